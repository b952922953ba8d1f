//! The pressures of a step with their displacements, and the memory that is free meanwhile.

use crate::methods::contract::State;
use crate::{Real, fields};

/// A pressure and the displacement it causes.
pub(crate) struct Pair<T> {
    pub(crate) pressure: Vec<T>,
    pub(crate) displacement: Vec<T>,
}

impl<T: Real> Pair<T> {
    fn new(n: usize) -> Self {
        Self { pressure: vec![T::zero(); n], displacement: vec![T::zero(); n] }
    }

    fn swap(&mut self, state: &mut State<T>) {
        std::mem::swap(&mut self.pressure, &mut state.pressure);
        std::mem::swap(&mut self.displacement, &mut state.displacement);
    }
}

/// The trial and, where there is [room](Self::make_room) for it, the iterate before the present one. The present
/// one belongs to the caller.
///
/// The displacement of the trial is known only once a convolution has been spent on it. Until then its place
/// is the *spare*: room for a field in single precision, which holds first `E g`, then the smallest
/// trial pressure below each cell. `docs/src/solver/method.md` names the fields.
pub(crate) struct Pairs<T> {
    pub(crate) trial: Pair<T>,
    pub(crate) before: Pair<T>,
}

impl<T: Real> Pairs<T> {
    pub(super) fn new(n: usize) -> Self {
        Self { trial: Pair::new(n), before: Pair::new(0) }
    }

    /// Makes room for the iterate before, which a step of two directions needs.
    pub(super) fn make_room(&mut self) {
        if !self.has_room() {
            self.before = Pair::new(self.trial.pressure.len());
        }
    }

    pub(crate) fn has_room(&self) -> bool {
        self.before.pressure.len() == self.trial.pressure.len()
    }

    /// As on a grid too large for it.
    #[cfg(test)]
    pub(crate) fn give_up_room(&mut self) {
        self.before = Pair::new(0);
    }

    /// The spare.
    pub(crate) fn spare(&mut self) -> &mut [f32] {
        narrowed(&mut self.trial.displacement)
    }

    /// The pressure of the trial, and the spare.
    pub(super) fn trial_and_spare(&mut self) -> (&mut [T], &mut [f32]) {
        let Pair { pressure, displacement } = &mut self.trial;
        (pressure, narrowed(displacement))
    }

    /// Multiplies the pairs that the next step will use by the factor of the load: K is linear.
    pub(super) fn scale(&mut self, factor: f64, iterate: &mut State<T>) {
        // The step before must stay one that changes no load.
        let Pair { pressure, displacement } = &mut self.before;
        iterate.scale(factor);
        fields::scale(factor, pressure);
        fields::scale(factor, displacement);
    }

    /// Makes the trial the iterate and, where there is room, the iterate the one before.
    pub(super) fn take_trial(&mut self, iterate: &mut State<T>) {
        self.trial.swap(iterate);
        if self.has_room() {
            std::mem::swap(&mut self.before, &mut self.trial);
        }
    }

    /// Makes what stands in the place of the iterate before the iterate, and the iterate the one before.
    pub(super) fn take_combined(&mut self, iterate: &mut State<T>) {
        self.before.swap(iterate);
    }
}

/// The memory of a field, as a field in single precision.
fn narrowed<T: Real>(free: &mut [T]) -> &mut [f32] {
    let n = free.len();
    &mut T::as_single(free)[..n]
}
