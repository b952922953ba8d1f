//! Against 34-digit values, Greenwood's double integral, and the limit of light load.
#![allow(clippy::unwrap_used, reason = "tests: a panic is the report")]

#[path = "../../gw-closed-form/tests/common/mod.rs"]
mod common;
use asperity_models::{SummitLaw, SummitModel};
use common::{ReferenceRow, Worst, reference_rows, relative_error};
use contact_types::{ContactModel, ContactModulus, SeparationModel, SpectralMoments};
use std::f64::consts::{PI, TAU};

/// m0 = m2 = E* = 1, so that h is the separation and p the pressure.
fn model(law: SummitLaw, bandwidth: f64) -> SummitModel {
    let moments = SpectralMoments { m0: 1.0, m2: 1.0, m4: bandwidth };
    SummitModel::new(law, moments, ContactModulus::from_pascals(1.0).unwrap()).unwrap()
}

fn check(law: SummitLaw, row: &ReferenceRow, name: &str, worst: &mut [Worst; 4]) {
    let [bandwidth, h] = row.numbers(["bandwidth", "h"]);
    let model = model(law, bandwidth);
    let [area, pressure] =
        ["area", "pressure"].map(|quantity| row.number(&format!("{name}_{quantity}")));
    let place = || format!("bandwidth {bandwidth}, h = {h}");
    let state = model.at_separation(h).unwrap();
    worst[0].see(relative_error(state.area_fraction, area), place);
    worst[1].see(relative_error(state.mean_pressure, pressure), place);
    if pressure.is_normal() {
        let inverse = model.at_pressure(pressure).unwrap();
        worst[2].see((inverse.separation.unwrap() - h).abs() / h.abs().max(1.0), place);
        worst[3].see(relative_error(inverse.area_fraction, area), place);
    }
}

fn all_models(table: &str, limit: f64) {
    let names = ["area", "pressure", "separation back", "area back"];
    let laws =
        [(SummitLaw::BushGibsonThomas, "bgt"), (SummitLaw::GreenwoodElliptical, "geometric")];
    let mut worst =
        laws.map(|(_, model)| names.map(|name| Worst::of(format!("{table}, {model}, {name}"))));
    for row in reference_rows(table) {
        for ((law, model), worst) in laws.into_iter().zip(&mut worst) {
            check(law, &row, model, worst);
        }
    }
    for worst in worst.iter().flatten() {
        worst.at_most(limit);
    }
}

#[test]
fn ordinary_arguments() {
    all_models("summit_models_ordinary.csv", 2e-14);
}

/// Bandwidth 3/2 exactly to 1e8, -6 to 40 rms heights.
#[test]
fn wide_arguments() {
    all_models("summit_models.csv", 1e-14);
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

/// A_r E* h'_rms / F -> √(2π) for both laws as the load vanishes, from below, with a
/// distance that falls like 1/h².
#[test]
fn light_load_limit_is_root_two_pi() {
    let kappa = |law: SummitLaw, bandwidth: f64, h: f64| {
        let state = model(law, bandwidth).at_separation(h).unwrap();
        state.area_fraction * 2f64.sqrt() / state.mean_pressure
    };
    for bandwidth in [1.5, 1.6, 2.0, 5.0] {
        for law in [SummitLaw::BushGibsonThomas, SummitLaw::GreenwoodElliptical] {
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
