//! Sums over fields. Each is made of partial sums over blocks of fixed length, so that the result
//! does not depend on the number of threads, and is accumulated in `f64`.

use crate::Real;

/// Pixels per partial sum.
const BLOCK: usize = 4096;

/// Sum of `term(i)` over `0..n`.
pub(crate) fn sum_of(n: usize, term: impl Fn(usize) -> f64 + Sync) -> f64 {
    let block = |k: usize| -> f64 { (k * BLOCK..((k + 1) * BLOCK).min(n)).map(&term).sum() };
    let blocks = n.div_ceil(BLOCK);
    #[cfg(feature = "parallel")]
    {
        use rayon::prelude::*;
        if blocks > 4 {
            let partial: Vec<f64> = (0..blocks).into_par_iter().map(block).collect();
            return partial.iter().sum();
        }
    }
    (0..blocks).map(block).sum()
}

/// Sum of a field.
pub(crate) fn sum<T: Real>(a: &[T]) -> f64 {
    sum_of(a.len(), |i| a[i].wide())
}

/// Inner product of two fields.
pub(crate) fn dot<T: Real>(a: &[T], b: &[T]) -> f64 {
    sum_of(a.len(), |i| a[i].wide() * b[i].wide())
}

/// Largest value; `-inf` for an empty field.
pub(crate) fn max<T: Real>(a: &[T]) -> f64 {
    a.iter().fold(f64::NEG_INFINITY, |m, x| m.max(x.wide()))
}

/// Smallest value; `+inf` for an empty field.
pub(crate) fn min<T: Real>(a: &[T]) -> f64 {
    a.iter().fold(f64::INFINITY, |m, x| m.min(x.wide()))
}

/// Number of pixels that carry pressure.
pub(crate) fn contact_count<T: Real>(pressure: &[T]) -> usize {
    pressure.iter().filter(|p| **p > T::zero()).count()
}
