//! Steps 4 and 5: the one convolution, and how far to go along the chord.

use super::memory::{Known, StepKind};
use super::run::Run;
use super::trial::is_rough;
use crate::methods::ceiling::Ceiling;
use crate::methods::passes::{self, Products};
use crate::row_work::{Partial, RowWork, total};
use crate::{HalfSpace, Real};

/// Below this chord length the step was a poor guess: take it as it is, and release nodes.
pub(super) const FULL: f64 = 0.7;

/// How far a trial is made.
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
        let nx = work.columns;
        let (nodes, sweep, pyramid) = (&work.nodes, &work.sweep, &work.pyramid);
        let prepare = |first: usize, q: &mut [T]| match trial {
            Trial::Ended(_) => Partial::default(),
            Trial::Swept => {
                let nodes = &nodes[first..][..q.len()];
                passes::end_trial(ceiling, first / nx, nodes, sweep, pyramid, nx, q)
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
            passes::inner_products(ceiling, [p, u, h], level, qv, scale, b, gap)
        };
        let around = RowWork {
            prepare: &prepare,
            factor: &mut factor,
            finish: &finish,
            pixels: HalfSpace::<T>::BLOCK_ROWS * nx,
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
        let now = &mut self.memory;
        if kind == StepKind::Chord {
            now.length = if theta < FULL { theta } else { 1.0 };
            if theta > 1.0 && !k.has_dropped {
                let (p, trial) = (&self.iterate.pressure, &self.work.pairs.trial.pressure);
                let reach = passes::reach(self.ceiling, p, trial, &mut self.work.partial);
                now.length = theta.min(reach.max(1.0));
            }
            now.adapt_length(theta);
        } else {
            now.length = theta.clamp(0.0, 1.0);
            if k.sks > 0.0 {
                now.alpha = k.ss / k.sks; // Barzilai & Borwein (1988), doi:10.1093/imanum/8.1.141
            }
        }
        // A node that the trial drops would keep a part of its load: then only the chord will do.
        let is_searchable = now.has_before && kind == StepKind::Chord && !k.has_dropped;
        let length = now.length;
        let plane = k.plane_minimum().filter(|_| is_searchable);
        let step = plane.and_then(|b| Some((b, self.combine(b)?)));
        let b = if let Some((b, level)) = step {
            self.memory.length = 1.0;
            self.memory.known = Known::Level(level);
            self.work.pairs.take_combined(self.iterate);
            b
        } else {
            let is_whole = (length - 1.0).abs() < f64::EPSILON;
            self.memory.known = if is_whole {
                Known::Gap { level: k.level, counted_from }
            } else {
                Known::Level(self.shorten(length))
            };
            self.work.pairs.take_trial(self.iterate);
            [length, 0.0]
        };
        self.memory.is_first = false;
        self.memory.has_before = self.work.pairs.has_room();
        self.memory.dkd = k.curvature(b);
    }

    /// `before = p + b1 s + b2 d`, see [`passes::combine`].
    fn combine(&mut self, b: [f64; 2]) -> Option<f64> {
        let work = &mut *self.work;
        let pairs = &mut work.pairs;
        passes::combine(
            self.ceiling,
            [&self.iterate.pressure, &self.iterate.displacement],
            [&pairs.trial.pressure, &pairs.trial.displacement],
            b,
            self.heights,
            [&mut pairs.before.pressure, &mut pairs.before.displacement],
            &mut work.partial,
        )
    }

    /// `trial = p + length s`, see [`passes::shorten`].
    fn shorten(&mut self, length: f64) -> f64 {
        let work = &mut *self.work;
        let trial = &mut work.pairs.trial;
        passes::shorten(
            self.ceiling,
            [&self.iterate.pressure, &self.iterate.displacement],
            length,
            self.heights,
            [&mut trial.pressure, &mut trial.displacement],
            &mut work.partial,
        )
    }
}
