//! The deterministic curve while it is solved.

use crate::distribution::{Distributions, contact_spots};
use crate::pressure_maps::{FirstContact, PressureMaps};
use crate::progress::{Listener, Progress};
use crate::result::{DeterministicAnswer, DeterministicPoint, Section, SurfaceComparison};
use crate::{EdgesName, MaterialUse};
use contact_accuracy::{Answered, Leaks, Map, Sink};
use contact_types::HeightMap;
use fft_bem_solver::{Iteration, Solution, SolverError};
use grid_fft::parallel::join;
use std::mem::take;
use std::ops::ControlFlow;

/// Area fraction the headline is looked for at.
const TYPICAL_AREA: f64 = 0.02;

/// A study whose deterministic curve grows. Of the fields only those of the headline are kept, of the other loads what
/// touches, and the pressure in a byte a dot.
pub(crate) struct Curve<'a, 'b> {
    pub(crate) found: SurfaceComparison,
    /// Nominal pressures (Pa).
    pub(crate) pressures: &'a [f64],
    /// Materials of the table that were used.
    pub(crate) materials: &'a [MaterialUse],
    /// Row of the given map that is kept of every solution, at its place on another grid.
    pub(crate) row: usize,
    /// Index of the load of the headline, if it was asked for.
    pub(crate) wanted: Option<usize>,
    /// How far the headline so far is from the one wanted.
    pub(crate) score: f64,
    pub(crate) progress: &'a mut Listener<'b>,
}

impl Curve<'_, '_> {
    /// How far a load is from the one wanted, or from the typical area as a ratio.
    fn distance(&self, index: usize, answer: Option<&DeterministicAnswer>) -> f64 {
        match (self.wanted, answer) {
            (Some(wanted), _) => wanted.abs_diff(index) as f64,
            (None, Some(a)) if a.touching_fraction > 0.0 => {
                let penalty = if a.converged { 0.0 } else { 50.0 };
                (a.touching_fraction / TYPICAL_AREA).ln().abs() + penalty
            }
            _ => 1e3,
        }
    }
}

impl Sink for Curve<'_, '_> {
    fn begin(&mut self, map: &HeightMap, known: &Map) {
        let found = &mut self.found;
        found.solved = (map.grid() != found.surface.grid()).then(|| map.clone());
        (found.map, found.beside_seconds) = (*known, [0.0; 2]);
        found.deterministic.clear();
        found.leaks.clear();
        found.distributions.clear();
        (found.first_contact, found.pressure_maps) = (None, None);
        found.sections.clear();
        (found.headline, found.solution) = (0, None);
        found.pressure.clear();
        self.score = f64::INFINITY;
    }

    fn iterated(&mut self, index: usize, now: &Iteration<'_>) -> ControlFlow<()> {
        (self.progress)(Progress::Iterated { index, now: *now })
    }

    fn take(&mut self, index: usize, mut result: Result<Answered, SolverError>) -> ControlFlow<()> {
        let mut leak = None;
        if let Ok(answered) = &mut result {
            leak = answered.leak.take();
            let beside = &mut self.found.beside_seconds;
            *beside = [0, 1].map(|k| beside[k] + answered.seconds[k]);
        }
        let mean_pressure = self.pressures[index];
        let (point, mut solution) = solved(mean_pressure, result, self.materials, &self.found.map);
        let score = self.distance(index, point.answer.as_ref());
        let found = &mut self.found;
        found.sections.push(solution.as_ref().map(|solution| {
            let [ny, nx] = solution.grid.shape();
            let row = self.row * ny / found.surface.grid().shape()[0];
            let along = |field: &[f64]| field[row * nx..][..nx].to_vec();
            Section { row, pressure: along(&solution.pressure), gap: along(&solution.gap) }
        }));
        let (first, maps) = (found.first_contact.take(), found.pressure_maps.take());
        let repeats = found.edges == EdgesName::Periodic;
        let fields = solution.as_ref().map(|s| (&s.pressure[..], &s.gap[..], s.grid));
        let (kept, distributions) = join(
            || {
                let pressure = fields.map_or(&[][..], |(pressure, ..)| pressure);
                let maps = fields.and_then(|(p, _, grid)| PressureMaps::with(maps, index, grid, p));
                (FirstContact::with(first, index, pressure), maps)
            },
            || {
                let (pressure, gap, grid) = fields?;
                let (list, _) = contact_spots(pressure, grid, repeats);
                Distributions::of(pressure, gap, &list)
            },
        );
        (found.first_contact, found.pressure_maps) = kept;
        found.distributions.push(distributions);
        found.deterministic.push(point);
        found.leaks.push(leak);
        if score < self.score {
            (self.score, found.headline) = (score, index);
            let fields = solution.as_mut().map(|s| (take(&mut s.pressure), take(&mut s.gap)));
            found.pressure = fields.unwrap_or_default().0;
            found.solution = solution;
        }
        let headline = found.headline;
        let others = found.leaks.iter_mut().enumerate().filter(|(i, _)| *i != headline);
        others.filter_map(|(_, leak)| leak.as_mut()).for_each(Leaks::drop_maps);
        let area_fraction = found.deterministic[index].answer.as_ref().map(|a| a.area_fraction);
        let maps = found.pressure_maps.as_ref();
        (self.progress)(Progress::Solved { index, mean_pressure, area_fraction, maps })
    }
}

/// The numbers of a load on a map of which `map` tells, of bodies of these materials of the table, and its fields.
pub(crate) fn solved(
    mean_pressure: f64,
    result: Result<Answered, SolverError>,
    materials: &[MaterialUse],
    map: &Map,
) -> (DeterministicPoint, Option<Solution>) {
    let trouble = result.as_ref().err().map(|error| {
        let (how, best) = match error {
            SolverError::NotConverged(best) => ("not converged", best),
            SolverError::Rounding(best) => ("stopped at rounding", best),
            error => return error.to_string(),
        };
        let reached = best.diagnostics.residuals.preconditioned;
        format!("{how}: relative rms pressure error about {reached:.1e}")
    });
    let (answer, solution) = DeterministicAnswer::of(result, materials, map).unzip();
    (DeterministicPoint { mean_pressure, answer, trouble }, solution)
}
