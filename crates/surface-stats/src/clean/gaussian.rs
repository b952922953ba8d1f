//! Gaussian S- and L-filters.

use crate::{StatsError, scale};
use contact_types::Grid;
use std::f64::consts::{LN_2, PI};

/// Weights are cut where they fall below 10⁻¹⁴ of the largest: 1.5 cut-off wavelengths.
const REACH: f64 = 1.5;

/// The long waves of `heights` (m, row-major, NaN = missing): at the cut-off wavelength half of
/// an amplitude passes.
///
/// ```math
/// s(x, y) = \frac{1}{\alpha^2\lambda_c^2}
///           \exp\Big(-\pi\frac{x^2+y^2}{\alpha^2\lambda_c^2}\Big), \quad
/// \alpha = \sqrt{\frac{\ln 2}{\pi}}, \qquad
/// \frac{a_1}{a_0} = 2^{-(\lambda_c/\lambda)^2}
/// ```
///
/// Near edges and missing points, which stay missing, the weights that fall on valid points are scaled to sum 1. A constant
/// passes unchanged everywhere; within one cut-off of an edge a tilt does not.
///
/// # Source
/// ISO 16610-61:2015 (areal Gaussian filter).
pub(crate) fn gaussian_filter(
    grid: Grid,
    heights: &[f64],
    cutoff: f64,
) -> Result<Vec<f64>, StatsError> {
    let ([ny, nx], [dy, dx]) = (grid.shape(), grid.pixel());
    let resolved = cutoff.is_finite() && cutoff >= 2.0 * dy.max(dx);
    let requirement = "must be finite and at least two pixels";
    StatsError::require("cut-off wavelength of the filter", cutoff, resolved, requirement)?;
    scale::check_measured(grid, heights)?;
    let Some(origin) = heights.iter().copied().find(|h| !h.is_nan()) else {
        return Ok(heights.to_vec());
    };
    let kernel = [weights(cutoff, dy, ny), weights(cutoff, dx, nx)];
    let raised: Vec<f64> =
        heights.iter().map(|h| if h.is_nan() { 0.0 } else { h - origin }).collect();
    let mut filtered = weighted_sums([ny, nx], raised, &kernel);
    // Sums of the weights that fell on valid points: a product of two profiles if none is missing.
    if heights.iter().all(|h| !h.is_nan()) {
        let sums = |n: usize, kernel: &[f64]| {
            weighted_sums([1, n], vec![1.0; n], &[vec![1.0], kernel.to_vec()])
        };
        let (sum_y, sum_x) = (sums(ny, &kernel[0]), sums(nx, &kernel[1]));
        for (i, z) in filtered.iter_mut().enumerate() {
            *z = origin + *z / (sum_y[i / nx] * sum_x[i % nx]);
        }
    } else {
        let valid = heights.iter().map(|h| if h.is_nan() { 0.0 } else { 1.0 });
        let sums = weighted_sums([ny, nx], valid.collect(), &kernel);
        for ((z, sum), h) in filtered.iter_mut().zip(sums).zip(heights) {
            *z = if h.is_nan() { f64::NAN } else { origin + *z / sum };
        }
    }
    Ok(filtered)
}

/// What [`gaussian_filter`] takes off `heights`: the short waves.
pub(crate) fn short_waves(
    grid: Grid,
    heights: &[f64],
    cutoff: f64,
) -> Result<Vec<f64>, StatsError> {
    let long = gaussian_filter(grid, heights, cutoff)?;
    Ok(long.into_iter().zip(heights).map(|(long, h)| h - long).collect())
}

/// Half of the symmetric weights along one axis, from the middle outwards.
fn weights(cutoff: f64, pixel: f64, n: usize) -> Vec<f64> {
    let reach = ((REACH * cutoff / pixel).ceil() as usize).min(n - 1);
    let alpha_square = LN_2 / PI;
    let weight = |k: usize| {
        let x = k as f64 * pixel / cutoff;
        (-PI * x * x / alpha_square).exp()
    };
    (0..=reach).map(weight).collect()
}

/// Separable convolution with the two half kernels `[along y, along x]`; nothing lies beyond the
/// edges.
fn weighted_sums([ny, nx]: [usize; 2], mut field: Vec<f64>, kernel: &[Vec<f64>; 2]) -> Vec<f64> {
    let mut line = vec![0.0; nx];
    for row in field.chunks_exact_mut(nx) {
        line.fill(0.0);
        for (k, weight) in kernel[1].iter().enumerate() {
            add_scaled(&mut line[..nx - k], &row[k..], *weight);
            if k > 0 {
                add_scaled(&mut line[k..], &row[..nx - k], *weight);
            }
        }
        row.copy_from_slice(&line);
    }
    let mut out = vec![0.0; field.len()];
    for (iy, row) in out.chunks_exact_mut(nx).enumerate() {
        for (k, weight) in kernel[0].iter().enumerate() {
            if iy + k < ny {
                add_scaled(row, &field[(iy + k) * nx..(iy + k + 1) * nx], *weight);
            }
            if k > 0 && iy >= k {
                add_scaled(row, &field[(iy - k) * nx..(iy - k + 1) * nx], *weight);
            }
        }
    }
    out
}

fn add_scaled(sum: &mut [f64], terms: &[f64], weight: f64) {
    for (s, t) in sum.iter_mut().zip(terms) {
        *s += weight * t;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::{assert_abs_diff_eq, assert_relative_eq};
    use contact_types::HeightMap;
    use std::f64::consts::TAU;

    /// Transmission 2^-(λc/λ)² of an oblique wave, to the sampling of the weights away from the edges.
    #[test]
    fn transmission_of_a_wave() {
        let grid = Grid::new([160, 240], [1.5, 1.0]).unwrap();
        for (ky, kx) in [(10, 10), (6, 8), (20, 0), (0, 3)] {
            let q = [TAU * f64::from(ky) / 240.0, TAU * f64::from(kx) / 240.0];
            let wave = |y: f64, x: f64| (q[0] * y + q[1] * x).cos();
            let map = HeightMap::from_fn(grid, |y, x| 3.0 + wave(y, x)).unwrap();
            for cutoff in [8.0, 17.0] {
                let ratio = cutoff * q[0].hypot(q[1]) / TAU;
                let transmission = 2f64.powf(-ratio * ratio);
                // What sampled weights let through of the first alias, on the coarser side.
                let sampling = 4.0 * 2f64.powf(-(cutoff / 1.5 - ratio).powi(2)) + 1e-12;
                let found = gaussian_filter(grid, map.heights(), cutoff).unwrap();
                for (iy, ix) in (25..135).flat_map(|iy| (30..210).map(move |ix| (iy, ix))) {
                    let expected = 3.0 + transmission * wave(1.5 * iy as f64, ix as f64);
                    assert_abs_diff_eq!(found[240 * iy + ix], expected, epsilon = sampling);
                }
            }
        }
    }

    /// A constant passes to the very corner; missing points far away change nothing.
    #[test]
    fn missing_points_stay_missing_and_are_local() {
        let grid = Grid::new([64, 64], [1.0, 2.0]).unwrap();
        let map = HeightMap::from_fn(grid, |y, x| (0.3 * x).sin() + (0.7 * y + 0.1 * x).cos());
        let filtered = |heights: &[f64]| gaussian_filter(grid, heights, 6.0).unwrap();
        let [mut flat, mut wavy] = [vec![76e-3; 64 * 64], map.unwrap().into_heights()];
        let long = filtered(&wavy);
        for heights in [&mut flat, &mut wavy] {
            for range in [0..50, 100..103, 400..401] {
                heights[range].fill(f64::NAN);
            }
        }
        for (f, h) in filtered(&flat).iter().zip(&flat) {
            assert_eq!(f.is_nan(), h.is_nan());
            assert!(f.is_nan() || (f - 76e-3).abs() < 1e-16);
        }
        for (now, before) in filtered(&wavy)[64 * 20..].iter().zip(&long[64 * 20..]) {
            assert_relative_eq!(now, before, epsilon = 1e-14);
        }
    }

    #[test]
    fn senseless_cutoffs_are_refused() {
        let grid = Grid::new([4, 4], [1.0, 2.0]).unwrap();
        for cutoff in [0.0, 3.9, f64::NAN, f64::INFINITY] {
            let error = gaussian_filter(grid, &[0.0; 16], cutoff);
            assert!(matches!(error, Err(StatsError::BadSetting { .. })), "{cutoff}");
        }
        assert!(gaussian_filter(grid, &[f64::NAN; 16], 4.0).is_ok());
    }
}
