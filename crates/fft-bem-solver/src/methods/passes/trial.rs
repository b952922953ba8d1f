//! The trial pressure: the step with the size of it, and its end after the sweep.

use super::{Partial, total};
use crate::Real;
use crate::methods::extension::Pyramid;
use crate::methods::sweep::Sweep;
use crate::methods::transfer::{ON, Transfer};
use grid_fft::parallel::prelude::*;

/// Columns handled at a time, an even number.
const TILE: usize = 256;
/// Independent partial sums, so that additions need not wait for one another.
const LANES: usize = 4;

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
    let step = |task: usize, y: &[f32], mask: &[u8], trial: &mut [T]| -> Partial {
        let mut sums = [[0.0; LANES]; 4];
        for ((i, t), (y, m)) in
            (0..).zip(trial.chunks_exact_mut(nx)).zip(y.chunks_exact(nx).zip(mask.chunks_exact(nx)))
        {
            let row = task * rows + i;
            for ix in (0..nx).step_by(TILE) {
                let tile = ix..(ix + TILE).min(nx);
                let (mut z, mut here) = ([0.0; TILE], [T::zero(); TILE]);
                let (z, here) = (&mut z[..tile.len()], &mut here[..tile.len()]);
                z.copy_from_slice(&y[tile.clone()]);
                if let Some(first) = first {
                    first.transfer.add_down_transposed(row, ix, &first.value, z);
                }
                here.copy_from_slice(match p {
                    Some(p) => &p[row * nx..][tile.clone()],
                    None => &t[tile.clone()],
                });
                step_tile(here, z, T::of(tau), &m[tile.clone()], &mut t[tile], &mut sums);
            }
        }
        let [z, z2, off2, p2] = sums.map(|s| s.iter().sum());
        [z, z2, off2, p2, 0.0, 0.0, 0.0, 0.0]
    };
    let fields = partial[..used]
        .par_iter_mut()
        .zip(y.par_chunks(chunk))
        .zip(mask.par_chunks(chunk))
        .zip(trial.par_chunks_mut(chunk));
    if let Some(first) = first {
        let t = &first.transfer;
        let coarse = rows / t.rows_per_coarse_row() * t.coarse[1];
        fields.zip(sweep.smallest.par_chunks_mut(coarse)).enumerate().for_each(
            |(task, ((((partial, y), mask), trial), smallest))| {
                *partial = step(task, y, mask, trial);
                smallest_below(t, mask, trial, smallest);
            },
        );
    } else {
        fields.enumerate().for_each(|(task, (((partial, y), mask), trial))| {
            *partial = step(task, y, mask, trial);
        });
    }
    let [z, z2, off2, p2] = total(&partial[..used]);
    let mean = z / active.max(1) as f64;
    sweep.shift = (tau * mean) as f32;
    Estimate { residual: (((z2 - mean * z).max(0.0) + off2) / p2).sqrt(), p2 }
}

/// One piece of a row of [`trial`], with the sums of `z`, `z^2` on F, `p^2` off F, `p^2`.
fn step_tile<T: Real>(
    p: &[T],
    z: &[f32],
    tau: T,
    mask: &[u8],
    trial: &mut [T],
    sums: &mut [[f64; LANES]; 4],
) {
    let mut one = |p: T, z: f32, m: u8, t: &mut T, lane: usize| {
        let on = m == ON;
        let wide = f64::from(z);
        let (p2, z_on) = (p.wide() * p.wide(), if on { wide } else { 0.0 });
        *t = p - tau * T::of(z_on);
        sums[0][lane] += z_on;
        sums[1][lane] += z_on * z_on;
        sums[2][lane] += if on { 0.0 } else { p2 };
        sums[3][lane] += p2;
    };
    let (p, p_rest) = p.as_chunks::<LANES>();
    let (z, z_rest) = z.as_chunks::<LANES>();
    let (m, m_rest) = mask.as_chunks::<LANES>();
    let (t, t_rest) = trial.as_chunks_mut::<LANES>();
    for (((p, z), m), t) in p.iter().zip(z).zip(m).zip(t) {
        for lane in 0..LANES {
            one(p[lane], z[lane], m[lane], &mut t[lane], lane);
        }
    }
    for (((p, z), m), t) in p_rest.iter().zip(z_rest).zip(m_rest).zip(t_rest) {
        one(*p, *z, *m, t, 0);
    }
}

/// The smallest trial pressure on F below each cell of the first level.
fn smallest_below<T: Real>(t: &Transfer, mask: &[u8], trial: &[T], smallest: &mut [f32]) {
    let (nx, mx) = (t.fine[1], t.coarse[1]);
    let pair = t.rows_per_coarse_row() * nx;
    let at = |t: T, m: u8| if m == ON { t.narrow() } else { f32::INFINITY };
    let least = |x: f32, y: f32| if x < y { x } else { y };
    let cells = smallest.chunks_exact_mut(mx);
    for ((m, p), smallest) in mask.chunks(pair).zip(trial.chunks(pair)).zip(cells) {
        // Two rows, or the single one twice.
        let last = p.len() - nx;
        let (a, b) = (&p[..nx], &p[last..]);
        let (ma, mb) = (&m[..nx], &m[last..]);
        if t.halved[1] {
            let ((a, a1), (b, b1)) = (a.as_chunks::<2>(), b.as_chunks::<2>());
            let ((ma, ma1), (mb, mb1)) = (ma.as_chunks::<2>(), mb.as_chunks::<2>());
            let pairs = a.iter().zip(b).zip(ma).zip(mb);
            for ((((a, b), ma), mb), s) in pairs.zip(smallest.iter_mut()) {
                let left = least(at(a[0], ma[0]), at(b[0], mb[0]));
                let right = least(at(a[1], ma[1]), at(b[1], mb[1]));
                *s = least(left, right);
            }
            if let ([a], [b], [ma], [mb]) = (a1, b1, ma1, mb1) {
                smallest[mx - 1] = least(at(*a, *ma), at(*b, *mb));
            }
        } else {
            for (i, s) in smallest.iter_mut().enumerate() {
                *s = least(at(a[i], ma[i]), at(b[i], mb[i]));
            }
        }
    }
}

/// Ends the trial: adds what was swept, clips, and sets to zero outside the contact. Returns the
/// sum.
pub(crate) fn finish_trial<T: Real>(
    mask: &[u8],
    sweep: &Sweep,
    pyramid: &Pyramid,
    [rows, nx]: [usize; 2],
    trial: &mut [T],
    partial: &mut [Partial],
) -> f64 {
    let chunk = rows * nx;
    let used = trial.len().div_ceil(chunk);
    let first = pyramid.levels.first();
    partial[..used]
        .par_iter_mut()
        .zip(trial.par_chunks_mut(chunk))
        .zip(mask.par_chunks(chunk))
        .enumerate()
        .for_each(|(task, ((partial, t), mask))| {
            let mut sum = [0.0; LANES];
            for (i, (t, mask)) in t.chunks_exact_mut(nx).zip(mask.chunks_exact(nx)).enumerate() {
                let mut one = |t: &mut T, m: u8, added: f32, lane: usize| {
                    let kept = (*t + T::of(f64::from(added))).larger(T::zero());
                    *t = if m == ON { kept } else { T::zero() };
                    sum[lane] += t.wide();
                };
                let Some(first) = first else {
                    t.iter_mut().zip(mask).for_each(|(t, m)| one(t, *m, sweep.shift, 0));
                    continue;
                };
                let transfer = &first.transfer;
                let mx = transfer.coarse[1];
                let added = &sweep.added[transfer.parent(task * rows + i) * mx..][..mx];
                if transfer.halved[1] {
                    let (t, t1) = t.as_chunks_mut::<4>();
                    let (m, m1) = mask.as_chunks::<4>();
                    for ((t, m), a) in t.iter_mut().zip(m).zip(added.as_chunks::<2>().0) {
                        for lane in 0..LANES {
                            one(&mut t[lane], m[lane], a[lane / 2], lane);
                        }
                    }
                    let rest = &added[nx / 4 * 2..];
                    for (k, (t, m)) in t1.iter_mut().zip(m1).enumerate() {
                        one(t, *m, rest[k / 2], k);
                    }
                } else {
                    for ((t, m), a) in t.iter_mut().zip(mask).zip(added) {
                        one(t, *m, *a, 0);
                    }
                }
            }
            partial[0] = sum.iter().sum();
        });
    let [sum] = total(&partial[..used]);
    sum
}
