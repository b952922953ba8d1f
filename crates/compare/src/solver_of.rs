//! The solver that the settings of a study ask for. It uses the threads of the study.

use crate::Settings;
use fft_bem_solver::{Solver, SolverBuilder};

/// Of bodies that yield, if a hardness is given.
pub(crate) fn builder(settings: &Settings) -> SolverBuilder {
    elastic(settings).hardness(settings.hardness.unwrap_or(f64::INFINITY))
}

/// Of elastic bodies.
pub(crate) fn elastic(settings: &Settings) -> SolverBuilder {
    Solver::builder()
        .method(settings.method)
        .precision(settings.precision)
        .tolerance(settings.tolerance)
}
