//! Why there is no solution, or not the one asked for.

use crate::{Precision, Solution};
use contact_types::Grid;

/// Why a solve did not end with an answer to the tolerance asked for.
#[derive(Debug, Clone, thiserror::Error)]
#[non_exhaustive]
pub enum SolverError {
    /// The surface stands on another grid than the solver.
    #[error(
        "the solver was built for pixels of {:?} m ([ny, nx] = {:?}) but the \
         surface has pixels of {:?} m ({:?}); build a solver for this grid",
        .expected.pixel(), .expected.shape(), .found.pixel(), .found.shape()
    )]
    Grid {
        /// Of the solver.
        expected: Grid,
        /// Of the surface.
        found: Grid,
    },
    /// A setting cannot be used.
    #[error("{setting} = {value} cannot be used: {limit}")]
    BadSetting {
        /// Which setting.
        setting: &'static str,
        /// Its value.
        value: f64,
        /// What it must be.
        limit: &'static str,
    },
    /// Two settings do not go together.
    #[error("{first} cannot be combined with {second}: {way_out}")]
    Combination {
        /// One setting.
        first: &'static str,
        /// The other.
        second: &'static str,
        /// What to do instead.
        way_out: &'static str,
    },
    /// The load is no load this surface can carry.
    #[error("{quantity} = {value:e} {unit} cannot be applied: {limit}")]
    BadLoad {
        /// Which load.
        quantity: &'static str,
        /// Its value.
        value: f64,
        /// Its unit.
        unit: &'static str,
        /// What it must be.
        limit: &'static str,
    },
    /// The mean pressure is above the hardness: no contact can carry it.
    #[error(
        "mean pressure {mean_pressure:.5e} Pa is above the hardness {hardness:.5e} Pa: even full contact carries \
         no more than that; lower the load"
    )]
    AboveHardness {
        /// What was asked for (Pa).
        mean_pressure: f64,
        /// What the surface bears (Pa).
        hardness: f64,
    },
    /// [`Solver::solve_again`](crate::Solver::solve_again) before any surface was given.
    #[error("no surface is known: give one with take_surface or solve first")]
    NoSurface,
    /// The numbers of the problem leave the range of the floating-point type.
    #[error(
        "{quantity} = {value:e} leaves the range in which the solver can compute; \
         {way_out}"
    )]
    Range {
        /// Which number.
        quantity: &'static str,
        /// Its value.
        value: f64,
        /// What to do instead.
        way_out: &'static str,
    },
    /// The solver would not fit into memory.
    #[error(
        "a solver for {} x {} pixels takes about {}, {}; \
         choose a coarser map, single precision or fewer maps",
        .shape[0], .shape[1], binary(*.bytes), granted(*.free)
    )]
    Memory {
        /// `[ny, nx]`.
        shape: [usize; 2],
        /// What it would take, with the maps of one solution (bytes).
        bytes: u128,
        /// What is free (bytes), where the system says so.
        free: Option<u128>,
    },
    /// Rounding keeps the iteration from going on before the tolerance is reached. The iterate is
    /// inside, as good as this floating-point type can give it; its residual says how good that is.
    #[error(
        "stopped at rounding after {} iterations: estimated relative pressure error {:.2e}; \
         ask for no smaller tolerance than that{}",
        .0.diagnostics.iterations, residual(.0),
        if .0.diagnostics.precision == Precision::Single { ", or use f64" } else { "" }
    )]
    Rounding(Box<Solution>),
    /// The iteration limit was reached first. The last iterate is inside; to keep the best one would
    /// take memory for two more fields.
    #[error(
        "not converged after {} iterations: estimated relative pressure error {:.2e}; \
         allow a larger tolerance",
        .0.diagnostics.iterations, residual(.0)
    )]
    NotConverged(Box<Solution>),
    /// The observer stopped the run. The iterate reached is inside.
    #[error(
        "stopped after {} iterations at an estimated relative pressure error of {:.2e}",
        .0.diagnostics.iterations, residual(.0)
    )]
    Stopped(Box<Solution>),
}

/// Why so much memory is too much.
fn granted(free: Option<u128>) -> String {
    match free {
        Some(free) => format!("and {} are free on this machine", binary(free)),
        None => "which this machine does not grant".to_owned(),
    }
}

/// A number of bytes in the unit that leaves the fewest digits.
fn binary(bytes: u128) -> String {
    let units = ["bytes", "KiB", "MiB", "GiB", "TiB", "PiB", "EiB"];
    let mut value = bytes as f64;
    let mut unit = 0;
    while value >= 1000.0 && unit + 1 < units.len() {
        value /= 1024.0;
        unit += 1;
    }
    format!("{value:.3} {}", units[unit])
}

fn residual(solution: &Solution) -> f64 {
    solution.diagnostics.residuals.preconditioned
}

impl SolverError {
    /// The iterate reached, if the run got that far.
    pub fn solution(&self) -> Option<&Solution> {
        match self {
            Self::NotConverged(solution) | Self::Rounding(solution) | Self::Stopped(solution) => {
                Some(solution)
            }
            _ => None,
        }
    }
}
