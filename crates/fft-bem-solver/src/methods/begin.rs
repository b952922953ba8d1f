//! What the two baselines begin with: a state that carries the load, and its gap.

use super::compliance::Compliance;
use super::contract::{Start, State};
use super::passes;
use crate::{Boundary, Real, fields};

/// Brings the state to the load; returns the pairs spent.
pub(super) fn begin<T: Real>(
    load: f64,
    operator: &mut dyn Compliance<T>,
    start: Start,
    state: &mut State<T>,
) -> f64 {
    let n = state.pressure.len() as f64;
    let present = fields::sum(&state.pressure) / n;
    if start == Start::Warm && present > 0.0 {
        passes::scale(load / present, &mut state.pressure);
        passes::scale(load / present, &mut state.displacement);
        return 0.0;
    }
    passes::fill(load, &mut state.pressure);
    if operator.boundary() == Boundary::Periodic {
        passes::fill(0.0, &mut state.displacement); // K of a constant
        return 0.0;
    }
    operator.apply(&state.pressure, &mut state.displacement);
    1.0
}

/// `gap = displacement - heights`, less its plain mean over the contact.
pub(super) fn mean_gap_in_contact_to_zero<T: Real>(state: &State<T>, heights: &[T], gap: &mut [T]) {
    let (p, u) = (&state.pressure, &state.displacement);
    let on = |i: usize| p[i] > T::zero();
    let total = fields::sum_of(p.len(), |i| if on(i) { (u[i] - heights[i]).wide() } else { 0.0 });
    let level = T::of(total / fields::contact_count(p).max(1) as f64);
    fields::write(gap, |i, _| u[i] - heights[i] - level);
}
