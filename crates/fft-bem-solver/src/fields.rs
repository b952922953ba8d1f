//! Sums over fields. Each is made of partial sums over blocks of fixed length, so that the result
//! does not depend on the number of threads, and is accumulated in `f64`.

use crate::Real;
use grid_fft::parallel::prelude::*;
use std::ops::Range;

/// Pixels per partial sum.
const BLOCK: usize = 4096;

/// `piece(range)` of every block of `0..n`, in order.
fn by_blocks(n: usize, piece: impl Fn(Range<usize>) -> f64 + Sync) -> Vec<f64> {
    let mut partial = vec![0.0; n.div_ceil(BLOCK)];
    let block = |(k, x): (usize, &mut f64)| *x = piece(k * BLOCK..((k + 1) * BLOCK).min(n));
    if partial.len() > 4 {
        partial.par_iter_mut().enumerate().for_each(block);
    } else {
        partial.iter_mut().enumerate().for_each(block);
    }
    partial
}

/// Sum of `term(i)` over `0..n`.
pub(crate) fn sum_of(n: usize, term: impl Fn(usize) -> f64 + Sync) -> f64 {
    by_blocks(n, |range| range.map(&term).sum()).iter().sum()
}

/// Least `term(i)` over `0..n`; `+inf` if there is none.
pub(crate) fn least_of(n: usize, term: impl Fn(usize) -> f64 + Sync) -> f64 {
    let piece = |range: Range<usize>| range.map(&term).fold(f64::INFINITY, f64::min);
    by_blocks(n, piece).into_iter().fold(f64::INFINITY, f64::min)
}

/// `value(i)` for every pixel.
pub(crate) fn filled<T: Real>(n: usize, value: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let mut field = vec![T::zero(); n];
    field.par_chunks_mut(BLOCK).enumerate().for_each(|(k, block)| {
        for (i, x) in block.iter_mut().enumerate() {
            *x = value(k * BLOCK + i);
        }
    });
    field
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
    -least_of(a.len(), |i| -a[i].wide())
}

/// Smallest value; `+inf` for an empty field.
pub(crate) fn min<T: Real>(a: &[T]) -> f64 {
    least_of(a.len(), |i| a[i].wide())
}

/// Number of pixels that carry pressure.
pub(crate) fn contact_count<T: Real>(pressure: &[T]) -> usize {
    sum_of(pressure.len(), |i| if pressure[i] > T::zero() { 1.0 } else { 0.0 }) as usize
}
