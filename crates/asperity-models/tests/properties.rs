//! Any finite input gives a finite answer or a typed error; area and load fall with separation.
#![allow(clippy::unwrap_used, reason = "tests: a panic is the report")]

use asperity_models::{SummitLaw, SummitModel};
use contact_types::{
    Caveat, ContactModel, ContactModulus, ModelError, SeparationModel, SpectralMoments,
};
use proptest::num::f64::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
use proptest::prelude::*;

fn any_finite() -> impl Strategy<Value = f64> {
    prop_oneof![POSITIVE | NEGATIVE | NORMAL | SUBNORMAL | ZERO, -50.0..50.0f64]
}

fn positive(low: f64, high: f64) -> impl Strategy<Value = f64> {
    prop_oneof![1 => POSITIVE | NORMAL, 3 => (low.ln()..high.ln()).prop_map(f64::exp)]
}

/// Bandwidths from 3/2 exactly through 3/2 (1 + 1e-16...) to 1e8 and beyond.
fn bandwidth() -> impl Strategy<Value = f64> {
    prop_oneof![
        Just(1.5),
        (-36.0..0.0f64).prop_map(|e| 1.5 * (1.0 + e.exp())),
        (0.5..20.0f64).prop_map(f64::exp),
        (20.0..700.0f64).prop_map(f64::exp),
    ]
}

fn models([m0, m2, m4]: [f64; 3], e: f64) -> [Result<SummitModel, ModelError>; 2] {
    let modulus = ContactModulus::from_pascals(e).unwrap();
    [SummitLaw::BushGibsonThomas, SummitLaw::GreenwoodElliptical]
        .map(|law| SummitModel::new(law, SpectralMoments { m0, m2, m4 }, modulus))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..Default::default() })]

    #[test]
    fn the_models_answer_or_say_why(
        m0 in positive(1e-18, 1e-6), m2 in positive(1e-6, 1.0), bandwidth in bandwidth(),
        modulus in positive(1e5, 1e12), separation in any_finite(), pressure in any_finite(), h in -8.0..45.0f64,
    ) {
        let m4 = bandwidth * m2 / m0 * m2;
        for model in models([m0, m2, m4], modulus).into_iter().flatten() {
            for answer in [
                model.at_separation(separation),
                model.at_separation(h * m0.sqrt()),
                model.at_pressure(pressure),
                model.at_pressure((1e-3 * pressure.abs()).min(1e3 * modulus)),
            ] {
                match answer {
                    Ok(state) => {
                        prop_assert!(state.mean_pressure.is_finite() && state.mean_pressure >= 0.0);
                        prop_assert!(state.area_fraction.is_finite() && state.area_fraction >= 0.0);
                        prop_assert!(state.separation.is_none_or(f64::is_finite));
                        let tiny = state.mean_pressure < f64::MIN_POSITIVE && state.separation.is_some();
                        let warned = matches!(state.caveat, Some(Caveat::Underflow { .. }));
                        prop_assert!(!tiny || warned);
                    }
                    Err(ModelError::InvalidInput { value, .. }) => prop_assert!(value < 0.0),
                    Err(error) => {
                        prop_assert!(matches!(error, ModelError::OutsideDomain { .. }), "{error}");
                    }
                }
            }
        }
    }

    /// Down to a change of 1e-13 of itself, or of 1e-13 rms heights; at any bandwidth and any load.
    #[test]
    fn area_and_load_fall_with_separation_and_pressure_leads_back(
        bandwidth in bandwidth(), h in -6.0..37.0f64, fraction in 1.0..100.0f64,
    ) {
        for model in models([1.0, 1.0, bandwidth], 1.0) {
            let model = model.unwrap();
            let near = model.at_separation(h).unwrap();
            let far = model.at_separation(h + 1e-13 * fraction * h.abs().max(1.0)).unwrap();
            prop_assert!(far.mean_pressure <= near.mean_pressure, "{bandwidth} {h}");
            prop_assert!(far.area_fraction <= near.area_fraction, "{bandwidth} {h}");
            if bandwidth < 1e100 {
                let back = model.at_pressure(near.mean_pressure).unwrap();
                prop_assert!((back.separation.unwrap() - h).abs() <= 1e-14 * h.abs().max(1.0));
                prop_assert!((back.area_fraction / near.area_fraction - 1.0).abs() < 2e-13);
            }
        }
    }
}

#[test]
fn refuses_a_bandwidth_below_three_halves_but_not_by_rounding() {
    let at = |bandwidth: f64| {
        let [model, ..] = models([1.0, 1.0, bandwidth], 1.0);
        model
    };
    let error = at(1.4999).err().unwrap();
    assert!(matches!(error, ModelError::OutsideDomain { value, .. } if value < 1.5), "{error}");
    assert!(error.to_string().contains("1.4999 is outside its domain, at least 1.5"), "{error}");
    assert!(at(1.5f64.next_down()).is_ok() && at(1.5).is_ok());
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(at(bad).err().unwrap(), ModelError::InvalidInput { .. }), "{bad}");
    }
}

#[test]
fn caveats_and_refusals() {
    for model in models([1.0, 1.0, 5.0], 1.0) {
        let model = model.unwrap();
        assert_eq!(model.at_separation(2.0).unwrap().caveat, None);
        assert!(matches!(
            model.at_separation(-1.0).unwrap().caveat,
            Some(Caveat::BeyondModel { quantity, .. }) if quantity == "area fraction"
        ));
        let far = model.at_separation(1e300).unwrap();
        assert!(matches!(far.caveat, Some(Caveat::Underflow { .. })));
        let none = model.at_pressure(0.0).unwrap();
        assert!(none.area_fraction <= 0.0 && none.separation.is_none());
        for bad in [-1.0, f64::NAN, f64::INFINITY] {
            assert!(model.at_pressure(bad).is_err());
        }
        assert!(model.at_separation(f64::NAN).is_err());
    }
}
