//! Exact solutions of contact problems: what the solver is compared with.
//!
//! Each is a closed form (the bi-sinusoid between its limits: a converged calculation) in
//! SI units, independent of the solver.

pub mod full_contact;
mod hertz;
mod sinusoid;
mod two_harmonic;
mod wavy_2d;

pub use hertz::{Hertz, HertzContact};
pub use sinusoid::{Westergaard, WestergaardContact};
pub(crate) use two_harmonic::TwoHarmonic;
pub use wavy_2d::BiSinusoid;
