//! The pressures of a step with their displacements, and the memory that is free meanwhile.

use crate::Real;
use crate::methods::contract::State;

/// The trial and, where there is [room](Self::make_room) for it, the iterate before the present one. The present
/// one belongs to the caller.
///
/// The displacement of the trial is known only once a convolution has been spent on it. Until then its place
/// is the *spare*: room for a field in single precision, which holds first `E g`, then the smallest
/// trial pressure below each cell. `docs/src/solver/method.md` names the fields.
pub(crate) struct Pairs<T> {
    pub(crate) trial: State<T>,
    pub(crate) before: State<T>,
}

impl<T: Real> Pairs<T> {
    pub(super) fn new(n: usize) -> Self {
        Self { trial: State::new(n), before: State::new(0) }
    }

    /// Makes room for the iterate before, which a step of two directions needs.
    pub(super) fn make_room(&mut self) {
        if !self.has_room() {
            self.before = State::new(self.trial.pressure.len());
        }
    }

    pub(crate) fn has_room(&self) -> bool {
        self.before.pressure.len() == self.trial.pressure.len()
    }

    /// As on a grid too large for it.
    #[cfg(test)]
    pub(crate) fn give_up_room(&mut self) {
        self.before = State::new(0);
    }

    /// The pressure of the trial, and the spare.
    pub(crate) fn trial_and_spare(&mut self) -> (&mut [T], &mut [f32]) {
        let State { pressure, displacement, .. } = &mut self.trial;
        let n = displacement.len();
        (pressure, &mut T::as_single(displacement)[..n])
    }

    /// Multiplies the pairs that the next step will use by the factor of the load: K is linear.
    pub(super) fn scale(&mut self, factor: f64, iterate: &mut State<T>) {
        // The step before must stay one that changes no load.
        self.before.scale(factor);
        iterate.scale(factor);
    }

    /// Makes the trial the iterate and, where there is room, the iterate the one before.
    pub(super) fn take_trial(&mut self, iterate: &mut State<T>) {
        std::mem::swap(&mut self.trial, iterate);
        if self.has_room() {
            std::mem::swap(&mut self.before, &mut self.trial);
        }
    }
}
