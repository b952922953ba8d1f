//! Control of the level of the flat (mean gap) by a method that controls the load: loads are tried until
//! the level is right, each from the answer before. A secant, kept inside a bracket.

use crate::methods::{
    ContactMethod, ContactTask, IterateView, Means, Outcome, RISE, Start, State, Target,
};
use crate::{End, Real, certificate, fields};

/// Iterations a method may try to control the level itself before the secant takes over.
const NATIVE_ITERATIONS: usize = 60;

/// Loads to try before giving up; a few are enough but for rounding.
const MOST_LOADS: usize = 60;
/// Largest change of y from one load to the next.
const FARTHEST: f64 = 2.0;

/// Solves `task`: by the method alone where it can, by loads where it cannot or does not succeed.
pub(crate) fn solve<T: Real>(
    method: &mut dyn ContactMethod<T>,
    mut task: ContactTask<'_, T>,
    means: Means<'_, '_, T>,
) -> Outcome {
    let (Means { operator, state, watch }, mut spent) = (means, Outcome::NOTHING);
    let Target::Gap(gap, guess) = task.target else {
        return method.solve(&task, Means { operator, state, watch });
    };
    if method.controls_level() && task.ceiling.is_infinite() {
        let most = task.max_iterations.min(NATIVE_ITERATIONS);
        let native = ContactTask { max_iterations: most, ..task };
        spent = method.solve(&native, Means { operator, state, watch });
        if spent.end != End::Exhausted || spent.iterations >= task.max_iterations {
            return spent;
        }
        // An iterate that lost its numbers is no start.
        let is_sound =
            fields::sum(&state.pressure) > 0.0 && fields::sum(&state.displacement).is_finite();
        task.start = if is_sound { Start::Warm } else { Start::Cold };
    }
    Search { method, task, means: Means { operator, state, watch }, spent }.run(gap, guess)
}

struct Search<'a, 'w, T: Real> {
    method: &'a mut dyn ContactMethod<T>,
    task: ContactTask<'a, T>,
    means: Means<'a, 'w, T>,
    spent: Outcome,
}

impl<T: Real> Search<'_, '_, T> {
    /// Solves for one load. An iterate that fits its load is no answer yet while its level is another: observers see
    /// what is still `missing`.
    fn under(
        &mut self,
        load: f64,
        tolerance: f64,
        missing: impl Fn(&State<T>) -> f64 + Sync,
    ) -> Outcome {
        let before = self.spent;
        let sub = ContactTask {
            target: Target::Pressure(load),
            tolerance,
            max_iterations: self.task.max_iterations - before.iterations,
            ends_on_trial: false,
            ..self.task
        };
        let Means { operator, state, watch } = &mut self.means;
        let mut shown = |step: &IterateView<'_, T>| {
            watch(&IterateView {
                iteration: before.iterations + step.iteration,
                transforms: before.transforms + step.transforms,
                residual: step.residual.max(missing(step.state)),
                state: step.state,
            })
        };
        let means = Means { operator: *operator, state, watch: &mut shown };
        let found = self.method.solve(&sub, means);
        self.task.start = Start::Warm;
        self.spent.add(&found);
        found
    }

    /// A secant in `y = -ln(1/P - 1/H)`, with which the gap falls; `ln P` without a ceiling.
    fn run(mut self, gap: f64, guess: f64) -> Outcome {
        let task = self.task;
        let h = task.ceiling;
        let load_of = |y: f64| 1.0 / (1.0 / h + (-y).exp());
        let y_of = |load: f64| -(1.0 / load - 1.0 / h).ln();
        let first = match task.start {
            Start::Warm => fields::mean(&self.means.state.pressure),
            Start::Cold => guess,
        };
        let mut y = y_of(first.min(0.9 * h));
        let finest = 0.25 * task.tolerance;
        let mut accuracy: f64 = 0.05;
        let [mut low, mut high] = [f64::NEG_INFINITY, f64::INFINITY];
        let mut last: Option<[f64; 2]> = None; // y, gap
        let mut slope = None;
        for _ in 0..MOST_LOADS {
            let load = load_of(y);
            let tolerance = accuracy.max(finest);
            let known = slope;
            let found = self.under(load, tolerance, |state| {
                known.map_or(f64::INFINITY, |slope: f64| {
                    (open_gap(&task, state) - gap).abs() / slope
                })
            });
            let reached = open_gap(&task, self.means.state);
            let State { pressure, displacement, .. } = &*self.means.state;
            let indentation = fields::dot(pressure, displacement) / fields::sum(pressure);
            let natural = RISE * indentation.abs() * (1.0 - load / h); // d ln P / dy = 1 - P/H
            let secant = last.map(|[y0, reached0]| (reached0 - reached) / (y - y0));
            let rise = secant.filter(|s| *s > 0.0 && s.is_finite()).or(slope).unwrap_or(natural);
            let rise = rise.max(1e-6 * natural).max(f64::MIN_POSITIVE);
            slope = Some(rise);
            let missing = (reached - gap) / rise;
            let in_load = missing.abs() * (1.0 - load / h);
            self.spent.residual = found.residual.max(in_load);
            self.spent.end = found.end;
            if !matches!(found.end, End::Converged | End::Rounding) {
                return self.spent;
            }
            if tolerance <= finest && in_load <= task.tolerance {
                let is_good = self.spent.residual <= task.tolerance;
                self.spent.end = if is_good { End::Converged } else { End::Rounding };
                return self.spent;
            }
            self.spent.end = End::Exhausted;
            if self.spent.iterations >= task.max_iterations {
                return self.spent;
            }
            // Only an answer clearly on one side may narrow the bracket.
            if missing > 2.0 * found.residual {
                low = y;
            } else if missing < -2.0 * found.residual {
                high = y;
            }
            if low >= high {
                [low, high] = [f64::NEG_INFINITY, f64::INFINITY];
            }
            // Points closer than their errors make no secant.
            if last.is_none_or(|[y0, _]| (y - y0).abs() > found.residual) {
                last = Some([y, reached]);
            }
            accuracy = accuracy.min(0.1 * in_load);
            let next = y + missing.clamp(-FARTHEST, FARTHEST);
            let is_inside = next > low && next < high;
            y = if is_inside || !(low + high).is_finite() { next } else { 0.5 * (low + high) };
        }
        self.spent
    }
}

/// Mean gap: what overlaps under a ceiling is flattened and no gap.
fn open_gap<T: Real>(task: &ContactTask<'_, T>, state: &State<T>) -> f64 {
    let (p, u, heights) = (&state.pressure, &state.displacement, &task.problem.heights);
    let level = certificate::level(state, heights, task.ceiling);
    let open = |i: usize| u[i].wide() - heights[i].wide() - level;
    let top = T::of(task.ceiling);
    let gap = |i: usize| if p[i] >= top { 0.0 } else { open(i) };
    fields::sum_of(u.len(), gap) / u.len() as f64
}
