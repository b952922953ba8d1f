//! One closed form, asked.

use crate::failure::{bug, raise};
use crate::surface::{Laid, Second, surface_of};
use crate::watched::quietly;
use answers::model::{Answer, Question, answers as asked, failure, measured, object, scene};
use answers::typed::{Typed, Untyped};
use answers::{Failure, bodies};
use compare::{
    Body, Card, ContactModulus, Input, Inputs, Joint, Level, MaterialUse, Spikes, Theory,
};
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;
use serde::Deserialize;
use serde_json::json;
use std::collections::BTreeMap;
use surface_stats::Edges;
use surface_stats::clean::row_offsets;

/// What Python asks. SI units; `roughness` is left out where a surface is given.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Request {
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

impl Request {
    pub(crate) fn theory(&self) -> Result<&'static dyn Theory, Failure> {
        compare::find(&self.name).ok_or_else(|| {
            let all: Vec<&str> =
                compare::built_in().iter().map(|t| t.card().name.as_ref()).collect();
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
        Ok(Inputs { hardness, gamma, poisson: compare::poisson(&self.bodies), ..inputs })
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
        Ok(Inputs { hardness, poisson: compare::poisson(&self.bodies), ..inputs })
    }

    pub(crate) fn questions(&self) -> Vec<Question> {
        let pressures = self.pressures.iter().flatten().map(|&p| Question::Pressure(p));
        let separations = self.separations.iter().flatten().map(|&d| Question::Separation(d));
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
pub(crate) fn trouble(answers: &[Answer]) -> Option<(String, String)> {
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
) -> PyResult<Answered> {
    let request: Request = serde_json::from_str(request).map_err(|e| bug(&e))?;
    let surface = surface.map(|(heights, facts)| surface_of(&heights, &facts)).transpose()?;
    let laid = Laid::of(against.as_ref())?;
    let found = quietly(py, threads, move || answer(&request, surface, laid))?;
    found.map_err(|e| raise(&e))
}

pub(crate) type Answered = (String, Option<(String, String)>);

fn answer(
    request: &Request,
    surface: Option<(compare::Surface, crate::surface::Facts)>,
    laid: Option<Laid>,
) -> Result<Answered, Failure> {
    let theory = request.theory()?;
    let card = theory.card();
    let (mut rows, mut spikes, mut cleaned, mut level) = (None, Spikes::default(), None, None);
    let mut pair = None;
    let inputs = if let Some((mut surface, facts)) = surface {
        let given = request.complete(card, Inputs::new(request.modulus(card)?))?;
        let mut missing = facts.missing;
        let path = facts.path().to_owned();
        if let Some(laid) = laid {
            surface = laid.on(surface, request.level)?;
            missing = surface.origin.missing();
            pair = surface.origin.pair().cloned();
        } else {
            cleaned = Some(facts.cleaned);
        }
        let steps = cleaned.as_deref().unwrap_or_default();
        spikes = Spikes::left(&surface.heights, steps, pair.as_ref());
        rows = row_offsets(surface.heights.grid(), surface.heights.heights()).ok();
        let used = request.level.on(&surface.heights);
        let used = used.map_err(|e| Failure::in_file(&path, &e))?;
        let how = (used, Edges::Open);
        level = Some(used.name());
        measured(card, given, &path, surface.heights, missing, how)?
    } else {
        request.typed(card, request.roughness.as_ref().unwrap_or(&BTreeMap::new()))?
    };
    let questions = request.questions();
    let joint = request.joint()?;
    let found = asked(theory, &inputs, &questions, joint).map_err(|e| e.failure(WAY_OUT))?;
    let mut json = object(card, (&inputs, joint), &questions, &found, None);
    let mut findings = scene(theory.card(), &inputs, &found, rows).findings();
    findings.extend(compare::spiky(&spikes, None));
    findings.extend(pair.as_ref().map(compare::of_pair).into_iter().flatten());
    findings.sort_by_key(|f| f.weight);
    json["findings"] = report::findings_json(&findings);
    json["level"] = json!(level);
    json["cleaning"] = report::cleaning_json(&cleaned.unwrap_or_default());
    json["pair"] = pair.as_ref().map_or(serde_json::Value::Null, report::pair_json);
    json["bodies"] = report::bodies_json(pair.as_ref(), &request.bodies);
    if !request.materials.is_empty() {
        json["materials"] = report::materials_json(&request.materials);
    }
    Ok((json.to_string(), trouble(&found)))
}
