//! In place of [`cholesky`](../cholesky.rs) without the feature.

#[derive(Default)]
pub(crate) struct Symbolic(());

/// There is none.
pub(crate) enum Cholesky {}

impl Cholesky {
    pub(crate) fn of(_: (&[[usize; 2]], &[f64]), _: &[f64], _: &mut Symbolic) -> Option<Self> {
        None
    }

    pub(crate) fn solve(&self, _: &[f64]) -> Vec<f64> {
        match *self {}
    }
}
