//! How work on fields is cut into pieces: for tasks, and in blocks of rows, while they are in cache,
//! around an application of `K`; and the sums that come of it.

use grid_fft::parallel::prelude::*;

/// Pixels that one task of a parallel loop handles, about.
pub(crate) const TASK: usize = 1 << 14;

/// Sums over a piece of the fields, whatever they are of.
pub(crate) type Partial = [f64; 8];

/// Adds the sums of all pieces up, in order.
pub(crate) fn total<const N: usize>(partial: &[Partial]) -> [f64; N] {
    let mut sum = [0.0; N];
    for x in partial {
        for (sum, x) in sum.iter_mut().zip(x) {
            *sum += x;
        }
    }
    sum
}

/// Adds up what `of(first pixel, piece)` makes of the pieces of a field.
pub(crate) fn sums<T: Sync, const N: usize>(
    field: &[T],
    of: &(dyn Fn(usize, &[T]) -> Partial + Sync),
    partial: &mut [Partial],
) -> [f64; N] {
    let partial = &mut partial[..field.len().div_ceil(TASK)];
    let pieces = partial.par_iter_mut().zip(field.par_chunks(TASK)).enumerate();
    pieces.for_each(|(task, (partial, piece))| *partial = of(task * TASK, piece));
    total(partial)
}

/// Rows of a block of work around an application of `K`.
pub(crate) const BLOCK_ROWS: usize = grid_fft::Convolution::<f64>::BLOCK_ROWS;

/// From first pixel, factor, pressure and displacement, and a third field to sums over them.
pub(crate) type Finish<'a, T> = dyn Fn(usize, T, [&mut [T]; 2], &mut [f32]) -> Partial + Sync + 'a;

/// What is done with the fields around an application of `K`, in blocks of whole rows while they are
/// in cache. Each is given the first pixel of the block.
pub(crate) struct RowWork<'a, T> {
    /// Ends the pressure, before it is transformed; returns sums over it.
    pub(crate) prepare: &'a (dyn Fn(usize, &mut [T]) -> Partial + Sync),
    /// From these sums: by what the displacement is to be multiplied; `None` stops here.
    pub(crate) factor: &'a mut dyn FnMut(&[Partial]) -> Option<f64>,
    /// Sees that factor, pressure and displacement, and a third field once the displacement is there.
    pub(crate) finish: &'a Finish<'a, T>,
    /// Pixels of a block, where the operator has none of its own.
    pub(crate) pixels: usize,
}
