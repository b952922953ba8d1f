//! Settings of ISO 21920-3, which say what waves are roughness, and the roughness at a setting.

use super::Trace;
use super::parameters::{ParameterMean, means};
use crate::{HeightStatistics, StatsError};

/// Sections of an evaluation length (ISO 21920-3:2021 default).
const SECTIONS: usize = 5;

/// The setting classes Sc1 to Sc5 of ISO 21920-3:2021 (m): λc, which is also the section length; λs, which acts on points a
/// fifth of it apart at most; the largest Ra that the class is for.
const SETTING_CLASSES: [[f64; 3]; 5] = [
    [0.08e-3, 2.5e-6, 0.02e-6],
    [0.25e-3, 2.5e-6, 0.1e-6],
    [0.8e-3, 2.5e-6, 2e-6],
    [2.5e-3, 8e-6, 10e-6],
    [8e-3, 25e-6, 80e-6],
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
    /// A λc that was asked for, on points at this spacing: with λs as asked for, else that of the class
    /// with this λc if there is one and the points resolve it.
    pub(super) fn asked(cutoff: f64, short: Option<f64>, spacing: f64) -> Self {
        let class = SETTING_CLASSES.iter().find(|[known, ..]| (known / cutoff - 1.0).abs() < 1e-6);
        Self::new(cutoff, short, class.map(|class| class[1]), spacing, SettingSource::Asked)
    }

    /// With the λs of a class, if none was asked for and the points resolve it.
    fn new(
        cutoff: f64,
        short: Option<f64>,
        of_class: Option<f64>,
        spacing: f64,
        source: SettingSource,
    ) -> Self {
        let of_class = of_class.filter(|_| short.is_none());
        let is_resolved = |short: &f64| spacing <= short / 5.0 * (1.0 + 1e-6);
        Self {
            cutoff,
            short: short.or(of_class.filter(is_resolved)),
            short_unresolved: of_class.filter(|short| !is_resolved(short)),
            source,
        }
    }
}

/// Roughness of traces at a setting.
#[derive(Debug, Clone, PartialEq)]
pub struct Roughness {
    /// Which waves are roughness.
    pub setting: Setting,
    /// Section lengths evaluated; five if the trace is long enough.
    pub sections: usize,
    /// Where the evaluation length begins and ends along the trace (m).
    pub evaluated: [f64; 2],
    /// R parameters over the traces.
    pub parameters: Vec<ParameterMean>,
}

/// The roughness profile of a levelled trace: waves shorter than λs and longer than λc taken off by
/// the Gaussian filter of ISO 16610-21. Half a cut-off is left out at both ends, where the weights
/// that fall beyond the trace are made up by the others.
fn roughness_profile(trace: &Trace, setting: &Setting) -> Result<Trace, StatsError> {
    let (length, needed) = (trace.length(), 2.0 * setting.cutoff);
    if length < needed * (1.0 - 1e-9) {
        return Err(StatsError::ShortTrace { length, cutoff: setting.cutoff, needed });
    }
    trace.filtered(setting.short, Some(setting.cutoff))
}

/// The middle five section lengths of the roughness profile of a levelled trace, or as many whole ones as fit between the
/// ends: the profile, the number of sections, where it begins and ends (m).
fn evaluated_part(
    trace: &Trace,
    setting: &Setting,
) -> Result<(Trace, usize, [f64; 2]), StatsError> {
    let profile = roughness_profile(trace, setting)?;
    let (spacing, length) = (profile.spacing(), profile.heights().len());
    let section = setting.cutoff / spacing; // in points
    // A trace of n sections has n sections of intervals, one point more.
    let fit = ((length - 1) as f64 / section + 1e-6).floor() as usize;
    let sections = fit.clamp(1, SECTIONS);
    let points = ((sections as f64 * section).round() as usize).min(length);
    let start = (length - points) / 2;
    let first = 0.5 * (trace.heights().len() - length) as f64 + start as f64;
    let ends = [first, first + points as f64].map(|i| i * spacing);
    let heights = profile.heights()[start..start + points].to_vec();
    Ok((Trace::new(spacing, heights)?, sections, ends))
}

/// Roughness parameters of levelled traces of the same length and spacing.
pub(super) fn roughness(traces: &[Trace], setting: Setting) -> Result<Roughness, StatsError> {
    let parts = traces.iter().map(|trace| evaluated_part(trace, &setting));
    let parts = parts.collect::<Result<Vec<_>, _>>()?;
    let (sections, evaluated) = (parts[0].1, parts[0].2);
    let profiles: Vec<Trace> = parts.into_iter().map(|(profile, ..)| profile).collect();
    Ok(Roughness { setting, sections, evaluated, parameters: means(&profiles, sections, 'R')? })
}

/// The setting for levelled traces by the rule of ISO 21920-3: the finest class whose limit of Ra
/// is not exceeded by the mean Ra measured with it. If the traces are too short for that class,
/// the coarsest one they are long enough for. `short` is λs, if one was asked for.
pub(super) fn choose_setting(traces: &[Trace], short: Option<f64>) -> Result<Setting, StatsError> {
    let length = traces.iter().map(Trace::length).fold(f64::INFINITY, f64::min);
    let spacing = traces.iter().map(Trace::spacing).fold(0.0, f64::max);
    let mut longest = None;
    for (number, [cutoff, of_class, most_ra]) in (1..).zip(SETTING_CLASSES) {
        let source = SettingSource::Class(number);
        let setting = Setting::new(cutoff, short, Some(of_class), spacing, source);
        if length < 2.0 * cutoff * (1.0 - 1e-9) || cutoff < 2.0 * spacing {
            continue;
        }
        let mut sum = 0.0;
        for trace in traces {
            let profile = roughness_profile(trace, &setting)?;
            sum += HeightStatistics::of(&profile).mean_abs_height;
        }
        if sum / traces.len() as f64 <= most_ra {
            return Ok(setting);
        }
        longest = Some(Setting { source: SettingSource::Longest(number), ..setting });
    }
    let [cutoff, ..] = SETTING_CLASSES[0];
    longest.ok_or(StatsError::ShortTrace { length, cutoff, needed: 2.0 * cutoff })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::close;
    use approx::assert_relative_eq;
    use std::f64::consts::{LN_2, PI, TAU};

    const SPACING: f64 = 0.5e-6;

    fn trace(length: f64, z: impl Fn(f64) -> f64) -> Trace {
        let heights = (0..=(length / SPACING).round() as usize).map(|i| z(i as f64 * SPACING));
        Trace::new(SPACING, heights.collect()).unwrap()
    }

    /// Roughness of 40 µm on waviness of 5 mm, λc 0.8 mm: Ra of the fine wave as it passes, of the
    /// coarse one (1 - 2^(-0.0256)) = 1.8 % is left; five sections of 0.8 mm in the middle of 6 mm.
    #[test]
    fn waviness_is_taken_off_and_roughness_is_not() {
        let z = |x: f64| 1e-6 * (TAU * x / 40e-6).sin() + 4e-6 * (TAU * x / 5e-3).cos();
        let trace = [trace(6e-3, z)];
        let found = roughness(&trace, Setting::asked(0.8e-3, None, 1e-6)).unwrap();
        assert_eq!((found.setting.short, found.sections), (None, 5));
        assert_relative_eq!(found.evaluated[0], 1e-3, epsilon = 1e-6);
        assert_relative_eq!(found.evaluated[1], 5e-3, epsilon = 1e-6);
        let left = 4e-6 * (1.0 - (-LN_2 * 0.0256f64).exp());
        let rq = (0.5e-12 + 0.5 * left * left).sqrt();
        close(found.parameters[1].mean.unwrap(), rq, 1e-3);
        // λs of 40 µm takes half of the fine wave's amplitude.
        let half = roughness(&trace, Setting::asked(0.8e-3, Some(40e-6), 1e-6)).unwrap();
        close(half.parameters[0].mean.unwrap(), 1e-6 / PI, 2e-2);
    }

    #[test]
    fn a_short_trace_has_fewer_sections() {
        let trace = [trace(2.4e-3, |x| 1e-8 * (x * 1e6).sin())];
        let found = roughness(&trace, Setting::asked(0.8e-3, None, SPACING)).unwrap();
        assert_eq!(found.sections, 2);
    }

    /// By Ra (µm) and length (mm): the class of the roughness, on a short trace the coarsest that fits, or none.
    #[test]
    fn the_class_is_that_of_the_roughness_if_the_trace_is_long_enough() {
        use SettingSource::{Class, Longest};
        for (ra, length, expected) in [
            (0.01, 6.0, Some(Class(1))),
            (0.05, 6.0, Some(Class(2))),
            (1.9, 6.0, Some(Class(3))),
            (5.0, 6.0, Some(Class(4))),
            (0.5, 1.0, Some(Longest(2))),
            (0.5, 0.1, None),
        ] {
            let sine = trace(1e-3 * length, |x| 0.5e-6 * PI * ra * (TAU * x / 20e-6).sin());
            match choose_setting(&[sine], None) {
                Ok(setting) => {
                    assert_eq!(Some(setting.source), expected, "Ra = {ra} µm");
                    assert_eq!(setting.short.is_some(), setting.short_unresolved.is_none());
                }
                Err(error) => {
                    assert!(matches!(error, StatsError::ShortTrace { .. }) && expected.is_none());
                }
            }
        }
    }

    #[test]
    fn a_lambda_s_that_the_points_do_not_resolve_is_left_out_and_said() {
        for (cutoff, asked, spacing, short, unresolved) in [
            (0.8e-3, None, 2e-6, None, Some(2.5e-6)),
            (0.8e-3, None, 0.5e-6, Some(2.5e-6), None),
            (0.7e-3, None, 0.5e-6, None, None),
            (0.8e-3, Some(8e-6), 0.5e-6, Some(8e-6), None),
        ] {
            let found = Setting::asked(cutoff, asked, spacing);
            assert_eq!((found.short, found.short_unresolved), (short, unresolved), "{cutoff:e}");
        }
    }
}
