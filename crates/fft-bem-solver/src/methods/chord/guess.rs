//! Steps before the first pair, with a cheap stand-in for `K`: a tenth of a pair each.

use super::run::Run;
use crate::Real;
use crate::methods::ceiling::Ceiling;
use crate::methods::cheap_compliance::CheapCompliance;
use crate::methods::passes::ContactSet;
use crate::parts::part;

impl<T: Real, C: Ceiling<T>> Run<'_, T, C> {
    /// Makes the trial the lead: its displacement is that of the base, which is known, and what
    /// [`CheapCompliance`] makes of the difference. Call it after [`make_trial`](Self::make_trial). False,
    /// and nothing done, on a grid that is too small for it.
    pub(super) fn guess(&mut self, set: ContactSet, level: f64) -> bool {
        let (stiffness, grid) = (&self.work.stiffness, self.work.grid);
        let new = || CheapCompliance::new(stiffness, grid.pixel());
        let known = self.work.cheap.take();
        let Some(cheap) = known.or_else(|| part("planning of K~", new)) else { return false };
        part("sweep", || self.sweep_trial(set, 1.0));
        let factor = part("end", || self.end_trial(level)).unwrap_or(1.0);
        let work = &mut *self.work;
        part("K~", || {
            work.pairs.change(factor, self.iterate, &mut work.residual);
            let (base, displacement, spare) = work.pairs.lead(self.iterate);
            cheap.add(&work.residual, &mut work.stiffness, spare, base, displacement);
        });
        work.cheap = Some(cheap);
        self.transforms += work.stiffness.cost; // a transform on the same coarse grid
        true
    }
}
