//! The headline load on coarser grids, for a report: what a cheaper deterministic answer would have cost in accuracy.

use crate::Settings;
use crate::progress::LoadListener;
use crate::result::{Coarser, SurfaceComparison};
use contact_accuracy::thinned;
use contact_types::HeightMap;
use fft_bem_solver::Load;
use grid_fft::parallel;

/// Point spacings tried, in spacings of the map. Together they have
/// 1/4 + 1/16 + 1/64 = 33 % of its points.
pub(crate) const COARSER: [usize; 3] = [2, 4, 8];

/// Points along the shorter side below which a grid is not tried.
const FEWEST_POINTS: usize = 16;

/// A short solution is repeated this often, so that its time is its own and not that of what else
/// the machine did just then.
const REPEATS: usize = 5;

/// Seconds after which a solution is not repeated.
const SHORT: f64 = 0.05;

/// The headline load on every coarser grid. One without a converged solution, or with fewer than 16 points a side, is left out;
/// a grid that was chosen for an accuracy says itself what a coarser one would leave.
pub(crate) fn solve_coarser(
    surface: &mut SurfaceComparison,
    settings: &Settings,
    watch: &mut LoadListener<'_, '_>,
) {
    if surface.plan.is_some() {
        return;
    }
    // All maps first: nothing else runs while a solution is timed.
    let maps = parallel::map(&COARSER, |factor| coarsened(&surface.surface, *factor));
    for (factor, map) in COARSER.into_iter().zip(maps) {
        let found = map.and_then(|map| solve(surface, settings, (factor, &map), watch));
        surface.coarser.extend(found);
    }
}

fn solve(
    surface: &SurfaceComparison,
    settings: &Settings,
    (factor, map): (usize, &HeightMap),
    watch: &mut LoadListener<'_, '_>,
) -> Option<Coarser> {
    let truth = surface.headline_answer().filter(|a| a.converged)?.area_fraction;
    let (mut solver, solution) = surface.solve_headline(map, settings, watch)?;
    let (whole, load) = (settings.edges.around(map).ok()?, surface.headline_pressure());
    let found = &solution.diagnostics;
    let (mut seconds, mut spent) = (found.seconds, found.seconds);
    for _ in 1..REPEATS {
        if spent + seconds > SHORT {
            break;
        }
        solver.forget();
        let again = solver.solve(&whole, Load::MeanPressure(load)).ok()?.diagnostics.seconds;
        (seconds, spent) = (seconds.min(again), spent + again);
    }
    (truth > 0.0).then(|| Coarser {
        factor,
        shape: map.grid().shape(),
        touching_fraction: solution.touching_fraction(),
        area_fraction: solution.state.area_fraction,
        error: solution.state.area_fraction / truth - 1.0,
        seconds,
    })
}

/// Every point of `factor` along each side; `None` if too few are left.
fn coarsened(map: &HeightMap, factor: usize) -> Option<HeightMap> {
    if map.grid().shape().into_iter().any(|n| n / factor < FEWEST_POINTS) {
        return None;
    }
    let mut map = thinned(map, [0, 0]).ok()?;
    for _ in 1..factor.ilog2() {
        map = thinned(&map, [0, 0]).ok()?;
    }
    Some(map)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Comparison, StudyError, built_in, built_in_recipes};
    use std::ops::ControlFlow;

    /// The error is against the map's own answer. A map whose shortest wave is 8 points long has 4 at half the points:
    /// what that moves is in the uncertainty.
    #[test]
    fn half_the_points_are_off_by_as_much_as_the_uncertainty_says() {
        let mut recipe = built_in_recipes().remove(0);
        (recipe.shape, recipe.quantise) = ([128, 128], None);
        let [dy, dx] = recipe.pixel;
        recipe.cutoff = 8.0 * dy.max(dx);
        let settings = Settings::default();
        let mut go = |_: crate::Progress<'_>| ControlFlow::Continue(());
        let mut study =
            Comparison::run(vec![recipe.make().unwrap()], settings, built_in(), &mut go).unwrap();
        assert!(study.surfaces[0].coarser.is_empty(), "not asked for, not computed");
        let mut stop = |_: crate::Progress<'_>| ControlFlow::Break(());
        let stopped = study.look_around(&mut stop);
        assert!(matches!(stopped, Err(("coarser_grids", StudyError::Stopped))));
        assert!(study.surfaces[0].coarser.is_empty() && study.surfaces[0].choices.is_none());
        study.look_around(&mut go).unwrap();
        let surface = &study.surfaces[0];
        let shapes: Vec<[usize; 2]> = surface.coarser.iter().map(|c| c.shape).collect();
        assert_eq!(shapes, [[64, 64], [32, 32], [16, 16]]);
        let area = surface.headline_answer().unwrap().budget.area;
        for c in &surface.coarser {
            assert!((c.error - (c.area_fraction / area.value - 1.0)).abs() < 1e-15);
            assert!(c.touching_fraction > c.area_fraction && c.seconds > 0.0);
        }
        let half = &surface.coarser[0];
        assert!((half.error * area.value).abs() < area.half_width().unwrap(), "{half:?}");
    }
}
