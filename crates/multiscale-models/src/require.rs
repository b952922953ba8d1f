//! Checks of single numbers, with the message that says what is wrong.

use contact_types::ModelError;

/// The nominal pressure of `at_pressure`: finite and not negative.
pub(crate) fn pressure(model: &'static str, value: f64) -> Result<f64, ModelError> {
    not_negative(model, "mean pressure", value)
}

pub(crate) fn not_negative(
    model: &'static str,
    quantity: &'static str,
    value: f64,
) -> Result<f64, ModelError> {
    if value.is_finite() && value >= 0.0 {
        return Ok(value);
    }
    let requirement = "must be finite and not negative";
    Err(ModelError::InvalidInput {
        model: model.into(),
        quantity: quantity.into(),
        value,
        requirement: requirement.into(),
    })
}

pub(crate) fn positive(
    model: &'static str,
    quantity: &'static str,
    value: f64,
) -> Result<f64, ModelError> {
    if value.is_finite() && value > 0.0 {
        return Ok(value);
    }
    let requirement = "must be finite and greater than 0";
    Err(ModelError::InvalidInput {
        model: model.into(),
        quantity: quantity.into(),
        value,
        requirement: requirement.into(),
    })
}

/// An area fraction between 0 and 1, both included.
pub(crate) fn fraction(
    model: &'static str,
    quantity: &'static str,
    value: f64,
) -> Result<f64, ModelError> {
    if (0.0..=1.0).contains(&value) {
        return Ok(value);
    }
    let requirement = "must lie between 0 and 1";
    Err(ModelError::InvalidInput {
        model: model.into(),
        quantity: quantity.into(),
        value,
        requirement: requirement.into(),
    })
}

/// A result that must be a finite double.
pub(crate) fn representable(
    model: &'static str,
    quantity: &'static str,
    value: f64,
) -> Result<f64, ModelError> {
    if value.is_finite() {
        return Ok(value);
    }
    Err(ModelError::OutsideDomain {
        model: model.into(),
        quantity: quantity.into(),
        value,
        domain: f64::MIN..=f64::MAX,
        reason: "the result exceeds the largest double".into(),
    })
}
