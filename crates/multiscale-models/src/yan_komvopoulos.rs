//! Yan and Komvopoulos' fractal surface in three dimensions.

use crate::spots::{FractalContact, PlasticSpots};
use crate::wide::Wide;
use contact_types::{Citation, ContactModel, ContactModulus, ContactState, ModelError};
use std::f64::consts::PI;

const MODEL: &str = "Yan-Komvopoulos";

/// Ratio gamma of successive frequencies of the surface.
const FREQUENCY_RATIO: f64 = 1.5;

/// Contact of an isotropic fractal *surface* of dimension 2 < D < 3.
///
/// Spots are counted by their truncated area `a'`, the cut of the undeformed surface at the
/// height of the flat, with the density `n = (D-1)/2 a'_L^((D-1)/2) a'^(-(D+1)/2)`. An elastic
/// spot touches over `a'/2` (Hertz), a plastic one over `a'` under `H a'`:
///
/// ```math
/// \Delta F = \frac{2^{(11-2D)/2}}{3\pi^{(4-D)/2}}\,(\ln\gamma)^{1/2} G^{D-2} E^*\,a'^{(4-D)/2}, \qquad
/// F_e = \frac{D-1}{5-2D}\,\Delta F(a_L')\left[1 - \left(\frac{a'_c}{a'_L}\right)^{(5-2D)/2}\right],
/// ```
///
/// with a logarithm at D = 5/2. Without a critical area the load exists for D < 5/2 only.
///
/// - `D`: dimension of the surface \[-\]; `G`: fractal roughness \[m\]; `gamma`: ratio of successive
///   frequencies \[-\]; `a'_L`, `a'_c`: largest and critical truncated area \[m²\].
///
/// # Source
/// Yan & Komvopoulos (1998), doi:10.1063/1.368536.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct YanKomvopoulos(FractalContact);

impl YanKomvopoulos {
    /// A surface of dimension `2 < dimension < 3` and roughness `G` (m) on a nominal area (m²), with the frequency ratio
    /// 1.5. By the hardness `H` (Pa) a spot yields where `Delta F = H a'`:
    ///
    /// ```math
    /// a'_c = \left[\frac{2^{11-2D}}{9\pi^{4-D}}\,G^{2D-4}\left(\frac{E^*}{H}\right)^2
    ///   \ln\gamma\right]^{1/(D-2)}
    /// ```
    ///
    /// # Errors
    /// [`ModelError::OutsideDomain`] unless `2 < dimension < 3`, and if `a'_c` is beyond the range of a double;
    /// [`ModelError::InvalidInput`] for another number that is not finite and positive.
    pub fn new(
        dimension: f64,
        roughness: f64,
        nominal_area: f64,
        modulus: ContactModulus,
        plastic: PlasticSpots,
    ) -> Result<Self, ModelError> {
        let d = dimension;
        let coefficient = |roughness: Wide| {
            roughness.powf(d - 2.0)
                * modulus.pascals()
                * (((11.0 - 2.0 * d) / 2.0).exp2() / (3.0 * PI.powf((4.0 - d) / 2.0)))
                * FREQUENCY_RATIO.ln().sqrt()
        };
        let numbers = [d, roughness, nominal_area];
        let contact = FractalContact::new(MODEL, ("surface", 1.0), numbers, coefficient)?;
        // c a^((4-D)/2) = H a  =>  a = (c/H)^(2/(D-2))
        let critical_area = |hardness: f64| (contact.coefficient / hardness).powf(2.0 / (d - 2.0));
        let reason = "it is beyond the range of a double: D is too close to 2";
        contact.with(plastic, critical_area, reason).map(Self)
    }

    /// Real area of all spots: half the truncated area of the elastic ones, all of the plastic.
    fn real_area(&self, largest: Wide) -> Wide {
        let truncated = largest * self.0.area_share();
        let Some(critical) = self.0.critical else {
            return truncated / 2.0;
        };
        let ratio = largest / critical.area;
        if ratio.value() <= 1.0 {
            return truncated;
        }
        // int_0^{a_c} n a' da' = s/(1-s) a_L (a_c/a_L)^(1-s)
        let plastic = truncated / ratio.powf(1.0 - self.0.size_exponent);
        (truncated + plastic) / 2.0
    }
}

impl ContactModel for YanKomvopoulos {
    fn citation(&self) -> Citation {
        let title = "Contact analysis of elastic-plastic fractal surfaces";
        let (journal, doi) = ("J. Appl. Phys. 84, 3617", "10.1063/1.368536");
        Citation::new("Yan & Komvopoulos", 1998, title, journal, doi)
    }

    fn at_pressure(&self, mean_pressure: f64) -> Result<ContactState, ModelError> {
        self.0.at_pressure(mean_pressure, |largest| self.real_area(largest))
    }
}
