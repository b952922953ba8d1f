//! Control of the level of the flat (mean gap or approach) by a method that controls the load: a
//! secant in the logarithm of the mean pressure, kept inside a bracket, warm-started.

use crate::methods::{
    Compliance, ContactMethod, ContactTask, IterateObserver, IterateView, Outcome, RISE, Start,
    State, Target,
};
use crate::{Boundary, End, Real, certificate, fields, yield_control};

/// Iterations a method may try to control the level itself before the secant takes over.
const NATIVE_ITERATIONS: usize = 60;

/// Near full contact the rise is no more than this times the gap that is left.
const LEVELLING_OFF: f64 = 1.5;

/// Loads to try before giving up; a few are enough but for rounding.
const MAX_LOADS: usize = 100;

/// Solves `task`: by the method alone where it can, by loads where it cannot or does not succeed.
pub(crate) fn solve<T: Real>(
    method: &mut dyn ContactMethod<T>,
    task: &ContactTask<'_, T>,
    operator: &mut dyn Compliance<T>,
    start: Start,
    state: &mut State<T>,
    watch: &mut IterateObserver<'_, T>,
) -> Outcome {
    let (level, guess) = match task.target {
        Target::Pressure(_) => return method.solve(task, operator, start, state, watch),
        Target::Level(_, guess) | Target::OpenGap(_, guess) if task.ceiling.is_finite() => {
            return yield_control::solve(method, task, guess, operator, start, state, watch);
        }
        Target::Level(level, guess) | Target::OpenGap(level, guess) => (level, guess),
    };
    if !method.controls_level() {
        let before = Outcome::NOTHING;
        return by_loads(method, task, (level, guess), operator, start, state, watch, before);
    }
    let native =
        ContactTask { max_iterations: task.max_iterations.min(NATIVE_ITERATIONS), ..*task };
    let tried = method.solve(&native, operator, start, state, watch);
    if tried.end != End::Exhausted || tried.iterations >= task.max_iterations {
        return tried;
    }
    // An iterate that lost its numbers is no start.
    let is_sound =
        fields::sum(&state.pressure) > 0.0 && fields::sum(&state.displacement).is_finite();
    let start = if is_sound { Start::Warm } else { Start::Cold };
    by_loads(method, task, (level, guess), operator, start, state, watch, tried)
}

/// Solves for loads until the level is right. `before` is what has been spent already.
#[expect(clippy::too_many_arguments, reason = "those of a method, and what came before")]
fn by_loads<T: Real>(
    method: &mut dyn ContactMethod<T>,
    task: &ContactTask<'_, T>,
    (level, guess): (f64, f64),
    operator: &mut dyn Compliance<T>,
    start: Start,
    state: &mut State<T>,
    watch: &mut IterateObserver<'_, T>,
    before: Outcome,
) -> Outcome {
    let mut load = guess;
    if start == Start::Warm {
        load = fields::mean(&state.pressure);
    }
    let mut start = start;
    let (mut low, mut high) = (0.0_f64, f64::INFINITY); // loads known to be too small, too large
    let mut last: Option<(f64, f64, f64)> = None; // ln load, level reached, relative accuracy
    let mut spent = before;
    let mut accuracy: f64 = 0.1;
    let finest = 0.25 * task.tolerance; // so that the level is known better than it is asked for
    let mut last_slope: Option<f64> = None;
    let (mut damping, mut last_missing) = (1.0, 0.0);
    let mut loads = 0;
    loop {
        loads += 1;
        let sub = ContactTask {
            target: Target::Pressure(load),
            tolerance: accuracy.max(finest),
            max_iterations: task.max_iterations - spent.iterations,
            ..*task
        };
        // An iterate that fits its load is no answer yet while its level is another.
        let known_slope = last_slope;
        let mut shifted = |step: &IterateView<'_, T>| {
            let missing = known_slope.map_or(f64::INFINITY, |slope| {
                let reached = certificate::level(step.state, &task.problem.heights, task.ceiling);
                ((level - reached) / slope).abs()
            });
            watch(&IterateView {
                iteration: spent.iterations + step.iteration,
                transforms: spent.transforms + step.transforms,
                residual: step.residual.max(missing),
                state: step.state,
            })
        };
        let outcome = method.solve(&sub, operator, start, state, &mut shifted);
        start = Start::Warm;
        spent.add(&outcome);
        // The level rises with the logarithm of the load about as the mean indentation does.
        let work = fields::dot(&state.pressure, &state.displacement);
        let mut natural = RISE * (work / fields::sum(&state.pressure)).abs();
        if operator.boundary() == Boundary::Periodic {
            // Near full contact it levels off with the gap that is left.
            natural = natural.min(LEVELLING_OFF * (-level - task.problem.mean_height));
        }
        let mut slope = last_slope.unwrap_or(natural).max(f64::MIN_POSITIVE);
        if let Some((ln_load, reached, accuracy)) = last {
            // A secant between points closer than their errors would tell nothing.
            let apart = load.ln() - ln_load;
            let secant = (state.level - reached) / apart;
            let is_telling = apart.abs() > 3.0 * (accuracy + outcome.residual);
            if is_telling && secant.is_finite() && secant > 0.0 {
                slope = secant.clamp(1e-6 * natural, 4.0 * natural);
                last_slope = Some(slope);
                damping = 1.0;
            }
        }
        let missing = (level - state.level) / slope; // in ln load
        let residual = outcome.residual.max(missing.abs());
        if !matches!(outcome.end, End::Converged | End::Rounding) {
            return Outcome { end: outcome.end, residual, ..spent };
        }
        let is_exact = sub.tolerance <= finest;
        if is_exact && missing.abs() <= task.tolerance {
            let end = if residual <= task.tolerance { End::Converged } else { End::Rounding };
            return Outcome { end, residual, ..spent };
        }
        if spent.iterations >= task.max_iterations || loads >= MAX_LOADS {
            return Outcome { end: End::Exhausted, residual, ..spent };
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
        last = Some((load.ln(), state.level, outcome.residual));
        let mut next = load * (damping * missing).clamp(-2.0, 2.0).exp();
        if next <= low || next >= high {
            next = if high.is_finite() && low > 0.0 { (low * high).sqrt() } else { next };
        }
        accuracy = (0.1 * missing.abs()).min(accuracy);
        load = next;
    }
}
