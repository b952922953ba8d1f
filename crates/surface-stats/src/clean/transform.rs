//! Turning, resampling and adding maps.

use super::gaussian::gaussian_filter;
use crate::{Edges, StatsError};
use contact_types::{ContactModulus, Elastic, Grid, HeightMap};
use grid_fft::GridFft;
use std::cmp::Ordering;

use crate::spectrum::Axis;

/// Relative difference of pixel sides below which two maps lie on each other.
const SAME_PIXEL: f64 = 1e-6;

/// Mirrors a map along one axis: along x, the first column becomes the last.
#[expect(clippy::missing_panics_doc, reason = "moving finite heights leaves them finite")]
pub fn flip(map: &HeightMap, axis: Axis) -> HeightMap {
    let nx = map.grid().shape()[1];
    let mut heights = map.heights().to_vec();
    match axis {
        Axis::X => heights.chunks_exact_mut(nx).for_each(<[f64]>::reverse),
        Axis::Y => {
            heights.reverse();
            heights.chunks_exact_mut(nx).for_each(<[f64]>::reverse);
        }
    }
    HeightMap::new(map.grid(), heights).expect("the same finite heights on the same grid")
}

/// How the second map was measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum Facing {
    /// From its own outside, as instruments do: it is mirrored along x when it is turned over and
    /// laid on the first.
    AsMeasured,
    /// Already as seen through the first body.
    Mirrored,
}

/// Roughness of the rigid surface that touches a smooth flat as the two touch each other: the sum
/// of both heights at each place. m0, m2, m4 and the PSD of independent surfaces add.
///
/// # Errors
/// [`StatsError::GridMismatch`] unless shapes are equal and pixels agree to 10⁻⁶.
pub fn combine(
    first: &HeightMap,
    second: &HeightMap,
    facing: Facing,
) -> Result<HeightMap, StatsError> {
    let (a, b) = (first.grid(), second.grid());
    let close = a.pixel().iter().zip(b.pixel()).all(|(p, q)| (p / q - 1.0).abs() <= SAME_PIXEL);
    if a.shape() != b.shape() || !close {
        return Err(StatsError::GridMismatch { first: a, second: b });
    }
    let nx = a.shape()[1];
    let mut sum = first.heights().to_vec();
    for (row, other) in sum.chunks_exact_mut(nx).zip(second.heights().chunks_exact(nx)) {
        match facing {
            Facing::AsMeasured => {
                row.iter_mut().zip(other.iter().rev()).for_each(|(h, o)| *h += o);
            }
            Facing::Mirrored => row.iter_mut().zip(other).for_each(|(h, o)| *h += o),
        }
    }
    Ok(HeightMap::new(a, sum)?)
}

/// Two rough elastic bodies as one rough rigid surface on a smooth half-space: combined heights
/// and contact modulus.
///
/// # Errors
/// As [`combine`]; [`StatsError::Surface`] for impossible moduli.
///
/// # Source
/// Johnson (1985), *Contact Mechanics*, §4.1 and §13.4; doi:10.1017/CBO9781139171731.
pub fn equivalent(
    first: (&HeightMap, Elastic),
    second: (&HeightMap, Elastic),
    facing: Facing,
) -> Result<(HeightMap, ContactModulus), StatsError> {
    let map = combine(first.0, second.0, facing)?;
    Ok((map, ContactModulus::of_pair(first.1, second.1)?))
}

/// The same area on another number of points.
///
/// - Periodic: the cell `ny dy` by `nx dx` is kept. Waves that both grids hold are kept exactly,
///   others are dropped; nothing is smoothed.
/// - Open: first and last points stay where they are. Cubic convolution (Keys, a = -1/2), exact
///   for quadratics inside. If a new pixel is larger than the old one, waves shorter than two new
///   pixels are taken off first by a Gaussian filter.
///
/// # Errors
/// [`StatsError::TooSmall`] below 4 x 4 pixels before or 2 x 2 after on an open map;
/// [`StatsError::Surface`] for an empty or too large shape.
pub fn resample(map: &HeightMap, shape: [usize; 2], edges: Edges) -> Result<HeightMap, StatsError> {
    match edges {
        Edges::Periodic => fourier(map, shape),
        Edges::Open => cubic(map, shape),
    }
}

fn fourier(map: &HeightMap, shape: [usize; 2]) -> Result<HeightMap, StatsError> {
    let [ly, lx] = map.grid().size();
    let grid = Grid::new(shape, [ly / shape[0].max(1) as f64, lx / shape[1].max(1) as f64])?;
    let [ny, nx] = map.grid().shape();
    let mean = map.mean();
    let field: Vec<f64> = map.heights().iter().map(|h| h - mean).collect();
    let mut from = GridFft::new([ny, nx]);
    let mut old = from.new_spectrum();
    from.forward(&field, &mut old);
    drop(field);
    let mut to = GridFft::new(shape);
    let mut new = to.new_spectrum();
    let (old_nq, new_nq) = (nx / 2 + 1, shape[1] / 2 + 1);
    let scale = grid.len() as f64 / map.grid().len() as f64;
    for kx in 0..=(nx.min(shape[1]) / 2) {
        for ky in 0..=(ny.min(shape[0]) / 2) {
            let kept = kept(nx, shape[1], kx) * kept(ny, shape[0], ky);
            for negative in [false, true] {
                let row = |n: usize| if negative { (n - ky) % n } else { ky };
                new[row(shape[0]) * new_nq + kx] = old[row(ny) * old_nq + kx] * (kept * scale);
            }
        }
    }
    let mut heights = vec![0.0; grid.len()];
    to.inverse(&mut new, &mut heights);
    for h in &mut heights {
        *h += mean;
    }
    Ok(HeightMap::new(grid, heights)?)
}

/// How much of wave k of `n` points goes to wave k of `m` points. A wave of two pixels stands for
/// itself and its mirror: a finer grid has both and gets half for each; a coarser grid cannot
/// hold it.
fn kept(n: usize, m: usize, k: usize) -> f64 {
    match (2 * k).cmp(&n.min(m)) {
        Ordering::Less => 1.0,
        _ if n == m => 1.0,
        _ if n < m => 0.5,
        _ => 0.0,
    }
}

fn cubic(map: &HeightMap, shape: [usize; 2]) -> Result<HeightMap, StatsError> {
    let ([ny, nx], [dy, dx]) = (map.grid().shape(), map.grid().pixel());
    if ny < 4 || nx < 4 {
        let what = "cubic interpolation";
        return Err(StatsError::TooSmall { what, shape: [ny, nx], needed: [4, 4] });
    }
    if shape[0] < 2 || shape[1] < 2 {
        let what = "a map that keeps its first and last points";
        return Err(StatsError::TooSmall { what, shape, needed: [2, 2] });
    }
    // New points in units of old pixels.
    let step = [0, 1].map(|k| [ny - 1, nx - 1][k] as f64 / (shape[k] - 1) as f64);
    let grid = Grid::new(shape, [dy * step[0], dx * step[1]])?;
    let shortest = 2.0 * grid.pixel()[0].max(grid.pixel()[1]);
    let smooth = step[0] > 1.0 || step[1] > 1.0;
    let smoothed = smooth
        .then(|| gaussian_filter(map.grid(), map.heights(), shortest, Edges::Open))
        .transpose()?;
    let heights = smoothed.as_deref().unwrap_or(map.heights());

    let along = |axis: usize| Along { first: 0.0, step: step[axis], count: shape[axis] };
    let resampled = interpolated([ny, nx], heights, [along(0), along(1)]);
    Ok(HeightMap::new(grid, resampled)?)
}

/// Points along one axis, in units of the points of a map: `first`, `first + step`, … .
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Along {
    pub(crate) first: f64,
    pub(crate) step: f64,
    pub(crate) count: usize,
}

/// Heights at points inside a map of at least 4 x 4 points; those at its own points are its own.
pub(crate) fn interpolated([ny, nx]: [usize; 2], heights: &[f64], along: [Along; 2]) -> Vec<f64> {
    let (rows, columns) = (stencils(ny, along[0]), stencils(nx, along[1]));
    let mut new = Vec::with_capacity(rows.len() * columns.len());
    for (y, wy) in &rows {
        for (x, wx) in &columns {
            let along = |row: usize| {
                let z = &heights[row * nx + x..row * nx + x + 4];
                (0..4).map(|k| wx[k] * z[k]).sum::<f64>()
            };
            new.push((0..4).map(|k| wy[k] * along(y + k)).sum());
        }
    }
    new
}

/// First of four neighbours and their weights for every new point along one axis. Next to an edge
/// the stencil is shifted inwards and the cubic through its four points is used.
fn stencils(n: usize, Along { first, step, count }: Along) -> Vec<(usize, [f64; 4])> {
    let stencil = |i: usize| {
        let position = first + i as f64 * step;
        let cell = (position.floor() as usize).min(n - 2);
        let t = position - cell as f64;
        if cell > 0 && cell + 2 < n {
            return (cell - 1, keys(t));
        }
        let start = if cell == 0 { 0 } else { n - 4 };
        (start, lagrange(position - start as f64))
    };
    (0..count).map(stencil).collect()
}

/// Weights of the points -1, 0, 1, 2 at t in 0..1 (Keys 1981, doi:10.1109/TASSP.1981.1163711).
fn keys(t: f64) -> [f64; 4] {
    let (t2, t3) = (t * t, t * t * t);
    [
        -0.5 * t3 + t2 - 0.5 * t,
        1.5 * t3 - 2.5 * t2 + 1.0,
        -1.5 * t3 + 2.0 * t2 + 0.5 * t,
        0.5 * t3 - 0.5 * t2,
    ]
}

/// Weights of the points 0, 1, 2, 3 at t: the cubic through all four.
fn lagrange(t: f64) -> [f64; 4] {
    let (a, b, c) = (t - 1.0, t - 2.0, t - 3.0);
    [-a * b * c / 6.0, t * b * c / 2.0, -t * a * c / 2.0, t * a * b / 6.0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::DirectionalMoments;
    use crate::spectrum::{PowerSpectrum, Window};
    use crate::synthesis::{Scale, SelfAffine};
    use approx::{assert_abs_diff_eq, assert_relative_eq};
    use proptest::prelude::*;
    use std::f64::consts::TAU;

    fn rough(seed: u64) -> HeightMap {
        let recipe = SelfAffine {
            grid: Grid::new([64, 81], [1e-6, 1.2e-6]).unwrap(),
            hurst: 0.8,
            rolloff: 20e-6,
            cutoff: 5e-6,
            scale: Scale::RmsHeight(1e-7),
            seed,
            quantise: None,
        };
        recipe.generate().unwrap()
    }

    #[test]
    fn flips_by_hand() {
        let map = HeightMap::new(
            Grid::new([2, 3], [1.0, 2.0]).unwrap(),
            vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0],
        )
        .unwrap();
        assert_eq!(flip(&map, Axis::X).heights(), [3.0, 2.0, 1.0, 6.0, 5.0, 4.0]);
        assert_eq!(flip(&map, Axis::Y).heights(), [4.0, 5.0, 6.0, 1.0, 2.0, 3.0]);
        assert_eq!(flip(&flip(&map, Axis::X), Axis::X), map);
        let sum = combine(&map, &map, Facing::AsMeasured).unwrap();
        assert_eq!(sum.heights(), [4.0, 4.0, 4.0, 10.0, 10.0, 10.0]);
    }

    /// Moments of independent surfaces add: exactly with the cross terms of the two, which vanish
    /// in the mean (checked to three standard deviations of 100 independent waves).
    #[test]
    fn moments_of_two_surfaces_add() {
        let (a, b) = (rough(1), rough(2));
        let steel = Elastic::new(210e9, 0.3).unwrap();
        let (sum, modulus) = equivalent((&a, steel), (&b, steel), Facing::AsMeasured).unwrap();
        assert_relative_eq!(modulus.pascals(), 210e9 / 1.82, max_relative = 1e-14);
        let moments = |m: &HeightMap| PowerSpectrum::of(m, Window::None).unwrap().moments().0;
        let (a, b, sum) = (moments(&a), moments(&b), moments(&sum));
        assert_relative_eq!(sum.m0, a.m0 + b.m0, max_relative = 0.3);
        assert_relative_eq!(sum.m2, a.m2 + b.m2, max_relative = 0.2);
    }

    #[test]
    fn maps_that_do_not_match_are_refused() {
        let a = rough(1);
        for (shape, pixel) in [([64, 80], [1e-6, 1.2e-6]), ([64, 81], [1e-6, 1.3e-6])] {
            let grid = Grid::new(shape, pixel).unwrap();
            let b = HeightMap::new(grid, vec![0.0; grid.len()]).unwrap();
            let error = combine(&a, &b, Facing::Mirrored);
            assert!(matches!(error, Err(StatsError::GridMismatch { .. })));
        }
    }

    proptest! {
        /// A sum of waves that both grids hold is the same function on either.
        #[test]
        fn fourier_resampling_keeps_waves(
            ny in 9usize..30, nx in 9usize..30, my in 9usize..30, mx in 9usize..30,
            ky in -4i32..=4, kx in 0i32..=4, phase in 0.0..TAU,
        ) {
            let size = [30e-6, 20e-6];
            let grid = |n: [usize; 2]| {
                Grid::new(n, [size[0] / n[0] as f64, size[1] / n[1] as f64]).unwrap()
            };
            let wave = |y: f64, x: f64| {
                1.0 + (TAU * (f64::from(ky) * y / size[0] + f64::from(kx) * x / size[1]) + phase).cos()
            };
            let map = HeightMap::from_fn(grid([ny, nx]), wave).unwrap();
            let expected = HeightMap::from_fn(grid([my, mx]), wave).unwrap();
            let found = resample(&map, [my, mx], Edges::Periodic).unwrap();
            for (a, b) in found.heights().iter().zip(expected.heights()) {
                prop_assert!((a - b).abs() < 1e-13);
            }
        }
    }

    /// Refining keeps the old points, also with waves of two pixels.
    #[test]
    fn fourier_refinement_passes_through_all_points() {
        for shape in [[8, 6], [7, 9]] {
            let grid = Grid::new(shape, [1.0, 1.0]).unwrap();
            let heights = (0..grid.len()).map(|i| (1.7 * (i * i) as f64).sin()).collect();
            let map = HeightMap::new(grid, heights).unwrap();
            let fine = resample(&map, [3 * shape[0], 2 * shape[1]], Edges::Periodic).unwrap();
            for iy in 0..shape[0] {
                for ix in 0..shape[1] {
                    assert_abs_diff_eq!(fine.at(3 * iy, 2 * ix), map.at(iy, ix), epsilon = 1e-14);
                }
            }
        }
    }

    /// Open: quadratics exactly, also at the edges; first and last points stay.
    #[test]
    fn cubic_resampling_of_a_quadratic() {
        let grid = Grid::new([9, 12], [2.0, 1.0]).unwrap();
        let z =
            |y: f64, x: f64| 1.0 + 0.2 * x - 0.1 * y + 0.05 * x * x - 0.02 * x * y + 0.01 * y * y;
        let map = HeightMap::from_fn(grid, z).unwrap();
        let fine = resample(&map, [33, 40], Edges::Open).unwrap();
        let [dy, dx] = fine.grid().pixel();
        assert_relative_eq!(32.0 * dy, 16.0, max_relative = 1e-14);
        assert_relative_eq!(39.0 * dx, 11.0, max_relative = 1e-14);
        for iy in 0..33 {
            for ix in 0..40 {
                let expected = z(dy * iy as f64, dx * ix as f64);
                assert_abs_diff_eq!(fine.at(iy, ix), expected, epsilon = 1e-13);
            }
        }
        let same = resample(&map, [9, 12], Edges::Open).unwrap();
        for (a, b) in same.heights().iter().zip(map.heights()) {
            assert_abs_diff_eq!(a, b, epsilon = 1e-14);
        }
    }

    /// Coarsening an open map does not fold short waves into long ones.
    #[test]
    fn coarsening_does_not_alias() {
        let grid = Grid::new([120, 120], [1.0, 1.0]).unwrap();
        let map = HeightMap::from_fn(grid, |y, x| (TAU * (x / 3.1 + y / 2.9)).cos()).unwrap();
        let coarse = resample(&map, [30, 30], Edges::Open).unwrap();
        let m = DirectionalMoments::of(&coarse, Edges::Open).unwrap();
        assert!(m.m2_x + m.m2_y < 1e-3, "{m:?}");
        for shape in [[1, 5], [5, 1]] {
            let error = resample(&map, shape, Edges::Open);
            assert!(matches!(error, Err(StatsError::TooSmall { .. })));
        }
        assert!(resample(&map, [0, 5], Edges::Periodic).is_err());
    }
}
