//! A rigid circular punch with a flat end.

use contact_types::require::{not_negative, positive};
use contact_types::{ContactModulus, ModelError};

/// A flat-ended cylinder of radius `a` on a half space.
///
/// ```math
/// p=\frac{F}{2\pi a^2}\Bigl(1-\frac{r^2}{a^2}\Bigr)^{-1/2},\qquad \delta=\frac{F}{2E^*a}
/// ```
///
/// # Source
/// Johnson (1985), *Contact Mechanics*, §3.4, eqs. (3.34)–(3.36).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FlatPunch {
    radius: f64,
    modulus: ContactModulus,
}

impl FlatPunch {
    /// Radius of the punch in m.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] if it is not finite and positive.
    pub(crate) fn new(radius: f64, modulus: ContactModulus) -> Result<Self, ModelError> {
        Ok(Self { radius: positive("flat punch", "radius", radius)?, modulus })
    }

    /// Approach (m) under `force` (N).
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] if the force is negative or not finite.
    pub(crate) fn approach(&self, force: f64) -> Result<f64, ModelError> {
        let force = not_negative("flat punch", "force", force)?;
        Ok(force / (2.0 * self.modulus.pascals() * self.radius))
    }
}
