//! The setting by the rule of ISO 21920-3.

use super::{SETTING_CLASSES, Setting, SettingSource, Trace, roughness_profile};
use crate::{HeightStatistics, StatsError};

/// The setting for levelled traces by the rule of ISO 21920-3: the finest class whose limit of Ra
/// is not exceeded by the mean Ra measured with it. If the traces are too short for that class,
/// the coarsest one they are long enough for. `short` is λs, if one was asked for.
///
/// # Errors
/// [`StatsError::ShortTrace`] if the traces are too short for the finest class; what the filter
/// refuses.
pub(super) fn choose_setting(traces: &[Trace], short: Option<f64>) -> Result<Setting, StatsError> {
    let length = traces.iter().map(Trace::length).fold(f64::INFINITY, f64::min);
    let spacing = traces.iter().map(Trace::spacing).fold(0.0, f64::max);
    let mut longest = None;
    for class in &SETTING_CLASSES {
        let setting = Setting::of_class(class, short, spacing);
        if length < setting.least_length() * (1.0 - 1e-9) || class.cutoff < 2.0 * spacing {
            continue;
        }
        let mut sum = 0.0;
        for trace in traces {
            let profile = roughness_profile(trace, &setting)?;
            sum += HeightStatistics::of(profile.as_map()).mean_abs_height;
        }
        if sum / traces.len() as f64 <= class.most_ra {
            return Ok(setting);
        }
        longest = Some(Setting { source: SettingSource::Longest(class.number), ..setting });
    }
    longest.ok_or(StatsError::ShortTrace {
        length,
        cutoff: SETTING_CLASSES[0].cutoff,
        needed: 2.0 * SETTING_CLASSES[0].cutoff,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{PI, TAU};

    fn sine(ra: f64, wavelength: f64, length: f64) -> Trace {
        let spacing = 0.5e-6;
        let z = |i: usize| 0.5 * PI * ra * (TAU * i as f64 * spacing / wavelength).sin();
        Trace::new(spacing, (0..=(length / spacing) as usize).map(z).collect()).unwrap()
    }

    #[test]
    fn the_class_is_that_of_the_roughness() {
        for (ra, class) in [(0.01e-6, 1), (0.05e-6, 2), (0.5e-6, 3), (1.9e-6, 3), (5e-6, 4)] {
            let trace = sine(ra, 20e-6, 6e-3);
            let setting = choose_setting(&[trace], None).unwrap();
            assert_eq!(setting.source, SettingSource::Class(class), "Ra = {ra:e}");
            assert_eq!(setting.short.is_some(), setting.short_unresolved.is_none());
        }
    }

    #[test]
    fn a_short_trace_gets_what_it_is_long_enough_for_or_nothing() {
        let short = choose_setting(&[sine(0.5e-6, 20e-6, 1e-3)], None).unwrap();
        assert_eq!(short.source, SettingSource::Longest(2));
        let error = choose_setting(&[sine(0.5e-6, 20e-6, 0.1e-3)], None).unwrap_err();
        assert!(matches!(error, StatsError::ShortTrace { .. }), "{error}");
    }
}
