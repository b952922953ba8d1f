//! Bars for the loads of a study that have none for want of resolution.

use crate::Settings;
use crate::result::DeterministicPoint;
use crate::solver_of::builder;
use contact_accuracy::budget::Map;
use contact_accuracy::{TwiceFiner, fits};
use contact_types::{ContactModulus, HeightMap};
use fft_bem_solver::{Boundary, Load};
use std::time::Instant;

/// Solves every load that has no bar for want of resolution on a twice finer grid, and gives its
/// numbers the bar that follows; only that of the headline if all of them are too many points, and
/// none if that one alone is. Answers with the seconds it took.
pub(crate) fn refine(
    map: &HeightMap,
    known: &Map,
    modulus: ContactModulus,
    settings: &Settings,
    points: &mut [DeterministicPoint],
    headline: usize,
) -> f64 {
    let start = Instant::now();
    let resolvable = |point: &DeterministicPoint| {
        point.answer.as_ref().is_some_and(|answer| TwiceFiner::is_wanted(&answer.budget, known))
    };
    let mut wanted: Vec<usize> = (0..points.len()).filter(|&i| resolvable(&points[i])).collect();
    if !fits(map.grid(), wanted.len()) {
        wanted.retain(|&i| i == headline);
    }
    if wanted.is_empty() {
        return 0.0;
    }
    let finer = TwiceFiner::of(map, known, Boundary::Periodic, builder(settings), modulus);
    let Ok(mut finer) = finer else { return 0.0 };
    for i in wanted {
        let point = &mut points[i];
        let Some(answer) = &mut point.answer else { continue };
        let found = finer.solve(Load::MeanPressure(point.mean_pressure), &answer.budget);
        if let Ok(found) = found {
            answer.budget = answer.budget.refined(&found);
            answer.finer = Some(found);
        }
    }
    start.elapsed().as_secs_f64()
}
