//! Archard's spheres on spheres on spheres.

use crate::answer::{beyond, underflow};
use crate::wide::Wide;
use contact_types::{
    Caveat, Citation, ContactModel, ContactModulus, ContactState, ModelError, require,
};
use std::f64::consts::PI;

const MODEL: &str = "Archard";

/// Spheres of one size.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SphereLevel {
    /// Radius of the spheres \[m\].
    pub radius: f64,
    /// Spheres per area of what carries them \[m⁻²\]: the nominal area for the coarsest.
    pub density: f64,
}

/// Spheres covered with smaller spheres, covered with smaller spheres still.
///
/// A smooth sphere touches over `A = k W^(2/3)` with `k = pi (3R/4E*)^(2/3)`. If its surface
/// carries `m` features per area, each with the law `A = C w^e`, and the load spreads over them
/// as the smooth Hertz pressure, then
///
/// ```math
/// A = m^{1-e}\,C\left(\tfrac32\right)^{e}\frac{2}{2+e}\;k^{1-e}\;W^{(2+e)/3}:
/// ```
///
/// the exponents go 2/3, 8/9, 26/27, … and area becomes proportional to load.
///
/// ```
/// use contact_types::{ContactModel, ContactModulus};
/// use multiscale_models::{Archard, SphereLevel};
/// let level = |radius, density| SphereLevel { radius, density };
/// let levels = [level(1e-3, 1e5), level(1e-6, 1e11)];
/// let model = Archard::new(&levels, ContactModulus::from_pascals(110e9)?)?;
/// let [light, heavy] = [1e6, 8e6].map(|pressure| model.at_pressure(pressure));
/// let exponent = (heavy?.area_fraction / light?.area_fraction).log(8.0);
/// assert!((exponent - 8.0 / 9.0).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Archard (1957), doi:10.1098/rspa.1957.0214.
#[derive(Debug, Clone, PartialEq)]
pub struct Archard {
    /// `k` \[m² N^(-2/3)\] and density \[m⁻²\] of each level, coarse to fine.
    levels: Vec<[f64; 2]>,
}

/// Fewer features than this in a Hertz spot are not a continuous cover.
const MANY: f64 = 10.0;

/// Spots that cover more than this fraction of their carrier are not independent.
const SPARSE: f64 = 0.1;

impl Archard {
    /// From the spheres of each level, coarse to fine.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] without levels, or for a radius or density that is not
    /// finite and positive, or a `k` beyond the range of a double.
    pub fn new(levels: &[SphereLevel], modulus: ContactModulus) -> Result<Self, ModelError> {
        if levels.is_empty() {
            let requirement = "needs at least one level";
            return Err(require::refused(MODEL, "number of levels", 0.0, requirement));
        }
        let of_level = |level: &SphereLevel| {
            let radius = require::positive(MODEL, "sphere radius", level.radius)?;
            // k = pi (3R/(4E*))^(2/3)
            let root = (Wide::from(radius) * 0.75 / modulus.pascals()).cbrt();
            let constant = (root * root * PI).value();
            let constant = require::positive(MODEL, "contact constant k", constant)?;
            Ok([constant, require::positive(MODEL, "sphere density", level.density)?])
        };
        Ok(Self { levels: levels.iter().map(of_level).collect::<Result<_, ModelError>>()? })
    }

    /// Real area of one coarse sphere under a load, `C W^e` with `W^e = W / W^(1/3^n)`.
    fn area(&self, load: Wide) -> Wide {
        if load.is_zero() {
            return load;
        }
        self.coefficient() * (load / repeated_cbrt(load, self.levels.len()))
    }

    /// `C`, built up from the finest level. Below a level, `e = 1 - 3^-n` with n finer levels.
    fn coefficient(&self) -> Wide {
        let [finest, _] = self.levels[self.levels.len() - 1];
        let mut coefficient = Wide::from(finest);
        for (finer, pair) in (1..).zip(self.levels.windows(2).rev()) {
            let [[k, _], [_, m]] = [pair[0], pair[1]];
            let e = 1.0 - (0..finer).fold(1.0, |lack, _| lack / 3.0);
            // m^(1-e) k^(1-e) C (3/2)^e 2/(2+e)
            coefficient = repeated_cbrt(Wide::from(m) * k, finer)
                * coefficient
                * (1.5_f64.powf(e) * 2.0 / (2.0 + e));
        }
        coefficient
    }

    /// The first assumption that is strained, judged by mean loads from coarse to fine.
    fn strain(&self, pressure: f64) -> Option<Caveat> {
        let mut stress = Wide::from(pressure); // load per area of the carrier
        for (level, &[k, density]) in self.levels.iter().enumerate() {
            let load = stress / density;
            let spot = load / load.cbrt() * k;
            let cover = (spot * density).value();
            if cover > SPARSE {
                let reason = "Hertz spots of one level cover much of what carries them";
                return Some(beyond("cover of a level", cover.min(f64::MAX), SPARSE, reason));
            }
            if let Some(&[_, finer]) = self.levels.get(level + 1) {
                let features = (spot * finer).value();
                if features < MANY {
                    let reason = "too few features in a Hertz spot to carry its pressure";
                    return Some(beyond("features per Hertz spot", features, MANY, reason));
                }
            }
            stress = load / spot;
        }
        None
    }
}

/// `x^(3^-n)`.
fn repeated_cbrt(x: Wide, times: usize) -> Wide {
    (0..times).fold(x, |root, _| root.cbrt())
}

impl ContactModel for Archard {
    fn citation(&self) -> Citation {
        let title = "Elastic deformation and the laws of friction";
        Citation::new("Archard", 1957, title, "Proc. R. Soc. A 243, 190", "10.1098/rspa.1957.0214")
    }

    fn at_pressure(&self, mean_pressure: f64) -> Result<ContactState, ModelError> {
        require::pressure(MODEL, mean_pressure)?;
        let [_, density] = self.levels[0];
        let area = self.area(Wide::from(mean_pressure) / density) * density;
        let area_fraction = require::answer(MODEL, area.value(), "mean pressure", mean_pressure)?;
        let strain = || if mean_pressure > 0.0 { self.strain(mean_pressure) } else { None };
        let caveat = underflow(mean_pressure, area_fraction).or_else(strain);
        Ok(ContactState { mean_pressure, area_fraction, separation: None, mean_gap: None, caveat })
    }
}
