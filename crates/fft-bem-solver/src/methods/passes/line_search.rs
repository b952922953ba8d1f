//! What the search along the chord, and over the plane of the chord and the step before, needs.

use super::sums::{Largest, TILE};
use crate::Real;
use crate::methods::ceiling::Ceiling;
use crate::row_work::{Partial, TASK};
use crate::simd::{LANES, four, rest, vectorised};
use fearless_simd::{Fallback, Select, Simd, SimdBase, SimdFloat, f64x4};
use grid_fft::parallel::prelude::*;

/// The search over the plane of the chord and the step before is left out where these two are nearly
/// parallel (determinant of their products over that of their squares), or where it would go less far
/// along the chord.
const LEAST_DETERMINANT: f64 = 1e-6;
const LEAST_CHORD: f64 = 0.3;

/// Inner products of the chord `s = trial - p` and the step before, `d = p - before`.
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
    /// Whether a node in contact is not in the trial, or one below the ceiling reaches it there.
    pub(crate) has_dropped: bool,
    /// Level of the trial: the mean of `K trial - h` in its contact.
    pub(crate) level: f64,
}

impl Products {
    /// From what [`inner_products`] summed; `dkd` is known from the step before.
    pub(crate) fn new([gs, sks, ss, gd, skd, dropped, sum, contact]: Partial, dkd: f64) -> Self {
        let level = sum / contact.max(1.0);
        Self { gs, sks, ss, gd, dkd, skd, has_dropped: dropped > 0.0, level }
    }

    /// Where the energy is least along the chord.
    pub(crate) fn theta(&self) -> f64 {
        if self.sks > 0.0 { -self.gs / self.sks } else { 1.0 }
    }

    /// Where it is least over the plane of the chord and the step before, `[b1, b2]`.
    pub(crate) fn plane_minimum(&self) -> Option<[f64; 2]> {
        let determinant = self.sks * self.dkd - self.skd * self.skd;
        let b1 = (self.gd * self.skd - self.gs * self.dkd) / determinant;
        let b2 = (self.gs * self.skd - self.gd * self.sks) / determinant;
        let is_plane = determinant > LEAST_DETERMINANT * self.sks * self.dkd;
        (is_plane && b1 > LEAST_CHORD).then_some([b1, b2])
    }

    /// `<x, K x>` of the step `x = b1 s + b2 d`.
    pub(crate) fn curvature(&self, [b1, b2]: [f64; 2]) -> f64 {
        b1 * b1 * self.sks + 2.0 * b1 * b2 * self.skd + b2 * b2 * self.dkd
    }
}

/// Multiplies the trial `q` by `scale`, as its displacement `v` is already; writes its gap, counted
/// from the level of the iterate; and returns one piece of the sums of [`Products`]: `<g,s>, <s,Ks>, <s,s>, <g,d>,
/// <d,Ks>`, the nodes dropped, the sum of `v - h` over the contact of the trial and its nodes. `b`
/// is the pressure before the last step.
pub(crate) fn inner_products<T: Real, C: Ceiling<T>>(
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
        let (vectors, ceiling) = (Fallback::new(), ceiling.after(whole));
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
            let top = ceiling.four(vectors, i);
            let (was, is) = (T::widened(p).simd_ge(top), T::widened(trial).simd_ge(top));
            dropped += was.select(zero, is.select(one, zero));
        }
        rise += is.select(T::widened(height), zero);
        contact += is.select(one, zero);
    }
    [gs, sks, ss, gd, dks, dropped, rise, contact].map(|sum| sum.iter().sum())
}

/// How far along the chord from `p` to the trial the pressure stays within its bounds.
pub(crate) fn reach<T: Real, C: Ceiling<T>>(
    ceiling: C,
    p: &[T],
    trial: &[T],
    partial: &mut [Partial],
) -> f64 {
    let used = p.len().div_ceil(TASK);
    let pieces = p.par_chunks(TASK).zip(trial.par_chunks(TASK));
    partial[..used].par_iter_mut().zip(pieces).enumerate().for_each(|(task, (partial, (p, q)))| {
        let ceiling = ceiling.after(task * TASK);
        let (mut largest, mut loss) = (Largest::default(), [0.0; TILE]);
        vectorised!({
            for (k, (p, q)) in p.chunks(TILE).zip(q.chunks(TILE)).enumerate() {
                let ceiling = ceiling.after(k * TILE);
                for (i, ((loss, p), q)) in loss.iter_mut().zip(p).zip(q).enumerate() {
                    let (p, q) = (p.wide(), q.wide());
                    *loss = if q < p { (p - q) / p } else { 0.0 };
                    if C::IS_FINITE && q > p {
                        *loss = (q - p) / (ceiling.at(i).wide() - p);
                    }
                }
                largest.take(&loss[..p.len()]);
            }
        });
        partial[0] = largest.total();
    });
    partial[..used].iter().fold(0.0_f64, |x, partial| x.max(partial[0])).recip()
}
