//! Least-squares polynomial surfaces through the valid points of a map.
//!
//! Written in Legendre polynomials of coordinates scaled to -1..1, so that the normal equations
//! are well conditioned at every degree offered, and repeated on the residual, so that a form a
//! million times higher than the roughness leaves no trace of its own rounding.

use crate::StatsError;
use contact_types::Grid;
use faer::{Mat, Side};

/// Highest total degree offered.
pub const MAX_DEGREE: usize = 12;

/// Eigenvalues of the normal matrix below this fraction of the largest belong to combinations
/// of terms that the points cannot tell apart; those combinations are left out.
const RANK_TOLERANCE: f64 = 1e-12;

/// A polynomial in x and y of limited total degree.
#[derive(Debug, Clone, PartialEq)]
pub struct Polynomial {
    degree: usize,
    grid: Grid,
    origin: f64,
    coefficients: Vec<f64>,
}

impl Polynomial {
    /// Fits all terms up to total degree `degree` (0 mean, 1 plane, 2 quadratic, ...) to the
    /// points of `heights` (m, row-major) that are not NaN. Combinations of terms that these
    /// points cannot determine (a tilt across a single row) are left at zero.
    ///
    /// # Errors
    /// [`StatsError::BadSetting`] above degree 12, [`StatsError::Shape`], or
    /// [`StatsError::TooFewPoints`] without a valid point.
    pub fn fit(grid: Grid, heights: &[f64], degree: usize) -> Result<Self, StatsError> {
        if degree > MAX_DEGREE {
            return Err(StatsError::BadSetting {
                setting: "degree of the polynomial",
                value: degree as f64,
                requirement: "must be at most 12",
            });
        }
        if heights.len() != grid.len() {
            let (expected, found) = (grid.len(), heights.len());
            return Err(StatsError::Shape { what: "heights", expected, found });
        }
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

    /// Replaces every valid height by its distance above the polynomial.
    ///
    /// # Panics
    /// If `heights` does not have the pixels of the grid that was fitted.
    pub fn remove_from(&self, heights: &mut [f64]) {
        assert_eq!(heights.len(), self.grid.len(), "heights of another grid");
        self.for_each_row(|iy, rows, columns| {
            let nx = columns[0].len();
            for (ix, h) in heights[iy * nx..(iy + 1) * nx].iter_mut().enumerate() {
                *h = (*h - self.origin) - self.value(rows, columns, ix);
            }
        });
    }

    /// Sum of squares of (polynomial - its mean) over sum of squares of (heights - their mean),
    /// over the valid points: the share of the height variance that the form explains. 0 for a
    /// flat map.
    pub fn explained(&self, heights: &[f64]) -> f64 {
        let mut residual = [0.0; 3];
        let mut total = [0.0; 3];
        let count = |sums: &mut [f64; 3], z: f64| {
            sums[0] += 1.0;
            sums[1] += z;
            sums[2] += z * z;
        };
        self.for_each_row(|iy, rows, columns| {
            let nx = columns[0].len();
            for (ix, h) in heights[iy * nx..(iy + 1) * nx].iter().enumerate() {
                if !h.is_nan() {
                    let z = h - self.origin;
                    count(&mut total, z);
                    count(&mut residual, z - self.value(rows, columns, ix));
                }
            }
        });
        let variance = |s: [f64; 3]| s[2] - s[1] * s[1] / s[0];
        let (kept, all) = (variance(residual), variance(total));
        if all > 0.0 { (1.0 - kept / all).clamp(0.0, 1.0) } else { 0.0 }
    }

    fn value(&self, rows: &[f64], columns: &[Vec<f64>], ix: usize) -> f64 {
        terms(self.degree)
            .zip(&self.coefficients)
            .map(|([ky, kx], coefficient)| coefficient * rows[ky] * columns[kx][ix])
            .sum()
    }

    /// Calls `visit(iy, P_k(v) for all k, P_k(u) for all k and columns)` row by row.
    fn for_each_row(&self, mut visit: impl FnMut(usize, &[f64], &[Vec<f64>])) {
        let [ny, nx] = self.grid.shape();
        let mut columns = vec![vec![0.0; nx]; self.degree + 1];
        for ix in 0..nx {
            for (column, value) in columns.iter_mut().zip(legendre(scaled(ix, nx))) {
                column[ix] = value;
            }
        }
        for iy in 0..ny {
            visit(iy, &legendre(scaled(iy, ny)), &columns);
        }
    }

    /// Coefficients that fit what the present ones leave over: the normal equations, solved in
    /// the space of eigenvectors that the points determine.
    fn solve_for_residual(&self, heights: &[f64]) -> Vec<f64> {
        let n = self.coefficients.len();
        let mut normal = Mat::<f64>::zeros(n, n);
        let mut right = vec![0.0; n];
        let mut basis = vec![0.0; n];
        self.for_each_row(|iy, rows, columns| {
            let nx = columns[0].len();
            // Sums of one row first: fewer digits lost than in one long sum.
            let (mut row_normal, mut row_right) = (vec![0.0; n * n], vec![0.0; n]);
            for (ix, h) in heights[iy * nx..(iy + 1) * nx].iter().enumerate() {
                if h.is_nan() {
                    continue;
                }
                for (b, [ky, kx]) in basis.iter_mut().zip(terms(self.degree)) {
                    *b = rows[ky] * columns[kx][ix];
                }
                let fitted: f64 = self.coefficients.iter().zip(&basis).map(|(c, b)| c * b).sum();
                let residual = (h - self.origin) - fitted;
                for i in 0..n {
                    row_right[i] += basis[i] * residual;
                    for j in 0..=i {
                        row_normal[i * n + j] += basis[i] * basis[j];
                    }
                }
            }
            for i in 0..n {
                right[i] += row_right[i];
                for j in 0..=i {
                    normal[(i, j)] += row_normal[i * n + j];
                }
            }
        });
        let eigen = normal
            .self_adjoint_eigen(Side::Lower)
            .expect("a symmetric matrix of finite numbers has eigenvectors");
        let (vectors, values) = (eigen.U(), eigen.S().column_vector());
        let largest = (0..n).map(|k| values[k]).fold(0.0, f64::max);
        let mut solution = vec![0.0; n];
        for k in (0..n).filter(|&k| values[k] > RANK_TOLERANCE * largest) {
            let projection: f64 = (0..n).map(|i| vectors[(i, k)] * right[i]).sum();
            for (i, s) in solution.iter_mut().enumerate() {
                *s += vectors[(i, k)] * projection / values[k];
            }
        }
        solution
    }
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
