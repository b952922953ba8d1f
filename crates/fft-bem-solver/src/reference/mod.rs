//! Exact solutions of contact problems: what the solver is compared with.
//!
//! Each is a closed form in SI units, independent of the solver.

mod hertz;
mod sinusoid;
mod two_harmonic;

pub use hertz::Hertz;
pub use sinusoid::Westergaard;
pub(crate) use two_harmonic::TwoHarmonic;
