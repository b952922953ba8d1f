//! What the search along the chord, and over the plane of the chord and the step before, needs.

use super::sums::{Largest, Sum, TILE};
use super::{Partial, TASK};
use crate::Real;
use crate::simd::vectorised;
use grid_fft::parallel::prelude::*;

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
    /// Whether a node in contact is not in the trial.
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
        (determinant > 1e-6 * self.sks * self.dkd && b1 > 0.3).then_some([b1, b2])
    }

    /// `<x, K x>` of the step `x = b1 s + b2 d`.
    pub(crate) fn curvature(&self, [b1, b2]: [f64; 2]) -> f64 {
        b1 * b1 * self.sks + 2.0 * b1 * b2 * self.skd + b2 * b2 * self.dkd
    }
}

/// Multiplies the trial `q` by `scale`, as its displacement `v` is already; writes its gap, counted
/// from the level `from`; and returns one piece of the sums of [`Products`]: `<g,s>, <s,Ks>, <s,s>, <g,d>,
/// <d,Ks>`, the nodes dropped, the sum of `v - h` over the contact of the trial and its nodes. `b`
/// is the pressure before the last step.
pub(crate) fn inner_products<T: Real>(
    [p, u, h]: [&[T]; 3],
    levels: [f64; 2],
    [q, v]: [&mut [T]; 2],
    scale: T,
    b: &[T],
    gap: &mut [f32],
) -> Partial {
    let (mut sums, mut room) = ([Sum::default(); 8], [[0.0; TILE]; 5]);
    vectorised!({
        let tiles = q.chunks_mut(TILE).zip(v.chunks(TILE)).zip(gap.chunks_mut(TILE));
        for (k, ((q, v), gap)) in tiles.enumerate() {
            let [p, u, h, b] = [p, u, h, b].map(|x| &x[k * TILE..][..q.len()]);
            for q in &mut *q {
                *q *= scale;
            }
            add_products([p, u, h], levels.map(T::of), [q, v], b, gap, &mut room, &mut sums);
        }
    });
    sums.map(Sum::total)
}

/// One tile of [`inner_products`].
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "a pass over seven fields")]
fn add_products<T: Real>(
    [p, u, h]: [&[T]; 3],
    [level, from]: [T; 2],
    [q, v]: [&[T]; 2],
    b: &[T],
    gap: &mut [f32],
    room: &mut [[f64; TILE]; 5],
    sums: &mut [Sum; 8],
) {
    let n = p.len().min(TILE);
    let (p, u, h, q, v, b) = (&p[..n], &u[..n], &h[..n], &q[..n], &v[..n], &b[..n]);
    let [g, s, ks, d, rise] = room.each_mut().map(|x| &mut x[..n]);
    for i in 0..n {
        g[i] = (u[i] - h[i] - level).wide();
        s[i] = (q[i] - p[i]).wide();
        ks[i] = (v[i] - u[i]).wide();
        d[i] = (p[i] - b[i]).wide();
    }
    let (mut contact, mut dropped) = (0, 0);
    for i in 0..n {
        contact += u32::from(q[i] > T::zero());
        dropped += u32::from((p[i] > T::zero()) & (q[i] <= T::zero()));
    }
    for i in 0..n {
        let height = v[i] - h[i];
        gap[i] = (height - from).narrow();
        rise[i] = f64::from(u8::from(q[i] > T::zero())) * height.wide();
    }
    sums[0].add_product(g, s);
    sums[1].add_product(s, ks);
    sums[2].add_product(s, s);
    sums[3].add_product(g, d);
    sums[4].add_product(d, ks);
    sums[5].add(&[f64::from(dropped)]);
    sums[6].add(rise);
    sums[7].add(&[f64::from(contact)]);
}

/// How far along the chord from `p` to the trial the pressure stays positive.
pub(crate) fn reach<T: Real>(p: &[T], trial: &[T], partial: &mut [Partial]) -> f64 {
    let used = p.len().div_ceil(TASK);
    let pieces = p.par_chunks(TASK).zip(trial.par_chunks(TASK));
    partial[..used].par_iter_mut().zip(pieces).for_each(|(partial, (p, q))| {
        let (mut largest, mut loss) = (Largest::default(), [0.0; TILE]);
        vectorised!({
            for (p, q) in p.chunks(TILE).zip(q.chunks(TILE)) {
                for ((loss, p), q) in loss.iter_mut().zip(p).zip(q) {
                    let (p, q) = (p.wide(), q.wide());
                    *loss = if q < p { (p - q) / p } else { 0.0 };
                }
                largest.take(&loss[..p.len()]);
            }
        });
        partial[0] = largest.total();
    });
    partial[..used].iter().fold(0.0_f64, |x, partial| x.max(partial[0])).recip()
}
