//! Contact stiffness, -dp/d(mean gap): from two more solutions, of a contact that may yield from its set.

use super::area::iteration_half_width;
use super::estimate::{Budget, Estimate};
use super::map::Map;
use super::no_interval::NoAreaInterval;
use super::{grid, iteration};
use contact_types::HeightMap;
use fft_bem_solver::{Load, Solution, Solver, SolverError};
use std::time::Instant;

/// Factor between the load and the two loads beside it.
const STEP: f64 = 1.01;

/// Relative error of a difference over a factor of 1.01² in load: a third of ln(1.01)² times the
/// curvature of ln p against the gap, of order one.
const DIFFERENCE: f64 = 1e-4;

/// What is known of the stiffness at a load.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Stiffness {
    /// -dp/d(mean gap) (Pa/m).
    pub value: f64,
    /// Relative half width left by stopping the iterations; the reason if it is not known.
    pub iteration: Result<f64, NoAreaInterval>,
    /// FFT pairs spent.
    pub transforms: f64,
    /// Wall-clock time spent (s).
    pub seconds: f64,
}

impl Stiffness {
    /// Solves at 1/1.01 and at 1.01 of `mean_pressure` (Pa), starting from the solution that
    /// `solver` holds. Over so short a way ln p is a straight line of the gap:
    /// `k = p ln(p2/p1) / (gap1 - gap2)`. `None` if the gap has no mean, does not close by more than
    /// the iteration leaves of it, or is closed: in full contact the stiffness is infinite.
    ///
    /// Of bodies with a hardness the slope of the curve is not the stiffness, for what has yielded takes
    /// no more load: there the load itself is solved, and its contact set is asked.
    ///
    /// # Errors
    /// [`SolverError`].
    pub fn near(
        solver: &mut Solver,
        surface: &HeightMap,
        map: &Map,
        mean_pressure: f64,
    ) -> Result<Option<Self>, SolverError> {
        if solver.hardness().is_finite() {
            let solution = solver.solve(surface, Load::MeanPressure(mean_pressure))?;
            return Self::of_set(solver, &solution);
        }
        Self::around(&mut |load| solver.solve(surface, load), map, mean_pressure)
    }

    /// Of the contact set of `solution`, which `solver` holds: its mixed problem. `None` without contact and
    /// in full contact.
    ///
    /// # Errors
    /// [`SolverError`].
    pub fn of_set(solver: &mut Solver, solution: &Solution) -> Result<Option<Self>, SolverError> {
        let start = Instant::now();
        let set = solver.contact_stiffness()?;
        let found = &solution.diagnostics;
        let area = found.area_fraction_corrected;
        if !(set.per_area > 0.0 && set.per_area.is_finite() && area > 0.0) {
            return Ok(None);
        }
        // The set is that of an iterate: the stiffness moves no more than its area does.
        let iteration = iteration_half_width(found).map(|half| half / area + set.residual);
        let (transforms, seconds) = (set.transforms, start.elapsed().as_secs_f64());
        Ok(Some(Self { value: set.per_area, iteration, transforms, seconds }))
    }

    /// The same of a surface that `solve` knows.
    ///
    /// # Errors
    /// [`SolverError`].
    pub fn around(
        solve: &mut dyn FnMut(Load) -> Result<Solution, SolverError>,
        map: &Map,
        mean_pressure: f64,
    ) -> Result<Option<Self>, SolverError> {
        let less = solve(Load::MeanPressure(mean_pressure / STEP))?;
        let more = solve(Load::MeanPressure(mean_pressure * STEP))?;
        let (Some(wide), Some(narrow)) = (less.state.mean_gap, more.state.mean_gap) else {
            return Ok(None);
        };
        let closed = wide - narrow;
        let (a, b) = (&less.diagnostics, &more.diagnostics);
        let [left_a, left_b] = [a, b].map(|d| iteration::gap_half_width(map, d));
        let is_closed = b.contact_pixels > 0 && b.contact_perimeter <= 0.0;
        if is_closed || closed <= left_a + left_b {
            return Ok(None);
        }
        let iteration = iteration_half_width(a).and(iteration_half_width(b));
        let iteration = iteration.map(|_| (left_a + left_b) / closed);
        Ok(Some(Self {
            value: 2.0 * STEP.ln() * mean_pressure / closed,
            iteration,
            transforms: a.transforms + b.transforms,
            seconds: a.seconds + b.seconds,
        }))
    }
}

impl Budget {
    /// The same with a stiffness found at its load, whose contact has this `line`.
    #[must_use]
    pub fn with_stiffness(mut self, found: &Stiffness, map: &Map, line: grid::Line) -> Self {
        let k = found.value;
        let wide = if self.yields { grid::YIELDING[2] } else { 1.0 };
        // Near full contact it follows the places that are open.
        let open = self.between / (1.0 - self.area.value).max(f64::MIN_POSITIVE);
        let few = self.sampled.map_or(1.0, |s| grid::of_few_spots(s.blocks.carrying));
        let relative =
            (few * wide * grid::stiffness_half_width(map, line)).hypot(open) + DIFFERENCE;
        self.stiffness = Some(Estimate {
            value: k,
            grid: self.own.map(|()| k * relative),
            iteration: found.iteration.map(|r| k * r),
            sample: self.sampled.map(|s| k * s.stiffness_half_width()),
            most: f64::INFINITY,
        });
        self
    }
}
