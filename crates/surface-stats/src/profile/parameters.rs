//! Parameters of ISO 21920-2 of one roughness profile.

use super::Trace;
use crate::StatsError;
use crate::iso25178::{MaterialRatioCurve, seven_point_slope};

/// Share of Rp and Rv that a hill and a dale must exceed to count (ISO 21920-3 default).
const THRESHOLD: f64 = 0.1;

/// Symbol, without its first letter R (roughness profile) or P (primary profile), and value of each
/// parameter, in the order of the standard: lengths in m, slopes and shares as numbers.
pub(super) type ProfileParameters = [(&'static str, Option<f64>); 15];

/// Parameters of a profile that is `sections` section lengths long (ISO 21920-2:2021).
///
/// Ra, Rq, Rsk, Rku, Rt, Rdq, RSm and the Rk family are of the evaluation length; Rp, Rv and Rz are
/// means over its section lengths. Heights are ordinates of the profile, counted from its mean
/// line: what the filter λc leaves at 0, for P the form that was taken off. The mean over the
/// evaluation length is not subtracted.
pub(super) fn parameters(
    profile: &Trace,
    sections: usize,
) -> Result<ProfileParameters, StatsError> {
    let n = profile.len();
    // In units of the largest ordinate, so that fourth powers stay in range.
    let reach = profile.heights().iter().fold(0.0, |reach: f64, z| reach.max(z.abs()));
    let mean = |power: &dyn Fn(f64) -> f64| {
        let unit = if reach > 0.0 { reach } else { 1.0 };
        profile.heights().iter().map(|z| power(z / unit)).sum::<f64>() / n as f64
    };
    let rms = mean(&|z| z * z).sqrt();
    let shape = |power: i32| (reach > 0.0).then(|| mean(&|z| z.powi(power)) / rms.powi(power));
    let (mut peak, mut pit) = (0.0, 0.0);
    for k in 0..sections {
        let section = &profile.heights()[k * n / sections..(k + 1) * n / sections];
        peak += section.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        pit -= section.iter().copied().fold(f64::INFINITY, f64::min);
    }
    let (low, high) = profile.as_map().range();
    let (peak, pit) = (peak / sections as f64, pit / sections as f64);
    let core = MaterialRatioCurve::of(profile.as_map())?.core();
    Ok([
        ("a", Some(reach * mean(&f64::abs))),
        ("q", Some(reach * rms)),
        ("z", Some(peak + pit)),
        ("p", Some(peak)),
        ("v", Some(pit)),
        ("t", Some(high - low)),
        ("sk", shape(3)),
        ("ku", shape(4)),
        ("dq", Some(rms_slope(profile))),
        ("Sm", element_width(profile, peak, pit)),
        ("k", Some(core.core_height)),
        ("pk", Some(core.reduced_peak_height)),
        ("vk", Some(core.reduced_valley_depth)),
        ("mr1", Some(core.peak_ratio)),
        ("mr2", Some(core.valley_ratio)),
    ])
}

/// Rms of the seven-point slope over the points that are three or more from both ends (ISO
/// 21920-2:2021, annex).
fn rms_slope(profile: &Trace) -> f64 {
    let windows = profile.heights().windows(7);
    let count = windows.len() as f64;
    let mean_square = windows.map(|z| seven_point_slope(|k| z[k]).powi(2)).sum::<f64>() / count;
    mean_square.sqrt() / profile.spacing()
}

/// RSm: mean width (m) of the profile elements, hills and dales between crossings of the mean line,
/// which is 0 here.
///
/// A hill counts if it rises above a tenth of `peak` (Rp), a dale if it falls below a tenth of
/// `pit` (Rv), both in m; what lies between is part of its neighbours. An element is a hill with
/// the dale after it, or a dale with the hill after it. Where the line is crossed several times
/// between a hill and a dale, the border is the middle of the first and the last crossing, so
/// that the result does not depend on the direction in which the trace is walked.
///
/// `None` unless two borders of one kind are inside the trace.
///
/// # Source
/// ISO 21920-2:2021, crossing-the-line segmentation; thresholds as in ISO 21920-3:2021.
fn element_width(trace: &Trace, peak: f64, pit: f64) -> Option<f64> {
    let (high, low) = (THRESHOLD * peak, -THRESHOLD * pit);
    // Borders in points: `true` from dale to hill.
    let mut borders: Vec<(bool, f64)> = Vec::new();
    let mut state: Option<bool> = None;
    let mut crossings: Option<[f64; 2]> = None;
    let heights = trace.heights();
    for (i, &z) in heights.iter().enumerate() {
        if i > 0 && (heights[i - 1] > 0.0) != (z > 0.0) {
            let before = heights[i - 1];
            let at = (i - 1) as f64 + before / (before - z);
            crossings = Some([crossings.map_or(at, |c| c[0]), at]);
        }
        let now = if z > high {
            true
        } else if z < low {
            false
        } else {
            continue;
        };
        match (state, crossings) {
            (Some(was), Some([first, last])) if was != now => {
                borders.push((now, f64::midpoint(first, last)));
            }
            _ => {}
        }
        state = Some(now);
        crossings = None;
    }
    let widths = |kind: bool| {
        let of_kind = borders.iter().filter(move |b| b.0 == kind).map(|b| b.1);
        let (first, last) = (of_kind.clone().next(), of_kind.clone().next_back());
        let count = of_kind.count().saturating_sub(1);
        (count, first.zip(last).map_or(0.0, |(a, b)| b - a))
    };
    let ((rising, rise), (falling, fall)) = (widths(true), widths(false));
    let count = rising + falling;
    (count > 0).then(|| (rise + fall) / count as f64 * trace.spacing())
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use std::f64::consts::{PI, SQRT_2, TAU};

    fn value(found: &ProfileParameters, symbol: &str) -> f64 {
        found.iter().find(|(name, _)| *name == symbol).unwrap().1.unwrap()
    }

    fn profile(n: usize, z: impl Fn(f64) -> f64) -> Trace {
        Trace::new(1e-6, (0..n).map(|i| z(i as f64 * 1e-6)).collect()).unwrap()
    }

    /// A sine over whole waves and five sections: Ra = 2A/π, Rq = A/√2, Rz = Rt = 2A, Rsk = 0,
    /// Rku = 3/2, Rdq = √2 π A/λ, RSm = λ.
    #[test]
    fn a_sine_by_hand() {
        let (a, wavelength) = (1.5e-6, 100e-6);
        let p = profile(4000, |x| a * (TAU * (x + 0.5e-6) / wavelength).sin());
        let r = parameters(&p, 5).unwrap();
        assert_relative_eq!(value(&r, "a"), 2.0 * a / PI, max_relative = 2e-4);
        assert_relative_eq!(value(&r, "q"), a / SQRT_2, max_relative = 1e-9);
        assert_relative_eq!(value(&r, "z"), 2.0 * a, max_relative = 1e-3);
        assert_relative_eq!(value(&r, "t"), 2.0 * a, max_relative = 1e-3);
        assert!(value(&r, "sk").abs() < 1e-9);
        assert_relative_eq!(value(&r, "ku"), 1.5, max_relative = 1e-9);
        // Three points at both ends, 1.5 per mille, have no slope of their own.
        assert_relative_eq!(value(&r, "dq"), SQRT_2 * PI * a / wavelength, max_relative = 1.5e-3);
        assert_relative_eq!(value(&r, "Sm"), wavelength, max_relative = 1e-6);
    }

    /// Ordinates count from the mean line of the filter, not from their own mean: one high point of 1 in ten of 0 has
    /// Rp = 1, Rv = 0, Ra = 0.1, Rq = √0.1, Rsk = √10; about its own mean it would be 0.9, 0.1, 0.18, 0.3, 2.67.
    #[test]
    fn the_mean_of_the_evaluated_length_stays() {
        let r = parameters(
            &profile(100, |x| if (x * 1e6).round() as u32 % 10 == 3 { 1e-6 } else { 0.0 }),
            5,
        );
        let r = r.unwrap();
        assert_relative_eq!(value(&r, "p"), 1e-6, max_relative = 1e-12);
        assert!(value(&r, "v").abs() < 1e-18);
        assert_relative_eq!(value(&r, "a"), 0.1e-6, max_relative = 1e-12);
        assert_relative_eq!(value(&r, "q"), 0.1f64.sqrt() * 1e-6, max_relative = 1e-12);
        assert_relative_eq!(value(&r, "sk"), 10f64.sqrt(), max_relative = 1e-12);
    }

    /// A triangle of amplitude A: Ra = A/2, Rq = A/√3, Rku = 9/5, RSm = λ, and its heights are spread
    /// evenly: a straight material ratio curve, Rk = 2A, no peaks and no valleys.
    #[test]
    fn a_triangle_by_hand() {
        let (a, wavelength) = (0.8e-6, 200e-6);
        let z = |x: f64| {
            let t = (x + 0.5e-6).rem_euclid(wavelength) / wavelength;
            a * (4.0 * (t - 0.5).abs() - 1.0)
        };
        let r = parameters(&profile(4000, z), 5).unwrap();
        assert_relative_eq!(value(&r, "a"), a / 2.0, max_relative = 1e-3);
        assert_relative_eq!(value(&r, "q"), a / 3f64.sqrt(), max_relative = 1e-3);
        assert_relative_eq!(value(&r, "ku"), 1.8, max_relative = 1e-3);
        assert_relative_eq!(value(&r, "Sm"), wavelength, max_relative = 1e-6);
        assert_relative_eq!(value(&r, "k"), 2.0 * a, max_relative = 1e-2);
        assert!(value(&r, "pk") < 1e-2 * a && value(&r, "vk") < 1e-2 * a);
        assert_relative_eq!(value(&r, "dq"), 4.0 * a / wavelength, max_relative = 2e-2);
    }

    /// A known Abbott curve, its heights in any order: a core of slope 1 µm between peaks on 10 % and
    /// valleys on 20 %. The line reads Rk = 1 µm; the curve passes its ends at 8 % and 85 %, and the
    /// triangles there are Rpk = 0.4 µm and Rvk = 0.6 µm high.
    #[test]
    fn a_known_abbott_curve_in_any_order() {
        let z =
            |ratio: f64| 1.0 - ratio + 4.0 * (0.1 - ratio).max(0.0) - 3.0 * (ratio - 0.8).max(0.0);
        let n = 40_009; // prime: multiples of 7919 meet every point once
        let heights =
            (0..n).map(|i| 1e-6 * z(f64::from(i * 7919 % n) / f64::from(n - 1))).collect();
        let r = parameters(&Trace::new(1e-6, heights).unwrap(), 5).unwrap();
        assert_relative_eq!(value(&r, "k"), 1e-6, max_relative = 1e-9);
        assert_relative_eq!(value(&r, "mr1"), 0.08, max_relative = 1e-4);
        assert_relative_eq!(value(&r, "mr2"), 0.85, max_relative = 1e-4);
        assert_relative_eq!(value(&r, "pk"), 0.4e-6, max_relative = 1e-3);
        assert_relative_eq!(value(&r, "vk"), 0.6e-6, max_relative = 1e-3);
    }

    /// Peaks of 1 to 5 µm, one in each of five sections, over a flat of -1 µm: Rz is the mean of the
    /// section heights, Rt the whole range.
    #[test]
    fn sections_are_averaged_and_the_total_is_not() {
        let heights = (0..5000)
            .map(|i| if i % 1000 == 500 { f64::from(i / 1000 + 1) * 1e-6 } else { -1e-6 })
            .collect();
        let r = parameters(&Trace::new(1e-6, heights).unwrap(), 5).unwrap();
        assert_relative_eq!(value(&r, "z"), 4e-6, max_relative = 1e-12);
        assert_relative_eq!(value(&r, "t"), 6e-6, max_relative = 1e-12);
    }

    fn width(z: impl Fn(f64) -> f64) -> Option<f64> {
        element_width(&profile(5000, z), 1e-6, 1e-6)
    }

    #[test]
    fn a_sine_has_its_wavelength() {
        for wavelength in [50e-6, 123.4e-6, 1e-3] {
            let found = width(|x| 1e-6 * (TAU * x / wavelength + 0.3).sin()).unwrap();
            assert_relative_eq!(found, wavelength, max_relative = 1e-6);
        }
    }

    /// Ripples of a twentieth of the wave cross the line several times and are no elements.
    #[test]
    fn ripples_below_the_threshold_do_not_count() {
        let wave = |x: f64| 1e-6 * (TAU * x / 250e-6).sin();
        let ripple = |x: f64| 0.05e-6 * (TAU * x / 5e-6 + 1.0).sin();
        let found = width(|x| wave(x) + ripple(x)).unwrap();
        assert_relative_eq!(found, 250e-6, max_relative = 2e-3);
        let all = width(|x| 20.0 * ripple(x)).unwrap();
        assert_relative_eq!(all, 5e-6, max_relative = 1e-2);
    }

    /// Wide dales of 300 um between hills of 100 um: the elements are 400 um wide, counted from
    /// either kind of border; walked backwards it is the same.
    #[test]
    fn an_element_is_a_hill_and_a_dale_in_either_direction() {
        let z = |x: f64| if (x + 0.5e-6).rem_euclid(400e-6) < 100e-6 { 1e-6 } else { -1e-6 };
        let found = width(z).unwrap();
        assert_relative_eq!(found, 400e-6, max_relative = 1e-9);
        let back = width(|x| z(4.999e-3 - x)).unwrap();
        assert_relative_eq!(back, found, max_relative = 1e-9);
    }

    #[test]
    fn half_a_wave_has_no_element() {
        assert_eq!(width(|x| 1e-6 * (TAU * x / 9e-3).sin()), None);
        assert_eq!(width(|_| 0.0), None);
    }
}
