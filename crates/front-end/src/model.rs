//! Closed-form models at loads and separations: what `rough-contact model` answers.

use crate::complete::Subject;
use crate::failure::{Failure, variant};
use crate::loads::Spread;
use crate::work::extend;
use contact_accuracy::round_to_digits;
use contact_compare::survey::gaussian_errors;
use contact_compare::{
    BuildError, Card, Conducted, Finding, Input, Inputs, Joint, Level, OfMap, Origin, PairOrigin,
    ProfileSurface, Scene, Settings, Solved, Spikes, Theory, Unevenness, built_in, conducted_by,
};
use contact_types::{
    AmplitudeSpectrum, Caveat, ContactModel, ContactModulus, ContactState, ModelError, Named,
    SeparationModel,
};
use serde_json::{Value, json};
use std::path::Path;
use surface_stats::clean::Record;
use surface_stats::profile::ProfileStatistics;
use surface_stats::spectrum::{amplitudes, radial};
use surface_stats::{Edges, StatsError, Warning, mean_slope, moments, spectral_scales};

/// What is asked of the model.
#[derive(Clone, Debug)]
pub enum ModelLoads {
    /// Nominal pressures (Pa).
    Pressures(Vec<f64>),
    /// Distances of the undeformed planes (m).
    Separations(Vec<f64>),
}

/// What a theory says to one question.
#[derive(Clone, Debug)]
pub struct Said {
    /// The contact it answers with.
    pub state: ContactState,
    /// Between which the area lies for 95 of 100 surfaces, if the theory knows its own error.
    pub area_interval: Option<[f64; 2]>,
    /// Its error on isotropic Gaussian surfaces, from lowest to highest, and how many they are, if there are numbers and no map.
    pub survey: Option<([f64; 2], usize)>,
    /// What the joint conducts, if that was asked for and the theory says it; of a correlation also by the expression that
    /// it is a fit of.
    pub conducted: Option<[Conducted; 2]>,
}

/// A question to a theory, answered.
#[derive(Clone, Debug)]
pub struct ModelPoint {
    /// Nominal pressure (Pa): answered, or asked where there is no answer.
    pub mean_pressure: Option<f64>,
    /// Distance of the undeformed planes (m), likewise.
    pub separation: Option<f64>,
    /// What the theory says, or why it says nothing.
    pub answer: Result<Said, ModelError>,
    /// Between which the area lies for 95 of 100 traces like these, if that can be told.
    pub interval: Option<[f64; 2]>,
    /// The pressure asked as a force (N), if forces were asked for.
    pub force: Option<f64>,
}

/// One answer per question, a load or a separation, with what the joint conducts there. A model that cannot be made refuses
/// every question.
/// `ways` out are of a model without separation, and of one that lacks an input.
fn results(
    theory: &dyn Theory,
    given: (&Inputs, &Joint),
    questions: &ModelLoads,
    ways: [&str; 2],
) -> Result<Vec<Result<Said, ModelError>>, Failure> {
    let (card, inputs) = (theory.card(), given.0);
    let title = card.title.as_ref();
    let typed = inputs.moments.filter(|_| !inputs.is_measured);
    let no_separation = || {
        let able = built_in().iter().map(Theory::card).filter(|c| c.has_separation);
        let able = able.map(|c| c.name.as_ref()).collect::<Vec<_>>().join(", ");
        let message = format!("{} has no separation; {}, or one of {able}", card.name, ways[0]);
        Failure::refused("usage", message)
    };
    let said = |model: &dyn ContactModel, state: Result<_, ModelError>| {
        let state = contact_compare::possible(title, state?)?;
        let survey = typed.and_then(|moments| {
            let load = state.mean_pressure / (inputs.modulus.pascals() * moments.rms_gradient());
            gaussian_errors(&card.name, moments.bandwidth(), load)
        });
        Ok(Said {
            area_interval: model.area_interval(state.area_fraction),
            conducted: conducted_by(theory, model, given, &state),
            state,
            survey,
        })
    };
    let (count, answers) = match questions {
        ModelLoads::Pressures(all) => {
            let at = |model: &dyn ContactModel, p: &f64| said(model, model.at_pressure(*p));
            let built = theory.build(inputs);
            (all.len(), built.map(|model| all.iter().map(|p| at(&*model, p)).collect()))
        }
        ModelLoads::Separations(all) => {
            let at = |model: &dyn SeparationModel, d: &f64| said(model, model.at_separation(*d));
            let built = theory.build_separation(inputs).ok_or_else(no_separation)?;
            (all.len(), built.map(|model| all.iter().map(|d| at(&*model, d)).collect()))
        }
    };
    match answers {
        Ok(answers) => Ok(answers),
        Err(BuildError::Model(error)) => Ok(vec![Err(error); count]),
        Err(missing @ BuildError::Missing { .. }) => {
            Err(Failure::refused("missing_input", format!("{missing}; {}", ways[1])))
        }
    }
}

/// What is asked of elasticity, with the results by rising load.
fn scene(card: &Card, inputs: &Inputs, points: &[ModelPoint], warned: Vec<Warning>) -> Scene {
    // Bodies that yield bear what presses them.
    let answers = points.iter().filter_map(|p| p.answer.as_ref().ok()).filter(|_| !card.yields);
    let hardness = inputs.hardness;
    Scene { warned, hardness, ..Scene::of(inputs, answers.map(|said| &said.state)) }
}

/// What is known of the surface that a model is asked about.
#[derive(Debug)]
pub struct ModelSubject {
    /// Numbers for its inputs. What no surface says is added by who asks.
    pub inputs: Inputs,
    warned: Vec<Warning>,
    spikes: Spikes,
    cleaned: Vec<Record>,
    level: Option<Level>,
    pair: Option<PairOrigin>,
    profile: Option<(ProfileStatistics, Origin, Option<Unevenness>)>,
}

/// What a model answers.
#[derive(Debug)]
pub struct ModelReply {
    /// What scripts see.
    pub json: Value,
    /// One for each load or separation.
    pub points: Vec<ModelPoint>,
    /// What may change a conclusion.
    pub findings: Vec<Finding>,
    /// What the model was given.
    pub inputs: Inputs,
    /// The joint, with its area and hardness.
    pub joint: Joint,
    /// The form that was taken off a map or a trace.
    pub level: Option<Level>,
    /// The two bodies, if it is a pair.
    pub pair: Option<PairOrigin>,
}

impl ModelSubject {
    /// Numbers typed in.
    pub fn typed(inputs: Inputs) -> Self {
        let (spikes, warned, cleaned) = (Spikes::default(), Vec::new(), Vec::new());
        Self { inputs, warned, spikes, cleaned, level: None, pair: None, profile: None }
    }

    /// What a model needs of a map, and nothing else; edges that are not given are those of its origin.
    ///
    /// # Errors
    /// [`Failure`] of a map without statistics.
    pub fn of_map(
        card: &Card,
        modulus: ContactModulus,
        subject: Subject<'_>,
        asked: Level,
        edges: Option<Edges>,
    ) -> Result<Self, Failure> {
        let Subject { path, surface, cleaned, .. } = subject;
        let refused = |e: StatsError| Failure::in_file(path, &e);
        let (origin, heights) = (surface.origin, surface.heights);
        let pair = origin.pair().cloned();
        let spikes = Spikes::left(&heights, &cleaned, pair.as_ref());
        let (form, map) = origin.level(asked).taken_off(heights).map_err(refused)?;
        let edges = edges.unwrap_or_else(|| origin.edges());
        let mut inputs = Inputs::new(modulus);
        inputs.nominal_area = Some(map.grid().area());
        // Every model has the moments that a study gives it; only Persson's mean gap needs more.
        inputs.is_measured = true;
        let (found, warned) = moments(&map, edges).map_err(refused)?;
        inputs.moments = Some(found);
        if card.takes(Input::MeanSlope) {
            inputs.mean_slope = Some(mean_slope(&map));
        }
        match card.of_map {
            OfMap::Fractal => {
                ([_, inputs.dimension], inputs.fractal) =
                    spectral_scales(&map, edges).map_err(refused)?;
            }
            OfMap::Spectrum => inputs.spectrum = Some(radial(&map).map_err(refused)?),
            OfMap::Amplitudes => inputs.amplitudes = Some(amplitudes(&map).map_err(refused)?),
            OfMap::Moments => {}
        }
        Ok(Self { inputs, warned, spikes, cleaned, level: Some(form), pair, profile: None })
    }

    /// The isotropic surface with the moments of these traces.
    ///
    /// # Errors
    /// [`Failure`] of traces without statistics.
    pub fn of_traces(
        modulus: ContactModulus,
        path: &Path,
        traces: &ProfileSurface,
        asked: Level,
    ) -> Result<Self, Failure> {
        let refused = |e: StatsError| Failure::in_file(path, &e);
        // The ends of a profile need not meet.
        let level = if asked == Level::Auto { Level::Plane } else { asked };
        let options = traces.options(&Settings { level, ..Settings::default() });
        let (statistics, _, spectrum) =
            ProfileStatistics::of(&traces.traces, &options).map_err(refused)?;
        let inputs =
            contact_compare::profile_inputs(&statistics, &spectrum, modulus).map_err(refused)?;
        Ok(Self {
            cleaned: traces.origin.cleaned().to_vec(),
            level: Some(level),
            profile: Some((statistics, traces.origin.clone(), traces.uneven)),
            ..Self::typed(inputs)
        })
    }

    /// Asks a model; `ways` out are of one without separation, and of one that lacks an input.
    ///
    /// # Errors
    /// [`Failure`] of these two. What the theory refuses is among the results.
    pub fn ask(
        self,
        theory: &dyn Theory,
        joint: &Joint,
        questions: &ModelLoads,
        spread: Option<&Spread>,
        ways: [&str; 2],
    ) -> Result<ModelReply, Failure> {
        let Self { inputs, warned, spikes, cleaned, level, pair, profile } = self;
        let card = theory.card();
        let (asked, is_load) = match questions {
            ModelLoads::Pressures(all) => (all, true),
            ModelLoads::Separations(all) => (all, false),
        };
        // Of a joint the area that carries the load, or that of the map; traces have none.
        let of_map = inputs.nominal_area.filter(|_| profile.is_none());
        let area = joint.area.or(spread.map(|s| s.area)).or(of_map);
        let joint = Joint { area, hardness: inputs.hardness, ..*joint };
        let mut answers = results(theory, (&inputs, &joint), questions, ways)?;
        // An interval is that of Gaussian surfaces.
        for said in answers.iter_mut().flatten() {
            said.area_interval = said.area_interval.filter(|_| warned.is_empty());
        }
        let point = |(&value, answer): (&f64, Result<Said, ModelError>)| {
            let state = answer.as_ref().ok().map(|said| &said.state);
            ModelPoint {
                mean_pressure: state.map_or(is_load.then_some(value), |s| Some(s.mean_pressure)),
                separation: state.map_or((!is_load).then_some(value), |s| s.separation),
                force: spread.filter(|_| is_load).map(|spread| value * spread.area),
                answer,
                interval: None,
            }
        };
        let mut points: Vec<ModelPoint> = asked.iter().zip(answers).map(point).collect();
        let scene = scene(card, &inputs, &points, warned);
        let objects: Vec<Value> = points.iter().map(point_object).collect();
        let mut json = json!({
            "model": card.name,
            "citation": card.citation,
            "modulus": (!card.is_rigid).then_some(inputs.modulus.pascals()),
            "inputs": given(card, &inputs),
            "load_area": spread.map(|s| s.area),
            "points": objects,
            "level": level.map(Level::name),
            "cleaning": contact_report::cleaning_json(&cleaned),
        });
        if let Some(gas) = &joint.gas {
            json["gas"] = contact_report::gas_json(gas);
        }
        let findings = if let Some((statistics, origin, uneven)) = &profile {
            for (i, (point, &p)) in points.iter_mut().zip(asked).enumerate().filter(|_| is_load) {
                let interval = || contact_compare::area_interval(theory, &inputs, statistics, p);
                point.interval = point.answer.is_ok().then(interval).flatten();
                json["points"][i]["area_interval"] = json!(point.interval);
            }
            json["profile"] = contact_report::profile_statistics_json(statistics);
            contact_compare::profile_findings(statistics, *uneven, origin, &scene)
        } else {
            json["pair"] = pair.as_ref().map_or(Value::Null, contact_report::pair_json);
            Solved { scene, spikes, pair: pair.as_ref(), ..Solved::default() }.findings()
        };
        json["findings"] = contact_report::findings_json(&findings);
        Ok(ModelReply { json, points, findings, inputs, joint, level, pair })
    }
}

/// What a theory is, for scripts.
pub fn described(card: &Card) -> Value {
    json!({
        "name": card.name,
        "title": card.title,
        "citation": card.citation,
        "inputs": card.needs,
        "domain": card.domain,
        "separation": card.has_separation,
    })
}

/// The same with six digits of the value, unless they would move it into the domain.
fn short(error: &ModelError) -> ModelError {
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
        _ => Failure::from(error),
    }
}

fn point_object(point: &ModelPoint) -> Value {
    let said = point.answer.as_ref().ok();
    let state = said.map(|said| &said.state);
    let mut json = json!({
        "mean_pressure": point.mean_pressure,
        "area_fraction": state.map(|state| state.area_fraction),
        "area_interval": said.and_then(|said| said.area_interval),
        "survey": said.and_then(|said| said.survey).map(|(area_error, surfaces)| json!({
            "area_error": area_error,
            "surfaces": surfaces,
        })),
        "real_pressure": state.and_then(ContactState::real_pressure),
        "separation": point.separation,
        "mean_gap": state.and_then(|state| state.mean_gap),
        "caveat": state.and_then(|state| state.caveat.as_ref()).map(caveat),
        "error": point.answer.as_ref().err().map(refusal),
    });
    if let Some([found, exact]) = said.and_then(|s| s.conducted) {
        extend(&mut json, contact_report::conducted_keys(&found));
        // Of a correlation also what it is a fit of.
        let both = [
            ("electrical_conductance_exact", found.electrical, exact.electrical),
            ("thermal_conductance_exact", found.thermal, exact.thermal),
        ];
        for (name, fit, exact) in both {
            if let Some(exact) = exact.filter(|_| exact != fit) {
                json[name] = json!(exact.value);
            }
        }
    }
    if let Some(force) = point.force {
        json["load"] = json!(force);
    }
    json
}

fn caveat(caveat: &Caveat) -> Value {
    let mut json = json!({ "value": null, "limit": null, "message": caveat.to_string() });
    if let Value::Object(own) = json!(caveat) {
        extend(&mut json, own);
    }
    json
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

fn given(card: &Card, inputs: &Inputs) -> Value {
    let alone = || inputs.mean_square_slope.map(|m2| json!({ "m0": null, "m2": m2, "m4": null }));
    let moments = inputs.moments.map(|m| json!(m)).or_else(alone);
    let amplitudes = inputs.amplitudes.as_ref();
    json!({
        "moments": moments,
        "rms_height": inputs.rms_height,
        "mean_slope": inputs.mean_slope,
        "source": inputs.m2().map(|_| if inputs.is_measured { "finite-differences" } else { "given" }),
        "asperities": inputs.asperities,
        "max_amplitude_ratio":
            inputs.max_amplitude_ratio.or(amplitudes.map(AmplitudeSpectrum::max_amplitude_ratio)),
        "record_length": amplitudes.map(AmplitudeSpectrum::record_length),
        "dimension": inputs.fractal.map(|f| f.dimension).or(inputs.dimension),
        "roughness": inputs.fractal.map(|f| f.roughness),
        "nominal_area": inputs.nominal_area,
        "critical_area": inputs.critical_area,
        "hardness": inputs.hardness,
        "gamma": inputs.gamma().filter(|_| card.takes(Input::Gamma)),
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
