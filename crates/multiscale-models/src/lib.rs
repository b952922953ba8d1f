//! Multiscale theories of elastic contact between rough surfaces: what each scale of roughness
//! does to the contact that the larger scales left.
//!
//! | model | from | knows |
//! |---|---|---|
//! | [`Persson`] | moments, or a spectrum | area; with a spectrum also mean gap, stiffness, energy |
//! | [`Stacked`] | largest amplitude over wavelength | area |
//! | [`MajumdarBhushan`] | fractal dimension and roughness | area |
//!
//! Every model answers for any finite input with a number, a number and a
//! [`Caveat`](contact_types::Caveat), or a typed error: never NaN, never infinity.

mod majumdar_bhushan;
mod persson;
mod require;
pub mod special;
mod stacked;
mod wide;

pub use majumdar_bhushan::{MajumdarBhushan, critical_area};
pub use persson::{AreaLaw, Persson, PressureDistribution, SelfAffineSpectrum};
pub use stacked::Stacked;
