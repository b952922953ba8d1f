//! The parts of a chord iteration, in the order in which the loop calls them.

use super::memory::{Kind, Known, Memory};
use super::work::{Chord, room};
use crate::methods::compliance::Compliance;
use crate::methods::contract::State;
use crate::methods::level_control::LevelControl;
use crate::methods::passes::{self, Estimate, Gap, Products};
use crate::methods::sweep;
use crate::row_work::{Partial, RowWork, total};
use crate::{HalfSpace, Real, fields, projection};
use grid_fft::parallel::prelude::*;
use std::f64::consts::FRAC_PI_2;

/// Below this chord length the step was a poor guess: take it as it is, and release nodes.
pub(super) const FULL: f64 = 0.7;
/// Range of the length of the preconditioned step.
const TAU: [f64; 2] = [0.3, 1.0];

impl<T: Real> Chord<T> {
    /// The residual gap g of the state, or of the lead, its contact set F, and `E g`. Returns the
    /// level, the mean of `u - h` in contact, as well; `known` says what is known of it.
    pub(crate) fn look(
        &mut self,
        h: &[T],
        known: Known,
        release: f64,
        is_lead: bool,
        state: &State<T>,
    ) -> (f64, passes::Residual) {
        let (p, u) = if is_lead {
            (&self.trial[..], &self.response[..])
        } else {
            (&state.pressure[..], &state.displacement[..])
        };
        let level = known.level.unwrap_or_else(|| passes::level(p, u, h, &mut self.partial));
        let excess = known.gap_from.map(|from| level - from);
        (level, self.contact_set(h, level, excess, release, is_lead, false, state))
    }

    /// Looks again, a step ahead: `E g` is what the step will take from the gap, in contact and
    /// beside it. A node with a smaller gap would overlap after the step and belongs to F now. Call
    /// it after [`look`](Self::look) with the same arguments.
    pub(super) fn look_ahead(
        &mut self,
        h: &[T],
        level: f64,
        release: f64,
        is_lead: bool,
        state: &State<T>,
    ) -> passes::Residual {
        self.contact_set(h, level, None, release, is_lead, true, state)
    }

    /// F, the residual on it and `E g`; with `is_ahead`, F grows by what the last `E g` closes. With
    /// `excess`, the residual field holds the gap but for that.
    #[allow(clippy::too_many_arguments, reason = "what is known differs between its callers")]
    fn contact_set(
        &mut self,
        h: &[T],
        level: f64,
        excess: Option<f64>,
        release: f64,
        is_lead: bool,
        is_ahead: bool,
        state: &State<T>,
    ) -> passes::Residual {
        let size = [self.rows, self.shape[1]];
        let (p, u, extended) = if is_lead {
            let extended = room(&mut [], &mut self.before_response, true);
            (&self.trial[..], &self.response[..], extended)
        } else {
            let extended = room(&mut self.response, &mut [], false);
            (&state.pressure[..], &state.displacement[..], extended)
        };
        let gap = match excess {
            Some(excess) => Gap::Known { excess },
            None => Gap::Of { u, h, level },
        };
        let found = passes::residual(
            p,
            gap,
            release,
            is_ahead.then_some(&*extended),
            size,
            &mut self.nodes,
            &mut self.residual,
            &mut self.pyramid,
            &mut self.partial,
        );
        self.pyramid.extend_above();
        let extended = room(&mut self.response, &mut self.before_response, is_lead);
        let (pyramid, stiffness) = (&self.pyramid, &mut self.stiffness);
        passes::push(&self.nodes, &self.residual, pyramid, size[1], stiffness, extended);
        found
    }

    /// Scales everything to a load that should bring the level to its target; returns the factor.
    /// `level` is where it is now, and `E g` says where it will settle.
    pub(super) fn towards_level(
        &mut self,
        control: &mut LevelControl,
        level: f64,
        load: f64,
        residual: f64,
        is_lead: bool,
        state: &mut State<T>,
    ) -> f64 {
        let (p, u) = (&mut state.pressure, &mut state.displacement);
        if control.wants_guess(residual) {
            if is_lead {
                control.guess(&self.trial, &self.response);
            } else {
                control.guess(p, u);
            }
        }
        let extended = room(&mut self.response, &mut self.before_response, is_lead);
        let rise = fields::sum(extended) / extended.len() as f64;
        let factor = control.factor(level + rise, load, residual);
        passes::scale(factor, p);
        passes::scale(factor, u);
        if is_lead {
            passes::scale(factor, &mut self.trial);
            passes::scale(factor, &mut self.response);
        } else {
            // The step before must stay one that changes no load.
            passes::scale(factor, &mut self.before);
            passes::scale(factor, &mut self.before_response);
        }
        factor
    }

    /// `y = S E r`, in place of the residual, and all of `z = E^T y` but the last step down to the
    /// finest grid, which [`make_trial`](Self::make_trial) does.
    pub(crate) fn precondition(&mut self, is_lead: bool) {
        let extended = room(&mut self.response, &mut self.before_response, is_lead);
        self.stiffness.apply_to_filled(extended, &mut self.residual);
        passes::gather(&self.nodes, &self.residual, &mut self.pyramid);
        self.pyramid.restrict_above();
    }

    /// `trial = p - tau z` on F, `p` elsewhere, where p is the state, or the lead, which moves to
    /// `before`. Where `E g` was, the smallest of it below each cell is left for
    /// [`sweep_trial`](Self::sweep_trial).
    pub(crate) fn make_trial(
        &mut self,
        is_lead: bool,
        tau: f64,
        found: &passes::Residual,
        state: &State<T>,
    ) -> Estimate {
        if is_lead {
            std::mem::swap(&mut self.trial, &mut self.before);
        }
        let smallest = room(&mut self.response, &mut self.before_response, is_lead);
        passes::trial(
            if is_lead { &self.before } else { &state.pressure },
            &self.residual,
            tau,
            &self.nodes,
            found.active,
            [self.rows, self.shape[1]],
            &self.pyramid,
            &mut self.trial,
            smallest,
            &mut self.sweep,
            &mut self.partial,
        )
    }

    /// The estimate, unless even the softest wave of the grid would resist the residual gap more: then
    /// the preconditioner is at fault, and the stiffest wave bounds the error instead.
    pub(super) fn credible(&mut self, estimate: &Estimate, fields: [&[T]; 2], level: f64) -> f64 {
        let gap2 = passes::residual_norm2(fields, level, &self.nodes, &mut self.partial);
        let stiffest = FRAC_PI_2 * (gap2 / estimate.p2).sqrt(); // |q|/2 at pi per finer pixel
        let softest = 2.0 / self.longest * stiffest;
        if estimate.residual < 0.01 * softest { stiffest } else { estimate.residual }
    }

    /// Sweeps the trial that was just made. What it then carries is what [`end_trial`](passes::end_trial) makes of it.
    ///
    /// The tension that is left is clipped, and the load that takes spread over the whole map. That is
    /// an error of the softest wave, and must be small beside the present error, `residual`. The
    /// softest wave of a slender map is as much softer than that of a square.
    pub(crate) fn sweep_trial(
        &mut self,
        found: &passes::Residual,
        load: f64,
        residual: f64,
        is_lead: bool,
    ) {
        let total = load * self.trial.len() as f64;
        let smallest = room(&mut self.response, &mut self.before_response, is_lead);
        self.sweep.run(
            &mut self.pyramid,
            &self.trial,
            &mut self.nodes,
            smallest,
            found.active,
            found.has_released,
            sweep::NEGLIGIBLE * total * residual.min(1.0) / self.slenderness,
        );
    }

    /// Clips the swept trial. Returns the factor that gives it the load; `None` if nothing is left.
    pub(crate) fn end_trial(&mut self, load: f64) -> Option<f64> {
        let nx = self.shape[1];
        let size = self.rows * nx;
        let (sweep, pyramid) = (&self.sweep, &self.pyramid);
        let pieces = self.trial.par_chunks_mut(size).zip(self.nodes.par_chunks(size));
        pieces.zip(self.partial.par_iter_mut()).enumerate().for_each(
            |(k, ((q, nodes), partial))| {
                *partial = passes::end_trial(k * self.rows, nodes, sweep, pyramid, nx, q);
            },
        );
        let [sum] = total(&self.partial[..self.trial.len().div_ceil(size)]);
        self.give_load(sum, load)
    }

    /// The factor that gives the clipped trial the load, if `sum` is what it carries.
    fn give_load(&mut self, sum: f64, load: f64) -> Option<f64> {
        let total = load * self.trial.len() as f64;
        if sum <= 0.0 || !sum.is_finite() {
            return None;
        }
        if is_rough(sum, total) {
            projection::onto_admissible(&mut self.trial, load);
            return Some(1.0);
        }
        Some(total / sum)
    }

    /// `trial = p - alpha g`, projected on the pressures that are positive and carry the load.
    pub(super) fn gradient_trial(
        &mut self,
        h: &[T],
        level: f64,
        alpha: f64,
        load: f64,
        state: &State<T>,
    ) {
        let (p, u) = (&state.pressure, &state.displacement);
        for (i, t) in self.trial.iter_mut().enumerate() {
            *t = p[i] - T::of(alpha) * (u[i] - h[i] - T::of(level));
        }
        projection::onto_admissible(&mut self.trial, load);
    }

    /// Gives the trial the load and computes `K trial`, the one pair. Returns the inner products
    /// along the chord to it; `None` if nothing is left of the trial. `levels` are that of the state
    /// and the one from which the gap of the trial is to be counted.
    #[allow(clippy::too_many_arguments, reason = "the operator and what belongs to one step")]
    pub(super) fn respond(
        &mut self,
        operator: &mut dyn Compliance<T>,
        trial: Trial,
        load: f64,
        h: &[T],
        levels: [f64; 2],
        now: &Memory,
        state: &State<T>,
    ) -> Option<Products> {
        let nx = self.shape[1];
        let wanted = load * self.trial.len() as f64;
        let (nodes, sweep, pyramid) = (&self.nodes, &self.sweep, &self.pyramid);
        let prepare = |first: usize, q: &mut [T]| match trial {
            Trial::Ended(_) => Partial::default(),
            Trial::Swept => {
                let nodes = &nodes[first..][..q.len()];
                passes::end_trial(first / nx, nodes, sweep, pyramid, nx, q)
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
        let (p, u) = (&state.pressure[..], &state.displacement[..]);
        let before = if now.has_before { &self.before[..] } else { p }; // without one, d = 0
        let finish = |first: usize, scale: T, qv: [&mut [T]; 2], gap: &mut [f32]| {
            let [p, u, h, b] = [p, u, h, before].map(|x| &x[first..][..gap.len()]);
            passes::inner_products([p, u, h], levels, qv, scale, b, gap)
        };
        let work = RowWork {
            prepare: &prepare,
            factor: &mut factor,
            finish: &finish,
            pixels: HalfSpace::<T>::BLOCK_ROWS * nx,
        };
        let (q, v, gap) = (&mut self.trial, &mut self.response, &mut self.residual);
        if let Some(sums) = operator.apply_around(q, v, gap, work, &mut self.partial) {
            return Some(Products::new(sums, if now.has_before { now.dkd } else { 0.0 }));
        }
        let scale = self.give_load(sum, load)?;
        self.respond(operator, Trial::Ended(scale), load, h, levels, now, state)
    }

    /// Goes along the chord, or to the minimum over the chord and the step before. `from` is the level
    /// from which the gap of the trial is counted.
    pub(super) fn advance(
        &mut self,
        kind: Kind,
        k: &Products,
        from: f64,
        now: &mut Memory,
        h: &[T],
        state: &mut State<T>,
    ) {
        let theta = k.theta();
        if kind == Kind::Chord {
            now.a = if theta < FULL { theta } else { 1.0 };
            if theta > 1.0 && !k.has_dropped {
                now.a = theta
                    .min(passes::reach(&state.pressure, &self.trial, &mut self.partial).max(1.0));
            }
            now.tau = (now.tau * theta.clamp(0.7, 1.4)).clamp(TAU[0], TAU[1]);
        } else {
            now.a = theta.clamp(0.0, 1.0);
            if k.sks > 0.0 {
                now.alpha = k.ss / k.sks; // Barzilai & Borwein (1988), doi:10.1093/imanum/8.1.141
            }
        }
        // A node that the trial drops would keep a part of its load: then only the chord will do.
        let is_searchable = now.has_before && kind == Kind::Chord && !k.has_dropped;
        let plane = k.plane_minimum().filter(|_| is_searchable);
        let step = plane.and_then(|b| Some((b, self.combine(b, true, h, state)?)));
        let b = if let Some((b, level)) = step {
            now.a = 1.0;
            now.known = Known { level: Some(level), gap_from: None };
            b
        } else if (now.a - 1.0).abs() < f64::EPSILON {
            std::mem::swap(&mut self.before, &mut self.trial);
            std::mem::swap(&mut self.before_response, &mut self.response);
            now.known = Known { level: Some(k.level), gap_from: Some(from) };
            [1.0, 0.0]
        } else {
            let b = [now.a, 0.0];
            now.known = Known { level: self.combine(b, false, h, state), gap_from: None };
            b
        };
        // `before` holds the new iterate: exchange it with the old one.
        std::mem::swap(&mut state.pressure, &mut self.before);
        std::mem::swap(&mut state.displacement, &mut self.before_response);
        now.has_before = true;
        now.dkd = k.curvature(b);
    }

    /// `before = p + b1 s + b2 d`, see [`passes::combine`].
    pub(super) fn combine(
        &mut self,
        b: [f64; 2],
        must_fit: bool,
        h: &[T],
        state: &State<T>,
    ) -> Option<f64> {
        passes::combine(
            [&state.pressure, &state.displacement],
            [&self.trial, &self.response],
            b,
            must_fit,
            h,
            [&mut self.before, &mut self.before_response],
            &mut self.partial,
        )
    }
}

/// How far a trial is made.
#[derive(Debug, Clone, Copy)]
pub(super) enum Trial {
    /// Swept, and what was swept is still to be added.
    Swept,
    /// Nowhere negative; this many times it carries the load.
    Ended(f64),
}

/// Whether much was clipped, if `sum` is left of a trial that should carry `total`: the contact is
/// far from settled, and small loads do not belong.
fn is_rough(sum: f64, total: f64) -> bool {
    sum > (1.0 + 2.0 * sweep::NEGLIGIBLE) * total
}
