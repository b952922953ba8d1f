//! Majumdar and Bhushan's fractal model, elastic part.

use crate::spots::{self, Critical, Spots};
use crate::wide::Wide;
use contact_types::require;
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
/// Without a critical area (`a_c = 0`) the load is the paper's, and exists for `D < 3/2` only:
/// the integral over the smallest spots diverges to plus infinity from D = 3/2 on, and the
/// negative load that the formula then gives is the continuation of a divergent integral. The
/// model refuses it. With a critical area every 1 < D < 2 has a finite positive load, evaluated
/// with `expm1` so that D = 3/2, where the bracket is `ln(a_l/a_c)`, costs no digit.
///
/// ```
/// use contact_types::{ContactModel, ContactModulus, FractalParameters};
/// use multiscale_models::MajumdarBhushan;
/// let modulus = ContactModulus::from_pascals(110e9)?;
/// let surface = FractalParameters { dimension: 1.4, roughness: 1e-11 };
/// let model = MajumdarBhushan::new(surface, 1e-6, modulus)?;
/// let state = model.at_pressure(10e6)?;
/// assert!(state.area_fraction > 0.0 && state.caveat.is_none());
/// // D = 1.62 has an answer only with a critical area:
/// let rough = FractalParameters { dimension: 1.62, roughness: 1e-11 };
/// let model = MajumdarBhushan::new(rough, 1e-6, modulus)?;
/// assert!(model.at_pressure(10e6).is_err());
/// assert!(model.with_critical_area(1e-16)?.at_pressure(10e6).is_ok());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Majumdar & Bhushan (1991), doi:10.1115/1.2920588; the elastic spot law and `a_c` there. The
/// paper's closing remark that the load turns negative for D > 1.5 describes the dropped `a_c`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MajumdarBhushan {
    surface: FractalParameters,
    nominal_area: f64,
    modulus: ContactModulus,
    critical_area: f64,
    hardness: Option<f64>,
}

impl MajumdarBhushan {
    /// A fractal surface of profile dimension `1 < D < 2` and roughness `G` (m) on a nominal
    /// area (m²), without critical area.
    ///
    /// # Errors
    /// [`ModelError::OutsideDomain`] unless `1 < D < 2`; [`ModelError::InvalidInput`] for a
    /// roughness or area that is not finite and positive.
    pub fn new(
        surface: FractalParameters,
        nominal_area: f64,
        modulus: ContactModulus,
    ) -> Result<Self, ModelError> {
        check_dimension(MODEL, surface.dimension)?;
        require::positive(MODEL, "fractal roughness", surface.roughness)?;
        require::positive(MODEL, "nominal area", nominal_area)?;
        Ok(Self { surface, nominal_area, modulus, critical_area: 0.0, hardness: None })
    }

    /// Counts as elastic only the spots larger than `critical_area` (m²). Load is the elastic
    /// load; area is that of all spots.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] unless it is finite and positive.
    pub fn with_critical_area(mut self, critical_area: f64) -> Result<Self, ModelError> {
        self.critical_area = require::positive(MODEL, "critical area", critical_area)?;
        self.hardness = None;
        Ok(self)
    }

    /// Takes the critical area from the hardness `H` (Pa) of the softer body,
    /// `a_c = G^2 (2 E*/H)^(2/(D-1))`, and adds to the load what the smaller, plastic spots carry
    /// at that pressure, `F_p = H D/(2-D) a_l^(D/2) a_c^((2-D)/2)`.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] for a hardness that is not finite and positive;
    /// [`ModelError::OutsideDomain`] if `a_c` is beyond the range of a double.
    pub fn with_hardness(mut self, hardness: f64) -> Result<Self, ModelError> {
        self.critical_area = critical_area(self.surface, self.modulus, hardness)?;
        self.hardness = Some(hardness);
        Ok(self)
    }

    /// Area below which a spot is plastic \[m²\]; 0 if none was set.
    pub fn critical_area(&self) -> f64 {
        self.critical_area
    }

    /// Largest spot `a_l = (2 - D)/D A_r` \[m²\] at an area fraction.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] unless the area fraction is finite and not negative.
    pub fn largest_spot(&self, area_fraction: f64) -> Result<f64, ModelError> {
        require::not_negative(MODEL, "area fraction", area_fraction)?;
        Ok(self.spot(area_fraction).value().min(f64::MAX))
    }

    fn spot(&self, area_fraction: f64) -> Wide {
        let d = self.surface.dimension;
        Wide::from(area_fraction) * self.nominal_area * ((2.0 - d) / d)
    }

    /// The nominal pressure \[Pa\] at which the area fraction is `area_fraction`.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] unless the area fraction is finite and not negative;
    /// [`ModelError::OutsideDomain`] without a critical area for D >= 1.5, and where the
    /// pressure exceeds the largest double.
    pub fn pressure_at_area(&self, area_fraction: f64) -> Result<f64, ModelError> {
        require::not_negative(MODEL, "area fraction", area_fraction)?;
        self.check_convergence()?;
        let largest = self.spot(area_fraction);
        if largest.is_zero() {
            return Ok(0.0);
        }
        let load = match self.critical() {
            Some(critical) => self.spots().load_with(critical, largest),
            None => self.spots().load(largest),
        };
        require::representable(MODEL, "mean pressure", (load / self.nominal_area).value())
    }

    /// `n(a) = (D/2) a_l^(D/2) a^(-D/2-1)`, `F(a) = (4 sqrt(pi)/3) E* G^(D-1) a^((3-D)/2)`.
    fn spots(&self) -> Spots {
        let d = self.surface.dimension;
        Spots {
            size_exponent: d / 2.0,
            load_exponent: (3.0 - d) / 2.0,
            epsilon: 1.5 - d, // exact for every double near D = 3/2
            coefficient: Wide::from(self.surface.roughness).powf(d - 1.0)
                * self.modulus.pascals()
                * (4.0 * PI.sqrt() / 3.0),
        }
    }

    fn critical(&self) -> Option<Critical> {
        (self.critical_area > 0.0).then(|| Critical {
            area: Wide::from(self.critical_area),
            hardness: Wide::from(self.hardness.unwrap_or(0.0)),
        })
    }

    /// Refuses a load integral that has no value.
    fn check_convergence(&self) -> Result<(), ModelError> {
        if self.critical_area > 0.0 || self.surface.dimension < 1.5 {
            return Ok(());
        }
        Err(ModelError::OutsideDomain {
            model: MODEL.into(),
            quantity: "D".into(),
            value: self.surface.dimension,
            domain: 1.0..=1.5,
            reason: "the load of ever smaller elastic spots diverges for D >= 1.5; give a \
                     critical area, below which spots are plastic"
                .into(),
        })
    }
}

/// Critical spot area by Majumdar & Bhushan \[m²\]: a spot of area `a` deforms by
/// `delta = G^(D-1) a^(1-D/2)`, its asperity has the radius `a^(D/2)/(pi^2 G^(D-1))`, and it
/// yields beyond `delta_c = (pi H / 2E*)^2 R`:
///
/// ```math
/// a_c = G^2 \left(\frac{2E^*}{H}\right)^{2/(D-1)}
/// ```
///
/// Spots *smaller* than `a_c` are plastic.
///
/// # Errors
/// [`ModelError::InvalidInput`] for a roughness or hardness that is not finite and positive;
/// [`ModelError::OutsideDomain`] unless `1 < D < 2`, and where `a_c` is beyond the range of a
/// double.
///
/// # Source
/// Majumdar & Bhushan (1991), doi:10.1115/1.2920588.
pub fn critical_area(
    surface: FractalParameters,
    modulus: ContactModulus,
    hardness: f64,
) -> Result<f64, ModelError> {
    let d = check_dimension(MODEL, surface.dimension)?;
    let roughness = require::positive(MODEL, "fractal roughness", surface.roughness)?;
    let hardness = require::positive(MODEL, "hardness", hardness)?;
    let softness = Wide::from(2.0) * modulus.pascals() / hardness; // 2 E*/H
    let area = (softness.powf(1.0 / (d - 1.0)) * roughness).powf(2.0).value();
    if area > 0.0 && area.is_finite() {
        return Ok(area);
    }
    Err(ModelError::OutsideDomain {
        model: MODEL.into(),
        quantity: "critical area".into(),
        value: area.min(f64::MAX),
        domain: f64::MIN_POSITIVE..=f64::MAX,
        reason: "G^2 (2 E*/H)^(2/(D-1)) is beyond the range of a double: D is too close to 1"
            .into(),
    })
}

/// Dimension of a profile, strictly between 1 and 2.
pub(crate) fn check_dimension(model: &'static str, dimension: f64) -> Result<f64, ModelError> {
    if dimension > 1.0 && dimension < 2.0 {
        return Ok(dimension);
    }
    Err(ModelError::OutsideDomain {
        model: model.into(),
        quantity: "D".into(),
        value: dimension,
        domain: 1.0..=2.0,
        reason: "the dimension of a fractal profile lies strictly between 1 and 2".into(),
    })
}

impl ContactModel for MajumdarBhushan {
    fn citation(&self) -> Citation {
        Citation {
            authors: "Majumdar & Bhushan".into(),
            year: 1991,
            title: "Fractal model of elastic-plastic contact between rough surfaces".into(),
            journal: "J. Tribol. 113, 1".into(),
            doi: "10.1115/1.2920588".into(),
        }
    }

    fn at_pressure(&self, mean_pressure: f64) -> Result<ContactState, ModelError> {
        require::pressure(MODEL, mean_pressure)?;
        self.check_convergence()?;
        let load = Wide::from(mean_pressure) * self.nominal_area;
        let spot = match self.critical() {
            _ if load.is_zero() => load,
            Some(critical) => self.spots().largest_with(critical, load),
            None => self.spots().largest(load),
        };
        let area = (spot * self.spots().area_share() / self.nominal_area).value();
        let area_fraction = require::representable(MODEL, "area fraction", area)?;
        let largest_fraction = (spot / self.nominal_area).value().min(f64::MAX);
        Ok(spots::state(mean_pressure, area_fraction, largest_fraction))
    }
}
