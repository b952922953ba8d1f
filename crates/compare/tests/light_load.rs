//! Theory against theory: what is left of each model when the load goes to zero.

#![allow(clippy::unwrap_used, reason = "a check that cannot be made has failed")]

use compare::models::{Inputs, find};
use contact_types::{ContactModulus, SpectralMoments};
use std::f64::consts::{PI, TAU};

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
