//! Exact solutions of contact problems: what the solver is compared with.
//!
//! Each is a closed form (the bi-sinusoid beyond its limits: a table of converged calculations) in
//! SI units, independent of the solver.

pub mod flat_punch;
pub mod full_contact;
pub mod hertz;
pub mod sinusoid;
pub mod two_harmonic;
pub mod wavy_2d;

pub use flat_punch::FlatPunch;
pub use hertz::Hertz;
pub use sinusoid::Westergaard;
pub use two_harmonic::TwoHarmonic;
pub use wavy_2d::BiSinusoid;
