//! Constrained conjugate gradients of Polonsky & Keer.
//!
//! # Source
//! Polonsky & Keer (1999), *Wear* 231, 206–219, doi:10.1016/S0043-1648(99)00113-1, section 3.

use super::begin::{begin, mean_gap_in_contact_to_zero};
use super::ceiling::{Elastic, Top};
use super::compliance::Compliance;
use super::contract::{ContactMethod, Outcome, Start, State, Step, Target, Task, Watch};
use super::passes;
use crate::certificate::{self, Patience};
use crate::{End, Fallbacks, Real, fields};
use std::sync::atomic::{AtomicBool, Ordering};

/// The method and its fields: gap, direction, and what a transform gives back.
pub(crate) struct PolonskyKeer<T> {
    gap: Vec<T>,
    direction: Vec<T>,
    response: Vec<T>,
}

impl<T: Real> PolonskyKeer<T> {
    pub(crate) fn new(n: usize) -> Self {
        let zeros = || vec![T::zero(); n];
        Self { gap: zeros(), direction: zeros(), response: zeros() }
    }
}

impl<T: Real> ContactMethod<T> for PolonskyKeer<T> {
    fn solve(
        &mut self,
        task: &Task<'_, T>,
        operator: &mut dyn Compliance<T>,
        start: Start,
        state: &mut State<T>,
        watch: &mut Watch<'_, T>,
    ) -> Outcome {
        let Target::Pressure(load) = task.target else {
            unreachable!("a level is controlled from outside: controls_level() is false")
        };
        let heights = &task.problem.heights;
        let n = heights.len();
        let mut transforms = begin(load, operator, start, state);
        let (gap, t, r) = (&mut self.gap, &mut self.direction, &mut self.response);
        passes::fill(0.0, t);
        let mut conjugate = false; // delta of the paper
        let mut last_norm = 1.0; // G_old
        let mut length = 1.0; // tau, pressure per gap
        let mut patience = Patience::new(task.tolerance);
        let mut iterations = 0;
        let mut residual = f64::INFINITY;
        let mut end = loop {
            // Gap, counted so that its mean over the contact is zero (eqs. 8, 9).
            mean_gap_in_contact_to_zero(state, heights, gap);
            let check = patience.judge(state, heights, gap, r, operator);
            transforms += check.transforms;
            residual = check.residual.unwrap_or(residual);
            let step = Step { iteration: iterations, transforms, residual, state };
            if watch(&step).is_break() {
                break End::Stopped;
            }
            if let Some(end) = check.end {
                break end;
            }
            if iterations >= task.max_iterations {
                break End::Exhausted;
            }
            iterations += 1;

            // Conjugate direction on the contact (eqs. 10, 11).
            let p = &state.pressure;
            let on = |i: usize| p[i] > T::zero();
            let norm = fields::sum_of(n, |i| if on(i) { gap[i].wide().powi(2) } else { 0.0 });
            let beta = T::of(if conjugate { norm / last_norm } else { 0.0 });
            last_norm = norm;
            fields::write(t, |i, t| if on(i) { gap[i] + beta * t } else { T::zero() });
            // Its response, and the length of the step (eqs. 12-14).
            operator.apply(t, r);
            transforms += 1.0;
            let contact = fields::contact_count(p) as f64;
            let mean = fields::sum_of(n, |i| if on(i) { r[i].wide() } else { 0.0 }) / contact;
            let descent =
                fields::sum_of(n, |i| if on(i) { gap[i].wide() * t[i].wide() } else { 0.0 });
            let curvature =
                fields::sum_of(n, |i| if on(i) { (r[i].wide() - mean) * t[i].wide() } else { 0.0 });
            let overlaps = |i: usize| p[i] <= T::zero() && gap[i] < T::zero();
            if curvature > 0.0 {
                length = descent / curvature;
            } else if fields::sum_of(n, |i| if overlaps(i) { 1.0 } else { 0.0 }) < 1.0 {
                break End::Exhausted; // nothing left but rounding
            } // else the contact is at rest, and the last length takes in what overlaps
            let tau = T::of(length);

            // Step, truncate, and take in the pixels that overlap (eqs. 15-17).
            let (truncated, taken_in) = (AtomicBool::new(false), AtomicBool::new(false));
            fields::write(&mut state.pressure, |i, p| {
                let trial = p - tau * t[i];
                if trial < T::zero() {
                    truncated.store(true, Ordering::Relaxed);
                }
                let p = trial.larger(T::zero());
                if p <= T::zero() && gap[i] < T::zero() {
                    taken_in.store(true, Ordering::Relaxed);
                    return p - tau * gap[i];
                }
                p
            });
            let [truncated, taken_in] = [truncated, taken_in].map(AtomicBool::into_inner);
            conjugate = !taken_in;
            // Restore the load (eq. 18). K is linear: unless a pixel changed sides, the response
            // is known without a transform.
            let scale = T::of(load * n as f64 / fields::sum(&state.pressure));
            fields::write(&mut state.pressure, |_, p| p * scale);
            if truncated || taken_in {
                operator.apply(&state.pressure, &mut state.displacement);
                transforms += 1.0;
            } else {
                fields::write(&mut state.displacement, |i, u| (u - tau * r[i]) * scale);
            }
        };
        if end == End::Exhausted && residual.is_infinite() {
            let check = certificate::energy_error(Elastic, state, |i| gap[i], r, operator);
            transforms += check.transforms;
            residual = certificate::CAUTION * check.relative;
        }
        if end == End::Exhausted && residual <= task.tolerance {
            end = End::Converged;
        }
        state.level = certificate::level(state, heights, Top::NONE);
        Outcome { end, iterations, transforms, residual, fallbacks: Fallbacks::default() }
    }
}
