//! Parameters of ISO 21920-2 of a roughness profile.

use super::Trace;
use crate::StatsError;
use crate::iso25178::{MaterialRatioCurve, seven_point_slope};

/// Share of Rp and Rv that a hill and a dale must exceed to count (ISO 21920-3 default).
const THRESHOLD: f64 = 0.1;

/// Symbol, without its first letter R (roughness profile) or P (primary profile), and value of each
/// parameter, in the order of the standard: lengths in m, slopes and shares as numbers.
type ProfileParameters = [(&'static str, Option<f64>); 15];

/// A parameter of ISO 21920-2 over several traces.
#[derive(Debug, Clone, PartialEq)]
pub struct ParameterMean {
    /// Its symbol, `Ra`.
    pub symbol: String,
    /// Its mean (m, or a number); absent where a trace does not have it.
    pub mean: Option<f64>,
    /// Its standard deviation from trace to trace, of two or more.
    pub deviation: Option<f64>,
}

/// Parameters of profiles that are `sections` section lengths long, with the first letter of their symbols.
pub(super) fn means(
    profiles: &[Trace],
    sections: usize,
    letter: char,
) -> Result<Vec<ParameterMean>, StatsError> {
    let all = profiles.iter().map(|profile| parameters(profile, sections));
    let all = all.collect::<Result<Vec<ProfileParameters>, _>>()?;
    let n = all.len() as f64;
    let one = |k: usize| {
        let values: Option<Vec<f64>> = all.iter().map(|p| p[k].1).collect();
        let mean = values.as_ref().map(|v| v.iter().sum::<f64>() / n);
        let deviation = values.zip(mean).filter(|_| all.len() > 1).map(|(values, mean)| {
            let squares = values.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>();
            (squares / (n - 1.0)).sqrt()
        });
        ParameterMean { symbol: format!("{letter}{}", all[0][k].0), mean, deviation }
    };
    Ok((0..15).map(one).collect())
}

/// Parameters of a profile that is `sections` section lengths long (ISO 21920-2:2021).
///
/// Rp, Rv and Rz are means over the section lengths, the others of the evaluation length. Heights count from the mean
/// line: what the filter λc leaves at 0, for P the form that was taken off. The mean over the evaluation length stays.
fn parameters(profile: &Trace, sections: usize) -> Result<ProfileParameters, StatsError> {
    let n = profile.heights().len();
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
    let (low, high) = profile.range();
    let (peak, pit) = (peak / sections as f64, pit / sections as f64);
    let [k, pk, vk, mr1, mr2] = MaterialRatioCurve::of(profile)?.core();
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
        ("k", Some(k)),
        ("pk", Some(pk)),
        ("vk", Some(vk)),
        ("mr1", Some(mr1)),
        ("mr2", Some(mr2)),
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
    let mut borders: Vec<f64> = Vec::new(); // in points
    let mut state: Option<bool> = None; // whether on a hill
    let mut crossings: Option<[f64; 2]> = None;
    let heights = trace.heights();
    for (i, &z) in heights.iter().enumerate() {
        if i > 0 && (heights[i - 1] > 0.0) != (z > 0.0) {
            let before = heights[i - 1];
            let at = (i - 1) as f64 + before / (before - z);
            crossings = Some([crossings.map_or(at, |c| c[0]), at]);
        }
        if low <= z && z <= high {
            continue;
        }
        let now = z > high;
        if let (Some(was), Some([first, last])) = (state.replace(now), crossings)
            && was != now
        {
            borders.push(f64::midpoint(first, last));
        }
        crossings = None;
    }
    // Hills and dales follow each other in turn: borders of one kind are two apart.
    let last = borders.len().checked_sub(1)?;
    let count = last.checked_sub(1).filter(|count| *count > 0)?;
    let [a, b] = [0, 1].map(|first| borders[last - (last - first) % 2] - borders[first]);
    Some((a + b) / count as f64 * trace.spacing())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::close;
    use std::f64::consts::{PI, SQRT_2, TAU};

    fn profile(n: usize, z: impl Fn(f64) -> f64) -> Trace {
        Trace::new(1e-6, (0..n).map(|i| z(i as f64 * 1e-6)).collect()).unwrap()
    }

    /// Height by place (m).
    type Shape<'f> = &'f dyn Fn(f64) -> f64;

    /// Symbol, value, and its relative error; the absolute one of 0.
    type Expected = [(&'static str, f64, f64)];

    /// Five sections of shapes that are known: a sine and a triangle over whole waves; ordinates that count from the mean
    /// line of the filter and not from their own mean, as one high point of 1 in ten of 0 shows; and peaks of 1 to 5, one
    /// in each section over a flat of -1, of whose heights Rz is the mean and Rt the range.
    #[test]
    fn shapes_by_hand() {
        let (a, slope) = (1e-6, 1e-6 / 200e-6);
        let at = |x: f64| (1e6 * x).round() as usize;
        let phase = |x: f64| (x + 0.5e-6).rem_euclid(200e-6) / 200e-6;
        let sine: &Expected = &[
            ("a", 2.0 * a / PI, 2e-4),
            ("q", a / SQRT_2, 1e-9),
            ("z", 2.0 * a, 1e-3),
            ("t", 2.0 * a, 1e-3),
            ("sk", 0.0, 1e-9),
            ("ku", 1.5, 1e-9),
            // Three points at both ends, 1.5 per mille, have no slope of their own.
            ("dq", SQRT_2 * PI * slope, 1.5e-3),
            ("Sm", 200e-6, 1e-6),
        ];
        // Heights spread evenly: a straight material ratio curve.
        let triangle: &Expected = &[
            ("a", a / 2.0, 1e-3),
            ("q", a / 3f64.sqrt(), 1e-3),
            ("ku", 1.8, 1e-3),
            ("dq", 4.0 * slope, 2e-2),
            ("Sm", 200e-6, 1e-6),
            ("k", 2.0 * a, 1e-2),
            ("pk", 0.0, 1e-2 * a),
            ("vk", 0.0, 1e-2 * a),
        ];
        let (rms, skew) = (0.1f64.sqrt() * a, 10f64.sqrt());
        let points: &Expected = &[
            ("p", a, 1e-12),
            ("v", 0.0, 1e-18),
            ("a", 0.1 * a, 1e-12),
            ("q", rms, 1e-12),
            ("sk", skew, 1e-12),
        ];
        let peaks: &Expected = &[("z", 4.0 * a, 1e-12), ("t", 6.0 * a, 1e-12)];
        let shapes: [(Shape<'_>, &Expected); 4] = [
            (&|x| a * (TAU * phase(x)).sin(), sine),
            (&|x| a * (4.0 * (phase(x) - 0.5).abs() - 1.0), triangle),
            (&|x| if at(x) % 10 == 3 { a } else { 0.0 }, points),
            (&|x| if at(x) % 800 == 500 { a * (at(x) / 800 + 1) as f64 } else { -a }, peaks),
        ];
        for (shape, expected) in shapes {
            let found = means(&[profile(4000, shape)], 5, 'R').unwrap();
            for &(symbol, value, error) in expected {
                let found = found.iter().find(|p| p.symbol[1..] == *symbol).unwrap().mean.unwrap();
                let allowed = error * if value > 0.0 { value } else { 1.0 };
                assert!((found - value).abs() <= allowed, "R{symbol}: {found:e}, not {value:e}");
            }
        }
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
        let found = parameters(&Trace::new(1e-6, heights).unwrap(), 5).unwrap();
        let expected = [(1e-6, 1e-9), (0.4e-6, 1e-3), (0.6e-6, 1e-3), (0.08, 1e-4), (0.85, 1e-4)];
        for ((symbol, value), (exact, error)) in found[10..].iter().zip(expected) {
            let found = value.unwrap();
            assert!((found / exact - 1.0).abs() < error, "{symbol}: {found:e}");
        }
    }

    /// Ripples of a twentieth of the wave are no elements; alone they are. Wide dales of 300 um
    /// between hills of 100 um: 400 um, from either kind of border. Half a wave has no element.
    #[test]
    fn an_element_is_a_hill_and_a_dale_above_the_threshold() {
        let wave = |x: f64, length: f64| 1e-6 * (TAU * x / length).sin();
        let ripple = |x: f64| wave(x + 5e-6 / TAU, 5e-6);
        let dale = |x: f64| if (x + 0.5e-6).rem_euclid(400e-6) < 100e-6 { 1e-6 } else { -1e-6 };
        let shapes: [(Shape<'_>, Option<f64>, f64); 6] = [
            (&|x| wave(x, 250e-6) + 0.05 * ripple(x), Some(250e-6), 2e-3),
            (&ripple, Some(5e-6), 1e-2),
            (&dale, Some(400e-6), 1e-9),
            (&|x| dale(4.999e-3 - x), Some(400e-6), 1e-9),
            (&|x| wave(x, 9e-3), None, 0.0),
            (&|_| 0.0, None, 0.0),
        ];
        for (i, (shape, expected, tolerance)) in shapes.into_iter().enumerate() {
            let found = element_width(&profile(5000, shape), 1e-6, 1e-6);
            match (found, expected) {
                (Some(found), Some(expected)) => close(found, expected, tolerance),
                _ => assert_eq!(found, expected, "{i}"),
            }
        }
    }
}
