//! Control of the level of the flat (mean gap) inside the chord iteration, without a convolution:
//! `K` is linear, so that the iterate may be scaled to another load at any time.
//!
//! Two things must be known to choose the load. *Where the level will settle* under the present load: once the step
//! `z = E^T S E g` has been taken, what is left of the residual gap g is its mean over the extended field,
//! `<1, E g> = <E^T 1, g>`; `E^T 1` is nearly the pressure below a flat punch of that shape, the adjoint of the level.
//! And *how the level rises with the load*: a first guess from the work done and the gap left, refined by secants,
//! each weighed by how far its loads are apart against what the residual leaves unsure.

use crate::{Real, fields};

/// Rise of the level per logarithm of the load, in units of the mean indentation `<p, u>/<p, 1>`,
/// while most of the surface is out of contact: 0.48 to 0.67 on self-affine surfaces at loads from
/// 0.005 to 0.1 of E* times the rms gradient.
pub(crate) const RISE: f64 = 0.53;
/// Near full contact the rise falls with the gap that is left, as `sqrt(1 - exp(-this gap/rise))`,
/// to 15 % up to 90 % of contact.
const LEVELLING: f64 = 1.2;
/// Relative uncertainty of that guess.
const DOUBT: f64 = 0.15;
/// Uncertainty of a foreseen level, in the logarithm of the load, per estimated relative pressure
/// error.
const NOISE: f64 = 0.1;
/// Above this error the guess is made anew instead.
const ROUGH: f64 = 0.3;
/// Largest change of the logarithm of the load in one step.
const FARTHEST: f64 = 1.0;

pub(crate) struct LevelControl {
    target: f64,
    /// Mean gap at the target, which limits the rise.
    mean_gap: f64,
    /// Rise of the level per logarithm of the load, and its inverse relative variance.
    slope: Option<[f64; 2]>,
    /// The last level foreseen and its load.
    last: Option<[f64; 2]>,
    /// How far the level was from its target, in the logarithm of the load.
    pub(crate) error: f64,
}

impl LevelControl {
    pub(crate) fn new(mean_gap: f64, mean_height: f64) -> Self {
        let target = -mean_height - mean_gap;
        Self { target, mean_gap, slope: None, last: None, error: f64::INFINITY }
    }

    /// Guesses the rise from a pressure and its displacement, while nothing better is known.
    pub(crate) fn guess<T: Real>(&mut self, [pressure, displacement]: [&[T]; 2], residual: f64) {
        if self.slope.is_some() && residual <= ROUGH {
            return;
        }
        let indentation = fields::dot(pressure, displacement) / fields::sum(pressure);
        let rise = RISE * indentation;
        let (gap, doubt) = (self.mean_gap, DOUBT * (1.0 + 0.1 * rise / self.mean_gap));
        let slope = rise * (1.0 - (-LEVELLING * gap / rise).exp()).sqrt();
        let is_usable = slope > 0.0 && slope.is_finite();
        self.slope = is_usable.then_some([slope, doubt.powi(-2)]);
    }

    /// The factor on the load that should bring the level, foreseen at `level` under `load`, to its
    /// target. `residual` is the estimate of the last iteration.
    pub(crate) fn factor(&mut self, level: f64, load: f64, residual: f64) -> f64 {
        let last = self.last.replace([level, load]);
        let Some([slope, weight]) = &mut self.slope else {
            return 1.0; // nothing is known yet
        };
        if let Some([last_level, last_load]) = last.filter(|_| residual <= ROUGH) {
            let change = (load / last_load).ln();
            let secant = (level - last_level) / change;
            let certainty = (change / (NOISE * residual)).powi(2);
            if secant > 0.0 && certainty > 0.0 {
                let secant = secant.clamp(0.25 * *slope, 4.0 * *slope);
                // A single pixel in contact leaves no residual: its secant is all there is to know.
                *slope += (secant - *slope) / (1.0 + *weight / certainty);
                *weight += if certainty.is_finite() { certainty } else { 0.0 };
            }
        }
        self.error = (level - self.target) / *slope;
        (-self.error).clamp(-FARTHEST, FARTHEST).exp()
    }
}
