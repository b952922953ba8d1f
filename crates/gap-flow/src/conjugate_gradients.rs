//! Potentials in a network of conductances, by conjugate gradients behind Cholesky's factorisation of its matrix.

#[cfg(feature = "cholesky")]
pub(crate) use crate::cholesky::{Cholesky, Symbolic};

/// What the factorisations of all networks of the same links share: nothing.
#[cfg(not(feature = "cholesky"))]
#[derive(Default)]
pub(crate) struct Symbolic(());

/// Error over the potential in the energy norm, as the factorisation estimates it, at which the iteration ends.
const TOLERANCE: f64 = 1e-14;
const MOST_ITERATIONS: usize = 20_000;

/// The iteration did not converge.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[error(
    "the flow through the gap is not solved after {iterations} iterations; take every second point of the map"
)]
#[non_exhaustive]
pub struct NotSolved {
    /// Iterations done.
    pub iterations: usize,
}

/// Nodes and links with drops of potential in them. In equilibrium what flows to a node flows away.
pub(crate) struct Network<'a> {
    /// Pairs of nodes, the lower first, in rising order of it.
    pub(crate) links: &'a [[usize; 2]],
    pub(crate) conductances: Vec<f64>,
    /// What each link adds to the fall of potential from its first node to its second.
    pub(crate) drops: &'a [f64],
    /// Conductance of each node to potential 0: none, or infinite.
    pub(crate) ground: &'a [f64],
}

/// What approximates the inverse of the matrix.
enum Factor {
    /// Cholesky's factors of the matrix.
    #[cfg(feature = "cholesky")]
    Whole(Cholesky),
    /// Pivots of the factorisation that keeps the pattern of the matrix.
    Incomplete(Vec<f64>),
}

impl Network<'_> {
    /// Conductance of each link and the fall of potential over it.
    pub(crate) fn falls<'b>(&'b self, potentials: &'b [f64]) -> impl Iterator<Item = [f64; 2]> {
        let links = self.links.iter().zip(&self.conductances).zip(self.drops);
        links.map(|((&[a, b], c), drop)| [*c, potentials[a] - potentials[b] + drop])
    }

    /// The matrix times potentials: what flows away from each node without the drops.
    fn outflow(&self, potentials: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        for (&[a, b], c) in self.links.iter().zip(&self.conductances) {
            let flow = c * (potentials[a] - potentials[b]);
            out[a] += flow;
            out[b] -= flow;
        }
    }

    /// What is dissipated: the flow if the drop is 1, with an error of second order in the potentials.
    pub(crate) fn dissipation(&self, potentials: &[f64]) -> f64 {
        self.falls(potentials).map(|[c, fall]| c * fall.powi(2)).sum()
    }

    /// The potentials. `symbolic` is kept for another network of the
    /// same links.
    pub(crate) fn solve(&self, symbolic: &mut Symbolic) -> Result<Vec<f64>, NotSolved> {
        let n = self.ground.len();
        let factor = self.factor(symbolic);
        let mut x = vec![0.0; n];
        let mut residual = vec![0.0; n];
        for ((&[a, b], c), drop) in self.links.iter().zip(&self.conductances).zip(self.drops) {
            residual[a] -= c * drop;
            residual[b] += c * drop;
        }
        let mut step = self.precondition(&factor, &residual);
        let mut product = vec![0.0; n];
        let first = dot(&residual, &step);
        let mut energy = first;
        for _ in 0..MOST_ITERATIONS {
            self.outflow(&step, &mut product);
            let length = energy / dot(&step, &product);
            for i in 0..n {
                x[i] += length * step[i];
                residual[i] -= length * product[i];
            }
            let corrected = self.precondition(&factor, &residual);
            let next = dot(&residual, &corrected);
            if next <= TOLERANCE * TOLERANCE * first {
                return Ok(x);
            }
            for (step, corrected) in step.iter_mut().zip(&corrected) {
                *step = corrected + next / energy * *step;
            }
            energy = next;
        }
        Err(NotSolved { iterations: MOST_ITERATIONS })
    }

    fn factor(&self, symbolic: &mut Symbolic) -> Factor {
        let mut pivots = self.ground.to_vec();
        for (&[a, b], c) in self.links.iter().zip(&self.conductances) {
            pivots[a] += c;
            pivots[b] += c;
        }
        #[cfg(not(feature = "cholesky"))]
        let _ = symbolic;
        #[cfg(feature = "cholesky")]
        if let Some(whole) = Cholesky::of((self.links, &self.conductances), &pivots, symbolic) {
            return Factor::Whole(whole);
        }
        for (&[a, b], c) in self.links.iter().zip(&self.conductances) {
            pivots[b] -= c * c / pivots[a];
        }
        Factor::Incomplete(pivots)
    }

    fn precondition(&self, factor: &Factor, residual: &[f64]) -> Vec<f64> {
        match factor {
            #[cfg(feature = "cholesky")]
            Factor::Whole(cholesky) => cholesky.solve(residual),
            Factor::Incomplete(pivots) => {
                let mut out = residual.to_vec();
                let links = self.links.iter().zip(&self.conductances);
                for (&[a, b], c) in links.clone() {
                    out[b] += c * out[a] / pivots[a];
                }
                out.iter_mut().zip(pivots).for_each(|(out, pivot)| *out /= pivot);
                for (&[a, b], c) in links.rev() {
                    out[a] += c * out[b] / pivots[a];
                }
                out
            }
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
