//! The passes over the finest grid that a chord iteration is made of. Each reads and writes every
//! field once, in pieces that belong to one task, and returns sums that do not depend on the
//! number of threads.

use super::extension::{Pyramid, Rows, gather_row, pull_rows};
use super::sweep::{RELEASED, Sweep};
use super::transfer::ON;
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

/// Sum over the contact (`p > 0`) of `u - h`, and its number of nodes.
pub(crate) fn level_sums<T: Real>(p: &[T], u: &[T], h: &[T], partial: &mut [Partial]) -> [f64; 2] {
    let used = p.len().div_ceil(TASK);
    partial[..used]
        .par_iter_mut()
        .zip(p.par_chunks(TASK))
        .zip(u.par_chunks(TASK))
        .zip(h.par_chunks(TASK))
        .for_each(|(((partial, p), u), h)| {
            let (mut sum, mut count) = (0.0, 0.0);
            for ((p, u), h) in p.iter().zip(u).zip(h) {
                let on = if *p > T::zero() { 1.0 } else { 0.0 };
                sum += on * (*u - *h).wide();
                count += on;
            }
            partial[0] = sum;
            partial[1] = count;
        });
    partial[..used].iter().fold([0.0; 2], |s, x| [s[0] + x[0], s[1] + x[1]])
}

/// What the residual pass found.
pub(crate) struct Residual {
    /// Nodes of the set F.
    pub(crate) active: usize,
    /// Whether nodes outside F carry load.
    pub(crate) has_released: bool,
    /// Largest residual on F, and largest height or displacement that it is a difference of.
    pub(crate) largest: f64,
    pub(crate) magnitude: f64,
}

/// The set `F = {p > release max(g, 0)} or {g < 0}`, the residual `g = u - h - level` on it, and
/// the first level of the pyramid over it.
#[allow(clippy::too_many_arguments, reason = "a pass over eight fields")]
pub(crate) fn residual<T: Real>(
    [p, u, h]: [&[T]; 3],
    level: f64,
    release: f64,
    rows: usize,
    nx: usize,
    mask: &mut [u8],
    residual: &mut [f32],
    pyramid: &mut Pyramid,
    partial: &mut [Partial],
) -> Residual {
    let (level, release) = (T::of(level), T::of(release));
    let piece = |p: &[T], u: &[T], h: &[T], mask: &mut [u8], r: &mut [f32]| -> Partial {
        let (mut active, mut released) = (0_u32, 0_u32);
        let (mut largest, mut size_u, mut size_h) = (T::zero(), T::zero(), T::zero());
        for ((((p, u), h), m), r) in p.iter().zip(u).zip(h).zip(mask).zip(r) {
            let g = *u - *h - level;
            let on = *p > release * g.larger(T::zero()) || g < T::zero();
            let carries = *p > T::zero();
            *m = if on {
                ON
            } else if carries {
                RELEASED
            } else {
                0
            };
            *r = if on { g.wide() as f32 } else { 0.0 };
            active += u32::from(on);
            released += u32::from(carries && !on);
            let size = |x: T| x.larger(T::zero() - x);
            largest = largest.larger(if on { size(g) } else { T::zero() });
            size_u = size_u.larger(size(*u));
            size_h = size_h.larger(if on { size(*h) } else { T::zero() });
        }
        let widest = [largest.wide(), size_u.wide(), size_h.wide()];
        [f64::from(active), f64::from(released), widest[0], widest[1], widest[2], 0.0, 0.0, 0.0]
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
        None => fields.for_each(|(((((partial, p), u), h), m), r)| *partial = piece(p, u, h, m, r)),
        Some(first) => {
            let (t, capacity) = (first.transfer, first.capacity);
            let coarse = chunk / (t.rows_per_coarse_row() * nx) * t.coarse[1];
            fields
                .zip(first.weight.par_chunks_mut(coarse))
                .zip(first.inverse.par_chunks_mut(coarse))
                .zip(first.value.par_chunks_mut(coarse))
                .for_each(|((((((((partial, p), u), h), m), r), weight), inverse), value)| {
                    *partial = piece(p, u, h, m, r);
                    pull_rows(&t, capacity, m, r, Rows { weight, inverse, value });
                });
        }
    }
    let mut total = [0.0_f64; 5];
    for x in &partial[..used] {
        total = [
            total[0] + x[0],
            total[1] + x[1],
            total[2].max(x[2]),
            total[3].max(x[3]),
            total[4].max(x[4]),
        ];
    }
    Residual {
        active: total[0] as usize,
        has_released: total[1] > 0.0,
        largest: total[2],
        magnitude: total[3] + total[4],
    }
}

/// `E` on the finest grid: the residual on F, what the pyramid knows elsewhere.
pub(crate) fn push(
    mask: &[u8],
    residual: &[f32],
    pyramid: &Pyramid,
    rows: usize,
    nx: usize,
    extended: &mut [f32],
) {
    let Some(first) = pyramid.levels.first() else {
        extended.copy_from_slice(residual);
        return;
    };
    let chunk = rows * nx;
    extended
        .par_chunks_mut(chunk)
        .zip(mask.par_chunks(chunk))
        .zip(residual.par_chunks(chunk))
        .enumerate()
        .for_each(|(task, ((x, mask), r))| {
            let lines = x.chunks_exact_mut(nx).zip(mask.chunks_exact(nx)).zip(r.chunks_exact(nx));
            for (i, ((x, mask), r)) in lines.enumerate() {
                first.transfer.up_row(task * rows + i, &first.value, |ix, up| {
                    let fields = x[ix..].iter_mut().zip(&mask[ix..]).zip(&r[ix..]);
                    for (((x, m), r), up) in fields.zip(up) {
                        *x = if *m == ON { *r } else { *up };
                    }
                });
            }
        });
}

/// `E^T` from the finest grid, in place: `z = y + down^T(...)` on F. Returns the sum of z.
pub(crate) fn transpose(
    mask: &[u8],
    field: &mut [f32],
    pyramid: &mut Pyramid,
    rows: usize,
    nx: usize,
    partial: &mut [Partial],
) -> f64 {
    if let Some(first) = pyramid.levels.first_mut() {
        let (t, task_rows) = (first.transfer, first.rows_per_task());
        let mx = t.coarse[1];
        let field = &*field;
        first.value.par_chunks_mut(task_rows * mx).enumerate().for_each(|(task, value)| {
            for (j, out) in value.chunks_exact_mut(mx).enumerate() {
                gather_row(&t, task * task_rows + j, mask, field, out);
            }
        });
    }
    pyramid.restrict_above();
    let (chunk, first) = (rows * nx, pyramid.levels.first());
    let used = field.len().div_ceil(chunk);
    partial[..used]
        .par_iter_mut()
        .zip(field.par_chunks_mut(chunk))
        .zip(mask.par_chunks(chunk))
        .enumerate()
        .for_each(|(task, ((partial, z), mask))| {
            partial[0] = 0.0;
            for (i, (z, mask)) in z.chunks_exact_mut(nx).zip(mask.chunks_exact(nx)).enumerate() {
                if let Some(first) = first {
                    let (t, row) = (&first.transfer, task * rows + i);
                    let mx = t.coarse[1];
                    let above = &first.value[t.parent(row) * mx..][..mx];
                    t.down_transposed_row(row, above, |ix, v| z[ix] += v);
                }
                let mut sum = 0.0_f64;
                for (z, m) in z.iter_mut().zip(mask) {
                    *z = if *m == ON { *z } else { 0.0 };
                    sum += f64::from(*z);
                }
                partial[0] += sum;
            }
        });
    partial[..used].iter().map(|x| x[0]).sum()
}

/// The trial pressure `p - tau (z - mean z)` on F, `p` elsewhere, and what the sweep needs of it.
/// Without `p` the trial field holds it. Returns `|z on F, p off F|^2` and `|p|^2`.
#[allow(clippy::too_many_arguments, reason = "a pass over six fields")]
pub(crate) fn trial<T: Real>(
    p: Option<&[T]>,
    z: &[f32],
    mean: f64,
    tau: f64,
    mask: &[u8],
    rows: usize,
    nx: usize,
    pyramid: &Pyramid,
    trial: &mut [T],
    sweep: &mut Sweep,
    partial: &mut [Partial],
) -> [f64; 2] {
    let (mean, tau) = (mean as f32, T::of(tau));
    let piece = |p: Option<&[T]>, z: &[f32], mask: &[u8], trial: &mut [T]| -> Partial {
        let (mut step2, mut p2) = (0.0, 0.0);
        let mut one = |p: T, z: f32, m: u8, t: &mut T| {
            let on = m == ON;
            let z = T::of(f64::from(z - mean));
            *t = if on { p - tau * z } else { p };
            let step = if on { z.wide() } else { p.wide() };
            step2 += step * step;
            p2 += p.wide() * p.wide();
        };
        match p {
            Some(p) => {
                for (((p, z), m), t) in p.iter().zip(z).zip(mask).zip(trial) {
                    one(*p, *z, *m, t);
                }
            }
            None => {
                for ((z, m), t) in z.iter().zip(mask).zip(trial) {
                    one(*t, *z, *m, t);
                }
            }
        }
        [step2, p2, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    };
    let chunk = rows * nx;
    let used = trial.len().div_ceil(chunk);
    let part = |task: usize, len: usize| p.map(|p| &p[task * chunk..task * chunk + len]);
    let fields = partial[..used]
        .par_iter_mut()
        .zip(z.par_chunks(chunk))
        .zip(mask.par_chunks(chunk))
        .zip(trial.par_chunks_mut(chunk));
    match pyramid.levels.first() {
        None => fields.enumerate().for_each(|(task, (((partial, z), m), t))| {
            *partial = piece(part(task, z.len()), z, m, t);
        }),
        Some(first) => {
            let transfer = first.transfer;
            let pair = transfer.rows_per_coarse_row() * nx;
            let mx = transfer.coarse[1];
            let coarse = chunk / pair * mx;
            fields.zip(sweep.smallest.par_chunks_mut(coarse)).enumerate().for_each(
                |(task, ((((partial, z), m), t), smallest))| {
                    *partial = piece(part(task, z.len()), z, m, t);
                    let cells = smallest.chunks_exact_mut(mx);
                    for ((m, t), smallest) in m.chunks(pair).zip(t.chunks(pair)).zip(cells) {
                        let last = t.len() - nx;
                        let (a, b) = (&t[..nx], &t[last..]);
                        let (ma, mb) = (&m[..nx], &m[last..]);
                        let at = |i: usize| {
                            let x = |t: T, m: u8| {
                                if m == ON { t.wide() as f32 } else { f32::INFINITY }
                            };
                            x(a[i], ma[i]).min(x(b[i], mb[i]))
                        };
                        if transfer.halved[1] {
                            for (j, s) in smallest.iter_mut().enumerate() {
                                *s = at(2 * j).min(at((2 * j + 1).min(nx - 1)));
                            }
                        } else {
                            for (j, s) in smallest.iter_mut().enumerate() {
                                *s = at(j);
                            }
                        }
                    }
                },
            );
        }
    }
    partial[..used].iter().fold([0.0; 2], |s, x| [s[0] + x[0], s[1] + x[1]])
}

/// Ends the trial: adds what was swept, clips, and sets to zero outside the contact. Returns the
/// sum.
pub(crate) fn finish_trial<T: Real>(
    mask: &[u8],
    sweep: &Sweep,
    pyramid: &Pyramid,
    rows: usize,
    nx: usize,
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
            partial[0] = 0.0;
            for (i, (t, mask)) in t.chunks_exact_mut(nx).zip(mask.chunks_exact(nx)).enumerate() {
                let mut sum = 0.0;
                let mut one = |t: &mut T, m: u8, added: f32| {
                    let kept = (*t + T::of(f64::from(added))).larger(T::zero());
                    *t = if m == ON { kept } else { T::zero() };
                    sum += t.wide();
                };
                match first {
                    None => t.iter_mut().zip(mask).for_each(|(t, m)| one(t, *m, 0.0)),
                    Some(first) => {
                        let transfer = &first.transfer;
                        let mx = transfer.coarse[1];
                        let row = transfer.parent(task * rows + i);
                        let added = &sweep.added[row * mx..][..mx];
                        let width = if transfer.halved[1] { 2 } else { 1 };
                        for ((t, m), a) in t.chunks_mut(width).zip(mask.chunks(width)).zip(added) {
                            for (t, m) in t.iter_mut().zip(m) {
                                one(t, *m, *a);
                            }
                        }
                    }
                }
                partial[0] += sum;
            }
        });
    partial[..used].iter().map(|x| x[0]).sum()
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

/// Inner products along the chord `s = trial - p` and the step before, `d = p - before`.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Products {
    /// `<g, s>`, `<s, K s>`, `<s, s>`.
    pub(crate) gs: f64,
    pub(crate) sks: f64,
    pub(crate) ss: f64,
    /// `<g, d>`, `<d, K d>`, `<s, K d>`.
    pub(crate) gd: f64,
    pub(crate) dkd: f64,
    pub(crate) skd: f64,
    /// Whether a node in contact is not in the trial.
    pub(crate) has_dropped: bool,
    /// How far along the chord the pressure stays positive.
    pub(crate) feasible: f64,
}

/// Computes [`Products`]; `before` are pressure and displacement before the last step.
pub(crate) fn products<T: Real>(
    [p, u, h]: [&[T]; 3],
    level: f64,
    [trial, response]: [&[T]; 2],
    before: Option<[&[T]; 2]>,
    partial: &mut [Partial],
) -> Products {
    let level = T::of(level);
    let used = p.len().div_ceil(TASK);
    let piece = |k: usize| k * TASK..((k + 1) * TASK).min(p.len());
    partial[..used].par_iter_mut().enumerate().for_each(|(k, partial)| {
        let r = piece(k);
        let (p, u, h) = (&p[r.clone()], &u[r.clone()], &h[r.clone()]);
        let (q, v) = (&trial[r.clone()], &response[r.clone()]);
        let mut x = [0.0_f64; 8];
        let mut reach = f64::INFINITY;
        for i in 0..p.len() {
            let g = (u[i] - h[i] - level).wide();
            let (s, ks) = ((q[i] - p[i]).wide(), (v[i] - u[i]).wide());
            x[0] += g * s;
            x[1] += s * ks;
            x[2] += s * s;
            let drops = p[i] > T::zero() && q[i] <= T::zero();
            x[6] += if drops { 1.0 } else { 0.0 };
            // p + a s >= 0: only nodes that lose more than all would do it below a = 2.
            let loss = -s / p[i].wide();
            reach = if s < 0.0 && loss * reach > 1.0 { 1.0 / loss } else { reach };
        }
        if let Some([b, w]) = before {
            let (b, w) = (&b[r.clone()], &w[r]);
            for i in 0..p.len() {
                let g = (u[i] - h[i] - level).wide();
                let (s, d) = ((q[i] - p[i]).wide(), (p[i] - b[i]).wide());
                let kd = (u[i] - w[i]).wide();
                x[3] += g * d;
                x[4] += d * kd;
                x[5] += s * kd;
            }
        }
        x[7] = reach;
        *partial = x;
    });
    let mut sum = [0.0; 8];
    let mut feasible = f64::INFINITY;
    for x in &partial[..used] {
        for k in 0..7 {
            sum[k] += x[k];
        }
        feasible = feasible.min(x[7]);
    }
    let [gs, sks, ss, gd, dkd, skd, dropped, _] = sum;
    Products { gs, sks, ss, gd, dkd, skd, has_dropped: dropped > 0.0, feasible }
}

/// `before = p + b1 (trial - p) + b2 (p - before)`, if that is nowhere negative and zero where
/// the trial is. Returns whether it is; if not, `before` is left undefined.
pub(crate) fn plane_point<T: Real>(
    p: &[T],
    trial: &[T],
    [b1, b2]: [f64; 2],
    before: &mut [T],
    partial: &mut [Partial],
) -> bool {
    let (b1, b2) = (T::of(b1), T::of(b2));
    let used = p.len().div_ceil(TASK);
    partial[..used]
        .par_iter_mut()
        .zip(before.par_chunks_mut(TASK))
        .zip(p.par_chunks(TASK))
        .zip(trial.par_chunks(TASK))
        .for_each(|(((partial, b), p), q)| {
            let mut bad = false;
            for ((b, p), q) in b.iter_mut().zip(p).zip(q) {
                let x = *p + b1 * (*q - *p) + b2 * (*p - *b);
                bad |= x < T::zero() || (*q <= T::zero() && x > T::zero());
                *b = x;
            }
            partial[0] = if bad { 1.0 } else { 0.0 };
        });
    partial[..used].iter().all(|x| x[0] <= 0.0)
}

/// `before = a + b1 (b - a) + b2 (a - before)`.
pub(crate) fn combine<T: Real>(a: &[T], b: &[T], [b1, b2]: [f64; 2], before: &mut [T]) {
    let (b1, b2) = (T::of(b1), T::of(b2));
    before.par_chunks_mut(TASK).zip(a.par_chunks(TASK)).zip(b.par_chunks(TASK)).for_each(
        |((x, a), b)| {
            for ((x, a), b) in x.iter_mut().zip(a).zip(b) {
                *x = *a + b1 * (*b - *a) + b2 * (*a - *x);
            }
        },
    );
}

/// `out = max(p + a (trial - p), 0)`.
pub(crate) fn along_chord<T: Real>(p: &[T], trial: &[T], a: f64, out: &mut [T]) {
    combine(p, trial, [a, 0.0], out);
    out.par_chunks_mut(TASK).for_each(|piece| {
        for x in piece {
            *x = x.larger(T::zero());
        }
    });
}
