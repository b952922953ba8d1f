//! Cholesky's factorisation of the matrix of a network.

use faer::linalg::solvers::Solve as _;
use faer::sparse::linalg::solvers::{Llt, SymbolicLlt};
use faer::sparse::{SparseColMat, Triplet};
use faer::{Mat, Side};

/// Most unknowns whose matrix is factorised.
const MOST: usize = 1 << 23;

/// What the factorisations of all networks of the same links share.
pub(crate) type Symbolic = Option<SymbolicLlt<usize>>;

/// The factors of the matrix scaled to the diagonal 1, and the scale.
pub(crate) struct Cholesky(Llt<usize, f64>, Vec<f64>);

impl Cholesky {
    /// From links and their conductances, and the diagonal of the matrix, infinite where the potential is 0; `None` where it is too
    /// large.
    pub(crate) fn of(
        (links, conductances): (&[[usize; 2]], &[f64]),
        diagonal: &[f64],
        symbolic: &mut Symbolic,
    ) -> Option<Self> {
        let scale: Vec<f64> = diagonal.iter().map(|d| d.sqrt().recip()).collect();
        if scale.len() > MOST {
            return None;
        }
        // Rounding may leave a pool behind an almost closed gap without a positive pivot: conjugate gradients mend
        // what a shift of the diagonal does to it.
        let factors = [0.0, 1e-14, 1e-10]
            .iter()
            .find_map(|&s| shifted((links, conductances), &scale, s, symbolic))?;
        Some(Self(factors, scale))
    }

    pub(crate) fn solve(&self, right: &[f64]) -> Vec<f64> {
        let Self(factors, scale) = self;
        let solved = factors.solve(Mat::from_fn(scale.len(), 1, |i, _| scale[i] * right[i]));
        scale.iter().enumerate().map(|(i, scale)| scale * solved[(i, 0)]).collect()
    }
}

fn shifted(
    (links, conductances): (&[[usize; 2]], &[f64]),
    scale: &[f64],
    shift: f64,
    symbolic: &mut Symbolic,
) -> Option<Llt<usize, f64>> {
    let n = scale.len();
    let on_diagonal = (0..n).map(|i| Triplet::new(i, i, 1.0 + shift));
    let links = links.iter().zip(conductances).filter(|&(&[a, b], _)| scale[a] * scale[b] > 0.0);
    let below = links.map(|(&[a, b], c)| Triplet::new(b, a, -c * scale[a] * scale[b]));
    let entries: Vec<_> = on_diagonal.chain(below).collect();
    let matrix = SparseColMat::try_new_from_triplets(n, n, &entries).ok()?;
    drop(entries);
    if symbolic.is_none() {
        *symbolic = SymbolicLlt::try_new(matrix.symbolic(), Side::Lower).ok();
    }
    Llt::try_new_with_symbolic(symbolic.clone()?, matrix.as_ref(), Side::Lower).ok()
}
