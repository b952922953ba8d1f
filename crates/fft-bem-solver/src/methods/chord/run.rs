//! One run of the iteration: the problem, the iterate, what it remembers from step to step, and the
//! ladder of fallbacks.

use super::work::Work;
use crate::methods::ceiling::Ceiling;
use crate::methods::compliance::Compliance;
use crate::methods::contract::{ContactTask, State, Target};
use crate::methods::level_control::LevelControl;
use crate::{Real, fields, projection};

/// A run in progress. Its steps are in files of their own, in the order in which the
/// [loop](super::iteration) takes them.
pub(crate) struct Run<'a, T: Real, C: Ceiling<T>> {
    pub(crate) ceiling: C,
    pub(crate) work: &'a mut Work<T>,
    pub(crate) operator: &'a mut dyn Compliance<T>,
    pub(crate) heights: &'a [T],
    pub(super) mean_height: f64,
    pub(crate) iterate: &'a mut State<T>,
    /// Mean pressure.
    pub(crate) load: f64,
    /// If the level is prescribed and not the load.
    pub(super) control: Option<LevelControl>,
    pub(super) memory: Memory,
    /// Pairs spent.
    pub(super) transforms: f64,
}

impl<'a, T: Real, C: Ceiling<T>> Run<'a, T, C> {
    /// A run that has not begun.
    pub(crate) fn new(
        ceiling: C,
        work: &'a mut Work<T>,
        task: &ContactTask<'a, T>,
        operator: &'a mut dyn Compliance<T>,
        iterate: &'a mut State<T>,
    ) -> Self {
        let (load, control) = match task.target {
            Target::Pressure(load) => (load, None),
            Target::Gap(gap, guess) => {
                (guess, Some(LevelControl::new(gap, task.problem.mean_height)))
            }
        };
        Self {
            ceiling,
            work,
            operator,
            heights: &task.problem.heights,
            mean_height: task.problem.mean_height,
            iterate,
            load,
            control,
            memory: Memory::new(),
            transforms: 0.0,
        }
    }

    /// The load of the whole map, in pixels.
    pub(super) fn total(&self) -> f64 {
        self.load * self.heights.len() as f64
    }

    pub(super) fn begin_constant(&mut self) {
        self.transforms += self.iterate.fill(self.load, self.operator);
    }

    /// Begins with the iterate there is, scaled to the load: K is linear. Where the level is prescribed, the
    /// load is that of the iterate.
    ///
    /// What would come to lie above the ceiling stays at it, and the rest is scaled more, for one convolution.
    pub(super) fn begin_scaled(&mut self) {
        let present = fields::mean(&self.iterate.pressure);
        if self.control.is_some() {
            self.load = present;
            return;
        }
        let factor = self.load / present;
        if !self.ceiling.is_passed(factor, &self.iterate.pressure) {
            self.iterate.scale(factor);
            return;
        }
        let total = self.total();
        let State { pressure, displacement, .. } = &mut *self.iterate;
        if !projection::scale_below(pressure, total, self.ceiling.top(), f64::MAX) {
            project(self.ceiling, pressure, self.load);
        }
        self.operator.apply(pressure, displacement);
        self.transforms += 1.0;
    }

    /// Steps longer than the chord multiply the rounding of the load: takes back what came of it.
    pub(super) fn end_drift(&mut self) {
        if C::IS_FINITE {
            return; // every trial is given the load to the last digit, and its nodes may not be scaled
        }
        let present = fields::mean(&self.iterate.pressure);
        if (present / self.load - 1.0).abs() > 32.0 * T::EPSILON {
            self.iterate.scale(self.load / present);
        }
    }

    /// How far a prescribed level is from being met, in the logarithm of the load.
    pub(super) fn level_error(&self) -> f64 {
        self.control.as_ref().map_or(0.0, |control| control.error.abs())
    }
}

/// The nearest pressure within the bounds that carries the load.
pub(super) fn project<T: Real, C: Ceiling<T>>(ceiling: C, field: &mut [T], load: f64) {
    if C::IS_FINITE {
        projection::between(field, load, ceiling.top());
    } else {
        projection::onto_admissible(field, load);
    }
}

/// Iterations without halving the estimate before another kind of step is tried.
const STALL: usize = 8;
/// Range of the length of the preconditioned step.
const TAU: [f64; 2] = [0.3, 1.0];
/// By how much that length may change from one step to the next.
const CHANGE: [f64; 2] = [0.7, 1.4];

/// How the trial of a step is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum StepKind {
    /// Along the preconditioned residual, swept.
    Chord,
    /// Along the residual gap, projected on the pressures that are positive and carry the load.
    Gradient,
}

/// What is known of an iterate before it is looked at.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) enum Known {
    #[default]
    Nothing,
    /// The mean of `u - h` in contact.
    Level(f64),
    /// That mean; and the residual field holds the gap, but counted from another level.
    Gap { level: f64, counted_from: f64 },
}

/// What a step needs to know of the ones before.
pub(super) struct Memory {
    /// Length of the next preconditioned step and of the next gradient step.
    pub(super) tau: f64,
    pub(super) alpha: f64,
    /// Chord length of the last step.
    pub(super) length: f64,
    /// Whether no trial was taken yet.
    pub(super) is_first: bool,
    /// Whether the iterate before this one is kept, and `<d, K d>` of the step from it.
    pub(super) has_before: bool,
    pub(super) dkd: f64,
    /// What the step to the iterate found out about it.
    pub(super) known: Known,
    /// Estimate of the relative pressure error.
    pub(super) residual: f64,
    /// Smallest estimate that was a halving, and the iterations since.
    best: f64,
    since: usize,
    kind: StepKind,
}

impl Memory {
    /// Before the first step.
    pub(super) fn new() -> Self {
        Self {
            tau: 1.0,
            alpha: 1.5,
            length: 1.0,
            is_first: true,
            has_before: false,
            dkd: 0.0,
            known: Known::Nothing,
            residual: f64::INFINITY,
            best: f64::INFINITY,
            since: 0,
            kind: StepKind::Chord,
        }
    }

    /// The next preconditioned step is to be `theta` times as long: so far along the last one the energy fell.
    pub(super) fn adapt_length(&mut self, theta: f64) {
        self.tau = (self.tau * theta.clamp(CHANGE[0], CHANGE[1])).clamp(TAU[0], TAU[1]);
    }

    /// Chords; gradients once chords have not halved the estimate for long; back to chords when it has been halved.
    pub(super) fn next_kind(&mut self) -> StepKind {
        if self.residual <= 0.5 * self.best {
            self.best = self.residual;
            self.since = 0;
        } else {
            self.since += 1;
        }
        match self.since {
            0 => self.kind = StepKind::Chord,
            STALL => self.kind = StepKind::Gradient,
            _ => {}
        }
        self.kind
    }
}
