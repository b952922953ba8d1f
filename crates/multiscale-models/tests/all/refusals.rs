//! What a theory cannot answer is refused by type, naming the value, the limit and the way out;
//! what strains an assumption is answered with a caveat.

use crate::pascals;
use contact_types::{
    AmplitudeSpectrum, Caveat, ContactModel, ContactModulus, FractalParameters, ModelError,
    RoughnessSpectrum, Shell, SpectralMoments, Wave,
};
use multiscale_models::{
    Archard, JacksonStreator, MajumdarBhushan, Persson, PlasticSpots, SelfAffineSpectrum,
    SphereLevel, Stacked, YanKomvopoulos,
};

fn modulus() -> ContactModulus {
    pascals(110e9)
}

fn persson() -> Persson {
    let moments = SpectralMoments { m0: 1e-12, m2: 0.02, m4: 1e9 };
    Persson::from_moments(moments, modulus()).expect("moments")
}

fn fractal(dimension: f64, plastic: PlasticSpots) -> MajumdarBhushan {
    let surface = FractalParameters { dimension, roughness: 1e-11 };
    MajumdarBhushan::new(surface, 1e-6, modulus(), plastic).expect("a surface")
}

/// The refusal is `OutsideDomain` and says all of `words`.
fn outside<T: std::fmt::Debug>(answer: Result<T, ModelError>, words: &[&str]) {
    let error = answer.expect_err("must be refused");
    assert!(matches!(error, ModelError::OutsideDomain { .. }), "{error}");
    says(&error, words);
}

/// The refusal is `InvalidInput` and says all of `words`.
fn invalid<T: std::fmt::Debug>(answer: Result<T, ModelError>, words: &[&str]) {
    let error = answer.expect_err("must be refused");
    assert!(matches!(error, ModelError::InvalidInput { .. }), "{error}");
    says(&error, words);
}

fn says(error: &ModelError, words: &[&str]) {
    let text = error.to_string();
    for word in words {
        assert!(text.contains(word), "{text:?} does not say {word:?}");
    }
}

#[test]
fn a_load_must_be_a_number_and_not_negative() {
    let waves = AmplitudeSpectrum::new(vec![Wave { frequency: 1e4, amplitude: 1e-7 }], 1e-3);
    let levels = [SphereLevel { radius: 1e-3, density: 1e5 }];
    let models: [&dyn ContactModel; 6] = [
        &persson(),
        &Stacked::new(0.01, modulus()).unwrap(),
        &JacksonStreator::new(waves.unwrap(), modulus()),
        &Archard::new(&levels, modulus()).unwrap(),
        &fractal(1.4, PlasticSpots::None),
        &YanKomvopoulos::new(2.4, 1e-11, 1e-6, modulus(), PlasticSpots::None).unwrap(),
    ];
    for model in models {
        for pressure in [-1.0, f64::NAN, f64::INFINITY] {
            invalid(model.at_pressure(pressure), &["mean pressure", "not negative"]);
        }
        // No load: nothing touches.
        let state = model.at_pressure(0.0).unwrap();
        assert!(state.area_fraction <= 0.0 && state.mean_gap.is_none());
        assert!(!model.citation().title.is_empty());
    }
}

#[test]
fn divergent_fractal_loads_name_the_way_out() {
    for dimension in [1.5, 1.62, 1.99] {
        let value = dimension.to_string();
        let words = ["D = ", value.as_str(), "1 to 1.5", "give a critical area"];
        outside(fractal(dimension, PlasticSpots::None).at_pressure(1e6), &words);
        let model = fractal(dimension, PlasticSpots::Below(1e-15));
        assert!(model.at_pressure(1e6).unwrap().area_fraction > 0.0);
    }
    for dimension in [1.0, 2.0, 0.3, f64::NAN] {
        let surface = FractalParameters { dimension, roughness: 1e-11 };
        let refused = MajumdarBhushan::new(surface, 1e-6, modulus(), PlasticSpots::None);
        outside(refused, &["D", "strictly"]);
    }
    let surface = |d| YanKomvopoulos::new(d, 1e-11, 1e-6, modulus(), PlasticSpots::None);
    outside(surface(2.5).unwrap().at_pressure(1e6), &["D = 2.5", "give a critical area"]);
    outside(surface(3.0), &["D = 3"]);
    // G^2 (2E*/H)^(2/(D-1)) overflows next to D = 1.
    let surface = FractalParameters { dimension: 1.0001, roughness: 1e-9 };
    let model = MajumdarBhushan::new(surface, 1e-6, modulus(), PlasticSpots::OfHardness(1e9));
    outside(model, &["critical area", "close to 1"]);
}

#[test]
fn persson_of_moments_has_no_gap_and_refuses_a_gamma_beyond_those_published() {
    assert!(persson().at_pressure(1e6).unwrap().mean_gap.is_none());
    outside(persson().with_gamma(0.0), &["gamma = 0", "0.01 to 1"]);
    let moments = SpectralMoments { m0: 1.0, m2: -1e-3, m4: 1.0 };
    invalid(Persson::from_moments(moments, modulus()), &["m2 = -1e-3"]);
}

#[test]
fn spectra_outside_their_theory() {
    let band = |hurst, q| SelfAffineSpectrum::from_wavenumbers(hurst, q, 1e-12);
    outside(band(1.2, [1e4, 1e4, 1e6]), &["Hurst exponent = 1.2", "0 to 1"]);
    outside(band(0.8, [1e4, 2e6, 1e6]), &["roll-off"]);
    outside(band(0.8, [1e4, 1e4, 1e4]), &["one shell"]);
    outside(band(0.8, [1e-9, 1e4, 1e12]), &["18 decades"]);
    invalid(SelfAffineSpectrum::from_wavelengths(0.8, 0.0, 1e-6, 1e-12), &["roll-off wavelength"]);
    let inverted = SelfAffineSpectrum::from_wavelengths(0.8, 1e-6, 3.2e-5, 1e-12);
    outside(inverted, &["cut-off wavelength = 3.2e-5", "at most 1e-6"]);
    let shell = |wavenumber| Shell { wavenumber, variance: 1e-12 };
    let spectrum = RoughnessSpectrum::new(vec![shell(1e-9), shell(1e12)]).unwrap();
    outside(Persson::from_spectrum(spectrum, modulus()), &["18 decades"]);
}

#[test]
fn flat_surfaces_touch_everywhere() {
    let flat = SpectralMoments { m0: 0.0, m2: 0.0, m4: 0.0 };
    let empty = RoughnessSpectrum::new(Vec::new()).unwrap();
    let waves = AmplitudeSpectrum::new(Vec::new(), 1e-3).unwrap();
    let models: [&dyn ContactModel; 4] = [
        &Persson::from_moments(flat, modulus()).unwrap(),
        &Persson::from_spectrum(empty, modulus()).unwrap(),
        &Stacked::new(0.0, modulus()).unwrap(),
        &JacksonStreator::new(waves, modulus()),
    ];
    for model in models {
        let state = model.at_pressure(1.0).unwrap();
        assert!(state.area_fraction >= 1.0 && state.mean_gap.unwrap_or(0.0) <= 0.0);
        assert!(matches!(state.caveat, Some(Caveat::Saturated { .. })));
    }
}

#[test]
fn strained_assumptions_are_said() {
    let beyond = |model: &dyn ContactModel, pressure, quantity| {
        let caveat = model.at_pressure(pressure).unwrap().caveat;
        let said =
            matches!(&caveat, Some(Caveat::BeyondModel { quantity: q, .. }) if q == quantity);
        assert!(said, "{caveat:?} does not mention {quantity}");
    };
    let steep = SpectralMoments { m0: 1e-12, m2: 3.0, m4: 1e13 };
    beyond(&Persson::from_moments(steep, modulus()).unwrap(), 1e6, "rms gradient");
    beyond(&fractal(1.4, PlasticSpots::None), 1e12, "area fraction");
    let levels =
        [SphereLevel { radius: 1e-3, density: 1e5 }, SphereLevel { radius: 1e-6, density: 1e11 }];
    let archard = Archard::new(&levels, modulus()).unwrap();
    beyond(&archard, 1e-3, "features per Hertz spot");
    beyond(&archard, 1e10, "cover of a level");
    assert!(archard.at_pressure(1e6).unwrap().caveat.is_none());
    assert!(persson().at_pressure(1e6).unwrap().caveat.is_none());
}
