//! The identities of the partial moments, each against a quadrature written here.

mod common;
use common::{Worst, relative_error};
use contact_types::{ContactModulus, SeparationModel, SpectralMoments};
use gw_closed_form::GreenwoodWilliamson;
use gw_closed_form::partial_moments::{Order, derivative, ln, scaled, value};
use std::f64::consts::{PI, TAU};

/// exp(α²/2) J_n(α) = (2π)^{-1/2} ∫_0^∞ u^n exp(-αu - u²/2) du, by the double-exponential rule
/// u = exp((π/2) sinh t); for α < 0 the factor exp(-α²/2) is taken inside.
fn quadrature(n: f64, alpha: f64) -> f64 {
    let step = 1.0 / 64.0;
    let lead = if alpha < 0.0 { 0.5 * alpha * alpha } else { 0.0 };
    let mut sum = 0.0;
    for k in -320..=320 {
        let t = f64::from(k) * step;
        let u = (0.5 * PI * t.sinh()).exp();
        if !(1e-150..=1e3).contains(&u) {
            continue;
        }
        let gaussian = (-alpha * u - 0.5 * u * u - lead).exp();
        sum += u.powf(n) * gaussian * u * 0.5 * PI * t.cosh() * step;
    }
    sum / TAU.sqrt()
}

const ALPHAS: [f64; 13] =
    [-9.3, -4.0, -1.7, -0.67, -0.1, 0.0, 0.3, 1.1, 2.9, 7.6, 8.4, 25.0, 400.0];

#[test]
fn definition() {
    let mut worst = Worst::of("J_n against quadrature");
    for order in Order::ALL {
        for alpha in ALPHAS {
            let direct = quadrature(order.exponent(), alpha);
            let ours = if alpha < 0.0 { value(order, alpha) } else { scaled(order, alpha) };
            worst.see(relative_error(ours, direct), || format!("{order:?} at {alpha}"));
        }
    }
    worst.at_most(2e-13); // the quadrature's exp(α²) rounding
}

/// dJ_n/dα = -n J_{n-1}: the integral on the right has its own quadrature, also for n - 1 = -1/2.
#[test]
fn derivative_is_the_moment_below() {
    let mut worst = Worst::of("derivative");
    for order in [Order::Half, Order::One, Order::ThreeHalves, Order::FiveHalves] {
        for alpha in ALPHAS.into_iter().filter(|a| *a < 30.0) {
            let n = order.exponent();
            let decay = if alpha < 0.0 { 1.0 } else { (-0.5 * alpha * alpha).exp() };
            let direct = -n * quadrature(n - 1.0, alpha) * decay;
            worst.see(relative_error(derivative(order, alpha), direct), || {
                format!("{order:?} {alpha}")
            });
        }
    }
    worst.at_most(2e-13);
}

/// J_{n+1} + α J_n = n J_{n-1} at n = 1 and n = 3/2, with what no table has from quadrature.
#[test]
fn recurrence() {
    for alpha in [-6.0f64, -1.0, 0.4, 3.0, 12.0] {
        let decay = if alpha < 0.0 { 1.0 } else { (-0.5 * alpha * alpha).exp() };
        let direct = |n: f64| quadrature(n, alpha) * decay;
        for (low, n, above) in
            [(Order::Zero, 1.0, direct(2.0)), (Order::Half, 1.5, value(Order::FiveHalves, alpha))]
        {
            let (left, right) = (above + alpha * direct(n), n * value(low, alpha));
            let scale = above.abs().max((alpha * direct(n)).abs());
            assert!((left - right).abs() < 3e-13 * scale, "{n} at {alpha}: {left} {right}");
        }
    }
}

/// The elastic energy ∫_α^∞ J_3/2 = (2/5) J_5/2: Hertz energy is (2/5) load times overlap.
#[test]
fn energy_is_two_fifths_of_the_next_moment() {
    for alpha in [-3.0, 0.0, 1.3, 6.0] {
        // Panels of Gauss-Legendre with 5 nodes.
        let (x, w) = (
            [0.0, 0.538_469_310_105_683_1, 0.906_179_845_938_664],
            [0.568_888_888_888_888_9, 0.478_628_670_499_366_47, 0.236_926_885_056_189_08],
        );
        let step = 0.05;
        let mut energy = 0.0;
        for panel in 0..400 {
            let mid = alpha + (f64::from(panel) + 0.5) * step;
            let at = |s: f64| value(Order::ThreeHalves, mid + 0.5 * step * s);
            energy += 0.5
                * step
                * (w[0] * at(0.0) + w[1] * (at(x[1]) + at(-x[1])) + w[2] * (at(x[2]) + at(-x[2])));
        }
        assert!(relative_error(0.4 * value(Order::FiveHalves, alpha), energy) < 1e-12);
    }
}

/// J_n(0) = 2^{(n-1)/2} Γ((n+1)/2) / √(2π).
#[test]
fn value_at_zero() {
    let gamma =
        [PI.sqrt(), 1.225_416_702_465_177_6, 1.0, 0.906_402_477_055_477_1, 0.919_062_526_848_883];
    for (order, gamma) in Order::ALL.into_iter().zip(gamma) {
        let exact = 2f64.powf(0.5 * (order.exponent() - 1.0)) * gamma / TAU.sqrt();
        assert!(relative_error(value(order, 0.0), exact) < 4e-16, "{order:?}");
    }
}

/// J_0(-x) = 1 - J_0(x), J_1(-x) = x + J_1(x).
#[test]
fn reflection() {
    for x in [1e-8, 0.3, 2.0, 9.9, 10.1, 30.0] {
        assert!(relative_error(value(Order::Zero, -x), 1.0 - value(Order::Zero, x)) < 3e-16);
        assert!(relative_error(value(Order::One, -x), x + value(Order::One, x)) < 3e-16);
    }
}

/// ln J_n against the series in 1/α² at large α: J_n -> Γ(n+1) φ(α) α^{-n-1} (1 - ...).
#[test]
fn far_limit() {
    for (order, gamma) in
        [(Order::Zero, 1.0), (Order::One, 1.0), (Order::ThreeHalves, 1.329_340_388_179_137)]
    {
        for alpha in [1e4, 1e9, 1e150] {
            let n = order.exponent();
            let limit = f64::ln(gamma)
                - 0.5 * TAU.ln()
                - (n + 1.0) * f64::ln(alpha)
                - 0.5 * (n + 1.0) * (n + 2.0) / (alpha * alpha)
                - 0.5 * alpha * alpha;
            assert!(relative_error(ln(order, alpha), limit) < 4e-16);
        }
    }
}

/// Stiffness and contact number are minus the derivatives of pressure and area.
#[test]
fn stiffness_is_the_slope_of_pressure() {
    let moments = SpectralMoments { m0: 1e-13, m2: 4e-3, m4: 4e8 };
    let modulus = ContactModulus::from_pascals(80e9).unwrap();
    let model = GreenwoodWilliamson::from_moments(moments, modulus).unwrap();
    let sigma = moments.rms_height();
    let asperities = model.asperities();
    for h in [-1.0, 0.5, 2.0, 4.0] {
        let (d, e) = (h * sigma, 1e-4 * sigma);
        let at = |d: f64| model.at_separation(d).unwrap();
        let (below, above) = (at(d - e), at(d + e));
        let slope = (below.mean_pressure - above.mean_pressure) / (2.0 * e);
        assert!(relative_error(model.stiffness(d).unwrap(), slope) < 1e-6);
        let slope = (below.area_fraction - above.area_fraction) / (2.0 * e);
        let per_area = PI * asperities.radius;
        assert!(relative_error(per_area * model.contact_density(d).unwrap(), slope) < 1e-6);
    }
}
