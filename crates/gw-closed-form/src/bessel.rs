//! Scaled modified Bessel functions of the orders that (A1) needs.
//!
//! `exp(-x) I_ν(x)` for ν = -1/4, 1/4, 3/4, 5/4 and `exp(x) K_ν(x)` for ν = 1/4, 3/4. Scaled,
//! because I overflows beyond x = 709, that is α = -53. Relative error below 2e-15 for
//! 1e-300 ≤ x (largest of 800 random arguments: 1.4e-15).
//!
//! # Source
//! NIST DLMF 10.25.2 (power series), 10.27.4 (K from I), 10.32.9 (integral of K), 10.40.1 and
//! 10.40.2 (large x).

use core::f64::consts::PI;

/// Order ν of I, and Γ(ν+1).
pub(crate) struct BesselOrder(f64, f64);

pub(crate) const MINUS_QUARTER: BesselOrder = BesselOrder(-0.25, GAMMA_3_4);
pub(crate) const QUARTER: BesselOrder = BesselOrder(0.25, GAMMA_5_4);
const MINUS_THREE_QUARTERS: BesselOrder = BesselOrder(-0.75, 4.0 * GAMMA_5_4);
pub(crate) const THREE_QUARTERS: BesselOrder = BesselOrder(0.75, 0.75 * GAMMA_3_4);
pub(crate) const FIVE_QUARTERS: BesselOrder = BesselOrder(1.25, 1.25 * GAMMA_5_4);

const GAMMA_5_4: f64 = 0.906_402_477_055_477_1;
const GAMMA_3_4: f64 = 1.225_416_702_465_177_6;
/// Where the expansions in 1/x reach rounding.
const LARGE: f64 = 20.0;

/// exp(-x) I_ν(x), x > 0.
pub(crate) fn i_scaled(BesselOrder(nu, gamma): BesselOrder, x: f64) -> f64 {
    if x >= LARGE {
        return large(nu, x, -1.0) / libm::sqrt(2.0 * PI * x);
    }
    // (x/2)^nu / Gamma(nu+1) sum (x^2/4)^k / (k! (nu+1)_k): all terms positive
    let q = 0.25 * x * x;
    let (mut term, mut sum) = (1.0, 1.0);
    for k in 1..60 {
        let k = f64::from(k);
        term *= q / (k * (k + nu));
        sum += term;
        if term < 1e-17 * sum {
            break;
        }
    }
    libm::pow(0.5 * x, nu) / gamma * sum * libm::exp(-x)
}

/// exp(x) K_{1/4}(x), x > 0.
pub(crate) fn k_quarter_scaled(x: f64) -> f64 {
    k_scaled([MINUS_QUARTER, QUARTER], x)
}

/// exp(x) K_{3/4}(x), x > 0.
pub(crate) fn k_three_quarters_scaled(x: f64) -> f64 {
    k_scaled([MINUS_THREE_QUARTERS, THREE_QUARTERS], x)
}

fn k_scaled([minus, plus]: [BesselOrder; 2], x: f64) -> f64 {
    let nu = plus.0;
    if x < 0.1 {
        // K = (pi/2) (I_{-nu} - I_nu) / sin(nu pi); sin(pi/4) = sin(3 pi/4)
        let difference = i_scaled(minus, x) - i_scaled(plus, x);
        0.5 * PI * core::f64::consts::SQRT_2 * difference * libm::exp(2.0 * x)
    } else if x < LARGE {
        // int_0^inf exp(-x (cosh t - 1)) cosh(nu t) dt: the trapezoid rule converges like
        // exp(-2 pi / step) here; step 1/8 is far below rounding.
        let step = 0.125;
        let mut sum = 0.5;
        for k in 1..80 {
            let t = f64::from(k) * step;
            let s = libm::sinh(0.5 * t);
            let decay = 2.0 * x * s * s; // x (cosh t - 1)
            if decay > 50.0 {
                break;
            }
            sum += libm::exp(-decay) * libm::cosh(nu * t);
        }
        step * sum
    } else {
        libm::sqrt(0.5 * PI / x) * large(nu, x, 1.0)
    }
}

/// sum_k (±1)^k (4 nu^2 - 1)(4 nu^2 - 9).../(k! (8x)^k).
fn large(nu: f64, x: f64, sign: f64) -> f64 {
    let (mut term, mut sum) = (1.0, 1.0);
    for k in 1..40 {
        let odd = f64::from(2 * k - 1);
        term *= sign * (4.0 * nu * nu - odd * odd) / (f64::from(8 * k) * x);
        sum += term;
        if term.abs() < 1e-17 {
            break;
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 20-digit values (mpmath): both sides of every switch.
    #[test]
    fn both_sides_of_every_switch() {
        for (found, exact) in [
            (i_scaled(MINUS_QUARTER, 1e-8), 97.045119486156457498),
            (i_scaled(QUARTER, 0.7), 0.46383056468778481573),
            (i_scaled(THREE_QUARTERS, 19.9), 0.088712224703513471232),
            (i_scaled(FIVE_QUARTERS, 20.1), 0.086052881726164876987),
            (i_scaled(MINUS_QUARTER, 700.0), 0.015080621912806277135),
            (k_quarter_scaled(1e-8), 215.55944813944137126),
            (k_three_quarters_scaled(0.0999), 6.1896338408948883151),
            (k_quarter_scaled(0.1001), 2.9664942864756068987),
            (k_three_quarters_scaled(19.9), 0.28311410930587452787),
            (k_quarter_scaled(20.1), 0.2782814558950887876),
        ] {
            assert!((found / exact - 1.0_f64).abs() < 2e-15, "{found} instead of {exact}");
        }
    }
}
