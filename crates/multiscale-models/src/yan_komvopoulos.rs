//! Yan and Komvopoulos' fractal surface in three dimensions.

use crate::answer::{citation, outside};
use crate::spots::FractalContact;
use crate::wide::Wide;
use contact_types::{Citation, ContactModel, ContactModulus, ContactState, ModelError, require};
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
    /// A surface of dimension `2 < dimension < 3` and roughness `G` (m) on a nominal area (m²),
    /// with the frequency ratio 1.5 and no critical area.
    ///
    /// # Errors
    /// [`ModelError::OutsideDomain`] unless `2 < dimension < 3`; [`ModelError::InvalidInput`] for
    /// a roughness or area that is not finite and positive.
    pub fn new(
        dimension: f64,
        roughness: f64,
        nominal_area: f64,
        modulus: ContactModulus,
    ) -> Result<Self, ModelError> {
        let d = dimension;
        if !(d > 2.0 && d < 3.0) {
            let reason = "the dimension of a fractal surface lies strictly between 2 and 3";
            return Err(outside(MODEL, "D", d, 2.0..=3.0, reason));
        }
        require::positive(MODEL, "fractal roughness", roughness)?;
        require::positive(MODEL, "nominal area", nominal_area)?;
        Ok(Self(FractalContact {
            model: MODEL,
            dimension,
            size_exponent: (d - 1.0) / 2.0,
            load_exponent: (4.0 - d) / 2.0,
            epsilon: 2.5 - d, // exact for every double near D = 5/2
            coefficient: Wide::from(roughness).powf(d - 2.0)
                * modulus.pascals()
                * (((11.0 - 2.0 * d) / 2.0).exp2() / (3.0 * PI.powf((4.0 - d) / 2.0)))
                * FREQUENCY_RATIO.ln().sqrt(),
            nominal_area,
            critical: None,
        }))
    }

    /// Counts as elastic only spots of truncated area above `critical_area` (m²). Load is the
    /// elastic load; area is that of all spots.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] unless it is finite and positive.
    pub fn with_critical_area(self, critical_area: f64) -> Result<Self, ModelError> {
        self.0.with_critical_area(critical_area).map(Self)
    }

    /// Takes the critical area from the hardness `H` (Pa), where `Delta F = H a'`,
    ///
    /// ```math
    /// a'_c = \left[\frac{2^{11-2D}}{9\pi^{4-D}}\,G^{2D-4}\left(\frac{E^*}{H}\right)^2
    ///   \ln\gamma\right]^{1/(D-2)}
    /// ```
    ///
    /// and adds what the smaller, plastic spots carry.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] for a hardness that is not finite and positive;
    /// [`ModelError::OutsideDomain`] if `a'_c` is beyond the range of a double.
    pub fn with_hardness(self, hardness: f64) -> Result<Self, ModelError> {
        require::positive(MODEL, "hardness", hardness)?;
        // c a^((4-D)/2) = H a  =>  a = (c/H)^(2/(D-2))
        let ratio = self.0.coefficient / hardness;
        let area = ratio.powf(2.0 / (self.0.dimension - 2.0));
        let reason = "it is beyond the range of a double: D is too close to 2";
        self.0.with_hardness(hardness, area, reason).map(Self)
    }

    /// The nominal pressure \[Pa\] at which the largest truncated spot is `largest` (m²).
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] unless `largest` is finite and not negative;
    /// [`ModelError::OutsideDomain`] without a critical area for D >= 2.5, and where the pressure
    /// exceeds the largest double.
    pub fn pressure_at_largest_spot(&self, largest: f64) -> Result<f64, ModelError> {
        self.0.pressure(Wide::from(require::not_negative(MODEL, "largest spot", largest)?))
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
        citation("Yan & Komvopoulos", 1998, title, journal, doi)
    }

    fn at_pressure(&self, mean_pressure: f64) -> Result<ContactState, ModelError> {
        self.0.at_pressure(mean_pressure, |largest| self.real_area(largest))
    }
}
