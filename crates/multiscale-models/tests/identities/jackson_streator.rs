//! Jackson and Streator's recursion over the waves.

use crate::close;
use crate::pascals;
use contact_types::{AmplitudeSpectrum, ContactModel, Wave};
use multiscale_models::{JacksonStreator, SinusoidLaw};
use std::f64::consts::PI;

fn one_wave(amplitude: f64) -> JacksonStreator {
    let waves = vec![Wave { frequency: 1e4, amplitude }];
    let spectrum = AmplitudeSpectrum::new(waves, 1e-3).expect("one wave");
    JacksonStreator::new(spectrum, pascals(1e9)).expect("a model")
}

#[test]
fn recursion_has_its_limits() {
    // One wave is the sinusoid law itself.
    let complete = 2.0_f64.sqrt() * PI * 1e9 * 1e-7 * 1e4;
    for law in [SinusoidLaw::PublishedFit, SinusoidLaw::NumericalTable] {
        for x in [1e-9, 0.03, 0.5, 0.95, 1.0, 3.0] {
            let area =
                one_wave(1e-7).with_law(law).at_pressure(x * complete).unwrap().area_fraction;
            close(area, law.area_fraction(x), 1e-14);
        }
        // Hertz at light load: both crests of a cell.
        let x = 1e-30;
        let hertz = PI * (3.0 * x / (8.0 * PI)).powf(2.0 / 3.0);
        close(law.area_fraction(x), hertz, 1e-9);
    }
    // A short wave of no amplitude changes nothing; a steep one takes over.
    let two = |amplitude| {
        let waves =
            vec![Wave { frequency: 1e4, amplitude: 1e-7 }, Wave { frequency: 1e6, amplitude }];
        JacksonStreator::new(AmplitudeSpectrum::new(waves, 1e-3).unwrap(), pascals(1e9)).unwrap()
    };
    let area = |model: &JacksonStreator| model.at_pressure(1e5).unwrap().area_fraction;
    close(area(&two(0.0)), area(&one_wave(1e-7)), 1e-15);
    close(area(&two(1e-14)), area(&one_wave(1e-7)), 1e-15);
    assert!(area(&two(1e-7)) < 0.1 * area(&one_wave(1e-7)));
}
