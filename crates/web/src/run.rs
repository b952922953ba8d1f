//! The study and its documents, told while it works.

use crate::message::Messages;
use crate::numbers::pressure as shown_pressure;
use crate::request::Request;
use crate::surface;
use crate::trouble::Trouble;
use contact_compare::{Comparison, Iteration, PressureMaps, Progress, RunFile, built_in};
use contact_front_end::{Failure, shown};
use contact_report::Provenance;
use serde_json::{Value, json};
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

/// Iterations are told no more often than this.
const EVERY: Duration = Duration::from_millis(200);

/// What the report says of how to repeat it: the run file is among what the page saves.
const REPEAT: &str = "rough-contact compare --from run.toml --out again";

pub(crate) fn answer(
    request: &Request,
    file: &[u8],
    out: &mut Messages<'_>,
) -> Result<Value, Trouble> {
    let begun = Instant::now();
    let surface = surface::of(request, file)?;
    let settings = request.settings(surface.heights.grid().area())?;
    let run_file = RunFile::of(&settings, [(&surface.name, &surface.origin)]);
    out.tell("progress", json!({ "stage": "read", "seconds": begun.elapsed().as_secs_f64() }));
    let (mut told, mut loads) = (Instant::now(), 0);
    let mut found = {
        let mut listen = |news: Progress<'_>| {
            match news {
                Progress::Surface { loads: of, .. } => {
                    loads = of;
                    out.tell("progress", json!({ "stage": "loads", "count": of }));
                }
                Progress::Iterated { index, now } => iterated(index, &now, &mut told, out),
                Progress::Solved { index, mean_pressure, area_fraction, maps } => {
                    let mut news = solved(index, loads, mean_pressure, area_fraction);
                    news["map"] = json!(maps.and_then(|maps| shown_map(maps, index)));
                    out.tell("progress", news);
                }
                Progress::Models => out.tell("progress", json!({ "stage": "models" })),
                _ => {}
            }
            if out.is_cut() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        Comparison::run(vec![surface], settings, built_in(), &mut listen).map_err(Trouble::Study)?
    };
    out.tell("progress", json!({ "stage": "accuracy" }));
    contact_front_end::look_around(&mut found, &mut |news| {
        if let Progress::Iterated { now, .. } = news {
            iterated(loads, &now, &mut told, out);
        }
        if out.is_cut() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    })?;
    out.tell("progress", json!({ "stage": "report" }));
    let documents = contact_front_end::documents(&found, &Provenance::here(REPEAT), &run_file)?;
    let files: serde_json::Map<String, Value> =
        documents.into_iter().map(|(name, text)| (name.to_owned(), text.into())).collect();
    let trouble = contact_front_end::not_met(&found).as_ref().map(Failure::json);
    let headline = found.surfaces.first().and_then(contact_report::headline_line);
    Ok(json!({
        "files": files, "trouble": trouble, "headline": headline,
        "seconds": begun.elapsed().as_secs_f64(),
    }))
}

/// The contact at a load as a picture, with how the end of its colours is written.
fn shown_map(maps: &PressureMaps, load: usize) -> Option<Value> {
    let picture = contact_report::pressure_picture(maps, load)?;
    let map = &maps.loads[load];
    let more = if map.clipped { " and more" } else { "" };
    Some(json!({ "picture": picture, "top": format!("{}{more}", shown_pressure(map.top)) }))
}

fn iterated(index: usize, now: &Iteration<'_>, told: &mut Instant, out: &mut Messages<'_>) {
    if told.elapsed() < EVERY {
        return;
    }
    *told = Instant::now();
    // The residual falls exponentially: how far it has come is its logarithm.
    let share = (now.residual.ln() / now.tolerance.ln()).clamp(0.0, 1.0);
    let share = if now.residual.is_finite() { share } else { 0.0 };
    let news =
        json!({ "stage": "iteration", "index": index, "number": now.number, "share": share });
    out.tell("progress", news);
}

fn solved(index: usize, count: usize, pressure: f64, area: Option<f64>) -> Value {
    let touches = area.map(shown::percent);
    json!({
        "stage": "load", "index": index, "count": count, "pressure": pressure, "area": area,
        "at": shown_pressure(pressure), "touches": touches,
    })
}
