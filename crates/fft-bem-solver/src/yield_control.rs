//! Control of the level of the flat, or of the open gap, under a ceiling of the pressure: loads are tried
//! until it is right, each from the answer before.
//!
//! What stands at the ceiling may not be scaled, so that the iteration cannot change the load on its way. The unknown
//! is `y = ln(P / (H - P))`; the level rises with it, the open gap falls. A secant, kept inside a bracket.

use crate::methods::{
    Compliance, ContactMethod, ContactTask, IterateObserver, IterateView, Outcome, RISE, Start,
    State, Target,
};
use crate::problem::Problem;
use crate::{End, Real, certificate, fields};

/// Loads to try before giving up.
const MOST_LOADS: usize = 60;
/// Largest change of y from one load to the next.
const FARTHEST: f64 = 2.0;

/// Mean gap: what overlaps at the ceiling is flattened and no gap.
fn open_gap<T: Real>(state: &State<T>, heights: &[T], level: f64, ceiling: f64) -> f64 {
    let (p, u) = (&state.pressure, &state.displacement);
    let open = |i: usize| (u[i] - heights[i]).wide() - level;
    let top = T::of(ceiling);
    let gap = |i: usize| if p[i] >= top { 0.0 } else { open(i) };
    fields::sum_of(u.len(), gap) / u.len() as f64
}

/// How far a state has come, and how far it should: both rise with the load.
fn progress<T: Real>(task: &ContactTask<'_, T>, state: &State<T>) -> [f64; 2] {
    let Problem { heights, .. } = task.problem;
    let level = certificate::level(state, heights, task.ceiling);
    match task.target {
        Target::OpenGap(gap, _) => [-open_gap(state, heights, level, task.ceiling), -gap],
        Target::Level(target, _) => [level, target],
        Target::Pressure(_) => [0.0; 2], // which needs no control
    }
}

/// Solves `task` by loads.
pub(crate) fn solve<T: Real>(
    method: &mut dyn ContactMethod<T>,
    task: &ContactTask<'_, T>,
    guess: f64,
    operator: &mut dyn Compliance<T>,
    start: Start,
    state: &mut State<T>,
    watch: &mut IterateObserver<'_, T>,
) -> Outcome {
    let h = task.ceiling;
    let load_of = |y: f64| h / (1.0 + (-y).exp());
    let y_of = |load: f64| (load / (h - load)).ln();
    let first = match start {
        Start::Warm => fields::mean(&state.pressure),
        Start::Cold => guess,
    };
    let mut y = y_of(first.clamp(1e-9 * h, 0.9 * h));
    let mut start = start;
    let finest = 0.25 * task.tolerance;
    let mut accuracy: f64 = 0.05;
    let [mut low, mut high] = [f64::NEG_INFINITY, f64::INFINITY];
    let mut last: Option<[f64; 2]> = None; // y, progress
    let mut slope = None;
    let mut all = Outcome::NOTHING;
    for _ in 0..MOST_LOADS {
        let load = load_of(y);
        let sub = ContactTask {
            target: Target::Pressure(load),
            tolerance: accuracy.max(finest),
            max_iterations: task.max_iterations - all.iterations,
            ..*task
        };
        let (before, known) = (all, slope);
        let mut shown = |step: &IterateView<'_, T>| {
            let missing = known.map_or(f64::INFINITY, |slope: f64| {
                let [reached, target] = progress(task, step.state);
                (target - reached).abs() / slope
            });
            watch(&IterateView {
                iteration: before.iterations + step.iteration,
                transforms: before.transforms + step.transforms,
                residual: step.residual.max(missing),
                state: step.state,
            })
        };
        let found = method.solve(&sub, operator, start, state, &mut shown);
        start = Start::Warm;
        all.add(&found);
        let [reached, target] = progress(task, state);
        // Elastic bodies rise by so much per logarithm of the load, which changes by 1 - P/H per y.
        let indentation =
            fields::dot(&state.pressure, &state.displacement) / fields::sum(&state.pressure);
        let natural = RISE * indentation.abs() * (1.0 - load / h);
        let secant = last.map(|[y0, reached0]| (reached - reached0) / (y - y0));
        let rise = secant.filter(|s| *s > 0.0 && s.is_finite()).or(slope).unwrap_or(natural);
        let rise = rise.max(1e-6 * natural).max(f64::MIN_POSITIVE);
        slope = Some(rise);
        let missing = (target - reached) / rise;
        let in_load = missing.abs() * (1.0 - load / h);
        all.residual = found.residual.max(in_load);
        all.end = found.end;
        if !matches!(found.end, End::Converged | End::Rounding) {
            return all;
        }
        if sub.tolerance <= finest && in_load <= task.tolerance {
            all.end = if all.residual <= task.tolerance { End::Converged } else { End::Rounding };
            return all;
        }
        all.end = End::Exhausted;
        if all.iterations >= task.max_iterations {
            return all;
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
    all
}
