//! What models ask of single numbers, each refused with the message that says what is wrong.
//!
//! ```
//! use contact_types::require;
//!
//! assert_eq!(require::positive("my model", "rms height", 1e-6), Ok(1e-6));
//! let refused = require::positive("my model", "rms height", -1e-6).unwrap_err();
//! let words = "my model: rms height = -1e-6 is not usable: must be finite and greater than 0";
//! assert_eq!(refused.to_string(), words);
//! ```

use crate::ModelError;

/// The nominal pressure (Pa) of `at_pressure`: finite and not negative.
///
/// # Errors
/// [`ModelError::InvalidInput`].
pub fn pressure(model: &'static str, value: f64) -> Result<f64, ModelError> {
    not_negative(model, "mean pressure", value)
}

/// A finite number, 0 or above.
///
/// # Errors
/// [`ModelError::InvalidInput`].
pub fn not_negative(
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

/// A finite number above 0.
///
/// # Errors
/// [`ModelError::InvalidInput`].
pub fn positive(
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
///
/// # Errors
/// [`ModelError::InvalidInput`].
pub fn fraction(
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
///
/// # Errors
/// [`ModelError::OutsideDomain`].
pub fn representable(
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
