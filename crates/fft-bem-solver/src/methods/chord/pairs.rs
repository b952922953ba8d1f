//! The pressures of a step with their displacements, and the memory that is free meanwhile.

use crate::Real;
use crate::methods::contract::State;
use crate::methods::passes;

/// Where the next trial starts from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Base {
    /// The iterate. Its displacement is `K p`.
    Iterate,
    /// A guess of the solution, which stands where the trial will be. Its displacement is nearly `K p`.
    Lead,
}

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
/// The displacement of the trial is known only once a pair has been spent on it. Until then its place
/// is the *spare*: room for a field in single precision, which holds first `E g`, then the smallest
/// trial pressure below each cell. Under a lead, whose displacement stands there, the spare is that of the
/// iterate before, since the first step has none. `docs/src/solver/method.md` names the fields.
pub(crate) struct Pairs<T> {
    pub(crate) trial: Pair<T>,
    pub(crate) before: Pair<T>,
    pub(crate) base: Base,
}

impl<T: Real> Pairs<T> {
    pub(super) fn new(n: usize) -> Self {
        Self { trial: Pair::new(n), before: Pair::new(0), base: Base::Iterate }
    }

    /// Makes room for the iterate before, which a lead and a step of two directions need.
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

    /// Pressure and displacement of the base.
    pub(super) fn start<'a>(&'a self, iterate: &'a State<T>) -> [&'a [T]; 2] {
        match self.base {
            Base::Iterate => [&iterate.pressure, &iterate.displacement],
            Base::Lead => [&self.trial.pressure, &self.trial.displacement],
        }
    }

    /// The same, and the spare.
    pub(super) fn start_and_spare<'a>(
        &'a mut self,
        iterate: &'a State<T>,
    ) -> ([&'a [T]; 2], &'a mut [f32]) {
        let Self { trial, before, base } = self;
        match base {
            Base::Iterate => {
                let start = [&iterate.pressure[..], &iterate.displacement];
                (start, narrowed(&mut trial.displacement))
            }
            Base::Lead => {
                let start = [&trial.pressure[..], &trial.displacement];
                (start, narrowed(&mut before.displacement))
            }
        }
    }

    /// The spare alone.
    pub(crate) fn spare(&mut self) -> &mut [f32] {
        self.trial_and_spare().1
    }

    /// The pressure of the trial, and the spare.
    pub(super) fn trial_and_spare(&mut self) -> (&mut [T], &mut [f32]) {
        let Self { trial, before, base } = self;
        let free = match base {
            Base::Iterate => &mut trial.displacement,
            Base::Lead => &mut before.displacement,
        };
        (&mut trial.pressure, narrowed(free))
    }

    /// Makes a multiple of the iterate the lead, unless there is one.
    pub(super) fn lead_from(&mut self, factor: f64, iterate: &State<T>) {
        if self.base == Base::Lead {
            return;
        }
        self.base = Base::Lead;
        passes::copy(&iterate.pressure, &mut self.trial.pressure);
        passes::copy(&iterate.displacement, &mut self.trial.displacement);
        passes::scale(factor, &mut self.trial.pressure);
        passes::scale(factor, &mut self.trial.displacement);
    }

    /// The pressure of the trial and, until it has its own, the displacement of the base.
    pub(super) fn trial_and_displacement<'a>(
        &'a mut self,
        iterate: &'a State<T>,
    ) -> (&'a mut [T], &'a [T]) {
        let Self { trial, base, .. } = self;
        match base {
            Base::Iterate => (&mut trial.pressure, &iterate.displacement),
            Base::Lead => (&mut trial.pressure, &trial.displacement),
        }
    }

    /// Makes room for a trial: the pressure of a lead steps aside. Returns the pressure of the base, that of
    /// the trial, which holds nothing yet, and the spare.
    pub(super) fn begin_trial<'a>(
        &'a mut self,
        iterate: &'a State<T>,
    ) -> (&'a [T], &'a mut [T], &'a mut [f32]) {
        let Self { trial, before, base } = self;
        match base {
            Base::Iterate => {
                (&iterate.pressure, &mut trial.pressure, narrowed(&mut trial.displacement))
            }
            Base::Lead => {
                std::mem::swap(&mut trial.pressure, &mut before.pressure);
                (&before.pressure, &mut trial.pressure, narrowed(&mut before.displacement))
            }
        }
    }

    /// Writes what the trial differs by from the pressure it was [begun](Self::begin_trial) with, once it
    /// has been multiplied by `factor`.
    pub(super) fn change(&mut self, factor: f64, iterate: &State<T>, change: &mut [f32]) {
        let from = match self.base {
            Base::Iterate => &iterate.pressure,
            Base::Lead => &self.before.pressure,
        };
        passes::difference(factor, from, &mut self.trial.pressure, change);
    }

    /// Makes the trial the lead: its displacement becomes that of the base, to which the caller adds what
    /// the change of the pressure adds.
    pub(super) fn lead<'a>(&'a mut self, iterate: &'a State<T>) -> Lead<'a, T> {
        let base = (self.base == Base::Iterate).then_some(&iterate.displacement[..]);
        self.base = Base::Lead;
        let Pair { pressure, displacement } = &mut self.trial;
        Lead { pressure, base, displacement, spare: narrowed(&mut self.before.displacement) }
    }

    /// Multiplies the pairs that the next step will use by the factor of the load: K is linear.
    pub(super) fn scale(&mut self, factor: f64, iterate: &mut State<T>) {
        // Under no lead, the step before must stay one that changes no load.
        let other = match self.base {
            Base::Iterate => &mut self.before,
            Base::Lead => &mut self.trial,
        };
        passes::scale(factor, &mut iterate.pressure);
        passes::scale(factor, &mut iterate.displacement);
        passes::scale(factor, &mut other.pressure);
        passes::scale(factor, &mut other.displacement);
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

/// A lead in the making.
pub(super) struct Lead<'a, T> {
    pub(super) pressure: &'a [T],
    /// The displacement of the base, unless it stands in the place of that of the lead already.
    pub(super) base: Option<&'a [T]>,
    pub(super) displacement: &'a mut [T],
    pub(super) spare: &'a mut [f32],
}

/// The memory of a field, as a field in single precision.
fn narrowed<T: Real>(free: &mut [T]) -> &mut [f32] {
    let n = free.len();
    &mut T::as_single(free)[..n]
}
