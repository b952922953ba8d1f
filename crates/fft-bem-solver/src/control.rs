//! Control of the level of the flat (mean gap) by a method that controls the load: loads are tried until
//! the level is right, each from the answer before. A secant, kept inside a bracket.

use crate::methods::{
    ContactMethod, ContactTask, IterateView, Means, Outcome, RISE, Start, State, Target,
};
use crate::{End, Real, certificate, fields};

/// Iterations a method may try to control the level itself before the secant takes over.
const NATIVE_ITERATIONS: usize = 60;

/// Near full contact the rise is no more than this times the gap that is left.
const LEVELLING_OFF: f64 = 1.5;

/// Loads to try before giving up, elastic and under a ceiling; a few are enough but for rounding.
const MOST_LOADS: usize = 100;
const MOST_YIELDING: usize = 60;
/// Largest change of the logarithm of the load, or of y under a ceiling, from one load to the next.
const FARTHEST: f64 = 2.0;

/// Solves `task`: by the method alone where it can, by loads where it cannot or does not succeed.
pub(crate) fn solve<T: Real>(
    method: &mut dyn ContactMethod<T>,
    mut task: ContactTask<'_, T>,
    means: Means<'_, '_, T>,
) -> Outcome {
    let (Means { operator, state, watch }, mut spent) = (means, Outcome::NOTHING);
    let (level, guess) = match task.target {
        Target::Pressure(_) => return method.solve(&task, Means { operator, state, watch }),
        Target::OpenGap(gap, guess) => {
            let means = Means { operator, state, watch };
            return Search { method, task, means, spent }.yielding(gap, guess);
        }
        Target::Level(level, guess) => (level, guess),
    };
    if method.controls_level() {
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
    Search { method, task, means: Means { operator, state, watch }, spent }.elastic(level, guess)
}

struct Search<'a, 'w, T: Real> {
    method: &'a mut dyn ContactMethod<T>,
    task: ContactTask<'a, T>,
    means: Means<'a, 'w, T>,
    spent: Outcome,
}

impl<T: Real> Search<'_, '_, T> {
    fn first(&self, guess: f64) -> f64 {
        match self.task.start {
            Start::Warm => fields::mean(&self.means.state.pressure),
            Start::Cold => guess,
        }
    }

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

    /// By how much the level of elastic bodies rises per logarithm of the load, about: as the mean indentation does.
    fn rise(&self) -> f64 {
        let State { pressure, displacement, .. } = &*self.means.state;
        RISE * (fields::dot(pressure, displacement) / fields::sum(pressure)).abs()
    }

    /// A secant in the logarithm of the load.
    fn elastic(mut self, level: f64, guess: f64) -> Outcome {
        let task = self.task;
        let mut load = self.first(guess);
        let (mut low, mut high) = (0.0_f64, f64::INFINITY); // loads known to be too small, too large
        let mut last: Option<(f64, f64, f64)> = None; // ln load, level reached, relative accuracy
        let mut accuracy: f64 = 0.1;
        let finest = 0.25 * task.tolerance; // so that the level is known better than it is asked for
        let mut last_slope: Option<f64> = None;
        let (mut damping, mut last_missing) = (1.0, 0.0);
        let mut loads = 0;
        loop {
            loads += 1;
            let tolerance = accuracy.max(finest);
            let known_slope = last_slope;
            let outcome = self.under(load, tolerance, |state| {
                known_slope.map_or(f64::INFINITY, |slope| {
                    let reached = certificate::level(state, &task.problem.heights, task.ceiling);
                    ((level - reached) / slope).abs()
                })
            });
            // Near full contact it levels off with the gap that is left.
            let gap_left = -level - task.problem.mean_height;
            let natural = self.rise().min(LEVELLING_OFF * gap_left);
            let reached = self.means.state.level;
            let mut slope = last_slope.unwrap_or(natural).max(f64::MIN_POSITIVE);
            if let Some((ln_load, last_reached, accuracy)) = last {
                // A secant between points closer than their errors would tell nothing.
                let apart = load.ln() - ln_load;
                let secant = (reached - last_reached) / apart;
                let is_telling = apart.abs() > 3.0 * (accuracy + outcome.residual);
                if is_telling && secant.is_finite() && secant > 0.0 {
                    slope = secant.clamp(1e-6 * natural, 4.0 * natural);
                    last_slope = Some(slope);
                    damping = 1.0;
                }
            }
            let missing = (level - reached) / slope; // in ln load
            let residual = outcome.residual.max(missing.abs());
            if !matches!(outcome.end, End::Converged | End::Rounding) {
                return Outcome { end: outcome.end, residual, ..self.spent };
            }
            if tolerance <= finest && missing.abs() <= task.tolerance {
                let end = if residual <= task.tolerance { End::Converged } else { End::Rounding };
                return Outcome { end, residual, ..self.spent };
            }
            if self.spent.iterations >= task.max_iterations || loads >= MOST_LOADS {
                return Outcome { end: End::Exhausted, residual, ..self.spent };
            }
            // Only an answer clearly on one side of the target may narrow the bracket; one that leaves
            // no room for the target was a mistake.
            if missing > 2.0 * outcome.residual {
                low = low.max(load);
            } else if missing < -2.0 * outcome.residual {
                high = high.min(load);
            }
            if (high / low).ln() < 0.5 * missing.abs() {
                (low, high) = (0.0, f64::INFINITY);
            }
            // A change of sides means that the slope was underestimated.
            let is_overshoot = last_missing * missing < 0.0;
            damping = if is_overshoot { 0.7 * damping } else { damping };
            last_missing = missing;
            last = Some((load.ln(), reached, outcome.residual));
            let mut next = load * (damping * missing).clamp(-FARTHEST, FARTHEST).exp();
            if next <= low || next >= high {
                next = if high.is_finite() && low > 0.0 { (low * high).sqrt() } else { next };
            }
            accuracy = (0.1 * missing.abs()).min(accuracy);
            load = next;
        }
    }

    /// Under a ceiling H, where the open gap is prescribed. What stands at the ceiling may not be scaled, so that the
    /// iteration cannot change the load on its way. The unknown is `y = ln(P / (H - P))`, with which the gap falls.
    fn yielding(mut self, gap: f64, guess: f64) -> Outcome {
        let task = self.task;
        let h = task.ceiling;
        let load_of = |y: f64| h / (1.0 + (-y).exp());
        let y_of = |load: f64| (load / (h - load)).ln();
        let mut y = y_of(self.first(guess).clamp(1e-9 * h, 0.9 * h));
        let finest = 0.25 * task.tolerance;
        let mut accuracy: f64 = 0.05;
        let [mut low, mut high] = [f64::NEG_INFINITY, f64::INFINITY];
        let mut last: Option<[f64; 2]> = None; // y, gap
        let mut slope = None;
        for _ in 0..MOST_YIELDING {
            let load = load_of(y);
            let tolerance = accuracy.max(finest);
            let known = slope;
            let found = self.under(load, tolerance, |state| {
                known.map_or(f64::INFINITY, |slope: f64| {
                    (open_gap(&task, state) - gap).abs() / slope
                })
            });
            let reached = open_gap(&task, self.means.state);
            let natural = self.rise() * (1.0 - load / h); // the logarithm of the load changes by that per y
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

/// Mean gap under a ceiling: what overlaps there is flattened and no gap.
fn open_gap<T: Real>(task: &ContactTask<'_, T>, state: &State<T>) -> f64 {
    let (p, u, heights) = (&state.pressure, &state.displacement, &task.problem.heights);
    let level = certificate::level(state, heights, task.ceiling);
    let open = |i: usize| (u[i] - heights[i]).wide() - level;
    let top = T::of(task.ceiling);
    let gap = |i: usize| if p[i] >= top { 0.0 } else { open(i) };
    fields::sum_of(u.len(), gap) / u.len() as f64
}
