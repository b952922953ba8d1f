//! What is left of each model when the load goes to zero, and where the deterministic slope lies
//! between them.

use contact_compare::{Inputs, find};
use contact_types::Grid;
use contact_types::{ContactModulus, SpectralMoments};
use fft_bem_solver::{Load, PERIMETER_CORRECTION, Solver};
use std::f64::consts::{PI, TAU};
use surface_stats::spectrum::{PowerSpectrum, Window};
use surface_stats::synthesis::{Scale, SelfAffine};

/// `A E* g / p` of a model at nominal pressure `p`, with `g` the rms gradient.
fn slope(model: &str, bandwidth: f64, load: f64) -> f64 {
    let (m0, m2, e_star) = (1e-14, 1e-3, 1e11);
    let moments = SpectralMoments { m0, m2, m4: bandwidth * m2 * m2 / m0 };
    let modulus = ContactModulus::from_pascals(e_star).unwrap();
    let inputs = Inputs { moments: Some(moments), ..Inputs::new(modulus) };
    let pressure = load * e_star * moments.rms_gradient();
    let model = find(model).unwrap().build(&inputs).unwrap();
    model.at_pressure(pressure).unwrap().area_fraction / load
}

/// Persson: sqrt(8/pi), reached at once.
#[test]
fn persson_starts_at_root_eight_over_pi() {
    let limit = (8.0 / PI).sqrt();
    assert!((slope("persson", 2.0, 1e-6) / limit - 1.0).abs() < 1e-9);
}

/// Bush–Gibson–Thomas and the elliptical model: sqrt(2 pi), from below and slowly. At αN = 2 the
/// distance to the limit falls as 1/h² with the separation h, that is as 1/ln(1/p).
#[test]
fn summit_models_approach_root_two_pi() {
    for model in ["bgt", "greenwood-elliptical"] {
        let short = |load: f64| 1.0 - slope(model, 2.0, load) / TAU.sqrt();
        let (a, b, c) = (short(1e-4), short(1e-20), short(1e-80));
        assert!(a > b && b > c && c > 0.0, "{model}: {a} {b} {c}");
        assert!(a < 0.06 && c < 2e-3, "{model}: {a} {c}");
        // 1/ln law between the two light loads, with a factor 1.5 of room.
        let ratio = b / c / (80.0 / 20.0);
        assert!((1.0 / 1.5..1.5).contains(&ratio), "{model}: {ratio}");
    }
}

/// One small map: longest wave 8 times the shortest, H = 0.5,
/// 256 x 256 points. Slope of 0.8 to 3.5 % of area within the 2.0 to 2.3 of the literature (Hyun
/// et al. 2004; Campana & Muser 2007; Putignano et al. 2012; Yastrebov et al. 2017), above
/// Persson's and below the limit of the summit models by more than its own grid error.
#[test]
fn deterministic_slope_is_the_published_one() {
    let grid = Grid::new([256; 2], [1e-6; 2]).unwrap();
    let map = SelfAffine {
        grid,
        hurst: 0.5,
        rolloff: 64e-6,
        cutoff: 8e-6,
        scale: Scale::RmsGradient(0.1),
        seed: 1,
        quantise: None,
    }
    .generate()
    .unwrap();
    let moments = PowerSpectrum::of(&map, Window::None).unwrap().moments();
    assert!((5.0..9.0).contains(&moments.bandwidth()), "{}", moments.bandwidth());
    let modulus = ContactModulus::from_pascals(1e11).unwrap();
    let mut solver = Solver::builder().tolerance(1e-5).build(grid, modulus).unwrap();
    let (mut slopes, mut bars) = (Vec::new(), Vec::new());
    for load in [0.004, 0.0063, 0.01, 0.016] {
        let solution = solver.solve(&map, Load::MeanPressure(load * 1e10)).unwrap();
        let found = &solution.diagnostics;
        slopes.push(solution.state.area_fraction / load);
        bars.push(0.3 * PERIMETER_CORRECTION * found.contact_perimeter / load);
    }
    let mean = |v: &[f64]| v.iter().sum::<f64>() / v.len() as f64;
    let (kappa, bar) = (mean(&slopes), mean(&bars));
    assert!((2.0..=2.3).contains(&kappa), "{kappa} ± {bar}");
    assert!(bar < 0.1 && kappa - bar > (8.0 / PI).sqrt() && kappa + bar < TAU.sqrt());
}
