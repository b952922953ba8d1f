//! What the inputs of a reference solution must be.

use contact_types::ModelError;

/// `value`, if it is a finite number above 0.
pub(super) fn positive(
    model: &'static str,
    quantity: &'static str,
    value: f64,
) -> Result<f64, ModelError> {
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
pub(super) fn not_negative(
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
