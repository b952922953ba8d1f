//! Which method is run.

use super::chord::Chord;
use super::contract::ContactMethod;
use super::free_chord::FreeChord;
use super::polonsky_keer::PolonskyKeer;
use super::stanley_kato::StanleyKato;
use crate::{Boundary, Method, Real, SolverError};
use contact_types::Grid;

/// The method asked for, with its memory; and which one `Auto` became.
pub(crate) fn build<T: Real>(
    method: Method,
    scaled: Grid,
    boundary: Boundary,
) -> Result<(Method, Box<dyn ContactMethod<T>>), SolverError> {
    Ok(match (method, boundary) {
        (Method::Auto | Method::Chord, Boundary::Periodic) => {
            (Method::Chord, Box::new(Chord::new(scaled)))
        }
        (Method::Auto | Method::Chord, Boundary::Free) => {
            (Method::Chord, Box::new(FreeChord::new(scaled)?))
        }
        (Method::PolonskyKeer, _) => {
            (Method::PolonskyKeer, Box::new(PolonskyKeer::new(scaled.len())))
        }
        (Method::StanleyKato, _) => (Method::StanleyKato, Box::new(StanleyKato::new(scaled.len()))),
    })
}
