//! Fractal dimension and roughness from a power spectrum or a structure function, and back.

use crate::majumdar_bhushan::check_dimension;
use crate::wide::Wide;
use contact_types::require;
use contact_types::{FractalParameters, ModelError};
use std::f64::consts::PI;

const MODEL: &str = "Weierstrass-Mandelbrot profile";

/// The usual ratio `gamma` of successive frequencies.
pub(crate) const FREQUENCY_RATIO: f64 = 1.5;

/// A Weierstrass-Mandelbrot profile, `z(x) = G^(D-1) sum_n gamma^(-(2-D)n) cos(2 pi gamma^n x)`.
///
/// One convention for everything: frequencies in cycles per length, the spectrum one-sided,
/// `int_0^inf S df` = variance:
///
/// ```math
/// S(f) = \frac{G^{2(D-1)}}{2\ln\gamma}\, f^{-(5-2D)}, \qquad
/// \langle(z(x+\tau)-z(x))^2\rangle = C_D\, G^{2(D-1)}\, \tau^{4-2D},
/// ```
///
/// ```math
/// C_D = \frac{(2\pi)^{4-2D}\,\Gamma(2D-3)\sin\frac{(2D-3)\pi}{2}}{2(2-D)\ln\gamma}
///     = \frac{\pi\,(2\pi)^{4-2D}}{2\ln\gamma\;\Gamma(5-2D)\,\sin\pi(D-1)}.
/// ```
///
/// The second form, by the reflection formula of the gamma function, has no 0 times infinity at
/// D = 3/2. The constant printed by Majumdar and Bhushan lacks `(2 pi)^(4-2D)` and the factor
/// 1/2 (an angular frequency with a two-sided spectrum): their `G` differs accordingly.
///
/// ```
/// use contact_types::FractalParameters;
/// use multiscale_models::fractal::WeierstrassMandelbrot;
/// let surface = FractalParameters { dimension: 1.4, roughness: 1e-11 };
/// let profile = WeierstrassMandelbrot::new(surface)?;
/// let back = WeierstrassMandelbrot::from_structure_function(
///     2.0 * (2.0 - 1.4), 1e-6, profile.structure_function(1e-6)?)?;
/// assert!((back.surface().roughness / 1e-11 - 1.0).abs() < 1e-12);
/// # Ok::<(), contact_types::ModelError>(())
/// ```
///
/// # Source
/// Majumdar & Bhushan (1991), doi:10.1115/1.2920588; Berry & Lewis (1980),
/// doi:10.1098/rspa.1980.0044.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WeierstrassMandelbrot {
    surface: FractalParameters,
    frequency_ratio: f64,
}

impl WeierstrassMandelbrot {
    /// The profile of given dimension and roughness, with the frequency ratio 1.5.
    ///
    /// # Errors
    /// [`ModelError::OutsideDomain`] unless `1 < D < 2`; [`ModelError::InvalidInput`] for a
    /// roughness that is not finite and positive.
    pub fn new(surface: FractalParameters) -> Result<Self, ModelError> {
        Self::with_ratio(surface, FREQUENCY_RATIO)
    }

    /// The same with another ratio `gamma > 1` of successive frequencies.
    ///
    /// # Errors
    /// As [`new`](Self::new); [`ModelError::OutsideDomain`] unless the ratio is finite and greater
    /// than 1.
    pub fn with_ratio(surface: FractalParameters, ratio: f64) -> Result<Self, ModelError> {
        check_dimension(MODEL, surface.dimension)?;
        require::positive(MODEL, "fractal roughness", surface.roughness)?;
        Ok(Self { surface, frequency_ratio: check_ratio(MODEL, ratio)? })
    }

    /// From a point `S(f)` \[m³\] of a one-sided profile spectrum at `f` \[1/m\] and its slope
    /// `d ln S / d ln f`: `D = (5 + slope)/2`, `G = [2 ln(gamma) S f^(5-2D)]^(1/(2(D-1)))`.
    ///
    /// # Errors
    /// [`ModelError::OutsideDomain`] if the slope is not between −3 and −1, or `G` is beyond the
    /// range of a double; [`ModelError::InvalidInput`] for a frequency or spectrum that is not
    /// finite and positive.
    pub fn from_psd(slope: f64, frequency: f64, psd: f64) -> Result<Self, ModelError> {
        let d = check_slope("slope of the spectrum", slope, -3.0, -1.0, 2.5 + 0.5 * slope)?;
        let f = Wide::from(require::positive(MODEL, "frequency", frequency)?);
        let s = Wide::from(require::positive(MODEL, "power spectral density", psd)?);
        let power = s * f.powf(-slope) * (2.0 * FREQUENCY_RATIO.ln()); // G^(2(D-1))
        Self::from_power(d, power)
    }

    /// From a point of the structure function, `value` \[m²\] at `lag` \[m\], and its slope
    /// `d ln value / d ln lag`: `D = 2 - slope/2`.
    ///
    /// # Errors
    /// [`ModelError::OutsideDomain`] if the slope is not between 0 and 2, or `G` is beyond the
    /// range of a double; [`ModelError::InvalidInput`] for a lag or value that is not finite and
    /// positive.
    pub fn from_structure_function(slope: f64, lag: f64, value: f64) -> Result<Self, ModelError> {
        let d = check_slope("slope of the structure function", slope, 0.0, 2.0, 2.0 - 0.5 * slope)?;
        let lag = Wide::from(require::positive(MODEL, "lag", lag)?);
        let value = Wide::from(require::positive(MODEL, "structure function", value)?);
        let power = value / lag.powf(slope) / structure_constant(d, FREQUENCY_RATIO);
        Self::from_power(d, power)
    }

    /// From `G^(2(D-1))`.
    fn from_power(dimension: f64, power: Wide) -> Result<Self, ModelError> {
        let roughness = power.powf(0.5 / (dimension - 1.0)).value();
        if !roughness.is_normal() {
            return Err(ModelError::OutsideDomain {
                model: MODEL.into(),
                quantity: "G".into(),
                value: roughness.min(f64::MAX),
                domain: f64::MIN_POSITIVE..=f64::MAX,
                reason: "it is beyond the range of a double: D is too close to 1".into(),
            });
        }
        Self::new(FractalParameters { dimension, roughness })
    }

    /// Dimension and roughness.
    pub fn surface(&self) -> FractalParameters {
        self.surface
    }

    /// One-sided power spectral density `S(f)` \[m³\] at frequency `f` \[1/m\].
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] for a frequency that is not finite and positive;
    /// [`ModelError::OutsideDomain`] if the density exceeds the largest double.
    pub fn psd(&self, frequency: f64) -> Result<f64, ModelError> {
        let f = Wide::from(require::positive(MODEL, "frequency", frequency)?);
        let FractalParameters { dimension: d, roughness } = self.surface;
        let g = Wide::from(roughness);
        let psd =
            g.powf(2.0 * (d - 1.0)) * f.powf(2.0 * d - 5.0) / (2.0 * self.frequency_ratio.ln());
        require::representable(MODEL, "power spectral density", psd.value())
    }

    /// Structure function, the mean square height difference \[m²\] over a lag \[m\].
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] for a lag that is not finite and positive;
    /// [`ModelError::OutsideDomain`] if it exceeds the largest double.
    pub fn structure_function(&self, lag: f64) -> Result<f64, ModelError> {
        let lag = Wide::from(require::positive(MODEL, "lag", lag)?);
        let FractalParameters { dimension: d, roughness } = self.surface;
        let value = Wide::from(roughness).powf(2.0 * (d - 1.0))
            * lag.powf(4.0 - 2.0 * d)
            * structure_constant(d, self.frequency_ratio);
        require::representable(MODEL, "structure function", value.value())
    }
}

/// `C_D` of the structure function, for `1 < D < 2`.
fn structure_constant(d: f64, ratio: f64) -> f64 {
    // sin pi(D-1) from the nearer end, where the argument is exact
    let sine = (PI * (d - 1.0).min(2.0 - d)).sin();
    PI * (2.0 * PI).powf(4.0 - 2.0 * d) / (2.0 * ratio.ln() * libm::tgamma(5.0 - 2.0 * d) * sine)
}

/// Ratio of successive frequencies, finite and above 1.
pub(crate) fn check_ratio(model: &'static str, ratio: f64) -> Result<f64, ModelError> {
    if ratio > 1.0 && ratio.is_finite() {
        return Ok(ratio);
    }
    Err(ModelError::OutsideDomain {
        model: model.into(),
        quantity: "frequency ratio".into(),
        value: ratio,
        domain: 1.0..=f64::MAX,
        reason: "successive frequencies rise by a factor greater than 1".into(),
    })
}

/// A slope strictly between two bounds, or a refusal that names the dimension it would mean.
fn check_slope(
    quantity: &'static str,
    slope: f64,
    lo: f64,
    hi: f64,
    dimension: f64,
) -> Result<f64, ModelError> {
    if slope > lo && slope < hi {
        return check_dimension(MODEL, dimension);
    }
    Err(ModelError::OutsideDomain {
        model: MODEL.into(),
        quantity: quantity.into(),
        value: slope,
        domain: lo..=hi,
        reason: "outside, the profile is not fractal: its dimension would not be between 1 and 2"
            .into(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// `C_D` is `2 int_0^inf S (1 - cos 2 pi f tau) df` at G = tau = 1; substituting
    /// `u = 2 pi f` leaves `int_0^inf (1 - cos u) u^(2D-5) du`, 30-digit values by mpmath.
    #[test]
    fn structure_constant_is_the_integral_of_the_spectrum() {
        for (d, integral) in [
            (1.05, 5.49495943399835073),
            (1.4, 1.499028195405828),
            (1.5, 0.5 * PI),
            (1.8, 3.01195459295253596),
            (1.99, 50.5724010439679587),
        ] {
            let expected = (2.0 * PI).powf(4.0 - 2.0 * d) / FREQUENCY_RATIO.ln() * integral;
            let found = structure_constant(d, FREQUENCY_RATIO);
            assert_relative_eq!(found, expected, max_relative = 3e-15);
        }
    }
}
