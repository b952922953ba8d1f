//! One run of the iteration: the problem, the iterate, and what the steps to it have shown.

use super::memory::{Memory, StepKind};
use super::work::Work;
use crate::methods::ceiling::Ceiling;
use crate::methods::compliance::Compliance;
use crate::methods::contract::{ContactTask, Start, State, Target};
use crate::methods::level_control::LevelControl;
use crate::{Boundary, Real, fields, projection};

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
    /// Level of the iterate that it began with, where that is a constant pressure without displacement.
    pub(super) first_level: Option<f64>,
    /// Pairs spent.
    pub(super) transforms: f64,
    pub(super) fallbacks: usize,
}

impl<'a, T: Real, C: Ceiling<T>> Run<'a, T, C> {
    /// A run that has not begun. Tests force a kind of step.
    pub(crate) fn new(
        ceiling: C,
        work: &'a mut Work<T>,
        task: &ContactTask<'a, T>,
        operator: &'a mut dyn Compliance<T>,
        start: Start,
        forced: Option<StepKind>,
        iterate: &'a mut State<T>,
    ) -> Self {
        let (load, control) = match task.target {
            Target::Pressure(load) | Target::OpenGap(_, load) => (load, None),
            Target::Level(level, guess) => {
                (guess, Some(LevelControl::new(level, task.problem.mean_height)))
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
            memory: Memory::new(start == Start::Cold, forced),
            first_level: None,
            transforms: 0.0,
            fallbacks: 0,
        }
    }

    /// The load of the whole map, in pixels.
    pub(super) fn total(&self) -> f64 {
        self.load * self.heights.len() as f64
    }

    /// Begins with the constant pressure; its displacement is zero on a periodic half space.
    pub(super) fn begin_constant(&mut self) {
        self.transforms += self.iterate.fill(self.load, self.operator);
        let is_periodic = self.operator.boundary() == Boundary::Periodic;
        self.first_level = is_periodic.then_some(-self.mean_height);
    }

    /// Begins with the iterate there is, scaled to the load: K is linear. Where the level is prescribed, the
    /// load is that of the iterate.
    ///
    /// What was near the ceiling may so come to lie above it: it is projected, for one convolution.
    pub(super) fn begin_scaled(&mut self) {
        let present = fields::mean(&self.iterate.pressure);
        if self.control.is_some() {
            self.load = present;
            return;
        }
        let factor = self.load / present;
        let is_cut = C::IS_FINITE && self.ceiling.is_passed(factor, &self.iterate.pressure);
        self.iterate.scale(factor);
        if is_cut {
            project(self.ceiling, &mut self.iterate.pressure, self.load);
            self.operator.apply(&self.iterate.pressure, &mut self.iterate.displacement);
            self.transforms += 1.0;
        }
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
