//! Bodies that yield: what a hardness means for the elastic answer.

use crate::finding::Reason;
use crate::result::{DeterministicPoint, SurfaceComparison};
use crate::scene::typical_hardness;
use contact_types::{AsperityStatistics, ContactModulus};
use serde::Serialize;
use std::f64::consts::PI;

/// By how much a hardness may leave the range of solids before it is called a mistake.
const NONSENSE: f64 = 10.0;

/// Mean pressure over hardness beyond which a ceiling of the pressure is no model of a metal: it yields in
/// its volume.
pub const BULK_YIELD: f64 = 0.3;

/// Part of the area by which yield makes the elastic one wrong: `E* g / H <= 1` keeps it below.
const TOLD: f64 = 0.02;

/// A hardness beside what is pressed with it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Hardness {
    /// H (Pa).
    pub pascals: f64,
    /// Contact modulus (Pa).
    pub modulus: f64,
    /// Rms gradient \[-\], if it is known.
    pub gradient: Option<f64>,
}

impl Hardness {
    /// The plasticity indices of the field, for a Gaussian surface; `asperities` are its summits, if it has any.
    pub fn indices(&self, asperities: Option<AsperityStatistics>) -> PlasticityIndices {
        let Self { pascals, modulus, gradient } = *self;
        // The mean absolute profile slope of a Gaussian surface is g/√π.
        let slope = gradient.map(|g| g / PI.sqrt());
        PlasticityIndices {
            modulus_gradient_over_hardness: gradient.map(|g| modulus * g / pascals),
            greenwood_williamson: asperities
                .map(|a| modulus / pascals * (a.height_std / a.radius).sqrt())
                .filter(|index| index.is_finite() && *index > 0.0),
            mikic: slope.map(|slope| modulus * slope / pascals),
        }
    }

    /// The hardness of solids of this modulus, `[low, high]` (Pa), if this one is so far from it that the
    /// unit may be wrong.
    pub fn unusual(&self) -> Option<[f64; 2]> {
        let [low, high] = typical_hardness(self.modulus)?;
        let is_far = self.pascals < low / NONSENSE || self.pascals > high * NONSENSE;
        is_far.then_some([low, high])
    }
}

/// How far elastic bodies are from what they bear: three numbers of one meaning \[-\].
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PlasticityIndices {
    /// `E* g / H`: up to 1 the area of elastic contact is right to 2 %, whatever the load.
    pub modulus_gradient_over_hardness: Option<f64>,
    /// Greenwood and Williamson's `(E*/H) √(σ_s/R)` (1966), doi:10.1098/rspa.1966.0242: below 0.6 summits stay elastic at
    /// ordinary loads, above 1 they yield at any.
    pub greenwood_williamson: Option<f64>,
    /// Mikic's `E* m_a / H` with the mean absolute slope m_a = g/√π of a Gaussian surface.
    pub mikic: Option<f64>,
}

/// The hardness of a study beside its surface, if one was given.
pub fn hardness_of(surface: &SurfaceComparison) -> Option<Hardness> {
    let pascals = surface.inputs.hardness?;
    let modulus = surface.inputs.modulus.pascals();
    let gradient = surface.inputs.moments.map(|m| m.rms_gradient());
    Some(Hardness { pascals, modulus, gradient })
}

/// `E* g` (Pa): for a hardness of at least that the area of elastic contact is right to 2 %. `None` for bodies
/// that do not yield in a contact (rubbers), for a flat map, and where a hardness was given.
pub fn elastic_limit(surface: &SurfaceComparison) -> Option<f64> {
    let modulus = surface.inputs.modulus.pascals();
    let limit = modulus * surface.inputs.rms_gradient();
    let asks = surface.inputs.hardness.is_none() && typical_hardness(modulus).is_some();
    (asks && limit > 0.0 && limit.is_finite()).then_some(limit)
}

/// Of the loads that both solutions have; `None` where the elastic area is right to 2 %.
pub(crate) fn excess(
    yielding: &[DeterministicPoint],
    elastic: &[DeterministicPoint],
) -> Option<Reason> {
    let area = |p: &DeterministicPoint| {
        let area = p.answer.as_ref()?.area_fraction;
        (area > 0.0).then_some(area)
    };
    let both = yielding.iter().zip(elastic);
    let excesses: Vec<(f64, f64)> =
        both.filter_map(|(a, b)| Some((a.mean_pressure, area(a)? / area(b)? - 1.0))).collect();
    let from = excesses.iter().find(|(_, e)| *e > TOLD)?.0;
    let most = excesses.iter().map(|(_, e)| *e).max_by(f64::total_cmp)?;
    let everywhere = excesses.iter().all(|(_, e)| *e > TOLD);
    Some(Reason::Elastic { from, most, everywhere })
}

/// Whether a theory of elastic bodies can be right at the headline: no hardness is given, or the area of
/// elastic bodies is that of these to 2 %. Where it is not, a theory that agrees does so by accident.
pub fn elastic_holds(surface: &SurfaceComparison) -> bool {
    let at = surface.headline;
    let (Some(yielding), Some(elastic)) = (surface.deterministic.get(at), surface.elastic.get(at))
    else {
        return true;
    };
    excess(std::slice::from_ref(yielding), std::slice::from_ref(elastic)).is_none()
}

/// The rms gradient that the loads of a study are chosen for: with a hardness such that the highest of them
/// stays below what the bodies bear before they yield in their volume.
pub(crate) fn gradient_of_loads(
    gradient: f64,
    modulus: ContactModulus,
    hardness: Option<f64>,
) -> f64 {
    // The highest load that is chosen is 0.4 E* g.
    hardness.map_or(gradient, |h| gradient.min(BULK_YIELD / 0.4 * h / modulus.pascals()))
}
