//! The first trial on a load curve: linear extrapolation from the last two solutions.

use super::contract::State;
use super::passes;
use crate::row_work::{Partial, TASK, total};
use crate::simd::vectorised;
use crate::{Real, fields};
use grid_fft::parallel::prelude::*;

/// Farthest extrapolation, in steps of the last two loads.
const FARTHEST: f64 = 4.0;
/// Widest step in the logarithm of the load, ln 2.2: where loads are a factor of 2 apart a pair is saved, where 2.5 two more are
/// needed than from the last solution alone.
const WIDEST: f64 = 0.79;

/// The solution before the last, with its load.
pub(crate) struct Earlier<T> {
    pressure: Vec<T>,
    displacement: Vec<T>,
    /// Mean pressure; `None` while nothing is remembered.
    load: Option<f64>,
    /// Sums over the pieces of a guess.
    partial: Vec<Partial>,
}

impl<T: Real> Earlier<T> {
    pub(crate) fn new(n: usize) -> Self {
        let partial = vec![Partial::default(); n.div_ceil(TASK)];
        Self { pressure: vec![T::zero(); n], displacement: vec![T::zero(); n], load: None, partial }
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
        let is_near = (load / present).ln().abs() <= WIDEST;
        let usable = steps.filter(|t| is_near && t.abs() <= FARTHEST);
        if let (Some(t), Some(earlier)) = (usable, self.load) {
            let factors = [load * (1.0 + t) / present, load * t / earlier];
            let line = Line { factors, least: 0.0 };
            let carried =
                line.follow(&last.pressure, &mut self.pressure, pressure, &mut self.partial);
            let scale = load * pressure.len() as f64 / carried;
            passes::scale(scale, pressure);
            let line = Line { factors: factors.map(|f| scale * f), least: f64::NEG_INFINITY };
            let (from, earlier) = (&last.displacement, &mut self.displacement);
            line.follow(from, earlier, displacement, &mut self.partial);
        } else {
            passes::copy(&last.pressure, &mut self.pressure);
            passes::copy(&last.displacement, &mut self.displacement);
        }
        self.load = Some(present);
        usable.is_some()
    }
}

/// `f0 a - f1 b`, nowhere less than `least`.
struct Line {
    factors: [f64; 2],
    least: f64,
}

impl Line {
    /// Writes it, and a to b. Returns its sum.
    fn follow<T: Real>(&self, a: &[T], b: &mut [T], out: &mut [T], partial: &mut [Partial]) -> f64 {
        let ([f0, f1], least) = (self.factors.map(T::of), T::of(self.least));
        let pieces = out.par_chunks_mut(TASK).zip(a.par_chunks(TASK)).zip(b.par_chunks_mut(TASK));
        pieces.zip(partial.par_iter_mut()).for_each(|(((out, a), b), partial)| {
            vectorised!({
                for ((x, a), b) in out.iter_mut().zip(a).zip(b) {
                    *x = (f0 * *a - f1 * *b).larger(least);
                    *b = *a;
                }
            });
            partial[0] = fields::sum(out);
        });
        let [sum] = total(partial);
        sum
    }
}
