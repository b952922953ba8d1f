//! The step to the next iterate, with the sums that its level needs.

use super::{Partial, TASK, total};
use crate::Real;
use grid_fft::parallel::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};

/// `before = p + b1 (c trial - p) + b2 (p - before)`, and the same for the displacements. Returns
/// the sum of `u - h` over the new contact and the number of its nodes.
///
/// With `is_plane`, `None` if a pressure comes out negative, or positive where the trial is zero;
/// `before` is then undefined. Without, b2 is 0, what `before` held does not matter, and negative
/// pressures are clipped.
#[allow(clippy::too_many_arguments, reason = "a pass over seven fields")]
pub(crate) fn combine<T: Real>(
    [p, u]: [&[T]; 2],
    [trial, response]: [&[T]; 2],
    scale: f64,
    [b1, b2]: [f64; 2],
    is_plane: bool,
    h: &[T],
    [before, before_response]: [&mut [T]; 2],
    partial: &mut [Partial],
) -> Option<[f64; 2]> {
    let (scale, b1, b2) = (T::of(scale), T::of(b1), T::of(b2));
    let used = p.len().div_ceil(TASK);
    let has_failed = AtomicBool::new(false);
    let new = |old: T, to: T, before: T| {
        let on_chord = old + b1 * (scale * to - old);
        if is_plane { on_chord + b2 * (old - before) } else { on_chord }
    };
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
            let (p, u, h) = (&p[from..][..n], &u[from..][..n], &h[from..][..n]);
            let (q, v) = (&trial[from..][..n], &response[from..][..n]);
            let mut bad = false;
            for ((b, p), q) in b.iter_mut().zip(p).zip(q) {
                let x = new(*p, *q, *b);
                bad |= (x < T::zero()) | ((*q <= T::zero()) & (x > T::zero()));
                *b = x.larger(T::zero());
            }
            if bad && is_plane {
                has_failed.store(true, Ordering::Relaxed);
                return;
            }
            for ((w, u), v) in w.iter_mut().zip(u).zip(v) {
                *w = new(*u, *v, *w);
            }
            *partial = contact_sums(b, w, h);
        });
    (!has_failed.into_inner()).then(|| total(&partial[..used]))
}

/// Multiplies the trial and its displacement by `scale`; returns the sums of [`combine`].
pub(crate) fn settle<T: Real>(
    [trial, response]: [&mut [T]; 2],
    scale: f64,
    h: &[T],
    partial: &mut [Partial],
) -> [f64; 2] {
    let scale = T::of(scale);
    let used = h.len().div_ceil(TASK);
    partial[..used]
        .par_iter_mut()
        .zip(trial.par_chunks_mut(TASK))
        .zip(response.par_chunks_mut(TASK))
        .zip(h.par_chunks(TASK))
        .for_each(|(((partial, q), v), h)| {
            for (q, v) in q.iter_mut().zip(v.iter_mut()) {
                *q *= scale;
                *v *= scale;
            }
            *partial = contact_sums(q, v, h);
        });
    total(&partial[..used])
}

/// Independent partial sums, so that additions need not wait for one another.
const LANES: usize = 4;

/// Sum over the contact (`p > 0`) of `u - h`, and its number of nodes.
pub(super) fn contact_sums<T: Real>(p: &[T], u: &[T], h: &[T]) -> Partial {
    let mut lanes = [[0.0; LANES]; 2];
    let mut one = |p: T, u: T, h: T, lane: usize| {
        let on = p > T::zero();
        lanes[0][lane] += if on { (u - h).wide() } else { 0.0 };
        lanes[1][lane] += if on { 1.0 } else { 0.0 };
    };
    let (p, p_rest) = p.as_chunks::<LANES>();
    let (u, u_rest) = u.as_chunks::<LANES>();
    let (h, h_rest) = h.as_chunks::<LANES>();
    for ((p, u), h) in p.iter().zip(u).zip(h) {
        for lane in 0..LANES {
            one(p[lane], u[lane], h[lane], lane);
        }
    }
    for ((p, u), h) in p_rest.iter().zip(u_rest).zip(h_rest) {
        one(*p, *u, *h, 0);
    }
    let [sum, count] = lanes.map(|l| l.iter().sum());
    [sum, count, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
}
