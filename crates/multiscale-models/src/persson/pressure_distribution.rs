//! The distribution of pressure over the nominal area.

use super::span::MODEL;
use super::theory::Persson;
use crate::answer::outside;
use crate::special::{erf, erfc};
use crate::wide::Wide;
use contact_types::{ModelError, require};
use std::f64::consts::{FRAC_1_SQRT_2, PI, SQRT_2};

/// Distribution of the local pressure over the nominal area: a continuous part for `sigma > 0`
/// and a delta at 0 for what is out of contact.
///
/// ```math
/// P(\sigma) = \frac{e^{-(\sigma-p)^2/2V} - e^{-(\sigma+p)^2/2V}}{\sqrt{2\pi V}}
///   + \Bigl(1 - \frac{A}{A_0}\Bigr)\,\delta(\sigma)
/// ```
///
/// # Source
/// Persson (2001), doi:10.1063/1.1388626, with the boundary condition P(0) = 0 of Persson,
/// Bucher & Chiaia (2002), doi:10.1103/PhysRevB.65.184106.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PressureDistribution {
    /// `p / sqrt(V)`.
    mean: f64,
    /// `sqrt(V) = E* g_rms / 2` \[Pa\].
    deviation: f64,
}

impl Persson {
    /// The pressure distribution at nominal pressure `pressure` \[Pa\].
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] if the pressure is negative or not finite;
    /// [`ModelError::OutsideDomain`] for a flat surface, whose pressure is uniform, and where
    /// the deviation `E* g_rms / 2` or its inverse exceeds the range of a double.
    pub fn pressure_distribution(&self, pressure: f64) -> Result<PressureDistribution, ModelError> {
        require::pressure(MODEL, pressure)?;
        let deviation = self.slope * FRAC_1_SQRT_2 * self.modulus.pascals();
        let domain = 1e-300..=1e300;
        if !domain.contains(&deviation.value()) {
            let value = deviation.value().min(f64::MAX);
            let reason = "the pressure on a surface this flat is uniform";
            return Err(outside(MODEL, "pressure deviation", value, domain, reason));
        }
        let mean = (Wide::from(pressure) / deviation).value();
        // Beyond 1e150 deviations the square of the mean overflows; the area is 1 long before.
        require::representable(MODEL, "pressure over its deviation", mean * mean)?;
        Ok(PressureDistribution { mean, deviation: deviation.value() })
    }
}

impl PressureDistribution {
    /// Density of the continuous part at local pressure `sigma` \[Pa\], in 1/Pa; 0 for
    /// `sigma <= 0`.
    pub fn density(&self, sigma: f64) -> f64 {
        let s = sigma / self.deviation;
        if s <= 0.0 {
            return 0.0;
        }
        // e^{-(s-m)^2/2} (1 - e^{-2 s m}): no cancellation for s m << 1.
        let difference = s - self.mean;
        let product = 2.0 * s * self.mean;
        (-0.5 * difference * difference).exp() * -(-product).exp_m1()
            / ((2.0 * PI).sqrt() * self.deviation)
    }

    /// Weight of the delta at zero pressure, `1 - A/A_0` \[-\].
    pub fn open_fraction(&self) -> f64 {
        erfc(self.mean / SQRT_2)
    }

    /// Mean square pressure over the nominal area \[Pa²\],
    ///
    /// ```math
    /// \langle\sigma^2\rangle = (p^2+V)\,\operatorname{erf}\frac{p}{\sqrt{2V}}
    ///   + p\sqrt{\tfrac{2V}{\pi}}\;e^{-p^2/2V}
    /// ```
    ///
    /// `None` if it exceeds the largest double.
    pub fn mean_square(&self) -> Option<f64> {
        let m = self.mean;
        let area_fraction = erf(m / SQRT_2);
        let square = (m * m + 1.0) * area_fraction + m * (2.0 / PI).sqrt() * (-0.5 * m * m).exp();
        let pascals = square * self.deviation * self.deviation;
        pascals.is_finite().then_some(pascals)
    }
}
