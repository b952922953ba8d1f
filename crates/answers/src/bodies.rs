//! The contact modulus of what was given.

use crate::failure::Failure;
use compare::Body;
use contact_types::{ContactModulus, Elastic, SurfaceError};

/// E* itself (Pa).
///
/// # Errors
/// [`Failure`] of a number that is no modulus.
pub fn of_modulus(pascals: f64) -> Result<ContactModulus, Failure> {
    ContactModulus::from_pascals(pascals).map_err(|e| failure(&e))
}

/// E* of one body against a rigid one, or of two.
///
/// # Errors
/// [`Failure`] of constants out of their domain, or of another number of bodies.
pub fn contact_modulus(bodies: &[Body]) -> Result<ContactModulus, Failure> {
    let elastic = |body: &Body| Elastic::new(body.young, body.poisson);
    let modulus = match bodies {
        [only] => elastic(only).and_then(ContactModulus::against_rigid),
        [first, second] => {
            elastic(first).and_then(|first| ContactModulus::of_pair(first, elastic(second)?))
        }
        _ => {
            let message =
                format!("{} elastic bodies make no contact; give one or two", bodies.len());
            return Err(Failure::refused("material", message));
        }
    };
    modulus.map_err(|e| failure(&e))
}

fn failure(error: &SurfaceError) -> Failure {
    match error {
        SurfaceError::Material { quantity, value, unit: "", domain } => {
            let (low, high) = (domain.start(), domain.end());
            let message = format!("{quantity} = {value} is outside its domain, {low} to {high}");
            Failure::refused("material", message)
        }
        other => Failure::from_error(other),
    }
}
