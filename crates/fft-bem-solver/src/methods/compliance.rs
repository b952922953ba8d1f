//! The operator `K` as a method sees it.

use crate::row_work::{Partial, RowWork, total};
use crate::{Boundary, Real};
use grid_fft::parallel::prelude::*;

/// `u = K p` and, where it is diagonal, its inverse.
pub(crate) trait Compliance<T: Real>: Send + Sync {
    /// `displacement = K pressure`.
    fn apply(&mut self, pressure: &[T], displacement: &mut [T]);
    /// As [`apply`](Self::apply), with `work` on the fields on the way, and a third field `gap` for it
    /// to write to. Returns the sums of `work.finish`, `None` where `work.factor` stopped; `partial`
    /// then holds what `work.prepare` found.
    fn apply_around(
        &mut self,
        pressure: &mut [T],
        displacement: &mut [T],
        gap: &mut [f32],
        work: RowWork<'_, T>,
        partial: &mut [Partial],
    ) -> Option<Partial> {
        let size = work.pixels;
        let blocks = pressure.par_chunks_mut(size).zip(partial.par_iter_mut()).enumerate();
        blocks.for_each(|(k, (p, partial))| *partial = (work.prepare)(k * size, p));
        let partial = &mut partial[..pressure.len().div_ceil(size)];
        let factor = T::of((work.factor)(partial)?);
        self.apply(pressure, displacement);
        pressure
            .par_chunks_mut(size)
            .zip(displacement.par_chunks_mut(size))
            .zip(gap.par_chunks_mut(size))
            .zip(partial.par_iter_mut())
            .enumerate()
            .for_each(|(k, (((p, u), gap), partial))| {
                for u in u.iter_mut() {
                    *u *= factor;
                }
                *partial = (work.finish)(k * size, factor, [p, u], gap);
            });
        Some(total(partial))
    }
    /// Replaces `w` by `B w`, where `<w, B w> >= <w, K^-1 w>`; periodic: `B = K^-1` on fields of mean
    /// zero. False, and nothing done, if there is no such `B` that costs one convolution.
    fn invert(&mut self, field: &mut [T]) -> bool;
    fn boundary(&self) -> Boundary;
}
