//! What is said below the table of `solve` about uncertainties: what twice the points read, and why there is none.

use crate::loads::{rising, shown};
use crate::text;
use rough_contact::contact_accuracy::NoUncertainty;
use rough_contact::fft_bem_solver::Load;
use rough_contact::front_end::Point;
use std::fmt::Write as _;

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
            // Writing to a String cannot fail.
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
