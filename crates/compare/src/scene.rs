//! Is the question one that an elastic half-space can answer? Slopes, units and pressures, and what a hardness means for the
//! elastic answer.

use crate::finding::{Fact, Finding, Pressed, Reason};
use crate::needs::Inputs;
use crate::result::{DeterministicPoint, SurfaceComparison};
use contact_types::{AsperityStatistics, ContactModulus, ContactState};
use serde::Serialize;
use std::f64::consts::PI;
use surface_stats::{SurfaceStatistics, Warning};

/// Rms gradient from which small-slope elasticity strains: errors of the slopes squared.
const STEEP: f64 = 0.3;
/// Rms gradient at which it ends.
const TOO_STEEP: f64 = 0.5;
/// Rms gradient that no surface has that a map can show: its sides stand at more than 84°.
const NO_SURFACE: f64 = 10.0;
/// Rms height (m) and radius of asperities (m) that no rough surface has.
const NO_HEIGHT: f64 = 1.0;
const NO_RADIUS: f64 = 1e3;

/// Contact modulus (Pa) below which solids are rubbers and gels, which do not yield in a contact.
const RUBBER: f64 = 1e8;
/// Contact modulus (Pa) below which they are polymers.
const POLYMER: f64 = 2e10;
/// Contact modulus (Pa) above which they are hard metals and ceramics.
const CERAMIC: f64 = 2.5e11;

/// Whether an rms gradient strains small-slope elasticity.
pub fn is_steep(gradient: f64) -> bool {
    gradient > STEEP || gradient.is_nan()
}

/// That an rms gradient strains small-slope elasticity.
pub(crate) fn steep(gradient: f64) -> Fact {
    Fact::Steep { gradient, is_over: gradient > TOO_STEEP }
}

/// What is asked of the theory of elasticity, and what it answers.
#[derive(Debug, Clone, Default)]
pub struct Scene {
    /// Contact modulus (Pa).
    pub modulus: f64,
    /// Hardness of the softer body (Pa), if it is known.
    pub hardness: Option<f64>,
    /// Rms gradient \[-\], if it is known.
    pub gradient: Option<f64>,
    /// Rms height (m), if it is known.
    pub rms_height: Option<f64>,
    /// Radius of asperities (m), if they have one.
    pub radius: Option<f64>,
    /// What it strains, where no statistics say it.
    pub warned: Vec<Warning>,
    /// Spacing of doubles at the heights as they were given (m), where no statistics say it.
    pub spacing: f64,
    /// Answers by rising load.
    pub pressed: Vec<Pressed>,
}

impl Scene {
    /// Of these moments and asperities with the answers of a theory, which knows no highest pressure, by rising load.
    pub fn of<'a>(inputs: &Inputs, answers: impl Iterator<Item = &'a ContactState>) -> Self {
        let pressed = |state: &ContactState| {
            let (nominal, mean) = (state.mean_pressure, state.real_pressure()?);
            Some(Pressed { nominal, mean, highest: None })
        };
        let mut pressed: Vec<Pressed> = answers.filter_map(pressed).collect();
        pressed.sort_by(|a, b| a.nominal.total_cmp(&b.nominal));
        Self {
            pressed,
            modulus: inputs.modulus.pascals(),
            gradient: inputs.m2().map(|_| inputs.rms_gradient()),
            rms_height: inputs.moments.map(|m| m.rms_height()),
            radius: inputs.asperities().map(|a| a.radius),
            ..Self::default()
        }
    }

    /// Of a map with these statistics, which say the rest.
    pub(crate) fn of_map(s: &SurfaceStatistics) -> Self {
        Self {
            gradient: Some(s.rms_gradient),
            rms_height: Some(s.rms_height),
            radius: s.asperities.map(|a| a.radius),
            ..Self::default()
        }
    }

    /// What is said before any number: units, yield, slopes.
    pub(crate) fn findings(&self) -> Vec<Finding> {
        let found = [self.unit(), self.rounding(), self.beyond_yield(), self.steep()];
        let warned = self.warned.iter().copied().map(Finding::warned);
        found.into_iter().flatten().chain(warned).collect()
    }

    /// A size that looks like a mistyped unit.
    fn unit(&self) -> Option<Finding> {
        let beyond = |value: Option<f64>, limit: f64| value.filter(|v| *v > limit || v.is_nan());
        let gradient = beyond(self.gradient, NO_SURFACE);
        // A moment below 0 has no root, and is refused by itself.
        let rms_height = self.rms_height.filter(|v| *v > NO_HEIGHT);
        let radius = beyond(self.radius, NO_RADIUS);
        let fact = Fact::Unit { gradient, rms_height, radius, hardness: None };
        let is_odd = [gradient, rms_height, radius].iter().any(Option::is_some);
        is_odd.then(|| Finding::check(fact))
    }

    /// Heights that far from zero are given by a few numbers, and what is left after levelling is theirs.
    fn rounding(&self) -> Option<Finding> {
        let rms_height = self.rms_height.filter(|rms| *rms > 0.0)?;
        Warning::flat(rms_height, self.spacing).map(Finding::warned)
    }

    fn steep(&self) -> Option<Finding> {
        let gradient = self.gradient.filter(|g| *g > STEEP && *g <= NO_SURFACE)?;
        Some(Finding::check_if(gradient > TOO_STEEP, steep(gradient)))
    }

    /// Whether the elastic answer presses harder than solids of this modulus bear.
    fn beyond_yield(&self) -> Option<Finding> {
        let hardness = match self.hardness {
            Some(known) => [known; 2],
            None => typical_hardness(self.modulus)?,
        };
        let [soft, hard] = hardness;
        let first =
            |least: f64, of: fn(&Pressed) -> f64| self.pressed.iter().find(|p| of(p) > least);
        let mean = |p: &Pressed| p.mean;
        let by_mean = first(hard, mean).or_else(|| first(soft, mean));
        let at = by_mean.or_else(|| first(hard, |p| p.highest.unwrap_or(0.0)))?;
        let full = self.gradient.map(|g| self.modulus * g);
        let fact = Fact::Yield { at: *at, modulus: self.modulus, hardness, full };
        Some(Finding::check_if(by_mean.is_some(), fact))
    }
}

/// Hardness `[low, high]` (Pa) of solids that have this contact modulus; `None` for rubbers.
///
/// Hardness over E/(1 − ν²) of 26 solids, load over projected area of the indent, from public data
/// sheets (makeitfrom.com, matweb.com, webelements.com): annealed copper and gold 0.002 to 0.003,
/// steels 1020, 304 and 316 0.006 to 0.009, 6061-T6 0.013, hardened 100Cr6 0.038; alumina 0.04, glass
/// 0.06 to 0.075, silicon carbide 0.063, hard carbon 0.10; PTFE 0.04, PMMA 0.053. The upper ends allow
/// for two like bodies, whose contact modulus is half; the lower end of metals is that of structural
/// alloys.
pub fn typical_hardness(modulus: f64) -> Option<[f64; 2]> {
    let [low, high] = match modulus {
        e if e < RUBBER => return None,
        e if e < POLYMER => [0.04, 0.11],
        e if e <= CERAMIC => [0.006, 0.08],
        _ => [0.006, 0.12],
    };
    Some([low * modulus, high * modulus])
}

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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Weight;

    fn said(scene: &Scene) -> Vec<(Weight, &'static str)> {
        let name = |f: &Finding| match f.fact {
            Fact::Unit { .. } => "unit",
            Fact::Yield { .. } => "yield",
            Fact::Steep { .. } => "steep",
            _ => "other",
        };
        scene.findings().iter().map(|f| (f.weight, name(f))).collect()
    }

    fn steel(mean: f64, highest: f64) -> Scene {
        let pressed = vec![Pressed { nominal: 1e7, mean, highest: Some(highest) }];
        Scene { modulus: 115e9, gradient: Some(0.05), pressed, ..Scene::default() }
    }

    /// 17 GPa mean and 110 GPa highest on steel; hardened bearing steel has 8 GPa.
    #[test]
    fn steel_that_bears_17_gigapascals_is_said_to_be_fiction() {
        let (check, note) = (&[(Weight::Check, "yield")][..], &[(Weight::Note, "yield")][..]);
        for (scene, expected) in [
            (steel(17e9, 110e9), check),
            (steel(5e9, 30e9), check),
            (steel(0.3e9, 30e9), note),
            (steel(0.3e9, 2e9), &[]),
            (Scene { hardness: Some(8.6e9), ..steel(5e9, 8e9) }, &[]), // bearing steel
            (Scene { hardness: Some(398e6), ..steel(0.5e9, 2e9) }, check), // copper
            (Scene { modulus: 2e6, ..steel(17e9, 110e9) }, &[]),       // rubber
        ] {
            assert_eq!(said(&scene), expected, "{scene:?}");
        }
    }

    /// The lightest load that presses too hard is named, in the graver of the two classes.
    #[test]
    fn the_lightest_load_is_named() {
        let at = |nominal, mean| Pressed { nominal, mean, highest: None };
        let pressed = vec![at(1e6, 1e8), at(2e6, 5e9), at(3e6, 10e9), at(4e6, 12e9)];
        let scene = Scene { pressed, ..steel(0.0, 0.0) };
        let found = scene.findings();
        let Fact::Yield { at, hardness: [low, high], full, .. } = found[0].fact else {
            panic!("{found:?}")
        };
        assert_eq!(at.nominal.to_bits(), 3e6f64.to_bits());
        assert!(low < 1.3e9 && high > 8e9 && high < 10e9, "{low:e} {high:e}");
        assert!(full.is_some_and(|f| (f - 5.75e9).abs() < 1.0), "{full:?}");
    }

    /// Gradient 287 is a file in mm read as m: the unit is asked for, first of all.
    #[test]
    fn slopes_and_units() {
        let of = |gradient| Scene { modulus: 1e9, gradient: Some(gradient), ..Scene::default() };
        let unit = &[(Weight::Check, "unit")][..];
        for (scene, expected) in [
            (of(287.0), unit),
            (of(0.2), &[]),
            (of(0.4), &[(Weight::Note, "steep")]),
            (of(3.0), &[(Weight::Check, "steep")]),
            (of(f64::INFINITY), unit),
            (of(f64::NAN), unit),
            (Scene { radius: Some(2.3e3), ..of(0.1) }, unit),
            (Scene { rms_height: Some(1e299), ..Scene::default() }, unit),
        ] {
            assert_eq!(said(&scene), expected, "{scene:?}");
        }
    }
}
