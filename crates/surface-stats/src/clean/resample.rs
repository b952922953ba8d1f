//! The same area on another number of points, and maps continued by their mirror images.

use crate::{Edges, StatsError};
use contact_types::{Grid, HeightMap};
use grid_fft::{Complex, GridFft};
use std::cmp::Ordering;
use std::f64::consts::PI;

/// The same area, `ny dy` by `nx dx`, on another number of points. Waves that both grids hold are kept exactly, others are
/// dropped; nothing is smoothed.
///
/// A map that repeats has Fourier waves. An open one is continued by its mirror images, which have no jump, and has
/// cosines; its point i stands for the pixel from `i dx` to `(i + 1) dx`, so that pixels stay inside the area.
///
/// # Errors
/// [`StatsError::Surface`] for an empty or too large shape.
pub fn resample(map: &HeightMap, shape: [usize; 2], edges: Edges) -> Result<HeightMap, StatsError> {
    let [ly, lx] = map.grid().size();
    let grid = Grid::new(shape, [ly / shape[0].max(1) as f64, lx / shape[1].max(1) as f64])?;
    let ([ny, nx], mean) = (map.grid().shape(), map.mean());
    let field: Vec<f64> = map.heights().iter().map(|h| h - mean).collect();
    let mut heights = match edges {
        Edges::Periodic => repeated(field, [ny, nx], shape),
        Edges::Open => {
            let wide = transpose(&along_rows(&field, nx, shape[1]), ny, shape[1]);
            transpose(&along_rows(&wide, ny, shape[0]), shape[1], shape[0])
        }
    };
    for h in &mut heights {
        *h += mean;
    }
    Ok(HeightMap::new(grid, heights)?)
}

/// A field that repeats on another number of points.
fn repeated(field: Vec<f64>, [ny, nx]: [usize; 2], shape: [usize; 2]) -> Vec<f64> {
    let mut from = GridFft::new([ny, nx]);
    let mut old = from.new_spectrum();
    from.forward(&field, &mut old);
    drop(field);
    let mut to = GridFft::new(shape);
    let mut new = to.new_spectrum();
    let (old_nq, new_nq) = (nx / 2 + 1, shape[1] / 2 + 1);
    let points = shape[0] * shape[1];
    let scale = points as f64 / (ny * nx) as f64;
    for kx in 0..=(nx.min(shape[1]) / 2) {
        for ky in 0..=(ny.min(shape[0]) / 2) {
            let kept = kept(nx, shape[1], kx) * kept(ny, shape[0], ky);
            for negative in [false, true] {
                let row = |n: usize| if negative { (n - ky) % n } else { ky };
                new[row(shape[0]) * new_nq + kx] = old[row(ny) * old_nq + kx] * (kept * scale);
            }
        }
    }
    let mut heights = vec![0.0; points];
    to.inverse(&mut new, &mut heights);
    heights
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

/// The map and its mirror images, `[2 ny, 2 nx]` points: a map that repeats without a jump at its
/// edges, only with a kink. The given map is its first quarter.
///
/// # Errors
/// [`StatsError::Surface`] if that are too many points.
pub fn mirrored(map: &HeightMap) -> Result<HeightMap, StatsError> {
    let [ny, nx] = map.grid().shape();
    let grid = Grid::new([2 * ny, 2 * nx], map.grid().pixel())?;
    let mut heights = Vec::with_capacity(grid.len());
    let rows = map.heights().chunks_exact(nx);
    for row in rows.clone().chain(rows.rev()) {
        heights.extend_from_slice(row);
        heights.extend(row.iter().rev());
    }
    Ok(HeightMap::new(grid, heights)?)
}

/// Every row of `n` points on `m` points. With `x` continued by its mirror image to 2n points, wave
/// k is `2 exp(iπk/2n)` times the cosine coefficient `Σ x_j cos(πk(j + ½)/n)`.
fn along_rows(field: &[f64], n: usize, m: usize) -> Vec<f64> {
    let (mut from, mut to) = (GridFft::new([1, 2 * n]), GridFft::new([1, 2 * m]));
    let (mut old, mut new) = (from.new_spectrum(), to.new_spectrum());
    let (mut doubled, mut regridded) = (vec![0.0; 2 * n], vec![0.0; 2 * m]);
    let scale = m as f64 / n as f64;
    let shift = |k: usize| {
        let angle = 0.5 * PI * k as f64 * (1.0 / m as f64 - 1.0 / n as f64);
        Complex::new(scale * angle.cos(), scale * angle.sin())
    };
    let shifts: Vec<Complex<f64>> = (0..n.min(m)).map(shift).collect();
    let mut result = Vec::with_capacity(field.len() / n * m);
    for row in field.chunks_exact(n) {
        doubled[..n].copy_from_slice(row);
        doubled[n..].iter_mut().zip(row.iter().rev()).for_each(|(to, from)| *to = *from);
        from.forward(&doubled, &mut old);
        new.fill(Complex::new(0.0, 0.0));
        for (k, shift) in shifts.iter().enumerate() {
            new[k] = old[k] * shift;
        }
        to.inverse(&mut new, &mut regridded);
        result.extend_from_slice(&regridded[..m]);
    }
    result
}

fn transpose(field: &[f64], ny: usize, nx: usize) -> Vec<f64> {
    (0..ny * nx).map(|i| field[(i % ny) * nx + i / ny]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;
    use proptest::prelude::*;
    use std::f64::consts::TAU;

    fn cosines(shape: [usize; 2]) -> HeightMap {
        let grid = Grid::new(shape, [3.0 / shape[0] as f64, 2.0 / shape[1] as f64]).unwrap();
        let place = |i: usize, n: usize| PI * (i as f64 + 0.5) / n as f64;
        let wave = |i: usize| {
            let (y, x) = (place(i / shape[1], shape[0]), place(i % shape[1], shape[1]));
            5.0 + (3.0 * x).cos() + 0.7 * (4.0 * x).cos() * (2.0 * y).cos() - (5.0 * y).cos()
        };
        HeightMap::new(grid, (0..grid.len()).map(wave).collect()).unwrap()
    }

    #[test]
    fn mirror_images_meet_at_every_edge() {
        let grid = Grid::new([2, 3], [1.0, 2.0]).unwrap();
        let map = HeightMap::new(grid, vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0]).unwrap();
        let whole = mirrored(&map).unwrap();
        assert_eq!((whole.grid().shape(), whole.grid().pixel()), ([4, 6], [1.0, 2.0]));
        let row = |y: usize| (0..6).map(|x| whole.at(y, x)).collect::<Vec<_>>();
        assert_eq!(row(0), [1.0, 2.0, 3.0, 3.0, 2.0, 1.0]);
        assert_eq!(row(1), [4.0, 5.0, 6.0, 6.0, 5.0, 4.0]);
        assert_eq!((row(0), row(1)), (row(3), row(2)));
    }

    #[test]
    fn cosines_that_both_grids_hold_are_kept() {
        for (from, to) in [([8, 7], [16, 21]), ([12, 10], [6, 5]), ([9, 9], [9, 9])] {
            let found = resample(&cosines(from), to, Edges::Open).unwrap();
            let expected = cosines(to);
            assert_eq!(found.grid(), expected.grid());
            for (a, b) in found.heights().iter().zip(expected.heights()) {
                assert_abs_diff_eq!(a, b, epsilon = 1e-13);
            }
        }
    }

    /// Mirrored, but for the kink at its ends; its periodic interpolation swings out by a tenth.
    #[test]
    fn a_ramp_keeps_its_range() {
        let grid = Grid::new([4, 64], [1.0, 1.0]).unwrap();
        let ramp = HeightMap::from_fn(grid, |_, x| x).unwrap();
        let (low, high) = resample(&ramp, [4, 256], Edges::Open).unwrap().range();
        assert!(low > -0.6 && high < 63.6, "{low} {high}");
        let periodic = resample(&ramp, [4, 256], Edges::Periodic).unwrap();
        assert!(periodic.range().1 > 66.0);
        assert!(resample(&ramp, [0, 5], Edges::Open).is_err());
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

    /// Also with waves of two pixels.
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
}
