//! From the spectral moments of a surface to the asperities of Greenwood and Williamson.

use crate::arithmetic::product;
use contact_types::{AsperityStatistics, ModelError, SpectralMoments};
use core::f64::consts::PI;

/// Summit density, radius, height deviation and mean height of an isotropic Gaussian surface.
///
/// ```math
/// \eta = \frac{m_4}{6\pi\sqrt3\, m_2}, \quad
/// R = \frac38 \sqrt{\frac{\pi}{m_4}}, \quad
/// y_s = 4\sqrt{\frac{m_0}{\pi\alpha}}, \quad
/// \sigma_s^2 = \left(1 - \frac{c}{\alpha}\right) m_0, \quad c = 1 + \tfrac{16}{\pi} - 3\sqrt3
/// ```
///
/// with the bandwidth α = m0 m4 / m2². Exact mean and variance of Nayak's summit heights; the
/// often quoted decimals 0.8968, 0.045944 and 3.717e-4 are these constants rounded.
///
/// # Errors
/// [`ModelError::InvalidInput`] unless all moments are finite and positive,
/// [`ModelError::OutsideDomain`] if the bandwidth is at most c = 0.8968: summits would have no
/// variance of height. Between c and 3/2, where no isotropic Gaussian surface exists, the result
/// is still computed (measured surfaces get there).
///
/// # Source
/// Nayak (1971), doi:10.1115/1.3451608; McCool (1986), doi:10.1016/0043-1648(86)90045-1.
pub fn asperities_from_moments(moments: SpectralMoments) -> Result<AsperityStatistics, ModelError> {
    let SpectralMoments { m0, m2, m4 } = moments;
    for (quantity, value) in [("m0", m0), ("m2", m2), ("m4", m4)] {
        if !(value.is_finite() && value > 0.0) {
            return Err(ModelError::InvalidInput {
                model: MODEL.into(),
                quantity: quantity.into(),
                value,
                requirement: "must be finite and greater than 0".into(),
            });
        }
    }
    let bandwidth = bandwidth(moments);
    if bandwidth <= SUMMIT_CONSTANT {
        return Err(ModelError::OutsideDomain {
            model: MODEL.into(),
            quantity: "bandwidth m0 m4 / m2^2".into(),
            value: bandwidth,
            domain: SUMMIT_CONSTANT..=f64::MAX,
            reason: "the variance of summit heights would not be positive".into(),
        });
    }
    let asperities = AsperityStatistics {
        density: product(&[m4, 1.0 / m2]) / (6.0 * PI * libm::sqrt(3.0)),
        radius: 0.375 * libm::sqrt(PI) / libm::sqrt(m4),
        height_std: libm::sqrt((1.0 - SUMMIT_CONSTANT / bandwidth) * m0),
        mean_offset: 4.0 * libm::sqrt(m0) / libm::sqrt(PI * bandwidth),
    };
    for (quantity, value) in [
        ("asperity density", asperities.density),
        ("asperity radius", asperities.radius),
        ("asperity height deviation", asperities.height_std),
    ] {
        if !value.is_normal() {
            return Err(ModelError::InvalidInput {
                model: MODEL.into(),
                quantity: quantity.into(),
                value,
                requirement: "must be a normal number; scale the moments to metres".into(),
            });
        }
    }
    Ok(asperities)
}

/// m0 m4 / m2², clamped to the largest double.
pub(crate) fn bandwidth(moments: SpectralMoments) -> f64 {
    let inverse = 1.0 / moments.m2;
    crate::arithmetic::clamp_to_finite(product(&[moments.m0, moments.m4, inverse, inverse]))
}

/// c = 1 + 16/π - 3√3.
pub(crate) const SUMMIT_CONSTANT: f64 = 0.896_805_756_234_018_9;

pub(crate) const MODEL: &str = "Greenwood-Williamson";
