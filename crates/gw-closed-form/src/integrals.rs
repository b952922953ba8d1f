//! The two integrals of the Greenwood-Williamson model, as the source paper names them.
//!
//! Lengths are divided by the rms height σ of the surface, as in the paper, or by any other
//! length, or kept in metres: `a` and `height_std` must only share the unit. `a` is the distance
//! of the rigid flat from the *mean summit plane*, `a = h - y_s`; `height_std` is the standard
//! deviation of summit heights σ_s. Only its square enters the height density, so a sign is
//! ignored; 0 means that all summits have one height.
//!
//! Both are finite for all finite input, fall with `a` to the last bit, and are right to 5e-16 of
//! their value (below the normal range of doubles: to the last bit that is left). What exceeds
//! the largest double is returned as `f64::MAX`.

use crate::arithmetic::{clamp_to_finite, product};
use crate::partial_moments::{self, Order};

/// I_ep, the load integral of eq. (1a) and (A1):
///
/// ```math
/// I_{ep}(a) = \int_a^\infty (z-a)^{3/2}\,\phi(z)\,dz = \sigma_s^{3/2} J_{3/2}(a/\sigma_s)
/// ```
///
/// ```
/// // All summits level with the flat's position on average: Gamma(5/4) / (2^(1/4) sqrt(pi)).
/// let load = gw_closed_form::integrals::load(0.0, 1.0);
/// assert!((load - 0.430_019_993_662_259_8).abs() < 1e-16);
/// ```
pub fn load(a: f64, height_std: f64) -> f64 {
    clamp_to_finite(product(&factors(Order::ThreeHalves, a, height_std)))
}

/// I_ea, the area integral of eq. (2a) and (A2):
///
/// ```math
/// I_{ea}(a) = \int_a^\infty (z-a)\,\phi(z)\,dz = \sigma_s J_1(a/\sigma_s)
/// ```
pub fn area(a: f64, height_std: f64) -> f64 {
    clamp_to_finite(product(&factors(Order::One, a, height_std)))
}

/// ln I_ep, where I_ep itself would under- or overflow. `height_std` must not be 0.
#[cfg(feature = "model")]
pub(crate) fn ln_load(a: f64, height_std: f64) -> f64 {
    let s = height_std.abs();
    if a / s < DEEP {
        return 1.5 * libm::log(-a);
    }
    clamp_to_finite(1.5 * libm::log(s) + partial_moments::ln(Order::ThreeHalves, a / s))
}

/// σ_s^n J_n(a/σ_s) as factors, so that a caller can multiply on without overflow in between.
pub(crate) fn factors(order: Order, a: f64, height_std: f64) -> [f64; 3] {
    let s = height_std.abs();
    let alpha = if s > 0.0 || a.is_nan() || s.is_nan() {
        a / s
    } else {
        // One sharp height, σ_s = 0: touching there is no contact.
        if a < 0.0 { f64::NEG_INFINITY } else { f64::INFINITY }
    };
    // a -> -inf: full overlap, |a|^n
    let is_deep = alpha < DEEP;
    let [whole, root] = powers(order, if is_deep { -a } else { s });
    [whole, root, if is_deep { 1.0 } else { partial_moments::value(order, alpha) }]
}

/// `length^n` as a whole power and a root.
pub(crate) fn powers(order: Order, length: f64) -> [f64; 2] {
    match order {
        Order::Zero => [1.0, 1.0],
        Order::Half => [1.0, libm::sqrt(length)],
        Order::One => [length, 1.0],
        Order::ThreeHalves => [length, libm::sqrt(length)],
    }
}

/// Beyond this many standard deviations the overlap power is exact to rounding.
const DEEP: f64 = -1e9;
