//! Control of the level of the flat (mean gap) inside an iteration: a secant in the logarithm of
//! the load, once per step, without a pair, because `K` is linear.

use super::State;
use super::passes::{self, Partial};
use crate::problem::Problem;
use crate::{Real, fields};

/// What the control remembers.
pub(crate) struct LevelControl {
    target: f64,
    mean_gap: f64,
    /// Change of the level per change of the logarithm of the load.
    slope: Option<f64>,
    last: Option<(f64, f64)>,
    /// How far the level was from its target, in the logarithm of the load.
    pub(crate) error: f64,
}

impl LevelControl {
    pub(crate) fn new<T>(target: f64, problem: &Problem<T>) -> Self {
        let mean_gap = -target - problem.mean_height; // mean u is 0
        Self { target, mean_gap, slope: None, last: None, error: f64::INFINITY }
    }

    /// Scales the state to a load that should bring the level nearer to its target; returns the
    /// factor. `residual` is the estimate of the last iteration.
    pub(crate) fn correct<T: Real>(
        &mut self,
        residual: f64,
        load: f64,
        h: &[T],
        state: &mut State<T>,
        partial: &mut [Partial],
    ) -> f64 {
        let (p, u) = (&mut state.pressure, &mut state.displacement);
        let [sum, contact] = passes::level_sums(p, u, h, partial);
        let level = sum / contact;
        // Mean indentation, or the gap that is left: near the end of a rise the level levels off.
        let natural = (0.53 * fields::dot(p, u) / fields::sum(p)).min(1.5 * self.mean_gap);
        let secant = self.last.and_then(|(last_level, last_load)| {
            let change = (load / last_load).ln();
            let secant = (level - last_level) / change;
            (change.abs() > 0.03 * residual && secant > 0.0).then_some(secant)
        });
        let slope = match (self.slope, secant) {
            (Some(slope), Some(secant)) if residual < 0.3 => {
                secant.clamp(0.25 * slope, 4.0 * slope)
            }
            (Some(slope), None) if residual < 0.3 => slope,
            _ => natural,
        };
        self.slope = Some(slope);
        self.last = Some((level, load));
        self.error = (level - self.target) / slope;
        let factor = (-self.error).clamp(-1.0, 1.0).exp();
        passes::scale(factor, p);
        passes::scale(factor, u);
        factor
    }
}
