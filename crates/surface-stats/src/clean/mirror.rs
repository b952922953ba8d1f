//! Maps that do not repeat, continued by their mirror images.

use crate::StatsError;
use contact_types::{Grid, HeightMap};
use grid_fft::{Complex, GridFft};
use std::f64::consts::PI;

/// The same area on another number of points, for a map that does not repeat.
///
/// The pixels stay inside the area: point i stands for the pixel from `i dx` to `(i + 1) dx`. The
/// map is continued by its mirror images, which have no jump, so that no wave of the seam rings
/// into the map as it does with [`resample`](super::resample) of a periodic one. Cosines that both
/// grids hold are kept exactly, shorter ones are dropped.
///
/// # Errors
/// [`StatsError::Surface`] for an empty or too large shape.
pub fn resample_mirrored(map: &HeightMap, shape: [usize; 2]) -> Result<HeightMap, StatsError> {
    let [ly, lx] = map.grid().size();
    let grid = Grid::new(shape, [ly / shape[0].max(1) as f64, lx / shape[1].max(1) as f64])?;
    let [ny, nx] = map.grid().shape();
    let mean = map.mean();
    let field: Vec<f64> = map.heights().iter().map(|h| h - mean).collect();
    let wide = transpose(&along_rows(&field, nx, shape[1]), ny, shape[1]);
    let mut heights = transpose(&along_rows(&wide, ny, shape[0]), shape[1], shape[0]);
    for h in &mut heights {
        *h += mean;
    }
    Ok(HeightMap::new(grid, heights)?)
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
            let found = resample_mirrored(&cosines(from), to).unwrap();
            let expected = cosines(to);
            assert_eq!(found.grid(), expected.grid());
            for (a, b) in found.heights().iter().zip(expected.heights()) {
                assert_abs_diff_eq!(a, b, epsilon = 1e-13);
            }
        }
    }

    /// A ramp does not repeat: mirrored it stays between its ends but for the kink there, while its
    /// periodic interpolation swings out by a tenth of the range.
    #[test]
    fn a_ramp_keeps_its_range() {
        let grid = Grid::new([4, 64], [1.0, 1.0]).unwrap();
        let ramp = HeightMap::from_fn(grid, |_, x| x).unwrap();
        let (low, high) = resample_mirrored(&ramp, [4, 256]).unwrap().range();
        assert!(low > -0.6 && high < 63.6, "{low} {high}");
        let periodic = crate::clean::resample(&ramp, [4, 256], crate::Edges::Periodic).unwrap();
        assert!(periodic.range().1 > 66.0);
    }
}
