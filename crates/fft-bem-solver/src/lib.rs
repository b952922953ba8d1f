//! Deterministic elastic contact of a rough surface with a flat, by FFT-accelerated boundary
//! elements.
//!
//! Of the pressures `p >= 0` that carry the load, the one that makes the elastic energy minus the
//! work of the heights smallest leaves a gap that is nowhere negative and vanishes where the
//! pressure does not. [`Solver`] finds it, on any grid, and says how accurate it is.
//!
//! ```
//! use fft_bem_solver::{ContactModulus, Grid, HeightMap, Load, Solver};
//!
//! let grid = Grid::new([32, 32], [1e-6, 1e-6])?; // 32 x 32 pixels of 1 um
//! let q = std::f64::consts::TAU / 32e-6;
//! let surface = HeightMap::from_fn(grid, |y, x| 1e-7 * (q * y).cos() * (q * x).cos())?;
//! let modulus = ContactModulus::from_pascals(110e9)?;
//!
//! let mut solver = Solver::builder().tolerance(1e-6).build(grid, modulus)?;
//! let solution = solver.solve(&surface, Load::MeanPressure(50e6))?;
//! assert!(solution.state.area_fraction > 0.05 && solution.state.area_fraction < 0.5);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#![warn(missing_debug_implementations)]

mod assemble;
mod builder;
mod certificate;
mod control;
mod engine;
mod error;
mod fields;
mod half_space;
mod half_space_free;
mod memory;
mod methods;
mod mixed_problem;
mod observer;
mod perimeter_correction;
mod pool;
mod problem;
mod projection;
mod real;
pub mod reference;
mod row_work;
mod settings;
mod simd;
mod solution;
mod solver;
mod special_cases;
mod tally;
pub mod validation;

pub use builder::SolverBuilder;
pub use contact_types::{
    Caveat, ContactModulus, ContactState, Elastic, Grid, HeightMap, ModelError, SurfaceError,
};
pub use error::SolverError;
pub use half_space::HalfSpace;
use half_space_free::love;
pub use mixed_problem::SetStiffness;
pub use observer::{Iteration, ObserverResult};
pub use perimeter_correction::PERIMETER_CORRECTION;
pub use real::Real;
pub use settings::{Boundary, Load, Maps, Method, Precision};
pub use solution::{Diagnostics, End, Residuals, Solution, Yielded};
pub use solver::Solver;

#[cfg(test)]
#[track_caller]
fn close(found: f64, exact: f64, tolerance: f64) {
    // By default the macro also has an absolute tolerance of 2e-16, which any two small numbers pass.
    approx::assert_relative_eq!(found, exact, max_relative = tolerance, epsilon = 0.0);
}
