//! Nayak's distribution of summit heights.

use crate::gauss_legendre::GAUSS_32;
use contact_types::{ModelError, require};
use gw_closed_form::partial_moments::times_gaussian;
use std::f64::consts::PI;

/// Probability density of summit heights of an isotropic Gaussian surface, ξ = z/√m0 above the
/// mean plane.
///
/// The mixture over summit curvature t of Gaussians of mean ρt and deviation s, ρ² = 3/(2α),
/// s² = 1 - ρ², α the bandwidth:
///
/// ```math
/// p(\xi) = \sqrt{\tfrac6\pi} \int_0^\infty \left(t^2 - 1 + e^{-t^2}\right) e^{-t^2/2}\,
///    \frac{e^{-(\xi-\rho t)^2/(2s^2)}}{\sqrt{2\pi}\,s}\,dt
/// ```
///
/// Its mean is `4/√(πα)` and its variance `1 - 0.8968/α`; Greenwood and Williamson replace it by
/// the Gaussian with these two. It tends to a Gaussian for α → ∞; at α = 3/2 no summit lies below
/// the mean plane. Relative error below 1e-14 for densities above 1e-30 and 2e-13 wherever the density is a
/// normal double, both tails and bandwidths next to 3/2 included.
///
/// ```
/// // Bandwidth 5: a summit at the mean plane is about half as likely as one at 1 rms height.
/// let density = asperity_models::nayak::summit_height_density(5.0, 0.0)?;
/// assert!((density - 0.238_734_539_355_391_4).abs() < 1e-15);
/// # Ok::<(), contact_types::ModelError>(())
/// ```
///
/// # Errors
/// [`ModelError::OutsideDomain`] for a bandwidth below 3/2 (by more than 1e-14 of it) or not
/// finite, [`ModelError::InvalidInput`] if ξ is not finite.
///
/// # Source
/// Nayak (1971), doi:10.1115/1.3451608.
pub fn summit_height_density(bandwidth: f64, xi: f64) -> Result<f64, ModelError> {
    if !(bandwidth >= 1.5 * (1.0 - 1e-14) && bandwidth.is_finite()) {
        return Err(ModelError::OutsideDomain {
            model: "Nayak summit heights".into(),
            quantity: "bandwidth m0 m4 / m2^2".into(),
            value: bandwidth,
            domain: 1.5..=f64::MAX,
            reason: "no isotropic Gaussian surface has less".into(),
        });
    }
    require::finite("Nayak summit heights", "height", xi)?;
    let bandwidth = bandwidth.max(1.5);
    let rho = (1.5 / bandwidth).sqrt();
    let s = ((bandwidth - 1.5) / bandwidth).sqrt();
    if xi.abs() > 1e3 {
        return Ok(0.0); // exp(-ξ²/2) is far below the smallest double
    }
    if s <= 0.0 {
        // One wavelength: height and curvature are the same thing, xi = t.
        return Ok(if xi > 0.0 { curvature_density(xi) } else { 0.0 });
    }
    // exp(-t²/2) exp(-(ξ-ρt)²/(2s²)) = exp(-ξ²/2) exp(-(t-c)²/(2s²)), c = ρξ. With s small, t-c must
    // not be a difference: nodes are offsets y from c, or from 0 if c lies below it.
    let center = rho * xi;
    let origin = center.max(0.0);
    let (low, high) = if center > -s {
        ((-REACH * s).max(-origin), REACH * s)
    } else {
        // Decays from t = 0 like exp(-|c| t / s²).
        (0.0, 55.0 * s * s / -center)
    };
    let panels = 6;
    let width = (high - low) / f64::from(panels);
    let mut sum = 0.0;
    for panel in 0..panels {
        let middle = low + (f64::from(panel) + 0.5) * width;
        for &[x, w] in &GAUSS_32 {
            for x in [-x, x] {
                let y = middle + 0.5 * width * x;
                // (t-c)² without its c², which is taken out below
                let square = if center < 0.0 { y * (y - 2.0 * center) } else { y * y };
                let gaussian = (-0.5 * (square / s) / s).exp();
                sum += 0.5 * width * w * summit_weight(origin + y) * gaussian;
            }
        }
    }
    let below_plane = if center < 0.0 { center / s } else { 0.0 };
    let prefactor = (6.0 / PI).sqrt() / ((2.0 * PI).sqrt() * s);
    Ok(times_gaussian(times_gaussian(prefactor * sum, xi), below_plane))
}

/// Density of the summit curvature t ≥ 0: √(6/π) (t² - 1 + e^{-t²}) e^{-t²/2}.
fn curvature_density(t: f64) -> f64 {
    times_gaussian((6.0 / PI).sqrt() * summit_weight(t), t)
}

/// t² - 1 + e^{-t²}; starts as t⁴/2.
pub(crate) fn summit_weight(t: f64) -> f64 {
    let x = t * t;
    if x > 1.0 {
        return x - 1.0 + (-x).exp();
    }
    x * x * weight_series(x)
}

/// W_N = (t² - 1 + e^{-t²})/(2t⁴): the contact of a sphere of the mean curvature, averaged over the
/// curvature ellipses at t.
pub(crate) fn mean_kernel(t: f64) -> f64 {
    let x = t * t;
    if x > 1.0 { (x - 1.0 + (-x).exp()) / (2.0 * x * x) } else { 0.5 * weight_series(x) }
}

/// (x - 1 + e^{-x})/x² = 1/2! - x/3! + x²/4! - ..., x ≤ 1.
fn weight_series(x: f64) -> f64 {
    let (mut term, mut sum) = (0.5, 0.0);
    for k in 3..22 {
        sum += term;
        term *= -x / f64::from(k);
    }
    sum
}

/// exp(-REACH²/2) of the peak is left out.
const REACH: f64 = 9.5;

#[cfg(test)]
mod tests {
    use super::*;

    /// Mean and variance of the density are the closed forms the GW model uses.
    #[test]
    fn mean_and_variance_are_those_of_the_asperities() {
        for bandwidth in [1.5, 1.6, 3.0, 40.0, 1e6] {
            let (step, mut moments) = (0.01, [0.0; 3]);
            for k in -1000..=1400 {
                let xi = f64::from(k) * step;
                let density = step * summit_height_density(bandwidth, xi).unwrap();
                for (moment, power) in moments.iter_mut().zip([1.0, xi, xi * xi]) {
                    *moment += density * power;
                }
            }
            let mean = 4.0 / (PI * bandwidth).sqrt();
            let constant = 1.0 + 16.0 / PI - 3.0 * 3f64.sqrt();
            let variance = 1.0 - constant / bandwidth;
            // The trapezoid rule is exact for smooth densities; at 3/2 there is a kink at 0.
            let tolerance = if bandwidth > 1.5 { 1e-13 } else { 1e-6 };
            assert!((moments[0] - 1.0).abs() < tolerance, "{bandwidth}: {moments:?}");
            assert!((moments[1] - mean).abs() < tolerance, "{bandwidth}: {moments:?}");
            assert!((moments[2] - mean * mean - variance).abs() < 10.0 * tolerance, "{bandwidth}");
        }
    }
}
