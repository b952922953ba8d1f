//! The solver that the settings of a study ask for.

use crate::Settings;
use fft_bem_solver::{Solver, SolverBuilder};

pub(crate) fn builder(settings: &Settings) -> SolverBuilder {
    Solver::builder()
        .method(settings.method)
        .precision(settings.precision)
        .tolerance(settings.tolerance)
        .threads(settings.threads.max(1))
}
