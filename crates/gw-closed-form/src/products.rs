//! The integrals I_ep and I_ea of the model, and products without overflow or underflow on the way.
//!
//! `a` is the distance of the flat from the mean summit plane, `height_std` the deviation σ_s > 0 of summit
//! heights.

use crate::partial_moments::{self, Order};

/// σ_s^n J_n(a/σ_s), n = 3/2 for I_ep and 1 for I_ea, as factors that a caller multiplies on.
pub(crate) fn factors(order: Order, a: f64, height_std: f64) -> [f64; 3] {
    let alpha = a / height_std;
    if alpha < DEEP {
        let [whole, root] = powers(order, -a);
        return [whole, root, 1.0]; // a -> -inf: full overlap, |a|^n
    }
    let [whole, root] = powers(order, height_std);
    [whole, root, partial_moments::value(order, alpha)]
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

/// Product of factors that are not negative, without overflow or underflow on the way. Rises
/// with each factor to the last bit.
pub(crate) fn product(factors: &[f64]) -> f64 {
    let (mantissa, exponent) = wide_product(factors);
    libm::scalbn(mantissa, exponent)
}

/// A quotient of positive numbers that may lie outside the range of doubles.
#[derive(Clone, Copy)]
pub(crate) struct Quotient {
    /// 0, subnormal or infinite where a double cannot hold it.
    pub(crate) value: f64,
    /// Always finite.
    pub(crate) logarithm: f64,
}

impl Quotient {
    /// `numerator` over the product of `denominators`.
    pub(crate) fn of(numerator: f64, denominators: &[f64]) -> Self {
        let (n, n_exponent) = libm::frexp(numerator);
        let (d, d_exponent) = wide_product(denominators);
        let exponent = n_exponent - d_exponent;
        Self {
            value: libm::scalbn(n / d, exponent),
            logarithm: libm::log(n / d) + f64::from(exponent) * core::f64::consts::LN_2,
        }
    }
}

fn wide_product(factors: &[f64]) -> (f64, i32) {
    let (mut mantissa, mut exponent) = (1.0, 0);
    for &factor in factors {
        let (m, e) = libm::frexp(factor);
        let (renormalised, shift) = libm::frexp(mantissa * m);
        mantissa = renormalised;
        exponent += e + shift;
    }
    (mantissa, exponent)
}
