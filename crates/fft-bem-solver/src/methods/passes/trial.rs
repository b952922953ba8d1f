//! The trial pressure: the step with the size of it, and its end after the sweep.

use super::sums::{Sum, TILE};
use super::{Partial, total};
use crate::Real;
use crate::methods::extension::{Level, Pyramid};
use crate::methods::sweep::{Added, Sweep};
use crate::methods::transfer::{ON, Transfer};
use crate::simd::vectorised;
use grid_fft::parallel::prelude::*;

/// How large the step is.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Estimate {
    /// `|z on F, p off F| / |p|`, where z is taken less its mean over F.
    pub(crate) residual: f64,
    /// `|p|^2`.
    pub(crate) p2: f64,
}

/// Ends `z = E^T y` and makes the step: the trial is `p - tau z` on F, `p` elsewhere. That the
/// mean of z does not belong to the step is known only at the end: [`Sweep::shift`] adds it.
/// Without `p` the trial field holds it. `active` is the size of F.
#[allow(clippy::too_many_arguments, reason = "a pass over six fields")]
pub(crate) fn trial<T: Real>(
    p: Option<&[T]>,
    y: &[f32],
    tau: f64,
    mask: &[u8],
    active: usize,
    [rows, nx]: [usize; 2],
    pyramid: &Pyramid,
    trial: &mut [T],
    sweep: &mut Sweep,
    partial: &mut [Partial],
) -> Estimate {
    let chunk = rows * nx;
    let used = trial.len().div_ceil(chunk);
    let first = pyramid.levels.first();
    let fields = partial[..used]
        .par_iter_mut()
        .zip(y.par_chunks(chunk))
        .zip(mask.par_chunks(chunk))
        .zip(trial.par_chunks_mut(chunk));
    let length = T::of(tau);
    if let Some(first) = first {
        let t = &first.transfer;
        let coarse = rows / t.rows_per_coarse_row() * t.coarse[1];
        fields.zip(sweep.smallest.par_chunks_mut(coarse)).enumerate().for_each(
            |(task, ((((partial, y), mask), trial), smallest))| {
                vectorised!({
                    *partial = step_rows(p, y, length, mask, Some(first), [task * rows, nx], trial);
                    smallest_below(t, mask, trial, smallest);
                });
            },
        );
    } else {
        fields.enumerate().for_each(|(task, (((partial, y), mask), trial))| {
            *partial = step_rows(p, y, length, mask, None, [task * rows, nx], trial);
        });
    }
    let [z, z2, off2, p2] = total(&partial[..used]);
    let mean = z / active.max(1) as f64;
    sweep.begin((tau * mean) as f32);
    Estimate { residual: (((z2 - mean * z).max(0.0) + off2) / p2).sqrt(), p2 }
}

/// The rows of [`trial`] from row `first_row` on, with the sums of `z`, `z^2` on F, `p^2` off F, `p^2`.
#[inline(always)]
fn step_rows<T: Real>(
    p: Option<&[T]>,
    y: &[f32],
    tau: T,
    mask: &[u8],
    level: Option<&Level>,
    [first_row, nx]: [usize; 2],
    trial: &mut [T],
) -> Partial {
    let (mut sums, mut room) = ([Sum::default(); 4], [[0.0; TILE]; 3]);
    let mut z = [0.0; TILE];
    let lines = y.chunks_exact(nx).zip(mask.chunks_exact(nx)).zip(trial.chunks_exact_mut(nx));
    for (i, ((y, mask), trial)) in lines.enumerate() {
        let row = first_row + i;
        for (k, t) in trial.chunks_mut(TILE).enumerate() {
            let (ix, n) = (k * TILE, t.len());
            let z = &mut z[..n];
            z.copy_from_slice(&y[ix..][..n]);
            if let Some(level) = level {
                level.transfer.add_down_transposed(row, ix, &level.value, z);
            }
            if let Some(p) = p {
                t.copy_from_slice(&p[row * nx + ix..][..n]);
            }
            step_tile(z, tau, &mask[ix..][..n], t, &mut room, &mut sums);
        }
    }
    let [z, z2, off2, p2] = sums.map(Sum::total);
    [z, z2, off2, p2, 0.0, 0.0, 0.0, 0.0]
}

/// One tile of it; the trial holds `p`.
#[inline(always)]
fn step_tile<T: Real>(
    z: &mut [f32],
    tau: T,
    mask: &[u8],
    trial: &mut [T],
    room: &mut [[f64; TILE]; 3],
    sums: &mut [Sum; 4],
) {
    let n = trial.len().min(TILE);
    for (z, m) in z.iter_mut().zip(mask) {
        *z = if *m == ON { *z } else { 0.0 };
    }
    let [wide, square, off] = room.each_mut().map(|x| &mut x[..n]);
    for (wide, z) in wide.iter_mut().zip(&*z) {
        *wide = f64::from(*z);
    }
    for (((square, off), p), m) in square.iter_mut().zip(off.iter_mut()).zip(&*trial).zip(mask) {
        *square = p.wide() * p.wide();
        *off = if *m == ON { 0.0 } else { *square };
    }
    for (t, z) in trial.iter_mut().zip(&*wide) {
        *t -= tau * T::of(*z);
    }
    sums[0].add(wide);
    sums[1].add_product(wide, wide);
    sums[2].add(off);
    sums[3].add(square);
}

/// The smallest trial pressure on F below each cell of the first level.
#[inline(always)]
fn smallest_below<T: Real>(t: &Transfer, mask: &[u8], trial: &[T], smallest: &mut [f32]) {
    let (nx, mx) = (t.fine[1], t.coarse[1]);
    let pair = t.rows_per_coarse_row() * nx;
    let least = |x: f32, y: f32| if x < y { x } else { y };
    let mut line = [0.0; TILE];
    let cells = smallest.chunks_exact_mut(mx);
    for ((mask, p), smallest) in mask.chunks(pair).zip(trial.chunks(pair)).zip(cells) {
        let last = p.len() - nx; // of two rows, or the single one again
        for ix in (0..nx).step_by(TILE) {
            let line = &mut line[..TILE.min(nx - ix)];
            line.fill(f32::INFINITY);
            for from in [ix, last + ix] {
                for ((x, p), m) in line.iter_mut().zip(&p[from..]).zip(&mask[from..]) {
                    let here = if *m == ON { p.narrow() } else { f32::INFINITY };
                    *x = least(*x, here);
                }
            }
            if t.halved[1] {
                let (pairs, single) = line.as_chunks::<2>();
                for (s, x) in smallest[ix / 2..].iter_mut().zip(pairs) {
                    *s = least(x[0], x[1]);
                }
                if let [x] = single {
                    smallest[mx - 1] = *x;
                }
            } else {
                smallest[ix..][..line.len()].copy_from_slice(line);
            }
        }
    }
}

/// Ends a piece of whole rows of the trial, from `first_row` on: adds what was swept, clips, and sets
/// to zero outside the contact. Returns the sum.
pub(crate) fn end_trial<T: Real>(
    first_row: usize,
    mask: &[u8],
    sweep: &Sweep,
    pyramid: &Pyramid,
    nx: usize,
    trial: &mut [T],
) -> Partial {
    let is_halved = pyramid.levels.first().is_some_and(|first| first.transfer.halved[1]);
    let (mut sum, mut more, mut wide) = (Sum::default(), [sweep.shift; TILE], [0.0; TILE]);
    vectorised!({
        for (i, (t, mask)) in trial.chunks_exact_mut(nx).zip(mask.chunks_exact(nx)).enumerate() {
            let added = sweep.added_below(first_row + i, pyramid);
            for ((k, t), mask) in t.chunks_mut(TILE).enumerate().zip(mask.chunks(TILE)) {
                match added {
                    Added::Same(_) => (),
                    Added::Cells(added) if is_halved => {
                        let pairs = more.as_chunks_mut::<2>().0;
                        for (more, a) in pairs.iter_mut().zip(&added[k * TILE / 2..]) {
                            *more = [*a; 2];
                        }
                    }
                    Added::Cells(added) => {
                        more[..t.len()].copy_from_slice(&added[k * TILE..][..t.len()]);
                    }
                }
                for (((t, m), a), wide) in t.iter_mut().zip(mask).zip(&more).zip(&mut wide) {
                    let kept = (*t + T::of(f64::from(*a))).larger(T::zero());
                    *t = if *m == ON { kept } else { T::zero() };
                    *wide = t.wide();
                }
                sum.add(&wide[..t.len()]);
            }
        }
    });
    [sum.total(), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
}
