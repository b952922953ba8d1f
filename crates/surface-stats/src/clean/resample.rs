//! The same area on another number of points.

use super::gaussian::gaussian_filter;
use crate::{Edges, StatsError};
use contact_types::{Grid, HeightMap};
use grid_fft::GridFft;
use std::cmp::Ordering;

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

    let along = |axis: usize| AxisPoints { first: 0.0, step: step[axis], count: shape[axis] };
    let resampled = interpolated([ny, nx], heights, [along(0), along(1)]);
    Ok(HeightMap::new(grid, resampled)?)
}

/// Points along one axis, in units of the points of a map: `first`, `first + step`, … .
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct AxisPoints {
    pub(crate) first: f64,
    pub(crate) step: f64,
    pub(crate) count: usize,
}

/// Heights at points inside a map of at least 4 x 4 points; those at its own points are its own.
pub(crate) fn interpolated(
    [ny, nx]: [usize; 2],
    heights: &[f64],
    along: [AxisPoints; 2],
) -> Vec<f64> {
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
fn stencils(n: usize, AxisPoints { first, step, count }: AxisPoints) -> Vec<(usize, [f64; 4])> {
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
    use approx::{assert_abs_diff_eq, assert_relative_eq};
    use proptest::prelude::*;
    use std::f64::consts::TAU;

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
