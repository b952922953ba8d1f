//! The contract between the solver and a method.
//!
//! A method receives a [`ContactTask`]: the scaled [`Problem`] (heights from -1 to 0, finer pixel side 1,
//! `K` with symbol `2/|q|`), what is prescribed, when to stop. It changes a [`State`], the pair
//! `pressure`, `displacement = K pressure` and the `level` of the rigid flat, and returns an
//! [`Outcome`]. The gap is `displacement - heights - level` and is never stored by the solver.
//!
//! - With [`Start::Cold`] the contents of the state mean nothing. With [`Start::Warm`] they are
//!   the solution for another load on the same surface and may be scaled: K is linear.
//! - On return, whatever the [`End`], `pressure >= 0`, its mean is the prescribed one (for
//!   [`Target::Pressure`]), `displacement` belongs to it, and `level` is the pressure-weighted mean
//!   of `displacement - heights`.
//! - Under a ceiling, which only the chord iteration knows, `pressure <= ceiling` as well, and `level` is that of
//!   [`level_under`](super::level::level_under).
//! - `watch` is called once per iteration and may end the run.
//! - `transforms` counts applications of `K` (or `K^-1`) at full size as 1; work on coarser grids
//!   in proportion `m log m / (n log n)`.
//! - Under a ceiling, and where it does not control the level itself (`controls_level`), a method is driven by
//!   [`control`](crate::control) to a prescribed gap.

use super::compliance::Compliance;
use crate::problem::Problem;
use crate::{Boundary, End, Real, fields};
use std::ops::ControlFlow;

/// What is prescribed, in scaled units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Target {
    /// Mean pressure.
    Pressure(f64),
    /// Mean of the gap where it is open. Beside it a first guess of the mean pressure.
    Gap(f64, f64),
}

/// One problem to solve.
#[derive(Clone, Copy)]
pub(crate) struct ContactTask<'a, T> {
    pub(crate) problem: &'a Problem<T>,
    pub(crate) target: Target,
    pub(crate) start: Start,
    /// Highest pressure, in scaled units; infinite for elastic bodies.
    pub(crate) ceiling: f64,
    /// Relative rms pressure error to reach.
    pub(crate) tolerance: f64,
    pub(crate) max_iterations: usize,
    /// Whether the last iterate takes the pressure of the trial that would come next, without its displacement.
    pub(crate) ends_on_trial: bool,
}

/// Where the iteration begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Start {
    Cold,
    Warm,
}

/// The iterate.
pub(crate) struct State<T> {
    pub(crate) pressure: Vec<T>,
    pub(crate) displacement: Vec<T>,
    pub(crate) level: f64,
}

impl<T: Real> State<T> {
    pub(crate) fn new(n: usize) -> Self {
        Self { pressure: vec![T::zero(); n], displacement: vec![T::zero(); n], level: 0.0 }
    }

    /// Makes the pressure constant; its displacement is zero on a periodic half space. Returns the convolutions spent.
    pub(crate) fn fill(&mut self, pressure: f64, operator: &mut dyn Compliance<T>) -> f64 {
        fields::fill(pressure, &mut self.pressure);
        if operator.boundary() == Boundary::Periodic {
            fields::fill(0.0, &mut self.displacement);
            return 0.0;
        }
        operator.apply(&self.pressure, &mut self.displacement);
        1.0
    }

    /// Multiplies pressure and displacement: K is linear.
    pub(crate) fn scale(&mut self, factor: f64) {
        fields::scale(factor, &mut self.pressure);
        fields::scale(factor, &mut self.displacement);
    }
}

/// What `watch` is shown.
pub(crate) struct IterateView<'a, T> {
    pub(crate) iteration: usize,
    pub(crate) transforms: f64,
    /// Estimated relative rms pressure error; infinite while there is none.
    pub(crate) residual: f64,
    /// May be of a larger grid, with nothing loaded beside the map; then no level may be prescribed, since `control`
    /// compares it with the heights of the map.
    pub(crate) state: &'a State<T>,
}

/// Called once per iteration; `Break` ends the run.
pub(crate) type IterateObserver<'a, T> =
    dyn FnMut(&IterateView<'_, T>) -> ControlFlow<()> + Send + 'a;

/// What a method works with.
pub(crate) struct Means<'a, 'w, T: Real> {
    pub(crate) operator: &'a mut dyn Compliance<T>,
    pub(crate) state: &'a mut State<T>,
    pub(crate) watch: &'a mut IterateObserver<'w, T>,
}

/// What a method reports.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Outcome {
    /// Why no iteration was needed.
    pub(crate) exact: Option<&'static str>,
    pub(crate) end: End,
    pub(crate) iterations: usize,
    pub(crate) transforms: f64,
    /// Estimated relative rms pressure error of the state returned.
    pub(crate) residual: f64,
}

impl Outcome {
    /// Before the first iteration.
    pub(crate) const NOTHING: Self = Self {
        exact: None,
        end: End::Exhausted,
        iterations: 0,
        transforms: 0.0,
        residual: f64::INFINITY,
    };

    /// Of an exact answer.
    pub(crate) fn exact(reason: &'static str, transforms: f64) -> Self {
        let (exact, end) = (Some(reason), End::Converged);
        Self { exact, end, transforms, residual: 0.0, ..Self::NOTHING }
    }

    /// Counts the work of another run as well.
    pub(crate) fn add(&mut self, other: &Self) {
        self.iterations += other.iterations;
        self.transforms += other.transforms;
    }
}

/// One way of solving the contact problem.
pub(crate) trait ContactMethod<T: Real>: Send + Sync {
    /// Solves the task, see the module documentation.
    fn solve(&mut self, task: &ContactTask<'_, T>, means: Means<'_, '_, T>) -> Outcome;

    /// Whether [`Target::Gap`] is understood, without a ceiling.
    fn controls_level(&self) -> bool {
        false
    }

    /// The mean pressure from which it is worth one convolution to see if every gap closes, and what finding
    /// that out cost in convolutions. A method that spends many convolutions anyway says: from any.
    fn suspected_closing_load(&mut self, problem: &Problem<T>) -> (f64, f64) {
        let _ = problem;
        (0.0, 0.0)
    }
}
