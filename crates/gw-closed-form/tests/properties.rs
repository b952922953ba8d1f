//! Any finite input gives a finite answer or a typed error; everything falls with separation.

use contact_types::{
    AsperityStatistics, Caveat, ContactModel, ContactModulus, ModelError, SeparationModel,
    SpectralMoments,
};
use gw_closed_form::partial_moments::{Order, ln, ln_derivative, scaled, value};
use gw_closed_form::{GreenwoodWilliamson, inverse};
use proptest::num::f64::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
use proptest::prelude::*;

/// Every finite double: all exponents alike.
fn any_finite() -> impl Strategy<Value = f64> {
    prop_oneof![POSITIVE | NEGATIVE | NORMAL | SUBNORMAL | ZERO, -50.0..50.0f64]
}

fn order() -> impl Strategy<Value = Order> {
    prop::sample::select(vec![Order::Zero, Order::Half, Order::One, Order::ThreeHalves])
}

/// Positive over the whole range, or something a surface may have.
fn positive(low: f64, high: f64) -> impl Strategy<Value = f64> {
    prop_oneof![POSITIVE | NORMAL, (low.ln()..high.ln()).prop_map(f64::exp)]
}

fn asperities() -> impl Strategy<Value = AsperityStatistics> {
    (positive(1e8, 1e14), positive(1e-7, 1e-3), positive(1e-10, 1e-5), any_finite()).prop_map(
        |(density, radius, height_std, mean_offset)| AsperityStatistics {
            density,
            radius,
            height_std,
            mean_offset,
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4000, failure_persistence: None, ..Default::default() })]

    #[test]
    fn partial_moments_are_finite(order in order(), alpha in any_finite()) {
        for x in [
            value(order, alpha),
            scaled(order, alpha),
            ln(order, alpha),
            ln_derivative(order, alpha),
        ] {
            prop_assert!(x.is_finite());
        }
        prop_assert!(value(order, alpha) >= 0.0 && scaled(order, alpha) > 0.0 || alpha > 1e80);
    }

    #[test]
    fn inverse_answers_every_positive_double(x in POSITIVE | NORMAL | SUBNORMAL) {
        let alpha = inverse::from_value(x).unwrap();
        // d ln x = slope dα: what is left of x after the rounding of α
        let allowed = 4e-15 * alpha.abs().max(1.0) * ln_derivative(Order::ThreeHalves, alpha).abs();
        prop_assert!((ln(Order::ThreeHalves, alpha) - x.ln()).abs() <= allowed + 3e-16 * x.ln().abs());
    }

    #[test]
    fn inverse_answers_or_refuses_every_logarithm(x in any_finite()) {
        let Some(alpha) = inverse::from_ln(x) else {
            prop_assert!(x > 1060.0);
            return Ok(());
        };
        prop_assert!(alpha.is_finite());
        if alpha.abs() < 1e150 {
            let allowed = 1e-14 * alpha.abs().max(1.0) * ln_derivative(Order::ThreeHalves, alpha).abs();
            prop_assert!((ln(Order::ThreeHalves, alpha) - x).abs() <= allowed + 1e-15 * x.abs());
        }
    }

    #[test]
    fn the_model_answers_or_says_why(
        asperities in asperities(), modulus in positive(1e5, 1e12),
        separation in any_finite(), pressure in any_finite(),
    ) {
        let modulus = ContactModulus::from_pascals(modulus).unwrap();
        let model = GreenwoodWilliamson::new(asperities, modulus).unwrap();
        for answer in [model.at_separation(separation), model.at_pressure(pressure)] {
            match answer {
                Ok(state) => {
                    prop_assert!(state.mean_pressure.is_finite() && state.mean_pressure >= 0.0);
                    prop_assert!(state.area_fraction.is_finite() && state.area_fraction >= 0.0);
                    prop_assert!(state.separation.is_none_or(f64::is_finite));
                    let tiny = state.mean_pressure < f64::MIN_POSITIVE
                        || state.area_fraction < f64::MIN_POSITIVE;
                    let silent = !tiny || state.mean_pressure <= 0.0 && state.separation.is_none();
                    let warned = matches!(state.caveat, Some(Caveat::Underflow { .. }));
                    prop_assert!(silent || warned);
                }
                Err(ModelError::InvalidInput { quantity, value, .. }) if quantity == "mean pressure" => {
                    prop_assert!(value < 0.0);
                }
                Err(_) => {}
            }
        }
        match model.stiffness(separation) {
            Ok(stiffness) => prop_assert!(stiffness.is_finite() && stiffness >= 0.0),
            Err(error) => {
                let overflow = matches!(error, ModelError::OutsideDomain { .. });
                prop_assert!(overflow, "{error}");
            }
        }
    }

    /// Area, pressure and stiffness never rise with the separation, to the last bit.
    #[test]
    fn the_model_falls_with_separation(h in -8.0..40.0f64, m4 in 1e6..1e12f64) {
        let moments = SpectralMoments { m0: 1e-13, m2: 1e-3, m4: 1e7 + m4 };
        let modulus = ContactModulus::from_pascals(1e11).unwrap();
        let model = GreenwoodWilliamson::from_moments(moments, modulus).unwrap();
        let d = h * 1e-13f64.sqrt();
        let (near, far) =
            (model.at_separation(d).unwrap(), model.at_separation(d.next_up()).unwrap());
        prop_assert!(far.mean_pressure <= near.mean_pressure);
        prop_assert!(far.area_fraction <= near.area_fraction);
        prop_assert!(model.stiffness(d.next_up()).unwrap() <= model.stiffness(d).unwrap());
    }
}

#[test]
fn refuses_with_the_value_and_the_way_out() {
    let modulus = ContactModulus::from_pascals(1e9).unwrap();
    let good =
        AsperityStatistics { density: 1e10, radius: 1e-5, height_std: 1e-6, mean_offset: 0.0 };
    for bad in [
        AsperityStatistics { density: 0.0, ..good },
        AsperityStatistics { radius: -1.0, ..good },
        AsperityStatistics { height_std: f64::NAN, ..good },
        AsperityStatistics { mean_offset: f64::INFINITY, ..good },
    ] {
        assert!(matches!(
            GreenwoodWilliamson::new(bad, modulus),
            Err(ModelError::InvalidInput { .. })
        ));
    }
    let model = GreenwoodWilliamson::new(good, modulus).unwrap();
    let error = model.at_pressure(-1.0).unwrap_err().to_string();
    let expected = "Greenwood-Williamson: mean pressure = -1e0 is not usable: \
                    must be finite and not negative";
    assert_eq!(error, expected);
    assert!(model.at_pressure(f64::NAN).is_err() && model.at_separation(f64::INFINITY).is_err());
    let narrow = SpectralMoments { m0: 1.0, m2: 1.0, m4: 0.89 };
    assert!(matches!(
        GreenwoodWilliamson::from_moments(narrow, modulus),
        Err(ModelError::OutsideDomain { quantity, .. }) if quantity == "bandwidth m0 m4 / m2^2"
    ));
}

proptest! {
    /// Pressure to separation to pressure, from pressures near the smallest double to full overlap, whatever the
    /// asperities: what is lost is the rounding of the separation.
    #[test]
    fn separation_and_back(
        density in 5.0..14.0, radius in -8.0..-3.0, height in -9.0..-4.0, pressure in -290.0..12.0,
    ) {
        let [density, radius, height_std, pressure] =
            [density, radius, height, pressure].map(|x: f64| 10f64.powf(x));
        let mean_offset = 0.3 * height_std;
        let asperities = AsperityStatistics { density, radius, height_std, mean_offset };
        let modulus = ContactModulus::from_pascals(1e11).unwrap();
        let model = GreenwoodWilliamson::new(asperities, modulus).unwrap();
        let there = model.at_pressure(pressure).unwrap();
        prop_assume!(there.area_fraction.is_normal());
        let separation = there.separation.unwrap();
        let back = model.at_separation(separation).unwrap();
        let alpha = (separation - mean_offset) / height_std;
        let tolerance = 1e-14 * (1.0 + if alpha > 0.0 { alpha * alpha } else { 0.0 });
        prop_assert!((back.mean_pressure / pressure - 1.0).abs() < tolerance, "{there:?} {back:?}");
        prop_assert!((back.area_fraction / there.area_fraction - 1.0).abs() < tolerance);
    }
}

#[test]
fn caveats_say_what_is_strained() {
    let modulus = ContactModulus::from_pascals(1e9).unwrap();
    let at = |m4: f64, h: f64| {
        let moments = SpectralMoments { m0: 1.0, m2: 1.0, m4 };
        GreenwoodWilliamson::from_moments(moments, modulus).unwrap().at_separation(h).unwrap()
    };
    assert_eq!(at(2.0, 3.0).caveat, None);
    assert!(matches!(
        at(2.0, -3.0).caveat,
        Some(Caveat::BeyondModel { quantity, .. }) if quantity == "area fraction"
    ));
    assert!(matches!(
        at(1.2, 3.0).caveat,
        Some(Caveat::BeyondModel { quantity, .. }) if quantity == "bandwidth"
    ));
    assert!(matches!(at(2.0, 60.0).caveat, Some(Caveat::Underflow { .. })));
    // One wavelength has bandwidth 3/2 exactly; rounding must not flag it.
    assert_eq!(at(1.5f64.next_down(), 3.0).caveat, None);
}

/// Neighbouring doubles never come out in the wrong order: half a million pairs for each order and
/// kind of place, anywhere in use, around 0, at every magnitude, and on both sides of every join
/// between two Taylor series.
#[test]
fn falls_to_the_last_bit() {
    for order in [Order::Zero, Order::Half, Order::One, Order::ThreeHalves] {
        for k in 0..2_000_000 {
            let u = (f64::from(k) * 0.618_033_988_749_894_9).fract();
            let alpha = match k % 4 {
                0 => -12.0 + 52.0 * u,
                1 => -1.0 + 2.0 * u,
                2 => (600.0 * (2.0 * u).fract() - 300.0).exp2().copysign(u - 0.5),
                _ => {
                    // Nodes are a quarter apart, joins halfway between them.
                    let join = 0.125 * ((160.0 * u).floor() - 82.0);
                    (0..k / 4 % 3).fold(join, |alpha, _| alpha.next_down())
                }
            };
            let (near, far) = (value(order, alpha), value(order, alpha.next_up()));
            assert!(far <= near, "{order:?} at {alpha:e}: {near:e} then {far:e}");
        }
    }
}
