//! The roughness profile and its parameters.

use super::parameters::{ProfileParameters, parameters};
use super::setting::SETTING_CLASSES;
use super::{Setting, SettingSource, Trace};
use crate::{HeightStatistics, StatsError};

/// Sections of an evaluation length (ISO 21920-3:2021 default).
const SECTIONS: usize = 5;

/// Roughness of one trace at a setting.
#[derive(Debug, Clone, PartialEq)]
pub struct Roughness {
    /// Which waves are roughness.
    pub setting: Setting,
    /// Section lengths evaluated; five if the trace is long enough.
    pub sections: usize,
    /// Where the evaluation length begins and ends along the trace (m).
    pub evaluated: [f64; 2],
    pub(super) parameters: ProfileParameters,
}

/// The roughness profile of a levelled trace: waves shorter than λs and longer than λc taken off by
/// the Gaussian filter of ISO 16610-21. Half a cut-off is left out at both ends, where the weights
/// that fall beyond the trace are made up by the others.
fn roughness_profile(trace: &Trace, setting: &Setting) -> Result<Trace, StatsError> {
    let (length, needed) = (trace.length(), setting.least_length());
    if length < needed * (1.0 - 1e-9) {
        return Err(StatsError::ShortTrace { length, cutoff: setting.cutoff, needed });
    }
    trace.filtered(setting.short, Some(setting.cutoff))
}

/// Roughness parameters of a levelled trace: of its middle five section lengths, or of as many whole
/// ones as fit between the ends.
pub(super) fn roughness(trace: &Trace, setting: &Setting) -> Result<Roughness, StatsError> {
    let profile = roughness_profile(trace, setting)?;
    let spacing = profile.spacing();
    let section = setting.cutoff / spacing; // in points
    // A trace of n sections has n sections of intervals, one point more.
    let fit = ((profile.len() - 1) as f64 / section + 1e-6).floor() as usize;
    let sections = fit.clamp(1, SECTIONS);
    let points = ((sections as f64 * section).round() as usize).min(profile.len());
    let start = (profile.len() - points) / 2;
    let parameters = parameters(&profile.part(start, start + points)?, sections)?;
    let first = 0.5 * (trace.len() - profile.len()) as f64 + start as f64;
    let evaluated = [first, first + points as f64].map(|i| i * spacing);
    Ok(Roughness { setting: *setting, sections, evaluated, parameters })
}

/// The setting for levelled traces by the rule of ISO 21920-3: the finest class whose limit of Ra
/// is not exceeded by the mean Ra measured with it. If the traces are too short for that class,
/// the coarsest one they are long enough for. `short` is λs, if one was asked for.
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
    use approx::assert_relative_eq;
    use std::f64::consts::{LN_2, PI, TAU};

    /// Roughness of 40 µm on waviness of 5 mm, λc 0.8 mm: Ra of the fine wave as it passes, of the
    /// coarse one (1 - 2^(-0.0256)) = 1.8 % is left; five sections of 0.8 mm in the middle of 6 mm.
    #[test]
    fn waviness_is_taken_off_and_roughness_is_not() {
        let z = |x: f64| 1e-6 * (TAU * x / 40e-6).sin() + 4e-6 * (TAU * x / 5e-3).cos();
        let trace =
            Trace::new(0.5e-6, (0..=12_000).map(|i| z(f64::from(i) * 0.5e-6)).collect()).unwrap();
        let found = roughness(&trace, &Setting::asked(0.8e-3, None)).unwrap();
        assert_eq!(found.sections, 5);
        assert_relative_eq!(found.evaluated[0], 1e-3, epsilon = 1e-6);
        assert_relative_eq!(found.evaluated[1], 5e-3, epsilon = 1e-6);
        let left = 4e-6 * (1.0 - (-LN_2 * 0.0256f64).exp());
        let rq = (0.5e-12 + 0.5 * left * left).sqrt();
        assert_relative_eq!(found.parameters[1].1.unwrap(), rq, max_relative = 1e-3);
        // λs of 40 µm takes half of the fine wave's amplitude.
        let half = roughness(&trace, &Setting::asked(0.8e-3, Some(40e-6))).unwrap();
        assert_relative_eq!(half.parameters[0].1.unwrap(), 1e-6 / PI, max_relative = 2e-2);
    }

    #[test]
    fn fewer_sections_on_a_short_trace_and_none_below_two_cut_offs() {
        let trace =
            Trace::new(1e-6, (0..=2400).map(|i| f64::from(i % 7) * 1e-8).collect()).unwrap();
        assert_eq!(roughness(&trace, &Setting::asked(0.8e-3, None)).unwrap().sections, 2);
        let error = roughness(&trace, &Setting::asked(2.5e-3, None)).unwrap_err();
        let text = error.to_string();
        assert!(text.contains("2.4 mm") && text.contains("5 mm"), "{text}");
    }

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
