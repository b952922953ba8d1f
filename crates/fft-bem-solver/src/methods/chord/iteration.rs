//! Extension-preconditioned chord iteration: about one FFT convolution per step and one digit per step.
//!
//! Each step asks for the pressure that would close the residual gap `g` on the contact set F,
//! `z = E^T S E g`; subtracts it; sweeps the tension that results onto the nodes that stay
//! ([`Sweep`](crate::methods::sweep::Sweep)); computes the displacement of that trial with one FFT convolution; and goes along the
//! chord from the present pressure to the trial as far as the energy falls. A chord of a convex
//! set stays in the set: pressures stay positive and carry the load without projection. The size
//! of z estimates the error of the pressure.
//!
//! ```text
//! begin with a pressure p of known displacement u = K p: constant, or that of another load
//! 1  g = u - h - mean of it in contact;  F = {p > release g+} or {g < 0}             active_set.rs
//! 2  z = E^T S E g on F, less its mean;  trial = p - tau z on F                       trial.rs
//!    |z on F, p off F| <= tolerance |p|: stop
//! 3  trial = trial swept, clipped, scaled to the load                                 trial.rs
//! 4  K trial                                                               (the one convolution)  line.rs
//!    theta = -<g,s>/<s,Ks> along the chord s = trial - p
//! 5  p += theta s, or all of s near theta = 1; better, the minimum over s and the step before
//!    and again from 1
//! ```
//!
//! Polonsky and Keer's method has the same five steps with other means: their 2 is the gap itself made
//! conjugate, their 3 clips and scales. The fields that it holds are named in
//! `docs/src/solver/method.md`.
//!
//! Projected gradients, where a chord does not descend or the estimate stalls, guarantee convergence.

use super::active_set::{ContactSet, RELEASE};
use super::line::{FULL, Trial};
use super::run::{Known, Run, StepKind};
use super::work::Work;
use crate::memory::is_large;
use crate::methods::ceiling::{Ceiling, under};
use crate::methods::contract::{
    ContactMethod, ContactTask, IterateView, Means, Outcome, Start, State,
};
use crate::methods::node::NodeState;
use crate::methods::thin_pixels::ratio;
use crate::problem::Problem;
use crate::{End, Real, certificate, fields};
use contact_types::Grid;

pub(crate) struct Chord<T: Real> {
    pub(crate) work: Work<T>,
}

impl<T: Real> Chord<T> {
    /// On a large grid without room for what only saves convolutions: the step before. With the
    /// [`Stiffness`](crate::methods::stiffness::Stiffness) of an isolated map nothing knows of its
    /// copies.
    pub(crate) fn new(scaled: Grid, is_isolated: bool) -> Self {
        let mut work = Work::new(scaled, is_isolated);
        if !is_large(scaled.len()) {
            work.pairs.before = State::new(scaled.len());
        }
        Self { work }
    }
}

impl<T: Real> ContactMethod<T> for Chord<T> {
    fn solve(&mut self, task: &ContactTask<'_, T>, means: Means<'_, '_, T>) -> Outcome {
        under!(task.ceiling, ceiling => self.iterate(ceiling, task, means))
    }

    fn controls_level(&self) -> bool {
        true
    }

    /// Asks the cheap `S`: `p = P + S (h - mean h)` would be nearly positive, above `-0.1 P`. That is also the first
    /// trial from the constant pressure, without what is swept: `S E g` is kept for it.
    fn suspected_closing_load(&mut self, problem: &Problem<T>) -> (f64, f64) {
        let work = &mut self.work;
        let gap = work.pairs.trial_and_spare().1;
        let (h, mean) = (&problem.heights, problem.mean_height);
        fields::write(gap, |i, _: f32| (mean - h[i].wide()) as f32);
        work.stiffness.apply(gap, &mut work.residual);
        work.holds_flattening = true;
        (fields::max(&work.residual) / 1.1, work.stiffness.cost)
    }
}

impl<T: Real> Chord<T> {
    fn iterate<C: Ceiling<T>>(
        &mut self,
        ceiling: C,
        task: &ContactTask<'_, T>,
        means: Means<'_, '_, T>,
    ) -> Outcome {
        let Means { operator, state, watch } = means;
        let mut run = Run::new(ceiling, &mut self.work, task, operator, state);
        match task.start {
            Start::Cold => run.begin_constant(),
            Start::Warm => run.begin_scaled(),
        }
        let mut proposal = run.first_proposal(task.start, task.tolerance);
        let mut iteration = 0;
        let end = loop {
            let error = run.level_error();
            let shown = IterateView {
                iteration,
                transforms: run.transforms,
                residual: run.memory.residual.max(error),
                state: run.iterate,
            };
            if watch(&shown).is_break() {
                break End::Stopped;
            }
            // A single pixel leaves no residual at any level: the level must be right as well.
            if error <= task.tolerance {
                if run.memory.residual <= task.tolerance {
                    break End::Converged;
                }
                if run.is_rounding(proposal.level) {
                    break End::Rounding;
                }
            }
            if iteration >= task.max_iterations {
                break End::Exhausted;
            }
            run.step(proposal);
            iteration += 1;
            proposal = run.propose(task.tolerance);
        };
        if task.ends_on_trial && end == End::Converged {
            run.end_on_trial(proposal);
        }
        if run.control.is_none() {
            run.end_drift();
        }
        let residual = run.memory.residual.max(run.level_error());
        let transforms = run.transforms;
        state.level = certificate::level(state, &task.problem.heights, task.ceiling);
        Outcome { exact: None, end, iterations: iteration, transforms, residual }
    }
}

/// Steps 1 and 2: a trial that is still to be swept.
#[derive(Clone, Copy)]
struct Proposal {
    /// Of the iterate.
    level: f64,
    set: ContactSet,
}

impl<T: Real, C: Ceiling<T>> Run<'_, T, C> {
    fn first_proposal(&mut self, start: Start, tolerance: f64) -> Proposal {
        let is_flattening = std::mem::take(&mut self.work.holds_flattening);
        if is_flattening && start == Start::Cold && self.control.is_none() {
            self.propose_from_constant(tolerance)
        } else {
            self.propose(tolerance)
        }
    }

    /// Residual gap and contact set, with the level prescribed once more at a better load; the preconditioned
    /// residual, and the trial it leads to.
    fn propose(&mut self, tolerance: f64) -> Proposal {
        let (shape, pixel) = (self.work.grid.shape(), self.work.grid.pixel());
        let release = if self.memory.length < FULL { RELEASE / ratio(shape, pixel) } else { 0.0 };
        let known = std::mem::take(&mut self.memory.known);
        let (mut level, mut set) = self.look(known, release);
        if self.control.is_some() {
            self.towards_level(level);
            (level, set) = self.look(Known::Nothing, release);
        }
        self.precondition();
        self.proposed(level, set, tolerance)
    }

    /// The same from the constant pressure, where everything is in contact and `E` leaves all as it is, if
    /// `S E g` is known.
    fn propose_from_constant(&mut self, tolerance: f64) -> Proposal {
        let work = &mut *self.work;
        work.nodes.fill(NodeState::Contact);
        work.pyramid.know_all();
        let set = ContactSet { size: work.nodes.len(), has_released: false };
        self.proposed(-self.mean_height, set, tolerance)
    }

    /// The trial that `S E g` leads to.
    fn proposed(&mut self, level: f64, set: ContactSet, tolerance: f64) -> Proposal {
        let estimate = self.make_trial(self.memory.tau, set);
        let [residual, _] = estimate;
        self.memory.residual =
            if residual <= tolerance { self.credible(estimate, level) } else { residual };
        Proposal { level, set }
    }

    /// Step 3, and its trial for the iterate.
    fn end_on_trial(&mut self, proposal: Proposal) {
        self.sweep_trial(proposal.set, self.memory.residual.min(1.0));
        if let Some(scale) = self.end_trial(proposal.level) {
            std::mem::swap(&mut self.iterate.pressure, &mut self.work.pairs.trial.pressure);
            fields::scale(scale, &mut self.iterate.pressure);
        }
    }

    /// Steps 3 to 5, or a step of another kind if the estimate has not been halved for long.
    fn step(&mut self, proposal: Proposal) {
        let mut kind = self.memory.next_kind();
        let products = loop {
            let trial = match kind {
                StepKind::Chord => {
                    self.sweep_trial(proposal.set, self.memory.residual.min(1.0));
                    // The first trial is likely to need more than a factor.
                    if self.memory.is_first || C::IS_FINITE {
                        self.end_trial(proposal.level).map(Trial::Ended)
                    } else {
                        Some(Trial::Swept)
                    }
                }
                StepKind::Gradient => {
                    self.gradient_trial(proposal.level);
                    Some(Trial::Ended(1.0))
                }
            };
            let products = trial.and_then(|trial| self.respond(trial, proposal.level));
            if let Some(products) = products
                && (products.theta() > 0.0 || kind != StepKind::Chord)
            {
                break products;
            }
            kind = StepKind::Gradient; // the chord does not descend: projected gradients always do
        };
        self.advance(kind, &products, proposal.level);
    }
}
