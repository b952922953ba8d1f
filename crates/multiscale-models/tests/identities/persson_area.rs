//! Persson's area.

use crate::close;
use crate::pascals;
use contact_types::{ContactModel, SpectralMoments};
use libm::erf;
use multiscale_models::{AreaLaw, Persson};
use std::f64::consts::PI;

/// The reduced diffusion as the differential equation it is, integrated from the full-contact
/// end, where `V_eff = V`, with Runge's fourth-order rule in ln V.
#[test]
fn reduced_diffusion_solves_its_equation() {
    let gamma = 0.45;
    let model = Persson::from_moments(SpectralMoments { m0: 1.0, m2: 1.0, m4: 1.0 }, pascals(1.0))
        .unwrap()
        .with_gamma(gamma)
        .unwrap()
        .with_area_law(AreaLaw::ReducedDiffusion);
    let rate = |ln_v: f64, v_eff: f64| {
        let area = erf((2.0 * v_eff).powf(-0.5)); // p = 1
        ln_v.exp() * (gamma + (1.0 - gamma) * area * area)
    };
    let (start, steps) = ((0.5 / 36.0_f64).ln(), 20_000);
    for x in [1.0, 0.1, 0.01] {
        let end = (0.5 / f64::powi(x, 2)).ln();
        let h = (end - start) / f64::from(steps);
        let (mut t, mut v) = (start, start.exp());
        for _ in 0..steps {
            let k1 = rate(t, v);
            let k2 = rate(t + 0.5 * h, v + 0.5 * h * k1);
            let k3 = rate(t + 0.5 * h, v + 0.5 * h * k2);
            let k4 = rate(t + h, v + h * k3);
            v += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
            t += h;
        }
        // p/(E* sqrt m2) = x with E* = m2 = 1.
        let area = model.at_pressure(x).unwrap().area_fraction;
        close(area, erf((2.0 * v).powf(-0.5)), 1e-11);
    }
    // A -> 2/sqrt(pi gamma) x at light load.
    let light = model.at_pressure(1e-9).unwrap().area_fraction;
    close(light, 2e-9 / (gamma * PI).sqrt(), 1e-6);
    let plain = model.clone().with_gamma(1.0).unwrap();
    close(plain.at_pressure(0.3).unwrap().area_fraction, erf(0.3), 1e-15);
}
