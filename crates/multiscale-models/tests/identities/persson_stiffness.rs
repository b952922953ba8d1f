//! Persson's stiffness, stored energy and light load: what follows from the gap.

use crate::persson;
use crate::quadrature::geometric_integral;
use crate::spectrum::Definition;
use approx::assert_relative_eq;
use multiscale_models::{Persson, SelfAffineSpectrum};
use std::f64::consts::PI;

#[test]
fn energy_balances_the_work_of_the_load() {
    let spectrum = SelfAffineSpectrum::from_wavenumbers(0.8, [1e4, 3e4, 1e6], 1e-13).unwrap();
    let e = 7e10;
    let scale = e * spectrum.moments().m2.sqrt();
    for gamma in [1.0, 0.45] {
        let model = persson(spectrum, e, gamma);
        for x in [0.05, 0.6, 2.5] {
            let p = x * scale;
            // int_0^p u dp' with dp' = p' d ln p'; u grows only as ln(1/p).
            let work = geometric_integral(1e-17 * p, p, 4.0, |p| model.mean_gap(p).unwrap());
            let stored = model.elastic_energy(p).unwrap() + p * model.mean_gap(p).unwrap();
            assert_relative_eq!(work, stored, max_relative = 1e-13);
        }
    }
}

#[test]
fn energy_of_full_contact() {
    // E*/4 int |q| C d^2q = (pi E*/2) int q^2 C dq
    let q = [1e4, 3e4, 1e6];
    let definition = Definition::new(0.8, q, 1e-13);
    let spectrum = SelfAffineSpectrum::from_wavenumbers(0.8, q, 1e-13).unwrap();
    let model = persson(spectrum, 7e10, Persson::GAMMA);
    let full = model.elastic_energy(1e3 * 7e10).unwrap();
    let expected = 0.5 * PI * 7e10 * definition.moment(2, q[2]);
    assert_relative_eq!(full, expected, max_relative = 1e-13);
}

#[test]
fn stiffness_is_the_slope_of_the_gap() {
    let spectrum = SelfAffineSpectrum::from_wavenumbers(0.6, [1.0, 2.0, 200.0], 1.0).unwrap();
    let scale = spectrum.moments().m2.sqrt();
    for gamma in [1.0, 0.45] {
        let model = persson(spectrum, 1.0, gamma);
        for x in [1e-6, 0.02, 0.5, 2.0] {
            let p = x * scale;
            // Five-point difference in ln p: error of order h^4, rounding eps/h.
            let gap = |d: f64| model.mean_gap(p * d.exp()).unwrap();
            let h = 1e-3 / (1.0 + x * x);
            let slope = (gap(-2.0 * h) - 8.0 * gap(-h) + 8.0 * gap(h) - gap(2.0 * h)) / (12.0 * h);
            assert_relative_eq!(model.stiffness(p).unwrap(), -p / slope, max_relative = 2e-10);
        }
    }
}

#[test]
fn light_load_constants_are_the_limit() {
    let spectrum = SelfAffineSpectrum::from_wavenumbers(0.8, [1.0, 1.0, 100.0], 1.0).unwrap();
    for gamma in [1.0, 0.45] {
        let model = persson(spectrum, 3.0, gamma);
        let [u0, b] = model.light_load().unwrap();
        for p in [1e-12, 1e-100, 1e-306] {
            let limit = u0 * ((3.0 * b).ln() - f64::ln(p));
            assert_relative_eq!(model.mean_gap(p).unwrap(), limit, max_relative = 1e-12);
            assert_relative_eq!(model.stiffness(p).unwrap(), p / u0, max_relative = 1e-11);
        }
    }
    // u0 = sqrt(pi) int q^2 C w dq, a number found independently: MODELS table of the theory.
    let model = persson(spectrum, 1.0, 1.0);
    assert_relative_eq!(model.light_load().unwrap()[0], 1.05357529, max_relative = 1e-8);
}
