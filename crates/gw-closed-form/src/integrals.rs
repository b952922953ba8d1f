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
    clamp_to_finite(product(&load_factors(a, height_std)))
}

/// I_ea, the area integral of eq. (2a) and (A2):
///
/// ```math
/// I_{ea}(a) = \int_a^\infty (z-a)\,\phi(z)\,dz = \sigma_s J_1(a/\sigma_s)
/// ```
pub fn area(a: f64, height_std: f64) -> f64 {
    clamp_to_finite(product(&area_factors(a, height_std)))
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

/// I_ep as factors, so that a caller can multiply on without overflow in between.
pub(crate) fn load_factors(a: f64, height_std: f64) -> [f64; 3] {
    let (s, alpha) = (height_std.abs(), ratio(a, height_std));
    if alpha < DEEP {
        // a -> -inf: full overlap, I_ep -> |a|^(3/2)
        return [-a, libm::sqrt(-a), 1.0];
    }
    [s, libm::sqrt(s), partial_moments::value(Order::ThreeHalves, alpha)]
}

/// I_ea as factors.
pub(crate) fn area_factors(a: f64, height_std: f64) -> [f64; 2] {
    let alpha = ratio(a, height_std);
    if alpha < DEEP {
        return [-a, 1.0]; // a -> -inf: full overlap, I_ea -> |a|
    }
    [height_std.abs(), partial_moments::value(Order::One, alpha)]
}

/// -dI_ep/da = (3/2) σ_s^{1/2} J_{1/2}(a/σ_s), what the contact stiffness is made of, as factors.
#[cfg(feature = "model")]
pub(crate) fn slope_factors(a: f64, height_std: f64) -> [f64; 3] {
    let alpha = ratio(a, height_std);
    if alpha < DEEP {
        return [1.5, libm::sqrt(-a), 1.0];
    }
    let j = partial_moments::value(Order::Half, alpha);
    [1.5, libm::sqrt(height_std.abs()), j]
}

/// Beyond this many standard deviations the overlap power is exact to rounding.
const DEEP: f64 = -1e9;

/// α = a/σ_s; one sharp height (σ_s = 0) is the limit ±∞, and touching there is no contact.
fn ratio(a: f64, height_std: f64) -> f64 {
    let s = height_std.abs();
    if s > 0.0 || a.is_nan() || s.is_nan() {
        a / s
    } else if a < 0.0 {
        f64::NEG_INFINITY
    } else {
        f64::INFINITY
    }
}
