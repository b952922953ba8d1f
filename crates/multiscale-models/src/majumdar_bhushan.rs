//! Majumdar and Bhushan's fractal model, elastic part.

use crate::require;
use crate::wide::Wide;
use contact_types::{
    Caveat, Citation, ContactModel, ContactModulus, ContactState, FractalParameters, ModelError,
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
        let load = if self.critical_area > 0.0 {
            self.load_with_critical_area(largest).total()
        } else {
            self.load_without_critical_area(largest)
        };
        require::representable(MODEL, "mean pressure", (load / self.nominal_area).value())
    }

    /// `(4 sqrt(pi)/3) E* G^(D-1) a^((3-D)/2)`: elastic load of one spot of area `a`.
    fn spot_load(&self, area: Wide) -> Wide {
        let d = self.surface.dimension;
        Wide::from(self.surface.roughness).powf(d - 1.0)
            * area.powf((3.0 - d) / 2.0)
            * self.modulus.pascals()
            * (4.0 * PI.sqrt() / 3.0)
    }

    /// `F_e = F(a_l) D/(3 - 2D)`, for D < 3/2.
    fn load_without_critical_area(&self, largest: Wide) -> Wide {
        let d = self.surface.dimension;
        self.spot_load(largest) * (d / (3.0 - 2.0 * d))
    }

    /// With `L = ln(a_l/a_c)`:
    ///
    /// ```math
    /// F_e = F(a_l)\,\frac D2\,\frac{1 - e^{-\varepsilon L}}{\varepsilon}, \qquad
    /// F_p = H\,\frac{D}{2-D}\,a_l^{D/2} a_c^{1-D/2}
    /// ```
    fn load_with_critical_area(&self, largest: Wide) -> SplitLoad {
        let d = self.surface.dimension;
        let ratio = largest / self.critical_area;
        let log_ratio = ratio.ln();
        let share = d / (2.0 - d);
        let hardness = Wide::from(self.hardness.unwrap_or(0.0));
        if log_ratio <= 0.0 {
            // Every spot is plastic; without a hardness those are not counted.
            let plastic = hardness * share * largest;
            return SplitLoad { elastic: Wide::from(0.0), plastic, slope: 1.0 };
        }
        let epsilon = 1.5 - d; // exact for every double near D = 3/2
        // (1 - e^{-|eps| L}) / |eps| -> L at D = 3/2
        let decay = epsilon.abs() * log_ratio;
        let bracket = if decay > 1e-300 { -(-decay).exp_m1() / epsilon.abs() } else { log_ratio };
        let growth = if epsilon < 0.0 { ratio.powf(-epsilon) } else { Wide::from(1.0) };
        let elastic = self.spot_load(largest) * growth * (0.5 * d * bracket);
        let plastic = hardness * share * self.critical_area * ratio.powf(0.5 * d);
        // d ln F / d ln a_l
        let elastic_slope = 0.5 * d + 1.0 / bracket + epsilon.min(0.0);
        let weight = 1.0 / (1.0 + (plastic / elastic).value());
        let slope = 0.5 * d + weight * (elastic_slope - 0.5 * d);
        SplitLoad { elastic, plastic, slope }
    }

    /// Largest spot that carries `load` (N), without critical area.
    fn spot_without_critical_area(&self, load: Wide) -> Wide {
        let d = self.surface.dimension;
        let unit = self.load_without_critical_area(Wide::from(1.0));
        (load / unit).powf(2.0 / (3.0 - d))
    }

    /// Largest spot that carries `load` (N), with critical area: Newton for `ln F` in
    /// `v = ln L`, kept inside a bracket.
    fn spot_with_critical_area(&self, load: Wide) -> Wide {
        let critical = Wide::from(self.critical_area);
        let threshold = self.load_with_critical_area(critical).plastic;
        if !threshold.is_zero() && (load / threshold).value() <= 1.0 {
            // All spots plastic: load is hardness times area.
            return critical * (load / threshold);
        }
        let (mut lo, mut hi) = ((-740.0_f64), 8.0_f64); // L from 1e-321 to 2981
        let mut v = 1.0_f64;
        for _ in 0..200 {
            let log_ratio = v.exp();
            let split = self.load_with_critical_area(critical * Wide::exp(log_ratio));
            let mismatch = if split.total().is_zero() {
                f64::NEG_INFINITY
            } else {
                (split.total() / load).ln()
            };
            if mismatch > 0.0 {
                hi = v;
            } else {
                lo = v;
            }
            let newton = v - mismatch / (split.slope * log_ratio);
            let next = if newton > lo && newton < hi { newton } else { 0.5 * (lo + hi) };
            let step = (next - v).abs();
            v = next;
            // An error in v matters only by its effect on the area, L dv.
            if step <= 1e-9 * v.abs().max(1.0) || step * v.exp() < 1e-17 {
                break;
            }
        }
        let mut spot = critical * Wide::exp(v.exp());
        // Two more steps on the spot itself, where its logarithm has lost digits.
        for _ in 0..2 {
            let split = self.load_with_critical_area(spot);
            if v > 0.0 {
                let mismatch = (split.total() / load).ln();
                spot = spot * (-mismatch / split.slope).exp();
            }
        }
        spot
    }

    /// Refuses a load integral that has no value.
    fn check_convergence(&self) -> Result<(), ModelError> {
        if self.critical_area > 0.0 || self.surface.dimension < 1.5 {
            return Ok(());
        }
        Err(ModelError::OutsideDomain {
            model: MODEL,
            quantity: "D",
            value: self.surface.dimension,
            domain: 1.0..=1.5,
            reason: "the load of ever smaller elastic spots diverges for D >= 1.5; give a \
                     critical area below which spots are plastic (with_critical_area or \
                     with_hardness)",
        })
    }
}

/// Load by kind, and `d ln F / d ln a_l` of their sum.
struct SplitLoad {
    elastic: Wide,
    plastic: Wide,
    slope: f64,
}

impl SplitLoad {
    fn total(&self) -> Wide {
        self.elastic + self.plastic
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
        model: MODEL,
        quantity: "critical area",
        value: area.min(f64::MAX),
        domain: f64::MIN_POSITIVE..=f64::MAX,
        reason: "G^2 (2 E*/H)^(2/(D-1)) is beyond the range of a double: D is too close to 1",
    })
}

/// Dimension of a profile, strictly between 1 and 2.
pub(crate) fn check_dimension(model: &'static str, dimension: f64) -> Result<f64, ModelError> {
    if dimension > 1.0 && dimension < 2.0 {
        return Ok(dimension);
    }
    Err(ModelError::OutsideDomain {
        model,
        quantity: "D",
        value: dimension,
        domain: 1.0..=2.0,
        reason: "the dimension of a fractal profile lies strictly between 1 and 2",
    })
}

impl ContactModel for MajumdarBhushan {
    fn citation(&self) -> Citation {
        Citation {
            authors: "Majumdar & Bhushan",
            year: 1991,
            title: "Fractal model of elastic-plastic contact between rough surfaces",
            journal: "J. Tribol. 113, 1",
            doi: "10.1115/1.2920588",
        }
    }

    fn at_pressure(&self, mean_pressure: f64) -> Result<ContactState, ModelError> {
        require::pressure(MODEL, mean_pressure)?;
        self.check_convergence()?;
        let d = self.surface.dimension;
        let load = Wide::from(mean_pressure) * self.nominal_area;
        let spot = if load.is_zero() {
            load
        } else if self.critical_area > 0.0 {
            self.spot_with_critical_area(load)
        } else {
            self.spot_without_critical_area(load)
        };
        let area = (spot * (d / (2.0 - d)) / self.nominal_area).value();
        let area_fraction = require::representable(MODEL, "area fraction", area)?;
        let largest_fraction = (spot / self.nominal_area).value();
        let beyond = |quantity, value, reason| {
            Some(Caveat::BeyondModel { quantity, value, limit: 1.0, reason })
        };
        let caveat = if area_fraction <= 0.0 && mean_pressure > 0.0 {
            Some(Caveat::Underflow { quantity: "area fraction" })
        } else if area_fraction > 1.0 {
            beyond("area fraction", area_fraction, "the spots cover more than the nominal area")
        } else if largest_fraction > 1.0 {
            beyond("largest spot", largest_fraction, "one spot is larger than the nominal area")
        } else {
            None
        };
        Ok(ContactState { mean_pressure, area_fraction, separation: None, mean_gap: None, caveat })
    }
}
