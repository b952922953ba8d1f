//! Control of the level of the flat (mean gap or approach) by a method that controls the load: a
//! secant in the logarithm of the mean pressure, kept inside a bracket, warm-started.

use crate::methods::{
    Compliance, ContactMethod, End, Outcome, Start, State, Step, Target, Task, Watch,
};
use crate::{Real, fields};

/// Solves `task`, whose target is a level, by solving for loads.
pub(crate) fn solve_level<T: Real>(
    method: &mut dyn ContactMethod<T>,
    task: &Task<'_, T>,
    operator: &mut dyn Compliance<T>,
    start: Start,
    state: &mut State<T>,
    watch: &mut Watch<'_, T>,
) -> Outcome {
    let Target::Level(level, guess) = task.target else {
        return method.solve(task, operator, start, state, watch);
    };
    let mut load = guess;
    if start == Start::Warm {
        load = fields::sum(&state.pressure) / state.pressure.len() as f64;
    }
    let mut start = start;
    let (mut low, mut high) = (0.0_f64, f64::INFINITY); // loads known to be too small, too large
    let mut last: Option<(f64, f64, f64)> = None; // ln load, level reached, relative accuracy
    let (mut iterations, mut transforms) = (0, 0.0);
    let mut accuracy: f64 = 0.1;
    loop {
        let sub = Task {
            problem: task.problem,
            target: Target::Pressure(load),
            tolerance: accuracy.max(task.tolerance),
            max_iterations: task.max_iterations - iterations,
        };
        let mut shifted = |step: &Step<'_, T>| {
            watch(&Step {
                iteration: iterations + step.iteration,
                transforms: transforms + step.transforms,
                residual: step.residual.max(0.1 * accuracy.min(step.residual)),
                state: step.state,
            })
        };
        let outcome = method.solve(&sub, operator, start, state, &mut shifted);
        start = Start::Warm;
        iterations += outcome.iterations;
        transforms += outcome.transforms;
        // The level rises with the logarithm of the load about as the mean indentation does.
        let work = fields::dot(&state.pressure, &state.displacement);
        let natural = 0.53 * (work / fields::sum(&state.pressure)).abs();
        let mut slope = natural.max(f64::MIN_POSITIVE);
        if let Some((ln_load, reached, accuracy)) = last {
            // A secant between points closer than their errors would tell nothing.
            let apart = load.ln() - ln_load;
            let secant = (state.level - reached) / apart;
            let is_telling = apart.abs() > 3.0 * (accuracy + outcome.residual);
            if is_telling && secant.is_finite() && secant > 0.0 {
                slope = secant.clamp(slope * 1e-6, 4.0 * slope);
            }
        }
        let missing = (level - state.level) / slope; // in ln load
        let residual = outcome.residual.max(missing.abs());
        if outcome.end != End::Converged {
            return Outcome { end: outcome.end, iterations, transforms, residual };
        }
        let is_exact = sub.tolerance <= task.tolerance;
        if is_exact && missing.abs() <= 0.5 * task.tolerance {
            return Outcome { end: End::Converged, iterations, transforms, residual };
        }
        if iterations >= task.max_iterations {
            return Outcome { end: End::Exhausted, iterations, transforms, residual };
        }
        // Only an answer clearly on one side of the target may narrow the bracket.
        if missing > 2.0 * outcome.residual {
            low = low.max(load);
        } else if missing < -2.0 * outcome.residual {
            high = high.min(load);
        }
        last = Some((load.ln(), state.level, outcome.residual));
        let mut next = load * missing.clamp(-2.0, 2.0).exp();
        if next <= low || next >= high {
            next = if high.is_finite() && low > 0.0 { (low * high).sqrt() } else { next };
        }
        accuracy = (0.1 * missing.abs()).min(accuracy);
        load = next;
    }
}
