//! Jackson and Streator's recursion over the waves.

use crate::close;
use crate::pascals;
use contact_types::{AmplitudeSpectrum, ContactModel, Wave};
use multiscale_models::JacksonStreator;

fn one_wave(amplitude: f64) -> JacksonStreator {
    let waves = vec![Wave { frequency: 1e4, amplitude }];
    let spectrum = AmplitudeSpectrum::new(waves, 1e-3).expect("one wave");
    JacksonStreator::new(spectrum, pascals(1e9))
}

/// A short wave of no amplitude changes nothing; a steep one takes over.
#[test]
fn short_waves_count_by_their_slope() {
    let two = |amplitude| {
        let waves =
            vec![Wave { frequency: 1e4, amplitude: 1e-7 }, Wave { frequency: 1e6, amplitude }];
        JacksonStreator::new(AmplitudeSpectrum::new(waves, 1e-3).unwrap(), pascals(1e9))
    };
    let area = |model: &JacksonStreator| model.at_pressure(1e5).unwrap().area_fraction;
    close(area(&two(0.0)), area(&one_wave(1e-7)), 1e-15);
    close(area(&two(1e-14)), area(&one_wave(1e-7)), 1e-15);
    assert!(area(&two(1e-7)) < 0.1 * area(&one_wave(1e-7)));
}
