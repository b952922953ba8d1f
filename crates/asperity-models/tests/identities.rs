//! The kernels against the ellipse they average, and the limits of the theory.
#![allow(clippy::unwrap_used, reason = "tests: a panic is the report")]

use asperity_models::{SummitLaw, SummitModel};
use contact_types::{ContactModulus, SeparationModel, SpectralMoments};
use std::f64::consts::{PI, TAU};

fn model(law: SummitLaw, bandwidth: f64) -> SummitModel {
    let moments = SpectralMoments { m0: 1.0, m2: 1.0, m4: bandwidth };
    SummitModel::new(law, moments, ContactModulus::from_pascals(1.0).unwrap()).unwrap()
}

/// Complete elliptic integrals K, E and K - E of parameter 1 - k², by the arithmetic-geometric
/// mean; K - E from its own sum, without subtraction.
fn complete_elliptic(k: f64) -> (f64, f64, f64) {
    let (mut a, mut b) = (1.0f64, k);
    let mut sum = 0.5 * (1.0 - k) * (1.0 + k);
    let mut power = 0.5;
    for _ in 0..12 {
        let c = 0.5 * (a - b);
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
        power *= 2.0;
        sum += power * c * c;
    }
    let first = PI / (2.0 * a);
    (first, first * (1.0 - sum), first * sum)
}

/// Average over all summits of one summit's contact: three nested sums over height, mean
/// curvature and ellipse, nothing of the crate's kernels or partial moments. Area and load.
fn brute_force(bandwidth: f64, h: f64) -> [f64; 2] {
    let rho = (1.5 / bandwidth).sqrt();
    let s = (1.0 - rho * rho).sqrt();
    // The ellipse: midpoint rule in w, k = w² (3 - 2w), so that both ends are flat.
    let mut ellipses = Vec::new();
    let n = 400;
    for i in 0..n {
        let w = (f64::from(i) + 0.5) / f64::from(n);
        let ratio = |w: f64| {
            let k = w * w * (3.0 - 2.0 * w);
            let (first, second, difference) = complete_elliptic(k);
            // curvature ratio κ₂/κ₁ = k² (K - E) / (E - k² K)
            (k, first, second, k * k * difference / (second - k * k * first))
        };
        let (k, first, second, q) = ratio(w);
        let (lower, upper) = (ratio(w - 0.5 / f64::from(n)), ratio(w + 0.5 / f64::from(n)));
        let u = |q: f64| (1.0 - q) / (1.0 + q);
        let edge = |r: (f64, f64, f64, f64), end: f64| if r.3.is_finite() { u(r.3) } else { end };
        let du = edge(lower, 1.0) - edge(upper, 0.0);
        let at = u(q);
        let area = second / (first * k);
        let load = second.sqrt() / (first.powf(1.5) * k);
        ellipses.push((at, du * at * (1.0 - at * at), area, load));
    }
    let mut total = [0.0; 2];
    let dt = 0.02;
    for i in 0..500 {
        let t = (f64::from(i) + 0.5) * dt;
        let density = (-0.5 * t * t).exp() / TAU.sqrt();
        let mut kernel = [0.0; 2];
        for &(u, weight, area, load) in &ellipses {
            let e = weight * (-t * t * u * u).exp();
            kernel[0] += e * area;
            kernel[1] += e * load;
        }
        let mut overlap = [0.0; 2];
        let dy = 0.02;
        for j in 0..900 {
            // y = √(ξ - h): the half powers become smooth
            let y = (f64::from(j) + 0.5) * dy * 0.25;
            let xi = h + y * y;
            let gaussian = (-0.5 * ((xi - rho * t) / s).powi(2)).exp() / (TAU.sqrt() * s);
            overlap[0] += 2.0 * y * y * y * gaussian * dy * 0.25;
            overlap[1] += 2.0 * y * y.powi(3) * gaussian * dy * 0.25;
        }
        total[0] += 4.0 * t.powi(3) * density * kernel[0] * overlap[0] * dt;
        total[1] += 4.0 * t.powf(3.5) * density * kernel[1] * overlap[1] * dt;
    }
    let load_scale = 1.5f64.powf(0.25) / 9.0 * bandwidth.powf(0.75);
    [(bandwidth / 24.0).sqrt() * total[0], load_scale * total[1]]
}

#[test]
fn bush_gibson_thomas_is_the_average_over_all_ellipses() {
    for (bandwidth, h) in [(2.0, 0.0), (5.0, 1.0), (20.0, 0.5), (3.0, 2.5)] {
        let [area, load] = brute_force(bandwidth, h);
        let state = model(SummitLaw::BushGibsonThomas, bandwidth).at_separation(h).unwrap();
        // Midpoint sums: second order in their steps, measured below 3e-6.
        assert!((state.area_fraction / area - 1.0).abs() < 5e-6, "{bandwidth} {h}: {area}");
        assert!((state.mean_pressure / load - 1.0).abs() < 5e-6, "{bandwidth} {h}: {load}");
    }
}

/// Greenwood's own form: a double integral over height and geometric mean curvature g = κ_g/√m4.
#[test]
fn greenwood_elliptical_is_his_two_dimensional_integral() {
    let (bandwidth, h) = (2.0f64, 1.0f64);
    // p(ξ, g) = 9/(2√(2π)) √(α/(α-1)) g³ exp(3g²/2 - αξ²/(2(α-1))) erfc(B)
    let erfc = |x: f64| {
        2.0 * gw_closed_form::partial_moments::value(
            gw_closed_form::partial_moments::Order::Zero,
            x * 2f64.sqrt(),
        )
    };
    let (dg, dy) = (0.01, 0.01);
    let (mut area, mut load) = (0.0, 0.0);
    for i in 0..900 {
        let g = (f64::from(i) + 0.5) * dg;
        for j in 0..300 {
            let y = (f64::from(j) + 0.5) * dy;
            let xi = h + y * y;
            let b = (3.0 * g * (bandwidth - 1.0) - bandwidth.sqrt() * xi)
                / (2.0 * (2.0 * bandwidth - 3.0) * (bandwidth - 1.0)).sqrt();
            let exponent = 1.5 * g * g - bandwidth * xi * xi / (2.0 * (bandwidth - 1.0));
            let tail = erfc(b);
            if tail <= 0.0 {
                continue;
            }
            let density = 9.0 / (2.0 * TAU.sqrt())
                * (bandwidth / (bandwidth - 1.0)).sqrt()
                * g.powi(3)
                * (exponent + tail.ln()).exp();
            area += density * y * y / g * 2.0 * y * dg * dy;
            load += density * y.powi(3) / g.sqrt() * 2.0 * y * dg * dy;
        }
    }
    area *= bandwidth.sqrt() / (6.0 * 3f64.sqrt());
    load *= 4.0 / 3.0 * bandwidth.powf(0.75) / (6.0 * PI * 3f64.sqrt());
    let state = model(SummitLaw::GreenwoodElliptical, bandwidth).at_separation(h).unwrap();
    assert!((state.area_fraction / area - 1.0).abs() < 1e-9, "{area} {}", state.area_fraction);
    assert!((state.mean_pressure / load - 1.0).abs() < 1e-9, "{load} {}", state.mean_pressure);
}

/// A_r E* h'_rms / F -> √(2π) for all three laws as the load vanishes, from below, with a
/// distance that falls like 1/h².
#[test]
fn light_load_limit_is_root_two_pi() {
    let kappa = |law: SummitLaw, bandwidth: f64, h: f64| {
        let state = model(law, bandwidth).at_separation(h).unwrap();
        state.area_fraction * 2f64.sqrt() / state.mean_pressure
    };
    let laws =
        [SummitLaw::BushGibsonThomas, SummitLaw::GreenwoodElliptical, SummitLaw::MeanCurvature];
    for bandwidth in [1.5, 1.6, 2.0, 5.0] {
        for law in laws {
            let [near, far] = [18.0, 36.0].map(|h| TAU.sqrt() - kappa(law, bandwidth, h));
            assert!(near > 0.0 && far > 0.0 && far < 0.01, "{bandwidth}: {near} {far}");
            assert!((near / far - 4.0).abs() < 0.35, "{bandwidth}: order {}", near / far);
        }
    }
    // Published: the linear law is far away at practical separations.
    for (bandwidth, expected) in
        [(1.6, 2.488), (2.0, 2.484), (5.0, 2.440), (20.0, 2.180), (100.0, 1.670)]
    {
        let kappa = kappa(SummitLaw::BushGibsonThomas, bandwidth, 6.0);
        assert!((kappa - expected).abs() < 6e-4, "{bandwidth}: {kappa}");
    }
}
