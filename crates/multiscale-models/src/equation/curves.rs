//! What a map tells the equation.

use crate::special::erf_inv;
use contact_types::{ModelError, require};
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_4, SQRT_2, TAU};

const MODEL: &str = "equation";

/// Levels of the curves over the highest part: parts `2^(-k/2)` of the map.
pub const CURVE_KNOTS: usize = 23;
/// Shares of the map at which the size of the full-contact pressure is given: (k + ½)/20.
pub const SHARE_KNOTS: usize = 20;
/// Values below this part of their unit count as it: cliffs and flats have no logarithm.
const LEAST: f64 = 0.01;
/// The same of a pressure over that of a Gaussian surface with the correlation 2.
const LEAST_PRESSURE: f64 = 0.02;

/// Curves over the highest parts of a map, the distribution of its full-contact pressure, and the ratio of
/// slopes across and along its lay (`surface_stats::ContactCurves`, `DirectionalMoments`).
#[derive(Debug, Clone, PartialEq)]
pub struct MapCurves {
    /// `ln s` at the parts `2^(-k/2)`.
    slope: [f64; CURVE_KNOTS],
    /// `ln` of mean over rms gradient, less that of an isotropic Gaussian surface.
    evenness: [f64; CURVE_KNOTS],
    /// `ln` of the gradient by central over single differences, less that of the whole map.
    resolved: [f64; CURVE_KNOTS],
    pressure: [f64; CURVE_KNOTS],
    /// How the pressure of the highest parts departs from that of a Gaussian surface.
    unlike: f64,
    /// `ln` of the quantiles over those of a Gaussian surface.
    flattened: [f64; SHARE_KNOTS],
    log_ratio: f64,
    /// Factor of the interval's half width.
    wider: f64,
}

impl MapCurves {
    /// From, over the highest `2^(-k/2)` of the map, k = 0 to 22: the rms gradient over that of all, by central
    /// differences; the mean over the rms gradient, by single ones; the rms gradient by central over that by single
    /// differences; the mean full-contact pressure over E\* g; the quantiles of its size at the shares
    /// (k + ½)/20; and the ratio of the rms slopes across and along the lay, 1 for none. All without units.
    ///
    /// Parts without any slope count as a hundredth, ratios above 10 as 10, pressures beyond 5 E\* g as 5.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] for a slope or a quantile that is negative, a ratio that is not positive,
    /// anything that is not finite.
    pub fn new(
        slope: [f64; CURVE_KNOTS],
        evenness: [f64; CURVE_KNOTS],
        resolved: [f64; CURVE_KNOTS],
        pressure: [f64; CURVE_KNOTS],
        flattened: [f64; SHARE_KNOTS],
        ratio: f64,
    ) -> Result<Self, ModelError> {
        let even = 0.5 * FRAC_PI_4.ln();
        let mut curves = Self::gaussian(0.0);
        for k in 0..CURVE_KNOTS {
            curves.slope[k] = log("slope of the highest part", slope[k])?;
            curves.evenness[k] = log("evenness of the highest part", evenness[k])? - even;
            curves.resolved[k] = log("resolution of the highest part", resolved[k])?;
            let here = require::finite(MODEL, "pressure of the highest part", pressure[k])?;
            curves.pressure[k] = here.clamp(-5.0, 5.0);
        }
        let whole = curves.resolved[0];
        curves.resolved = curves.resolved.map(|here| here - whole);
        curves.unlike = unlike(&curves.pressure);
        for (k, of) in curves.flattened.iter_mut().enumerate() {
            let usual = FRAC_1_SQRT_2 * erf_inv(share(k));
            *of = log("full-contact pressure", flattened[k] / usual)?;
        }
        let ratio =
            if ratio > 10.0 { 10.0 } else { require::positive(MODEL, "ratio of slopes", ratio)? };
        curves.log_ratio = ratio.max(1.0 / ratio).ln();
        Ok(curves)
    }

    /// An isotropic Gaussian surface without end, with this correlation of height and full-contact pressure,
    /// m₁/(m₀ m₂)^½ of the moments of its profile: about 0.8 to 0.3 for bandwidths from 2 to 100.
    pub fn gaussian(correlation: f64) -> Self {
        let pressure = std::array::from_fn(|k| 0.5 * correlation * mean_of_highest(k));
        Self {
            slope: [0.0; CURVE_KNOTS],
            evenness: [0.0; CURVE_KNOTS],
            resolved: [0.0; CURVE_KNOTS],
            pressure,
            unlike: 0.0,
            flattened: [0.0; SHARE_KNOTS],
            log_ratio: 0.0,
            wider: 1.0,
        }
    }

    /// The same of a map that does not repeat: its seam, its spikes and waves too short for its points are in no
    /// map that the law was fitted on. The interval is twice as wide; of 15 maps of instruments it then holds
    /// 96 of 100 cases, of those 83 without.
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

    /// Mean full-contact pressure over E\* g there.
    pub(super) fn pressure(&self, part: f64) -> f64 {
        over(&self.pressure, part)
    }

    /// `ln` of the full-contact pressure that `part` of the map stays below, over that of a Gaussian surface:
    /// linear between the shares, constant beyond.
    pub(super) fn log_flattened(&self, part: f64) -> f64 {
        let place = (SHARE_KNOTS as f64 * part - 0.5).clamp(0.0, (SHARE_KNOTS - 1) as f64);
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

    /// Logarithm of the ratio of slopes.
    pub(super) fn log_ratio(&self) -> f64 {
        self.log_ratio
    }
}

/// Mean of the highest `2^(-k/2)` of a normal distribution: its density at the level, over the part.
fn mean_of_highest(k: usize) -> f64 {
    if k == 0 {
        return 0.0;
    }
    let part = 0.5f64.powf(0.5 * k as f64);
    let side = 1.0 - 2.0 * part;
    let z = SQRT_2 * erf_inv(side.abs()).copysign(side);
    (-0.5 * z * z).exp() / TAU.sqrt() / part
}

/// Standard deviation of the logarithm of the pressure over that of a Gaussian surface.
fn unlike(pressure: &[f64; CURVE_KNOTS]) -> f64 {
    const DOWN_TO: usize = 14;
    let logs: [f64; DOWN_TO] = std::array::from_fn(|k| {
        (pressure[k + 1] / mean_of_highest(k + 1)).max(LEAST_PRESSURE).ln()
    });
    let mean = logs.iter().sum::<f64>() / DOWN_TO as f64;
    (logs.iter().map(|l| (l - mean).powi(2)).sum::<f64>() / DOWN_TO as f64).sqrt()
}

fn share(k: usize) -> f64 {
    (k as f64 + 0.5) / SHARE_KNOTS as f64
}

fn log(what: &'static str, value: f64) -> Result<f64, ModelError> {
    Ok(require::not_negative(MODEL, what, value)?.max(LEAST).ln())
}

/// Linear in the logarithm of the part between the knots, constant below the last.
fn over(curve: &[f64; CURVE_KNOTS], part: f64) -> f64 {
    between(curve, (-2.0 * part.log2()).clamp(0.0, (CURVE_KNOTS - 1) as f64))
}

fn between(values: &[f64], place: f64) -> f64 {
    let k = (place as usize).min(values.len() - 2);
    let t = place - k as f64;
    values[k] * (1.0 - t) + values[k + 1] * t
}
