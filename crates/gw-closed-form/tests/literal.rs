//! (A1) and (A2) as the paper's appendix writes them, against the partial moments used in their place.
//!
//! In both branches of (A1) the root covers `a` alone: `√a · exp(-θ)`, not `√(a exp(-θ))`.

mod common;

use std::f64::consts::{FRAC_PI_2, PI};

/// `exp(x) K_ν(x)`: the trapezoid rule for `int_0^inf exp(-x (cosh t - 1)) cosh(nu t) dt` (DLMF 10.32.9).
fn k_scaled(nu: f64, x: f64) -> f64 {
    let step = 0.125 / (1.0 + x.sqrt());
    let term = |k: i32| {
        let t = f64::from(k) * step;
        (-2.0 * x * (0.5 * t).sinh().powi(2)).exp() * (nu * t).cosh()
    };
    // The smallest first: the largest would round them away.
    step * ((1..2000).rev().map(term).sum::<f64>() + 0.5)
}

/// `exp(-x) I_ν(x)` by its power series (DLMF 10.25.2), with Γ(ν+1).
fn i_scaled([nu, gamma]: [f64; 2], x: f64) -> f64 {
    let (mut term, mut sum) = (1.0, 1.0);
    for k in (1..80).map(f64::from) {
        term *= 0.25 * x * x / (k * (k + nu));
        sum += term;
    }
    (0.5 * x).powf(nu) / gamma * sum * (-x).exp()
}

/// I_ep for σ_s = 1 by (A1), with θ = α²/4:
///
/// ```math
/// I_{ep} = \frac{\sqrt\alpha\, e^{-\theta}}{4\sqrt\pi}
///   \left[(1+\alpha^2) K_{1/4}(\theta) - \alpha^2 K_{3/4}(\theta)\right], \qquad \alpha > 0
/// ```
/// ```math
/// I_{ep} = \frac{\sqrt{-\alpha}\, e^{-\theta}}{4} \sqrt{\frac\pi2}
///   \left[(1+\alpha^2) I_{-1/4} + (3+\alpha^2) I_{1/4} + \alpha^2 (I_{3/4} + I_{5/4})\right],
///   \qquad \alpha < 0
/// ```
pub(crate) fn load_a1(alpha: f64) -> f64 {
    let square = alpha * alpha;
    let theta = 0.25 * square;
    if alpha > 0.0 {
        let bracket = (1.0 + square) * k_scaled(0.25, theta) - square * k_scaled(0.75, theta);
        return alpha.sqrt() * (-2.0 * theta).exp() * bracket / (4.0 * PI.sqrt());
    }
    let (gamma_3_4, gamma_5_4) = (1.225_416_702_465_177_6, 0.906_402_477_055_477_1);
    let [minus, one, three, five] =
        [[-0.25, gamma_3_4], [0.25, gamma_5_4], [0.75, 0.75 * gamma_3_4], [1.25, 1.25 * gamma_5_4]]
            .map(|order| i_scaled(order, theta));
    let bracket = (1.0 + square) * minus + (3.0 + square) * one + square * (three + five);
    0.25 * (-alpha).sqrt() * FRAC_PI_2.sqrt() * bracket
}

/// The brackets subtract nearly equal numbers and lose digits like α⁴, at α > 0.
#[test]
fn the_printed_formulas_are_the_partial_moments() {
    use common::{Worst, relative_error};
    use gw_closed_form::partial_moments::{Order, value};
    for [low, high, of_a1, of_a2] in [
        [-8.0, 0.0, 8e-16, 4e-16],
        [0.0, 1.0, 8e-15, 1e-15],
        [1.0, 4.0, 3e-13, 7e-14],
        [4.0, 8.0, 2.5e-12, 9e-13],
        [8.0, 20.0, 1e-10, 4e-11],
        [20.0, 37.0, 1e-9, 4e-10],
    ] {
        let [mut a1, mut a2] =
            ["A1", "A2"].map(|name| Worst::of(format!("({name}) on {low} to {high}")));
        for k in 1..400 {
            let alpha = low + (high - low) * f64::from(k) / 400.0;
            let place = || format!("{alpha}");
            a1.see(relative_error(load_a1(alpha), value(Order::ThreeHalves, alpha)), place);
            // (A2): φ(α) - α/2 erfc(α/√2)
            let density = (-0.5 * alpha * alpha).exp() / (2.0 * PI).sqrt();
            let printed = density - 0.5 * alpha * libm::erfc(alpha / 2f64.sqrt());
            a2.see(relative_error(printed, value(Order::One, alpha)), place);
        }
        a1.at_most(of_a1);
        a2.at_most(of_a2);
    }
}
