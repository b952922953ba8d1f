//! Parameters of ISO 21920-2 of one roughness profile.

use super::{Elements, Trace, elements};
use crate::StatsError;
use crate::iso25178::{CoreRoughness, MaterialRatioCurve};

/// Parameters of the evaluated part of a profile (ISO 21920-2:2021): R if it is a roughness
/// profile, P if it is the primary profile.
///
/// Ra, Rq, Rsk, Rku, Rt, Rdq, RSm and the Rk family are of the evaluation length; Rp, Rv and Rz are
/// means over its section lengths. Heights are ordinates of the profile, counted from its mean line: what the
/// filter λc leaves at 0, for P the form that was taken off. The mean over the evaluation length is not subtracted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProfileParameters {
    /// Ra: mean absolute height (m).
    pub mean_abs_height: f64,
    /// Rq: rms height (m).
    pub rms_height: f64,
    /// Rsk (-); absent for a flat profile.
    pub skewness: Option<f64>,
    /// Rku (-); absent for a flat profile.
    pub kurtosis: Option<f64>,
    /// Rp: mean over the sections of the highest peak (m).
    pub peak_height: f64,
    /// Rv: mean over the sections of the deepest pit (m), as a positive number.
    pub pit_depth: f64,
    /// Rz = Rp + Rv: mean over the sections of highest less lowest (m).
    pub max_height: f64,
    /// Rt: highest less lowest of the whole evaluation length (m).
    pub total_height: f64,
    /// Rdq: rms slope by seven-point differences (-).
    pub rms_slope: f64,
    /// RSm and the number of widths; absent if no element is complete.
    pub elements: Option<Elements>,
    /// Rk, Rpk, Rvk, Rmr1, Rmr2.
    pub core: CoreRoughness,
}

impl ProfileParameters {
    /// Of a profile that is `sections` section lengths long.
    ///
    /// # Errors
    /// [`StatsError::TooFewPoints`] if a section has fewer than two points.
    pub(crate) fn of(profile: &Trace, sections: usize) -> Result<Self, StatsError> {
        let n = profile.len();
        if sections == 0 || n < 2 * sections {
            let what = "every section of a profile";
            return Err(StatsError::TooFewPoints { what, needed: 2 * sections.max(1), found: n });
        }
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
        let (peak_height, pit_depth) = (peak / sections as f64, pit / sections as f64);
        Ok(Self {
            mean_abs_height: reach * mean(&f64::abs),
            rms_height: reach * rms,
            skewness: shape(3),
            kurtosis: shape(4),
            peak_height,
            pit_depth,
            max_height: peak_height + pit_depth,
            total_height: high - low,
            rms_slope: rms_slope(profile),
            elements: elements(profile, peak_height, pit_depth),
            core: MaterialRatioCurve::of(profile.as_map())?.core(),
        })
    }

    /// Symbol and value of every parameter, in the order of the standard: lengths in m, slopes and
    /// shares as numbers. `letter` is `R` or `P`.
    pub(crate) fn named(&self, letter: char) -> Vec<(String, Option<f64>)> {
        let core = self.core;
        [
            ("a", Some(self.mean_abs_height)),
            ("q", Some(self.rms_height)),
            ("z", Some(self.max_height)),
            ("p", Some(self.peak_height)),
            ("v", Some(self.pit_depth)),
            ("t", Some(self.total_height)),
            ("sk", self.skewness),
            ("ku", self.kurtosis),
            ("dq", Some(self.rms_slope)),
            ("Sm", self.elements.map(|e| e.mean_width)),
            ("k", Some(core.core_height)),
            ("pk", Some(core.reduced_peak_height)),
            ("vk", Some(core.reduced_valley_depth)),
            ("mr1", Some(core.peak_ratio)),
            ("mr2", Some(core.valley_ratio)),
        ]
        .into_iter()
        .map(|(symbol, value)| (format!("{letter}{symbol}"), value))
        .collect()
    }
}

/// Rms of the seven-point slope `(45 (z4 - z2) - 9 (z5 - z1) + (z6 - z0)) / 60 Δ`, error of order
/// Δ⁶, over the points that are three or more from both ends (ISO 21920-2:2021, annex).
fn rms_slope(profile: &Trace) -> f64 {
    let slope = |z: &[f64]| (45.0 * (z[4] - z[2]) - 9.0 * (z[5] - z[1]) + (z[6] - z[0])) / 60.0;
    let windows = profile.heights().windows(7);
    let count = windows.len() as f64;
    let mean_square = windows.map(|z| slope(z).powi(2)).sum::<f64>() / count;
    mean_square.sqrt() / profile.spacing()
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use std::f64::consts::{PI, SQRT_2, TAU};

    fn profile(n: usize, z: impl Fn(f64) -> f64) -> Trace {
        Trace::new(1e-6, (0..n).map(|i| z(i as f64 * 1e-6)).collect()).unwrap()
    }

    /// A sine over whole waves and five sections: Ra = 2A/π, Rq = A/√2, Rz = Rt = 2A, Rsk = 0,
    /// Rku = 3/2, Rdq = √2 π A/λ, RSm = λ.
    #[test]
    fn a_sine_by_hand() {
        let (a, wavelength) = (1.5e-6, 100e-6);
        let p = profile(4000, |x| a * (TAU * (x + 0.5e-6) / wavelength).sin());
        let r = ProfileParameters::of(&p, 5).unwrap();
        assert_relative_eq!(r.mean_abs_height, 2.0 * a / PI, max_relative = 2e-4);
        assert_relative_eq!(r.rms_height, a / SQRT_2, max_relative = 1e-9);
        assert_relative_eq!(r.max_height, 2.0 * a, max_relative = 1e-3);
        assert_relative_eq!(r.total_height, 2.0 * a, max_relative = 1e-3);
        assert!(r.skewness.unwrap().abs() < 1e-9);
        assert_relative_eq!(r.kurtosis.unwrap(), 1.5, max_relative = 1e-9);
        // Three points at both ends, 1.5 per mille, have no slope of their own.
        assert_relative_eq!(r.rms_slope, SQRT_2 * PI * a / wavelength, max_relative = 1.5e-3);
        assert_relative_eq!(r.elements.unwrap().mean_width, wavelength, max_relative = 1e-6);
    }

    /// Ordinates count from the mean line of the filter, not from their own mean: one high point of 1 in ten of 0 has
    /// Rp = 1, Rv = 0, Ra = 0.1, Rq = √0.1, Rsk = √10; about its own mean it would be 0.9, 0.1, 0.18, 0.3, 2.67.
    #[test]
    fn the_mean_of_the_evaluated_length_stays() {
        let r = ProfileParameters::of(
            &profile(100, |x| if (x * 1e6).round() as u32 % 10 == 3 { 1e-6 } else { 0.0 }),
            5,
        );
        let r = r.unwrap();
        assert_relative_eq!(r.peak_height, 1e-6, max_relative = 1e-12);
        assert!(r.pit_depth.abs() < 1e-18);
        assert_relative_eq!(r.mean_abs_height, 0.1e-6, max_relative = 1e-12);
        assert_relative_eq!(r.rms_height, 0.1f64.sqrt() * 1e-6, max_relative = 1e-12);
        assert_relative_eq!(r.skewness.unwrap(), 10f64.sqrt(), max_relative = 1e-12);
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
        let r = ProfileParameters::of(&profile(4000, z), 5).unwrap();
        assert_relative_eq!(r.mean_abs_height, a / 2.0, max_relative = 1e-3);
        assert_relative_eq!(r.rms_height, a / 3f64.sqrt(), max_relative = 1e-3);
        assert_relative_eq!(r.kurtosis.unwrap(), 1.8, max_relative = 1e-3);
        assert_relative_eq!(r.elements.unwrap().mean_width, wavelength, max_relative = 1e-6);
        assert_relative_eq!(r.core.core_height, 2.0 * a, max_relative = 1e-2);
        assert!(r.core.reduced_peak_height < 1e-2 * a && r.core.reduced_valley_depth < 1e-2 * a);
        assert_relative_eq!(r.rms_slope, 4.0 * a / wavelength, max_relative = 2e-2);
    }

    /// A known Abbott curve, its heights in any order: a core of slope 1 µm between peaks on 10 % and
    /// valleys on 20 %. The line reads Rk = 1 µm; the curve passes its ends at 8 % and 85 %, and the
    /// triangles there are Rpk = 0.4 µm and Rvk = 0.6 µm high.
    #[test]
    fn a_known_abbott_curve_in_any_order() {
        let z =
            |ratio: f64| 1.0 - ratio + 4.0 * (0.1 - ratio).max(0.0) - 3.0 * (ratio - 0.8).max(0.0);
        let n = 20_011; // prime: multiples of 7919 meet every point once
        let heights =
            (0..n).map(|i| 1e-6 * z(f64::from(i * 7919 % n) / f64::from(n - 1))).collect();
        let core = ProfileParameters::of(&Trace::new(1e-6, heights).unwrap(), 5).unwrap().core;
        assert_relative_eq!(core.core_height, 1e-6, max_relative = 1e-9);
        assert_relative_eq!(core.peak_ratio, 0.08, max_relative = 1e-3);
        assert_relative_eq!(core.valley_ratio, 0.85, max_relative = 1e-3);
        assert_relative_eq!(core.reduced_peak_height, 0.4e-6, max_relative = 1e-3);
        assert_relative_eq!(core.reduced_valley_depth, 0.6e-6, max_relative = 1e-3);
    }

    /// Peaks of 1 to 5 µm, one in each of five sections, over a flat of -1 µm: Rz is the mean of the
    /// section heights, Rt the whole range.
    #[test]
    fn sections_are_averaged_and_the_total_is_not() {
        let heights = (0..5000)
            .map(|i| if i % 1000 == 500 { f64::from(i / 1000 + 1) * 1e-6 } else { -1e-6 })
            .collect();
        let r = ProfileParameters::of(&Trace::new(1e-6, heights).unwrap(), 5).unwrap();
        assert_relative_eq!(r.max_height, 4e-6, max_relative = 1e-12);
        assert_relative_eq!(r.total_height, 6e-6, max_relative = 1e-12);
        let named = r.named('R');
        assert_eq!(named[2].0, "Rz");
        assert_eq!(named.len(), 15);
    }
}
