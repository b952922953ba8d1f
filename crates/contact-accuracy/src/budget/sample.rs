//! Error of one map as a sample of its surface: how far another map, measured beside it, would
//! scatter.
//!
//! *Area.* The solution itself is cut into blocks. A block carries the load `l` and has the area
//! `a`; at a given load on all of them only what `a` varies at given `l` is left, since the loads
//! of the blocks add up to the one prescribed. That is the regression estimator of survey sampling
//! (Cochran 1977, *Sampling Techniques*, ch. 7): with the residuals `e` of the line through
//! `(l, a)`, the standard error of the mean area is `s_e / sqrt(n)`, on `n - 2` degrees of
//! freedom. Waves longer than a block, which move whole blocks up and down, change their loads and
//! drop out; a plain scatter of block areas would count them.
//!
//! *Gap and stiffness* follow the longest waves, which no part of a map samples: they scatter with
//! the rms height. The variance of the mean of `h²` over a map is the power of `h²` at long waves,
//! and is found in two ways, of which the larger counts. If the amplitudes of the waves are
//! independent and normal it is `sum S²`, S the power of each wave of the plane: the relative
//! scatter of the rms height is then `½ sqrt(sum S²) / sum S`. If they are not, where a surface is
//! rougher in some places than in others, it is still what the longest waves of `h²` itself show.
//! Waves of height longer than the map are in none of these.

use contact_types::{Grid, HeightMap};
use std::f64::consts::TAU;
use surface_stats::spectrum::PowerSpectrum;

/// Blocks along each side.
pub const PARTS: usize = 8;

/// Logarithm of the 95 % ratio over the standard errors of area by blocks, of rms height and of rms
/// gradient, whose squares add.
const AREA: [f64; 3] = [3.2, 0.5, 2.0];
/// The same of a map whose edges do not match: long waves make a step of another height at the seam
/// of every map, which carries a part of a light load.
const AREA_AT_SEAM: [f64; 3] = [3.2, 2.5, 2.0];
/// The same of the gap, which follows the rms height alone.
const GAP: f64 = 3.0;
/// The same of a map whose edges do not match, which holds few of its longest waves.
const GAP_AT_SEAM: f64 = 4.0;
/// The same of the stiffness, of area and rms height: of what carries, and of the heights it closes
/// over.
const STIFFNESS: [f64; 2] = [4.5, 2.7];

/// What the heights of a map say about other maps of the same surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scatter {
    /// Relative standard error of the rms height.
    pub height: f64,
    /// The same of the rms gradient.
    pub gradient: f64,
    /// Whether the edges of the map match.
    pub repeats: bool,
}

impl Scatter {
    /// Of a `surface`, with its spectrum, under a window unless it `repeats`.
    pub fn of(surface: &HeightMap, power: &PowerSpectrum, repeats: bool) -> Self {
        let height = height_scatter(surface, power);
        Self { height, gradient: gradient_scatter(surface), repeats }
    }

    /// Relative 95 % half width of the area over maps of the same surface. Half widths are those of
    /// the upper end: a map that has little of something says of the others by which factor they
    /// may have more.
    pub fn area_half_width(self, area_scatter: f64) -> f64 {
        let [area, height, gradient] = if self.repeats { AREA } else { AREA_AT_SEAM };
        let heights = (height * doubted(self.height)).hypot(gradient * self.gradient);
        (area * area_scatter).hypot(heights).exp_m1()
    }

    /// The same of the stiffness.
    pub fn stiffness_half_width(self, area_scatter: f64) -> f64 {
        let [area, height] = STIFFNESS;
        (area * area_scatter).hypot(height * doubted(self.height)).exp_m1()
    }

    /// The same of the mean gap.
    pub fn gap_half_width(self) -> f64 {
        let part = if self.repeats { GAP } else { GAP_AT_SEAM };
        (part * doubted(self.height)).exp_m1()
    }
}

/// The scatter `h` of the rms height, widened because it is itself found from few waves where it is
/// large: by Student's quantile over the normal one at 97.5 %, in its expansion for many degrees of
/// freedom `ν` (Abramowitz & Stegun 26.7.5), `1 + 1.21/ν + 1.44/ν²`. `h = ½/√N` means `N = 1/(4h²)`
/// waves of equal weight, half of them independent: `ν = 1/(8h²)`.
fn doubted(height_scatter: f64) -> f64 {
    let one_over_freedom = 8.0 * height_scatter * height_scatter;
    height_scatter * (1.0 + one_over_freedom * (1.21 + one_over_freedom * 1.44))
}

/// Relative standard error of the area by the residuals of a line through load and area of `parts`
/// by `parts` blocks; `None` if nothing touches, the field is not of this grid, fewer than 4 blocks
/// are asked for, or a block has no pixel.
pub fn area_scatter(pressure: &[f64], grid: Grid, parts: usize) -> Option<f64> {
    let [ny, nx] = grid.shape();
    if pressure.len() != grid.len() || ny.min(nx) < parts || parts < 2 {
        return None;
    }
    let mut blocks = vec![[0.0; 3]; parts * parts]; // points, touching, load
    for (i, &p) in pressure.iter().enumerate() {
        let block = &mut blocks[(i / nx) * parts / ny * parts + (i % nx) * parts / nx];
        block[0] += 1.0;
        if p > 0.0 {
            block[1] += 1.0;
            block[2] += p;
        }
    }
    let points: Vec<[f64; 2]> = blocks.iter().map(|b| [b[2] / b[0], b[1] / b[0]]).collect();
    let n = points.len() as f64;
    let mean = [0, 1].map(|k| points.iter().map(|p| p[k]).sum::<f64>() / n);
    let moment = |i: usize, j: usize| -> f64 {
        points.iter().map(|p| (p[i] - mean[i]) * (p[j] - mean[j])).sum()
    };
    if mean[1] <= 0.0 {
        return None;
    }
    let explained = if moment(0, 0) > 0.0 { moment(0, 1).powi(2) / moment(0, 0) } else { 0.0 };
    let residual = (moment(1, 1) - explained).max(0.0) / (n - 2.0);
    Some((residual / n).sqrt() / mean[1])
}

/// Relative standard error of the rms height over maps of the same surface; `power` is the spectrum
/// of `surface`, under a window if its edges do not match.
pub fn height_scatter(surface: &HeightMap, power: &PowerSpectrum) -> f64 {
    scatter_by_waves(power).max(scatter_by_squares(surface))
}

/// The same from the waves of the map, taken as independent and normal.
fn scatter_by_waves(power: &PowerSpectrum) -> f64 {
    let (mut sum, mut squares) = (0.0, 0.0);
    power.for_each(|_, weight, variance| {
        sum += weight * variance;
        squares += weight * variance * variance;
    });
    if sum > 0.0 { 0.5 * squares.sqrt() / sum } else { 0.0 }
}

/// Waves that stand for the long end of a spectrum, by direction: periods over the map along y and
/// x. It is flat there, so that edges which do not match need no window.
const LONGEST: [[[i32; 2]; 2]; 4] =
    [[[0, 1], [0, 2]], [[1, 0], [2, 0]], [[1, 1], [2, 2]], [[-1, 1], [-2, 2]]];

/// The same from the power of the longest waves of the squared heights.
fn scatter_by_squares(surface: &HeightMap) -> f64 {
    let mean = surface.mean();
    let nx = surface.grid().shape()[1];
    0.5 * scatter_of_mean(surface.grid().shape(), |iy, row| {
        let heights = &surface.heights()[iy * nx..][..nx];
        row.iter_mut().zip(heights).for_each(|(y, h)| *y = (h - mean).powi(2));
    })
}

/// Relative standard error of the rms gradient over maps of the same surface: a light load is carried
/// on an area as 1/h'rms. From the longest waves of the squared differences between neighbours,
/// without those across the edges.
pub fn gradient_scatter(surface: &HeightMap) -> f64 {
    let [ny, nx] = surface.grid().shape();
    let [dy, dx] = surface.grid().pixel();
    0.5 * scatter_of_mean([ny, nx], |iy, row| {
        let below = if iy + 1 < ny { iy + 1 } else { iy };
        for (ix, y) in row.iter_mut().enumerate() {
            let right = if ix + 1 < nx { ix + 1 } else { ix };
            let here = surface.at(iy, ix);
            let slopes = [(surface.at(below, ix) - here) / dy, (surface.at(iy, right) - here) / dx];
            *y = slopes[0] * slopes[0] + slopes[1] * slopes[1];
        }
    })
}

/// Relative standard error of the mean of a field that is not negative, given row by row: from the
/// power at its longest waves, in the direction where it is largest. Scratches that cross a map are
/// as few as they are in one direction, whatever the others show.
fn scatter_of_mean([ny, nx]: [usize; 2], fill: impl Fn(usize, &mut [f64])) -> f64 {
    let turns = |k: i32, n: usize| -> Vec<(f64, f64)> {
        (0..n).map(|i| (f64::from(k) * TAU * i as f64 / n as f64).sin_cos()).collect()
    };
    let turns_along = [0, 1, 2].map(|kx| turns(kx, nx));
    // Sums of y exp(i q x) over the map, along x first.
    let mut sums = [[[0.0; 2]; 2]; 4];
    let (mut row, mut total) = (vec![0.0; nx], 0.0);
    for iy in 0..ny {
        fill(iy, &mut row);
        total += row.iter().sum::<f64>();
        let along = [0, 1, 2].map(|kx: usize| {
            let terms = row.iter().zip(&turns_along[kx]);
            terms.fold([0.0; 2], |[re, im], (y, (sin, cos))| [re + y * cos, im + y * sin])
        });
        for (sum, [ky, kx]) in sums.as_flattened_mut().iter_mut().zip(LONGEST.as_flattened()) {
            let (sin, cos) = (f64::from(*ky) * TAU * iy as f64 / ny as f64).sin_cos();
            let [re, im] = along[*kx as usize];
            sum[0] += re * cos - im * sin;
            sum[1] += re * sin + im * cos;
        }
    }
    if total <= 0.0 {
        return 0.0;
    }
    // A profile has no waves across.
    let fits = |[ky, kx]: &[i32; 2]| (*ky == 0 || ny > 4) && (*kx == 0 || nx > 4);
    let along = |direction: usize| -> f64 {
        let pairs = sums[direction].iter().zip(&LONGEST[direction]);
        let power = pairs.filter(|(_, wave)| fits(wave)).map(|([re, im], _)| re * re + im * im);
        power.sum::<f64>() / 2.0
    };
    (0..4).map(along).fold(0.0, f64::max).sqrt() / total
}

#[cfg(test)]
mod tests {
    use super::*;
    use contact_types::HeightMap;
    use std::f64::consts::TAU;
    use surface_stats::spectrum::Window;

    /// Areas in proportion to the loads of the blocks leave no residual; one block with too much
    /// area leaves the residual of a line through four points, by hand.
    #[test]
    fn residuals_of_a_line_through_the_blocks() {
        let grid = Grid::new([8, 8], [1.0, 1.0]).unwrap();
        // Blocks of 4 x 4 points: 2, 4, 6, 8 touching points of pressure 1.
        let field = |counts: [usize; 4], pressures: [f64; 4]| -> Vec<f64> {
            (0..64)
                .map(|i| {
                    let (iy, ix) = (i / 8, i % 8);
                    let block = iy / 4 * 2 + ix / 4;
                    let place = iy % 4 * 4 + ix % 4;
                    if place < counts[block] { pressures[block] } else { 0.0 }
                })
                .collect()
        };
        let even = area_scatter(&field([2, 4, 6, 8], [1.0; 4]), grid, 2).unwrap();
        assert!(even < 1e-7, "{even:e}");
        // l = 2, 4, 6, 8 but a = 2, 4, 6, 12 sixteenths: line 6 + 1.6 (l - 5), residuals
        // 0.8, -0.4, -1.6, 1.2; s² = 4.8 / 2, mean 6: sqrt(2.4 / 4) / 6.
        let uneven = area_scatter(&field([2, 4, 6, 12], [1.0, 1.0, 1.0, 8.0 / 12.0]), grid, 2);
        assert!((uneven.unwrap() - 0.6f64.sqrt() / 6.0).abs() < 1e-12);
        assert_eq!(area_scatter(&[0.0; 64], grid, 2), None);
        assert_eq!(area_scatter(&[1.0; 63], grid, 2), None);
    }

    /// Student's quantile at 97.5 % is 2.228 for 10 degrees of freedom and 2.776 for 4.
    #[test]
    fn few_waves_widen_like_students_quantile() {
        for (freedom, quantile) in [(10.0_f64, 2.228), (4.0, 2.776)] {
            let h = (1.0 / (8.0 * freedom)).sqrt();
            let ratio = doubted(h) / h;
            assert!((ratio - quantile / 1.95996).abs() < 0.03, "{ratio}");
        }
    }

    /// n waves of equal amplitude, all along x, with q and -q: the variance of each is known to
    /// 100 %, so that of the sum to 1/sqrt(n), and the rms to half of that... over both halves of
    /// the plane, of which one repeats the other, by sqrt(2) less.
    #[test]
    fn scatter_of_equal_waves_is_known() {
        let grid = Grid::new([16, 64], [1.0, 1.0]).unwrap();
        let wave = |k: f64, x: f64| (TAU * k * x / 64.0 + k * k).cos();
        let map =
            HeightMap::from_fn(grid, |_, x| (3..12).map(|k| wave(f64::from(k), x)).sum()).unwrap();
        let height = scatter_by_waves(&PowerSpectrum::of(&map, Window::None).unwrap());
        assert!((height - 0.5 / 18f64.sqrt()).abs() < 1e-9, "{height}");
    }

    /// Where one half of a map is rougher than the other, `h²` is a square wave: `h² = 2.5 ± 1.5`
    /// times a fine wave of mean 1, whose first harmonic has the amplitude `1.5 4/π` and the second
    /// none: along x the mean power of the two waves is that of half its amplitude squared, half.
    #[test]
    fn rough_and_smooth_halves_scatter_as_their_squares_do() {
        let grid = Grid::new([64, 4096], [1.0, 1.0]).unwrap();
        let rough = |ix: usize| if ix < 2048 { 2.0 } else { 1.0 };
        let sign = |iy: usize, ix: usize| if (iy + ix).is_multiple_of(2) { 1.0 } else { -1.0 };
        let heights = (0..64 * 4096).map(|i| rough(i % 4096) * sign(i / 4096, i)).collect();
        let map = HeightMap::new(grid, heights).unwrap();
        let found = scatter_by_squares(&map);
        let amplitude = 1.5 * 4.0 / std::f64::consts::PI;
        let expected = 0.5 * (amplitude * amplitude / 4.0 / 2.0).sqrt() / 2.5;
        assert!((found / expected - 1.0).abs() < 1e-3, "{found} {expected}");
        // Differences are twice the heights: their squares scatter alike, but for the last column.
        assert!((gradient_scatter(&map) / expected - 1.0).abs() < 2e-2);
        let power = PowerSpectrum::of(&map, Window::None).unwrap();
        assert!(height_scatter(&map, &power) >= found);
    }

    /// Of Gaussian maps both ways say the same, but for the chance in the largest of four directions
    /// of two waves: the largest of four means of two exponential variables is 1.9 in the mean.
    #[test]
    fn both_ways_agree_on_gaussian_maps() {
        use surface_stats::synthesis::{Scale, SelfAffine};
        let mut sums = [0.0; 2];
        for seed in 1..=20 {
            let recipe = SelfAffine {
                grid: Grid::new([128, 96], [1.0, 1.0]).unwrap(),
                hurst: 0.7,
                rolloff: 16.0,
                cutoff: 4.0,
                scale: Scale::ExpectedRmsGradient(0.1),
                seed,
                quantise: None,
            };
            let map = recipe.generate().unwrap();
            let power = PowerSpectrum::of(&map, Window::None).unwrap();
            sums[0] += scatter_by_waves(&power).powi(2);
            sums[1] += scatter_by_squares(&map).powi(2);
        }
        // It varies by 0.6 of one from map to map, over 20 maps by 0.14.
        assert!((sums[1] / sums[0] - 1.9).abs() < 0.5, "{sums:?}");
    }
}
