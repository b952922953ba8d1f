//! Settings of ISO 21920-3, which say what waves are roughness, and the roughness at a setting.

use super::Trace;
use super::parameters::{ProfileParameters, parameters};
use crate::{HeightStatistics, StatsError};

/// Sections of an evaluation length (ISO 21920-3:2021 default).
const SECTIONS: usize = 5;

/// A setting class of ISO 21920-3:2021: what is measured how, by the roughness it is for.
struct SettingClass {
    /// Sc1 to Sc5.
    number: u8,
    /// λc (m): waves longer than this are not roughness. Also the section length.
    cutoff: f64,
    /// λs (m): waves shorter than this are not roughness. It acts on points a fifth of it apart at
    /// most.
    short: f64,
    /// Largest Ra it is for (m).
    most_ra: f64,
}

const fn class(number: u8, cutoff: f64, short: f64, most_ra: f64) -> SettingClass {
    SettingClass { number, cutoff, short, most_ra }
}

/// The five classes, from fine to coarse.
const SETTING_CLASSES: [SettingClass; 5] = [
    class(1, 0.08e-3, 2.5e-6, 0.02e-6),
    class(2, 0.25e-3, 2.5e-6, 0.1e-6),
    class(3, 0.8e-3, 2.5e-6, 2e-6),
    class(4, 2.5e-3, 8e-6, 10e-6),
    class(5, 8e-3, 25e-6, 80e-6),
];

/// Where a setting comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SettingSource {
    /// λc was asked for.
    Asked,
    /// The finest class whose Ra is not exceeded with its own λc.
    Class(u8),
    /// The coarsest class that the trace is long enough for, although Ra exceeds it; the class
    /// that Ra asks for is not known, being coarser.
    Longest(u8),
}

/// Which waves are roughness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Setting {
    /// λc (m), the section length.
    pub cutoff: f64,
    /// λs (m), if it is applied.
    pub short: Option<f64>,
    /// λs of the class (m), if the points stand too far apart for it.
    pub short_unresolved: Option<f64>,
    /// Why these.
    pub source: SettingSource,
}

impl Setting {
    /// λc and, if it is not `None`, λs as asked for.
    pub(crate) fn asked(cutoff: f64, short: Option<f64>) -> Self {
        Self { cutoff, short, short_unresolved: None, source: SettingSource::Asked }
    }

    /// A λc that was asked for, on points at this spacing: with λs as asked for, else that of the class
    /// with this λc if there is one and the points resolve it.
    pub(crate) fn of_cutoff(cutoff: f64, short: Option<f64>, spacing: f64) -> Self {
        let known = SETTING_CLASSES.iter().find(|c| (c.cutoff / cutoff - 1.0).abs() < 1e-6);
        match (short, known) {
            (None, Some(class)) => {
                let source = SettingSource::Asked;
                Self { cutoff, source, ..Self::of_class(class, None, spacing) }
            }
            _ => Self::asked(cutoff, short),
        }
    }

    /// That of a class on points at this spacing, with λs if one was asked for.
    fn of_class(class: &SettingClass, short: Option<f64>, spacing: f64) -> Self {
        let resolved = spacing <= class.short / 5.0 * (1.0 + 1e-6);
        Self {
            cutoff: class.cutoff,
            short: short.or(resolved.then_some(class.short)),
            short_unresolved: (short.is_none() && !resolved).then_some(class.short),
            source: SettingSource::Class(class.number),
        }
    }

    /// Shortest trace that has one section length of roughness, with half a cut-off at each end (m).
    fn least_length(&self) -> f64 {
        2.0 * self.cutoff
    }
}

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

    #[test]
    fn a_lambda_s_that_the_points_do_not_resolve_is_left_out_and_said() {
        let wide = Setting::of_cutoff(0.8e-3, None, 2e-6);
        assert_eq!((wide.short, wide.short_unresolved), (None, Some(2.5e-6)));
        let fine = Setting::of_cutoff(0.8e-3, None, 0.5e-6);
        assert_eq!(fine.short, Some(2.5e-6));
        assert_eq!(Setting::of_cutoff(0.7e-3, None, 0.5e-6).short, None);
        assert_eq!(Setting::of_cutoff(0.8e-3, Some(8e-6), 0.5e-6).short, Some(8e-6));
    }
}
