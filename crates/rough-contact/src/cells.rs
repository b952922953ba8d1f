//! Loads that were solved for: the rows of the table, and what is said below it about uncertainties.

use crate::conduction;
use crate::loads::{rising, shown};
use crate::text::{self, Columns};
use rough_contact::compare::{DeterministicAnswer, Joint};
use rough_contact::contact_accuracy::{Estimate, NoUncertainty};
use rough_contact::fft_bem_solver::Load;
use rough_contact::front_end::Point;
use std::fmt::Write as _;

/// A row for each load; a number that is asked for and not there is a dash, so that the others stand under their headings.
/// Columns may be there of forces, of gaps that are prescribed, of stiffness and of what yields.
pub(crate) fn table(
    points: &[Point],
    asked: &Joint,
    [forces, gaps, stiffness, yields]: [bool; 4],
) -> Columns {
    let mut columns = Columns::default();
    if forces {
        columns.column("load", points.iter().map(|p| text::or_dash(p.force, text::force)));
    }
    for (k, heading) in conduction::first_headings(asked, true).into_iter().enumerate() {
        let cell = |p: &Point| conduction::first_cell(p.conducted.as_ref(), asked, k);
        columns.column(heading, points.iter().map(cell));
    }
    let load = |p: &Point| match &p.answer {
        Some(answer) => text::pressure(answer.budget.mean_pressure.value),
        None => shown(p.load),
    };
    columns.column("mean pressure", points.iter().map(load));
    let mut otherwise = "refused";
    let mut add = |heading: &str, cell: &dyn Fn(&DeterministicAnswer) -> String| {
        let of = |p: &Point| p.answer.as_ref().map_or_else(|| otherwise.to_owned(), cell);
        columns.column(heading, points.iter().map(of));
        otherwise = "";
    };
    if gaps {
        // The load is an answer too.
        let load = |a: &DeterministicAnswer| a.budget.mean_pressure;
        add("±", &|a| text::relative(load(a).value, load(a).interval().ok(), text::pressure));
    }
    let area = |a: &DeterministicAnswer| a.budget.area;
    let mean = |a: &DeterministicAnswer| a.budget.real_pressure().map(|r| r.value);
    add("touching", &|a| text::percent(a.touching_fraction));
    add("area", &|a| text::percent(a.area_fraction));
    add("±", &|a| text::relative(area(a).value, area(a).interval().ok(), text::percent));
    add("± surface", &|a| text::relative(area(a).value, area(a).prediction(), text::percent));
    add("mean gap", &|a| text::or_dash(a.mean_gap, text::length));
    add("real pressure", &|a| text::or_dash(mean(a), text::pressure));
    add("highest", &|a| text::highest(a.diagnostics.max_pressure, mean(a)));
    add("convolutions", &|a| text::number(a.diagnostics.transforms));
    add("residual", &|a| format!("{:.1e}", a.diagnostics.residuals.preconditioned));
    add("time", &|a| text::seconds(a.diagnostics.seconds));
    if stiffness {
        let shown = |k: Estimate| format!("{:.2e} Pa/m", k.value);
        add("stiffness", &|a| text::or_dash(a.budget.stiffness, shown));
    }
    if yields {
        let yielded = |a: &DeterministicAnswer| a.diagnostics.yielded;
        add("area at H", &|a| text::or_dash(yielded(a), |y| text::percent(y.area_fraction)));
        add("load at H", &|a| text::or_dash(yielded(a), |y| text::percent(y.load_share)));
    }
    for (heading, of, unit) in conduction::columns(asked) {
        let cell = |p: &Point| Some(conduction::cell(of(p.conducted.as_ref()?), unit));
        columns.column(heading, points.iter().map(|p| cell(p).unwrap_or_default()));
    }
    columns
}

/// One line for each load on twice the points, and one for each reason without an uncertainty.
pub(crate) fn notes(points: &[Point]) -> String {
    let loads: Vec<Load> = points.iter().map(|point| point.load).collect();
    let mut notes = String::new();
    let mut missing: Vec<(String, Vec<String>)> = Vec::new();
    for index in rising(&loads) {
        let point = &points[index];
        let Some(answer) = point.answer.as_ref().filter(|a| a.converged) else { continue };
        let shown = shown(point.load);
        if let Some(finer) = &answer.finer {
            let area = text::percent(finer.area);
            let _ = writeln!(notes, "{shown}: twice the points read {area}; the ± covers both");
        }
        let Err(why) = answer.budget.area.half_width() else { continue };
        let why = match (why, answer.mean_gap) {
            // The flat hangs above: by as much as it has approached less than nothing.
            (NoUncertainty::NoContact, Some(gap)) => {
                let first = text::length(gap + answer.approach);
                format!("{why}; first contact at a mean gap of {first}")
            }
            _ => why.to_string(),
        };
        match missing.iter_mut().find(|(known, _)| *known == why) {
            Some((_, loads)) => loads.push(shown),
            None => missing.push((why, vec![shown])),
        }
    }
    for (why, loads) in &missing {
        let _ = writeln!(notes, "no ± at {}: {why}", loads.join(", "));
    }
    notes
}
