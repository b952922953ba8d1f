//! Sampling variability: how far the numbers of another map of the same surface would lie.
//!
//! The solution is cut into 8 × 8 blocks. By these the load has a relative standard error `l`, the mean gap one `b`;
//! the rms height has one `h` by the long waves of its square. Relative 95 % half widths are
//!
//! ```math
//! r_A = \sqrt{(1.2 l)^2 + h^2}, \quad r_G = \sqrt{(3.1 b)^2 + (1.7 h)^2}, \quad
//! r_K = \sqrt{(1.8 l)^2 + (3.7 b)^2}
//! ```
//!
//! and `r + r²/2` to the upper side, as for a count (Garwood 1936, doi:10.1093/biomet/28.3-4.437). The area answers to them
//! less as the contact closes.

use contact_types::HeightMap;
use fft_bem_solver::Solution;
use std::f64::consts::TAU;

/// Blocks along each side.
const BLOCKS: usize = 8;
/// Of the area over `l` and `h`.
const AREA: [f64; 2] = [1.2, 1.0];
/// Of the gap over `b` and `h`.
const GAP: [f64; 2] = [3.1, 1.7];
/// Of the stiffness over `l` and `b`.
const STIFFNESS: [f64; 2] = [1.8, 3.7];

/// What a map says of the answers on it before anything is solved. Made once per surface, in two passes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Map {
    /// Whether opposite edges match.
    pub repeats: bool,
    /// Rms height (m).
    pub rms_height: f64,
    /// Relative standard error of the rms height over maps of the same surface.
    pub height_scatter: f64,
    /// How many times it shows the same cell: where contact ends, all round alike.
    pub copies: usize,
}

impl Map {
    /// Of a surface as it is solved.
    pub fn of(surface: &HeightMap) -> Self {
        let (rms_height, height_scatter) = height_scatter(surface);
        let repeats = surface_stats::repeats(surface);
        Self { repeats, rms_height, height_scatter, copies: copies(surface, 1e-6 * rms_height) }
    }
}

/// How many times a map shows the same cell, to `tolerance` (m); of ridges along the points each row or column is one.
fn copies(surface: &HeightMap, tolerance: f64) -> usize {
    let ([ny, nx], heights) = (surface.grid().shape(), surface.heights());
    let along = |n: usize, moved: &dyn Fn(usize, usize) -> usize| {
        let same = |p: usize, i: usize| (heights[i] - heights[moved(i, p)]).abs() <= tolerance;
        let is_period = |p: &usize| n.is_multiple_of(*p) && (0..heights.len()).all(|i| same(*p, i));
        (1..n).find(is_period).map_or(1, |period| n / period)
    };
    let rows = along(ny, &|i, p| (i + p * nx) % heights.len());
    rows * along(nx, &|i, p| i / nx * nx + (i + p) % nx)
}

/// Relative 95 % half widths of area, mean gap and stiffness over maps of the same surface, of a solution on a map whose
/// rms height has this relative standard error; `None` if the pressure is not there, nothing touches, or a block has no
/// point.
pub(crate) fn sampling(solution: &Solution, height: f64) -> Option<[f64; 3]> {
    let touches = solution.pressure.iter().any(|p| *p > 0.0);
    let l = scatter(solution.grid.shape(), &solution.pressure).filter(|_| touches)?;
    let (blocks, coarse_gap) = &solution.coarse_gap;
    let b = scatter(*blocks, coarse_gap)?;
    let half = |factors: [f64; 2], x: f64, y: f64| {
        let r = (factors[0] * x).hypot(factors[1] * y);
        r + 0.5 * r * r
    };
    Some([half(AREA, l, height), half(GAP, b, height), half(STIFFNESS, l, b)])
}

/// Relative standard error of the mean of a field by its blocks; 0 where it is nowhere above 0.
fn scatter([ny, nx]: [usize; 2], field: &[f64]) -> Option<f64> {
    if field.len() != ny * nx || ny.min(nx) < BLOCKS {
        return None;
    }
    let mut sums = vec![[0.0; 2]; BLOCKS * BLOCKS];
    for (iy, row) in field.chunks_exact(nx).enumerate() {
        let blocks = &mut sums[iy * BLOCKS / ny * BLOCKS..][..BLOCKS];
        for (column, [sum, points]) in blocks.iter_mut().enumerate() {
            let [from, to] = [column, column + 1].map(|c| (c * nx).div_ceil(BLOCKS));
            *sum += row[from..to].iter().sum::<f64>();
            *points += (to - from) as f64;
        }
    }
    let means: Vec<f64> = sums.iter().map(|[sum, points]| sum / points).collect();
    let n = means.len() as f64;
    let mean = means.iter().sum::<f64>() / n;
    let square = means.iter().map(|m| (m - mean).powi(2)).sum::<f64>() / (n - 1.0);
    Some(if mean > 0.0 { (square / n).sqrt() / mean } else { 0.0 })
}

/// Rms height (m), and its relative standard error over maps of the same surface: the variance of the mean of a field over
/// a map is its power at long waves, here of `h²` at the twelve longest. Widened by Student's quantile, since they
/// are few.
fn height_scatter(surface: &HeightMap) -> (f64, f64) {
    let [ny, nx] = surface.grid().shape();
    let longest = [[0, 1], [0, 2], [1, 0], [2, 0], [1, 1], [ny - 1, 1]];
    let mean = surface.mean();
    let turns = |n: usize| -> Vec<[f64; 2]> {
        (0..n).map(|i| (TAU * i as f64 / n as f64).sin_cos().into()).collect()
    };
    let (along_y, along_x) = (turns(ny), turns(nx));
    let mut sums = [[0.0; 2]; 6]; // of h² exp(i q x)
    let mut all = 0.0;
    for (iy, row) in surface.heights().chunks_exact(nx).enumerate() {
        // Of this row at 0, 1 and 2 periods.
        let mut periods = [[0.0; 2]; 3];
        for (h, [sin, cos]) in row.iter().zip(&along_x) {
            let square = (h - mean).powi(2);
            let twice = [2.0 * sin * cos, cos * cos - sin * sin];
            periods[0][0] += square;
            for (period, [sin, cos]) in periods[1..].iter_mut().zip([[*sin, *cos], twice]) {
                *period = [period[0] + square * cos, period[1] + square * sin];
            }
        }
        all += periods[0][0];
        for ([ky, kx], sum) in longest.iter().zip(&mut sums) {
            let ([sin, cos], [re, im]) = (along_y[ky * iy % ny], periods[*kx]);
            *sum = [sum[0] + re * cos - im * sin, sum[1] + re * sin + im * cos];
        }
    }
    let rms_height = (all / surface.heights().len() as f64).sqrt();
    if all <= 0.0 {
        return (rms_height, 0.0);
    }
    let power = sums.iter().map(|[re, im]| (re * re + im * im) / (all * all)).sum::<f64>();
    let h = 0.5 * (power / longest.len() as f64).sqrt(); // a root scatters by half of what is under it
    (rms_height, h * students(0.5 * (0.5 / h).powi(2)))
}

/// Student's quantile over the normal one at 97.5 %, in its expansion for many degrees of freedom
/// (Abramowitz & Stegun 26.7.5).
fn students(freedom: f64) -> f64 {
    1.0 + (1.21 + 1.44 / freedom) / freedom
}
