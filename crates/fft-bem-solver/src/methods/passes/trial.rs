//! The trial pressure: the step with the size of it, and its end after the sweep.

use super::sums::TILE;
use crate::Real;
use crate::methods::ceiling::Ceiling;
use crate::methods::extension::{Level, Pyramid};
use crate::methods::node::Node;
use crate::methods::sweep::Sweep;
use crate::methods::tension::Added;
use crate::methods::transfer::Transfer;
use crate::row_work::{Partial, total};
use crate::simd::{LANES, Lane, four, rest, vectorised};
use fearless_simd::{Simd, SimdBase, f64x4};
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
/// `active` is the size of F. Writes the smallest trial pressure below each cell of the first level
/// to `smallest`, if there are cells; under a ceiling, the smallest distance from a bound.
#[allow(clippy::too_many_arguments, reason = "a pass over six fields")]
pub(crate) fn trial<T: Real, C: Ceiling<T>>(
    ceiling: C,
    p: &[T],
    y: &[f32],
    tau: f64,
    nodes: &[Node],
    active: usize,
    [rows, nx]: [usize; 2],
    pyramid: &Pyramid,
    trial: &mut [T],
    smallest: &mut [f32],
    sweep: &mut Sweep,
    partial: &mut [Partial],
) -> Estimate {
    let chunk = rows * nx;
    let used = trial.len().div_ceil(chunk);
    let first = pyramid.levels.first();
    let fields = partial[..used]
        .par_iter_mut()
        .zip(y.par_chunks(chunk))
        .zip(nodes.par_chunks(chunk))
        .zip(trial.par_chunks_mut(chunk));
    let length = T::of(tau);
    if let Some(first) = first {
        let t = &first.transfer;
        let (height, mx) = (t.rows_per_coarse_row(), t.coarse[1]);
        fields.zip(smallest.par_chunks_mut(rows / height * mx)).enumerate().for_each(
            |(task, ((((partial, y), nodes), trial), smallest))| {
                *partial = vectorised!(x => {
                    let mut sums = [f64x4::splat(x, 0.0); 4];
                    let below = y.chunks(height * nx).zip(nodes.chunks(height * nx));
                    let cells = below.zip(trial.chunks_mut(height * nx)).zip(smallest.chunks_mut(mx));
                    for (j, (((y, nodes), trial), smallest)) in cells.enumerate() {
                        let row = task * rows + j * height;
                        let place = [row, nx];
                        step_rows(x, ceiling, p, y, length, nodes, Some(first), place, trial, &mut sums);
                        smallest_below(ceiling.after(row * nx), t, nodes, trial, smallest);
                    }
                    totals(sums)
                });
            },
        );
    } else {
        fields.enumerate().for_each(|(task, (((partial, y), nodes), trial))| {
            *partial = vectorised!(x => {
                let (mut sums, row) = ([f64x4::splat(x, 0.0); 4], task * rows);
                step_rows(x, ceiling, p, y, length, nodes, None, [row, nx], trial, &mut sums);
                totals(sums)
            });
        });
    }
    let [z, z2, off2, p2] = total(&partial[..used]);
    let mean = z / active.max(1) as f64;
    sweep.begin((tau * mean) as f32);
    Estimate { residual: (((z2 - mean * z).max(0.0) + off2) / p2).sqrt(), p2 }
}

/// The sums of the lanes.
#[inline(always)]
fn totals<S: Simd>(sums: [f64x4<S>; 4]) -> Partial {
    let [a, b, c, d] = sums.map(|sum| sum.iter().sum());
    [a, b, c, d, 0.0, 0.0, 0.0, 0.0]
}

/// The rows of [`trial`] from row `first_row` on; adds up `z`, `z^2` on F, `p^2` off F (of those that are to
/// carry the ceiling, what they lack), `p^2`.
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "a pass over five fields")]
fn step_rows<S: Simd, T: Real, C: Ceiling<T>>(
    vectors: S,
    ceiling: C,
    p: &[T],
    y: &[f32],
    tau: T,
    nodes: &[Node],
    level: Option<&Level>,
    [first_row, nx]: [usize; 2],
    trial: &mut [T],
    sums: &mut [f64x4<S>; 4],
) {
    let mut z = [0.0; TILE];
    let lines = y.chunks_exact(nx).zip(nodes.chunks_exact(nx)).zip(trial.chunks_exact_mut(nx));
    for (i, ((y, nodes), trial)) in lines.enumerate() {
        let row = first_row + i;
        for (k, t) in trial.chunks_mut(TILE).enumerate() {
            let (ix, n) = (k * TILE, t.len());
            let z = &mut z[..n];
            z.copy_from_slice(&y[ix..][..n]);
            if let Some(level) = level {
                level.transfer.add_down_transposed(row, ix, &level.value, z);
            }
            let (p, ceiling) = (&p[row * nx + ix..][..n], ceiling.after(row * nx + ix));
            step_tile(vectors, ceiling, p, z, tau, &nodes[ix..][..n], t, sums);
        }
    }
}

/// One tile of it.
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "a pass over four fields")]
fn step_tile<S: Simd, T: Real, C: Ceiling<T>>(
    vectors: S,
    ceiling: C,
    p: &[T],
    z: &mut [f32],
    tau: T,
    nodes: &[Node],
    trial: &mut [T],
    sums: &mut [f64x4<S>; 4],
) {
    let mut off = [0.0; TILE];
    let off = &mut off[..nodes.len()];
    for ((z, off), m) in z.iter_mut().zip(&mut *off).zip(nodes) {
        *z = if m.is_in() { *z } else { 0.0 };
        *off = if m.is_in() { 0.0 } else { 1.0 };
    }
    if C::IS_FINITE {
        let mut lacking = 0.0;
        for (i, ((off, m), p)) in off.iter_mut().zip(nodes).zip(p).enumerate() {
            let lacks = if m.is_full() { (ceiling.at(i) - *p).wide() } else { 0.0 };
            *off = if m.is_full() { 0.0 } else { *off };
            lacking += lacks * lacks;
        }
        sums[2] += f64x4::from_slice(vectors, &[lacking, 0.0, 0.0, 0.0]);
    }
    add_sums(vectors, z, off, p, sums);
    if !p.len().is_multiple_of(LANES) {
        add_sums(vectors, &rest(z), &rest(off), &rest(p), sums);
    }
    for ((t, p), z) in trial.iter_mut().zip(p).zip(&*z) {
        *t = *p - tau * T::of(f64::from(*z));
    }
}

/// Adds up `z`, `z^2`, `p^2` where `off` is 1 and not 0, and `p^2`, over whole vectors.
#[inline(always)]
fn add_sums<S: Simd, T: Real>(
    vectors: S,
    z: &[f32],
    off: &[f32],
    p: &[T],
    sums: &mut [f64x4<S>; 4],
) {
    for i in (0..p.len() - p.len() % LANES).step_by(LANES) {
        let z = f32::widened(four(vectors, z, i));
        let off = f32::widened(four(vectors, off, i));
        let p = T::widened(four(vectors, p, i));
        let p2 = p * p;
        sums[0] += z;
        sums[1] += z * z;
        sums[2] += off * p2;
        sums[3] += p2;
    }
}

/// The smallest trial pressure on F, or distance from a bound, below each cell of a row of the first level.
#[inline(always)]
fn smallest_below<T: Real, C: Ceiling<T>>(
    ceiling: C,
    t: &Transfer,
    nodes: &[Node],
    trial: &[T],
    smallest: &mut [f32],
) {
    let nx = t.fine[1];
    let least = |x: f32, y: f32| if x < y { x } else { y };
    let mut line = [0.0; TILE];
    let last = trial.len() - nx; // of two rows, or the single one again
    for ix in (0..nx).step_by(TILE) {
        let line = &mut line[..TILE.min(nx - ix)];
        line.fill(f32::INFINITY);
        for from in [ix, last + ix] {
            let fields = line.iter_mut().zip(&trial[from..]).zip(&nodes[from..]);
            for (i, ((x, p), m)) in fields.enumerate() {
                let mut here = p.narrow();
                if C::IS_FINITE {
                    here = least(here, (ceiling.at(from + i) - *p).narrow());
                }
                *x = least(*x, if m.is_in() { here } else { f32::INFINITY });
            }
        }
        if t.halved[1] {
            let (pairs, single) = line.as_chunks::<2>();
            for (s, x) in smallest[ix / 2..].iter_mut().zip(pairs) {
                *s = least(x[0], x[1]);
            }
            if let ([x], Some(s)) = (single, smallest.last_mut()) {
                *s = *x;
            }
        } else {
            smallest[ix..][..line.len()].copy_from_slice(line);
        }
    }
}

/// Ends a piece of whole rows of the trial, from `first_row` on: adds what was swept, clips, and sets
/// to zero outside the contact, or to the ceiling. Returns the sum.
pub(crate) fn end_trial<T: Real, C: Ceiling<T>>(
    ceiling: C,
    first_row: usize,
    nodes: &[Node],
    sweep: &Sweep,
    pyramid: &Pyramid,
    nx: usize,
    trial: &mut [T],
) -> Partial {
    let is_halved = pyramid.levels.first().is_some_and(|first| first.transfer.halved[1]);
    let mut more = [sweep.shift; TILE];
    let sum = vectorised!(x => {
        let mut sum = f64x4::splat(x, 0.0);
        for (i, (t, nodes)) in trial.chunks_exact_mut(nx).zip(nodes.chunks_exact(nx)).enumerate() {
            let added = sweep.added_below(first_row + i, pyramid);
            for ((k, t), nodes) in t.chunks_mut(TILE).enumerate().zip(nodes.chunks(TILE)) {
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
                let ceiling = ceiling.after((first_row + i) * nx + k * TILE);
                for (i, ((t, m), a)) in t.iter_mut().zip(nodes).zip(&more).enumerate() {
                    let kept = ceiling.clip(i, *t + T::of(f64::from(*a)));
                    *t = if m.is_in() { kept } else { T::zero() };
                    if C::IS_FINITE && m.is_full() {
                        *t = ceiling.at(i);
                    }
                }
                for i in (0..t.len() - t.len() % LANES).step_by(LANES) {
                    sum += T::widened(four(x, t, i));
                }
                if !t.len().is_multiple_of(LANES) {
                    sum += T::widened(four(x, &rest(t), 0));
                }
            }
        }
        sum.iter().sum()
    });
    [sum, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
}
