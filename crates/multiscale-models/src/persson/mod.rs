//! Persson's theory: the pressure distribution diffuses as finer roughness comes into view.

mod profile_amplitudes;
mod scales;
mod self_affine;
mod span;
mod theory;
mod with_yield;

pub use self_affine::SelfAffineSpectrum;
pub use theory::Persson;
pub use with_yield::PerssonWithYield;
