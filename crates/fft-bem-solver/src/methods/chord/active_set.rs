//! Step 1: what is wrong with the iterate. The level, the contact set F, the residual gap g on it, `E g`.

use super::run::{Known, Run};
use crate::methods::ceiling::Ceiling;
use crate::methods::contract::State;
use crate::methods::extension::pull_rows;
use crate::methods::level;
use crate::methods::node::NodeState;
use crate::methods::transfer::FilledPart;
use crate::row_work::{Partial, total};
use crate::simd::vectorised;
use crate::{Real, fields};
use grid_fft::parallel::prelude::*;

/// After a poor step, nodes with less pressure than this times their gap are let go; as much less as
/// pixels are longer than wide, where a line of them may stand off as a whole for a lack of little load.
pub(super) const RELEASE: f64 = 0.1;

const BLOCK: usize = 256;

#[derive(Debug, Clone, Copy)]
pub(crate) struct ContactSet {
    pub(crate) size: usize,
    /// Whether nodes outside F carry load, or less than the ceiling that they are to carry.
    pub(crate) has_released: bool,
}

impl<T: Real, C: Ceiling<T>> Run<'_, T, C> {
    /// The level of the iterate, from which the residual gap g is counted; its contact set F; and `E g`.
    ///
    /// The level is the plain mean of `u - h` in contact, so that g has no mean there, which no
    /// pressure could remove.
    pub(crate) fn look(&mut self, known: Known, release: f64) -> (f64, ContactSet) {
        let (level, excess) = match known {
            Known::Level(level) if !C::IS_FINITE => (level, None),
            Known::Gap { level, counted_from: c } if !C::IS_FINITE => (level, Some(level - c)),
            _ => (self.level_of_iterate(), None),
        };
        (level, self.contact_set(level, excess, release))
    }

    fn level_of_iterate(&mut self) -> f64 {
        let State { pressure: p, displacement: u, .. } = &*self.iterate;
        if C::IS_FINITE {
            let fields = [&p[..], &u[..], self.heights];
            return level::level_under(self.ceiling, fields, &mut self.work.partial);
        }
        level::level([p, u, self.heights], &mut self.work.partial)
    }

    /// The set `F = {p > release max(g, 0)} or {g < 0}`, the residual g on it, and `E g`. With `excess`, the residual
    /// field holds the gap but for that.
    ///
    /// Under a ceiling H a node must also be pressed less than that, `H - p > release max(-g, 0)`, or stand
    /// off, `g > 0`.
    fn contact_set(&mut self, level: f64, excess: Option<f64>, release: f64) -> ContactSet {
        let work = &mut *self.work;
        let (nx, chunk) = (work.columns(), work.rows * work.columns());
        let State { pressure: p, displacement: u, .. } = &*self.iterate;
        let extended = work.pairs.trial_and_spare().1;
        let classify =
            Classify { ceiling: self.ceiling, fields: [u, self.heights], level, excess, release };
        let partial = &mut work.partial[..p.len().div_ceil(chunk)];
        let fields = partial
            .par_iter_mut()
            .zip(p.par_chunks(chunk))
            .zip(work.nodes.par_chunks_mut(chunk))
            .zip(work.residual.par_chunks_mut(chunk));
        let first = &mut work.pyramid.levels[0];
        let (t, capacity) = (first.transfer, first.capacity);
        let coarse = chunk / (t.rows_per_coarse_row() * nx) * t.coarse[1];
        fields
            .zip(first.weight.par_chunks_mut(coarse))
            .zip(first.value.par_chunks_mut(coarse))
            .enumerate()
            .for_each(|(task, (((((partial, p), m), r), weight), value))| {
                vectorised!({
                    *partial = classify.nodes(task * chunk, p, m, r);
                    pull_rows(&t, capacity, m, r, weight, value);
                });
            });
        let [active, released] = total(partial);
        work.pyramid.extend_above();
        work.pyramid.push(&work.nodes, &work.residual, &mut work.stiffness, extended);
        ContactSet { size: active as usize, has_released: released > 0.0 }
    }

    /// Where the level is prescribed: scales everything to a load that should bring it there. `level`
    /// is where it is now, and `E g` says where it will settle.
    pub(super) fn towards_level(&mut self, level: f64) {
        let Some(control) = &mut self.control else { return };
        let pairs = &mut self.work.pairs;
        let State { pressure, displacement, .. } = &*self.iterate;
        control.guess([pressure, displacement], self.memory.residual);
        let rise = fields::mean(pairs.trial_and_spare().1);
        let factor = control.factor(level + rise, self.load, self.memory.residual);
        self.iterate.scale(factor);
        pairs.before.scale(factor); // the step before must stay one that changes no load
        self.load *= factor;
        self.memory.dkd *= factor * factor;
    }

    /// Whether the residual gap of the iterate, on F, is no more than the rounding of the fields it is a difference of.
    pub(super) fn is_rounding(&self, level: f64) -> bool {
        if self.memory.residual >= T::EPSILON.sqrt() {
            return false;
        }
        let (u, h, nodes) = (&self.iterate.displacement, self.heights, &self.work.nodes);
        let level = T::of(level);
        let on = |i: usize, x: T| if nodes[i].is_in() { x.wide().abs() } else { 0.0 };
        let largest = |of: &(dyn Fn(usize) -> f64 + Sync)| fields::largest_of(u.len(), of);
        let [gap, height] = [largest(&|i| on(i, u[i] - h[i] - level)), largest(&|i| on(i, h[i]))];
        gap <= 2.0 * T::EPSILON * (largest(&|i| u[i].wide().abs()) + height)
    }
}

#[derive(Clone, Copy)]
struct Classify<'a, T, C> {
    ceiling: C,
    /// The gap is `u - h - level`.
    fields: [&'a [T]; 2],
    level: f64,
    /// Or it is known already, but for this constant to be taken off.
    excess: Option<f64>,
    release: f64,
}

impl<T: Real, C: Ceiling<T>> Classify<'_, T, C> {
    /// Marks the nodes from pixel `first` on and leaves the gap on those of F. Returns how many these
    /// are, and how many carry load but do not belong. In single precision, as the gap is.
    #[inline(always)]
    fn nodes(&self, first: usize, p: &[T], nodes: &mut [NodeState], gap: &mut [f32]) -> Partial {
        let release = self.release as f32;
        let blocks = p.chunks(BLOCK).zip(nodes.chunks_mut(BLOCK)).zip(gap.chunks_mut(BLOCK));
        let (mut active, mut released) = (0, 0);
        let (mut load, mut is_in) = ([0.0; BLOCK], [0.0; BLOCK]);
        for (k, ((p, nodes), g)) in blocks.enumerate() {
            let first = first + k * BLOCK;
            let [load, is_in] = [&mut load, &mut is_in].map(|x| &mut x[..p.len()]);
            if let Some(excess) = self.excess {
                for g in g.iter_mut() {
                    *g -= excess as f32;
                }
            } else {
                let ([u, h], level) = (self.fields.map(|x| &x[first..]), T::of(self.level));
                let fields = g.iter_mut().zip(u).zip(h);
                fields.for_each(|((g, u), h)| *g = (*u - *h - level).narrow());
            }
            load.iter_mut().zip(p).for_each(|(load, p)| *load = p.narrow());
            for ((is_in, load), g) in is_in.iter_mut().zip(&*load).zip(&*g) {
                let open = if *g > 0.0 { *g } else { 0.0 };
                *is_in = if (*load > release * open) | (*g < 0.0) { 1.0 } else { 0.0 };
            }
            nodes.iter_mut().zip(&*is_in).for_each(|(m, is_in)| *m = NodeState::of(*is_in > 0.0));
            let top = self.ceiling.top();
            if C::IS_FINITE {
                for ((m, p), g) in nodes.iter_mut().zip(p).zip(&*g) {
                    let room = top - *p;
                    let yields = room <= T::of(self.release * f64::from((-g).max(0.0)));
                    *m = m.or(NodeState::Full, yields & (*g <= 0.0));
                }
                is_in.iter_mut().zip(&*nodes).for_each(|(is_in, m)| *is_in = m.value());
            }
            for (g, is_in) in g.iter_mut().zip(&*is_in) {
                *g = if *is_in > 0.0 { *g } else { 0.0 };
            }
            for ((m, load), is_in) in nodes.iter_mut().zip(&*load).zip(&*is_in) {
                let is_off = (*load > 0.0) & (*is_in <= 0.0) & !(C::IS_FINITE && m.is_full());
                *m = m.or(NodeState::Released, is_off);
            }
            active += nodes.iter().map(|m| u32::from(m.is_in())).sum::<u32>();
            released += nodes.iter().map(|m| u32::from(*m == NodeState::Released)).sum::<u32>();
            if C::IS_FINITE {
                for (m, p) in nodes.iter_mut().zip(p) {
                    let is_filled = m.is_full() & ((*p < top) | (*p > top));
                    *m = m.or(NodeState::Filled, is_filled);
                    released += u32::from(is_filled);
                }
            }
        }
        [f64::from(active), f64::from(released), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    }
}
