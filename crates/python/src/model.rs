//! One closed form, asked.

use crate::failure::{bug, raise};
use crate::surface::{HeightFacts, LaidBody, Second, subject, surface_of};
use crate::watched::quietly;
use contact_compare::{
    Body, BuildError, Card, ContactModel, ContactModulus, Input, Inputs, Joint, Level, MaterialUse,
    Surface, Theory,
};
use contact_front_end::Failure;
use contact_front_end::model::{ModelLoads, ModelSubject, failure};
use contact_front_end::typed;
use numpy::{PyArray1, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use serde::Deserialize;
use std::collections::BTreeMap;

/// What Python asks. SI units; `roughness` is left out where a surface is given.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ModelArguments {
    name: String,
    modulus: Option<f64>,
    bodies: Vec<Body>,
    hardness: Option<f64>,
    /// Not only known of the bodies.
    hardness_is_given: bool,
    materials: Vec<MaterialUse>,
    gamma: Option<f64>,
    joint: Joint,
    pressures: Option<Vec<f64>>,
    separations: Option<Vec<f64>>,
    pub(crate) level: Level,
    roughness: Option<BTreeMap<Input, Vec<f64>>>,
}

/// What helps where a model lacks something.
const WAY_OUT: &str = "give pressure, or what the model needs: rc.Moments, rc.Asperities, rc.SelfAffine, \
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
            Some(_) if card.is_rigid && self.bodies.is_empty() => {
                Err(typed::unused(card, "modulus", named))
            }
            Some(pascals) => ContactModulus::from_pascals(pascals).map_err(|e| Failure::from(&e)),
            None if card.is_rigid => Ok(ContactModulus::RIGID),
            None => {
                Err(Failure::refused("usage", format!("{} needs modulus or bodies", card.name)))
            }
        }
    }

    /// With what no surface says.
    ///
    /// # Errors
    /// [`Failure`] of what the model has no use for.
    pub(crate) fn complete(&self, card: &Card, inputs: Inputs) -> Result<Inputs, Failure> {
        self.refuse_unused(card)?;
        let (hardness, gamma) = (self.hardness, self.gamma);
        Ok(Inputs { hardness, gamma, poisson: contact_compare::poisson(&self.bodies), ..inputs })
    }

    fn refuse_unused(&self, card: &Card) -> Result<(), Failure> {
        for (is_given, input) in
            [(self.hardness_is_given, Input::Hardness), (self.gamma.is_some(), Input::Gamma)]
        {
            if is_given && !card.takes(input) {
                return Err(typed::unused(card, &named(input), named));
            }
        }
        Ok(())
    }

    /// What the model is made from, of numbers typed in.
    fn typed(&self, card: &Card) -> Result<Inputs, Failure> {
        let mut typed = self.roughness.clone().unwrap_or_default();
        let used = self.hardness_is_given || card.yields;
        if let Some(hardness) = self.hardness.filter(|_| used) {
            typed.entry(Input::Hardness).or_insert(vec![hardness]);
        }
        if let Some(gamma) = self.gamma {
            typed.insert(Input::Gamma, vec![gamma]);
        }
        let inputs = typed::inputs(&typed, card, self.modulus(card)?, named, None)?;
        let hardness = inputs.hardness.or(self.hardness);
        Ok(Inputs { hardness, poisson: contact_compare::poisson(&self.bodies), ..inputs })
    }

    /// Numbers for the inputs, of a surface or typed in.
    fn subject(
        &self,
        card: &Card,
        surface: Option<(Surface, HeightFacts)>,
        laid: Option<LaidBody>,
    ) -> Result<ModelSubject, Failure> {
        let Some((surface, facts)) = surface else {
            return self.typed(card).map(ModelSubject::typed);
        };
        self.refuse_unused(card)?;
        let map = subject(surface, &facts, laid, self.level)?;
        let mut found = ModelSubject::of_map(card, self.modulus(card)?, map, self.level, None)?;
        found.inputs = self.complete(card, found.inputs)?;
        Ok(found)
    }

    /// What the model says of this, as JSON, and the first refusal, as kind and message.
    pub(crate) fn ask(
        &self,
        theory: &dyn Theory,
        subject: ModelSubject,
    ) -> Result<ModelAnswer, Failure> {
        let questions = match &self.separations {
            Some(all) if !all.is_empty() => ModelLoads::Separations(all.clone()),
            _ => ModelLoads::Pressures(self.pressures.clone().unwrap_or_default()),
        };
        self.joint.check().map_err(|e| Failure::from(&e))?;
        if theory.card().takes(Input::MeanSlope) && !self.joint.is_asked() {
            let way =
                "says what a joint conducts; give conductivity, such as '50 W/m/K', or resistivity";
            return Err(Failure::refused("missing_input", format!("{} {way}", self.name)));
        }
        let mut found = subject.ask(theory, &self.joint, &questions, None, [WAY_OUT; 2])?;
        found.json["bodies"] = contact_report::bodies_json(found.pair.as_ref(), &self.bodies);
        if !self.materials.is_empty() {
            found.json["materials"] = contact_report::materials_json(&self.materials);
        }
        let mut answers = found.points.iter().map(|point| &point.answer);
        let refused = answers.find_map(|answer| answer.as_ref().err()).map(failure);
        Ok((found.json.to_string(), refused.map(|first| (first.kind, first.message))))
    }
}

fn named(input: Input) -> String {
    input.name().replace('-', "_")
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
    let found = quietly(py, threads, move || {
        let theory = request.theory()?;
        request.ask(theory, request.subject(theory.card(), surface, laid)?)
    })?;
    found.map_err(|e| raise(&e))
}

pub(crate) type ModelAnswer = (String, Option<(String, String)>);

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
            let inputs = request.subject(theory.card(), surface, None)?.inputs;
            let model = theory.build(&inputs).map_err(|e| match &e {
                BuildError::Model(error) => failure(error),
                BuildError::Missing { .. } => {
                    Failure::refused("missing_input", format!("{e}; {WAY_OUT}"))
                }
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
