//! Loads that were solved for: the rows of the table, and what is said below it about uncertainties.

use crate::conduction;
use crate::loads::{rising, shown};
use crate::text;
use rough_contact::compare::Joint;
use rough_contact::contact_accuracy::NoUncertainty;
use rough_contact::fft_bem_solver::{Load, Yielded};
use rough_contact::front_end::Point;
use std::fmt::Write as _;

/// The cells of its row; a number that is asked for and not there is a dash, so that the others stand under their
/// headings.
pub(crate) fn cells(point: &Point, asked: &Joint, has_stiffness: bool) -> Vec<String> {
    let mut cells = conduction::first_cells(point.conducted.as_ref(), asked, true);
    let (Some(solution), Some(budget)) = (&point.solution, &point.budget) else {
        cells.extend([shown(point.load), "refused".to_owned()]);
        return cells;
    };
    let (state, d) = (&solution.state, &solution.diagnostics);
    let mean = budget.real_pressure().map(|r| r.value);
    let area = &budget.area;
    cells.push(text::pressure(state.mean_pressure));
    if budget.gap_is_given {
        let load = budget.mean_pressure;
        cells.push(text::relative(load.value, load.interval().ok(), text::pressure));
    }
    cells.extend([
        text::percent(solution.touching_fraction()),
        text::percent(state.area_fraction),
        text::relative(area.value, area.interval().ok(), text::percent),
        text::relative(area.value, area.prediction(), text::percent),
        text::or_dash(state.mean_gap, text::length),
        text::or_dash(mean, text::pressure),
        text::highest(d.max_pressure, mean),
        text::number(d.transforms),
        format!("{:.1e}", d.residuals.preconditioned),
        text::seconds(d.seconds),
    ]);
    if has_stiffness {
        cells.push(text::or_dash(budget.stiffness, |k| format!("{:.2e} Pa/m", k.value)));
    }
    if let Some(Yielded { area_fraction, load_share, .. }) = d.yielded {
        cells.extend([area_fraction, load_share].map(text::percent));
    }
    if let Some(found) = &point.conducted {
        cells.extend(conduction::cells(found));
    }
    cells
}

/// One line for each load on twice the points, and one for each reason without an uncertainty.
pub(crate) fn notes(points: &[Point]) -> String {
    let loads: Vec<Load> = points.iter().map(|point| point.load).collect();
    let mut notes = String::new();
    let mut missing: Vec<(String, Vec<String>)> = Vec::new();
    for index in rising(&loads) {
        let point = &points[index];
        let (true, Some(solution), Some(budget)) =
            (point.converged, &point.solution, &point.budget)
        else {
            continue;
        };
        let shown = shown(point.load);
        if let Some(finer) = &point.finer {
            let area = text::percent(finer.area);
            let _ = writeln!(notes, "{shown}: twice the points read {area}; the ± covers both");
        }
        let Err(why) = budget.area.half_width() else { continue };
        let why = match (why, solution.state.mean_gap) {
            // The flat hangs above: by as much as it has approached less than nothing.
            (NoUncertainty::NoContact, Some(gap)) => {
                let first = text::length(gap + solution.approach);
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
