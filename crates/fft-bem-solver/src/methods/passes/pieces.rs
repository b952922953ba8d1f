//! The pieces that passes work on, and the passes that any field may need.

use crate::Real;
use crate::methods::extension::Pyramid;
use crate::row_work::{Partial, TASK, total};
use crate::simd::vectorised;
use grid_fft::parallel::prelude::*;

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

/// The gap under a constant pressure, whose displacement is zero.
pub(crate) fn gap_of_constant<T: Real>(heights: &[T], mean: f64, gap: &mut [f32]) {
    gap.par_chunks_mut(TASK).zip(heights.par_chunks(TASK)).for_each(|(gap, heights)| {
        vectorised!({
            for (g, h) in gap.iter_mut().zip(heights) {
                *g = (mean - h.wide()) as f32;
            }
        });
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
