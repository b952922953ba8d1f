//! The step to the next iterate, with the sums that its level needs.

use crate::Real;
use crate::methods::ceiling::Ceiling;
use crate::row_work::{Partial, TASK, total};
use crate::simd::{LANES, four, rest, vectorised};
use fearless_simd::{Select, Simd, SimdBase, SimdFloat, f64x4};
use grid_fft::parallel::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};

/// `before = p + b1 (trial - p) + b2 (p - before)`, and the same for the displacements. Returns
/// the level of the new iterate; `None` if a pressure comes out negative, or positive where the trial is zero,
/// likewise at the ceiling. `before` is then undefined.
pub(crate) fn combine<T: Real, C: Ceiling<T>>(
    ceiling: C,
    [p, u]: [&[T]; 2],
    [trial, response]: [&[T]; 2],
    [b1, b2]: [f64; 2],
    h: &[T],
    [before, before_response]: [&mut [T]; 2],
    partial: &mut [Partial],
) -> Option<f64> {
    let (b1, b2) = (T::of(b1), T::of(b2));
    let used = p.len().div_ceil(TASK);
    let has_failed = AtomicBool::new(false);
    partial[..used]
        .par_iter_mut()
        .zip(before.par_chunks_mut(TASK))
        .zip(before_response.par_chunks_mut(TASK))
        .enumerate()
        .for_each(|(task, ((partial, b), w))| {
            if has_failed.load(Ordering::Relaxed) {
                return; // the rest does not matter any more
            }
            let (from, n) = (task * TASK, b.len());
            let [p, u, h, q, v] = [p, u, h, trial, response].map(|x| &x[from..][..n]);
            let fits = vectorised!(vectors => {
                let fits = step_pressure(ceiling.after(from), p, q, [b1, b2], b);
                step_linearly(u, v, [b1, b2], w);
                *partial = contact_sums(vectors, b, w, h);
                fits
            });
            if !fits {
                has_failed.store(true, Ordering::Relaxed);
            }
        });
    let [sum, contact] = total(&partial[..used]);
    (!has_failed.into_inner()).then_some(sum / contact.max(1.0))
}

/// `trial = p + length (trial - p)`, clipped, and the same for the displacements. Returns the level of the
/// new iterate.
pub(crate) fn shorten<T: Real, C: Ceiling<T>>(
    ceiling: C,
    [p, u]: [&[T]; 2],
    length: f64,
    h: &[T],
    [trial, response]: [&mut [T]; 2],
    partial: &mut [Partial],
) -> f64 {
    let length = T::of(length);
    let used = p.len().div_ceil(TASK);
    partial[..used]
        .par_iter_mut()
        .zip(trial.par_chunks_mut(TASK))
        .zip(response.par_chunks_mut(TASK))
        .enumerate()
        .for_each(|(task, ((partial, q), v))| {
            let (from, n) = (task * TASK, q.len());
            let [p, u, h] = [p, u, h].map(|x| &x[from..][..n]);
            let ceiling = ceiling.after(from);
            vectorised!(vectors => {
                for (i, (q, p)) in q.iter_mut().zip(p).enumerate() {
                    *q = ceiling.clip(i, *p + length * (*q - *p));
                }
                for (v, u) in v.iter_mut().zip(u) {
                    *v = *u + length * (*v - *u);
                }
                *partial = contact_sums(vectors, q, v, h);
            });
        });
    let [sum, contact] = total(&partial[..used]);
    sum / contact.max(1.0)
}

/// `before = old + b1 (to - old) + b2 (old - before)`.
#[inline(always)]
fn step_linearly<T: Real>(old: &[T], to: &[T], [b1, b2]: [T; 2], before: &mut [T]) {
    for ((x, old), to) in before.iter_mut().zip(old).zip(to) {
        *x = *old + b1 * (*to - *old) + b2 * (*old - *x);
    }
}

/// The same for the pressure, clipped. Returns whether nothing had to be, and no node carries load
/// that does not in the trial, or less than the ceiling where the trial reaches it.
#[inline(always)]
fn step_pressure<T: Real, C: Ceiling<T>>(
    ceiling: C,
    p: &[T],
    trial: &[T],
    b: [T; 2],
    before: &mut [T],
) -> bool {
    step_linearly(p, trial, b, before);
    let mut misfits = 0_u32;
    for (i, (x, q)) in before.iter_mut().zip(trial).enumerate() {
        let misfit = (*x < T::zero()) | ((*q <= T::zero()) & (*x > T::zero()));
        misfits += u32::from(misfit);
        if C::IS_FINITE {
            let top = ceiling.at(i);
            misfits += u32::from((*x > top) | ((*q >= top) & (*x < top)));
        }
        *x = ceiling.clip(i, *x);
    }
    misfits == 0
}

/// Sum over the contact (`p > 0`) of `u - h`, and its number of nodes.
#[inline(always)]
pub(super) fn contact_sums<S: Simd, T: Real>(vectors: S, p: &[T], u: &[T], h: &[T]) -> Partial {
    let [sum, count] = contact_sums_by_fours(vectors, p, u, h);
    let [more, others] = contact_sums_by_fours(vectors, &rest(p), &rest(u), &rest(h));
    [sum + more, count + others, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
}

/// The same over whole vectors.
#[inline(always)]
fn contact_sums_by_fours<S: Simd, T: Real>(vectors: S, p: &[T], u: &[T], h: &[T]) -> [f64; 2] {
    let (zero, one) = (f64x4::splat(vectors, 0.0), f64x4::splat(vectors, 1.0));
    let (mut sum, mut count) = (zero, zero);
    for i in (0..p.len() - p.len() % LANES).step_by(LANES) {
        let is_contact = T::widened(four(vectors, p, i)).simd_gt(zero);
        let rise = T::widened(four(vectors, u, i) - four(vectors, h, i));
        sum += is_contact.select(rise, zero);
        count += is_contact.select(one, zero);
    }
    [sum.iter().sum(), count.iter().sum()]
}
