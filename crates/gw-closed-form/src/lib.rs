//! Greenwood-Williamson contact of rough surfaces in closed form, right to rounding for every
//! double.
//!
//! - [`partial_moments`]: J_n(α) of the Gaussian, n = 0, 1/2, 1, 3/2, 5/2: plain, scaled,
//!   logarithm, derivative.
//! - [`integrals`]: I_ep (load) and I_ea (area) of the source paper.
//! - [`inverse`]: α from a load, a log-load or an area.
#![cfg_attr(
    feature = "model",
    doc = "- [`GreenwoodWilliamson`]: the model with units: pressure, area, stiffness, contacts."
)]
//! - [`appendix`], [`bessel`]: (A1) and (A2) literally, with their loss of digits.
//! - [`approximations`]: the exponential height law and the curve fits they replaced.
//!
//! The crate is `no_std`. Without the feature `model` it needs only `libm`.
//!
//! # Source
//! Greenwood & Williamson (1966), doi:10.1098/rspa.1966.0242; Jackson & Green, IJTC2009-15106.
#![no_std]

pub mod appendix;
pub mod approximations;
mod arithmetic;
pub mod bessel;
pub mod integrals;
pub mod inverse;
pub mod partial_moments;

#[cfg(feature = "model")]
mod asperities;
#[cfg(feature = "model")]
mod model;

#[cfg(feature = "model")]
pub use asperities::asperities_from_moments;
#[cfg(feature = "model")]
pub use model::GreenwoodWilliamson;
