//! What the search along the chord, and over the plane of the chord and the step before, needs.

use super::Partial;
use crate::{Real, fields};

/// Independent partial sums, so that additions need not wait for one another.
const LANES: usize = 4;

/// Inner products of the chord `s = c trial - p` and the step before, `d = p - before`.
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

impl Products {
    /// From what [`inner_products`] summed; `dkd` is known from the step before.
    pub(crate) fn new([gs, sks, ss, gd, skd, dropped, ..]: Partial, dkd: f64) -> Self {
        Self { gs, sks, ss, gd, dkd, skd, has_dropped: dropped > 0.0 }
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

/// One piece of the sums of [`Products`]: `<g,s>, <s,Ks>, <s,s>, <g,d>, <d,Ks>` and the number of
/// nodes dropped. `v` is the displacement of the trial `q`, both before they are multiplied by
/// `scale`; `b` the pressure before the last step.
pub(crate) fn inner_products<T: Real>(
    [p, u, h]: [&[T]; 3],
    level: f64,
    [q, v]: [&[T]; 2],
    scale: f64,
    b: &[T],
) -> Partial {
    let n = p.len();
    let (level, scale) = (T::of(level), T::of(scale));
    let (u, h, q, v, b) = (&u[..n], &h[..n], &q[..n], &v[..n], &b[..n]);
    let mut lanes = [[0.0_f64; LANES]; 6];
    let mut add = |i: usize, lane: usize| {
        let g = (u[i] - h[i] - level).wide();
        let (s, ks) = ((scale * q[i] - p[i]).wide(), (scale * v[i] - u[i]).wide());
        let d = (p[i] - b[i]).wide();
        lanes[0][lane] += g * s;
        lanes[1][lane] += s * ks;
        lanes[2][lane] += s * s;
        lanes[3][lane] += g * d;
        lanes[4][lane] += d * ks;
        let drops = (p[i] > T::zero()) & (q[i] <= T::zero());
        lanes[5][lane] += if drops { 1.0 } else { 0.0 };
    };
    for i in (0..n - n % LANES).step_by(LANES) {
        for lane in 0..LANES {
            add(i + lane, lane);
        }
    }
    for i in n - n % LANES..n {
        add(i, 0);
    }
    let [a, b, c, d, e, f] = lanes.map(|l| l.iter().sum::<f64>());
    [a, b, c, d, e, f, 0.0, 0.0]
}

/// How far along the chord from `p` to `scale` times the trial the pressure stays positive.
pub(crate) fn reach<T: Real>(p: &[T], trial: &[T], scale: f64) -> f64 {
    let scale = T::of(scale);
    let reach = |p: T, q: T| if q < p { p.wide() / (p - q).wide() } else { f64::INFINITY };
    fields::least_of(p.len(), |i| reach(p[i], scale * trial[i]))
}
