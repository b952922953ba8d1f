//! Steps before the first pair, with a cheap stand-in for `K`: a tenth of a pair each.

use super::work::{Chord, room};
use crate::Real;
use crate::methods::cheap_compliance::CheapCompliance;
use crate::methods::contract::State;
use crate::methods::passes;

impl<T: Real> Chord<T> {
    /// Makes the trial the lead: its displacement is that of the state, or of the lead before, which is
    /// known, and what [`CheapCompliance`] makes of the difference. Call it after
    /// [`make_trial`](Self::make_trial). Returns what it cost in pairs; `None`, and nothing done, on a
    /// grid that is too small for it.
    pub(super) fn guess(
        &mut self,
        load: f64,
        found: &passes::Residual,
        is_lead: bool,
        state: &State<T>,
    ) -> Option<f64> {
        let new = || CheapCompliance::new(&self.stiffness, self.grid.pixel());
        let cheap = self.cheap.take().or_else(new)?;
        self.sweep_trial(found, load, 1.0, is_lead);
        let factor = self.end_trial(load).unwrap_or(1.0);
        let p = if is_lead { &self.before } else { &state.pressure };
        passes::difference(factor, p, &mut self.trial, &mut self.residual);
        if !is_lead {
            passes::copy(&state.displacement, &mut self.response);
        }
        let room = room(&mut [], &mut self.before_response, true);
        cheap.add(&self.residual, &mut self.stiffness, room, &mut self.response);
        self.cheap = Some(cheap);
        Some(self.stiffness.cost) // a transform on the same coarse grid
    }
}
