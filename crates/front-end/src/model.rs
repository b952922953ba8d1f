//! Closed-form models at loads and separations: what `rough-contact model` answers.

use crate::failure::{Failure, variant};
use crate::loads::Spread;
use crate::traces::Traces;
use contact_accuracy::round_to_digits;
use contact_compare::survey::{ErrorRange, gaussian_errors};
use contact_compare::{
    BuildError, Card, Conducted, Finding, Input, Inputs, Joint, Level, MomentSource, OfMap, Origin,
    Pressed, Scene, Theory, built_in, conducted_by,
};
use contact_types::{
    AmplitudeSpectrum, Caveat, ContactModel, ContactModulus, ContactState, HeightMap, ModelError,
    Named,
};
use serde_json::{Value, json};
use std::path::Path;
use surface_stats::clean::RowOffsets;
use surface_stats::profile::ProfileStatistics;
use surface_stats::spectrum::{amplitudes, radial};
use surface_stats::{Edges, SpectralScales, StatsError, StatsOptions, level, moments};

/// What is asked of the model.
#[derive(Clone, Copy, Debug)]
pub enum ModelLoad {
    /// Nominal pressure (Pa).
    Pressure(f64),
    /// Distance of the undeformed planes (m).
    Separation(f64),
}

/// Why a theory cannot be asked at all.
#[derive(Clone, Debug, thiserror::Error)]
pub enum Unasked {
    /// It answers at no separation.
    #[error("{model} has no separation")]
    NoSeparation {
        /// Its name.
        model: String,
    },
    /// An input it needs is absent.
    #[error(transparent)]
    Missing(BuildError),
}

impl Unasked {
    /// As a refusal, with the way out.
    pub fn failure(&self, way_out: &str) -> Failure {
        match self {
            Self::NoSeparation { .. } => {
                let cards = built_in().iter().map(Theory::card);
                let able: Vec<&str> =
                    cards.filter(|c| c.has_separation).map(|c| c.name.as_ref()).collect();
                let message = format!("{self}; {way_out}, or one of {}", able.join(", "));
                Failure::refused("usage", message)
            }
            Self::Missing(_) => Failure::refused("missing_input", format!("{self}; {way_out}")),
        }
    }
}

/// What a theory says to one question.
#[derive(Clone, Debug)]
pub struct Said {
    /// The contact it answers with.
    pub state: ContactState,
    /// Between which the area lies for 95 of 100 surfaces, if the theory knows its own error.
    pub area_interval: Option<[f64; 2]>,
    /// Its error on isotropic Gaussian surfaces, if there are numbers and no map.
    pub survey: Option<ErrorRange>,
    /// What the joint conducts, if that was asked for and the theory says it; of a correlation also by the expression that
    /// it is a fit of.
    pub conducted: Option<[Conducted; 2]>,
}

impl Said {
    fn of(
        model: &dyn ContactModel,
        state: ContactState,
        theory: &dyn Theory,
        given: (&Inputs, &Joint),
    ) -> Self {
        let (card, inputs) = (theory.card(), given.0);
        let typed = inputs.moments.filter(|_| inputs.source == MomentSource::Given);
        let survey = typed.and_then(|moments| {
            let load = state.mean_pressure / (inputs.modulus.pascals() * moments.rms_gradient());
            gaussian_errors(&card.name, moments.bandwidth(), load)
        });
        Self {
            area_interval: model.area_interval(state.area_fraction),
            conducted: conducted_by(theory, model, given, &state),
            state,
            survey,
        }
    }
}

/// That, or why it says nothing.
pub type ModelResult = Result<Said, ModelError>;
type Ask<'a> = Box<dyn Fn(&ModelLoad) -> ModelResult + 'a>;

impl ModelLoad {
    /// Pa or m.
    pub fn value(&self) -> f64 {
        match *self {
            Self::Pressure(value) | Self::Separation(value) => value,
        }
    }
}

/// One answer per question, with what the joint conducts there. A model that cannot be made refuses every question.
///
/// # Errors
/// [`Unasked`].
pub fn results(
    theory: &dyn Theory,
    inputs: &Inputs,
    questions: &[ModelLoad],
    joint: &Joint,
) -> Result<Vec<ModelResult>, Unasked> {
    let given = (inputs, joint);
    let card = theory.card();
    let title = card.title.as_ref();
    let ask: Ask<'_> = match questions.first() {
        Some(ModelLoad::Separation(_)) => match theory.build_separation(inputs) {
            None => return Err(Unasked::NoSeparation { model: card.name.to_string() }),
            Some(Ok(model)) => Box::new(move |q| {
                let state = contact_compare::at_separation(title, model.as_ref(), q.value())?;
                Ok(Said::of(model.as_ref(), state, theory, given))
            }),
            Some(Err(error)) => refuse_all(error)?,
        },
        _ => match theory.build(inputs) {
            Ok(model) => Box::new(move |q| {
                let state = contact_compare::at_pressure(title, model.as_ref(), q.value())?;
                Ok(Said::of(model.as_ref(), state, theory, given))
            }),
            Err(error) => refuse_all(error)?,
        },
    };
    Ok(questions.iter().map(ask).collect())
}

fn refuse_all(error: BuildError) -> Result<Ask<'static>, Unasked> {
    match error {
        BuildError::Model(error) => Ok(Box::new(move |_| Err(error.clone()))),
        missing @ BuildError::Missing { .. } => Err(Unasked::Missing(missing)),
    }
}

/// What is asked of elasticity, with the results by rising load.
pub fn scene(
    card: &Card,
    inputs: &Inputs,
    results: &[ModelResult],
    rows: Option<RowOffsets>,
) -> Scene {
    let pressed = |state: &ContactState| {
        let mean = state.real_pressure()?;
        Some(Pressed { nominal: state.mean_pressure, mean, highest: None })
    };
    let mut pressed: Vec<Pressed> =
        results.iter().flatten().filter_map(|said| pressed(&said.state)).collect();
    // Bodies that yield bear what presses them.
    pressed.retain(|_| !card.yields);
    pressed.sort_by(|a, b| a.nominal.total_cmp(&b.nominal));
    let moments = inputs.moments;
    let gradient = inputs.m2().map(|_| inputs.rms_gradient());
    Scene {
        rows,
        modulus: inputs.modulus.pascals(),
        gradient,
        hardness: inputs.hardness,
        rms_height: moments.map(|m| m.m0.sqrt()),
        radius: inputs.asperities().map(|a| a.radius),
        pressed,
        ..Scene::default()
    }
}

/// What a model needs of a measured surface before it is levelled, and nothing else, added to what no map says.
///
/// # Errors
/// [`Failure`] of a map without statistics.
pub fn measured(
    card: &Card,
    given: Inputs,
    path: &Path,
    heights: HeightMap,
    missing: usize,
    (form, edges): (Level, Edges),
) -> Result<Inputs, Failure> {
    let mut inputs = given;
    let refused = |e: StatsError| Failure::in_file(path, &e);
    inputs.nominal_area = Some(heights.grid().area());
    let map = level(&heights, form).map_err(refused)?;
    // Every model has the moments that a study gives it; only Persson's mean gap needs more.
    inputs.source = MomentSource::FiniteDifferences;
    inputs.moments = Some(moments(&map, edges).map_err(refused)?);
    if card.of_map == OfMap::Fractal {
        let options = StatsOptions { level: form, edges, missing, ..StatsOptions::default() };
        let scales = SpectralScales::of(&heights, &options).map_err(refused)?;
        (inputs.dimension, inputs.fractal) = scales.fractal_of_surface();
        return Ok(inputs);
    }
    drop(heights);
    match card.of_map {
        OfMap::Spectrum => inputs.spectrum = Some(radial(&map).map_err(refused)?),
        OfMap::Amplitudes => {
            inputs.amplitudes = Some(amplitudes(&map).map_err(refused)?);
        }
        OfMap::Moments | OfMap::Fractal => {}
    }
    Ok(inputs)
}

/// A model asked of the isotropic surface with the moments of traces.
#[derive(Debug)]
pub struct OfProfile {
    /// What scripts see.
    pub json: Value,
    /// One for each load or separation.
    pub results: Vec<ModelResult>,
    /// Of each, between which the area lies for 95 of 100 traces like these, if that can be told.
    pub intervals: Vec<Option<[f64; 2]>>,
    /// What may change a conclusion.
    pub findings: Vec<Finding>,
    /// How many traces there are.
    pub traces: usize,
    /// What the model was given.
    pub inputs: Inputs,
    /// What it was asked.
    pub questions: Vec<ModelLoad>,
    /// Loads, if it was asked at loads.
    pub spread: Option<Spread>,
}

/// What the traces do not say of a model's inputs, what is asked of it, and loads if those are given.
type Completed = (Inputs, Vec<ModelLoad>, Option<Spread>);

/// Traces, where they came from, and the form that is taken off each.
type Traced<'a> = (&'a Path, &'a Traces, &'a Origin, Level);

/// Asks a model about profiles: `complete` adds to what the traces say what no trace does, and says what is asked then.
///
/// # Errors
/// [`Failure`] of traces without statistics, and of a theory that lacks something, with its way out.
pub fn of_profile(
    theory: &dyn Theory,
    modulus: ContactModulus,
    joint: &Joint,
    (path, traces, origin, form): Traced<'_>,
    complete: impl FnOnce(Inputs) -> Result<Completed, Failure>,
    way_out: impl FnOnce(&Unasked) -> Failure,
) -> Result<OfProfile, Failure> {
    let refused = |e: StatsError| Failure::in_file(path, &e);
    let form = form.of_profile();
    let options = traces.options(form.degree().unwrap_or(0));
    let (statistics, _, spectrum) =
        ProfileStatistics::of(&traces.each, &options).map_err(refused)?;
    let inputs =
        contact_compare::profile_inputs(&statistics, &spectrum, modulus).map_err(refused)?;
    let (inputs, questions, spread) = complete(inputs)?;
    let found = results(theory, &inputs, &questions, joint).map_err(|e| way_out(&e))?;
    let findings = contact_compare::profile_findings(
        &statistics,
        traces.uneven,
        origin,
        &scene(theory.card(), &inputs, &found, None),
    );
    let interval = |(question, answer): (&ModelLoad, &ModelResult)| match (question, answer) {
        (ModelLoad::Pressure(p), Ok(_)) => {
            contact_compare::area_interval(theory, &inputs, &statistics, *p)
        }
        _ => None,
    };
    let intervals: Vec<_> = questions.iter().zip(&found).map(interval).collect();
    let mut json = object(theory.card(), (&inputs, joint), &questions, &found, spread.as_ref());
    for (i, (question, interval)) in questions.iter().zip(&intervals).enumerate() {
        if matches!(question, ModelLoad::Pressure(_)) {
            json["points"][i]["area_interval"] = json!(interval);
        }
    }
    json["findings"] = contact_report::findings_json(&findings);
    json["level"] = json!(form.name());
    json["cleaning"] = contact_report::cleaning_json(&traces.cleaned);
    json["profile"] = contact_report::profile_statistics_json(&statistics);
    let traces = statistics.traces;
    Ok(OfProfile { json, results: found, intervals, findings, traces, inputs, questions, spread })
}

/// The object that scripts see.
pub fn object(
    card: &Card,
    (inputs, joint): (&Inputs, &Joint),
    questions: &[ModelLoad],
    results: &[ModelResult],
    spread: Option<&Spread>,
) -> Value {
    let point = |(q, a): (&ModelLoad, &ModelResult)| {
        let mut point = point(*q, a);
        conducts(&mut point, a);
        if let Some(spread) = spread {
            point["load"] = json!(spread.force(q.value()));
        }
        point
    };
    let points: Vec<Value> = questions.iter().zip(results).map(point).collect();
    let mut json = json!({
        "model": card.name,
        "citation": card.citation,
        "modulus": (!card.is_rigid).then_some(inputs.modulus.pascals()),
        "inputs": given(card, inputs),
        "load_area": spread.map(|s| s.area),
        "points": points,
    });
    if let Some(gas) = &joint.gas {
        json["gas"] = contact_report::gas_json(gas);
    }
    json
}

/// Adds what the joint conducts to a point, with a correlation what it is a fit of.
fn conducts(point: &mut Value, answer: &ModelResult) {
    let (Ok(said), Value::Object(keys)) = (answer, point) else { return };
    let Some([found, exact]) = &said.conducted else { return };
    keys.extend(contact_report::conducted_keys(found));
    let both = [
        ("electrical", found.electrical, exact.electrical),
        ("thermal", found.thermal, exact.thermal),
    ];
    for (name, fit, exact) in both {
        if let Some(exact) = exact.filter(|_| exact != fit) {
            keys.insert(format!("{name}_conductance_exact"), json!(exact.value));
        }
    }
}

/// The same with six digits of the value, unless they would move it into the domain.
pub fn short(error: &ModelError) -> ModelError {
    let mut short = error.clone();
    if let ModelError::OutsideDomain { value, domain, .. } = &mut short {
        let rounded = round_to_digits(*value, 6);
        if !domain.contains(&rounded) {
            *value = rounded;
        }
    }
    short
}

/// A refusal by the theory, or an iteration that did not end.
pub fn failure(error: &ModelError) -> Failure {
    let error = &short(error);
    match error {
        ModelError::NotConverged { .. } => Failure::incomplete("not_converged", error.to_string()),
        _ => Failure::from_error(error),
    }
}

fn point(question: ModelLoad, answer: &ModelResult) -> Value {
    let said = answer.as_ref().ok();
    let state = said.map(|said| &said.state);
    let (pressure, separation) = match (state, question) {
        (Some(state), _) => (Some(state.mean_pressure), state.separation),
        (None, ModelLoad::Pressure(p)) => (Some(p), None),
        (None, ModelLoad::Separation(d)) => (None, Some(d)),
    };
    json!({
        "mean_pressure": pressure,
        "area_fraction": state.map(|state| state.area_fraction),
        "area_interval": said.and_then(|said| said.area_interval),
        "survey": said.and_then(|said| said.survey).map(|e| json!({
            "area_error": [e.low, e.high],
            "surfaces": e.surfaces,
        })),
        "real_pressure": state.and_then(ContactState::real_pressure),
        "separation": separation,
        "mean_gap": state.and_then(|state| state.mean_gap),
        "caveat": state.and_then(|state| state.caveat.as_ref()).map(caveat),
        "error": answer.as_ref().err().map(refusal),
    })
}

fn caveat(caveat: &Caveat) -> Value {
    let (quantity, value, limit) = match caveat {
        Caveat::Saturated { quantity } | Caveat::Underflow { quantity } => {
            (quantity.as_ref(), None, None)
        }
        Caveat::BeyondModel { quantity, value, limit, .. } => {
            (quantity.as_ref(), Some(*value), Some(*limit))
        }
        _ => ("", None, None),
    };
    json!({
        "kind": variant(caveat), "quantity": quantity, "value": value, "limit": limit,
        "message": caveat.to_string(),
    })
}

fn refusal(error: &ModelError) -> Value {
    let (quantity, value, domain) = match error {
        ModelError::InvalidInput { quantity, value, .. } => (quantity.as_ref(), Some(*value), None),
        ModelError::OutsideDomain { quantity, value, domain, .. } => {
            // The largest double stands for no bound.
            let bound = |end: f64| (end.abs() < f64::MAX).then_some(end);
            (quantity.as_ref(), Some(*value), Some([bound(*domain.start()), bound(*domain.end())]))
        }
        ModelError::NotConverged { residual, .. } => ("residual", Some(*residual), None),
        _ => ("", None, None),
    };
    json!({
        "kind": variant(error), "quantity": quantity, "value": value, "domain": domain,
        "message": short(error).to_string(),
    })
}

/// What the model was given, for the JSON.
fn given(card: &Card, inputs: &Inputs) -> Value {
    let has_gap = card.takes(Input::Gamma) && inputs.has_gap();
    let alone = || inputs.mean_square_slope.map(|m2| json!({ "m0": null, "m2": m2, "m4": null }));
    let moments = inputs.moments.map(|m| json!(m)).or_else(alone);
    let amplitudes = inputs.amplitudes.as_ref();
    json!({
        "moments": moments,
        "rms_height": inputs.rms_height,
        "mean_slope": inputs.mean_slope,
        "source": inputs.m2().map(|_| inputs.source.name()),
        "asperities": inputs.asperities,
        "max_amplitude_ratio":
            inputs.max_amplitude_ratio.or(amplitudes.map(AmplitudeSpectrum::max_amplitude_ratio)),
        "record_length": amplitudes.map(AmplitudeSpectrum::record_length),
        "dimension": inputs.fractal.map(|f| f.dimension).or(inputs.dimension),
        "roughness": inputs.fractal.map(|f| f.roughness),
        "nominal_area": inputs.nominal_area,
        "critical_area": inputs.critical_area,
        "hardness": inputs.hardness,
        "gamma": has_gap.then(|| inputs.gamma()),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_refusal_has_six_digits_and_stays_true() {
        let error = |value: f64| ModelError::OutsideDomain {
            model: "M".into(),
            quantity: "D".into(),
            value,
            domain: 1.0..=1.5,
            reason: "it diverges".into(),
        };
        let text = short(&error(1.623_456_789_012_345)).to_string();
        assert!(text.starts_with("M: D = 1.62346 is outside"), "{text}");
        assert!(short(&error(1.500_000_000_1)).to_string().contains("1.5000000001"));
    }
}
