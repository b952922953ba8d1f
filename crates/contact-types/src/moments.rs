//! A rough surface reduced to a few numbers.

use crate::{ModelError, require};
use std::f64::consts::PI;

/// Profile spectral moments of the equivalent rough surface (Nayak 1971, doi:10.1115/1.3451608). Of a surface with
/// a lay or a pattern they are the means of the profiles along both axes of its map.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SpectralMoments {
    /// Mean square height \[m²\].
    pub m0: f64,
    /// Mean square slope of a profile, `<|grad h|^2> / 2` \[-\].
    pub m2: f64,
    /// Mean square second derivative of a profile; of an isotropic surface `3 <(laplace h)^2> / 8` \[m⁻²\].
    pub m4: f64,
}

impl SpectralMoments {
    /// Rms height σ = √m0 \[m\].
    pub fn rms_height(&self) -> f64 {
        self.m0.sqrt()
    }

    /// Rms gradient of the surface h'_rms = √(2 m2) \[-\].
    pub fn rms_gradient(&self) -> f64 {
        (2.0 * self.m2).sqrt()
    }

    /// Nayak's bandwidth parameter α = m0 m4 / m2² \[-\]; at least 3/2 for an isotropic Gaussian
    /// surface. Infinite where it exceeds the largest double, NaN for a flat surface.
    pub fn bandwidth(&self) -> f64 {
        let (long, short) = (self.m0 / self.m2, self.m4 / self.m2);
        if long.is_normal() && short.is_normal() {
            return long * short;
        }
        // The quotients leave the range of doubles where the bandwidth need not.
        let root = self.m0.sqrt() * self.m4.sqrt() / self.m2;
        root * root
    }
}

/// Asperities (summits) as Greenwood and Williamson see them.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct AsperityStatistics {
    /// Asperities per nominal area η \[m⁻²\].
    pub density: f64,
    /// Radius of every summit R \[m\].
    pub radius: f64,
    /// Standard deviation of summit heights σ_s \[m\].
    pub height_std: f64,
    /// Mean summit height above the mean plane of the surface y_s \[m\].
    pub mean_offset: f64,
}

impl AsperityStatistics {
    /// Summits of an isotropic Gaussian surface with these moments:
    ///
    /// ```math
    /// \eta = \frac{m_4/m_2}{6\pi\sqrt3}, \quad R = \frac38\sqrt{\frac{\pi}{m_4}}, \quad
    /// y_s = 4\sqrt{\frac{m_0}{\pi\alpha_N}} = \frac{4 m_2}{\sqrt{\pi m_4}}, \quad
    /// \sigma_s^2 = \Big(1 - \frac{c}{\alpha_N}\Big) m_0, \quad c = 1 + \tfrac{16}\pi - 3\sqrt3
    /// ```
    ///
    /// Exact mean and variance of Nayak's summit heights; the often quoted decimals 0.8968,
    /// 0.045944 and 3.717e-4 are these constants rounded. Between c and 3/2 there is no isotropic
    /// Gaussian surface, but measured surfaces get there, and the result is still computed.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] unless all moments are finite and positive and the asperities
    /// normal numbers, [`ModelError::OutsideDomain`] if the bandwidth αN is at most c = 0.8968:
    /// summits would have no variance of height.
    ///
    /// # Source
    /// Nayak (1971), doi:10.1115/1.3451608; in this form McCool (1986),
    /// doi:10.1016/0043-1648(86)90045-1.
    pub fn from_moments(moments: SpectralMoments) -> Result<Self, ModelError> {
        let SpectralMoments { m0, m2, m4 } = moments;
        for (quantity, value) in [("m0", m0), ("m2", m2), ("m4", m4)] {
            require::positive(SUMMITS, quantity, value)?;
        }
        let bandwidth = moments.bandwidth().min(f64::MAX);
        if bandwidth <= LEAST_BANDWIDTH {
            let (quantity, domain) = ("bandwidth m0 m4 / m2^2", LEAST_BANDWIDTH..=f64::MAX);
            let reason = "the variance of summit heights would not be positive";
            return Err(require::outside(SUMMITS, quantity, bandwidth, domain, reason));
        }
        let summits = Self {
            density: m4 / m2 / (6.0 * PI * 3f64.sqrt()),
            radius: 0.375 * (PI / m4).sqrt(),
            height_std: ((1.0 - LEAST_BANDWIDTH / bandwidth) * m0).sqrt(),
            mean_offset: 4.0 * m2 / (PI.sqrt() * m4.sqrt()),
        };
        for (quantity, value) in [
            ("asperity density", summits.density),
            ("asperity radius", summits.radius),
            ("asperity height deviation", summits.height_std),
        ] {
            if !value.is_normal() {
                let requirement = "must be a normal number; scale the moments to metres";
                return Err(require::refused(SUMMITS, quantity, value, requirement));
            }
        }
        Ok(summits)
    }
}

/// Who speaks in errors about summits.
const SUMMITS: &str = "summits of a Gaussian surface";

/// c = 1 + 16/π - 3√3: at this bandwidth the variance of summit heights would be 0.
const LEAST_BANDWIDTH: f64 = 0.896_805_756_234_018_9;

/// Parameters of a fractal profile (Majumdar & Bhushan 1991, doi:10.1115/1.2920588).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct FractalParameters {
    /// Dimension of a profile D, between 1 and 2 \[-\].
    pub dimension: f64,
    /// Fractal roughness G \[m\].
    pub roughness: f64,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::close;

    /// mpmath, 22 digits, for the finite-difference m2, m4 of a sum of six sinusoids.
    #[test]
    fn summits_of_a_gaussian_surface() {
        let moments =
            SpectralMoments { m0: 0.6747, m2: 0.4162700053973672599, m4: 1.593138331724997233 };
        close(moments.bandwidth(), 6.203173951396777558, 1e-15);
        let summits = AsperityStatistics::from_moments(moments).unwrap();
        close(summits.density, 0.1172240219749787773, 1e-15);
        close(summits.radius, 0.5265983094237080350, 1e-15);
        close(summits.height_std, 0.7597086402797854233, 1e-15);
        close(summits.mean_offset, 0.7442749977338474396, 1e-15);
    }

    #[test]
    fn no_summits_without_spread_of_heights() {
        for (m0, m2, m4) in
            [(1.0, 1.0, 0.89), (0.0, 0.0, 0.0), (1.0, f64::NAN, 1.0), (1.0, 1.0, f64::INFINITY)]
        {
            assert!(AsperityStatistics::from_moments(SpectralMoments { m0, m2, m4 }).is_err());
        }
        let narrow = SpectralMoments { m0: 1.0, m2: 1.0, m4: LEAST_BANDWIDTH };
        let error = AsperityStatistics::from_moments(narrow).unwrap_err();
        assert!(matches!(error, ModelError::OutsideDomain { .. }), "{error}");
    }

    /// In other units of length the asperities are the same: L^2 and 1/L^2 scale m0 and m4. Powers of
    /// two lose nothing, so that only over- and underflow on the way could show.
    #[test]
    fn any_unit_of_length_gives_the_same_summits() {
        let of = |unit: f64| {
            let square = unit * unit;
            let (m0, m2, m4) = (2.0 * square, 1.0, 1.5 / square);
            AsperityStatistics::from_moments(SpectralMoments { m0, m2, m4 }).unwrap()
        };
        let expected = of(1.0);
        for exponent in [-500, -100, -20, 20, 100, 500] {
            let unit = 2f64.powi(exponent);
            let found = of(unit);
            for (found, expected) in [
                (found.density * unit * unit, expected.density),
                (found.radius / unit, expected.radius),
                (found.height_std / unit, expected.height_std),
                (found.mean_offset / unit, expected.mean_offset),
            ] {
                close(found, expected, 1e-15);
            }
        }
        // Here m0/m2 overflows, and the bandwidth is only 2^200.
        let [m0, m2, m4] = [1000, -100, -1000].map(|e| 2f64.powi(e));
        let wide = SpectralMoments { m0, m2, m4 };
        close(wide.bandwidth(), 2f64.powi(200), 1e-15);
        let found = AsperityStatistics::from_moments(wide).unwrap();
        close(found.height_std, 2f64.powi(500), 1e-15);
    }
}
