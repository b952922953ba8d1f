//! Contact conductance by the correlations that users compare with, and what they are fits of.
//!
//! Gaussian heights cut at a level λσ leave circular spots; each carries heat as one in a tube of its own. For
//! bodies that yield at once the cut area is p/H, for elastic ones half of what is cut is in contact:
//!
//! ```math
//! \text{plastic: } \frac pH = Q(\lambda),\quad
//! h=\frac{k_s m_a}{\sigma}\,\frac{e^{-\lambda^2/2}}{2\sqrt{2\pi}\,(1-\sqrt{p/H})^{3/2}},\qquad
//! \text{elastic: } \frac{\sqrt2\,p}{E^*m_a}=\tfrac12 Q(\lambda)=A,\quad
//! h=\frac{k_s m_a}{\sigma}\,\frac{e^{-\lambda^2/2}}{4\sqrt\pi\,(1-\sqrt A)^{3/2}}
//! ```
//!
//! with the Gaussian tail Q, `σ² = σ₁² + σ₂²` and `m_a² = m₁² + m₂²`. The well-known powers of the load are fits
//! of these to 1.5 and 3 %. m_a is the *mean absolute* profile slope, 0.798 of the rms one: public codes mix
//! them. For a current put `2/(ρ₁ + ρ₂)` in the place of k_s.
//!
//! # Source
//! Cooper, Mikic & Yovanovich (1969), with 1.25 and 0.95 of Yovanovich (1982) in the place of their 1.45 and 0.985; Mikic (1974).
//! From memory: their papers could not be read here. Public codes have these constants, and they fit the expressions above.

use contact_types::{ModelError, require};
use gw_closed_form::partial_moments::{self, Order};
use std::f64::consts::{PI, SQRT_2};

const MODEL: &str = "conductance correlation";

/// Two rough surfaces as the correlations see them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoughJoint {
    factor: f64,
    slope: f64,
}

impl RoughJoint {
    /// From the harmonic mean conductivity `k_s = 2 k1 k2 / (k1 + k2)` (W/(m K), or `2/(ρ1 + ρ2)` in S/m), the mean
    /// absolute profile slope m_a (-) and the rms height σ (m) of both surfaces together.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] unless all are finite and positive.
    pub fn new(conductivity: f64, mean_slope: f64, rms_height: f64) -> Result<Self, ModelError> {
        require::positive(MODEL, "conductivity", conductivity)?;
        require::positive(MODEL, "mean absolute slope", mean_slope)?;
        require::positive(MODEL, "rms height", rms_height)?;
        Ok(Self { factor: conductivity * mean_slope / rms_height, slope: mean_slope })
    }

    /// Cooper, Mikic & Yovanovich: `h = 1.25 k_s m_a/σ (p/H)^0.95`, in W/(m² K) or S/m².
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] if pressure or hardness (Pa) is not finite and positive,
    /// [`ModelError::OutsideDomain`] from p = H on.
    pub fn plastic(&self, pressure: f64, hardness: f64) -> Result<f64, ModelError> {
        Ok(1.25
            * self.factor
            * below("mean pressure over hardness", pressure, hardness, 1.0)?.powf(0.95))
    }

    /// What that is a fit of.
    ///
    /// # Errors
    /// As [`plastic`](Self::plastic).
    pub fn plastic_truncation(&self, pressure: f64, hardness: f64) -> Result<f64, ModelError> {
        let area = below("mean pressure over hardness", pressure, hardness, 1.0)?;
        Ok(self.factor * at_cut(area) / (2.0 * (2.0 * PI).sqrt()) / (1.0 - area.sqrt()).powf(1.5))
    }

    /// Mikic: `h = 1.55 k_s m_a/σ (√2 p/(E* m_a))^0.94`, with the contact modulus E* (Pa).
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] if pressure or modulus is not finite and positive,
    /// [`ModelError::OutsideDomain`] where half of the surface would be cut and more.
    pub fn elastic(&self, pressure: f64, modulus: f64) -> Result<f64, ModelError> {
        Ok(1.55 * self.factor * self.elastic_area(pressure, modulus)?.powf(0.94))
    }

    /// What that is a fit of.
    ///
    /// # Errors
    /// As [`elastic`](Self::elastic).
    pub fn elastic_truncation(&self, pressure: f64, modulus: f64) -> Result<f64, ModelError> {
        let area = self.elastic_area(pressure, modulus)?;
        Ok(self.factor * at_cut(2.0 * area) / (4.0 * PI.sqrt()) / (1.0 - area.sqrt()).powf(1.5))
    }

    /// Mikic's plasticity index `E* m_a / H` (-).
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] if modulus or hardness is not finite and positive.
    pub fn plasticity_index(&self, modulus: f64, hardness: f64) -> Result<f64, ModelError> {
        require::positive(MODEL, "modulus", modulus)?;
        require::positive(MODEL, "hardness", hardness)?;
        Ok(modulus * self.slope / hardness)
    }

    /// A of the module documentation.
    fn elastic_area(&self, pressure: f64, modulus: f64) -> Result<f64, ModelError> {
        let strength = modulus * self.slope / SQRT_2;
        below("area fraction", pressure, strength, 0.5)
    }
}

/// Greenwood & Williamson's plasticity index `ψ = (E*/H) sqrt(σ_s/R)` (-): below 0.6 summits stay elastic at
/// ordinary loads, above 1 they yield at any.
///
/// # Errors
/// [`ModelError::InvalidInput`] unless all are finite and positive.
///
/// # Source
/// Greenwood & Williamson (1966), doi:10.1098/rspa.1966.0242.
pub fn summit_plasticity_index(
    modulus: f64,
    hardness: f64,
    height_std: f64,
    radius: f64,
) -> Result<f64, ModelError> {
    require::positive(MODEL, "modulus", modulus)?;
    require::positive(MODEL, "hardness", hardness)?;
    require::positive(MODEL, "asperity height deviation", height_std)?;
    require::positive(MODEL, "asperity radius", radius)?;
    Ok(modulus / hardness * (height_std / radius).sqrt())
}

/// `exp(-λ²/2)` at the cut λ above which a fraction `tail` of Gaussian heights lies.
fn at_cut(tail: f64) -> f64 {
    // Newton's method for ln Q, which is concave in λ: it passes the root at most once.
    let step = |cut: f64| {
        let lacks = partial_moments::ln(Order::Zero, cut) - tail.ln();
        lacks / -partial_moments::ln_derivative(Order::Zero, cut)
    };
    let mut cut = 0.0;
    for _ in 0..100 {
        let change = step(cut);
        cut += change;
        if change.abs() <= 1e-15 * (1.0 + cut.abs()) {
            break;
        }
    }
    // The Gaussian there, with what the rounding of λ took from it given back.
    partial_moments::times_gaussian(1.0, cut) * (-cut * step(cut)).exp()
}

/// Pressure over strength, if it is below `most`.
fn below(
    quantity: &'static str,
    pressure: f64,
    strength: f64,
    most: f64,
) -> Result<f64, ModelError> {
    require::positive(MODEL, "mean pressure", pressure)?;
    require::positive(MODEL, "hardness or modulus", strength)?;
    let ratio = pressure / strength;
    if ratio < most {
        return Ok(ratio);
    }
    Err(ModelError::OutsideDomain {
        model: MODEL.into(),
        quantity: quantity.into(),
        value: ratio,
        domain: 0.0..=most,
        reason: "the spots would no longer be apart".into(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against 32 digits (mpmath).
    #[test]
    fn correlations_against_the_table() {
        let table = include_str!("../../../fixtures/reference/contact_conductance.csv");
        let (mut worst, mut count) = ([0.0_f64; 5], 0);
        for line in table.lines().filter(|line| !line.starts_with(['#', 'k'])) {
            let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
            let [k1, k2, slope, height, hardness, modulus, p, exact @ ..] = &cells[..] else {
                panic!("{line}")
            };
            let joint = RoughJoint::new(2.0 * k1 * k2 / (k1 + k2), *slope, *height).unwrap();
            let found = [
                joint.plastic(*p, *hardness),
                joint.elastic(*p, *modulus),
                joint.plasticity_index(*modulus, *hardness),
                joint.plastic_truncation(*p, *hardness),
                joint.elastic_truncation(*p, *modulus),
            ];
            for (worst, (found, exact)) in worst.iter_mut().zip(found.into_iter().zip(exact)) {
                *worst = worst.max((found.unwrap() / exact - 1.0).abs());
            }
            count += 1;
        }
        assert!(count == 12 && worst.iter().all(|w| *w < 1e-13), "{count}: {worst:?}");
    }

    #[test]
    fn nonsense_is_refused() {
        let joint = RoughJoint::new(50.0, 0.1, 1e-6).unwrap();
        assert!(joint.plastic(2e9, 1e9).is_err() && joint.plastic(-1.0, 1e9).is_err());
        assert!(joint.elastic(1e10, 1e10).is_err() && joint.elastic(1e6, f64::NAN).is_err());
        assert!(RoughJoint::new(0.0, 0.1, 1e-6).is_err());
        assert!(summit_plasticity_index(1e11, 1e9, 1e-6, 1e-5).unwrap() > 31.0);
        assert!(summit_plasticity_index(1e11, 0.0, 1e-6, 1e-5).is_err());
    }
}
