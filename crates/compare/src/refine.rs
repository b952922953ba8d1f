//! Bars outside the gate, from solutions on a twice finer grid.

use crate::Settings;
use crate::budget::{Map, grid::Finer};
use crate::regrid::regrid;
use crate::result::DeterministicPoint;
use crate::study::builder;
use contact_types::{ContactModulus, HeightMap};
use fft_bem_solver::{Load, NoAreaInterval};
use std::time::Instant;

/// Most points times loads that are solved on twice finer grids: 16 loads of 2048 x 2048.
const MOST_REFINED: usize = 1 << 26;

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
        let grid = point.answer.as_ref().map(|a| a.budget.area.grid);
        matches!(
            grid,
            Some(Err(NoAreaInterval::Unresolved { .. }
                | NoAreaInterval::Stepped { .. }
                | NoAreaInterval::SpotsTooSmall { .. }))
        )
    };
    let mut wanted: Vec<usize> = (0..points.len()).filter(|&i| resolvable(&points[i])).collect();
    let [ny, nx] = map.grid().shape();
    let fits = |loads: usize| loads * 4 * map.grid().len() <= MOST_REFINED;
    if !fits(wanted.len()) {
        wanted.retain(|&i| i == headline);
    }
    if wanted.is_empty() || !fits(1) || ny.min(nx) < 4 {
        return 0.0;
    }
    let finer = regrid(map, [2 * ny, 2 * nx], known.repeats).ok();
    let solver = finer.as_ref().and_then(|f| builder(settings).build(f.grid(), modulus).ok());
    let (Some(finer), Some(mut solver)) = (finer, solver) else { return 0.0 };
    for i in wanted {
        let point = &mut points[i];
        let solution = solver.solve(&finer, Load::MeanPressure(point.mean_pressure));
        if let (Ok(solution), Some(answer)) = (solution, &mut point.answer) {
            let finer = Finer::of(&solution, known);
            answer.budget = answer.budget.refined(&finer);
            answer.finer = Some(finer);
        }
    }
    start.elapsed().as_secs_f64()
}
