//! What a map tells the equation.

use contact_types::{ModelError, require};

const MODEL: &str = "equation";

/// Levels at which the slope of the highest part is given: parts `2^(-k/2)` of the map.
pub const SLOPE_KNOTS: usize = 23;

/// Slopes of the highest parts of a map, and the ratio of slopes across and along its lay.
#[derive(Debug, Clone, PartialEq)]
pub struct MapSlopes {
    /// `ln s` at the parts `2^(-k/2)`.
    logs: [f64; SLOPE_KNOTS],
    ratio: f64,
    kurtosis: f64,
}

impl MapSlopes {
    /// From the rms gradient over the highest `2^(-k/2)` of the map over that of all, k = 0 to 22
    /// (`surface_stats::slope_curve`), and the ratio of the rms slopes across and along the lay, 1 for none \[-\], and
    /// the kurtosis of the heights, 3 for Gaussian ones \[-\].
    ///
    /// Parts without any slope count as a hundredth; ratios above 10 as 10; a kurtosis outside 1.5 to 15 as
    /// the nearer of these.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] for a slope that is negative or not finite, or a ratio or
    /// kurtosis that is not positive.
    pub fn new(highest: [f64; SLOPE_KNOTS], ratio: f64, kurtosis: f64) -> Result<Self, ModelError> {
        let mut logs = [0.0; SLOPE_KNOTS];
        for (log, s) in logs.iter_mut().zip(highest) {
            *log = require::not_negative(MODEL, "slope of the highest part", s)?.max(0.01).ln();
        }
        let ratio =
            if ratio > 10.0 { 10.0 } else { require::positive(MODEL, "ratio of slopes", ratio)? };
        let kurtosis = require::positive(MODEL, "kurtosis", kurtosis)?.clamp(1.5, 15.0);
        Ok(Self { logs, ratio: ratio.max(1.0 / ratio), kurtosis })
    }

    /// A surface whose highest parts are like the rest, without a lay.
    pub fn plain() -> Self {
        Self { logs: [0.0; SLOPE_KNOTS], ratio: 1.0, kurtosis: 3.0 }
    }

    /// `ln s` over the highest `part`, linear in the logarithm between the knots, constant below the last.
    pub(super) fn log_slope(&self, part: f64) -> f64 {
        let last = (SLOPE_KNOTS - 1) as f64;
        let place = (-2.0 * part.log2()).clamp(0.0, last);
        let k = (place as usize).min(SLOPE_KNOTS - 2);
        let t = place - k as f64;
        self.logs[k] * (1.0 - t) + self.logs[k + 1] * t
    }

    /// The same for the lowest `1 - part`: what is left of the mean square; at least e^-3.5.
    pub(super) fn log_slope_below(&self, part: f64) -> f64 {
        let part = part.clamp(1e-9, 0.98);
        let square = (2.0 * self.log_slope(part)).exp();
        0.5 * ((1.0 - part * square) / (1.0 - part)).max(1e-3).ln()
    }

    /// Logarithm of the kurtosis over that of Gaussian heights.
    pub(super) fn log_kurtosis(&self) -> f64 {
        (self.kurtosis / 3.0).ln()
    }

    /// How unlike the highest parts are to the whole: the rms of `ln s` down to 1/32 of the map.
    pub(super) fn unlike(&self) -> f64 {
        const DOWN_TO: usize = 10;
        (self.logs[1..=DOWN_TO].iter().map(|l| l * l).sum::<f64>() / DOWN_TO as f64).sqrt()
    }

    /// Logarithm of the ratio of slopes.
    pub(super) fn log_ratio(&self) -> f64 {
        self.ratio.ln()
    }
}
