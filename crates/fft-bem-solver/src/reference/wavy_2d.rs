//! The bi-sinusoid: an egg-box against a flat.

use contact_types::require::positive;
use contact_types::{ContactModulus, ModelError};
use std::f64::consts::{PI, SQRT_2};

/// The surface `z = amplitude cos(2 pi x / wavelength) cos(2 pi y / wavelength)` pressed on a flat.
///
/// No closed form is known between its two limits.
///
/// ```math
/// p^*=\sqrt2\,\pi E^*\frac{\Delta}{\lambda},\quad x=\frac{\bar p}{p^*},\quad
/// \frac{A_r}{A_n}\to\pi\Bigl(\frac{3x}{8\pi}\Bigr)^{2/3}\ (x\to0),\quad
/// \frac{A_r}{A_n}\to1-\frac{3}{2\pi}(1-x)\ (x\to1)
/// ```
///
/// # Source
/// Johnson, Greenwood & Higginson (1985), *Int. J. Mech. Sci.* 27, 383–396,
/// doi:10.1016/0020-7403(85)90029-3.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BiSinusoid {
    amplitude: f64,
    wavelength: f64,
    modulus: ContactModulus,
}

impl BiSinusoid {
    /// Amplitude (mean plane to summit) and wavelength along x and y in m.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] if one is not finite and positive.
    pub fn new(
        amplitude: f64,
        wavelength: f64,
        modulus: ContactModulus,
    ) -> Result<Self, ModelError> {
        positive("bi-sinusoid", "amplitude", amplitude)?;
        positive("bi-sinusoid", "wavelength", wavelength)?;
        Ok(Self { amplitude, wavelength, modulus })
    }

    /// Height (m) at `(y, x)` from a summit.
    pub fn height(&self, y: f64, x: f64) -> f64 {
        let turn = 2.0 * PI / self.wavelength;
        self.amplitude * (turn * y).cos() * (turn * x).cos()
    }

    /// Mean pressure p* that closes every gap (Pa).
    pub fn closing_pressure(&self) -> f64 {
        SQRT_2 * PI * self.modulus.pascals() * self.amplitude / self.wavelength
    }
}
