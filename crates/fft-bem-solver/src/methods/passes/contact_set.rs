//! Level of the flat, contact set and residual of an iterate.

use super::step::contact_sums;
use super::{Partial, TASK, total};
use crate::Real;
use crate::methods::extension::{Pyramid, Rows, pull_rows};
use crate::methods::sweep::RELEASED;
use crate::methods::transfer::ON;
use grid_fft::parallel::prelude::*;

/// Sum over the contact (`p > 0`) of `u - h`, and its number of nodes.
pub(crate) fn level_sums<T: Real>(p: &[T], u: &[T], h: &[T], partial: &mut [Partial]) -> [f64; 2] {
    let used = p.len().div_ceil(TASK);
    partial[..used]
        .par_iter_mut()
        .zip(p.par_chunks(TASK))
        .zip(u.par_chunks(TASK))
        .zip(h.par_chunks(TASK))
        .for_each(|(((partial, p), u), h)| *partial = contact_sums(p, u, h));
    total(&partial[..used])
}

/// What the residual pass found.
pub(crate) struct Residual {
    /// Nodes of the set F.
    pub(crate) active: usize,
    /// Whether nodes outside F carry load.
    pub(crate) has_released: bool,
}

/// The set `F = {p > release max(g, 0)} or {g < 0}`, the residual `g = u - h - level` on it, and
/// the first level of the pyramid over it. With `closing`, how much the next step will lower the gap
/// where it is not in contact yet, nodes that it would make overlap, `g <= closing`, belong to F.
#[allow(clippy::too_many_arguments, reason = "a pass over nine fields")]
pub(crate) fn residual<T: Real>(
    [p, u, h]: [&[T]; 3],
    level: f64,
    release: f64,
    closing: Option<&[f32]>,
    [rows, nx]: [usize; 2],
    mask: &mut [u8],
    residual: &mut [f32],
    pyramid: &mut Pyramid,
    partial: &mut [Partial],
) -> Residual {
    let (level, release) = (T::of(level), T::of(release));
    let piece = |task: usize, p: &[T], u: &[T], h: &[T], mask: &mut [u8], r: &mut [f32]| {
        let closing = closing.map(|e| &e[task * rows * nx..][..p.len()]);
        let (mut active, mut released) = (0_u32, 0_u32);
        for (i, ((((p, u), h), m), r)) in p.iter().zip(u).zip(h).zip(mask).zip(r).enumerate() {
            let g = *u - *h - level;
            let mut on = (*p > release * g.larger(T::zero())) | (g < T::zero());
            if let Some(closing) = closing {
                on |= g.narrow() <= closing[i];
            }
            let carries = *p > T::zero();
            *m = if on {
                ON
            } else if carries {
                RELEASED
            } else {
                0
            };
            *r = if on { g.narrow() } else { 0.0 };
            active += u32::from(on);
            released += u32::from(carries && !on);
        }
        [f64::from(active), f64::from(released), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    };
    let chunk = rows * nx;
    let used = p.len().div_ceil(chunk);
    let fields = partial[..used]
        .par_iter_mut()
        .zip(p.par_chunks(chunk))
        .zip(u.par_chunks(chunk))
        .zip(h.par_chunks(chunk))
        .zip(mask.par_chunks_mut(chunk))
        .zip(residual.par_chunks_mut(chunk));
    match pyramid.levels.first_mut() {
        None => fields.enumerate().for_each(|(task, (((((partial, p), u), h), m), r))| {
            *partial = piece(task, p, u, h, m, r);
        }),
        Some(first) => {
            let (t, capacity) = (first.transfer, first.capacity);
            let coarse = chunk / (t.rows_per_coarse_row() * nx) * t.coarse[1];
            fields
                .zip(first.weight.par_chunks_mut(coarse))
                .zip(first.inverse.par_chunks_mut(coarse))
                .zip(first.value.par_chunks_mut(coarse))
                .enumerate()
                .for_each(
                    |(task, ((((((((partial, p), u), h), m), r), weight), inverse), value))| {
                        *partial = piece(task, p, u, h, m, r);
                        pull_rows(&t, capacity, m, r, Rows { weight, inverse, value });
                    },
                );
        }
    }
    let [active, released] = total(&partial[..used]);
    Residual { active: active as usize, has_released: released > 0.0 }
}

/// `|g|^2` on F.
pub(crate) fn residual_norm2<T: Real>(
    [u, h]: [&[T]; 2],
    level: f64,
    mask: &[u8],
    partial: &mut [Partial],
) -> f64 {
    let level = T::of(level);
    let square = |from: usize, u: &[T]| -> Partial {
        let fields = u.iter().zip(&h[from..]).zip(&mask[from..]);
        let g = fields.map(|((u, h), m)| if *m == ON { (*u - *h - level).wide() } else { 0.0 });
        [g.map(|g| g * g).sum(), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    };
    super::sums(u, &square, partial)[0]
}

/// Whether the residual on F is no more than the rounding of the fields it is a difference of.
pub(crate) fn is_rounding<T: Real>(
    [u, h]: [&[T]; 2],
    level: f64,
    mask: &[u8],
    partial: &mut [Partial],
) -> bool {
    let level = T::of(level);
    let used = u.len().div_ceil(TASK);
    partial[..used]
        .par_iter_mut()
        .zip(u.par_chunks(TASK))
        .zip(h.par_chunks(TASK))
        .zip(mask.par_chunks(TASK))
        .for_each(|(((partial, u), h), m)| {
            let mut largest = [0.0_f64; 3];
            for ((u, h), m) in u.iter().zip(h).zip(m) {
                largest[1] = largest[1].max(u.wide().abs());
                if *m == ON {
                    largest[0] = largest[0].max((*u - *h - level).wide().abs());
                    largest[2] = largest[2].max(h.wide().abs());
                }
            }
            partial[..3].copy_from_slice(&largest);
        });
    let largest = |k: usize| partial[..used].iter().fold(0.0_f64, |m, x| m.max(x[k]));
    largest(0) <= 2.0 * T::EPSILON * (largest(1) + largest(2))
}
