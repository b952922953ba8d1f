//! Profile elements: hills and dales between crossings of the mean line, and their mean width RSm.

use super::Trace;

/// Share of Rp and Rv that a hill and a dale must exceed to count (ISO 21920-3 default).
const THRESHOLD: f64 = 0.1;

/// Profile elements of a trace.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elements {
    /// RSm: mean width (m).
    pub mean_width: f64,
    /// How many widths it is the mean of: hill and dale, and dale and hill.
    pub count: usize,
}

/// Mean width of the profile elements of heights about their mean line, which is 0 here.
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
pub fn elements(trace: &Trace, peak: f64, pit: f64) -> Option<Elements> {
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
    (count > 0)
        .then(|| Elements { mean_width: (rise + fall) / count as f64 * trace.spacing(), count })
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use std::f64::consts::TAU;

    fn of(z: impl Fn(f64) -> f64) -> Option<Elements> {
        let trace = Trace::new(1e-6, (0..5000).map(|i| z(f64::from(i) * 1e-6)).collect()).unwrap();
        elements(&trace, 1e-6, 1e-6)
    }

    #[test]
    fn a_sine_has_its_wavelength() {
        for wavelength in [50e-6, 123.4e-6, 1e-3] {
            let found = of(|x| 1e-6 * (TAU * x / wavelength + 0.3).sin()).unwrap();
            assert_relative_eq!(found.mean_width, wavelength, max_relative = 1e-6);
        }
    }

    /// Ripples of a twentieth of the wave cross the line several times and are no elements.
    #[test]
    fn ripples_below_the_threshold_do_not_count() {
        let wave = |x: f64| 1e-6 * (TAU * x / 250e-6).sin();
        let ripple = |x: f64| 0.05e-6 * (TAU * x / 5e-6 + 1.0).sin();
        let found = of(|x| wave(x) + ripple(x)).unwrap();
        assert_relative_eq!(found.mean_width, 250e-6, max_relative = 2e-3);
        let all = of(|x| 20.0 * ripple(x)).unwrap();
        assert_relative_eq!(all.mean_width, 5e-6, max_relative = 1e-2);
    }

    /// Wide dales of 300 um between hills of 100 um: the elements are 400 um wide, counted from
    /// either kind of border; walked backwards it is the same.
    #[test]
    fn an_element_is_a_hill_and_a_dale_in_either_direction() {
        let z = |x: f64| if (x + 0.5e-6).rem_euclid(400e-6) < 100e-6 { 1e-6 } else { -1e-6 };
        let found = of(z).unwrap();
        assert_relative_eq!(found.mean_width, 400e-6, max_relative = 1e-9);
        let back = of(|x| z(4.999e-3 - x)).unwrap();
        assert_relative_eq!(back.mean_width, found.mean_width, max_relative = 1e-9);
    }

    #[test]
    fn half_a_wave_has_no_element() {
        assert_eq!(of(|x| 1e-6 * (TAU * x / 9e-3).sin()), None);
        assert_eq!(of(|_| 0.0), None);
    }
}
