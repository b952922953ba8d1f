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
    let total = partial[..used].iter().fold([0.0; 2], |s, x| [s[0] + x[0], s[1] + x[1]]);
    Residual { active: total[0] as usize, has_released: total[1] > 0.0 }
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
                    t.add_down_transposed_row(row, above, z);
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
                        let at = |t: T, m: u8| {
                            if m == ON { t.narrow() } else { f32::INFINITY }
                        };
                        let least = |x: f32, y: f32| if x < y { x } else { y };
                        if transfer.halved[1] {
                            let ((a, a1), (b, b1)) = (a.as_chunks::<2>(), b.as_chunks::<2>());
                            let ((ma, ma1), (mb, mb1)) = (ma.as_chunks::<2>(), mb.as_chunks::<2>());
                            let pairs = a.iter().zip(b).zip(ma).zip(mb);
                            for ((((a, b), ma), mb), s) in pairs.zip(smallest.iter_mut()) {
                                let (left, right) = (
                                    least(at(a[0], ma[0]), at(b[0], mb[0])),
                                    least(at(a[1], ma[1]), at(b[1], mb[1])),
                                );
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
                        if transfer.halved[1] {
                            let (t, t1) = t.as_chunks_mut::<2>();
                            let (m, m1) = mask.as_chunks::<2>();
                            for ((t, m), a) in t.iter_mut().zip(m).zip(added) {
                                one(&mut t[0], m[0], *a);
                                one(&mut t[1], m[1], *a);
                            }
                            if let ([t], [m]) = (t1, m1) {
                                one(t, *m, added[mx - 1]);
                            }
                        } else {
                            for ((t, m), a) in t.iter_mut().zip(mask).zip(added) {
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
    partial[..used].par_iter_mut().enumerate().for_each(|(k, partial)| {
        let r = k * TASK..((k + 1) * TASK).min(p.len());
        let chord = [&p[r.clone()], &u[r.clone()], &h[r.clone()], &trial[r.clone()]];
        let chord_u = &response[r.clone()];
        *partial = match before {
            Some([b, w]) => inner_products(chord, chord_u, &b[r.clone()], &w[r], level),
            // No step before: d = 0.
            None => inner_products(chord, chord_u, chord[0], chord[1], level),
        };
    });
    let mut sum = [0.0; 8];
    for x in &partial[..used] {
        for k in 0..8 {
            sum[k] += x[k];
        }
    }
    let [gs, sks, ss, gd, dkd, skd, dropped, _] = sum;
    Products { gs, sks, ss, gd, dkd, skd, has_dropped: dropped > 0.0 }
}

/// Independent partial sums, so that additions need not wait for one another.
const LANES: usize = 4;

/// One task of [`products`].
fn inner_products<T: Real>(
    [p, u, h, q]: [&[T]; 4],
    v: &[T],
    b: &[T],
    w: &[T],
    level: T,
) -> Partial {
    let n = p.len();
    let (u, h, q, v, b, w) = (&u[..n], &h[..n], &q[..n], &v[..n], &b[..n], &w[..n]);
    let mut lanes = [[0.0_f64; LANES]; 7];
    let mut add = |i: usize, lane: usize| {
        let g = (u[i] - h[i] - level).wide();
        let (s, ks) = ((q[i] - p[i]).wide(), (v[i] - u[i]).wide());
        let (d, kd) = ((p[i] - b[i]).wide(), (u[i] - w[i]).wide());
        lanes[0][lane] += g * s;
        lanes[1][lane] += s * ks;
        lanes[2][lane] += s * s;
        lanes[3][lane] += g * d;
        lanes[4][lane] += d * kd;
        lanes[5][lane] += s * kd;
        let drops = p[i] > T::zero() && q[i] <= T::zero();
        lanes[6][lane] += if drops { 1.0 } else { 0.0 };
    };
    for i in (0..n - n % LANES).step_by(LANES) {
        for lane in 0..LANES {
            add(i + lane, lane);
        }
    }
    for i in n - n % LANES..n {
        add(i, 0);
    }
    let [a, b, c, d, e, f, g] = lanes.map(|l| l.iter().sum::<f64>());
    [a, b, c, d, e, f, g, 0.0]
}

/// How far along the chord the pressure stays positive.
pub(crate) fn reach<T: Real>(p: &[T], trial: &[T]) -> f64 {
    let reach = |p: T, q: T| if q < p { p.wide() / (p - q).wide() } else { f64::INFINITY };
    crate::fields::least_of(p.len(), |i| reach(p[i], trial[i]))
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
