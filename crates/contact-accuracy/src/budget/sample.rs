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
//! Waves of height longer than the map are in none of these: on a map that does not repeat, which is a
//! part of a larger surface, more is added for them. Marks that run across a map, such as scratches, scatter more
//! than both ways say (`lines.rs`).
//!
//! Where few blocks carry the load, Student's quantile widens what they say of the area, and near full
//! contact the gap follows the rms height with more than the first power.

use super::lines::scatter_by_lines;
use contact_types::{Grid, HeightMap};
use std::f64::consts::TAU;
use surface_stats::spectrum::PowerSpectrum;

/// Blocks along each side.
pub const PARTS: usize = 8;

/// 95 % half width over the standard errors of area by blocks and of rms height, whose squares
/// add, and the second on a map that does not repeat.
const AREA: [f64; 3] = [3.0, 0.5, 1.5];
/// The same of the gap, which follows the rms height alone.
const GAP: [f64; 2] = [3.4, 4.2];
/// The same of the stiffness: of the area that carries, and of the heights it closes over.
const STIFFNESS: [f64; 3] = [4.2, 3.0, 3.6];
/// The same of the area over that of the rms gradient by marks across the map.
const MARKS: f64 = 4.5;
/// Standard error of the area of one block, where one carries everything.
const ONE_BLOCK: f64 = 0.3;
/// 95 % half width of the gap, where one block carries everything.
const ONE_BLOCK_GAP: f64 = 0.5;
/// Over √(1 − A²), the part of the scatter of the area that is left near full contact, at most all of it.
const FULL: f64 = 8.0;
/// Fall of the gap per e-fold load over the gap, with 1 for the height itself, up to which the gap follows the
/// rms height with the first power.
const LIGHT: f64 = 1.7;
/// Most of that fall that counts.
const STEEPEST: f64 = 20.0;

/// What one solution on one map says of other maps of the same surface. Half widths are relative
/// and 95 %.
///
/// Numbers that are known to a large factor scatter more to the upper side than to the lower, as
/// counts of few things do: half widths are those of the upper side.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Sampled {
    /// Blocks of the solution.
    pub blocks: Blocks,
    /// Corrected area fraction \[-\].
    pub area: f64,
    /// Fall of the gap per e-fold load, over the gap \[-\].
    pub fall: f64,
    /// Relative standard error of the rms height.
    pub height: f64,
    /// The same of the rms gradient by marks across the map; 0 where there are none.
    pub marks: f64,
    /// Whether the map repeats. If not it is a part of a larger surface, whose longest waves it
    /// does not hold.
    pub repeats: bool,
}

impl Sampled {
    /// Of the area.
    pub fn area_half_width(&self) -> f64 {
        let height = AREA[1 + usize::from(!self.repeats)] * doubted(self.height);
        // Near full contact the area hardly follows the slopes any more.
        let marks = MARKS * self.marks * (1.0 - self.area * self.area).max(0.0).sqrt();
        // It ends at full contact, where it cannot vary.
        let left = (FULL * (1.0 - self.area * self.area).max(0.0).sqrt()).min(1.0);
        left * upper((AREA[0] * self.blocks()).hypot(height).hypot(marks))
    }

    /// Of the stiffness.
    pub fn stiffness_half_width(&self) -> f64 {
        let height = STIFFNESS[1 + usize::from(!self.repeats)] * doubted(self.height);
        upper((STIFFNESS[0] * self.blocks()).hypot(height * self.closing()))
    }

    /// Of the mean gap.
    pub fn gap_half_width(&self) -> f64 {
        let height = GAP[usize::from(!self.repeats)] * doubted(self.height);
        upper((height * self.closing()).hypot(ONE_BLOCK_GAP / self.blocks.carrying))
    }

    /// Standard error of the area by blocks, widened for how few of them carry the load.
    fn blocks(&self) -> f64 {
        let Blocks { scatter, carrying } = self.blocks;
        (scatter * students((carrying - 2.0).max(1.5))).hypot(ONE_BLOCK / carrying)
    }

    /// How much more than in proportion the gap follows the rms height: it is a function of the load
    /// over it, which falls faster the nearer the gap is to its end.
    fn closing(&self) -> f64 {
        ((1.0 + self.fall.min(STEEPEST)) / LIGHT).max(1.0)
    }
}

/// The upper side of a number that is known to `r`, two relative standard errors: of a count `n`, where
/// `r = 2/√n`, the 97.5 % limit is `n (1 + r + r²/2)` within a twentieth from n = 3 on (Garwood 1936).
fn upper(r: f64) -> f64 {
    r + 0.5 * r * r
}

/// Student's quantile over the normal one at 97.5 %, in its expansion for many degrees of freedom
/// (Abramowitz & Stegun 26.7.5).
fn students(freedom: f64) -> f64 {
    1.0 + (1.21 + 1.44 / freedom) / freedom
}

/// The scatter `h` of the rms height, widened because it is itself found from few waves where it is
/// large: `h = ½/√N` means `N = 1/(4h²)` waves of equal weight, half of them independent, `ν = 1/(8h²)`.
fn doubted(height_scatter: f64) -> f64 {
    if height_scatter > 0.0 {
        height_scatter * students(1.0 / (8.0 * height_scatter * height_scatter))
    } else {
        0.0
    }
}

/// Blocks of one solution.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Blocks {
    /// Relative standard error of the area by the residuals of a line through their loads and areas.
    pub scatter: f64,
    /// How many carry the load: (sum of their loads)² over the sum of the squares.
    pub carrying: f64,
}

/// What `parts` by `parts` blocks of a solution say; `None` if nothing touches, the field is not of this grid, fewer than 4 blocks
/// are asked for, or a block has no pixel.
pub fn blocks(pressure: &[f64], grid: Grid, parts: usize) -> Option<Blocks> {
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
    let squares: f64 = points.iter().map(|p| p[0] * p[0]).sum();
    let carrying = if squares > 0.0 { n * n * mean[0] * mean[0] / squares } else { n };
    Some(Blocks { scatter: (residual / n).sqrt() / mean[1], carrying })
}

/// Relative standard errors of the rms height over maps of the same surface, and of the rms gradient
/// by marks across it; `power` is the spectrum of `surface`, under a window if its edges do not match.
pub fn height_and_marks(surface: &HeightMap, power: &PowerSpectrum) -> [f64; 2] {
    let [height, marks] = scatter_by_lines(surface);
    [scatter_by_waves(power).max(scatter_by_squares(surface)).max(height), marks]
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

/// Waves that stand for the long end of the spectrum of `h²`: periods over the map along y and x.
/// It is flat there, so that edges which do not match need no window.
const LONGEST: [[i32; 2]; 6] = [[0, 1], [0, 2], [1, 0], [2, 0], [1, 1], [-1, 1]];

/// The same from the mean power of the longest waves of the squared heights.
fn scatter_by_squares(surface: &HeightMap) -> f64 {
    let [ny, nx] = surface.grid().shape();
    let n = surface.grid().len() as f64;
    let mean = surface.mean();
    let square = |h: &f64| (h - mean) * (h - mean);
    let mean_square = surface.heights().iter().map(square).sum::<f64>() / n;
    // A profile has no waves across.
    let fits = |[ky, kx]: &[i32; 2]| (*ky == 0 || ny > 4) && (*kx == 0 || nx > 4);
    let longest: Vec<[i32; 2]> = LONGEST.into_iter().filter(fits).collect();
    if mean_square <= 0.0 || longest.is_empty() {
        return 0.0;
    }
    let turns = |k: i32, n: usize| -> Vec<(f64, f64)> {
        (0..n).map(|i| (f64::from(k) * TAU * i as f64 / n as f64).sin_cos()).collect()
    };
    let turns_along = [0, 1, 2].map(|kx| turns(kx, nx));
    // Sums of (h² - <h²>) exp(i q x) over the map.
    let mut sums = vec![[0.0; 2]; longest.len()];
    for (iy, row) in surface.heights().chunks_exact(nx).enumerate() {
        let along = [0, 1, 2].map(|kx: usize| {
            let terms = row.iter().zip(&turns_along[kx]);
            terms.fold([0.0; 2], |[re, im], (h, (sin, cos))| {
                let y = square(h) - mean_square;
                [re + y * cos, im + y * sin]
            })
        });
        for (sum, [ky, kx]) in sums.iter_mut().zip(&longest) {
            let (sin, cos) = (f64::from(*ky) * TAU * iy as f64 / ny as f64).sin_cos();
            let [re, im] = along[*kx as usize];
            sum[0] += re * cos - im * sin;
            sum[1] += re * sin + im * cos;
        }
    }
    let power: f64 = sums.iter().map(|[re, im]| re * re + im * im).sum();
    0.5 * (power / sums.len() as f64).sqrt() / (n * mean_square)
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
        let even = blocks(&field([2, 4, 6, 8], [1.0; 4]), grid, 2).unwrap();
        assert!(even.scatter < 1e-7, "{even:?}");
        // 20² over 4 + 16 + 36 + 64.
        assert!((even.carrying - 400.0 / 120.0).abs() < 1e-12, "{even:?}");
        // l = 2, 4, 6, 8 but a = 2, 4, 6, 12 sixteenths: line 6 + 1.6 (l - 5), residuals
        // 0.8, -0.4, -1.6, 1.2; s² = 4.8 / 2, mean 6: sqrt(2.4 / 4) / 6.
        let uneven = blocks(&field([2, 4, 6, 12], [1.0, 1.0, 1.0, 8.0 / 12.0]), grid, 2);
        assert!((uneven.unwrap().scatter - 0.6f64.sqrt() / 6.0).abs() < 1e-12);
        assert_eq!(blocks(&[0.0; 64], grid, 2), None);
        assert_eq!(blocks(&[1.0; 63], grid, 2), None);
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
    /// none. One of the six waves has the power of half its amplitude squared, twice over.
    #[test]
    fn rough_and_smooth_halves_scatter_as_their_squares_do() {
        let grid = Grid::new([64, 4096], [1.0, 1.0]).unwrap();
        let rough = |ix: usize| if ix < 2048 { 2.0 } else { 1.0 };
        let sign = |iy: usize, ix: usize| if (iy + ix).is_multiple_of(2) { 1.0 } else { -1.0 };
        let heights = (0..64 * 4096).map(|i| rough(i % 4096) * sign(i / 4096, i)).collect();
        let map = HeightMap::new(grid, heights).unwrap();
        let found = scatter_by_squares(&map);
        let amplitude = 1.5 * 4.0 / std::f64::consts::PI;
        let expected = 0.5 * (amplitude * amplitude / 4.0 / 6.0).sqrt() / 2.5;
        assert!((found / expected - 1.0).abs() < 1e-3, "{found} {expected}");
        let power = PowerSpectrum::of(&map, Window::None).unwrap();
        assert!(height_and_marks(&map, &power)[0] >= found);
    }

    /// Of Gaussian maps both ways say the same, but for the chance in six waves.
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
        // 20 maps of 6 waves with two degrees of freedom each: 9 % standard error.
        assert!((sums[1] / sums[0] - 1.0).abs() < 0.25, "{sums:?}");
    }
}
