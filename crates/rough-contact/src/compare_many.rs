//! `rough-contact compare` of many maps: each by itself, and a page of how they are spread.

use crate::args::CommonOptions;
use crate::batch::{self, FileOutcome, How, PerFile, Shown, Store};
use crate::compare::{Compare, quoted};
use crate::input::One;
use crate::outcome::{Failure, Reply, unfit};
use rough_contact::compare::{Comparison, Settings, Surface, built_in};
use rough_contact::report::{Provenance, Summary};
use rough_contact::{compare, report};
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::io::Write as _;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::time::Instant;

const OUTPUTS: [&str; 3] = ["report.html", "results.json", "table.csv"];

const PROFILE: &str = "a profile has no deterministic answer that closed forms could be compared with; \
compare up to 10 profiles in a run of their own";

impl PerFile for Compare {
    const NAME: &'static str = "compare";
    const SHOWN: &'static [Shown] = &[
        Shown { head: "points", at: &["/shape"], how: How::Shape },
        Shown { head: "against", at: &["/against"], how: How::Word },
        Shown { head: "Sq", at: &["/rms_height"], how: How::Length },
        Shown { head: "rms gradient", at: &["/rms_gradient"], how: How::Number },
        Shown { head: "load", at: &["/load"], how: How::Force },
        Shown { head: "headline", at: &["/mean_pressure"], how: How::Pressure },
        Shown { head: "area", at: &["/area_fraction"], how: How::Percent },
        Shown { head: "real pressure", at: &["/real_pressure"], how: How::Pressure },
        Shown { head: "GW off by", at: &["/models/gw/area_error"], how: How::Percent },
        Shown { head: "Persson off by", at: &["/models/persson/area_error"], how: How::Percent },
        Shown { head: "solver", at: &["/seconds"], how: How::Seconds },
        Shown { head: "to check", at: &["/to_check"], how: How::Count },
    ];

    fn settings(&self) -> String {
        let mut asked = self.clone();
        asked.files.clear();
        (asked.out, asked.summary, asked.resume) = (PathBuf::new(), false, false);
        format!("{asked:?}")
    }

    fn beside(&self) -> String {
        self.against.content()
    }

    fn answer(&self, path: &Path, common: &CommonOptions) -> Result<Reply, Failure> {
        let One::Map(map) = self.read(path)? else {
            return Err(unfit(path, "profile", PROFILE));
        };
        let settings = Settings { threads: common.threads(), ..self.settings()? };
        let surface = vec![Surface { name: path.display().to_string(), ..*map }];
        let settings = self.loaded(settings, [surface[0].heights.grid().area()])?;
        let go_on = &mut |_: compare::Progress<'_>| ControlFlow::Continue(());
        let study = Comparison::run(surface, settings, built_in(), go_on)
            .map_err(|e| Failure::in_file(path, &e))?;
        let mut all = report::comparison_json(&study, &Provenance::here(""));
        let json = all.pointer_mut("/surfaces/0").map_or(Value::Null, Value::take);
        let mut reply = Reply::new(String::new(), json);
        reply.trouble = crate::compare::not_met(&study);
        Ok(reply)
    }

    fn digest(answer: Value) -> Value {
        report::digest(&answer)
    }
}

/// Runs the studies and writes the page; the report with a section each where they are few.
pub(crate) fn run(command: &Compare, common: &CommonOptions) -> Result<Reply, Failure> {
    if !command.is_summary() {
        return command.run(common);
    }
    let start = Instant::now();
    let settings = Settings { threads: common.threads(), ..command.settings()? };
    let store = Store::at(command, &command.out, &OUTPUTS, [command.resume, common.force])?;
    let outcomes = batch::outcomes(command, &command.files, Some(&store), common)?;
    let mut reply = Reply::new(
        batch::table(&outcomes, Compare::SHOWN),
        json!({ "files": batch::objects(&outcomes), "settings": settings }),
    );
    reply.trouble = batch::trouble(&outcomes);
    let words: Vec<String> = std::env::args().skip(1).map(|word| quoted(&word)).collect();
    let provenance = Provenance::here(format!("rough-contact {}", words.join(" ")));
    let summary = summary(&outcomes, &settings, start.elapsed().as_secs_f64());
    // What was computed is printed even if it cannot be written.
    if let Err(failure) = write(&store, &outcomes, &summary, &provenance) {
        reply.trouble = Some(failure);
    }
    let page = store.folder.path.join("report.html");
    let _ = writeln!(reply.text, "report: {}", page.display());
    Ok(reply)
}

fn summary<'a>(outcomes: &'a [FileOutcome], settings: &'a Settings, seconds: f64) -> Summary<'a> {
    let folder = batch::common_folder(outcomes);
    let map = |o: &'a FileOutcome| Some((o.name_in(&folder), &o.result.as_ref().ok()?.0));
    let failed = |o: &FileOutcome| {
        o.result.is_err().then(|| (o.name_in(&folder), o.why().unwrap_or_default()))
    };
    Summary {
        maps: outcomes.iter().filter_map(map).collect(),
        failed: outcomes.iter().filter_map(failed).collect(),
        settings,
        seconds,
    }
}

fn write(
    store: &Store,
    outcomes: &[FileOutcome],
    summary: &Summary<'_>,
    provenance: &Provenance,
) -> Result<(), Failure> {
    let folder = &store.folder;
    let page = report::summary_html(summary, provenance);
    folder.write("report.html", |out| out.write_all(page.as_bytes()))?;
    folder.write("table.csv", |out| batch::csv(outcomes, out))?;
    // The answers go through one by one: together they may be more than the memory holds.
    folder.write("results.json", |out| {
        let mut before = "{\n\"surfaces\": [\n";
        for outcome in outcomes.iter().filter(|o| o.result.is_ok()) {
            write!(out, "{before}{}", store.whole(outcome)?)?;
            before = ",\n";
        }
        let refused: Vec<Value> = summary
            .failed
            .iter()
            .map(|(name, reason)| json!({ "name": name, "reason": reason }))
            .collect();
        let versions =
            json!({ "rough-contact": provenance.version, "platform": provenance.platform });
        let opening = if before.starts_with('{') { before } else { "" };
        writeln!(
            out,
            "{opening}\n],\n\"refused\": {},\n\"settings\": {},\n\"versions\": {versions}\n}}",
            json!(refused),
            json!(summary.settings),
        )
    })
}
