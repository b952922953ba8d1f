//! Products, quotients and powers of positive numbers that cannot overflow on the way.

use std::ops::{Add, Div, Mul};

/// A number that is not negative, with an exponent far beyond that of a double:
/// `mantissa * 2^exponent`, the mantissa in [1/2, 1) or 0.
///
/// A formula such as `p / (E* g)` is written with it as on paper; its value is rounded a few
/// times like any other, but no intermediate result overflows or loses digits to underflow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Wide {
    mantissa: f64,
    exponent: i64,
}

impl Wide {
    /// The nearest double: 0 or infinity where its range ends.
    pub(crate) fn value(self) -> f64 {
        // A double spans 2^-1074 to 2^1024; beyond +-3000 the result is 0 or infinity anyway.
        libm::ldexp(self.mantissa, self.exponent.clamp(-3000, 3000) as i32)
    }

    /// True for zero itself, not for what merely underflows a double.
    pub(crate) fn is_zero(self) -> bool {
        self.mantissa <= 0.0
    }

    /// Natural logarithm; the number must not be zero.
    pub(crate) fn ln(self) -> f64 {
        self.mantissa.ln() + self.exponent as f64 * std::f64::consts::LN_2
    }

    /// `e^x`, for any finite `x`; its error is that of `x` itself.
    pub(crate) fn exp(x: f64) -> Self {
        let whole = (x / std::f64::consts::LN_2).round();
        let rest = (x - whole * LN_2_HIGH) - whole * LN_2_LOW;
        Self::new(rest.exp(), whole as i64)
    }

    pub(crate) fn sqrt(self) -> Self {
        let odd = self.exponent.rem_euclid(2);
        let mantissa = if odd == 1 { 2.0 * self.mantissa } else { self.mantissa };
        Self::new(mantissa.sqrt(), (self.exponent - odd) / 2)
    }

    /// Cube root. Powers such as 2/3 are taken with it: 2/3 is no double, and its rounding times
    /// the logarithm of a very small number would show.
    pub(crate) fn cbrt(self) -> Self {
        let rest = self.exponent.rem_euclid(3);
        let mantissa = self.mantissa * f64::from(1_u8 << rest);
        Self::new(mantissa.cbrt(), (self.exponent - rest) / 3)
    }

    /// `self^power`. The exponent's share is split exactly into an integer and a remainder, so
    /// the relative error stays at a few units in the last place times `max(1, |power|)`.
    pub(crate) fn powf(self, power: f64) -> Self {
        if self.is_zero() {
            return if power > 0.0 { self } else { Self::from(1.0) };
        }
        // Mantissa in [1/sqrt 2, sqrt 2): its power overflows only for |power| > 2000.
        let (m, e) = if self.mantissa < std::f64::consts::FRAC_1_SQRT_2 {
            (2.0 * self.mantissa, self.exponent as f64 - 1.0)
        } else {
            (self.mantissa, self.exponent as f64)
        };
        let product = e * power;
        let error = e.mul_add(power, -product); // exact: what the product lost to rounding
        let (from_mantissa, mantissa_power) =
            if power.abs() > 1e3 { (m.log2() * power, 1.0) } else { (0.0, m.powf(power)) };
        let whole = product.round() + from_mantissa.round();
        let rest = (product - product.round()) + error + (from_mantissa - from_mantissa.round());
        Self::new(mantissa_power * rest.exp2(), whole as i64)
    }

    fn new(value: f64, exponent: i64) -> Self {
        let (mantissa, shift) = libm::frexp(value);
        Self { mantissa, exponent: exponent.saturating_add(shift.into()).clamp(-LIMIT, LIMIT) }
    }
}

/// ln 2 in two parts; the first has trailing zeros, so that its multiples by integers below 2^20
/// are exact.
const LN_2_HIGH: f64 = 6.93147180369123816490e-01;
const LN_2_LOW: f64 = 1.90821492927058770002e-10;

/// Exponents are held within +-2^60, so that sums of two never overflow.
const LIMIT: i64 = 1 << 60;

impl From<f64> for Wide {
    /// Takes a finite number that is not negative.
    fn from(value: f64) -> Self {
        debug_assert!(value >= 0.0 && value.is_finite(), "{value} is not usable here");
        Self::new(value, 0)
    }
}

impl Add for Wide {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return if self.is_zero() { other } else { self };
        }
        let (small, large) =
            if self.exponent < other.exponent { (self, other) } else { (other, self) };
        let shift = (small.exponent - large.exponent).max(-3000) as i32;
        Self::new(large.mantissa + libm::ldexp(small.mantissa, shift), large.exponent)
    }
}

impl Mul for Wide {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(self.mantissa * other.mantissa, self.exponent + other.exponent)
    }
}

impl Mul<f64> for Wide {
    type Output = Self;
    fn mul(self, other: f64) -> Self {
        self * Self::from(other)
    }
}

impl Div for Wide {
    type Output = Self;
    /// The divisor must not be zero.
    fn div(self, other: Self) -> Self {
        Self::new(self.mantissa / other.mantissa, self.exponent - other.exponent)
    }
}

impl Div<f64> for Wide {
    type Output = Self;
    fn div(self, other: f64) -> Self {
        self / Self::from(other)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::close;

    #[test]
    fn products_pass_through_values_no_double_can_hold() {
        let tiny = Wide::from(f64::MIN_POSITIVE);
        let huge = Wide::from(f64::MAX);
        close((tiny * tiny / tiny).value(), f64::MIN_POSITIVE, 0.0);
        close((huge * huge / huge).value(), f64::MAX, 0.0);
        close((Wide::from(3.0) + Wide::from(0.5)).value(), 3.5, 0.0);
        close(Wide::exp(-740.0).value(), f64::exp(-740.0), 1e-13);
        close(Wide::exp(3.7).value(), f64::exp(3.7), 3e-16);
        assert!((huge * huge).value().is_infinite());
        assert!((tiny * tiny).value() <= 0.0 && !(tiny * tiny).is_zero());
        close((huge * huge).ln(), 2.0 * f64::MAX.ln(), 1e-15);
    }

    #[test]
    fn powers_agree_with_the_standard_library_where_it_can_answer() {
        for x in [1e-300, 3.7e-12, 0.6, 1.0, 1.5, 2.0, 9.1e24, 1.7e300] {
            for y in [-0.9, -1.0 / 3.0, 0.0, 0.05, 0.5, 2.0 / 3.0, 1.0] {
                let expected: f64 = f64::powf(x, y);
                close(Wide::from(x).powf(y).value(), expected, 5e-16);
            }
            close(Wide::from(x).sqrt().value(), x.sqrt(), 3e-16);
            close(Wide::from(x).cbrt().value(), x.cbrt(), 3e-16);
        }
        // (1 + 2^-20)^(2^30): by 30 squarings of the exactly known base, as a logarithm.
        let base = 1.0 + (-20.0_f64).exp2();
        let power = Wide::from(base).powf(30.0_f64.exp2());
        close(power.ln(), 30.0_f64.exp2() * base.ln(), 1e-14);
    }
}
