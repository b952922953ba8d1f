//! What the two baselines have in common: fields, start, stopping rule.

use super::ceiling::NoCeiling;
use super::compliance::Compliance;
use super::contract::{
    ContactMethod, ContactTask, IterateView, Means, Outcome, Start, State, Target,
};
use crate::certificate::{self, Patience};
use crate::{End, Real, fields};
use std::marker::PhantomData;

/// The iteration of one baseline, with what it remembers from step to step.
pub(super) trait BaselineStep<T>: Send + Sync {
    const START: Self;

    /// Steps to the next iterate of this `load`. `gap` has no mean over the contact; `direction` is kept
    /// from step to step, zero at first; `response` is scratch. Returns the convolutions spent; `None` after one if
    /// nothing but rounding is left.
    fn step(
        &mut self,
        load: f64,
        state: &mut State<T>,
        gap: &[T],
        direction: &mut [T],
        response: &mut [T],
        operator: &mut dyn Compliance<T>,
    ) -> Option<f64>;
}

pub(crate) struct Baseline<T, S> {
    gap: Vec<T>,
    direction: Vec<T>,
    response: Vec<T>,
    step: PhantomData<S>,
}

impl<T: Real, S: BaselineStep<T>> Baseline<T, S> {
    pub(crate) fn new(n: usize) -> Self {
        let zeros = || vec![T::zero(); n];
        Self { gap: zeros(), direction: zeros(), response: zeros(), step: PhantomData }
    }
}

impl<T: Real, S: BaselineStep<T>> ContactMethod<T> for Baseline<T, S> {
    fn solve(&mut self, task: &ContactTask<'_, T>, means: Means<'_, '_, T>) -> Outcome {
        let Means { operator, state, watch } = means;
        let Target::Pressure(load) = task.target else {
            unreachable!("a level is controlled from outside: controls_level() is false")
        };
        let heights = &task.problem.heights;
        let Self { gap, direction, response, .. } = self;
        fields::fill(0.0, direction);
        let mut transforms = begin(load, operator, task.start, state);
        let (mut iterations, mut residual) = (0, f64::INFINITY);
        let (mut method, mut patience) = (S::START, Patience::new(task.tolerance));
        let mut end = loop {
            gap_without_mean(state, heights, gap);
            let (end, found, spent) = patience.judge(state, heights, gap, response, operator);
            transforms += spent;
            residual = found.unwrap_or(residual);
            if watch(&IterateView { iteration: iterations, transforms, residual, state }).is_break()
            {
                break End::Stopped;
            }
            if let Some(end) = end {
                break end;
            }
            if iterations >= task.max_iterations {
                break End::Exhausted;
            }
            iterations += 1;
            let spent = method.step(load, state, gap, direction, response, operator);
            transforms += spent.unwrap_or(1.0);
            if spent.is_none() {
                break End::Exhausted;
            }
        };
        if end == End::Exhausted && residual.is_infinite() {
            let bound = certificate::energy_error(NoCeiling, state, |i| gap[i], response, operator);
            transforms += bound.map_or(0.0, |_| 1.0);
            residual = certificate::CAUTION * bound.unwrap_or(f64::INFINITY);
        }
        if end == End::Exhausted && residual <= task.tolerance {
            end = End::Converged;
        }
        state.level = certificate::level(state, heights, f64::INFINITY);
        Outcome { end, iterations, transforms, residual, ..Outcome::NOTHING }
    }
}

/// Brings the state to the load; returns the convolutions spent.
fn begin<T: Real>(
    load: f64,
    operator: &mut dyn Compliance<T>,
    start: Start,
    state: &mut State<T>,
) -> f64 {
    let present = fields::mean(&state.pressure);
    if start == Start::Warm && present > 0.0 {
        state.scale(load / present);
        return 0.0;
    }
    state.fill(load, operator)
}

/// `gap = displacement - heights`, less its plain mean over the contact.
fn gap_without_mean<T: Real>(state: &State<T>, heights: &[T], gap: &mut [T]) {
    let (p, u) = (&state.pressure, &state.displacement);
    let on = |i: usize| p[i] > T::zero();
    let total = fields::sum_of(p.len(), |i| if on(i) { (u[i] - heights[i]).wide() } else { 0.0 });
    let level = T::of(total / fields::contact_count(p).max(1) as f64);
    fields::write(gap, |i, _| u[i] - heights[i] - level);
}
