//! Steps 2 and 3: the preconditioned residual, the trial it leads to, and the sweep that frees that of
//! tension.

use super::active_set::ContactSet;
use super::run::{Run, project};
use crate::methods::ceiling::Ceiling;
use crate::methods::extension::PyramidLevel;
use crate::methods::node::NodeState;
use crate::methods::sweep::{self, Sweep};
use crate::methods::thin_pixels;
use crate::methods::transfer::Transfer;
use crate::row_work::{Partial, total};
use crate::simd::{LANES, four, rest, vectorised};
use crate::{Real, fields, projection};
use fearless_simd::{Simd, SimdBase, f64x4};
use grid_fft::parallel::prelude::*;
use std::f64::consts::FRAC_PI_2;

/// Pressure per gap of a node that joins the contact because the others cannot carry more, per finer
/// pixel and `E*`: about that of a single node.
const STIFFNESS: f64 = 1.0;
/// Pixels handled at a time where there must be room for intermediate fields.
const TILE: usize = 64;

/// Below this part of what the softest wave of the grid would make of the residual gap, an estimate is
/// not believed.
const INCREDIBLE: f64 = 0.01;

impl<T: Real, C: Ceiling<T>> Run<'_, T, C> {
    /// `y = S E g`, in place of the residual, and all of `z = E^T y` but the last step down to the
    /// finest grid, which [`make_trial`](Self::make_trial) does.
    pub(crate) fn precondition(&mut self) {
        let work = &mut *self.work;
        let extended = work.pairs.trial_and_spare().1;
        work.stiffness.apply_to_filled(extended, &mut work.residual);
        work.pyramid.restrict(&work.nodes, &work.residual);
        self.transforms += work.stiffness.cost;
    }

    /// Ends `z = E^T y` and makes the step: the trial is `p - tau z` on F, `p` elsewhere. That the mean of z does not
    /// belong to the step is known only at the end: [`Sweep::begin`] is told. Where `E g` was, the smallest trial
    /// pressure below each cell of the first level is left for
    /// [`sweep_trial`](Self::sweep_trial); under a ceiling, the smallest distance from a bound.
    ///
    /// Returns the estimate `|z on F, p off F| / |p|`, where z is taken less its mean over F, and
    /// `|p|^2`.
    pub(crate) fn make_trial(&mut self, tau: f64, set: ContactSet) -> [f64; 2] {
        let work = &mut *self.work;
        let (rows, nx) = (work.rows, work.columns());
        let chunk = rows * nx;
        let (trial, smallest) = work.pairs.trial_and_spare();
        let partial = &mut work.partial[..trial.len().div_ceil(chunk)];
        let level = &work.pyramid.levels[0];
        let p = &self.iterate.pressure[..];
        let step = PressureStep { ceiling: self.ceiling, p, tau, level };
        let fields = partial
            .par_iter_mut()
            .zip(work.residual.par_chunks(chunk))
            .zip(work.nodes.par_chunks(chunk))
            .zip(trial.par_chunks_mut(chunk));
        let (height, mx) = (level.transfer.rows_per_coarse_row(), level.transfer.coarse[1]);
        fields.zip(smallest.par_chunks_mut(rows / height * mx)).enumerate().for_each(
            |(task, ((((partial, y), nodes), trial), smallest))| {
                *partial = vectorised!(x => {
                    let mut sums = [f64x4::splat(x, 0.0); 4];
                    let below = y.chunks(height * nx).zip(nodes.chunks(height * nx));
                    let cells = below.zip(trial.chunks_mut(height * nx));
                    let cells = cells.zip(smallest.chunks_mut(mx)).enumerate();
                    for (j, (((y, nodes), trial), smallest)) in cells {
                        step.cells(x, task * rows + j * height, y, nodes, trial, smallest, &mut sums);
                    }
                    let [a, b, c, d] = sums.map(|sum| sum.iter().sum());
                    [a, b, c, d, 0.0, 0.0, 0.0, 0.0]
                });
            },
        );
        let [z, z2, off2, p2] = total(partial);
        let mean = z / set.size.max(1) as f64;
        work.sweep.begin((tau * mean) as f32);
        [(((z2 - mean * z).max(0.0) + off2) / p2).sqrt(), p2]
    }

    /// The estimate, unless even the softest wave of the grid would resist the residual gap more: then
    /// the preconditioner is at fault, and the stiffest wave bounds the error instead.
    pub(super) fn credible(&self, [estimate, p2]: [f64; 2], level: f64) -> f64 {
        let (u, h, nodes) = (&self.iterate.displacement, self.heights, &self.work.nodes);
        let level = T::of(level);
        let square =
            |i: usize| if nodes[i].is_in() { (u[i] - h[i] - level).wide().powi(2) } else { 0.0 };
        let gap2 = fields::sum_of(u.len(), square);
        let stiffest = FRAC_PI_2 * (gap2 / p2).sqrt(); // |q|/2 at pi per finer pixel
        let longest = self.work.grid.size().into_iter().fold(1.0, f64::max);
        let softest = 2.0 / longest * stiffest;
        if estimate < INCREDIBLE * softest { stiffest } else { estimate }
    }

    /// Sweeps the trial that was just made. The tension that is left will be clipped, and the load that takes spread
    /// over the whole map: an error of the softest wave, which must be small beside the present error, `residual`, at
    /// most 1. The softest wave of a slender map is as much softer than that of a square.
    pub(crate) fn sweep_trial(&mut self, set: ContactSet, residual: f64) {
        let (total, work) = (self.total(), &mut *self.work);
        let slenderness = thin_pixels::ratio(work.grid.shape(), work.grid.size());
        let negligible = sweep::NEGLIGIBLE * total * residual / slenderness;
        let (trial, smallest) = work.pairs.trial_and_spare();
        work.sweep.run(
            self.ceiling,
            &mut work.pyramid,
            trial,
            &mut work.nodes,
            smallest,
            set.size,
            set.has_released,
            [negligible, sweep::LITTLE * total],
        );
    }

    /// Clips the swept trial, made from a base at this level. Returns the factor that gives it the load; `None` if
    /// nothing is left.
    pub(crate) fn end_trial(&mut self, level: f64) -> Option<f64> {
        let ceiling = self.ceiling;
        let work = &mut *self.work;
        let (rows, nx) = (work.rows, work.columns());
        let (size, trial) = (rows * nx, &mut work.pairs.trial.pressure);
        let (sweep, below) = (&work.sweep, &work.pyramid.levels[0].transfer);
        let pieces = trial.par_chunks_mut(size).zip(work.nodes.par_chunks(size));
        pieces.zip(work.partial.par_iter_mut()).enumerate().for_each(
            |(k, ((q, nodes), partial))| {
                *partial = end_trial(ceiling, k * rows, nodes, sweep, below, q);
            },
        );
        if C::IS_FINITE {
            self.give_load_below_ceiling(level);
            return Some(1.0);
        }
        let [sum] = total(&work.partial[..trial.len().div_ceil(size)]);
        self.give_load(sum)
    }

    /// The factor that gives the clipped trial the load, if `sum` is what it carries.
    pub(super) fn give_load(&mut self, sum: f64) -> Option<f64> {
        let total = self.total();
        if sum <= 0.0 || !sum.is_finite() {
            return None;
        }
        if is_rough(sum, total) {
            projection::onto_admissible(&mut self.work.pairs.trial.pressure, self.load);
            return Some(1.0);
        }
        Some(total / sum)
    }

    /// Gives the clipped trial the load where nodes at the ceiling cannot be scaled: by a factor on the
    /// others, if that is a small matter. Else the contact set is too small or too large to carry it, and the
    /// nodes that come next, those with the least gap in the iterate or the least overlap, join or leave it.
    fn give_load_below_ceiling(&mut self, level: f64) {
        let (load, total, top) = (self.load, self.total(), self.ceiling.top());
        let heights = self.heights;
        let (trial, u) = (&mut self.work.pairs.trial.pressure, &self.iterate.displacement);
        if projection::scale_below(trial, total, top, sweep::ROUGH) {
            return;
        }
        let (stiffness, level) = (T::of(STIFFNESS), T::of(level));
        fields::write(trial, |i, p| {
            let step = stiffness * (u[i] - heights[i] - level);
            match (p > T::zero(), p < top) {
                (true, true) => p,
                (false, _) => T::zero() - step.larger(T::zero()),
                (_, false) => p + (T::zero() - step).larger(T::zero()),
            }
        });
        projection::between(trial, load, top);
    }

    /// `trial = p - alpha g`, projected on the pressures that are positive and carry the load.
    pub(super) fn gradient_trial(&mut self, level: f64) {
        let (p, u, h) = (&self.iterate.pressure, &self.iterate.displacement, self.heights);
        let trial = &mut self.work.pairs.trial.pressure;
        let (alpha, level) = (T::of(self.memory.alpha), T::of(level));
        for (i, t) in trial.iter_mut().enumerate() {
            *t = p[i] - alpha * (u[i] - h[i] - level);
        }
        project(self.ceiling, trial, self.load);
    }
}

/// Whether much was clipped, if `sum` is left of a trial that should carry `total`: the contact is
/// far from settled, and small loads do not belong.
pub(super) fn is_rough(sum: f64, total: f64) -> bool {
    sum > (1.0 + 2.0 * sweep::NEGLIGIBLE) * total
}

/// What the rows of a trial have in common.
#[derive(Clone, Copy)]
struct PressureStep<'a, T, C> {
    ceiling: C,
    p: &'a [T],
    tau: f64,
    level: &'a PyramidLevel,
}

impl<T: Real, C: Ceiling<T>> PressureStep<'_, T, C> {
    /// The rows from `row` on, below one row of cells: the trial, and the smallest of it below each cell. Adds up `z`, `z^2` on F, `p^2` off F (of those that are to carry the ceiling, what they
    /// lack), `p^2`.
    #[inline(always)]
    #[allow(clippy::too_many_arguments, reason = "a pass over five fields")]
    fn cells<S: Simd>(
        &self,
        vectors: S,
        row: usize,
        y: &[f32],
        nodes: &[NodeState],
        trial: &mut [T],
        smallest: &mut [f32],
        sums: &mut [f64x4<S>; 4],
    ) {
        let nx = self.level.transfer.fine[1];
        let (mut z, mut least) = ([0.0; TILE], [0.0; TILE]);
        for ix in (0..nx).step_by(TILE) {
            let n = TILE.min(nx - ix);
            let (z, least) = (&mut z[..n], &mut least[..n]);
            least.fill(f32::INFINITY);
            for (i, trial) in trial.chunks_exact_mut(nx).enumerate() {
                let (here, row) = (i * nx + ix, row + i);
                z.copy_from_slice(&y[here..][..n]);
                self.level.transfer.add_down_transposed(row, ix, &self.level.value, z);
                let (nodes, trial) = (&nodes[here..][..n], &mut trial[ix..][..n]);
                self.tile(vectors, row * nx + ix, z, nodes, trial, least, sums);
            }
            smallest_below(self.level.transfer.halved[1], ix, least, smallest);
        }
    }

    /// Part of a row, from pixel `first` on. Brings `least` up to date: the smallest trial pressure on F, or
    /// distance from a bound, of each column.
    #[inline(always)]
    #[allow(clippy::too_many_arguments, reason = "a pass over five fields")]
    fn tile<S: Simd>(
        &self,
        vectors: S,
        first: usize,
        z: &mut [f32],
        nodes: &[NodeState],
        trial: &mut [T],
        least: &mut [f32],
        sums: &mut [f64x4<S>; 4],
    ) {
        let (p, top) = (&self.p[first..][..z.len()], self.ceiling.top());
        let mut off = [0.0; TILE];
        let off = &mut off[..nodes.len()];
        off.iter_mut().zip(nodes).for_each(|(off, m)| *off = if m.is_in() { 0.0 } else { 1.0 });
        z.iter_mut().zip(&*off).for_each(|(z, off)| *z *= 1.0 - off);
        if C::IS_FINITE {
            let mut lacking = 0.0;
            for ((off, m), p) in off.iter_mut().zip(nodes).zip(p) {
                let lacks = if m.is_full() { (top - *p).wide() } else { 0.0 };
                *off = if m.is_full() { 0.0 } else { *off };
                lacking += lacks * lacks;
            }
            sums[2] += f64x4::from_slice(vectors, &[lacking, 0.0, 0.0, 0.0]);
        }
        self.step(vectors, z, off, p, trial, sums);
        if !p.len().is_multiple_of(LANES) {
            let mut last = [T::zero(); LANES];
            self.step(vectors, &rest(z), &rest(off), &rest(p), &mut last, sums);
            let whole = p.len() - p.len() % LANES;
            trial[whole..].iter_mut().zip(last).for_each(|(t, x)| *t = x);
        }
        for (((least, t), off), m) in least.iter_mut().zip(&*trial).zip(&*off).zip(nodes) {
            let is_off = if C::IS_FINITE { !m.is_in() } else { *off > 0.0 };
            let here = if is_off { f32::INFINITY } else { t.narrow() };
            *least = if here < *least { here } else { *least };
        }
        if C::IS_FINITE {
            for ((least, t), m) in least.iter_mut().zip(&*trial).zip(nodes) {
                let room = if m.is_in() { (top - *t).narrow() } else { f32::INFINITY };
                *least = if room < *least { room } else { *least };
            }
        }
    }

    /// The trial `p - tau z`, and the sums of `z`, `z^2`, `p^2` where `off` is 1 and not 0, and `p^2`, over whole
    /// vectors.
    #[inline(always)]
    fn step<S: Simd>(
        &self,
        vectors: S,
        z: &[f32],
        off: &[f32],
        p: &[T],
        trial: &mut [T],
        sums: &mut [f64x4<S>; 4],
    ) {
        let tau = f64x4::splat(vectors, self.tau);
        for i in (0..p.len() - p.len() % LANES).step_by(LANES) {
            let z = f32::widened(four(vectors, z, i));
            let off = f32::widened(four(vectors, off, i));
            let p = T::widened(four(vectors, p, i));
            let p2 = p * p;
            sums[0] += z;
            sums[1] += z * z;
            sums[2] += off * p2;
            sums[3] += p2;
            let step = p - tau * z;
            trial[i..i + LANES].iter_mut().zip(step.as_slice()).for_each(|(t, x)| *t = T::of(*x));
        }
    }
}

/// From the smallest of each column to the smallest below each cell, from column `ix` on.
#[inline(always)]
fn smallest_below(is_halved: bool, ix: usize, least: &[f32], smallest: &mut [f32]) {
    if !is_halved {
        smallest[ix..][..least.len()].copy_from_slice(least);
        return;
    }
    let (pairs, single) = least.as_chunks::<2>();
    for (s, x) in smallest[ix / 2..].iter_mut().zip(pairs) {
        *s = if x[1] < x[0] { x[1] } else { x[0] };
    }
    if let ([x], Some(s)) = (single, smallest.last_mut()) {
        *s = *x;
    }
}

/// Ends a piece of whole rows of the trial, from `first_row` on: adds what was swept, clips, and sets
/// to zero outside the contact, or to the ceiling. Returns the sum.
pub(super) fn end_trial<T: Real, C: Ceiling<T>>(
    ceiling: C,
    first_row: usize,
    nodes: &[NodeState],
    sweep: &Sweep,
    below: &Transfer,
    trial: &mut [T],
) -> Partial {
    let nx = below.fine[1];
    let mut more = [0.0; TILE];
    let sum = vectorised!(x => {
        let mut sum = f64x4::splat(x, 0.0);
        for (i, (t, nodes)) in trial.chunks_exact_mut(nx).zip(nodes.chunks_exact(nx)).enumerate() {
            let added = sweep.added_below(first_row + i, below);
            for ((k, t), nodes) in t.chunks_mut(TILE).enumerate().zip(nodes.chunks(TILE)) {
                if below.halved[1] {
                    let pairs = more.as_chunks_mut::<2>().0;
                    for (more, a) in pairs.iter_mut().zip(&added[k * TILE / 2..]) {
                        *more = [*a; 2];
                    }
                } else {
                    more[..t.len()].copy_from_slice(&added[k * TILE..][..t.len()]);
                }
                for ((t, m), a) in t.iter_mut().zip(nodes).zip(&more) {
                    let kept = ceiling.clip(*t + T::of(f64::from(*a)));
                    *t = if m.is_in() { kept } else { T::zero() };
                    if C::IS_FINITE && m.is_full() {
                        *t = ceiling.top();
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
