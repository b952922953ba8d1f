//! The two integrals of Persson's mean gap.

use super::coefficients::{E1_TAIL, K_HEAD, K_TAIL};

const EULER_GAMMA: f64 = 0.57721566490153286061;

/// Half the exponential integral of a square, for `x > 0`:
///
/// ```math
/// \tfrac12 E_1(x^2) = \int_x^\infty \frac{e^{-y^2}}{y}\, dy
/// ```
///
/// Taken of `x`, not of `x^2`, so that it answers down to the smallest double. Relative error at
/// most 1.2e-15 for x < 1 (measured), and `x^2` roundings of the exponential above. 0 past x = 27.3, where
/// the result is below the smallest double.
pub(crate) fn half_e1_of_square(x: f64) -> f64 {
    let z = x * x;
    if z > 750.0 {
        return 0.0;
    }
    if z >= 1.0 {
        let t = (z - 4.0) / (z + 2.0); // z = 1 + 3 (1 + t)/(1 - t)
        return 0.5 * (-z).exp() * chebyshev(&E1_TAIL, t) / (z + 0.5);
    }
    // E1(z) = -gamma - ln z + z - z^2/4 + z^3/18 - ...
    let (mut series, mut power, mut k) = (0.0, 1.0, 1.0);
    while k < 20.0 {
        power *= -z / k;
        series -= power / k;
        if power.abs() < 1e-18 {
            break;
        }
        k += 1.0;
    }
    0.5 * (series - EULER_GAMMA) - x.ln()
}

/// For `x >= 0`:
///
/// ```math
/// K(x) = \int_x^\infty \operatorname{erf}^2(y)\, \frac{e^{-y^2}}{y}\, dy
/// ```
///
/// `K(0) = 0.40712493...`. Relative error a few 1e-16, and `x^2` roundings of the exponential.
pub(crate) fn squared_erf_tail(x: f64) -> f64 {
    let z = x * x;
    if z > 750.0 {
        return 0.0;
    }
    let scaled = if z <= 6.0 {
        chebyshev(&K_HEAD, z / 3.0 - 1.0)
    } else {
        chebyshev(&K_TAIL, (z - 26.0) / (z + 14.0)) // z = 6 + 20 (1 + t)/(1 - t)
    };
    (-z).exp() * scaled / (z + 1.0)
}

/// Sum of Chebyshev polynomials `c[j] T_j(t)` (Clenshaw).
fn chebyshev(c: &[f64], t: f64) -> f64 {
    let (mut b1, mut b2) = (0.0, 0.0);
    for &cj in c[1..].iter().rev() {
        (b1, b2) = (cj + 2.0 * t * b1 - b2, b1);
    }
    c[0] + t * b1 - b2
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::close;

    #[test]
    fn small_arguments_follow_their_limits() {
        // K(0) = (2/pi) int_0^1 ln(2 + s^2)/(1 + s^2) ds, 22 digits.
        close(squared_erf_tail(0.0), 0.4071249346343892376898, 3e-16);
        // E1(z) -> -gamma - ln z, also where z = x^2 underflows.
        let x: f64 = 1e-300;
        let expected = -0.5 * EULER_GAMMA - x.ln();
        close(half_e1_of_square(x), expected, 3e-16);
    }
}
