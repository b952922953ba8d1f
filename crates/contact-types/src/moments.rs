//! A rough surface reduced to a few numbers.

use std::f64::consts::PI;

/// Profile spectral moments of the equivalent rough surface (Nayak 1971, doi:10.1115/1.3451608).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SpectralMoments {
    /// Mean square height \[m²\].
    pub m0: f64,
    /// Mean square slope of a profile, `<|grad h|^2> / 2` \[-\].
    pub m2: f64,
    /// Mean square second derivative of a profile, `3 <(laplace h)^2> / 8` \[m⁻²\].
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
    /// surface.
    pub fn bandwidth(&self) -> f64 {
        (self.m0 / self.m2) * (self.m4 / self.m2)
    }
}

/// Asperities (summits) as Greenwood and Williamson see them.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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
    /// Summits of an isotropic Gaussian surface with these moments; `None` if a moment is not
    /// positive and finite, or the bandwidth αN is so small (at most 0.8968) that the variance of
    /// the summit heights would not be positive.
    ///
    /// ```math
    /// \eta = \frac{m_4/m_2}{6\pi\sqrt3}, \quad R = \frac38\sqrt{\frac{\pi}{m_4}}, \quad
    /// y_s = 4\sqrt{\frac{m_0}{\pi\alpha_N}}, \quad
    /// \sigma_s^2 = \Big(1 - \frac{1 + 16/\pi - 3\sqrt3}{\alpha_N}\Big) m_0
    /// ```
    ///
    /// # Source
    /// Nayak (1971), doi:10.1115/1.3451608; in this form McCool (1986),
    /// doi:10.1016/0043-1648(86)90045-1.
    pub fn from_moments(moments: SpectralMoments) -> Option<Self> {
        let SpectralMoments { m0, m2, m4 } = moments;
        if ![m0, m2, m4].iter().all(|m| m.is_normal() && *m > 0.0) {
            return None;
        }
        let bandwidth = moments.bandwidth();
        let variance_ratio = 1.0 - (1.0 + 16.0 / PI - 3.0 * 3f64.sqrt()) / bandwidth;
        let summits = Self {
            density: m4 / m2 / (6.0 * PI * 3f64.sqrt()),
            radius: 0.375 * (PI / m4).sqrt(),
            height_std: (variance_ratio * m0).sqrt(),
            mean_offset: 4.0 * (m0 / (PI * bandwidth)).sqrt(),
        };
        (variance_ratio > 0.0 && summits.density.is_normal()).then_some(summits)
    }
}

/// Parameters of a fractal profile (Majumdar & Bhushan 1991, doi:10.1115/1.2920588).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct FractalParameters {
    /// Dimension of a profile D, between 1 and 2 \[-\].
    pub dimension: f64,
    /// Fractal roughness G \[m\].
    pub roughness: f64,
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// 22-digit values computed with mpmath for m0 = 0.6747 and the finite-difference m2, m4 of a
    /// sum of six sinusoids.
    #[test]
    fn summits_of_a_gaussian_surface() {
        let moments =
            SpectralMoments { m0: 0.6747, m2: 0.4162700053973672599, m4: 1.593138331724997233 };
        assert_relative_eq!(moments.bandwidth(), 6.203173951396777558, max_relative = 1e-15);
        let summits = AsperityStatistics::from_moments(moments).unwrap();
        assert_relative_eq!(summits.density, 0.1172240219749787773, max_relative = 1e-15);
        assert_relative_eq!(summits.radius, 0.5265983094237080350, max_relative = 1e-15);
        assert_relative_eq!(summits.height_std, 0.7597086402797854233, max_relative = 1e-15);
        assert_relative_eq!(summits.mean_offset, 0.7442749977338474396, max_relative = 1e-15);
    }

    #[test]
    fn no_summits_without_spread_of_heights() {
        for (m0, m2, m4) in
            [(1.0, 1.0, 0.89), (0.0, 0.0, 0.0), (1.0, f64::NAN, 1.0), (1.0, 1.0, f64::INFINITY)]
        {
            assert!(AsperityStatistics::from_moments(SpectralMoments { m0, m2, m4 }).is_none());
        }
    }
}
