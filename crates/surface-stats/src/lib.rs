#![doc = include_str!("../README.md")]
//!
//! # What is where
//! [`SurfaceStatistics::of`] answers most questions in one call; the parts are public beside it.
//! Definitions, choices and their consequences are in the book, chapter "Surface statistics".

mod by_distance;
pub mod clean;
mod differences;
mod error;
mod fractal;
mod heights;
pub mod iso25178;
mod level;
mod linear;
mod noise;
pub mod numbers;
pub mod pair;
mod polynomial;
pub mod profile;
mod scale;
mod seam;
pub mod spectrum;
mod statistics;
mod steps;
mod summits;
pub mod synthesis;
mod warning;

pub use contact_types::{
    AmplitudeSpectrum, AsperityStatistics, FractalParameters, Grid, HeightMap, RoughnessSpectrum,
    Shell, SpectralMoments, SurfaceError, Wave,
};

pub use by_distance::{ByDistance, by_distance};
use differences::DirectionalMoments;
pub use differences::{Edges, mean_slope, moments};
pub use error::StatsError;
use heights::HeightStatistics;
pub use level::{Level, tilted};
pub use seam::{repeats, seam_jump};
pub use statistics::{
    STATISTICS, Spectra, Statistic, StatsOptions, SurfaceStatistics, spectral_scales,
};
pub use steps::height_step;
pub use summits::Summits;
pub use warning::Warning;

#[cfg(test)]
#[track_caller]
fn close(found: f64, exact: f64, tolerance: f64) {
    // By default the macro also has an absolute tolerance of 2e-16, which any two small numbers pass.
    approx::assert_relative_eq!(found, exact, max_relative = tolerance, epsilon = 0.0);
}
