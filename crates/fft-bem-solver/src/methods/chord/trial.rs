//! Steps 2 and 3: the preconditioned residual, the trial it leads to, and the sweep that frees that of
//! tension.

use super::run::{Run, project};
use crate::methods::ceiling::Ceiling;
use crate::methods::passes::{self, ContactSet, StepEstimate};
use crate::methods::sweep;
use crate::row_work::total;
use crate::{Real, fields, projection};
use grid_fft::parallel::prelude::*;

/// Pressure per gap of a node that joins the contact because the others cannot carry more, per finer
/// pixel and `E*`: about that of a single node.
const STIFFNESS: f64 = 1.0;

impl<T: Real, C: Ceiling<T>> Run<'_, T, C> {
    /// `y = S E g`, in place of the residual, and all of `z = E^T y` but the last step down to the
    /// finest grid, which [`make_trial`](Self::make_trial) does.
    pub(crate) fn precondition(&mut self) {
        let work = &mut *self.work;
        let extended = work.pairs.spare();
        work.stiffness.apply_to_filled(extended, &mut work.residual);
        passes::gather(&work.nodes, &work.residual, &mut work.pyramid);
        work.pyramid.restrict_above();
        self.transforms += work.stiffness.cost;
    }

    /// `trial = p - tau z` on F, `p` elsewhere, where p is the pressure of the iterate. Where `E g` was, the
    /// smallest of it below each cell is left for [`sweep_trial`](Self::sweep_trial).
    pub(crate) fn make_trial(&mut self, tau: f64, set: ContactSet) -> StepEstimate {
        let work = &mut *self.work;
        let size = [work.rows, work.columns];
        let (trial, smallest) = work.pairs.trial_and_spare();
        passes::trial(
            self.ceiling,
            &self.iterate.pressure,
            &work.residual,
            tau,
            &work.nodes,
            set.size,
            size,
            &work.pyramid,
            trial,
            smallest,
            &mut work.sweep,
            &mut work.partial,
        )
    }

    /// Sweeps the trial that was just made. What it then carries is what
    /// [`end_trial`](passes::end_trial) makes of it.
    ///
    /// The tension that is left is clipped, and the load that takes spread over the whole map. That is
    /// an error of the softest wave, and must be small beside the present error, `residual`, at most 1. The
    /// softest wave of a slender map is as much softer than that of a square.
    pub(crate) fn sweep_trial(&mut self, set: ContactSet, residual: f64) {
        let (total, work) = (self.total(), &mut *self.work);
        let negligible = sweep::NEGLIGIBLE * total * residual / work.slenderness;
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
        let (rows, nx) = (work.rows, work.columns);
        let (size, trial) = (rows * nx, &mut work.pairs.trial.pressure);
        let (sweep, pyramid) = (&work.sweep, &work.pyramid);
        let pieces = trial.par_chunks_mut(size).zip(work.nodes.par_chunks(size));
        pieces.zip(work.partial.par_iter_mut()).enumerate().for_each(
            |(k, ((q, nodes), partial))| {
                *partial = passes::end_trial(ceiling, k * rows, nodes, sweep, pyramid, nx, q);
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
        let (load, total, ceiling) = (self.load, self.total(), self.ceiling);
        let heights = self.heights;
        let (trial, u) = (&mut self.work.pairs.trial.pressure, &self.iterate.displacement);
        if projection::scale_below(trial, total, ceiling, sweep::ROUGH) {
            return;
        }
        let (stiffness, level) = (T::of(STIFFNESS), T::of(level));
        fields::write(trial, |i, p| {
            let step = stiffness * (u[i] - heights[i] - level);
            match (p > T::zero(), p < ceiling.at(i)) {
                (true, true) => p,
                (false, _) => T::zero() - step.larger(T::zero()),
                (_, false) => p + (T::zero() - step).larger(T::zero()),
            }
        });
        projection::between(trial, load, ceiling);
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
