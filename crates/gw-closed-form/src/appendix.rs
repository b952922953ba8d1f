//! (A1) and (A2) as the paper's appendix writes them, term by term.
//!
//! Kept for the reader who holds the paper beside the code, and to show what the formula costs:
//! its bracket subtracts nearly equal numbers. Measured relative error against 50 digits,
//! largest in each interval of α = a/σ_s (`tests/literal.rs` prints and checks it):
//!
//! | α | (A1) | (A2) |
//! |---|---|---|
//! | -1000 to 0 | 8e-16 | 4e-16 |
//! | 0 to 0.5 | 2e-15 | 6e-16 |
//! | 0.5 to 1 | 8e-15 | 1e-15 |
//! | 1 to 2 | 4e-14 | 6e-15 |
//! | 2 to 4 | 3e-13 | 7e-14 |
//! | 4 to 8 | 2.5e-12 | 9e-13 |
//! | 8 to 20 | 1e-10 | 4e-11 |
//! | 20 to 37 | 1e-9 | 4e-10 |
//!
//! [`integrals`](crate::integrals) gives the same two numbers to 5e-16 everywhere, faster.
//!
//! # Where the extracted text of the paper is damaged
//! In both branches of (A1) the root must cover `a` alone: `√a · exp(-θ)`, not `√(a exp(-θ))`;
//! the other reading is wrong by exp(θ/2), a factor 3.08 at α = 3.
//!
//! # Source
//! Jackson & Green, IJTC2009-15106, appendix, eqs. (A1) and (A2).

use crate::arithmetic::clamp_to_finite;
use crate::bessel::{self, i_scaled};
use crate::partial_moments::FRAC_1_SQRT_2PI;
use core::f64::consts::{FRAC_PI_2, PI, SQRT_2};

/// I_ep by (A1), with θ = α²/4 and exponentially scaled Bessel functions:
///
/// ```math
/// I_{ep} = \frac{\sigma_s \sqrt a\, e^{-\theta}}{4\sqrt\pi}
///   \left[(1+\alpha^2) K_{1/4}(\theta) - \alpha^2 K_{3/4}(\theta)\right], \qquad a > 0
/// ```
/// ```math
/// I_{ep} = \frac{\sigma_s \sqrt{-a}\, e^{-\theta}}{4} \sqrt{\frac\pi2}
///   \left[(1+\alpha^2) I_{-1/4} + (3+\alpha^2) I_{1/4} + \alpha^2 (I_{3/4} + I_{5/4})\right],
///   \qquad a < 0
/// ```
///
/// `height_std` > 0. The loss of digits is in the table of the [module](self).
pub fn load_a1(a: f64, height_std: f64) -> f64 {
    let alpha = a / height_std;
    let square = alpha * alpha;
    let theta = 0.25 * square;
    if theta < f64::MIN_POSITIVE {
        // a = 0: Gamma(5/4) sigma_s^(3/2) / (2^(1/4) sqrt(pi))
        return clamp_to_finite(0.430_019_993_662_259_77 * height_std * libm::sqrt(height_std));
    }
    if alpha > 39.0 {
        return 0.0; // exp(-alpha^2/2) is below the smallest double
    }
    let load = if alpha > 0.0 {
        // exp(-theta) K(theta) = exp(-2 theta) exp(theta) K(theta)
        let bracket = (1.0 + square) * bessel::k_quarter_scaled(theta)
            - square * bessel::k_three_quarters_scaled(theta);
        height_std * libm::sqrt(a) * libm::exp(-2.0 * theta) * bracket / (4.0 * libm::sqrt(PI))
    } else {
        let upper =
            i_scaled(bessel::THREE_QUARTERS, theta) + i_scaled(bessel::FIVE_QUARTERS, theta);
        let bracket = (1.0 + square) * i_scaled(bessel::MINUS_QUARTER, theta)
            + (3.0 + square) * i_scaled(bessel::QUARTER, theta)
            + square * upper;
        0.25 * height_std * libm::sqrt(-a) * libm::sqrt(FRAC_PI_2) * bracket
    };
    if load.is_nan() { f64::MAX } else { clamp_to_finite(load) } // alpha^2 overflowed
}

/// I_ea by (A2):
///
/// ```math
/// I_{ea} = \frac{\sigma_s}{\sqrt{2\pi}}\, e^{-\alpha^2/2}
///        - \frac a2\, \operatorname{erfc}\!\left(\frac{\alpha}{\sqrt2}\right)
/// ```
///
/// `height_std` > 0. The loss of digits is in the table of the [module](self).
pub fn area_a2(a: f64, height_std: f64) -> f64 {
    let alpha = a / height_std;
    FRAC_1_SQRT_2PI * height_std * libm::exp(-0.5 * alpha * alpha)
        - 0.5 * a * libm::erfc(alpha / SQRT_2)
}
