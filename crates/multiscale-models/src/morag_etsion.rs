//! Morag and Etsion's asperity of a fractal surface.

use crate::majumdar_bhushan::check_dimension;
use crate::wide::Wide;
use contact_types::require;
use contact_types::{ContactModulus, FractalParameters, ModelError};
use std::f64::consts::PI;

const MODEL: &str = "Morag-Etsion";

/// One asperity of a fractal surface, whose shape is fixed by its base and not by its load.
///
/// Majumdar and Bhushan take the radius of an asperity from its *contact spot*, so a growing
/// spot becomes elastic. Here the radius belongs to the base length `l`, which no load changes:
///
/// ```math
/// \delta_\max = G^{D-1} l^{2-D}, \qquad R = \frac{l^D}{\pi^2 G^{D-1}}, \qquad
/// \omega_c = \left(\frac{\pi H}{2E^*}\right)^2 R
/// ```
///
/// It is elastic (Hertz) up to the interference `omega_c` and plastic beyond, in this order, as
/// for any sphere. An asperity with `l` above
///
/// ```math
/// l_c = G\left(\frac{2E^*}{H}\right)^{1/(D-1)}
/// ```
///
/// is flat before it yields (`delta_max < omega_c`).
///
/// ```
/// use contact_types::{ContactModulus, FractalParameters};
/// use multiscale_models::MoragEtsion;
/// let surface = FractalParameters { dimension: 1.4, roughness: 1e-11 };
/// let asperity = MoragEtsion::new(surface, 1e-6, ContactModulus::from_pascals(110e9)?)?;
/// let contact = asperity.at_interference(0.1 * asperity.amplitude())?;
/// assert!(contact.load > 0.0 && contact.area > 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Morag & Etsion (2007), doi:10.1016/j.wear.2006.07.007. Their load integral over all asperities
/// is not reproduced here.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MoragEtsion {
    surface: FractalParameters,
    base_length: f64,
    modulus: ContactModulus,
    amplitude: f64,
    radius: f64,
}

/// Elastic contact of one asperity.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct AsperityContact {
    /// Load \[N\].
    pub load: f64,
    /// Real area \[m²\].
    pub area: f64,
}

impl MoragEtsion {
    /// The asperity of base length `l` (m) of a fractal surface.
    ///
    /// # Errors
    /// [`ModelError::OutsideDomain`] unless `1 < D < 2`, and where amplitude or radius are beyond
    /// the range of a double; [`ModelError::InvalidInput`] for a roughness or length that is not
    /// finite and positive.
    pub fn new(
        surface: FractalParameters,
        base_length: f64,
        modulus: ContactModulus,
    ) -> Result<Self, ModelError> {
        let d = check_dimension(MODEL, surface.dimension)?;
        let g = Wide::from(require::positive(MODEL, "fractal roughness", surface.roughness)?);
        let l = Wide::from(require::positive(MODEL, "base length", base_length)?);
        let amplitude = (g.powf(d - 1.0) * l.powf(2.0 - d)).value();
        let radius = (l.powf(d) / g.powf(d - 1.0) / (PI * PI)).value();
        for (quantity, value) in [("amplitude", amplitude), ("radius", radius)] {
            if !value.is_normal() {
                return Err(ModelError::OutsideDomain {
                    model: MODEL.into(),
                    quantity: quantity.into(),
                    value: value.min(f64::MAX),
                    domain: f64::MIN_POSITIVE..=f64::MAX,
                    reason: "it is beyond the range of a double".into(),
                });
            }
        }
        Ok(Self { surface, base_length, modulus, amplitude, radius })
    }

    /// Height `delta_max = G^(D-1) l^(2-D)` of the asperity \[m\]: at this interference it is flat.
    pub fn amplitude(&self) -> f64 {
        self.amplitude
    }

    /// Radius of its summit, `R = l^D / (pi^2 G^(D-1))` \[m\].
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Interference `omega_c = (pi H / 2E*)^2 R` \[m\] at which an asperity of hardness `H` (Pa)
    /// begins to yield.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] for a hardness that is not finite and positive;
    /// [`ModelError::OutsideDomain`] if the interference exceeds the largest double.
    pub fn critical_interference(&self, hardness: f64) -> Result<f64, ModelError> {
        let hardness = require::positive(MODEL, "hardness", hardness)?;
        let strain = Wide::from(hardness) * (0.5 * PI) / self.modulus.pascals();
        let interference = (strain * strain * self.radius).value();
        require::representable(MODEL, "critical interference", interference)
    }

    /// True if an asperity of hardness `H` (Pa) yields before it is flat: `l < l_c`.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] for a hardness that is not finite and positive.
    pub fn can_yield(&self, hardness: f64) -> Result<bool, ModelError> {
        Ok(Wide::from(self.base_length).ln() < self.critical_length(hardness)?.ln())
    }

    /// `l_c = G (2 E*/H)^(1/(D-1))`: longer asperities never yield.
    fn critical_length(&self, hardness: f64) -> Result<Wide, ModelError> {
        let hardness = require::positive(MODEL, "hardness", hardness)?;
        let softness = Wide::from(2.0) * self.modulus.pascals() / hardness;
        Ok(softness.powf(1.0 / (self.surface.dimension - 1.0)) * self.surface.roughness)
    }

    /// Hertz contact at an interference (m):
    ///
    /// ```math
    /// F = \tfrac43 E^* \sqrt R\, \omega^{3/2}, \qquad A = \pi R\,\omega
    /// ```
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] if the interference is negative or not finite;
    /// [`ModelError::OutsideDomain`] beyond the height of the asperity, or if load or area exceed
    /// the largest double.
    pub fn at_interference(&self, interference: f64) -> Result<AsperityContact, ModelError> {
        require::not_negative(MODEL, "interference", interference)?;
        if interference > self.amplitude {
            return Err(ModelError::OutsideDomain {
                model: MODEL.into(),
                quantity: "interference".into(),
                value: interference,
                domain: 0.0..=self.amplitude,
                reason: "the asperity is flat; longer wavelengths carry the load".into(),
            });
        }
        let (radius, interference) = (Wide::from(self.radius), Wide::from(interference));
        let load =
            (radius * interference).sqrt() * interference * self.modulus.pascals() * (4.0 / 3.0);
        let area = radius * interference * PI;
        Ok(AsperityContact {
            load: require::representable(MODEL, "load", load.value())?,
            area: require::representable(MODEL, "area", area.value())?,
        })
    }
}
