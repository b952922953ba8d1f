//! Persson's mean gap: of shells, and at light load.

use crate::quadrature::geometric_integral;
use crate::{close, pascals};
use contact_types::{ContactModel, RoughnessSpectrum, Shell};
use libm::erfc;
use multiscale_models::{Persson, SelfAffineSpectrum};
use std::f64::consts::PI;

fn gap(model: &Persson, pressure: f64) -> f64 {
    let state = model.at_pressure(pressure).expect("an answer");
    state.mean_gap.expect("a spectrum has a gap")
}

/// On a shell q is constant, and for gamma = 1 the integral over it is elementary:
/// `int_0^r E1(P^2/s^2)/2 ds = r [E1(x^2)/2 - e^{-x^2} + x sqrt(pi) erfc x]`, x = P/r.
#[test]
fn shells_have_their_closed_forms() {
    let shells: Vec<_> = (1..40)
        .map(f64::from)
        .map(|i| Shell {
            wavenumber: 1e4 * i,
            variance: 1e-14 * (0.5 + (7.0 * i).sin().powi(2)) / i,
        })
        .collect();
    let e = 3e9;
    let spectrum = RoughnessSpectrum::new(shells.clone()).unwrap();
    let model = Persson::from_spectrum(&spectrum, pascals(e)).unwrap().with_gamma(1.0).unwrap();
    for load in [1e-8, 1e-3, 0.1, 0.9] {
        let x_all = load * spectrum.moments().m2.sqrt();
        let (mut m2, mut below, mut sum) = (0.0, 0.0, 0.0);
        for shell in &shells {
            m2 += 0.5 * shell.variance * shell.wavenumber.powi(2);
            let (r, x) = (m2.sqrt(), x_all / m2.sqrt());
            let half_e1 = geometric_integral(x, x + 9.0, 4.0, |y| (-y * y).exp() / y);
            let above = r * (half_e1 - (-x * x).exp() + x * PI.sqrt() * erfc(x));
            sum += (above - below) / shell.wavenumber;
            below = above;
        }
        close(gap(&model, x_all * e), 2.0 / PI.sqrt() * sum, 1e-12);
    }
}

/// `u = u0 ln(b E*/p)` at light load: a decade of load is always the same gap.
/// `u0 = sqrt(pi) int q^2 C w dq` of this spectrum, a number found independently.
#[test]
fn the_gap_is_a_logarithm_at_light_load() {
    let spectrum = SelfAffineSpectrum::from_wavenumbers(0.8, [1.0, 1.0, 100.0], 1.0).unwrap();
    for gamma in [1.0, 0.45] {
        let model = Persson::from_self_affine(spectrum, pascals(3.0)).with_gamma(gamma).unwrap();
        let first = gap(&model, 1e-12);
        for decades in [88, 294] {
            let rise = gamma * 1.05357529 * f64::from(decades) * 10f64.ln();
            close(gap(&model, 10f64.powi(-12 - decades)) - first, rise, 1e-8);
        }
    }
}
