//! Extension-preconditioned chord iteration: about one FFT pair per step and one digit per step.
//!
//! Each step asks for the pressure that would close the residual gap `g` on the contact set F,
//! `z = E^T S E g`; subtracts it; sweeps the tension that results onto the nodes that stay
//! ([`Sweep`]); computes the displacement of that trial with one FFT pair; and goes along the
//! chord from the present pressure to the trial as far as the energy falls. A chord of a convex
//! set stays in the set: pressures stay positive and carry the load without projection. The size
//! of z estimates the error of the pressure.
//!
//! ```text
//! loop
//!   g = u - h - mean of it in contact;  F = {p > release g+} or {g < 0}
//!   z = E^T S E g on F, less its mean;  |z on F, p off F| <= tolerance |p|: stop
//!   trial = p - tau z on F, swept, clipped, scaled to the load
//!   at first, while |z| > 0.05 |p|:  u = u + K~ (trial - p),  p = trial     (no pair: a guess)
//!   K trial                                                                  (the one pair)
//!   theta = -<g,s>/<s,Ks> along the chord s = trial - p
//!   p += theta s, or all of s near theta = 1; better, the minimum over s and the step before
//! ```
//!
//! Two fallbacks guarantee convergence: projected gradients where a chord does not descend or the
//! estimate stalls, and conjugate gradients on the face where that does not help.

use super::memory::{Kind, Known, Memory};
use super::steps::{FULL, Trial};
use super::work::{Chord, room};
use crate::methods::compliance::Compliance;
use crate::methods::contract::{
    ContactMethod, End, Outcome, Start, State, Step, Target, Task, Watch,
};
use crate::methods::extrapolation::Earlier;
use crate::methods::level_control::LevelControl;
use crate::methods::{face_cg, passes};
use crate::problem::Problem;
use crate::{Boundary, Real, certificate, fields};

/// After a poor step, nodes with less pressure than this times their gap are let go; as much less as
/// pixels are longer than wide, where a line of them may stand off as a whole for a lack of little load.
const RELEASE: f64 = 0.1;
/// The estimate that ends the steps before the first trial.
const GUESSED: f64 = 0.05;

impl<T: Real> Chord<T> {
    fn iterate(
        &mut self,
        task: &Task<'_, T>,
        operator: &mut dyn Compliance<T>,
        start: Start,
        state: &mut State<T>,
        watch: &mut Watch<'_, T>,
    ) -> Outcome {
        let h = &task.problem.heights[..];
        let (mut load, mut control) = match task.target {
            Target::Pressure(p) => (p, None),
            Target::Level(level, guess) => {
                let mean_height = task.problem.mean_height;
                (guess, Some(LevelControl::new(level, mean_height, operator.boundary())))
            }
        };
        self.events.clear();
        let mut is_lead = false; // the trial fields hold where the next trial starts from, not the state
        let mut transforms = 0.0;
        if start == Start::Warm {
            let guess = [&mut self.trial[..], &mut self.response[..]];
            if let (Some(earlier), Target::Pressure(load)) = (&mut self.earlier, task.target) {
                is_lead = earlier.guess(load, state, guess);
            }
            load = rescale(control.is_none().then_some(load), state);
        } else {
            if let Some(earlier) = &mut self.earlier {
                earlier.forget();
            }
            transforms += begin_constant(load, operator, state);
        }
        let mut now = Memory {
            tau: 1.0,
            alpha: 1.5,
            a: if start == Start::Cold { 1.0 } else { 0.0 },
            has_before: false,
            dkd: 0.0,
            known: Known::default(),
            best: f64::INFINITY,
            since: 0,
            kind: self.force.unwrap_or(Kind::Chord),
        };
        let (mut iteration, mut residual) = (0, f64::INFINITY);
        let mut guesses = if self.force.is_none() { self.guesses } else { 0 };
        let mut is_first = true;
        let end = loop {
            // Residual gap and contact set; with the level prescribed, once more at a better load.
            let most = RELEASE / self.elongation;
            let release = if now.a < FULL { most } else { 0.0 };
            let known = std::mem::take(&mut now.known);
            let (mut level, mut found) = self.look(h, known, release, is_lead, state);
            if let Some(control) = &mut control {
                let factor = self.towards_level(control, level, load, residual, is_lead, state);
                load *= factor;
                now.dkd *= factor * factor;
                (level, found) = self.look(h, Known::default(), most, is_lead, state);
            } else if is_first && start == Start::Warm {
                // The contact of another load: the step will close much that it leaves open.
                found = self.look_ahead(h, level, release, is_lead, state);
            }

            // Preconditioned residual, and the trial it leads to.
            self.precondition(is_lead);
            transforms += self.stiffness.cost;
            let estimate = self.make_trial(is_lead, now.tau, &found, state);
            residual = estimate.residual;
            if !is_lead && residual <= task.tolerance {
                let fields = [&state.displacement[..], h];
                residual = self.credible(&estimate, fields, level);
            }

            // Before the first trial costs a pair: the same without one, while there is much to gain.
            let is_worth_it =
                residual > GUESSED || (is_first && (is_lead || residual > task.tolerance));
            is_first = false;
            if guesses > 0 && is_worth_it {
                guesses -= 1;
                if let Some(cost) = self.guess(load, &found, is_lead, state) {
                    transforms += cost;
                    is_lead = true;
                    now.a = 0.0;
                    continue;
                }
            }
            guesses = 0;

            let error = control.as_ref().map_or(0.0, |c| c.error.abs());
            let step = Step { iteration, transforms, residual: residual.max(error), state };
            if watch(&step).is_break() {
                break End::Stopped;
            }
            if !is_lead {
                let mut is_rounding = || {
                    let fields = [&state.displacement[..], h];
                    residual < T::EPSILON.sqrt()
                        && passes::is_rounding(fields, level, &self.nodes, &mut self.partial)
                };
                // A single pixel leaves no residual at any level: the level must be right as well.
                if error <= task.tolerance && (residual <= task.tolerance || is_rounding()) {
                    break End::Converged;
                }
                if iteration >= task.max_iterations {
                    break End::Exhausted;
                }
            }

            // Another kind of step if the estimate has not been halved for long.
            now.watch_progress(residual, iteration, self.force.is_some(), &mut self.events);
            if now.kind == Kind::FaceCg && !is_lead {
                let first = !now.has_before;
                transforms += face_cg::step(self, operator, h, level, load, first, state);
                now.has_before = true;
                iteration += 1;
                continue;
            }

            // Trial, its displacement, and how far to go along the chord.
            let base_level = if is_lead {
                passes::level(&state.pressure, &state.displacement, h, &mut self.partial)
            } else {
                level
            };
            let mut kind = now.kind;
            let products = loop {
                let trial = match kind {
                    Kind::Chord => {
                        self.sweep_trial(&found, load, residual, is_lead);
                        // The first trial is likely to need more than a factor.
                        let is_first = !now.has_before;
                        if is_first {
                            self.end_trial(load).map(Trial::Ended)
                        } else {
                            Some(Trial::Swept)
                        }
                    }
                    Kind::Gradient | Kind::FaceCg => {
                        self.gradient_trial(h, base_level, now.alpha, load, state);
                        Some(Trial::Ended(1.0))
                    }
                };
                let levels = [base_level, level];
                if let Some(trial) = trial
                    && let Some(products) =
                        self.respond(operator, trial, load, h, levels, &now, state)
                {
                    transforms += 1.0;
                    if products.theta() > 0.0 || kind != Kind::Chord {
                        break products;
                    }
                }
                kind = Kind::Gradient; // the chord does not descend: projected gradients always do
                self.events.push((iteration, kind));
            };
            is_lead = false;
            self.advance(kind, &products, level, &mut now, h, state);
            iteration += 1;
        };
        if control.is_none() {
            end_drift(load, state);
        }
        state.level = certificate::level(state, h);
        let error = control.map_or(0.0, |c| c.error.abs());
        Outcome { end, iterations: iteration, transforms, residual: residual.max(error) }
    }
}

/// The constant pressure; its displacement is zero on a periodic half space. Returns the pairs.
fn begin_constant<T: Real>(
    load: f64,
    operator: &mut dyn Compliance<T>,
    state: &mut State<T>,
) -> f64 {
    passes::fill(load, &mut state.pressure);
    if operator.boundary() == Boundary::Periodic {
        passes::fill(0.0, &mut state.displacement);
        return 0.0;
    }
    operator.apply(&state.pressure, &mut state.displacement);
    1.0
}

/// Steps longer than the chord multiply the rounding of the load: takes back what came of it.
fn end_drift<T: Real>(load: f64, state: &mut State<T>) {
    let present = fields::sum(&state.pressure) / state.pressure.len() as f64;
    if (present / load - 1.0).abs() > 32.0 * T::EPSILON {
        rescale(Some(load), state);
    }
}

/// Scales a solution to another load: K is linear. Without a load, leaves it. Returns the load.
fn rescale<T: Real>(load: Option<f64>, state: &mut State<T>) -> f64 {
    let present = fields::sum(&state.pressure) / state.pressure.len() as f64;
    if let Some(load) = load {
        passes::scale(load / present, &mut state.pressure);
        passes::scale(load / present, &mut state.displacement);
    }
    load.unwrap_or(present)
}

impl<T: Real> ContactMethod<T> for Chord<T> {
    fn solve(
        &mut self,
        task: &Task<'_, T>,
        operator: &mut dyn Compliance<T>,
        start: Start,
        state: &mut State<T>,
        watch: &mut Watch<'_, T>,
    ) -> Outcome {
        self.iterate(task, operator, start, state, watch)
    }

    fn extrapolate(&mut self, is_on: bool) {
        let n = self.trial.len();
        self.earlier = is_on.then(|| Box::new(Earlier::new(n)));
    }

    fn controls_level(&self) -> bool {
        true
    }

    /// Asks the cheap `S`: `p = P + S (h - mean h)` would be nearly positive, above `-0.1 P`.
    fn suspected_closing_load(&mut self, problem: &Problem<T>) -> (f64, f64) {
        let heights = room(&mut self.response, &mut self.before_response, false);
        passes::narrow(&problem.heights, problem.mean_height, heights);
        self.stiffness.apply(heights, &mut self.residual);
        let least = fields::min(&self.residual);
        (-least / 1.1, self.stiffness.cost)
    }
}
