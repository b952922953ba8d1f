//! Looking on while a solve runs.

use std::ops::ControlFlow;

/// What an observer is shown after each iteration.
#[derive(Clone, Copy)]
pub struct Iteration<'a> {
    /// Iterations done, counted from 0 before the first.
    pub number: usize,
    /// FFT pairs spent so far.
    pub transforms: f64,
    /// Estimated relative rms pressure error of the present iterate; infinite while there is no
    /// estimate.
    pub residual: f64,
    /// The residual at which the iteration ends.
    pub tolerance: f64,
    pub(crate) area: &'a dyn Fn() -> f64,
    pub(crate) fields: &'a dyn Fn() -> [Vec<f64>; 2],
}

impl Iteration<'_> {
    /// Fraction of the pixels that carry pressure at present. Counted only when asked for.
    pub fn area_fraction(&self) -> f64 {
        (self.area)()
    }

    /// Pressure (Pa) and gap (m) of the present iterate, row-major. Made only when asked for.
    pub fn pressure_and_gap(&self) -> [Vec<f64>; 2] {
        (self.fields)()
    }
}

impl std::fmt::Debug for Iteration<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Iteration")
            .field("number", &self.number)
            .field("transforms", &self.transforms)
            .field("residual", &self.residual)
            .field("area_fraction", &self.area_fraction())
            .finish_non_exhaustive()
    }
}

/// Something that follows the iterations and may stop them. Closures implement it.
pub trait Observer: Send {
    /// Called after each iteration; `Break` ends the run with
    /// [`SolverError::Stopped`](crate::SolverError::Stopped).
    fn on_iteration(&mut self, iteration: &Iteration<'_>) -> ControlFlow<()>;
}

impl<F: FnMut(&Iteration<'_>) -> ControlFlow<()> + Send> Observer for F {
    fn on_iteration(&mut self, iteration: &Iteration<'_>) -> ControlFlow<()> {
        self(iteration)
    }
}
