//! Steps 4 and 5: the one convolution, and how far to go along the chord.

use super::run::{Known, Run, StepKind};
use super::trial::{end_trial, is_rough};
use crate::Real;
use crate::methods::ceiling::Ceiling;
use crate::methods::contract::State;
use crate::methods::level::{contact_sums, mean_of_sums};
use crate::row_work::{BLOCK_ROWS, Partial, RowWork, TASK, total};
use crate::simd::{LANES, four, rest, vectorised};
use fearless_simd::{Fallback, Select, Simd, SimdBase, SimdFloat, f64x4};
use grid_fft::parallel::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};

/// Below this chord length the step was a poor guess: take it as it is, and release nodes.
pub(super) const FULL: f64 = 0.7;
/// The search over the plane of the chord and the step before is left out where these two are nearly
/// parallel (determinant of their products over that of their squares), or where it would go less far
/// along the chord.
const LEAST_DETERMINANT: f64 = 1e-6;
const LEAST_CHORD: f64 = 0.3;
/// Pixels whose losses are looked at together.
const TILE: usize = 64;

/// Inner products of the chord `s = trial - p` and the step before, `d = p - before`.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Products {
    /// `<g, s>`, `<s, K s>`, `<s, s>`.
    gs: f64,
    sks: f64,
    ss: f64,
    /// `<g, d>`, `<d, K d>`, `<s, K d>`.
    gd: f64,
    dkd: f64,
    skd: f64,
    /// Whether a node in contact is not in the trial, or one below the ceiling reaches it there.
    has_dropped: bool,
    /// Level of the trial: the mean of `K trial - h` in its contact.
    level: f64,
}

impl Products {
    /// From what [`inner_products`] summed; `dkd` is known from the step before.
    fn new([gs, sks, ss, gd, skd, dropped, sum, contact]: Partial, dkd: f64) -> Self {
        let level = sum / contact.max(1.0);
        Self { gs, sks, ss, gd, dkd, skd, has_dropped: dropped > 0.0, level }
    }

    /// Where the energy is least along the chord.
    pub(super) fn theta(&self) -> f64 {
        if self.sks > 0.0 { -self.gs / self.sks } else { 1.0 }
    }

    /// Where it is least over the plane of the chord and the step before, `[b1, b2]`.
    fn plane_minimum(&self) -> Option<[f64; 2]> {
        let determinant = self.sks * self.dkd - self.skd * self.skd;
        let b1 = (self.gd * self.skd - self.gs * self.dkd) / determinant;
        let b2 = (self.gs * self.skd - self.gd * self.sks) / determinant;
        let is_plane = determinant > LEAST_DETERMINANT * self.sks * self.dkd;
        (is_plane && b1 > LEAST_CHORD).then_some([b1, b2])
    }

    /// `<x, K x>` of the step `x = b1 s + b2 d`.
    fn curvature(&self, [b1, b2]: [f64; 2]) -> f64 {
        b1 * b1 * self.sks + 2.0 * b1 * b2 * self.skd + b2 * b2 * self.dkd
    }
}

#[derive(Debug, Clone, Copy)]
pub(super) enum Trial {
    /// Swept, and what was swept is still to be added.
    Swept,
    /// Nowhere negative; this many times it carries the load.
    Ended(f64),
}

impl<T: Real, C: Ceiling<T>> Run<'_, T, C> {
    /// Gives the trial the load and computes `K trial`, the one convolution. Returns the inner products
    /// along the chord to it; `None` if nothing is left of the trial. The gap of the trial is counted from
    /// the level of the iterate.
    pub(super) fn respond(&mut self, trial: Trial, level: f64) -> Option<Products> {
        let (ceiling, wanted) = (self.ceiling, self.total());
        let work = &mut *self.work;
        let nx = work.columns();
        let (nodes, sweep) = (&work.nodes, &work.sweep);
        let below = &work.pyramid.levels[0].transfer;
        let prepare = |first: usize, q: &mut [T]| match trial {
            Trial::Ended(_) => Partial::default(),
            Trial::Swept => {
                let nodes = &nodes[first..][..q.len()];
                end_trial(ceiling, first / nx, nodes, sweep, below, q)
            }
        };
        let mut sum = 0.0;
        let mut factor = |sums: &[Partial]| {
            [sum] = total(sums);
            match trial {
                Trial::Ended(scale) => Some(scale),
                Trial::Swept => Some(wanted / sum).filter(|_| sum > 0.0 && !is_rough(sum, wanted)),
            }
        };
        let (p, u) = (&self.iterate.pressure[..], &self.iterate.displacement[..]);
        let (h, has_before) = (self.heights, self.memory.has_before);
        let before = if has_before { &work.pairs.before.pressure[..] } else { p }; // without one, d = 0
        let finish = |first: usize, scale: T, qv: [&mut [T]; 2], gap: &mut [f32]| {
            let [p, u, h, b] = [p, u, h, before].map(|x| &x[first..][..gap.len()]);
            inner_products(ceiling, [p, u, h], level, qv, scale, b, gap)
        };
        let around = RowWork {
            prepare: &prepare,
            factor: &mut factor,
            finish: &finish,
            pixels: BLOCK_ROWS * nx,
        };
        let (trial, gap) = (&mut work.pairs.trial, &mut work.residual);
        let (q, v) = (&mut trial.pressure, &mut trial.displacement);
        if let Some(sums) = self.operator.apply_around(q, v, gap, around, &mut work.partial) {
            self.transforms += 1.0;
            let dkd = if has_before { self.memory.dkd } else { 0.0 };
            return Some(Products::new(sums, dkd));
        }
        let scale = self.give_load(sum)?;
        self.respond(Trial::Ended(scale), level)
    }

    /// Goes along the chord, or to the minimum over the chord and the step before. The gap of the trial
    /// is counted from a level.
    pub(super) fn advance(&mut self, kind: StepKind, k: &Products, counted_from: f64) {
        let theta = k.theta();
        if kind == StepKind::Chord {
            self.memory.length = if theta < FULL { theta } else { 1.0 };
            if theta > 1.0 && !k.has_dropped {
                self.memory.length = theta.min(self.reach().max(1.0));
            }
            self.memory.adapt_length(theta);
        } else {
            self.memory.length = theta.clamp(0.0, 1.0);
            if k.sks > 0.0 {
                self.memory.alpha = k.ss / k.sks; // Barzilai & Borwein (1988), doi:10.1093/imanum/8.1.141
            }
        }
        let now = &self.memory;
        // A node that the trial drops would keep a part of its load: then only the chord will do.
        let is_searchable = now.has_before && kind == StepKind::Chord && !k.has_dropped;
        let length = now.length;
        let plane = k.plane_minimum().filter(|_| is_searchable);
        let step = plane.and_then(|b| Some((b, self.combine(b)?)));
        let b = if let Some((b, level)) = step {
            self.memory.length = 1.0;
            self.memory.known = Known::Level(level);
            std::mem::swap(&mut self.work.pairs.before, self.iterate);
            b
        } else {
            let is_whole = (length - 1.0).abs() < f64::EPSILON;
            self.memory.known = if is_whole {
                Known::Gap { level: k.level, counted_from }
            } else {
                Known::Level(self.shorten(length))
            };
            let pairs = &mut self.work.pairs;
            std::mem::swap(&mut pairs.trial, self.iterate);
            if pairs.has_room() {
                std::mem::swap(&mut pairs.before, &mut pairs.trial);
            }
            [length, 0.0]
        };
        self.memory.is_first = false;
        self.memory.has_before = self.work.pairs.has_room();
        self.memory.dkd = k.curvature(b);
    }

    /// How far along the chord to the trial the pressure stays within its bounds.
    fn reach(&mut self) -> f64 {
        let (ceiling, p) = (self.ceiling, &self.iterate.pressure);
        let work = &mut *self.work;
        let trial = &work.pairs.trial.pressure;
        let partial = &mut work.partial[..p.len().div_ceil(TASK)];
        let pieces = p.par_chunks(TASK).zip(trial.par_chunks(TASK)).zip(partial.par_iter_mut());
        pieces.for_each(|((p, q), partial)| {
            let (mut largest, mut loss) = ([0.0; LANES], [0.0; TILE]);
            vectorised!({
                for (p, q) in p.chunks(TILE).zip(q.chunks(TILE)) {
                    loss.fill(0.0);
                    for ((loss, p), q) in loss.iter_mut().zip(p).zip(q) {
                        let (p, q) = (p.wide(), q.wide());
                        *loss = if q < p { (p - q) / p } else { 0.0 };
                        if C::IS_FINITE && q > p {
                            *loss = (q - p) / (ceiling.top().wide() - p);
                        }
                    }
                    for four in loss.as_chunks::<LANES>().0 {
                        for (largest, x) in largest.iter_mut().zip(four) {
                            *largest = if *x > *largest { *x } else { *largest };
                        }
                    }
                }
            });
            partial[0] = largest.into_iter().fold(0.0, f64::max);
        });
        partial.iter().fold(0.0_f64, |x, partial| x.max(partial[0])).recip()
    }

    /// `before = p + b1 s + b2 d`, and the same for the displacements. Returns the level of the new iterate; `None`
    /// if a pressure comes out negative, or positive where the trial is zero, likewise at the ceiling. `before` is
    /// then undefined.
    fn combine(&mut self, b: [f64; 2]) -> Option<f64> {
        let (ceiling, h, b) = (self.ceiling, self.heights, b.map(T::of));
        let State { pressure: p, displacement: u, .. } = &*self.iterate;
        let work = &mut *self.work;
        let (trial, before) = (&work.pairs.trial, &mut work.pairs.before);
        let has_failed = AtomicBool::new(false);
        let partial = &mut work.partial[..p.len().div_ceil(TASK)];
        let both = before.pressure.par_chunks_mut(TASK);
        let both = both.zip(before.displacement.par_chunks_mut(TASK));
        both.zip(partial.par_iter_mut()).enumerate().for_each(|(task, ((x, w), partial))| {
            if has_failed.load(Ordering::Relaxed) {
                return; // the rest does not matter any more
            }
            let (from, n) = (task * TASK, x.len());
            let [p, u, h, q, v] =
                [p, u, h, &trial.pressure, &trial.displacement].map(|field| &field[from..][..n]);
            let fits = vectorised!(vectors => {
                let fits = step_pressure(ceiling, p, q, b, x);
                step_linearly(u, v, b, w);
                *partial = contact_sums(vectors, x, w, h);
                fits
            });
            if !fits {
                has_failed.store(true, Ordering::Relaxed);
            }
        });
        let level = mean_of_sums(partial);
        (!has_failed.into_inner()).then_some(level)
    }

    /// `trial = p + length s`, clipped, and the same for the displacements. Returns the level of the new iterate.
    fn shorten(&mut self, length: f64) -> f64 {
        let (ceiling, h, length) = (self.ceiling, self.heights, T::of(length));
        let State { pressure: p, displacement: u, .. } = &*self.iterate;
        let work = &mut *self.work;
        let trial = &mut work.pairs.trial;
        let partial = &mut work.partial[..p.len().div_ceil(TASK)];
        let both = trial.pressure.par_chunks_mut(TASK);
        let both = both.zip(trial.displacement.par_chunks_mut(TASK));
        both.zip(partial.par_iter_mut()).enumerate().for_each(|(task, ((q, v), partial))| {
            let (from, n) = (task * TASK, q.len());
            let [p, u, h] = [p, u, h].map(|x| &x[from..][..n]);
            vectorised!(vectors => {
                for (q, p) in q.iter_mut().zip(p) {
                    *q = ceiling.clip(*p + length * (*q - *p));
                }
                for (v, u) in v.iter_mut().zip(u) {
                    *v = *u + length * (*v - *u);
                }
                *partial = contact_sums(vectors, q, v, h);
            });
        });
        mean_of_sums(partial)
    }
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
    for (x, q) in before.iter_mut().zip(trial) {
        let misfit = (*x < T::zero()) | ((*q <= T::zero()) & (*x > T::zero()));
        misfits += u32::from(misfit);
        if C::IS_FINITE {
            let top = ceiling.top();
            misfits += u32::from((*x > top) | ((*q >= top) & (*x < top)));
        }
        *x = ceiling.clip(*x);
    }
    misfits == 0
}

/// Multiplies the trial `q` by `scale`, as its displacement `v` is already; writes its gap, counted
/// from the level of the iterate; and returns one piece of the sums of [`Products`]: `<g,s>, <s,Ks>, <s,s>, <g,d>,
/// <d,Ks>`, the nodes dropped, the sum of `v - h` over the contact of the trial and its nodes. `b`
/// is the pressure before the last step.
fn inner_products<T: Real, C: Ceiling<T>>(
    ceiling: C,
    [p, u, h]: [&[T]; 3],
    level: f64,
    [q, v]: [&mut [T]; 2],
    scale: T,
    b: &[T],
    gap: &mut [f32],
) -> Partial {
    let level = T::of(level);
    let fields = [p, u, h, b, &*v];
    let mut sums = vectorised!(x => products_by_fours(x, ceiling, fields, level, q, scale, gap));
    let whole = gap.len() - gap.len() % LANES;
    if whole < gap.len() {
        let (mut last, mut its_gap) = (rest(q), [0.0; LANES]);
        let fields = fields.map(rest);
        let fields = fields.each_ref().map(|x| &x[..]);
        let vectors = Fallback::new();
        let more =
            products_by_fours(vectors, ceiling, fields, level, &mut last, scale, &mut its_gap);
        sums.iter_mut().zip(more).for_each(|(sum, x)| *sum += x);
        q[whole..].iter_mut().zip(last).for_each(|(q, x)| *q = x);
        gap[whole..].iter_mut().zip(its_gap).for_each(|(gap, x)| *gap = x);
    }
    sums
}

/// The same on whole vectors of the fields `p`, `u`, `h`, `b`, `v` and of `q`.
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "a pass over seven fields")]
fn products_by_fours<S: Simd, T: Real, C: Ceiling<T>>(
    vectors: S,
    ceiling: C,
    [p, u, h, b, v]: [&[T]; 5],
    level: T,
    q: &mut [T],
    scale: T,
    gap: &mut [f32],
) -> Partial {
    let (zero, one) = (f64x4::splat(vectors, 0.0), f64x4::splat(vectors, 1.0));
    let [mut gs, mut sks, mut ss, mut gd, mut dks, mut dropped, mut rise, mut contact] = [zero; 8];
    for i in (0..gap.len() - gap.len() % LANES).step_by(LANES) {
        let (p, u, h) = (four(vectors, p, i), four(vectors, u, i), four(vectors, h, i));
        let (b, v) = (four(vectors, b, i), four(vectors, v, i));
        let trial = four(vectors, q, i) * scale;
        trial.store_slice(&mut q[i..i + LANES]);
        let height = v - h;
        for (gap, g) in gap[i..i + LANES].iter_mut().zip((height - level).as_slice()) {
            *gap = g.narrow();
        }
        let (g, s) = (T::widened(u - h - level), T::widened(trial - p));
        let (d, ks) = (T::widened(p - b), T::widened(v - u));
        gs += g * s;
        sks += s * ks;
        ss += s * s;
        gd += g * d;
        dks += d * ks;
        let (was, is) = (T::widened(p).simd_gt(zero), T::widened(trial).simd_gt(zero));
        dropped += is.select(zero, was.select(one, zero));
        if C::IS_FINITE {
            let top = f64x4::splat(vectors, ceiling.top().wide());
            let (was, is) = (T::widened(p).simd_ge(top), T::widened(trial).simd_ge(top));
            dropped += was.select(zero, is.select(one, zero));
        }
        rise += is.select(T::widened(height), zero);
        contact += is.select(one, zero);
    }
    [gs, sks, ss, gd, dks, dropped, rise, contact].map(|sum| sum.iter().sum())
}
