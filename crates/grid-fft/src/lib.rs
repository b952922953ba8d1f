#![doc = include_str!("../README.md")]
//!
//! # Convention
//! The forward transform is unnormalised with `exp(-i q x)`; the inverse divides by `ny nx`, so
//! that `inverse(forward(field))` is `field`. Only the half spectrum `0..=nx/2` along x is kept.

mod convolution;
mod float;
pub mod parallel;
mod rows;
mod transform;

pub use convolution::Convolution;
pub use float::Float;
#[doc(hidden)]
pub use float::Plans;
pub use rustfft::num_complex::Complex;
pub use transform::GridFft;
