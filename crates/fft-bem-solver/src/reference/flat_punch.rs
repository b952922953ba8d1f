//! A rigid circular punch with a flat end.

use contact_types::require::{not_negative, positive};
use contact_types::{ContactModulus, ModelError};
use std::f64::consts::PI;

/// A flat-ended cylinder of radius `a` on a half space.
///
/// ```math
/// p=\frac{F}{2\pi a^2}\Bigl(1-\frac{r^2}{a^2}\Bigr)^{-1/2},\qquad \delta=\frac{F}{2E^*a}
/// ```
///
/// # Source
/// Johnson (1985), *Contact Mechanics*, §3.4, eqs. (3.34)–(3.36).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlatPunch {
    radius: f64,
    modulus: ContactModulus,
}

impl FlatPunch {
    /// Radius of the punch in m.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] if it is not finite and positive.
    pub fn new(radius: f64, modulus: ContactModulus) -> Result<Self, ModelError> {
        Ok(Self { radius: positive("flat punch", "radius", radius)?, modulus })
    }

    /// Approach (m) under `force` (N).
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] if the force is negative or not finite.
    pub fn approach(&self, force: f64) -> Result<f64, ModelError> {
        let force = not_negative("flat punch", "force", force)?;
        Ok(force / (2.0 * self.modulus.pascals() * self.radius))
    }

    /// Pressure (Pa) under `force` (N) at distance `r` (m) from the axis; infinite at the edge, 0
    /// outside.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] if the force is negative or not finite.
    pub fn pressure(&self, force: f64, r: f64) -> Result<f64, ModelError> {
        let force = not_negative("flat punch", "force", force)?;
        let a = self.radius;
        let inside = 1.0 - (r / a).powi(2);
        if inside < 0.0 {
            return Ok(0.0);
        }
        Ok(force / (2.0 * PI * a * a) / inside.sqrt())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn pressure_integrates_to_the_force() {
        let punch = FlatPunch::new(2.0, ContactModulus::from_pascals(5.0).unwrap()).unwrap();
        // r = a sin s removes the singularity: p 2 pi r dr = F sin s ds.
        let n = 1000;
        let sum: f64 = (0..n)
            .map(|i| {
                let s = 0.5 * PI * (f64::from(i) + 0.5) / f64::from(n);
                let r = 2.0 * s.sin();
                punch.pressure(3.0, r).unwrap() * 2.0 * PI * r * 2.0 * s.cos() * 0.5 * PI
                    / f64::from(n)
            })
            .sum();
        assert_relative_eq!(sum, 3.0, max_relative = 1e-6);
        assert_relative_eq!(punch.approach(3.0).unwrap(), 3.0 / 20.0);
    }
}
