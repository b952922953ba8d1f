//! Steepest descent with redistribution of the load, after Stanley & Kato.
//!
//! Each iteration (1) transforms the pressure to the displacement, (2) forms the gap, which is the
//! gradient of the energy, (3) steps down the gradient, (4) drops tension and shifts the whole
//! field until the load is carried again. One FFT pair per iteration. The step is the one that
//! minimises the energy along the way from the old pressure to the redistributed one: the energy
//! never rises, and the iteration can be run to any tolerance.
//!
//! The number of iterations grows with the longest over the shortest wavelength in contact: this is
//! a baseline, not a method to prefer.
//!
//! # Source
//! Stanley & Kato (1997), *J. Tribol.* 119, 481–485, doi:10.1115/1.2833523.

use super::begin::{begin, mean_gap_in_contact_to_zero};
use super::ceiling::{Elastic, Top};
use super::compliance::Compliance;
use super::contract::{ContactMethod, Outcome, Start, State, Step, Target, Task, Watch};
use crate::certificate::{self, Patience};
use crate::{End, Fallbacks, Real, fields, projection};

/// The method and its fields: gap, redistributed pressure and its displacement.
pub(crate) struct StanleyKato<T> {
    gap: Vec<T>,
    trial: Vec<T>,
    response: Vec<T>,
}

impl<T: Real> StanleyKato<T> {
    pub(crate) fn new(n: usize) -> Self {
        let zeros = || vec![T::zero(); n];
        Self { gap: zeros(), trial: zeros(), response: zeros() }
    }
}

impl<T: Real> ContactMethod<T> for StanleyKato<T> {
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
        let (gap, trial, response) = (&mut self.gap, &mut self.trial, &mut self.response);
        let mut length = 1.0; // of the step down the gradient; pressure per gap
        let mut patience = Patience::new(task.tolerance);
        let (mut iterations, mut residual) = (0, f64::INFINITY);
        let end = loop {
            mean_gap_in_contact_to_zero(state, heights, gap);
            let check = patience.judge(state, heights, gap, response, operator);
            transforms += check.transforms;
            residual = check.residual.unwrap_or(residual);
            if watch(&Step { iteration: iterations, transforms, residual, state }).is_break() {
                break End::Stopped;
            }
            if let Some(end) = check.end {
                break end;
            }
            if iterations >= task.max_iterations {
                break End::Exhausted;
            }
            iterations += 1;

            // Down the gradient, then redistribute.
            let (p, step) = (&state.pressure, T::of(length));
            fields::write(trial, |i, _| p[i] - step * gap[i]);
            projection::onto_admissible(trial, load);
            operator.apply(trial, response);
            transforms += 1.0;

            // The best point on the way: theta = -<g, s> / <s, K s>.
            let (p, u) = (&state.pressure, &state.displacement);
            let s = |i: usize| trial[i].wide() - p[i].wide();
            let descent = -fields::sum_of(n, |i| gap[i].wide() * s(i));
            let curvature = fields::sum_of(n, |i| s(i) * (response[i].wide() - u[i].wide()));
            if descent <= 0.0 || curvature <= 0.0 || (descent / curvature).is_nan() {
                break End::Exhausted; // nothing left but rounding
            }
            let theta = descent / curvature;
            length *= theta.clamp(0.2, 5.0);
            // Beyond the end of the way only as far as no pressure turns negative, and little, since
            // the error of u grows by the factor 1 - part; the next step will be longer.
            let mut part = theta.min(1.5);
            if theta > 1.0 {
                let reach = fields::least_of(n, |i| {
                    if trial[i] < p[i] { p[i].wide() / -s(i) } else { f64::INFINITY }
                });
                part = part.min(reach.max(1.0));
            }
            let part = T::of(part);
            let State { pressure: p, displacement: u, .. } = &mut *state;
            fields::write_both([p, u], |i, [p, u]| {
                [(p + part * (trial[i] - p)).larger(T::zero()), u + part * (response[i] - u)]
            });
            // Beyond the end of the way rounding of the load would grow; K is linear.
            let scale = T::of(load * n as f64 / fields::sum(&state.pressure));
            let State { pressure: p, displacement: u, .. } = &mut *state;
            fields::write_both([p, u], |_, [p, u]| [p * scale, u * scale]);
        };
        if end == End::Exhausted && residual.is_infinite() {
            let check = certificate::energy_error(Elastic, state, |i| gap[i], response, operator);
            transforms += check.transforms;
            residual = certificate::CAUTION * check.relative;
        }
        state.level = certificate::level(state, heights, Top::NONE);
        Outcome { end, iterations, transforms, residual, fallbacks: Fallbacks::default() }
    }
}
