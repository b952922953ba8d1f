//! The moments by order.

use super::function::{
    FAR, Function, HALF, NEAR, ONE, THREE_HALVES, ZERO, density, overlap_correction, taylor,
};
use crate::arithmetic::{clamp_to_finite, exp_half_square};

/// Which partial moment: the power n of the overlap that is averaged.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Order {
    /// n = 0: fraction of summits in contact.
    Zero,
    /// n = 1/2: stiffness.
    Half,
    /// n = 1: area.
    One,
    /// n = 3/2: load.
    ThreeHalves,
}

impl Order {
    fn function(self) -> &'static Function {
        match self {
            Self::Zero => &ZERO,
            Self::Half => &HALF,
            Self::One => &ONE,
            Self::ThreeHalves => &THREE_HALVES,
        }
    }
}

/// J_n(α) for any α. Falls with α to the last bit.
///
/// Error about one unit in the last place (4e-16; 9e-16 for α > 8).
///
/// ```
/// use gw_closed_form::partial_moments::{value, Order};
/// // Half of all summits stand above their mean, by phi(0) = 0.3989... on average.
/// assert_eq!(value(Order::Zero, 0.0), 0.5);
/// assert!((value(Order::One, 0.0) - 0.398_942_280_401_432_7).abs() < 1e-16);
/// ```
pub fn value(order: Order, alpha: f64) -> f64 {
    order.function().value(alpha)
}

/// exp(α²/2) J_n(α): what is left of J_n at large α, a slow power law.
///
/// Error at most 1.5e-15. `f64::MAX` where it overflows (α below about -37).
pub fn scaled(order: Order, alpha: f64) -> f64 {
    let f = order.function();
    if alpha >= FAR {
        f.far_scaled(alpha)
    } else if alpha < -60.0 {
        f64::MAX
    } else {
        let [outer, inner] = exp_half_square(alpha);
        clamp_to_finite(f.value(alpha) / outer / inner / outer)
    }
}

/// ln J_n(α), also where J_n itself under- or overflows, and with full relative accuracy where
/// J_n is close to 1.
///
/// `-f64::MAX` below the range of doubles (α > 1.9e154).
pub fn ln(order: Order, alpha: f64) -> f64 {
    let f = order.function();
    if alpha >= FAR {
        let lead = clamp_to_finite(0.5 * alpha * alpha);
        let scaled = libm::log(f.factor * f.far_series(alpha)) - (f.n + 1.0) * libm::log(alpha);
        return clamp_to_finite(scaled - lead);
    }
    if alpha < 0.0 && order == Order::Zero {
        return libm::log1p(-f.value(-alpha));
    }
    if alpha <= NEAR {
        return f.n * libm::log(-alpha) + libm::log1p(overlap_correction(f.n, -alpha));
    }
    if let Some([at, low, slope]) = f.unity {
        let delta = (alpha - at) - low;
        if delta.abs() < 0.25 {
            return libm::log1p(taylor(f.n, at, [1.0, slope], delta)); // J_n = 1 at the root
        }
    }
    libm::log(f.value(alpha))
}

/// d ln J_n/dα = -n J_{n-1}/J_n, also where both underflow: it tends to -α for large α and to
/// -n/|α| for large negative α.
pub fn ln_derivative(order: Order, alpha: f64) -> f64 {
    let f = order.function();
    if alpha >= FAR {
        // n Gamma(n) / Gamma(n+1) = 1: only the two slowly varying factors remain.
        let below = match order {
            Order::Zero => 1.0,
            // J_{-1/2} = 2 (J_{3/2} + alpha J_{1/2})
            Order::Half => {
                f.far_series(alpha) + 1.5 * THREE_HALVES.far_series(alpha) / alpha / alpha
            }
            Order::One => ZERO.far_series(alpha),
            Order::ThreeHalves => HALF.far_series(alpha),
        };
        return -alpha * below / f.far_series(alpha);
    }
    if alpha <= NEAR && order != Order::Zero {
        let x = -alpha;
        let below = overlap_correction(f.n - 1.0, x);
        return -f.n * (1.0 + below) / (1.0 + overlap_correction(f.n, x)) / x;
    }
    // dJ_n/dα = -n J_{n-1}
    let slope = match order {
        Order::Zero => -density(alpha),
        Order::Half => HALF.slope(alpha), // there is no table of J_{-1/2}
        Order::One => -f.n * ZERO.value(alpha),
        Order::ThreeHalves => -f.n * HALF.value(alpha),
    };
    slope / f.value(alpha)
}
