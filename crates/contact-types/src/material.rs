//! Elastic bodies and the one modulus their contact depends on.

use crate::SurfaceError;

/// An isotropic linear elastic body.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Elastic {
    young: f64,
    poisson: f64,
}

impl Elastic {
    /// Young's modulus in Pa (> 0) and Poisson's ratio (-1 < nu <= 0.5).
    ///
    /// # Errors
    /// [`SurfaceError::Material`].
    pub fn new(young: f64, poisson: f64) -> Result<Self, SurfaceError> {
        let young = positive_modulus("Young's modulus", young)?;
        if !(poisson > -1.0 && poisson <= 0.5) {
            return Err(SurfaceError::Material {
                quantity: "Poisson's ratio",
                value: poisson,
                unit: "",
                domain: -1.0..=0.5,
            });
        }
        Ok(Self { young, poisson })
    }

    /// Plane-strain modulus `E / (1 - nu^2)` \[Pa\].
    pub(crate) fn plane_strain_modulus(&self) -> f64 {
        self.young / (1.0 - self.poisson * self.poisson)
    }
}

/// A modulus in Pa: a positive normal number.
fn positive_modulus(quantity: &'static str, value: f64) -> Result<f64, SurfaceError> {
    if value.is_normal() && value > 0.0 {
        return Ok(value);
    }
    let domain = f64::MIN_POSITIVE..=f64::MAX;
    Err(SurfaceError::Material { quantity, value, unit: "Pa", domain })
}

/// Contact modulus E* in Pa. Never a bare `f64`, so it cannot be confused with Young's modulus.
///
/// ```math
/// \frac{1}{E^*} = \frac{1-\nu_1^2}{E_1} + \frac{1-\nu_2^2}{E_2}
/// ```
///
/// # Source
/// Johnson (1985), *Contact Mechanics*, eq. (4.20); doi:10.1017/CBO9781139171731.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ContactModulus(f64);

impl ContactModulus {
    /// That of bodies that do not deform elastically: what models without elasticity are given.
    pub const RIGID: Self = Self(f64::INFINITY);

    /// E* given directly, in Pa.
    ///
    /// # Errors
    /// [`SurfaceError::Material`] unless it is a positive normal number.
    pub fn from_pascals(pascals: f64) -> Result<Self, SurfaceError> {
        positive_modulus("contact modulus", pascals).map(Self)
    }

    /// E* of two elastic bodies, or of one against a rigid one (`None`).
    ///
    /// # Errors
    /// [`SurfaceError::Material`] if the result is not a normal number.
    pub fn of_pair(
        first: Elastic,
        second: impl Into<Option<Elastic>>,
    ) -> Result<Self, SurfaceError> {
        let a = first.plane_strain_modulus();
        let b = second.into().map_or(f64::INFINITY, |second| second.plane_strain_modulus());
        // a b / (a + b), written so that neither product nor sum can overflow.
        let (small, large) = if a < b { (a, b) } else { (b, a) };
        Self::from_pascals(small / (1.0 + small / large))
    }

    /// E* \[Pa\].
    pub fn pascals(self) -> f64 {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::close;

    #[test]
    fn two_steel_bodies() {
        // 1/E* = 2 (1 - 0.3^2) / 210 GPa
        let steel = Elastic::new(210e9, 0.3).unwrap();
        let modulus = ContactModulus::of_pair(steel, steel).unwrap();
        close(modulus.pascals(), 210e9 / (2.0 * 0.91), 1e-15);
        close(ContactModulus::of_pair(steel, None).unwrap().pascals(), 210e9 / 0.91, 1e-15);
    }

    #[test]
    fn refuses_impossible_bodies() {
        for (e, nu) in [(0.0, 0.3), (-1.0, 0.3), (f64::NAN, 0.3), (1e9, 0.51), (1e9, -1.0)] {
            assert!(Elastic::new(e, nu).is_err(), "E = {e}, nu = {nu}");
        }
        assert!(Elastic::new(1e9, 0.5).is_ok());
    }
}
