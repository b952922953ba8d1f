//! The inverse problem: how far apart are the surfaces under a given load?
//!
//! Solves J_n(α) = value for α, n = 1 (area) or 3/2 (load). ln J_n is concave and falls, so Newton's
//! iteration on it converges from any start and from the second iterate on from one side; two or
//! three steps from the starting values below.
//!
//! Error at most 4e-15 max(1, |α|); from a logarithm x > 0 it cannot be better than the
//! rounding of x itself allows, |x| 1e-16 |α|.

use crate::partial_moments::{Order, ln, ln_derivative};

/// α from J_n(α) = `value`; `None` unless that is finite and positive, and for other n.
///
/// ```
/// use gw_closed_form::{inverse, partial_moments::Order};
/// let alpha = inverse::from_value(Order::ThreeHalves, 1e-6).unwrap();
/// assert!((alpha - 4.318_855_902_881_386).abs() < 2e-15);
/// ```
pub fn from_value(order: Order, value: f64) -> Option<f64> {
    if !(value > 0.0 && value.is_finite()) {
        return None;
    }
    let overlap = match order {
        Order::One => value,
        Order::ThreeHalves => {
            let root = libm::cbrt(value);
            root * root
        }
        _ => return None,
    };
    Some(solve(order, libm::log(value), overlap))
}

/// α from ln J_n(α) = `logarithm`, for values that no double can hold; `None` unless it is finite,
/// where α would be below the most negative double (above about 709 n), and for other n.
pub fn from_ln(order: Order, logarithm: f64) -> Option<f64> {
    let overlap = libm::exp(logarithm / order.exponent());
    let is_held = order.exponent() >= 1.0 && logarithm.is_finite() && overlap.is_finite();
    is_held.then(|| solve(order, logarithm, overlap))
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
