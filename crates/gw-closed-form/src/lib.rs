#![cfg_attr(feature = "model", doc = include_str!("../README.md"))]
#![cfg_attr(not(feature = "model"), doc = "Partial moments of the Gaussian, for any double.")]
//!
//! # What is where
//! - [`partial_moments`]: J_n(α) of the Gaussian, n = 0, 1/2, 1, 3/2: plain, scaled,
//!   logarithm, derivative.
//! - [`inverse`]: α from a load or its logarithm.
#![cfg_attr(
    feature = "model",
    doc = "- [`GreenwoodWilliamson`]: the model with units: pressure, area, stiffness."
)]
//!
//! # Source
//! Greenwood & Williamson (1966), doi:10.1098/rspa.1966.0242; Jackson & Green, IJTC2009-15106.
#![no_std]

mod arithmetic;
pub mod inverse;
pub mod partial_moments;

#[cfg(feature = "model")]
mod model;
#[cfg(feature = "model")]
mod products;

#[cfg(feature = "model")]
pub use contact_types::{
    AsperityStatistics, Caveat, Citation, ContactModel, ContactModulus, ContactState, Elastic,
    ModelError, SeparationModel, SpectralMoments, SurfaceError,
};
#[cfg(feature = "model")]
pub use model::GreenwoodWilliamson;
