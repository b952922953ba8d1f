//! Looking on while a solve runs: closures, called on a thread of the solver while the caller waits.

use std::ops::ControlFlow;

/// What an observer is shown after each iteration.
#[derive(Clone, Copy)]
#[non_exhaustive]
pub struct Iteration<'a> {
    /// Iterations done, counted from 0 before the first.
    pub number: usize,
    /// FFT convolutions spent so far.
    pub transforms: f64,
    /// Estimated relative rms pressure error of the present iterate; infinite while there is no
    /// estimate.
    pub residual: f64,
    /// The residual at which the iteration ends.
    pub tolerance: f64,
    pub(crate) area: &'a dyn Fn() -> f64,
}

impl Iteration<'_> {
    /// Fraction of the pixels that carry pressure at present. Counted only when asked for.
    pub fn touching_fraction(&self) -> f64 {
        (self.area)()
    }
}

impl std::fmt::Debug for Iteration<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Iteration")
            .field("number", &self.number)
            .field("transforms", &self.transforms)
            .field("residual", &self.residual)
            .field("touching_fraction", &self.touching_fraction())
            .finish_non_exhaustive()
    }
}

/// What an observer may answer: nothing, or whether to go on.
pub trait ObserverResult {
    /// Whether to go on.
    fn flow(self) -> ControlFlow<()>;
}

impl ObserverResult for () {
    fn flow(self) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

impl ObserverResult for ControlFlow<()> {
    fn flow(self) -> ControlFlow<()> {
        self
    }
}

/// Any observer, once its answers are alike.
pub(crate) type Observe<'a> = dyn FnMut(&Iteration<'_>) -> ControlFlow<()> + Send + 'a;
