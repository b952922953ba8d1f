//! Jackson and Streator's recursion over the sinusoids of a profile.

use crate::answer::up_to_complete;
use crate::stacked::complete_contact_pressure;
use crate::wide::Wide;
use contact_types::{
    AmplitudeSpectrum, Citation, ContactModel, ContactModulus, ContactState, ModelError, require,
};
use std::f64::consts::PI;

const MODEL: &str = "Jackson-Streator";

/// Sinusoids stacked from long to short: each carries the whole load on the area that the longer
/// ones left.
///
/// ```math
/// A_k = A_{k-1}\; g\!\left(\frac{F/A_{k-1}}{p^*_k}\right), \qquad
/// p^*_k = \sqrt2\,\pi E^* \Delta_k f_k, \qquad k \text{ by rising frequency,}
/// ```
///
/// where `g` is the area fraction of one bi-sinusoidal surface, by the published fit:
///
/// ```math
/// g = g_1(1 - x^{1.51}) + g_2\,x^{1.04} \;(x < 0.8), \quad g = g_2 \;(0.8 \le x < 1), \qquad
/// g_1 = \pi\left(\frac{3x}{8\pi}\right)^{2/3}, \quad g_2 = 1 - \frac{3}{2\pi}(1-x).
/// ```
///
/// The pressure grows as the area falls, so short waves of small `Δ f` are flat and change nothing.
/// The fit falls by 4.2e-4 at x = 0.8, so that the area is not strictly monotone there.
///
/// The amplitudes of a random surface depend on the record length and on the finest frequency.
///
/// ```
/// use contact_types::{AmplitudeSpectrum, ContactModel, ContactModulus, Wave};
/// use multiscale_models::JacksonStreator;
/// let waves = vec![
///     Wave { frequency: 5e4, amplitude: 1e-7 },
///     Wave { frequency: 1.5e5, amplitude: 4e-8 },
///     Wave { frequency: 3.5e5, amplitude: 1.5e-8 },
/// ];
/// let spectrum = AmplitudeSpectrum::new(waves, 20e-6)?;
/// let model = JacksonStreator::new(spectrum, ContactModulus::from_pascals(110e9)?);
/// let state = model.at_pressure(110e6)?;
/// assert!((state.area_fraction - 0.0505014).abs() < 1e-7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Jackson & Streator (2006), doi:10.1016/j.wear.2006.03.015. `g` is normalised per asperity, with 2 f^2
/// asperities per area: only that closes at full contact.
#[derive(Debug, Clone, PartialEq)]
pub struct JacksonStreator {
    amplitudes: AmplitudeSpectrum,
    modulus: ContactModulus,
}

impl JacksonStreator {
    /// From the amplitudes of a profile by frequency.
    pub fn new(amplitudes: AmplitudeSpectrum, modulus: ContactModulus) -> Self {
        Self { amplitudes, modulus }
    }
}

impl ContactModel for JacksonStreator {
    fn citation(&self) -> Citation {
        let title = "A multi-scale model for contact between rough surfaces";
        let doi = "10.1016/j.wear.2006.03.015";
        Citation::new("Jackson & Streator", 2006, title, "Wear 261, 1337", doi)
    }

    fn at_pressure(&self, mean_pressure: f64) -> Result<ContactState, ModelError> {
        require::pressure(MODEL, mean_pressure)?;
        let load = Wide::from(mean_pressure);
        let mut area = Wide::from(if mean_pressure > 0.0 { 1.0 } else { 0.0 });
        for wave in self.amplitudes.waves() {
            let ratio = Wide::from(wave.amplitude) * wave.frequency;
            if ratio.is_zero() || area.is_zero() {
                continue;
            }
            let complete = complete_contact_pressure(self.modulus, ratio);
            let pressure = load / area;
            area = area * sinusoid(pressure / complete);
        }
        Ok(up_to_complete(mean_pressure, area.value()))
    }
}

/// Real over nominal area of a bi-sinusoid `Δ cos(2πx/λ) cos(2πy/λ)` at the mean pressure `x = p/p*` over that of
/// complete contact, which must not be zero: the published fit. Both ends are exact, Hertz contact of the crests and the
/// last valleys, which close as penny-shaped cracks.
fn sinusoid(x: Wide) -> Wide {
    let load = x.value();
    if load < 1e-60 {
        // g1 is exact to rounding, also beyond the range of a double.
        let root = (x * (3.0 / (8.0 * PI))).cbrt();
        return root * root * PI;
    }
    let hertz = PI * (3.0 * load / (8.0 * PI)).cbrt().powi(2);
    let last_valleys = 1.0 - 3.0 / (2.0 * PI) * (1.0 - load);
    Wide::from(if load < 0.8 {
        hertz * (1.0 - load.powf(1.51)) + last_valleys * load.powf(1.04)
    } else {
        last_valleys.min(1.0)
    })
}
