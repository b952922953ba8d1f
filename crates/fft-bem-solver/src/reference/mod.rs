//! Exact solutions of contact problems: what the solver is compared with.
//!
//! Each is a closed form (the bi-sinusoid beyond its limits: a table of converged calculations) in
//! SI units, independent of the solver.

pub mod flat_punch;
pub mod full_contact;
pub mod hertz;
pub mod sinusoid;
pub mod two_harmonic;
pub mod wavy_2d;

pub use flat_punch::FlatPunch;
pub use hertz::Hertz;
pub use sinusoid::Westergaard;
pub use two_harmonic::TwoHarmonic;
pub use wavy_2d::BiSinusoid;

use contact_types::ModelError;

/// `value`, if it is a finite number above 0.
fn positive(model: &'static str, quantity: &'static str, value: f64) -> Result<f64, ModelError> {
    if value.is_finite() && value > 0.0 {
        return Ok(value);
    }
    let requirement = "it must be finite and greater than 0";
    Err(ModelError::InvalidInput {
        model: model.into(),
        quantity: quantity.into(),
        value,
        requirement: requirement.into(),
    })
}

/// `value`, if it is a finite number, 0 or above.
fn not_negative(
    model: &'static str,
    quantity: &'static str,
    value: f64,
) -> Result<f64, ModelError> {
    if value.is_finite() && value >= 0.0 {
        return Ok(value);
    }
    let requirement = "it must be finite and not negative";
    Err(ModelError::InvalidInput {
        model: model.into(),
        quantity: quantity.into(),
        value,
        requirement: requirement.into(),
    })
}
