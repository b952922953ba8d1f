//! The first trial on a load curve: linear extrapolation from the last two solutions.

use super::contract::State;
use super::passes;
use crate::{Real, fields};

/// Farthest extrapolation, in steps of the last two loads.
const FARTHEST: f64 = 4.0;

/// The solution before the last, with its load.
pub(crate) struct Earlier<T> {
    pressure: Vec<T>,
    displacement: Vec<T>,
    /// Mean pressure; `None` while nothing is remembered.
    load: Option<f64>,
}

impl<T: Real> Earlier<T> {
    pub(crate) fn new(n: usize) -> Self {
        Self { pressure: vec![T::zero(); n], displacement: vec![T::zero(); n], load: None }
    }

    pub(crate) fn forget(&mut self) {
        self.load = None;
    }

    /// Writes a guess of the solution for `load` to two fields: `p / mean p` and `u / mean p` continue
    /// linearly in the logarithm of the load. Then remembers `last` instead. Returns whether there
    /// was enough to go by. (Quadratic extrapolation is worse: nodes come and go.)
    pub(crate) fn guess(
        &mut self,
        load: f64,
        last: &State<T>,
        [pressure, displacement]: [&mut [T]; 2],
    ) -> bool {
        let present = fields::sum(&last.pressure) / last.pressure.len() as f64;
        let steps = self.load.map(|earlier| (load / present).ln() / (present / earlier).ln());
        let usable = steps.filter(|t| t.abs() <= FARTHEST);
        if let (Some(t), Some(earlier)) = (usable, self.load) {
            let factors = [load * (1.0 + t) / present, load * t / earlier];
            continue_line(&last.pressure, &self.pressure, factors, pressure);
            continue_line(&last.displacement, &self.displacement, factors, displacement);
            for p in pressure.iter_mut() {
                *p = p.larger(T::zero());
            }
            let scale = load * pressure.len() as f64 / fields::sum(pressure);
            passes::scale(scale, pressure);
            passes::scale(scale, displacement);
        }
        self.pressure.copy_from_slice(&last.pressure);
        self.displacement.copy_from_slice(&last.displacement);
        self.load = Some(present);
        usable.is_some()
    }
}

/// `out = f0 a - f1 b`.
fn continue_line<T: Real>(a: &[T], b: &[T], factors: [f64; 2], out: &mut [T]) {
    let [f0, f1] = factors.map(T::of);
    for ((x, a), b) in out.iter_mut().zip(a).zip(b) {
        *x = f0 * *a - f1 * *b;
    }
}
