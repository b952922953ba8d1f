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
use std::borrow::Cow;
use std::ops::RangeInclusive;

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
    Err(refused(model, quantity, value, "must be finite and not negative"))
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
    Err(refused(model, quantity, value, "must be finite and greater than 0"))
}

/// A finite number of either sign.
///
/// # Errors
/// [`ModelError::InvalidInput`].
pub fn finite(model: &'static str, quantity: &'static str, value: f64) -> Result<f64, ModelError> {
    if value.is_finite() {
        return Ok(value);
    }
    Err(refused(model, quantity, value, "must be finite"))
}

/// What came of the input `quantity = value`, if a double can hold it.
///
/// # Errors
/// [`ModelError::OutsideDomain`], which names the input.
pub fn answer(
    model: &'static str,
    result: f64,
    quantity: &'static str,
    value: f64,
) -> Result<f64, ModelError> {
    if result.is_finite() {
        return Ok(result);
    }
    let reason = "the answer exceeds the largest double";
    Err(outside(model, quantity, value, f64::MIN..=f64::MAX, reason))
}

/// The error of an input that cannot be used at all.
pub fn refused(
    model: &'static str,
    quantity: &'static str,
    value: f64,
    requirement: &'static str,
) -> ModelError {
    ModelError::InvalidInput {
        model: model.into(),
        quantity: quantity.into(),
        value,
        requirement: requirement.into(),
    }
}

/// The error of a number at which the theory has no meaning.
pub fn outside(
    model: &'static str,
    quantity: &'static str,
    value: f64,
    domain: RangeInclusive<f64>,
    reason: impl Into<Cow<'static, str>>,
) -> ModelError {
    let (model, quantity, reason) = (model.into(), quantity.into(), reason.into());
    ModelError::OutsideDomain { model, quantity, value, domain, reason }
}
