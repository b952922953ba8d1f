//! Contact stiffness, -dp/d(mean gap), from two more solutions.

use super::area::iteration_half_width;
use super::estimate::{Budget, Estimate};
use super::map::Map;
use super::no_interval::NoAreaInterval;
use super::{grid, iteration};
use contact_types::HeightMap;
use fft_bem_solver::{Load, Solution, Solver, SolverError};

/// Factor between the load and the two loads beside it.
const STEP: f64 = 1.01;

/// Relative error of a difference over a factor of 1.01² in load: a third of ln(1.01)² times the
/// curvature of ln p against the gap, of order one.
const DIFFERENCE: f64 = 1e-4;

/// What two solutions at a little less and a little more load say of the stiffness.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Stiffness {
    /// -dp/d(mean gap) (Pa/m).
    pub value: f64,
    /// Relative half width left by stopping the iterations; the reason if it is not known.
    pub iteration: Result<f64, NoAreaInterval>,
    /// FFT pairs of both solutions.
    pub transforms: f64,
    /// Wall-clock time of both (s).
    pub seconds: f64,
}

impl Stiffness {
    /// Solves at 1/1.01 and at 1.01 of `mean_pressure` (Pa), starting from the solution that
    /// `solver` holds. Over so short a way ln p is a straight line of the gap:
    /// `k = p ln(p2/p1) / (gap1 - gap2)`. `None` if the gap has no mean, does not close by more than
    /// the iteration leaves of it, or is closed: in full contact the stiffness is infinite.
    ///
    /// # Errors
    /// [`SolverError`].
    pub fn near(
        solver: &mut Solver,
        surface: &HeightMap,
        map: &Map,
        mean_pressure: f64,
    ) -> Result<Option<Self>, SolverError> {
        Self::around(&mut |load| solver.solve(surface, load), map, mean_pressure)
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
        let relative = grid::stiffness_half_width(map, line) + DIFFERENCE;
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
