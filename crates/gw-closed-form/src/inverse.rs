//! The inverse problem: how far apart are the surfaces under a given load?
//!
//! Solves J_n(α) = value for α. ln J_n is concave and falls, so Newton's iteration on it
//! converges from any start and from the second iterate on from one side; two or three steps
//! from the starting values below.
//!
//! Error at most 4e-15 max(1, |α|); from a logarithm x > 0 it cannot be better than the
//! rounding of x itself allows, |x| 1e-16 |α|.

use crate::partial_moments::{Order, ln, ln_derivative};
use core::fmt;

/// Why there is no α.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum InverseError {
    /// A load or an area must be finite and greater than 0; no contact at all lies at α = ∞.
    NotPositive {
        /// The value found.
        value: f64,
    },
    /// A logarithm must be finite.
    NotFinite {
        /// The value found.
        value: f64,
    },
    /// α would be below the most negative double.
    TooLarge {
        /// The logarithm asked for.
        logarithm: f64,
    },
}

impl fmt::Display for InverseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotPositive { value } => {
                write!(f, "{value:e} is no load or area: it must be finite and greater than 0")
            }
            Self::NotFinite { value } => write!(f, "the logarithm {value} must be finite"),
            Self::TooLarge { logarithm } => {
                write!(f, "exp({logarithm}) is so large that alpha exceeds the range of doubles")
            }
        }
    }
}

impl core::error::Error for InverseError {}

/// α from J_3/2(α) = `load`, any positive double.
///
/// ```
/// let alpha = gw_closed_form::inverse::from_load(1e-6).unwrap();
/// assert!((alpha - 4.318_855_902_881_386).abs() < 2e-15);
/// ```
///
/// # Errors
/// [`InverseError::NotPositive`].
pub fn from_load(load: f64) -> Result<f64, InverseError> {
    from_value(Order::ThreeHalves, load)
}

/// α from ln J_3/2(α) = `logarithm`, for loads that no double can hold.
///
/// # Errors
/// [`InverseError::NotFinite`] and [`InverseError::TooLarge`] (logarithm above about 1064).
pub fn from_ln_load(logarithm: f64) -> Result<f64, InverseError> {
    from_logarithm(Order::ThreeHalves, logarithm)
}

/// α from J_1(α) = `area`.
///
/// # Errors
/// [`InverseError::NotPositive`].
pub fn from_area(area: f64) -> Result<f64, InverseError> {
    from_value(Order::One, area)
}

pub(crate) fn from_value(order: Order, value: f64) -> Result<f64, InverseError> {
    if !(value > 0.0 && value.is_finite()) {
        return Err(InverseError::NotPositive { value });
    }
    let overlap = if order == Order::One {
        value
    } else {
        let root = libm::cbrt(value);
        root * root
    };
    Ok(solve(order, libm::log(value), overlap))
}

pub(crate) fn from_logarithm(order: Order, logarithm: f64) -> Result<f64, InverseError> {
    if !logarithm.is_finite() {
        return Err(InverseError::NotFinite { value: logarithm });
    }
    let overlap = libm::exp(logarithm / order.exponent());
    if overlap.is_infinite() {
        return Err(InverseError::TooLarge { logarithm });
    }
    Ok(solve(order, logarithm, overlap))
}

/// `overlap` is value^{1/n}: minus α where everything overlaps.
fn solve(order: Order, target: f64, overlap: f64) -> f64 {
    let n = order.exponent();
    let mut alpha = if target > 0.0 {
        // J_n = x^n (1 + n (n-1) / (2 x^2) + ...)
        -(overlap - 0.5 * (n - 1.0) / overlap)
    } else if target > -2.0 {
        -0.67 - 0.69 * target
    } else {
        // J_n -> Gamma(n+1)/sqrt(2 pi) exp(-alpha^2/2) / alpha^(n+1)
        let factor = if order == Order::One { -0.919 } else { -0.634 };
        let exponent = factor - target;
        let b = libm::sqrt(2.0) * libm::sqrt(exponent);
        let square = exponent - (n + 1.0) * libm::log(b + 0.9);
        libm::sqrt(2.0) * libm::sqrt(square.max(0.125))
    };
    // Above 24 the next term of the series is below rounding.
    let steps = if target > 24.0 { 0 } else { MAX_STEPS };
    for _ in 0..steps {
        let step = (ln(order, alpha) - target) / ln_derivative(order, alpha);
        alpha -= step;
        // Quadratic: a step of 1e-9 leaves only rounding behind.
        if step.abs() <= 1e-9 * alpha.abs().max(1.0) {
            break;
        }
    }
    alpha
}

/// Never reached: five steps are the most that were needed in 1e5 random cases.
const MAX_STEPS: usize = 50;
