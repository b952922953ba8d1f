//! Any finite input gives a finite answer or a typed error; area and load fall with separation.
#![allow(clippy::unwrap_used, reason = "tests: a panic is the report")]

use asperity_models::{
    BushGibsonThomas, GreenwoodElliptical, MeanCurvature, SummitLaw, SummitModel, nayak,
};
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

fn models(m0: f64, m2: f64, m4: f64, e: f64) -> Vec<Result<Box<dyn SeparationModel>, ModelError>> {
    let moments = SpectralMoments { m0, m2, m4 };
    let modulus = ContactModulus::from_pascals(e).unwrap();
    vec![
        BushGibsonThomas::new(moments, modulus).map(|m| Box::new(m) as _),
        GreenwoodElliptical::new(moments, modulus).map(|m| Box::new(m) as _),
        MeanCurvature::new(moments, modulus).map(|m| Box::new(m) as _),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..Default::default() })]

    #[test]
    fn the_models_answer_or_say_why(
        m0 in positive(1e-18, 1e-6), m2 in positive(1e-6, 1.0), bandwidth in bandwidth(),
        modulus in positive(1e5, 1e12), separation in any_finite(), pressure in any_finite(), h in -8.0..45.0f64,
    ) {
        let m4 = bandwidth * m2 / m0 * m2;
        for model in models(m0, m2, m4, modulus) {
            let Ok(model) = model else { continue };
            let natural = h * m0.sqrt();
            for answer in [
                model.at_separation(separation),
                model.at_separation(natural),
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

    /// Down to a separation change of 1e-13 of itself, and of 1e-13 rms heights around 0.
    #[test]
    fn area_and_load_fall_with_separation(
        bandwidth in bandwidth(), h in -6.0..37.0f64, fraction in 1.0..100.0f64,
    ) {
        for model in models(1.0, 1.0, bandwidth, 1.0) {
            let model = model.unwrap();
            let near = model.at_separation(h).unwrap();
            let far = model.at_separation(h + 1e-13 * fraction * h.abs().max(1.0)).unwrap();
            prop_assert!(far.mean_pressure <= near.mean_pressure, "{bandwidth} {h}");
            prop_assert!(far.area_fraction <= near.area_fraction, "{bandwidth} {h}");
        }
    }

    /// The inverse finds its way back, at any bandwidth and any load.
    #[test]
    fn pressure_and_separation_are_inverse(bandwidth in bandwidth(), h in -6.0..37.0f64) {
        prop_assume!(bandwidth < 1e100);
        for model in models(1.0, 1.0, bandwidth, 1.0) {
            let model = model.unwrap();
            let there = model.at_separation(h).unwrap();
            let back = model.at_pressure(there.mean_pressure).unwrap();
            prop_assert!((back.separation.unwrap() - h).abs() <= 1e-14 * h.abs().max(1.0));
            prop_assert!((back.area_fraction / there.area_fraction - 1.0).abs() < 2e-13);
        }
    }

    #[test]
    fn summit_heights_have_a_density(bandwidth in bandwidth(), xi in any_finite()) {
        let density = nayak::summit_height_density(bandwidth, xi).unwrap();
        prop_assert!(density.is_finite() && density >= 0.0);
    }
}

#[test]
fn refuses_a_bandwidth_below_three_halves_but_not_by_rounding() {
    let at = |bandwidth: f64| {
        let moments = SpectralMoments { m0: 1.0, m2: 1.0, m4: bandwidth };
        BushGibsonThomas::new(moments, ContactModulus::from_pascals(1.0).unwrap())
    };
    let error = at(1.4999).err().unwrap();
    assert!(matches!(error, ModelError::OutsideDomain { value, .. } if value < 1.5), "{error}");
    assert!(error.to_string().contains("1.4999 is outside its domain, at least 1.5"), "{error}");
    assert!(at(1.5f64.next_down()).is_ok() && at(1.5).is_ok());
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(at(bad).err().unwrap(), ModelError::InvalidInput { .. }), "{bad}");
    }
    assert!(nayak::summit_height_density(1.4, 0.0).is_err());
}

#[test]
fn caveats_and_refusals() {
    for model in models(1.0, 1.0, 5.0, 1.0) {
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

proptest! {
    /// Pressure to area to pressure: the same digits, from pressures near the smallest double to full
    /// overlap, at every bandwidth.
    #[test]
    fn area_and_back(bandwidth in bandwidth(), pressure in -290.0..12.0f64) {
        prop_assume!(bandwidth < 1e8);
        let moments = SpectralMoments { m0: 1e-12, m2: 0.01, m4: bandwidth * 1e8 };
        let modulus = ContactModulus::from_pascals(1e11).unwrap();
        let pressure = 10f64.powf(pressure);
        same_digits(&BushGibsonThomas::new(moments, modulus).unwrap(), pressure)?;
        same_digits(&GreenwoodElliptical::new(moments, modulus).unwrap(), pressure)?;
        same_digits(&MeanCurvature::new(moments, modulus).unwrap(), pressure)?;
    }
}

fn same_digits<L: SummitLaw>(model: &SummitModel<L>, pressure: f64) -> Result<(), TestCaseError> {
    let there = model.at_pressure(pressure).unwrap();
    let back = model.at_area(there.area_fraction).unwrap();
    prop_assert!((back.mean_pressure / pressure - 1.0).abs() < 1e-13, "{there:?} {back:?}");
    prop_assert_eq!(back.area_fraction.to_bits(), there.area_fraction.to_bits());
    Ok(())
}

#[test]
fn at_no_area_nothing_touches() {
    let moments = SpectralMoments { m0: 0.25e-12, m2: 5e-3, m4: 1e9 };
    let modulus = ContactModulus::from_pascals(1e11).unwrap();
    let model = BushGibsonThomas::new(moments, modulus).unwrap();
    assert_eq!(model.at_area(0.0).unwrap(), model.at_pressure(0.0).unwrap());
    for bad in [-0.1, f64::NAN, f64::INFINITY] {
        assert!(matches!(model.at_area(bad), Err(ModelError::InvalidInput { .. })), "{bad}");
    }
}
