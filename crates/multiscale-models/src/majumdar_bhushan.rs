//! Majumdar and Bhushan's fractal model, elastic part.

use crate::spots::{FractalContact, PlasticSpots};
use crate::wide::Wide;
use contact_types::{
    Citation, ContactModel, ContactModulus, ContactState, FractalParameters, ModelError,
};
use std::f64::consts::PI;

const MODEL: &str = "Majumdar-Bhushan";

/// Contact of a fractal surface: spots of all sizes `a` with the density
/// `n(a) = (D/2) a_l^(D/2) a^(-D/2 - 1)` below the largest, `a_l`.
///
/// A spot carries `F(a) = (4 sqrt(pi)/3) E* G^(D-1) a^((3-D)/2)` elastically, so
///
/// ```math
/// \frac{A_r}{A_0} = \frac{D}{2-D}\frac{a_l}{A_0}, \qquad
/// F_e = \frac{4\sqrt\pi}{3} E^* G^{D-1}\,\frac D2\, a_l^{D/2}\,
///       \frac{a_l^\varepsilon - a_c^\varepsilon}{\varepsilon}, \qquad
/// \varepsilon = \frac{3-2D}{2}.
/// ```
///
/// - `D`: dimension of a profile, 1 < D < 2 \[-\]; `G`: fractal roughness \[m\];
/// - `A_0`: nominal area \[m²\]; `a_c`: critical area \[m²\], below which a spot is plastic.
///
/// Without a critical area (`a_c = 0`) the load exists for `D < 3/2` only and is refused from there on: the
/// negative load of the printed formula continues a divergent integral. With one every 1 < D < 2 has a
/// finite positive load, through the logarithm at D = 3/2 without loss of a digit.
///
/// ```
/// use contact_types::{ContactModel, ContactModulus, FractalParameters};
/// use multiscale_models::{MajumdarBhushan, PlasticSpots};
/// let modulus = ContactModulus::from_pascals(110e9)?;
/// // D = 1.62 has an answer only with a critical area:
/// let rough = FractalParameters { dimension: 1.62, roughness: 1e-11 };
/// let model = |plastic| MajumdarBhushan::new(rough, 1e-6, modulus, plastic);
/// assert!(model(PlasticSpots::None)?.at_pressure(10e6).is_err());
/// assert!(model(PlasticSpots::Below(1e-16))?.at_pressure(10e6).is_ok());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Majumdar & Bhushan (1991), doi:10.1115/1.2920588.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MajumdarBhushan(FractalContact);

impl MajumdarBhushan {
    /// A fractal surface of profile dimension `1 < D < 2` and roughness `G` (m) on a nominal area (m²). By the hardness `H`
    /// (Pa) a spot yields where its deformation `G^(D-1) a^(1-D/2)` exceeds `(pi H / 2E*)^2 R`, with the radius
    /// `R = a^(D/2)/(pi^2 G^(D-1))` of its asperity:
    ///
    /// ```math
    /// a_c = G^2 \left(\frac{2E^*}{H}\right)^{2/(D-1)}, \qquad
    /// F_p = H \frac{D}{2-D} a_l^{D/2} a_c^{(2-D)/2}
    /// ```
    ///
    /// # Errors
    /// [`ModelError::OutsideDomain`] unless `1 < D < 2`, and if `a_c` is beyond the range of a double;
    /// [`ModelError::InvalidInput`] for another number that is not finite and positive.
    pub fn new(
        surface: FractalParameters,
        nominal_area: f64,
        modulus: ContactModulus,
        plastic: PlasticSpots,
    ) -> Result<Self, ModelError> {
        let FractalParameters { dimension: d, roughness } = surface;
        // n(a) = (D/2) a_l^(D/2) a^(-D/2-1), F(a) = (4 sqrt(pi)/3) E* G^(D-1) a^((3-D)/2)
        let coefficient =
            |roughness: Wide| roughness.powf(d - 1.0) * modulus.pascals() * (4.0 * PI.sqrt() / 3.0);
        let numbers = [d, roughness, nominal_area];
        let contact = FractalContact::new(MODEL, ("profile", 0.0), numbers, coefficient)?;
        let critical_area = |hardness: f64| {
            let softness = Wide::from(2.0) * modulus.pascals() / hardness; // 2 E*/H
            (softness.powf(1.0 / (d - 1.0)) * roughness).powf(2.0)
        };
        let reason = "G^2 (2 E*/H)^(2/(D-1)) is beyond the range of a double: D is too close to 1";
        contact.with(plastic, critical_area, reason).map(Self)
    }
}

impl ContactModel for MajumdarBhushan {
    fn citation(&self) -> Citation {
        let title = "Fractal model of elastic-plastic contact between rough surfaces";
        let (journal, doi) = ("J. Tribol. 113, 1", "10.1115/1.2920588");
        Citation::new("Majumdar & Bhushan", 1991, title, journal, doi)
    }

    fn at_pressure(&self, mean_pressure: f64) -> Result<ContactState, ModelError> {
        let share = self.0.area_share();
        self.0.at_pressure(mean_pressure, |largest| largest * share)
    }
}
