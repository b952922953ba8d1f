//! The passes over the finest grid that a chord iteration is made of. Each reads and writes every
//! field once, in pieces that belong to one task, and returns sums that do not depend on the
//! number of threads. A pass costs about what it moves: bytes, not operations.

mod contact_set;
mod line_search;
mod preconditioner;
mod step;
mod sums;
mod trial;

pub(crate) use contact_set::{Gap, Residual, is_rounding, level, residual, residual_norm2};
pub(crate) use line_search::{Products, inner_products, reach};
pub(crate) use preconditioner::{gather, push};
pub(crate) use step::{combine, copy, difference};
pub(crate) use trial::{Estimate, end_trial, trial};

use super::extension::Pyramid;
use crate::Real;
use grid_fft::parallel::prelude::*;

/// Pixels that one task of a parallel loop handles, where rows do not matter.
const TASK: usize = 1 << 14;

/// Partial results of the tasks of a pass, in order.
pub(crate) type Partial = [f64; 8];

/// Rows of the finest grid that one task handles: whole rows of cells of the first level.
pub(crate) fn rows_per_task(pyramid: &Pyramid, shape: [usize; 2]) -> usize {
    match pyramid.levels.first() {
        Some(level) => level.rows_per_task() * level.transfer.rows_per_coarse_row(),
        None => shape[0],
    }
}

/// How many partial results a pass over `n` pixels in rows of `nx` needs at most.
pub(crate) fn tasks(n: usize, rows_per_task: usize, nx: usize) -> usize {
    n.div_ceil(rows_per_task * nx).max(n.div_ceil(TASK))
}

/// Adds the partial results up, in order.
pub(crate) fn total<const N: usize>(partial: &[Partial]) -> [f64; N] {
    let mut sum = [0.0; N];
    for x in partial {
        for (sum, x) in sum.iter_mut().zip(x) {
            *sum += x;
        }
    }
    sum
}

/// Adds up what `sums(first pixel, piece)` makes of the pieces of a field.
pub(crate) fn sums<T: Real>(
    field: &[T],
    sums: &(dyn Fn(usize, &[T]) -> Partial + Sync),
    partial: &mut [Partial],
) -> Partial {
    let partial = &mut partial[..field.len().div_ceil(TASK)];
    let pieces = partial.par_iter_mut().zip(field.par_chunks(TASK)).enumerate();
    pieces.for_each(|(task, (partial, piece))| *partial = sums(task * TASK, piece));
    total(partial)
}

/// A field less a constant, in single precision.
pub(crate) fn narrow<T: Real>(field: &[T], constant: f64, out: &mut [f32]) {
    out.par_chunks_mut(TASK).zip(field.par_chunks(TASK)).for_each(|(out, field)| {
        for (x, f) in out.iter_mut().zip(field) {
            *x = (f.wide() - constant) as f32;
        }
    });
}

/// Makes a field constant.
pub(crate) fn fill<T: Real>(value: f64, field: &mut [T]) {
    field.par_chunks_mut(TASK).for_each(|piece| piece.fill(T::of(value)));
}

/// Multiplies a field.
pub(crate) fn scale<T: Real>(factor: f64, field: &mut [T]) {
    let factor = T::of(factor);
    field.par_chunks_mut(TASK).for_each(|piece| {
        for x in piece {
            *x *= factor;
        }
    });
}
