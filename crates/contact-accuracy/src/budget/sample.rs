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
//! *Gap and stiffness* follow the rms height and the longest waves, which no part of a map samples. The
//! variance of the mean of `h²` over a map is the power of `h²` at long waves, and is found in three ways, of which the
//! largest counts. If the amplitudes of the waves are independent and normal it is `sum S²`, S the power of
//! each wave of the plane: the relative scatter of the rms height is then `½ sqrt(sum S²) / sum S`. If they are
//! not, where a surface is rougher in some places than in others, it is still what the longest waves of `h²`
//! itself show, and where marks run across the map what stands out of them (`long_waves.rs`). The scatter of the rms
//! gradient, which the area follows, is found alike. Waves of height longer than the map are in none of these: on
//! a map that does not repeat, which is a part of a larger surface, more is added for them.
//!
//! At high load what is left of the gap lies in a few places, and its mean scatters as their number does: as the
//! long waves of the gap itself say. At light load a few summits carry everything, and the flat rests where the next
//! map has others: higher or lower by what the highest differ by.
//!
//! Where few blocks carry the load, Student's quantile widens what they say of the area, and near full
//! contact the gap follows the rms height with more than the first power.

use super::long_waves::LongWaves;
use contact_types::{Grid, HeightMap};
use fft_bem_solver::Solution;
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
/// The same of the area over that of the rms gradient.
const GRADIENT: f64 = 4.0;
/// The same of gap and stiffness over that of the mean gap by its own long waves: two, and a quarter more because
/// an open place is the deeper the wider it is.
const PLACES: f64 = 2.5;
/// The same of area and gap over what the highest blocks differ by, where one carries everything.
const HIGHEST: [f64; 2] = [2.5, 4.0];
/// Standard error of the area of one block, where one carries everything.
const ONE_BLOCK: f64 = 0.3;
/// Over √(1 − A²), the part of the scatter of the area that is left near full contact, at most all of it.
const FULL: f64 = 8.0;
/// Fall of the gap per e-fold load over the gap, with 1 for the height itself, up to which the gap follows the
/// rms height with the first power.
const LIGHT: f64 = 1.7;
/// Most of that fall, and of the differences of the highest blocks, over a gap that counts.
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
    /// The same of the rms gradient.
    pub gradient: f64,
    /// The same of the mean gap by its long waves.
    pub gap: f64,
    /// What the highest blocks differ by, over the mean gap \[-\].
    pub highest: f64,
    /// Whether the map repeats. If not it is a part of a larger surface, whose longest waves it
    /// does not hold.
    pub repeats: bool,
}

impl Sampled {
    /// Of the area.
    pub fn area_half_width(&self) -> f64 {
        let height = AREA[1 + usize::from(!self.repeats)] * doubted(self.height);
        // Near full contact the area hardly follows the slopes any more, nor the summits.
        let open = (1.0 - self.area * self.area).max(0.0).sqrt();
        let blocks = (AREA[0] * self.blocks()).hypot(height);
        let parts = blocks.hypot(open * HIGHEST[0] * self.summits());
        // It ends at full contact, where it cannot vary.
        (FULL * open).min(1.0) * upper(parts.max(open * GRADIENT * self.gradient))
    }

    /// Of the stiffness.
    pub fn stiffness_half_width(&self) -> f64 {
        let height = STIFFNESS[1 + usize::from(!self.repeats)] * doubted(self.height);
        let parts = (STIFFNESS[0] * self.blocks()).hypot(height * self.closing());
        upper(parts.max(self.places()))
    }

    /// Of the mean gap.
    pub fn gap_half_width(&self) -> f64 {
        let height = GAP[usize::from(!self.repeats)] * doubted(self.height);
        let heights = (height * self.closing()).max(self.places());
        upper(heights.hypot(HIGHEST[1] * self.summits()))
    }

    /// What the places left open say of the mean gap. `g = 1/√N` means `N` of equal volume, known to `N/2`
    /// degrees of freedom as their sum is; of one it says no less than one does.
    fn places(&self) -> f64 {
        let freedom = (0.5 / (self.gap * self.gap)).max(1.0);
        PLACES * self.gap * students(freedom)
    }

    /// What the highest blocks differ by, over the gap, as far as few of them carry: none is left where all do.
    fn summits(&self) -> f64 {
        let all = (PARTS * PARTS) as f64;
        self.highest.min(STEEPEST) * (1.0 / self.blocks.carrying - 1.0 / all).max(0.0)
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
    // Points ix with ix parts / nx = column.
    let columns =
        |column: usize| (column * nx).div_ceil(parts)..((column + 1) * nx).div_ceil(parts);
    for (iy, row) in pressure.chunks_exact(nx).enumerate() {
        let blocks = &mut blocks[iy * parts / ny * parts..][..parts];
        for (column, block) in blocks.iter_mut().enumerate() {
            let points = &row[columns(column)];
            block[0] += points.len() as f64;
            block[1] += points.iter().filter(|p| **p > 0.0).count() as f64;
            block[2] = points.iter().filter(|p| **p > 0.0).fold(block[2], |load, p| load + p);
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

/// Relative standard errors of the rms height and the rms gradient over maps of the same surface; `power` is
/// the spectrum of `surface`, under a window if its edges do not match.
pub fn height_and_gradient(surface: &HeightMap, power: &PowerSpectrum) -> [f64; 2] {
    let ([ny, nx], [dy, dx]) = (surface.grid().shape(), surface.grid().pixel());
    let mean = surface.mean();
    let heights = LongWaves::of(surface.grid(), |iy, ix| (surface.at(iy, ix) - mean).powi(2));
    // The last line has its neighbour before it; a profile has none.
    let beside = |i: usize, n: usize| if i + 1 < n { i + 1 } else { i.saturating_sub(1) };
    let slopes = LongWaves::of(surface.grid(), |iy, ix| {
        let here = surface.at(iy, ix);
        let along_y = (surface.at(beside(iy, ny), ix) - here) / dy;
        let along_x = (surface.at(iy, beside(ix, nx)) - here) / dx;
        along_y * along_y + along_x * along_x
    });
    // Marks are seen by their slopes.
    let marks = slopes.scatter_by_marks();
    let marks = [if marks > 0.0 { heights.scatter_by_marks() } else { 0.0 }, marks];
    let waves =
        [scatter_by_waves(power, |_| 1.0), scatter_by_waves(power, |[qy, qx]| qy * qy + qx * qx)];
    // A root scatters by half of what is under it.
    let found = |k: usize, by: &LongWaves| waves[k].max(0.5 * by.scatter().max(marks[k]));
    [found(0, &heights), found(1, &slopes)]
}

/// The same of the mean square of the waves of the map times `weight`, taken as independent and normal.
fn scatter_by_waves(power: &PowerSpectrum, weight: impl Fn([f64; 2]) -> f64) -> f64 {
    let (mut sum, mut squares) = (0.0, 0.0);
    power.for_each(|q, count, variance| {
        let part = weight(q) * variance;
        sum += count * part;
        squares += count * part * part;
    });
    if sum > 0.0 { 0.5 * squares.sqrt() / sum } else { 0.0 }
}

/// Relative standard error of the mean gap of `solution` over maps of the same surface, by its long waves.
pub fn gap_scatter(solution: &Solution) -> f64 {
    let grid = solution.coarse_grid();
    let nx = grid.shape()[1];
    let waves = LongWaves::of(grid, |iy, ix| solution.coarse_gap[iy * nx + ix]);
    waves.scatter().max(waves.scatter_by_marks())
}

/// Mean height of the highest eighth of the summits of `parts` by `parts` blocks over the next (m): how much higher
/// or lower those of another map may be (Pickands 1975 on the excess over a threshold).
pub fn highest(surface: &HeightMap, parts: usize) -> f64 {
    let [ny, nx] = surface.grid().shape();
    if ny.min(nx) < parts || parts < 3 {
        return 0.0;
    }
    let mut summits = vec![f64::NEG_INFINITY; parts * parts];
    for (iy, row) in surface.heights().chunks_exact(nx).enumerate() {
        for (ix, h) in row.iter().enumerate() {
            let summit = &mut summits[iy * parts / ny * parts + ix * parts / nx];
            *summit = summit.max(*h);
        }
    }
    summits.sort_by(|a, b| b.total_cmp(a));
    let few = summits.len() / 8;
    summits[..few].iter().map(|h| h - summits[few]).sum::<f64>() / few as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use contact_types::HeightMap;
    use std::f64::consts::TAU;
    use surface_stats::spectrum::Window;

    fn scatter_by_squares(map: &HeightMap) -> f64 {
        let mean = map.mean();
        let square = |iy: usize, ix: usize| (map.at(iy, ix) - mean).powi(2);
        0.5 * LongWaves::of(map.grid(), square).scatter()
    }

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

    /// A groove across half the places: one of the six longest waves, (1 - i)/π of the share at each odd period,
    /// says how the mean scatters; a gap that is alike everywhere says nothing. The solver keeps means of blocks
    /// of its gap.
    #[test]
    fn gaps_in_one_place_scatter_and_even_ones_do_not() {
        use contact_types::ContactModulus;
        use fft_bem_solver::{Load, Solver};
        let grid = Grid::new([64, 64], [1.0, 1.0]).unwrap();
        let fine = |x: f64| 0.01 * (TAU * x / 4.0).cos();
        let solve = |map: &HeightMap| {
            let modulus = ContactModulus::from_pascals(1.0).unwrap();
            let mut solver = Solver::builder().build(grid, modulus).unwrap();
            solver.solve(map, Load::MeanPressure(1e-4)).unwrap()
        };
        let even = solve(&HeightMap::from_fn(grid, |_, x| fine(x)).unwrap());
        assert!(gap_scatter(&even) < 1e-3, "{}", gap_scatter(&even));
        let deep = |x: f64| if x < 32.0 { fine(x) } else { fine(x) - 100.0 };
        let half = solve(&HeightMap::from_fn(grid, |_, x| deep(x)).unwrap());
        // |F(1)|²/F(0)² = 1/(32 sin(π/64))² of an array of 64 points, of which one half is filled.
        let expected = (1.0 / (32.0 * (TAU / 64.0 / 2.0).sin()).powi(2) / 6.0).sqrt();
        let found = gap_scatter(&half);
        assert!((found / expected - 1.0).abs() < 0.01, "{found} {expected}");
        let open = |i: usize| if half.pressure[i] > 0.0 { 0.0 } else { half.gap[i].max(0.0) };
        let block = |i: usize| [0, 1, 64, 65].map(|k| open(i + k)).iter().sum::<f64>();
        assert!((half.coarse_gap[0] - block(0) / 4.0).abs() < 1e-12);
        assert!((half.coarse_gap[31] - block(62) / 4.0).abs() < 1e-12 * half.coarse_gap[31]);
    }

    /// 64 blocks whose summits are 0, 1, ... 63: the highest eight are 59.5 - 55 above the next in the mean.
    #[test]
    fn highest_summits_by_hand() {
        let grid = Grid::new([16, 16], [1.0, 1.0]).unwrap();
        let summit = |iy: usize, ix: usize| (iy / 2 * 8 + ix / 2) as f64 - ((iy + ix) % 2) as f64;
        let map = HeightMap::new(grid, (0..256).map(|i| summit(i / 16, i % 16)).collect()).unwrap();
        assert!((highest(&map, 8) - 4.5).abs() < 1e-12);
        assert!(highest(&map, 32).abs() < 1e-12);
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
        let power = PowerSpectrum::of(&map, Window::None).unwrap();
        let height = scatter_by_waves(&power, |_| 1.0);
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
        assert!(height_and_gradient(&map, &power)[0] >= found);
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
            sums[0] += scatter_by_waves(&power, |_| 1.0).powi(2);
            sums[1] += scatter_by_squares(&map).powi(2);
        }
        // 20 maps of 6 waves with two degrees of freedom each: 9 % standard error.
        assert!((sums[1] / sums[0] - 1.0).abs() < 0.25, "{sums:?}");
    }
}
