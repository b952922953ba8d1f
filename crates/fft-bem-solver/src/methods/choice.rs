//! Which method is run.

use super::baseline::Baseline;
use super::chord::Chord;
use super::contract::ContactMethod;
use super::free_chord::FreeChord;
use super::polonsky_keer::PolonskyKeer;
use super::stanley_kato::StanleyKato;
use super::thin_pixels;
use crate::{Boundary, Method, Real, SolverError};
use contact_types::Grid;

/// The method asked for, with its memory.
pub(crate) fn build<T: Real>(
    method: Method,
    scaled: Grid,
    boundary: Boundary,
) -> Result<Box<dyn ContactMethod<T>>, SolverError> {
    let ratio = thin_pixels::ratio(scaled.shape(), scaled.pixel());
    if method == Method::Chord && ratio > thin_pixels::LARGEST_RATIO {
        return Err(SolverError::Range {
            quantity: "ratio of the pixel sides",
            value: ratio,
            way_out: "up to 1e5 it can: average the map along the shorter sides, or choose the \
                      method polonsky-keer",
        });
    }
    Ok(match (method, boundary) {
        (Method::PolonskyKeer, _) => Box::new(Baseline::<T, PolonskyKeer>::new(scaled.len())),
        (Method::StanleyKato, _) => Box::new(Baseline::<T, StanleyKato>::new(scaled.len())),
        (_, Boundary::Periodic) => Box::new(Chord::new(scaled, false)),
        (_, Boundary::Free) => Box::new(FreeChord::new(scaled)?),
    })
}
