//! Contact stiffness: of the contact set, by its mixed problem. Of elastic contact that is -dp/d(mean gap); of bodies with a
//! hardness it is not, for what has yielded takes no more load.

use super::area::iteration_half_width;
use super::estimate::{Budget, Estimate};
use super::grid;
use super::map::Map;
use super::no_interval::NoAreaInterval;
use contact_types::HeightMap;
use fft_bem_solver::{Load, SetStiffness, Solution, Solver, SolverError};
use std::time::Instant;

/// What is known of the stiffness at a load.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Stiffness {
    /// Of the set (Pa/m).
    pub value: f64,
    /// Relative half width left by stopping the iterations; the reason if it is not known.
    pub iteration: Result<f64, NoAreaInterval>,
    /// FFT pairs spent.
    pub transforms: f64,
    /// Wall-clock time spent (s).
    pub seconds: f64,
}

impl Stiffness {
    /// Solves at `mean_pressure` (Pa), from the solution that `solver` holds, and asks the contact set.
    ///
    /// # Errors
    /// [`SolverError`].
    pub fn near(
        solver: &mut Solver,
        surface: &HeightMap,
        mean_pressure: f64,
    ) -> Result<Option<Self>, SolverError> {
        let solution = solver.solve(surface, Load::MeanPressure(mean_pressure))?;
        Self::of_set(solver, &solution)
    }

    /// Of the contact set of `solution`, which `solver` holds: its mixed problem. `None` without contact and
    /// in full contact.
    ///
    /// # Errors
    /// [`SolverError`].
    pub fn of_set(solver: &mut Solver, solution: &Solution) -> Result<Option<Self>, SolverError> {
        let start = Instant::now();
        let set = solver.contact_stiffness()?;
        Ok(Self::of(&set, solution, start.elapsed().as_secs_f64()))
    }

    /// Of a set that was asked, of this solution, in so many seconds.
    pub fn of(set: &SetStiffness, solution: &Solution, seconds: f64) -> Option<Self> {
        let found = &solution.diagnostics;
        let area = found.area_fraction_corrected;
        if !(set.per_area > 0.0 && set.per_area.is_finite() && area > 0.0) {
            return None;
        }
        // The set is that of an iterate: the stiffness moves no more than its area does.
        let iteration = iteration_half_width(found).map(|half| half / area + set.residual);
        Some(Self { value: set.per_area, iteration, transforms: set.transforms, seconds })
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
        let [_, few] = self.few_spots();
        let relative = (few * wide * grid::stiffness_half_width(map, line)).hypot(open);
        self.stiffness = Some(Estimate {
            value: k,
            grid: self.own.map(|()| k * relative),
            iteration: found.iteration.map(|r| k * r),
            sample: self.sampled.map(|s| k * s.stiffness_half_width()),
            least: 0.0,
            most: f64::INFINITY,
        });
        self
    }
}
