//! One closed form, asked.

use crate::failure::{bug, raise};
use crate::surface::{HeightFacts, LaidBody, Second, surface_of};
use crate::watched::quietly;
use contact_compare::{
    Body, BuildError, Card, ContactModel, ContactModulus, Input, Inputs, Joint, Level, MaterialUse,
    PairOrigin, Solved, Spikes, Surface, Theory,
};
use contact_front_end::model::{
    ModelLoad, ModelResult, Unasked, failure, measured, object, results, scene,
};
use contact_front_end::typed::{Typed, Untyped};
use contact_front_end::{Failure, bodies};
use contact_types::Named;
use numpy::{PyArray1, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use serde::Deserialize;
use serde_json::json;
use std::collections::BTreeMap;
use surface_stats::clean::{Record, RowOffsets, row_offsets};

/// What Python asks. SI units; `roughness` is left out where a surface is given.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ModelArguments {
    name: String,
    modulus: Option<f64>,
    pub(crate) bodies: Vec<Body>,
    hardness: Option<f64>,
    /// Not only known of the bodies.
    hardness_is_given: bool,
    materials: Vec<MaterialUse>,
    gamma: Option<f64>,
    pub(crate) joint: Joint,
    pressures: Option<Vec<f64>>,
    separations: Option<Vec<f64>>,
    pub(crate) level: Level,
    roughness: Option<BTreeMap<Input, Vec<f64>>>,
}

/// What helps where a model lacks something.
pub(crate) const WAY_OUT: &str = "give pressure, or what the model needs: rc.Moments, rc.Asperities, rc.SelfAffine, \
                                  rc.Fractal, rc.Numbers or a surface; rc.models() lists the inputs";

impl ModelArguments {
    pub(crate) fn theory(&self) -> Result<&'static dyn Theory, Failure> {
        contact_compare::find(&self.name).ok_or_else(|| {
            let all: Vec<&str> =
                contact_compare::built_in().iter().map(|t| t.card().name.as_ref()).collect();
            let message =
                format!("there is no model {:?}; there are {}", self.name, all.join(", "));
            Failure::refused("setting", message)
        })
    }

    pub(crate) fn modulus(&self, card: &Card) -> Result<ContactModulus, Failure> {
        match self.modulus {
            Some(pascals) => bodies::of_modulus(pascals),
            None if card.is_rigid => Ok(ContactModulus::RIGID),
            None => {
                Err(Failure::refused("usage", format!("{} needs modulus or bodies", card.name)))
            }
        }
    }

    /// What is asked of the conduction.
    ///
    /// # Errors
    /// [`Failure`] of what conducts nothing that is known.
    pub(crate) fn joint(&self) -> Result<&Joint, Failure> {
        self.joint.check().map_err(|e| Failure::from_error(&e)).map(|()| &self.joint)
    }

    /// With what no surface says.
    ///
    /// # Errors
    /// [`Failure`] of what the model has no use for.
    pub(crate) fn complete(&self, card: &Card, inputs: Inputs) -> Result<Inputs, Failure> {
        for (is_given, input) in
            [(self.hardness_is_given, Input::Hardness), (self.gamma.is_some(), Input::Gamma)]
        {
            if is_given && !card.takes(input) {
                return Err(refused(card, &Untyped::Unused(input)));
            }
        }
        let (hardness, gamma) = (self.hardness, self.gamma);
        Ok(Inputs { hardness, gamma, poisson: contact_compare::poisson(&self.bodies), ..inputs })
    }

    /// What the model is made from, of numbers typed in.
    fn typed(&self, card: &Card, given: &BTreeMap<Input, Vec<f64>>) -> Result<Inputs, Failure> {
        let lists = given.iter().fold(Typed::default(), |typed, (input, values)| {
            typed.with_list(*input, Some(values.clone()))
        });
        let used = self.hardness_is_given || card.requires(Input::Hardness);
        let own = lists.one(Input::Hardness);
        let typed = match self.hardness.filter(|_| used && own.is_none()) {
            Some(hardness) => lists.with(Input::Hardness, Some(hardness)),
            None => lists,
        };
        let typed = typed.with(Input::Gamma, self.gamma);
        let inputs = typed.inputs(card, self.modulus(card)?).map_err(|e| refused(card, &e))?;
        let hardness = inputs.hardness.or(self.hardness);
        Ok(Inputs { hardness, poisson: contact_compare::poisson(&self.bodies), ..inputs })
    }

    pub(crate) fn questions(&self) -> Vec<ModelLoad> {
        let pressures = self.pressures.iter().flatten().map(|&p| ModelLoad::Pressure(p));
        let separations = self.separations.iter().flatten().map(|&d| ModelLoad::Separation(d));
        pressures.chain(separations).collect()
    }
}

/// Numbers that make no model, each called as Python does.
fn refused(card: &Card, untyped: &Untyped) -> Failure {
    let name = |input: Input| input.name().replace('-', "_");
    match untyped {
        Untyped::Model(error) => Failure::from_error(error),
        Untyped::Incomplete { .. } => Failure::refused("missing_input", untyped.told(card, name)),
        _ => Failure::refused("usage", untyped.told(card, name)),
    }
}

/// The first refusal, as kind and message.
pub(crate) fn trouble(answers: &[ModelResult]) -> Option<(String, String)> {
    let first = answers.iter().find_map(|answer| answer.as_ref().err()).map(failure)?;
    Some((first.kind().to_owned(), first.message().to_owned()))
}

/// What `rough-contact model` answers, as JSON, and the first refusal, as kind and message.
#[pyfunction]
#[pyo3(signature = (request, surface, threads, against=None))]
pub(crate) fn model(
    py: Python<'_>,
    request: &str,
    surface: Option<(PyReadonlyArray2<'_, f64>, String)>,
    threads: usize,
    against: Option<Second<'_>>,
) -> PyResult<ModelAnswer> {
    let request: ModelArguments = serde_json::from_str(request).map_err(|e| bug(&e))?;
    let surface = surface.map(|(heights, facts)| surface_of(&heights, &facts)).transpose()?;
    let laid = LaidBody::of(against.as_ref())?;
    let found = quietly(py, threads, move || answer(&request, surface, laid))?;
    found.map_err(|e| raise(&e))
}

pub(crate) type ModelAnswer = (String, Option<(String, String)>);

/// What a theory is built from, and what is known of the heights that say it.
struct Made {
    inputs: Inputs,
    rows: Option<RowOffsets>,
    spikes: Spikes,
    cleaned: Vec<Record>,
    level: Option<&'static str>,
    pair: Option<PairOrigin>,
}

impl Made {
    fn of(
        request: &ModelArguments,
        card: &Card,
        surface: Option<(Surface, HeightFacts)>,
        laid: Option<LaidBody>,
    ) -> Result<Self, Failure> {
        let Some((mut surface, facts)) = surface else {
            let typed = request.roughness.clone().unwrap_or_default();
            let inputs = request.typed(card, &typed)?;
            let (spikes, cleaned) = (Spikes::default(), Vec::new());
            return Ok(Self { inputs, rows: None, spikes, cleaned, level: None, pair: None });
        };
        let given = request.complete(card, Inputs::new(request.modulus(card)?))?;
        let path = facts.path().to_owned();
        let (mut missing, mut cleaned, mut pair) = (facts.missing, facts.cleaned, None);
        if let Some(laid) = laid {
            surface = laid.on(surface, request.level)?;
            (missing, cleaned) = (surface.origin.missing(), Vec::new());
            pair = surface.origin.pair().cloned();
        }
        let spikes = Spikes::left(&surface.heights, &cleaned, pair.as_ref());
        let rows = row_offsets(surface.heights.grid(), surface.heights.heights()).ok();
        let used = surface.origin.level(request.level).on(&surface.heights);
        let used = used.map_err(|e| Failure::in_file(&path, &e))?;
        let how = (used, surface.origin.edges());
        let inputs = measured(card, given, &path, surface.heights, missing, how)?;
        Ok(Self { inputs, rows, spikes, cleaned, level: Some(used.name()), pair })
    }
}

fn answer(
    request: &ModelArguments,
    surface: Option<(Surface, HeightFacts)>,
    laid: Option<LaidBody>,
) -> Result<ModelAnswer, Failure> {
    let theory = request.theory()?;
    let card = theory.card();
    let Made { inputs, rows, spikes, cleaned, level, pair } =
        Made::of(request, card, surface, laid)?;
    let questions = request.questions();
    let joint = request.joint()?;
    let found = results(theory, &inputs, &questions, joint).map_err(|e| e.failure(WAY_OUT))?;
    let mut json = object(card, (&inputs, joint), &questions, &found, None);
    let scene = scene(theory.card(), &inputs, &found, rows);
    let known = Solved { scene, spikes, pair: pair.as_ref(), ..Solved::default() };
    let findings = known.findings();
    json["findings"] = contact_report::findings_json(&findings);
    json["level"] = json!(level);
    json["cleaning"] = contact_report::cleaning_json(&cleaned);
    json["pair"] = pair.as_ref().map_or(serde_json::Value::Null, contact_report::pair_json);
    json["bodies"] = contact_report::bodies_json(pair.as_ref(), &request.bodies);
    if !request.materials.is_empty() {
        json["materials"] = contact_report::materials_json(&request.materials);
    }
    Ok((json.to_string(), trouble(&found)))
}

/// A closed form that is built once and asked again and again. Private.
#[pyclass(frozen)]
pub(crate) struct Closed {
    title: String,
    model: Box<dyn ContactModel>,
}

#[pymethods]
impl Closed {
    #[new]
    fn new(
        py: Python<'_>,
        request: &str,
        surface: Option<(PyReadonlyArray2<'_, f64>, String)>,
        threads: usize,
    ) -> PyResult<Self> {
        let request: ModelArguments = serde_json::from_str(request).map_err(|e| bug(&e))?;
        let surface = surface.map(|(heights, facts)| surface_of(&heights, &facts)).transpose()?;
        let made = quietly(py, threads, move || {
            let theory = request.theory()?;
            let inputs = Made::of(&request, theory.card(), surface, None)?.inputs;
            let model = theory.build(&inputs).map_err(|e| match e {
                BuildError::Model(error) => failure(&error),
                missing @ BuildError::Missing { .. } => Unasked::Missing(missing).failure(WAY_OUT),
            })?;
            Ok(Self { title: theory.card().title.to_string(), model })
        })?;
        made.map_err(|e: Failure| raise(&e))
    }

    /// Area fraction and mean gap (m) at nominal pressures (Pa); NaN where there is no answer.
    fn at<'py>(
        &self,
        py: Python<'py>,
        pressures: PyReadonlyArray1<'py, f64>,
    ) -> (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>) {
        let asked: Vec<f64> = pressures.as_array().iter().copied().collect();
        let (areas, gaps): (Vec<f64>, Vec<f64>) = py.detach(|| {
            let one = |&p: &f64| {
                let state = self.model.at_pressure(p);
                let state = state.and_then(|s| contact_compare::possible(&self.title, s));
                state.map_or((f64::NAN, f64::NAN), |state| {
                    (state.area_fraction, state.mean_gap.unwrap_or(f64::NAN))
                })
            };
            asked.iter().map(one).unzip()
        });
        (PyArray1::from_vec(py, areas), PyArray1::from_vec(py, gaps))
    }
}
