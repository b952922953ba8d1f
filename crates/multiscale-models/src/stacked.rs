//! The stacked multiscale model: complete contact at the steepest scale decides.

use crate::answer::up_to_complete;
use crate::wide::Wide;
use contact_types::{Citation, ContactModel, ContactModulus, ContactState, ModelError, require};
use std::f64::consts::PI;

const MODEL: &str = "stacked multiscale";

/// Stacked sinusoids: the real pressure is the pressure that flattens the steepest of them.
///
/// A bi-sinusoidal surface `Δ cos(2πx/λ) cos(2πy/λ)` is flattened completely by the mean
/// pressure
///
/// ```math
/// p^* = \sqrt2\,\pi E^* \frac{\Delta}{\lambda} = \sqrt2\,\pi E^* B,
/// ```
///
/// and the scale with the largest `B = Δ/λ` needs most: `p_r = sqrt(2) pi E* B_max`, whatever
/// the load, and `A/A_0 = min(1, p / p_r)`.
///
/// `B_max` is amplitude (not peak to valley) over wavelength \[-\]; it depends on the record length and the
/// finest scale resolved.
///
/// ```
/// use contact_types::{ContactModel, ContactModulus};
/// use multiscale_models::Stacked;
/// let model = Stacked::new(0.01, ContactModulus::from_pascals(110e9)?)?;
/// let state = model.at_pressure(50e6)?;
/// assert!((state.area_fraction - 0.010231).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Jackson, Wilson & Angadi (2008), STLE/ASME IJTC, Miami; Jackson & Green (2009),
/// IJTC2009-15106, eqs (3)-(4), where the root must cover the 2 alone as in `p*` of Johnson, Greenwood &
/// Higginson (1985), doi:10.1016/0020-7403(85)90029-3.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stacked {
    max_amplitude_ratio: f64,
    modulus: ContactModulus,
}

impl Stacked {
    /// From `B_max`, the largest amplitude over wavelength \[-\], as
    /// [`AmplitudeSpectrum::max_amplitude_ratio`](contact_types::AmplitudeSpectrum::max_amplitude_ratio).
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] if it is negative or not finite. 0, a flat surface, is
    /// accepted.
    pub fn new(max_amplitude_ratio: f64, modulus: ContactModulus) -> Result<Self, ModelError> {
        require::not_negative(MODEL, "largest amplitude over wavelength", max_amplitude_ratio)?;
        Ok(Self { max_amplitude_ratio, modulus })
    }
}

/// Mean pressure that flattens a bi-sinusoid of amplitude over wavelength `ratio`.
pub(crate) fn complete_contact_pressure(modulus: ContactModulus, ratio: Wide) -> Wide {
    ratio * (std::f64::consts::SQRT_2 * PI) * modulus.pascals()
}

impl ContactModel for Stacked {
    fn citation(&self) -> Citation {
        let title = "A study of the average real contact pressure between rough surfaces";
        let journal = "STLE/ASME International Joint Tribology Conference, Miami";
        Citation::new("Jackson, Wilson & Angadi", 2008, title, journal, "")
    }

    fn at_pressure(&self, mean_pressure: f64) -> Result<ContactState, ModelError> {
        require::pressure(MODEL, mean_pressure)?;
        let real_pressure =
            complete_contact_pressure(self.modulus, Wide::from(self.max_amplitude_ratio));
        let area_fraction = if mean_pressure <= 0.0 {
            0.0
        } else if real_pressure.is_zero() {
            1.0 // flat
        } else {
            (Wide::from(mean_pressure) / real_pressure).value().min(1.0)
        };
        Ok(up_to_complete(mean_pressure, area_fraction))
    }
}
