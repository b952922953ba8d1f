//! Steps without a pair, with a cheap stand-in for `K`: before the first pair, and later where one step would not do.

use super::memory::Known;
use super::pairs::Lead;
use super::run::Run;
use crate::Real;
use crate::methods::ceiling::Ceiling;
use crate::methods::cheap_compliance::CheapCompliance;
use crate::methods::passes::{self, ContactSet};
use crate::row_work::total;

impl<T: Real, C: Ceiling<T>> Run<'_, T, C> {
    /// Makes the trial the lead: its displacement is that of the base, which is known, and what
    /// [`CheapCompliance`] makes of the difference. Its level is known then, and how far along the chord to it the
    /// energy falls; the step before is forgotten. Call it after [`make_trial`](Self::make_trial). False, and
    /// nothing done, on a grid that is too small for it.
    pub(super) fn guess(&mut self, set: ContactSet, level: f64) -> bool {
        let (stiffness, grid) = (&self.work.stiffness, self.work.grid);
        let new = || CheapCompliance::new(stiffness, grid.pixel());
        let known = self.work.cheap.take();
        let Some(cheap) = known.or_else(new) else { return false };
        self.sweep_trial(set, 1.0);
        let factor = self.end_trial(level).unwrap_or(1.0);
        let has_load = self.control.is_none();
        let work = &mut *self.work;
        work.pairs.change(factor, self.iterate, &mut work.residual);
        let Lead { pressure, base, displacement, spare } = work.pairs.lead(self.iterate);
        let (rows, h) = (work.rows, self.heights);
        let (change, used) = (&work.residual, h.len().div_ceil(rows * work.columns));
        let partial = &mut work.partial[..used];
        let sums = |first: usize, u: &[T], response: f64| {
            let [p, h] = [pressure, h].map(|x| &x[first..][..u.len()]);
            let change = &change[first..][..u.len()];
            let [rise, contact, along] = passes::guess_sums(p, u, h, change);
            [rise, contact, along, response, 0.0, 0.0, 0.0, 0.0]
        };
        let stiffness = &mut work.stiffness;
        cheap.add(change, stiffness, spare, base, displacement, rows, sums, partial);
        self.memory.known = Known::Level(passes::level_of_sums(partial));
        // <g,s> = <u - K s - h, s>, since s carries no load.
        let [_, _, along, response] = total(partial);
        if has_load && response > 0.0 {
            self.memory.adapt_length(1.0 - along / response);
        }
        self.memory.has_before = false;
        work.cheap = Some(cheap);
        self.transforms += work.stiffness.cost; // a transform on the same coarse grid
        true
    }
}
