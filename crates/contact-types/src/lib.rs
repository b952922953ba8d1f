#![doc = include_str!("../README.md")]
//!
//! # Conventions
//! - SI units in `f64`, everywhere.
//! - Heights are positive out of the material; pressure is positive in compression;
//!   displacement is positive into the body; a gap is never negative.
//! - Fields are row-major: pixel (iy, ix) is at index `iy * nx + ix`.
//! - `q` is angular wavenumber (rad/m); `f = 1 / wavelength` is not.
//! - Spectral moments are those of a *profile* (Nayak 1971): `m2 = <|grad h|^2> / 2`.

#[cfg(feature = "serde")]
mod any_number;
mod clock;
mod contact;
mod error;
mod grid;
mod height_map;
mod material;
mod moments;
mod named;
pub mod require;
mod spectrum;

pub use clock::Clock;
pub use contact::{Caveat, Citation, ContactModel, ContactState, SeparationModel};
pub use error::{ModelError, SurfaceError};
pub use grid::{Axis, Grid};
pub use height_map::HeightMap;
pub use material::{ContactModulus, Elastic};
pub use moments::{AsperityStatistics, FractalParameters, SpectralMoments};
pub use named::Named;
pub use spectrum::{AmplitudeSpectrum, RoughnessSpectrum, Shell, Wave};

#[cfg(test)]
#[track_caller]
fn close(found: f64, exact: f64, tolerance: f64) {
    // By default the macro also has an absolute tolerance of 2e-16, which any two small numbers pass.
    approx::assert_relative_eq!(found, exact, max_relative = tolerance, epsilon = 0.0);
}
