//! The height step of data stored as integers or in single precision.

/// Heights looked at; enough to see a step, few enough to sort at no cost.
const SAMPLE: usize = 30_000;
/// Spacing of the numbers themselves over the range of the heights from which it counts as a step.
const COARSE: f64 = 1e-3;

/// The step that all heights are multiples of (from the lowest), or `None` if there is none.
///
/// Sorted distinct heights must lie whole multiples of one distance apart, each to
/// 5 % of it; with four heights or more, some of them repeated, or sixteen or more, this does not
/// happen by chance. NaN is skipped. Heights so far from zero that double precision rounds them by
/// more than a thousandth of their range have its spacing for a step.
pub fn height_step(heights: &[f64]) -> Option<f64> {
    let stride = heights.len().div_ceil(SAMPLE).max(1);
    let sample = heights.iter().step_by(stride).copied();
    let mut sample: Vec<f64> = sample.filter(|h| h.is_finite()).collect();
    sample.sort_unstable_by(f64::total_cmp);
    let points = sample.len();
    // Two computations of one integer may differ in the last bits.
    let magnitude = sample.first()?.abs().max(sample.last()?.abs());
    let rounding = 2.0 * f64::EPSILON * magnitude;
    // Far from zero, the numbers themselves come in steps.
    let spacing = f64::EPSILON * magnitude;
    if spacing > COARSE * (sample.last()? - sample.first()?) && sample.last()? > sample.first()? {
        return Some(spacing);
    }
    sample.dedup_by(|b, a| *b - *a <= rounding);
    let distinct = sample.len();
    if distinct < 4 || (distinct < 16 && 2 * distinct > points) {
        return None;
    }
    let gaps = || sample.windows(2).map(|z| z[1] - z[0]);
    let smallest = gaps().fold(f64::INFINITY, f64::min);
    // The average of a step over the gaps of fewer than `most`, by a first guess of it.
    let average = |guess: f64, most: f64| {
        let near = || gaps().filter(move |gap| *gap < most * guess);
        let whole = |n: f64| ((n - n.round()).abs() <= 0.05 + 0.01 * n).then(|| n.round());
        let steps: Option<f64> = near().map(|gap| whole(gap / guess)).sum();
        Some(near().sum::<f64>() / steps?)
    };
    // Over few steps first: the error of a guess grows with the gap.
    let step = average(average(smallest, 8.0)?, f64::INFINITY)?;
    let fits = |gap: f64| (gap / step - (gap / step).round()).abs() <= 0.05;
    (gaps().all(fits) && step > rounding).then_some(step)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::close;

    fn wavy(n: usize) -> impl Iterator<Item = f64> {
        (0..n).map(|i| 1e-6 * ((i as f64 * 0.37).sin() + 0.6 * (i as f64 * 0.011).cos()))
    }

    #[test]
    fn finds_steps_with_and_without_offset_and_those_of_single_precision() {
        for offset in [0.0, 76e-3, -1.0] {
            let stepped: Vec<f64> =
                wavy(20_000).map(|h| offset + (h / 10e-9).round() * 10e-9).collect();
            close(height_step(&stepped).unwrap(), 10e-9, 1e-6);
        }
        let stored: Vec<f64> = wavy(20_000).map(|h| f64::from((76e-3 + h) as f32)).collect();
        close(height_step(&stored).unwrap(), 0.0625 / 8388608.0, 1e-9);
    }

    /// Numbers near 1e9 are 2^-23 apart.
    #[test]
    fn an_offset_that_rounds_the_heights_makes_steps() {
        let far: Vec<f64> = wavy(20_000).map(|h| 1e9 + h).collect();
        let step = height_step(&far).unwrap();
        assert!((0.5f64.powi(23)..=0.5f64.powi(22)).contains(&step), "{step:e}");
        assert_eq!(height_step(&wavy(20_000).map(|h| 1e3 + h).collect::<Vec<_>>()), None);
    }

    #[test]
    fn continuous_flat_and_tiny_maps_have_none() {
        let none: [&[f64]; 4] = [&[0.5; 100], &[0.0, 1.0, f64::NAN], &[f64::NAN], &[]];
        for heights in none.into_iter().chain([&*wavy(20_000).collect::<Vec<_>>()]) {
            assert_eq!(height_step(heights), None);
        }
    }
}
