//! Contact stiffness, -dp/d(mean gap), from two more solutions.

use super::area::iteration_half_width;
use super::estimate::{Budget, Estimate};
use super::map::Map;
use super::no_interval::NoAreaInterval;
use super::{grid, iteration};
use contact_types::HeightMap;
use fft_bem_solver::{Load, Solver, SolverError};

/// Factor between the load and the two loads beside it.
const STEP: f64 = 1.01;

/// Relative error of a difference over a factor of 1.01² in load: a third of ln(1.01)² times the
/// curvature of ln p against the gap, of order one.
const DIFFERENCE: f64 = 1e-4;

/// What two solutions at a little less and a little more load say of the stiffness.
#[derive(Debug, Clone, Copy, PartialEq)]
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
    /// `k = p ln(p2/p1) / (gap1 - gap2)`. `None` if the gap has no mean or does not close.
    ///
    /// # Errors
    /// [`SolverError`].
    pub fn near(
        solver: &mut Solver,
        surface: &HeightMap,
        map: &Map,
        mean_pressure: f64,
    ) -> Result<Option<Self>, SolverError> {
        let less = solver.solve(surface, Load::MeanPressure(mean_pressure / STEP))?;
        let more = solver.solve(surface, Load::MeanPressure(mean_pressure * STEP))?;
        let (Some(wide), Some(narrow)) = (less.state.mean_gap, more.state.mean_gap) else {
            return Ok(None);
        };
        let closed = wide - narrow;
        if closed <= 0.0 {
            return Ok(None);
        }
        let (a, b) = (&less.diagnostics, &more.diagnostics);
        let iteration = iteration_half_width(a).and(iteration_half_width(b)).map(|_| {
            let [a, b] = [a, b].map(|d| iteration::gap_half_width(map, d));
            (a + b) / closed
        });
        Ok(Some(Self {
            value: 2.0 * STEP.ln() * mean_pressure / closed,
            iteration,
            transforms: a.transforms + b.transforms,
            seconds: a.seconds + b.seconds,
        }))
    }
}

impl Budget {
    /// The same with a stiffness found at its load. `line_share` is [`grid::line_share`] of the
    /// solution.
    #[must_use]
    pub fn with_stiffness(mut self, found: &Stiffness, map: &Map, line_share: f64) -> Self {
        let k = found.value;
        let relative = grid::stiffness_half_width(map, line_share) + DIFFERENCE;
        let area_scatter = self.area_scatter.unwrap_or(0.0);
        self.stiffness = Some(Estimate {
            value: k,
            grid: self.area.grid.map(|_| k * relative),
            iteration: found.iteration.map(|r| k * r),
            sample: self
                .area_scatter
                .map(|_| k * super::sample::stiffness_half_width(area_scatter, map.height_scatter)),
            most: f64::INFINITY,
        });
        self
    }
}
