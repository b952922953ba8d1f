#![doc = include_str!("../README.md")]
//!
//! # The models
//! What each scale of roughness does to the contact that the larger scales left:
//!
//! | model | from | knows |
//! |---|---|---|
//! | [`Persson`] | moments, or a spectrum | area; with a spectrum also mean gap |
//! | [`PerssonWithYield`] | rms gradient and hardness | area |
//! | [`Equation`] | moments | area, with an interval |
//! | [`Stacked`] | largest amplitude over wavelength | area |
//! | [`JacksonStreator`] | amplitude by frequency | area |
//! | [`Archard`] | spheres on spheres | area |
//! | [`MajumdarBhushan`] | profile dimension and roughness | area |
//! | [`YanKomvopoulos`] | surface dimension and roughness | area |

mod answer;
mod archard;
mod equation;
mod jackson_streator;
mod majumdar_bhushan;
mod persson;
mod special;
mod spots;
mod stacked;
mod wide;
mod yan_komvopoulos;

pub use contact_types::{
    AmplitudeSpectrum, Caveat, Citation, ContactModel, ContactModulus, ContactState, Elastic,
    FractalParameters, ModelError, RoughnessSpectrum, Shell, SpectralMoments, SurfaceError, Wave,
};

pub use archard::{Archard, SphereLevel};
pub use equation::Equation;
pub use jackson_streator::JacksonStreator;
pub use majumdar_bhushan::MajumdarBhushan;
pub use persson::{Persson, PerssonWithYield, SelfAffineSpectrum};
pub use spots::PlasticSpots;
pub use stacked::Stacked;
pub use yan_komvopoulos::YanKomvopoulos;

#[cfg(test)]
#[track_caller]
fn close(found: f64, exact: f64, tolerance: f64) {
    // By default the macro also has an absolute tolerance of 2e-16, which any two small numbers pass.
    approx::assert_relative_eq!(found, exact, max_relative = tolerance, epsilon = 0.0);
}
