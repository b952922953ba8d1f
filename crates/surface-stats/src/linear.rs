//! Normal equations of small least-squares problems.

/// Pivots below this fraction of the largest belong to terms that the points cannot tell from those taken before;
/// their coefficients are 0.
const RANK_TOLERANCE: f64 = 1e-12;

/// Sum of terms, eight at a time: the processor need not wait for each.
pub(crate) fn sum(mut terms: impl ExactSizeIterator<Item = f64>) -> f64 {
    let mut sums = [0.0; 8];
    while terms.len() > 0 {
        sums.iter_mut().zip(&mut terms).for_each(|(sum, term)| *sum += term);
    }
    sums.iter().sum()
}

/// Sums `b bᵀ` and `b r` over points with basis values `b` and residuals `r`.
pub(crate) struct NormalEquations {
    /// Rows of the lower triangle.
    pub(crate) matrix: Vec<Vec<f64>>,
    pub(crate) right: Vec<f64>,
}

impl NormalEquations {
    pub(crate) fn new(terms: usize) -> Self {
        Self { matrix: vec![vec![0.0; terms]; terms], right: vec![0.0; terms] }
    }

    pub(crate) fn add_point(&mut self, basis: &[f64], residual: f64) {
        for (i, b) in basis.iter().enumerate() {
            self.right[i] += b * residual;
            for (j, c) in basis[..=i].iter().enumerate() {
                self.matrix[i][j] += b * c;
            }
        }
    }

    /// Coefficients of the terms that the points determine, the largest pivot first. Terms are scaled to equal weight
    /// first, so that their units do not matter.
    pub(crate) fn solve(self) -> Vec<f64> {
        let (mut right, n) = (self.right, self.matrix.len());
        let scale: Vec<f64> = (0..n)
            .map(|i| self.matrix[i][i].sqrt())
            .map(|s| if s > 0.0 { s.recip() } else { 0.0 })
            .collect();
        let whole = |i: usize, j: usize| self.matrix[i.max(j)][i.min(j)] * scale[i] * scale[j];
        let mut a: Vec<Vec<f64>> = (0..n).map(|i| (0..n).map(|j| whole(i, j)).collect()).collect();
        right.iter_mut().zip(&scale).for_each(|(r, s)| *r *= s);
        // Gauss and Jordan's elimination: what is left of the diagonal is the part of each term that is new.
        let mut is_taken = vec![false; n];
        while let Some(k) = (0..n)
            .rev() // of equal pivots the first
            .filter(|&k| !is_taken[k] && a[k][k] > RANK_TOLERANCE)
            .max_by(|&i, &j| a[i][i].total_cmp(&a[j][j]))
        {
            is_taken[k] = true;
            let (row, value) = (a[k].clone(), right[k]);
            for i in (0..n).filter(|i| *i != k) {
                let factor = a[i][k] / row[k];
                a[i].iter_mut().zip(&row).for_each(|(x, r)| *x -= factor * r);
                right[i] -= factor * value;
            }
        }
        let solution = |k: usize| if is_taken[k] { scale[k] * right[k] / a[k][k] } else { 0.0 };
        (0..n).map(solution).collect()
    }
}
