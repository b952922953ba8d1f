//! Normal equations of small least-squares problems.

use faer::{Mat, Side};

/// Eigenvalues of the normal matrix below this fraction of the largest belong to combinations
/// of terms that the points cannot tell apart; those combinations are left out.
const RANK_TOLERANCE: f64 = 1e-12;

/// Sums `b bᵀ` and `b r` over points with basis values `b` and residuals `r`.
pub(crate) struct NormalEquations {
    matrix: Mat<f64>,
    right: Vec<f64>,
}

impl NormalEquations {
    pub(crate) fn new(terms: usize) -> Self {
        Self { matrix: Mat::zeros(terms, terms), right: vec![0.0; terms] }
    }

    /// Adds to one entry of the lower triangle of the matrix.
    pub(crate) fn add_product(&mut self, row: usize, column: usize, product: f64) {
        self.matrix[(row, column)] += product;
    }

    /// Adds to one entry of the right-hand side.
    pub(crate) fn add_right(&mut self, row: usize, product: f64) {
        self.right[row] += product;
    }

    /// Adds one point.
    pub(crate) fn add_point(&mut self, basis: &[f64], residual: f64) {
        for (i, b) in basis.iter().enumerate() {
            self.right[i] += b * residual;
            for (j, c) in basis[..=i].iter().enumerate() {
                self.matrix[(i, j)] += b * c;
            }
        }
    }

    /// The solution in the space of eigenvectors that the points determine. Terms are scaled to
    /// equal weight first, so that their units do not matter.
    pub(crate) fn solve(mut self) -> Vec<f64> {
        let n = self.right.len();
        let scale: Vec<f64> = (0..n)
            .map(|i| self.matrix[(i, i)].sqrt())
            .map(|s| if s > 0.0 { s.recip() } else { 0.0 })
            .collect();
        for i in 0..n {
            self.right[i] *= scale[i];
            for j in 0..=i {
                self.matrix[(i, j)] *= scale[i] * scale[j];
            }
        }
        let eigen = self
            .matrix
            .self_adjoint_eigen(Side::Lower)
            .expect("a symmetric matrix of finite numbers has eigenvectors");
        let (vectors, values) = (eigen.U(), eigen.S().column_vector());
        let largest = (0..n).map(|k| values[k]).fold(0.0, f64::max);
        let mut solution = vec![0.0; n];
        for k in (0..n).filter(|&k| values[k] > RANK_TOLERANCE * largest) {
            let projection: f64 = (0..n).map(|i| vectors[(i, k)] * self.right[i]).sum();
            for (i, s) in solution.iter_mut().enumerate() {
                *s += scale[i] * vectors[(i, k)] * projection / values[k];
            }
        }
        solution
    }
}
