//! Quadrature that shares nothing with the crate's.

use std::f64::consts::PI;

/// Double-exponential quadrature of a smooth function over [a, b]: `x = m + h tanh(pi/2 sinh t)`.
pub(crate) fn integral(a: f64, b: f64, f: impl Fn(f64) -> f64) -> f64 {
    let (half, step) = (0.5 * (b - a), 1.0 / 32.0);
    (-130..=130)
        .map(|i| {
            let t = f64::from(i) * step;
            let u = 0.5 * PI * t.sinh();
            let weight = 0.5 * PI * t.cosh() / u.cosh().powi(2);
            // Distance to the nearer end without cancellation: half (1 - tanh u)
            let near = half * (-u.abs()).exp() / u.abs().cosh();
            let x = if u < 0.0 { a + near } else { b - near };
            if weight > 1e-300 { step * weight * f(x) } else { 0.0 }
        })
        .sum::<f64>()
        * half
}

/// The same over panels that rise by a factor.
pub(crate) fn geometric_integral(a: f64, b: f64, factor: f64, f: impl Fn(f64) -> f64) -> f64 {
    let (mut sum, mut lo) = (0.0, a);
    while lo < b {
        let hi = (lo * factor).min(b);
        sum += integral(lo, hi, &f);
        lo = hi;
    }
    sum
}
