//! How the conductance of a contact is found, over the loads and without its shortest waves.
//!
//! By Barber's analogy the conductance of a contact is its stiffness times a number that only the
//! materials know, `2/(E* (ρ1 + ρ2))` or `2/(E* (1/k1 + 1/k2))`: one stiffness serves both, and a
//! correlation of the field is drawn as the stiffness it stands for.

use crate::ask::possible;
use crate::conducted::{Conductance, Conducted, Conduction, Joint, Octave, TheoryStiffness};
use crate::progress::LoadListener;
use crate::registry::find;
use crate::result::{DeterministicAnswer, SurfaceComparison};
use crate::settings::Settings;
use crate::{GapGas, Input, Inputs, Theory};
use asperity_models::thermal_conductance::gas_between;
use contact_accuracy::{Budget, regrid};
use contact_types::{Clock, ContactModel, ContactModulus, ContactState, HeightMap};
use std::iter::successors;

/// Points along the shorter side below which a grid is not tried, nor a choice.
pub(crate) const FEWEST_POINTS: usize = 16;
/// Most octaves taken off.
const MOST_OCTAVES: usize = 4;
/// Roll-off over the shortest wave left, at least: with less there is no roughness left to be asked.
const LEAST_BAND: f64 = 4.0;
impl Conduction {
    /// From the solutions at the loads; `None` if nothing was asked.
    pub(crate) fn of(surface: &SurfaceComparison, settings: &Settings) -> Option<Self> {
        if !settings.joint().is_asked() {
            return None;
        }
        let modulus = surface.inputs.modulus.pascals();
        let joint = Joint { area: Some(surface.nominal_area()), ..settings.joint() };
        Some(Self {
            joint,
            factors: joint.factors().map(|f| f.map(|f| f / modulus)),
            stiffness: surface
                .deterministic
                .iter()
                .map(|p| stiffness(p.answer.as_ref().filter(|a| a.converged)?))
                .collect(),
            theories: theories(surface, joint),
            octaves: Vec::new(),
            seconds: 0.0,
        })
    }
}

/// Theories of elastic contact that have a separation, and of conductance.
const THEORIES: [&str; 5] = ["gw", "bgt", "persson", "mikic", "cmy"];

/// Relative change of the load over which the slope of a theory is taken; its square is the error.
const SLOPE: f64 = 1e-3;

/// Stiffness and gas of theories at the loads.
fn theories(surface: &SurfaceComparison, joint: Joint) -> Vec<TheoryStiffness> {
    let inputs = surface.inputs_with_spectrum(); // Persson's gap asks for it
    let of = |name: &str| {
        let theory = find(name)?;
        let model = theory.build(&inputs).ok()?;
        let loads = || surface.deterministic.iter().map(|point| point.mean_pressure);
        let modulus = inputs.modulus.pascals();
        let conducted = |p| Some(modulus * contact_of(theory, &*model, &inputs, p)?[0]);
        let stiffness = loads().map(conducted).collect();
        let gas = |gas: GapGas| -> Vec<Option<f64>> {
            let at = |p| {
                let state = possible(name, model.at_pressure(p).ok()?).ok()?;
                gas_at(&state, &inputs, gas)
            };
            loads().map(at).collect()
        };
        let gas = joint.gas.map_or_else(Vec::new, gas);
        let gamma = inputs.gamma().filter(|_| theory.card().takes(Input::Gamma));
        let label = theory.card().label.to_string();
        Some(TheoryStiffness { name: name.to_owned(), label, gamma, stiffness, gas })
    };
    THEORIES.into_iter().filter_map(of).collect()
}

/// Conductance of a theory over the harmonic mean conductivity of the bodies (1/m): its own, and the expression that it is
/// a fit of; of one of elastic contact its stiffness over E* (Barber's analogy). `None` of others.
fn contact_of(
    theory: &dyn Theory,
    model: &dyn ContactModel,
    inputs: &Inputs,
    pressure: f64,
) -> Option<[f64; 2]> {
    let card = theory.card();
    match model.conductance(pressure) {
        Ok(Some(own)) => Some(own),
        Ok(None) if !card.yields => {
            Some([slope(&card.name, model, pressure)? / inputs.modulus.pascals(); 2])
        }
        _ => None,
    }
}

/// Conductance over conductivity of a gas between Gaussian heights at the separation of an answer (1/m).
fn gas_at(state: &ContactState, inputs: &Inputs, gas: GapGas) -> Option<f64> {
    gas_between(state.separation?, inputs.rms_height()?, gas.jump()).ok()
}

/// What a joint conducts by a theory, in the state of its answer: by its own conductance, and by the expression that it is a
/// fit of. `None` if the joint is not asked about, or the theory does not say.
pub fn conducted_by(
    theory: &dyn Theory,
    model: &dyn ContactModel,
    (inputs, joint): (&Inputs, &Joint),
    state: &ContactState,
) -> Option<[Conducted; 2]> {
    let pressure = state.mean_pressure;
    let both = joint.is_asked().then(|| contact_of(theory, model, inputs, pressure))??;
    let gas = joint.gas.and_then(|gas| gas_at(state, inputs, gas)).map(Conductance::of);
    let joint = Joint { hardness: inputs.hardness, ..*joint };
    Some(both.map(|h| joint.conducted(Conductance::of(h), gas, pressure)))
}

/// `-dp/d(separation)`, or of the mean gap, of a model at a mean pressure (Pa/m).
fn slope(name: &str, model: &dyn ContactModel, pressure: f64) -> Option<f64> {
    let separation = |p: f64| {
        let state = possible(name, model.at_pressure(p).ok()?).ok()?;
        state.separation.or(state.mean_gap) // Persson's is that of the deformed bodies
    };
    let closed = separation(pressure * (1.0 - SLOPE))? - separation(pressure * (1.0 + SLOPE))?;
    (closed > 0.0).then(|| 2.0 * SLOPE * pressure / closed)
}

/// Stiffness of the contact set of an answer (Pa/m).
fn stiffness(answer: &DeterministicAnswer) -> Option<f64> {
    if answer.diagnostics.contact_pixels == 0 {
        return Some(0.0);
    }
    let is_full = answer.touching_fraction >= 1.0;
    answer.budget.stiffness.map(|k| k.value).or(is_full.then_some(f64::INFINITY))
}

impl SurfaceComparison {
    /// What the joint conducts at a load by its index, if that was asked for and solved.
    pub fn conducted(&self, index: usize) -> Option<Conducted> {
        let found = self.conduction.as_ref()?;
        let stiffness = (*found.stiffness.get(index)?)?;
        let budget = self.deterministic[index].answer.as_ref()?.budget;
        Some(found.joint.of_budget(stiffness, &budget, self.inputs.modulus))
    }
}

impl Joint {
    /// What a contact set with this stiffness (Pa/m) conducts, and the gas beside it, with their uncertainties.
    pub fn of_budget(&self, stiffness: f64, budget: &Budget, modulus: ContactModulus) -> Conducted {
        let mut estimate = budget.stiffness.filter(|_| stiffness > 0.0 && stiffness.is_finite());
        // At a load the conductance answers to E* and H as the area does, about.
        if let Some(k) = &mut estimate {
            k.materials = stiffness * budget.area.materials / budget.area.value;
        }
        let set = Conductance { value: stiffness, estimate }.times(1.0 / modulus.pascals());
        let gas = budget.gas.map(Conductance::from);
        self.conducted(set, gas, budget.mean_pressure.value)
    }
}

/// Solves the headline load without the shortest octave of waves, then without the next, if the conductance was asked for:
/// up to four solutions.
pub(crate) fn remove_octaves(
    surface: &mut SurfaceComparison,
    settings: &Settings,
    watch: &mut LoadListener<'_, '_>,
) {
    let start = Clock::now();
    let octaves = octaves(surface, settings, watch);
    if let Some(conduction) = surface.conduction.as_mut().filter(|_| !watch.is_stopped) {
        conduction.octaves = octaves;
        conduction.seconds = start.elapsed().as_secs_f64();
    }
}

fn octaves(
    surface: &SurfaceComparison,
    settings: &Settings,
    watch: &mut LoadListener<'_, '_>,
) -> Vec<Octave> {
    let at_headline =
        surface.conduction.as_ref().and_then(|c| *c.stiffness.get(surface.headline)?);
    let whole = at_headline.filter(|k| *k > 0.0 && k.is_finite()).zip(surface.headline_answer());
    let Some((stiffness, answer)) = whole else { return Vec::new() };
    let grid = surface.surface.grid();
    let [dy, dx] = grid.pixel();
    let shortest = surface.statistics.cutoff.unwrap_or(0.0).max(2.0 * dy.max(dx));
    let mut found = vec![Octave { shortest, area: answer.area_fraction, stiffness }];
    let solve = |cut: f64| {
        let smooth = without_shorter(&surface.surface, cut, surface.map.repeats)?;
        let (solver, solution) = surface.solve_headline(&smooth, settings, watch)?;
        let set = solver.contact_stiffness(|i| solution.pressure[i] > 0.0).ok()?;
        let (area, stiffness) = (solution.state.area_fraction, set.per_area);
        let is_partial = area > 0.0 && stiffness > 0.0 && stiffness.is_finite();
        is_partial.then_some(Octave { shortest: cut, area, stiffness })
    };
    // The fit of the spectrum places cut-off and roll-off to a few per cent.
    let longest = 1.1 * (surface.statistics.rolloff.unwrap_or(f64::INFINITY) / LEAST_BAND);
    let cuts = successors(Some(2.0 * shortest), |cut| Some(2.0 * cut)).take(MOST_OCTAVES);
    found.extend(cuts.take_while(|cut| *cut <= longest).map_while(solve));
    found
}

/// The map without waves shorter than this (m), if there are sixteen points with two to each.
pub(crate) fn without_shorter(map: &HeightMap, wave: f64, repeats: bool) -> Option<HeightMap> {
    let points = map.grid().size().map(|side| (2.0 * side / wave).round() as usize);
    let is_enough = points[0].min(points[1]) >= FEWEST_POINTS;
    let coarse = is_enough.then(|| regrid(map, points, repeats).ok())??;
    regrid(&coarse, map.grid().shape(), repeats).ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use contact_types::{AsperityStatistics, SpectralMoments};
    use gw_closed_form::GreenwoodWilliamson;

    #[test]
    fn the_slope_of_a_theory_is_its_stiffness() {
        let modulus = ContactModulus::from_pascals(1e11).expect("a modulus");
        let moments = SpectralMoments { m0: 1e-14, m2: 1e-3, m4: 1e9 };
        let inputs = Inputs { moments: Some(moments), ..Inputs::new(modulus) };
        let theory = find("gw").expect("a theory").build(&inputs).expect("a model");
        let asperities = AsperityStatistics::from_moments(moments).expect("summits");
        let exact = GreenwoodWilliamson::new(asperities, modulus).expect("a model");
        for pressure in [1e4, 1e6, 1e8] {
            let state = theory.at_pressure(pressure).expect("an answer");
            let known =
                exact.stiffness(state.separation.expect("a separation")).expect("stiffness");
            let found = slope("gw", &*theory, pressure).expect("a slope");
            assert!((found / known - 1.0).abs() < 1e-5, "{pressure}: {found} and {known}");
        }
    }
}
