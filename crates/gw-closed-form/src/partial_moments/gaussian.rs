//! The Gaussian itself.

use crate::arithmetic::exp_half_square;

/// The standard normal density φ(α).
pub fn density(alpha: f64) -> f64 {
    times_gaussian(FRAC_1_SQRT_2PI, alpha)
}

/// `factor` times exp(-α²/2), with no digit lost in α² and no underflow before the result itself
/// underflows.
pub fn times_gaussian(factor: f64, alpha: f64) -> f64 {
    if alpha.abs() > 1e3 {
        return 0.0;
    }
    let [outer, inner] = exp_half_square(alpha);
    (factor * outer * inner) * outer
}

/// 1/√(2π).
pub(crate) const FRAC_1_SQRT_2PI: f64 = 0.398_942_280_401_432_7;
