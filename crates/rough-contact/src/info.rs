//! `rough-contact info`: what a surface file holds.

use crate::args::CommonOptions;
use crate::batch::{self, How, PerFile, Shown};
use crate::files::Files;
use crate::input::{self, ReadingOptions};
use crate::outcome::{Failure, Reply};
use crate::text::{self, TwoColumns};
use clap::Args;
use rough_contact::front_end;
use rough_contact::surface_io::{FORMATS, Measurement, Need};
use serde_json::{Value, json};
use std::path::Path;

#[derive(Args, Clone, Debug)]
pub(crate) struct Info {
    #[command(flatten)]
    files: Files,
    /// The formats that can be read
    #[arg(long, conflicts_with_all = ["paths", "out", "resume"])]
    list: bool,
    #[command(flatten)]
    reading: ReadingOptions,
}

impl Info {
    pub(crate) fn run(&self, common: &CommonOptions) -> Result<Reply, Failure> {
        if self.list { Ok(formats()) } else { batch::run(self, &self.files, common) }
    }
}

impl PerFile for Info {
    const NAME: &'static str = "info";
    const SHOWN: &'static [Shown] = &[
        Shown { head: "format", at: &["/format"], how: How::Word },
        Shown { head: "points", at: &["/shape"], how: How::Shape },
        Shown { head: "pixel", at: &["/pixel/1"], how: How::Length },
        Shown { head: "missing", at: &["/missing"], how: How::Count },
        Shown { head: "lowest", at: &["/height_min"], how: How::Length },
        Shown { head: "highest", at: &["/height_max"], how: How::Length },
        Shown { head: "channel", at: &["/channel"], how: How::Word },
    ];

    fn answer(&self, file: &Path, _: &CommonOptions) -> Result<Reply, Failure> {
        match self.reading.measurement(file) {
            Ok(measurement) => {
                let mut json = front_end::info(&measurement);
                json["ambiguity"] = json!(measurement.ambiguity.map(input::reading));
                Ok(Reply::new(describe(&measurement), json))
            }
            Err(failure) => {
                // The refusal says what to give; the numbers help to find it.
                let Some((measurement, missing)) = self.reading.raw(file) else {
                    return Err(failure);
                };
                let (text, json) = raw(&measurement, &missing);
                Ok(Reply { text, json, trouble: Some(failure) })
            }
        }
    }
}

/// A file without units: points, and its numbers as they stand there.
fn raw(m: &Measurement, missing: &[Need]) -> (String, Value) {
    let heights = if missing.contains(&Need::HeightUnit) { m.height_summary() } else { None };
    let json = json!({
        "format": m.format,
        "shape": m.grid().shape(),
        "missing": m.missing(),
        "raw_height_min": heights.map(|s| s.0),
        "raw_height_max": heights.map(|s| s.1),
        "raw_height_mean": heights.map(|s| s.2),
    });
    let mut table = begun(m);
    if m.missing() > 0 {
        table.row("missing points", m.missing().to_string());
    }
    if let Some((low, high, mean)) = heights {
        let [low, high, mean] = [low, high, mean].map(text::digits);
        table.row("heights", format!("{low} to {high}, unit unknown"));
        table.row("mean height", format!("{mean}, unit unknown"));
    } else {
        heights_in(&mut table, m);
    }
    (table.to_string(), json)
}

fn begun(m: &Measurement) -> TwoColumns {
    let [ny, nx] = m.grid().shape();
    let mut table = TwoColumns::default();
    table.row("format", m.format);
    table.row("points", format!("{ny} rows × {nx} columns"));
    table
}

fn heights_in(table: &mut TwoColumns, m: &Measurement) {
    if let Some((low, high, mean)) = m.height_summary() {
        table.row("heights", text::length_range(low, high));
        table.row("mean height", text::length(mean));
    }
}

fn describe(m: &Measurement) -> String {
    let [dy, dx] = m.grid().pixel();
    let [ly, lx] = m.grid().size();
    let mut table = begun(m);
    table.row("pixel", format!("{} × {} (dy × dx)", text::length(dy), text::length(dx)));
    table.row("size", format!("{} × {}", text::length(ly), text::length(lx)));
    let missing = match m.missing() {
        0 => "none".to_owned(),
        n => format!("{n} ({:.2} %)", 100.0 * n as f64 / m.grid().len() as f64),
    };
    table.row("missing points", missing);
    heights_in(&mut table, m);
    if m.is_profile() {
        table.row("note", "a single line of points: a profile, not a surface");
        let traces = m.channels.iter().filter(|c| c.is_trace).count();
        if traces > 1 {
            table.row("note", format!("{traces} traces of one surface, which are taken together"));
        }
    }
    if let Some(uneven) = m.uneven {
        table.row("note", format!("points not evenly spaced: up to {uneven:.2} steps off"));
    }
    if let Some(reading) = m.ambiguity {
        table.row("note", input::reading(reading));
    }
    for channel in &m.channels {
        let unit = channel.unit.as_deref().unwrap_or("no unit");
        let used = if channel.name == m.channel { ", read here" } else { "" };
        let kind = if channel.is_height { "height" } else { "not a height" };
        let about = match &channel.fault {
            Some(fault) => format!("{}: {fault}", channel.name),
            None => format!("{} ({unit}, {kind}{used})", channel.name),
        };
        table.row("channel", about);
    }
    for (key, value) in &m.metadata {
        table.row(key, value.trim());
    }
    table.to_string()
}

fn formats() -> Reply {
    let mut table = TwoColumns::default();
    let mut list = Vec::new();
    for spec in FORMATS {
        let name = spec.name;
        table.row(name, format!(".{}", spec.extensions.join(" .")));
        list.push(json!({ "name": name, "extensions": spec.extensions, "about": spec.about }));
    }
    Reply::new(table.to_string(), json!({ "formats": list }))
}
