//! The inverse problem: how far apart are the surfaces under a given load?
//!
//! Solves J_3/2(α) = value for α. ln J_3/2 is concave and falls, so Newton's
//! iteration on it converges from any start and from the second iterate on from one side; two or
//! three steps from the starting values below.
//!
//! Error at most 4e-15 max(1, |α|); from a logarithm x > 0 it cannot be better than the
//! rounding of x itself allows, |x| 1e-16 |α|.

use crate::partial_moments::{Order, ln, ln_derivative};

/// α from J_3/2(α) = `value`; `None` unless that is finite and positive.
///
/// ```
/// use gw_closed_form::inverse;
/// let alpha = inverse::from_value(1e-6).unwrap();
/// assert!((alpha - 4.318_855_902_881_386).abs() < 2e-15);
/// ```
pub fn from_value(value: f64) -> Option<f64> {
    let root = libm::cbrt(value);
    (value > 0.0 && value.is_finite()).then(|| solve(libm::log(value), root * root))
}

/// α from ln J_3/2(α) = `logarithm`, for values that no double can hold; `None` unless it is finite,
/// and where α would be below the most negative double (above about 1064).
pub fn from_ln(logarithm: f64) -> Option<f64> {
    let overlap = libm::exp(logarithm / 1.5);
    (logarithm.is_finite() && overlap.is_finite()).then(|| solve(logarithm, overlap))
}

/// `overlap` is value^{2/3}: minus α where everything overlaps.
fn solve(target: f64, overlap: f64) -> f64 {
    let order = Order::ThreeHalves;
    let mut alpha = if target > 0.0 {
        // J_n = x^n (1 + n (n-1) / (2 x^2) + ...)
        -(overlap - 0.25 / overlap)
    } else if target > -2.0 {
        -0.67 - 0.69 * target
    } else {
        // J_n -> Gamma(n+1)/sqrt(2 pi) exp(-alpha^2/2) / alpha^(n+1)
        let exponent = -0.634 - target;
        let b = libm::sqrt(2.0) * libm::sqrt(exponent);
        let square = exponent - 2.5 * libm::log(b + 0.9);
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
