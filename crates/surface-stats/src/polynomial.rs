//! Least-squares polynomial surfaces through the valid points of a map.
//!
//! In Legendre polynomials of coordinates scaled to -1..1, which condition the normal equations, and repeated on the
//! residual, so that a form a million times higher than the roughness leaves no trace of its own rounding.

use crate::linear::{NormalEquations, sum};
use crate::{StatsError, scale};
use contact_types::{Grid, HeightMap};
use grid_fft::parallel::{self, prelude::*};

pub(crate) const MAX_DEGREE: usize = 12;
/// Pixels of a row, and rows, handled at a time.
const TILE: usize = 64;

/// A polynomial in x and y of limited total degree.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Polynomial {
    degree: usize,
    grid: Grid,
    origin: f64,
    coefficients: Vec<f64>,
}

impl Polynomial {
    /// Fits all terms up to total degree `degree` (0 mean, 1 plane, 2 quadratic, ...) to the
    /// points of `heights` (m, row-major) that are not NaN. Terms that these cannot determine are left at zero.
    pub(crate) fn fit(grid: Grid, heights: &[f64], degree: usize) -> Result<Self, StatsError> {
        let (setting, holds) = ("degree of the polynomial", degree <= MAX_DEGREE);
        StatsError::require(setting, degree as f64, holds, "must be at most 12")?;
        scale::check_measured(grid, heights)?;
        let Some(origin) = heights.iter().copied().find(|h| !h.is_nan()) else {
            return Err(StatsError::TooFewPoints { what: "a fit", needed: 1, found: 0 });
        };
        let terms = (degree + 1) * (degree + 2) / 2;
        let mut fit = Self { degree, grid, origin, coefficients: vec![0.0; terms] };
        // The second pass fits what rounding left of the form in the residual of the first.
        for _ in 0..2 {
            let step = fit.solve_for_residual(heights);
            for (coefficient, change) in fit.coefficients.iter_mut().zip(step) {
                *coefficient += change;
            }
        }
        Ok(fit)
    }

    /// The form of degree 0 of a map without missing points.
    pub(crate) fn mean(&self) -> Self {
        Self { degree: 0, coefficients: vec![self.coefficients[0]], ..*self }
    }

    /// Rise of a plane from point to point along `[y, x]` (m).
    pub(crate) fn rises(&self) -> [f64; 2] {
        let [ny, nx] = self.grid.shape();
        let rise = |coefficient: f64, n: usize| coefficient * (scaled(1, n) - scaled(0, n));
        [rise(self.coefficients[2], ny), rise(self.coefficients[1], nx)]
    }

    /// The map that was fitted without the polynomial.
    pub(crate) fn taken_off(&self, map: HeightMap) -> Result<HeightMap, StatsError> {
        let mut heights = map.into_heights();
        self.remove_from(&mut heights);
        Ok(HeightMap::new(self.grid, heights)?)
    }

    /// Replaces every valid height of the grid that was fitted by its distance above the polynomial.
    pub(crate) fn remove_from(&self, heights: &mut [f64]) {
        let [ny, nx] = self.grid.shape();
        let columns = columns(nx, self.degree);
        heights.par_chunks_mut(nx).enumerate().for_each(|(iy, row)| {
            self.remove_from_row(row, &legendre(scaled(iy, ny)), &columns);
        });
    }

    /// The same of one row, whose polynomials of y are `rows`.
    fn remove_from_row(&self, row: &mut [f64], rows: &[f64], columns: &[Vec<f64>]) {
        // Along the row the form is the sum of `along[k] P_k`.
        let mut along = [0.0; MAX_DEGREE + 1];
        for ([ky, kx], coefficient) in terms(self.degree).zip(&self.coefficients) {
            along[kx] += coefficient * rows[ky];
        }
        for (k, heights) in row.chunks_mut(TILE).enumerate() {
            let mut form = [0.0; TILE];
            for (a, column) in along.iter().zip(columns) {
                form.iter_mut().zip(&column[k * TILE..]).for_each(|(form, p)| *form += a * p);
            }
            heights.iter_mut().zip(form).for_each(|(h, form)| *h = (*h - self.origin) - form);
        }
    }

    /// Coefficients that fit what the present ones leave over.
    fn solve_for_residual(&self, heights: &[f64]) -> Vec<f64> {
        let ([ny, nx], k) = (self.grid.shape(), self.degree + 1);
        let columns = columns(nx, self.degree);
        let complete = products(&columns, &(0..nx));
        let mut equations = NormalEquations::new(self.coefficients.len());
        // Along a row only the polynomials of x vary: sum over it first, then over rows.
        let of_row = |iy: usize, row: &mut [f64]| {
            let (rows, mut sums) = (legendre(scaled(iy, ny)), [0.0; MAX_DEGREE + 1]);
            row.copy_from_slice(&heights[iy * nx..(iy + 1) * nx]);
            self.remove_from_row(row, &rows, &columns);
            let valid = (0..nx).filter(|&ix| !row[ix].is_nan());
            let own = row.iter().any(|z| z.is_nan()).then(|| products(&columns, &valid));
            row.iter_mut().filter(|z| z.is_nan()).for_each(|z| *z = 0.0);
            let dot = |column: &[f64]| sum(column.iter().zip(&*row).map(|(p, z)| p * z));
            sums.iter_mut().zip(&columns).for_each(|(sum, column)| *sum = dot(column));
            (rows, sums, own)
        };
        let blocks: Vec<usize> = (0..ny).step_by(TILE).collect();
        let along = parallel::map(&blocks, |&first| -> Vec<_> {
            let mut row = vec![0.0; nx];
            (first..ny.min(first + TILE)).map(|iy| of_row(iy, &mut row)).collect()
        });
        for (rows, sums, own) in along.iter().flatten() {
            let gram = own.as_ref().unwrap_or(&complete);
            for (i, [ky, kx]) in terms(self.degree).enumerate() {
                equations.right[i] += rows[ky] * sums[kx];
                for (j, [my, mx]) in terms(self.degree).enumerate().take(i + 1) {
                    equations.matrix[i][j] += rows[ky] * rows[my] * gram[kx * k + mx];
                }
            }
        }
        equations.solve()
    }
}

/// Legendre polynomials of x by degree and pixel.
fn columns(nx: usize, degree: usize) -> Vec<Vec<f64>> {
    (0..=degree).map(|k| (0..nx).map(|ix| legendre(scaled(ix, nx))[k]).collect()).collect()
}

/// `sum_ix P_i(u) P_j(u)` over the pixels given, as a square matrix.
fn products(columns: &[Vec<f64>], pixels: &(impl Iterator<Item = usize> + Clone)) -> Vec<f64> {
    let pairs = columns.iter().flat_map(|a| columns.iter().map(move |b| (a, b)));
    pairs.map(|(a, b)| pixels.clone().map(|ix| a[ix] * b[ix]).sum()).collect()
}

/// Exponent pairs `[ky, kx]` of all terms up to a total degree.
fn terms(degree: usize) -> impl Iterator<Item = [usize; 2]> {
    (0..=degree).flat_map(|total| (0..=total).map(move |ky| [ky, total - ky]))
}

/// Pixel position scaled to -1..1; 0 for a single pixel.
fn scaled(i: usize, n: usize) -> f64 {
    if n > 1 { 2.0 * i as f64 / (n - 1) as f64 - 1.0 } else { 0.0 }
}

/// Legendre polynomials `P_0(x) .. P_12(x)` by Bonnet's recurrence.
fn legendre(x: f64) -> [f64; MAX_DEGREE + 1] {
    let mut p = [1.0; MAX_DEGREE + 1];
    p[1] = x;
    for k in 1..MAX_DEGREE {
        let n = k as f64;
        p[k + 1] = ((2.0 * n + 1.0) * x * p[k] - n * p[k - 1]) / (n + 1.0);
    }
    p
}
