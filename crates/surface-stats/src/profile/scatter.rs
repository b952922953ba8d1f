//! How far the moments of another trace of the same surface would scatter.
//!
//! A moment is the mean of a square (of height, slope, second difference) over a finite length. Of three estimates of the
//! variance of that mean the largest counts: of independent, normal waves the sum of the squares of their powers; of a
//! surface rougher in some places than in others what the longest waves of the squares show; the scatter of several traces
//! over the root of their number.

use super::Trace;
use crate::spectrum::psd_1d;
use contact_types::SpectralMoments;
use std::f64::consts::TAU;

/// Waves along the trace that stand for the long end of the spectrum of the squares.
const LONGEST: usize = 4;
/// Pieces of a trace whose moments tell how m0, m2 and m4 vary together.
const PIECES: usize = 16;

/// Scatter of m0, m2, m4, in that order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct MomentScatter {
    /// Variance of each relative to its square (-), of the mean over all traces.
    relative_variance: [f64; 3],
    /// How they vary together (-1 to 1).
    correlation: [[f64; 3]; 3],
    /// Degrees of freedom of each variance.
    freedom: [f64; 3],
    /// Relative standard deviation from trace to trace, of two or more.
    pub(super) between: Option<[f64; 3]>,
}

/// Two-sided 95 % quantile of Student's t for `freedom` degrees of freedom, by its expansion about
/// the normal one (Abramowitz & Stegun 26.7.5); `None` below 2, where it means nothing.
fn students_t(freedom: f64) -> Option<f64> {
    const Z: f64 = 1.959_963_984_540_054;
    if freedom.is_nan() || freedom < 2.0 {
        return None;
    }
    let g1 = (Z.powi(3) + Z) / 4.0;
    let g2 = (5.0 * Z.powi(5) + 16.0 * Z.powi(3) + 3.0 * Z) / 96.0;
    let g3 = (3.0 * Z.powi(7) + 19.0 * Z.powi(5) + 17.0 * Z.powi(3) - 15.0 * Z) / 384.0;
    let y = 1.0 / freedom;
    Some(Z + y * (g1 + y * (g2 + y * g3)))
}

impl MomentScatter {
    /// Of levelled traces with these moments.
    pub(super) fn of(traces: &[Trace], moments: &[SpectralMoments]) -> Self {
        let n = traces.len() as f64;
        let mut variance = [0.0; 3];
        let mut freedom = [0.0; 3];
        let mut products = [[0.0; 3]; 3];
        for trace in traces {
            let squares = squares(trace);
            let by_waves = by_waves(trace);
            for k in 0..3 {
                let one = by_waves[k].max(by_squares(&squares[k]));
                variance[k] += one / (n * n);
                freedom[k] += if one > 0.0 { 2.0 / one } else { f64::INFINITY };
            }
            add_products(&squares, &mut products);
        }
        let between = (traces.len() > 1).then(|| between(moments));
        if let Some(between) = between {
            for k in 0..3 {
                variance[k] = variance[k].max(between[k] * between[k] / n);
                freedom[k] += n - 1.0;
            }
        }
        let correlation = [0, 1, 2].map(|i| {
            [0, 1, 2].map(|j: usize| match (products[i][i] * products[j][j]).sqrt() {
                _ if i == j => 1.0,
                norm if norm > 0.0 => products[i][j] / norm,
                _ => 0.0,
            })
        });
        Self { relative_variance: variance, correlation, freedom, between }
    }

    /// 95 % interval of the k-th of m0, m2, m4; `None` where the traces hold too few independent waves to tell.
    pub(super) fn interval(&self, moment: usize, value: f64) -> Option<[f64; 2]> {
        let factor = factor(self.relative_variance[moment], self.freedom[moment])?;
        Some([value / factor, value * factor])
    }

    /// As [`ProfileStatistics::factor_of`](super::ProfileStatistics::factor_of).
    pub(super) fn factor_of(&self, exponents: [f64; 3]) -> Option<f64> {
        let sigma = self.relative_variance.map(f64::sqrt);
        let mut variance = 0.0;
        for i in 0..3 {
            for j in 0..3 {
                let parts = exponents[i] * sigma[i] * exponents[j] * sigma[j];
                variance += parts * self.correlation[i][j];
            }
        }
        // The least known of those that matter.
        let matters = |k: &usize| exponents[*k].abs() * sigma[*k] > 0.1 * variance.max(0.0).sqrt();
        let freedom = (0..3).filter(matters).map(|k| self.freedom[k]).fold(f64::INFINITY, f64::min);
        factor(variance.max(0.0), freedom)
    }
}

/// The 95 % factor of a quantity whose logarithm has this variance.
fn factor(variance: f64, freedom: f64) -> Option<f64> {
    let factor = (students_t(freedom)? * variance.sqrt()).exp();
    factor.is_finite().then_some(factor)
}

/// Squares of heights, slopes and second differences along a trace, without units.
fn squares(trace: &Trace) -> [Vec<f64>; 3] {
    let z = trace.heights();
    let mean = z.iter().sum::<f64>() / z.len() as f64;
    let reach = z.iter().map(|z| (z - mean).abs()).fold(0.0, f64::max);
    let scale = if reach > 0.0 { 1.0 / reach } else { 1.0 };
    let square = |x: f64| (scale * x) * (scale * x);
    [
        z.iter().map(|z| square(z - mean)).collect(),
        z.windows(2).map(|z| square(z[1] - z[0])).collect(),
        z.windows(3).map(|z| square(z[2] - z[1] - (z[1] - z[0]))).collect(),
    ]
}

/// Relative variances of the means if the waves are independent and normal: of a wave with the
/// observed power P the squared expected power is P²/2 on average.
fn by_waves(trace: &Trace) -> [f64; 3] {
    let bins = psd_1d(trace);
    let mut sums = [[0.0; 2]; 3];
    let largest = bins.iter().map(|b| b.psd).fold(0.0, f64::max);
    if largest <= 0.0 {
        return [0.0; 3];
    }
    for bin in &bins {
        // The same power in slopes and second differences, as neighbouring points see it.
        let read = (2.0 * (0.5 * TAU * bin.frequency * trace.spacing()).sin()).powi(2);
        let mut power = bin.psd / largest;
        for sum in &mut sums {
            sum[0] += power;
            sum[1] += power * power;
            power *= read;
        }
    }
    sums.map(|[sum, squares]| if sum > 0.0 { 0.5 * squares / (sum * sum) } else { 0.0 })
}

/// The same from the longest waves of the squares themselves.
fn by_squares(squares: &[f64]) -> f64 {
    let n = squares.len() as f64;
    let mean = squares.iter().sum::<f64>() / n;
    if mean <= 0.0 {
        return 0.0;
    }
    let mut power = 0.0;
    for k in 1..=LONGEST {
        let turn = TAU * k as f64 / n;
        let [re, im] = squares.iter().enumerate().fold([0.0; 2], |[re, im], (i, y)| {
            let (sin, cos) = (turn * i as f64).sin_cos();
            [re + (y - mean) * cos, im + (y - mean) * sin]
        });
        power += re * re + im * im;
    }
    power / LONGEST as f64 / (n * mean).powi(2)
}

/// Adds the products of the deviations of the means of pieces, relative to the mean of all.
fn add_products(squares: &[Vec<f64>; 3], products: &mut [[f64; 3]; 3]) {
    let mean = |y: &[f64]| y.iter().sum::<f64>() / y.len().max(1) as f64;
    let all = [0, 1, 2].map(|k| mean(&squares[k]));
    if all.iter().any(|m| *m <= 0.0) {
        return;
    }
    for piece in 0..PIECES {
        let deviation = [0, 1, 2].map(|k| {
            let n = squares[k].len();
            mean(&squares[k][piece * n / PIECES..(piece + 1) * n / PIECES]) / all[k] - 1.0
        });
        for i in 0..3 {
            for j in 0..3 {
                products[i][j] += deviation[i] * deviation[j];
            }
        }
    }
}

/// Relative standard deviations of the moments from trace to trace.
fn between(moments: &[SpectralMoments]) -> [f64; 3] {
    let n = moments.len() as f64;
    let each = moments.iter().map(|m| [m.m0, m.m2, m.m4]);
    [0, 1, 2].map(|k| {
        let mean = each.clone().map(|m| m[k]).sum::<f64>() / n;
        let square = |m: [f64; 3]| if mean > 0.0 { (m[k] / mean - 1.0).powi(2) } else { 0.0 };
        (each.clone().map(square).sum::<f64>() / (n - 1.0)).sqrt()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::profile::moments;
    use crate::synthesis::rough;
    use contact_types::Grid;

    #[test]
    fn students_t_is_that_of_tables() {
        for (freedom, t) in [(4.0, 2.776), (10.0, 2.228), (30.0, 2.042), (1e9, 1.960)] {
            assert!((students_t(freedom).unwrap() / t - 1.0).abs() < 3e-3, "{freedom}");
        }
        assert_eq!(students_t(1.0), None);
    }

    /// Rows that are independent, half as long as the map; the truth is the mean over all. Nine in
    /// ten hold it, and they are no wider than thrice what the rows scatter.
    #[test]
    fn intervals_hold_the_truth() {
        let mut all = Vec::new();
        for seed in 0..12 {
            let grid = Grid::new([512, 1024], [1e-6, 1e-6]).unwrap();
            let map = rough(grid, 0.8, [32e-6, 4e-6], 1e-6, seed);
            for iy in (0..512).step_by(32) {
                let row = map.heights()[iy * 1024..iy * 1024 + 512].to_vec();
                all.push(Trace::new(1e-6, row).unwrap());
            }
        }
        let moments: Vec<SpectralMoments> = all.iter().map(moments).collect();
        let each: Vec<[f64; 3]> = moments.iter().map(|m| [m.m0, m.m2, m.m4]).collect();
        let count = each.len() as f64;
        for k in 0..3 {
            let truth = each.iter().map(|m| m[k]).sum::<f64>() / count;
            let spread =
                (each.iter().map(|m| (m[k] / truth - 1.0).powi(2)).sum::<f64>() / count).sqrt();
            // One trace, and four together.
            for size in [1, 4] {
                let (mut held, mut width) = (0.0, 0.0);
                let sets = all.chunks(size).zip(moments.chunks(size));
                for ((traces, moments), m) in sets.zip(each.chunks(size)) {
                    let mean = m.iter().map(|m| m[k]).sum::<f64>() / size as f64;
                    let scatter = MomentScatter::of(traces, moments);
                    let [low, high] = scatter.interval(k, mean).unwrap();
                    held += f64::from(u8::from(low <= truth && truth <= high));
                    width += (high / low).ln() / 2.0;
                }
                let sets = count / size as f64;
                assert!(held / sets >= 0.9, "m{}: {held} of {sets}", 2 * k);
                let is_narrow = width / sets < 3.0 * 2.0 * spread;
                assert!(is_narrow || size > 1, "m{}: {width} {spread}", 2 * k);
            }
        }
    }

    /// One half of a trace is rough, the other smooth: the squares show it, the waves do not.
    #[test]
    fn rough_and_smooth_halves_are_seen_in_the_squares() {
        let sign = |i: usize| if i.is_multiple_of(2) { 1.0 } else { -1.0 };
        let rough = |i: usize| if i < 2048 { 2.0 } else { 1.0 };
        let trace = Trace::new(1.0, (0..4096).map(|i| rough(i) * sign(i)).collect()).unwrap();
        let found = by_squares(&squares(&trace)[0]);
        // h² = 2.5 ± 1.5: first and third harmonics 1.5 (2/π) and a third of that, two are none.
        let amplitude = 1.5 * 2.0 / std::f64::consts::PI;
        let expected = amplitude * amplitude * (1.0 + 1.0 / 9.0) / 4.0 / 6.25;
        assert!((found / expected - 1.0).abs() < 0.01, "{found} {expected}");
        let scatter = MomentScatter::of(&[trace], &[]);
        assert!(scatter.relative_variance[0] >= found && scatter.correlation[0][1] > 0.9);
    }

    #[test]
    fn a_single_wave_tells_nothing_of_another_trace() {
        let z = |i: i32| (TAU * f64::from(i) / 400.0).sin();
        let trace = Trace::new(1.0, (0..400).map(z).collect()).unwrap();
        let scatter = MomentScatter::of(&[trace], &[]);
        assert!(scatter.interval(0, 1.0).is_none_or(|[low, high]| high / low > 4.0));
    }
}
