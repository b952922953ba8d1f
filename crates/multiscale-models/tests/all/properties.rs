//! No finite input makes a NaN, an infinity or a panic; area never falls as pressure rises.

use contact_types::{
    AmplitudeSpectrum, ContactModel, ContactModulus, ContactState, FractalParameters, ModelError,
    RoughnessSpectrum, Shell, SpectralMoments, Wave,
};
use multiscale_models::{
    Archard, JacksonStreator, MajumdarBhushan, Persson, PlasticSpots, SelfAffineSpectrum,
    SphereLevel, Stacked, YanKomvopoulos,
};
use proptest::prelude::*;

/// Any finite double, of either sign, subnormal ones and zero included.
fn any_finite() -> impl Strategy<Value = f64> {
    any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite())
}

/// Any finite double that is not negative, evenly over the exponents.
fn magnitude() -> impl Strategy<Value = f64> {
    any_finite().prop_map(f64::abs)
}

fn modulus() -> impl Strategy<Value = ContactModulus> {
    magnitude()
        .prop_filter("normal", |x| x.is_normal())
        .prop_map(|e| ContactModulus::from_pascals(e).expect("a positive normal number"))
}

fn shells() -> impl Strategy<Value = Vec<Shell>> {
    prop::collection::vec((magnitude(), magnitude()), 0..6).prop_map(|mut pairs| {
        pairs.retain(|p| p.0 > 0.0);
        pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
        pairs.dedup_by(|a, b| a.0.to_bits() == b.0.to_bits());
        pairs.into_iter().map(|(wavenumber, variance)| Shell { wavenumber, variance }).collect()
    })
}

/// The same within the 18 decades that Persson's integrals resolve.
fn band() -> impl Strategy<Value = Vec<Shell>> {
    let steps = prop::collection::vec((1.0..1e3, magnitude()), 0..6);
    (magnitude(), steps).prop_map(|(first, steps)| {
        let mut wavenumber = first.clamp(f64::MIN_POSITIVE, 1e290);
        let shell = |(ratio, variance): (f64, f64)| {
            wavenumber *= 1.0 + ratio;
            Shell { wavenumber, variance }
        };
        steps.into_iter().map(shell).collect()
    })
}

/// An answer, if there is one, must be a number.
fn is_sound(answer: &Result<ContactState, ModelError>) -> bool {
    let Ok(state) = answer else { return true };
    let gap = state.mean_gap.unwrap_or(0.0);
    state.area_fraction.is_finite()
        && state.area_fraction >= 0.0
        && gap.is_finite()
        && gap >= 0.0
        && state.real_pressure().is_none_or(f64::is_finite)
}

/// Area at two pressures must not fall.
fn is_monotone(model: &dyn ContactModel, p: f64, q: f64) -> bool {
    let (lo, hi) = (p.min(q), p.max(q));
    match (model.at_pressure(lo), model.at_pressure(hi)) {
        (Ok(a), Ok(b)) => a.area_fraction <= b.area_fraction,
        (Err(_), Ok(_)) => lo < 0.0,
        _ => true,
    }
}

fn is_sound_and_monotone(model: &dyn ContactModel, p: f64, q: f64) -> bool {
    is_sound(&model.at_pressure(p)) && is_monotone(model, p.abs(), q)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn persson_from_moments(m2 in any_finite(), e in modulus(), p in any_finite(), q in magnitude()) {
        let moments = SpectralMoments { m0: 1.0, m2, m4: 1.0 };
        if let Ok(model) = Persson::from_moments(moments, e) {
            prop_assert!(is_sound_and_monotone(&model, p, q));
        } else {
            prop_assert!(m2 < 0.0);
        }
    }

    #[test]
    fn persson_from_spectrum(shells in prop_oneof![band(), shells()], e in modulus(), p in any_finite(), q in magnitude(), gamma in 0.01..=1.0) {
        let spectrum = RoughnessSpectrum::new(shells).unwrap();
        let Ok(model) = Persson::from_spectrum(&spectrum, e) else {
            // More than 18 decades.
            let carrying = || spectrum.shells().iter().filter(|s| s.variance > 0.0);
            let span = carrying().next_back().unwrap().wavenumber / carrying().next().unwrap().wavenumber;
            prop_assert!(span > 0.99e18);
            return Ok(());
        };
        let model = model.with_gamma(gamma).unwrap();
        prop_assert!(is_sound_and_monotone(&model, p, q));
    }

    #[test]
    fn persson_self_affine(
        hurst in 0.0..=1.0, q in [1e-300..1e300, 1.0..1e3, 1.0..1e15], m0 in magnitude(), e in modulus(), p in magnitude(), r in magnitude(),
    ) {
        let wavenumbers = [q[0], q[0] * q[1], q[0] * q[1] * q[2]];
        if let Ok(spectrum) = SelfAffineSpectrum::from_wavenumbers(hurst, wavenumbers, m0) {
            let model = Persson::from_self_affine(spectrum, e).with_gamma(0.45).unwrap();
            prop_assert!(is_sound_and_monotone(&model, p, r));
        }
    }

    #[test]
    fn self_affine_takes_any_input(h in any_finite(), a in any_finite(), b in any_finite(), c in any_finite(), m0 in any_finite()) {
        // Whether it is accepted or refused, it must not panic.
        let _ = SelfAffineSpectrum::from_wavenumbers(h, [a, b, c], m0);
        let _ = SelfAffineSpectrum::from_wavelengths(h, a, b, m0);
    }

    #[test]
    fn stacked(b in any_finite(), e in modulus(), p in any_finite(), q in magnitude()) {
        match Stacked::new(b, e) {
            Ok(model) => prop_assert!(is_sound_and_monotone(&model, p, q)),
            Err(_) => prop_assert!(b < 0.0),
        }
    }

    #[test]
    fn jackson_streator(shells in shells(), e in modulus(), p in any_finite(), q in magnitude()) {
        let waves = shells.iter().map(|s| Wave { frequency: s.wavenumber, amplitude: s.variance });
        let spectrum = AmplitudeSpectrum::new(waves.collect(), 1.0).unwrap();
        let model = JacksonStreator::new(spectrum, e);
        // The area falls by 4.2e-4 where the fit of the sinusoid ends.
        prop_assert!(is_sound(&model.at_pressure(p)) && is_sound(&model.at_pressure(q)));
    }

    #[test]
    fn archard(levels in prop::collection::vec((any_finite(), any_finite()), 0..5), e in modulus(), p in any_finite(), q in magnitude()) {
        let level = |(radius, density)| SphereLevel { radius, density };
        if let Ok(model) = Archard::new(&levels.into_iter().map(level).collect::<Vec<_>>(), e) {
            prop_assert!(is_sound_and_monotone(&model, p, q));
        }
    }

    #[test]
    fn fractals(
        dimension in prop_oneof![1.0..2.0, any_finite(), Just(1.5), Just(1.0 + f64::EPSILON), Just(2.0 - f64::EPSILON)],
        roughness in magnitude(), area in magnitude(), critical in any_finite(), e in modulus(), p in any_finite(), q in magnitude(),
    ) {
        let surface = FractalParameters { dimension, roughness };
        let kinds = [PlasticSpots::None, PlasticSpots::Below(critical), PlasticSpots::OfHardness(critical)];
        for plastic in kinds {
            if let Ok(model) = MajumdarBhushan::new(surface, area, e, plastic) {
                prop_assert!(is_sound(&model.at_pressure(p)));
                prop_assert!(plastic != PlasticSpots::None || is_monotone(&model, p.abs(), q));
            }
            if let Ok(model) = YanKomvopoulos::new(dimension + 1.0, roughness, area, e, plastic) {
                prop_assert!(is_sound(&model.at_pressure(p)));
            }
        }
    }
}

/// By no more than the roundings of a few operations; of one monotone function, not at all.
#[test]
fn area_does_not_fall_from_one_double_to_the_next() {
    let e = ContactModulus::from_pascals(1e9).unwrap();
    let moments = SpectralMoments { m0: 1.0, m2: 0.02, m4: 1.0 };
    let persson = Persson::from_moments(moments, e).unwrap();
    let levels =
        [SphereLevel { radius: 1e-3, density: 1e5 }, SphereLevel { radius: 1e-6, density: 1e11 }];
    let surface = |dimension| FractalParameters { dimension, roughness: 1e-9 };
    let fractal = |d, plastic| MajumdarBhushan::new(surface(d), 1e-6, e, plastic).unwrap();
    let models: [(&dyn ContactModel, f64); 6] = [
        (&persson, 0.0),
        (&Stacked::new(0.013, e).unwrap(), 0.0),
        (&fractal(1.4, PlasticSpots::None), 0.0),
        (&Archard::new(&levels, e).unwrap(), 4.0 * f64::EPSILON),
        (&fractal(1.6, PlasticSpots::Below(1e-15)), 16.0 * f64::EPSILON),
        (&fractal(1.6, PlasticSpots::OfHardness(1e7)), 16.0 * f64::EPSILON),
    ];
    for (index, (model, slack)) in models.into_iter().enumerate() {
        for step in 0..400 {
            let mut p = 1e2 * 10.0_f64.powf(f64::from(step) / 60.0);
            let mut last = 0.0;
            for _ in 0..6 {
                let area = model.at_pressure(p).unwrap().area_fraction;
                assert!(area >= last * (1.0 - slack), "model {index}, p = {p}: {last} to {area}");
                last = area;
                p = p.next_up();
            }
        }
    }
}
