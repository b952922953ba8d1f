//! What a map tells the equation.

use crate::special::{erf, erf_inv};
use contact_types::{CURVE_LEVELS, CURVE_SHARES, ContactCurves, ModelError, PartCurve, require};
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_4, SQRT_2, TAU};

const MODEL: &str = "equation";

/// Values below this part of their unit count as it: cliffs and flats have no logarithm.
const LEAST: f64 = 0.01;
/// The same of a pressure over that of a Gaussian surface with the correlation 2.
const LEAST_PRESSURE: f64 = 0.02;

/// Bounds of what has none of its own: a mean over an rms lies within 1, curvatures do not where they cancel out.
const DIFFERENCE: [f64; 2] = [0.0, 5.0];
const PRODUCT: [f64; 2] = [-5.0, 0.25];
const EVEN: [f64; 2] = [-1.0, 1.0];

/// What the equation takes of a map: its [`ContactCurves`] and the ratio of slopes across and along its lay.
#[derive(Debug, Clone, PartialEq)]
pub struct MapCurves {
    /// `ln s` at the parts `2^(-k/2)`.
    slope: PartCurve,
    /// `ln` of mean over rms gradient, less that of an isotropic Gaussian surface.
    evenness: PartCurve,
    /// `ln` of the gradient by central over single differences, less that of the whole map.
    resolved: PartCurve,
    pressure_evenness: PartCurve,
    pressed: PartCurve,
    /// `ln` of the gradient where it is pressed, over that of the map.
    pressed_slope: PartCurve,
    curvature_evenness: PartCurve,
    curvature_difference: PartCurve,
    curvature_product: PartCurve,
    level: PartCurve,
    /// How the pressure of the highest parts departs from that of a Gaussian surface.
    unlike: f64,
    /// `ln` of the quantiles over those of a Gaussian surface.
    flattened: [f64; CURVE_SHARES],
    /// Factor of the interval's half width.
    wider: f64,
}

impl MapCurves {
    /// Parts without any slope count as a hundredth, pressures beyond 5 E\* g as 5.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] for a slope, an evenness of slopes or a quantile that is negative, anything that is not
    /// finite.
    pub fn new(curves: &ContactCurves) -> Result<Self, ModelError> {
        let even = 0.5 * FRAC_PI_4.ln();
        let mut pressure = [0.0; CURVE_LEVELS];
        let mut found = Self::gaussian([0.0; 2]);
        for k in 0..CURVE_LEVELS {
            found.slope[k] = log("slope of the highest part", curves.slope[k])?;
            found.evenness[k] = log("evenness of the highest part", curves.evenness[k])? - even;
            found.resolved[k] = log("resolution of the highest part", curves.resolved[k])?;
            found.pressed_slope[k] = log("slope where pressed", curves.pressed_slope[k])?;
            let within = |what, value, [low, high]: [f64; 2]| {
                Ok::<f64, ModelError>(require::finite(MODEL, what, value)?.clamp(low, high))
            };
            pressure[k] = within("pressure of the highest part", curves.pressure[k], [-5.0, 5.0])?;
            found.pressure_evenness[k] =
                within("evenness of the pressure", curves.pressure_evenness[k], EVEN)?;
            found.pressed[k] = within("share pressed", curves.pressed[k], [0.0, 1.0])?;
            found.curvature_evenness[k] =
                within("evenness of the curvature", curves.curvature_evenness[k], EVEN)?;
            found.curvature_difference[k] =
                within("difference of curvatures", curves.curvature_difference[k], DIFFERENCE)?;
            found.curvature_product[k] =
                within("product of curvatures", curves.curvature_product[k], PRODUCT)?;
            found.level[k] = within("share without slope", curves.level[k], [0.0, 1.0])?;
        }
        let whole = found.resolved[0];
        found.resolved = found.resolved.map(|here| here - whole);
        found.unlike = unlike(&pressure);
        for (k, of) in found.flattened.iter_mut().enumerate() {
            let usual = FRAC_1_SQRT_2 * erf_inv(share(k));
            *of = log("full-contact pressure", curves.flattened[k] / usual)?;
        }
        Ok(found)
    }

    /// An isotropic Gaussian surface without end, with these correlations of its height: with the full-contact pressure,
    /// m₁/(m₀ m₂)^½ of the moments of its profile (about 0.8 to 0.3 for bandwidths α from 2 to 100), and with the sum of its
    /// curvatures, (3/(2α))^½.
    pub fn gaussian([pressure, curvature]: [f64; 2]) -> Self {
        // Of a field with the correlation c, in units of its own deviation: where the height is z it is c z in the mean, and
        // deviates from that by 1 - c².
        let square = |c: f64, k: usize| 1.0 + c * c * (square_of_highest(k) - 1.0);
        let even = |c: f64, k: usize| c * mean_of_highest(k) / square(c, k).sqrt();
        let at = |value: &dyn Fn(usize) -> f64| -> PartCurve { std::array::from_fn(value) };
        Self {
            slope: [0.0; CURVE_LEVELS],
            evenness: [0.0; CURVE_LEVELS],
            resolved: [0.0; CURVE_LEVELS],
            pressure_evenness: at(&|k| even(pressure, k)),
            pressed: at(&|k| positive_of_highest(pressure, k)),
            pressed_slope: [0.0; CURVE_LEVELS],
            curvature_evenness: at(&|k| even(curvature, k)),
            curvature_difference: at(&|k| 1.0 / square(curvature, k).sqrt()),
            curvature_product: at(&|k| 0.25 * (square(curvature, k) - 1.0) / square(curvature, k)),
            level: [0.0; CURVE_LEVELS],
            unlike: 0.0,
            flattened: [0.0; CURVE_SHARES],
            wider: 1.0,
        }
    }

    /// The same of a map that does not repeat: its seam, its spikes and waves too short for its points are in no
    /// map that the law was fitted on. The interval is twice as wide, which was fixed for an
    /// earlier law; of 15 maps of instruments it then holds all 225 cases.
    #[must_use]
    pub fn measured(self) -> Self {
        Self { wider: 2.0, ..self }
    }

    /// Factor of the interval's half width.
    pub(super) fn wider(&self) -> f64 {
        self.wider
    }

    /// `ln s` over the highest `part`.
    pub(super) fn log_slope(&self, part: f64) -> f64 {
        over(&self.slope, part)
    }

    /// `ln` of the mean over the rms gradient there.
    pub(super) fn log_evenness(&self, part: f64) -> f64 {
        over(&self.evenness, part)
    }

    /// Mean over rms full-contact pressure there.
    pub(super) fn pressure_evenness(&self, part: f64) -> f64 {
        over(&self.pressure_evenness, part)
    }

    /// Share of it whose full-contact pressure is positive.
    pub(super) fn pressed(&self, part: f64) -> f64 {
        over(&self.pressed, part)
    }

    /// `ln` of the rms gradient there over that of the map.
    pub(super) fn log_pressed_slope(&self, part: f64) -> f64 {
        over(&self.pressed_slope, part)
    }

    /// Mean over rms of the sum of the principal curvatures.
    pub(super) fn curvature_evenness(&self, part: f64) -> f64 {
        over(&self.curvature_evenness, part)
    }

    /// Rms of their difference over that of their sum.
    pub(super) fn curvature_difference(&self, part: f64) -> f64 {
        over(&self.curvature_difference, part)
    }

    /// Share of it without any slope.
    pub(super) fn level(&self, part: f64) -> f64 {
        over(&self.level, part)
    }

    /// Mean of their product over the mean square of their sum.
    pub(super) fn curvature_product(&self, part: f64) -> f64 {
        over(&self.curvature_product, part)
    }

    /// `ln` of the full-contact pressure that `part` of the map stays below, over that of a Gaussian surface:
    /// linear between the shares, constant beyond.
    pub(super) fn log_flattened(&self, part: f64) -> f64 {
        let place = (CURVE_SHARES as f64 * part - 0.5).clamp(0.0, (CURVE_SHARES - 1) as f64);
        between(&self.flattened, place)
    }

    /// `ln` of the gradient by central over single differences there, less that of the whole map: below 0 where the
    /// highest part is less resolved.
    pub(super) fn log_resolved(&self, part: f64) -> f64 {
        over(&self.resolved, part)
    }

    /// How the full-contact pressure of the highest parts, down to 1/128, departs from a Gaussian surface's, whatever
    /// its correlation with the height.
    pub(super) fn unlike(&self) -> f64 {
        self.unlike
    }
}

/// Level above which a normal distribution has `2^(-k/2)`, k above 0.
fn level(k: usize) -> f64 {
    let side = 1.0 - 2.0 * 0.5f64.powf(0.5 * k as f64);
    SQRT_2 * erf_inv(side.abs()).copysign(side)
}

/// Mean of the highest `2^(-k/2)` of a normal distribution: its density at the level, over the part.
fn mean_of_highest(k: usize) -> f64 {
    if k == 0 {
        return 0.0;
    }
    (-0.5 * level(k).powi(2)).exp() / TAU.sqrt() / 0.5f64.powf(0.5 * k as f64)
}

/// Mean square of the same.
fn square_of_highest(k: usize) -> f64 {
    if k == 0 { 1.0 } else { 1.0 + level(k) * mean_of_highest(k) }
}

/// Share of the highest `2^(-k/2)` of a normal distribution where another one, with the correlation `c`, is positive: the
/// mean of its probability, erf by erf, over equal parts of the part.
fn positive_of_highest(c: f64, k: usize) -> f64 {
    const POINTS: usize = 64;
    let part = 0.5f64.powf(0.5 * k as f64);
    let steep = c / (1.0 - c * c).sqrt();
    let one = |i: usize| {
        let side = 1.0 - 2.0 * part * (i as f64 + 0.5) / POINTS as f64;
        let over_root_two = erf_inv(side.abs()).copysign(side);
        0.5 + 0.5 * erf(steep * over_root_two)
    };
    (0..POINTS).map(one).sum::<f64>() / POINTS as f64
}

/// Standard deviation of the logarithm of the pressure over that of a Gaussian surface.
fn unlike(pressure: &PartCurve) -> f64 {
    const DOWN_TO: usize = 14;
    let logs: [f64; DOWN_TO] = std::array::from_fn(|k| {
        (pressure[k + 1] / mean_of_highest(k + 1)).max(LEAST_PRESSURE).ln()
    });
    let mean = logs.iter().sum::<f64>() / DOWN_TO as f64;
    (logs.iter().map(|l| (l - mean).powi(2)).sum::<f64>() / DOWN_TO as f64).sqrt()
}

fn share(k: usize) -> f64 {
    (k as f64 + 0.5) / CURVE_SHARES as f64
}

fn log(what: &'static str, value: f64) -> Result<f64, ModelError> {
    Ok(require::not_negative(MODEL, what, value)?.max(LEAST).ln())
}

/// Linear in the logarithm of the part between the knots, constant below the last.
fn over(curve: &PartCurve, part: f64) -> f64 {
    between(curve, (-2.0 * part.log2()).clamp(0.0, (CURVE_LEVELS - 1) as f64))
}

fn between(values: &[f64], place: f64) -> f64 {
    let k = (place as usize).min(values.len() - 2);
    let t = place - k as f64;
    values[k] * (1.0 - t) + values[k + 1] * t
}
