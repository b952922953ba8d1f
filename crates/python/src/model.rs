//! One closed form, asked.

use crate::failure::{bug, raise};
use crate::surface::{Laid, Second, surface_of};
use crate::watched::quietly;
use answers::model::{Answer, Question, answers as asked, failure, measured, object, scene};
use answers::{Failure, bodies};
use compare::{Body, ContactModulus, Inputs, Level, SpectralMoments, Spikes, Theory};
use contact_types::{AsperityStatistics, FractalParameters};
use multiscale_models::SelfAffineSpectrum;
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;
use serde::Deserialize;
use serde_json::json;
use surface_stats::Edges;
use surface_stats::clean::row_offsets;

/// What Python asks. SI units; `roughness` is left out where a surface is given.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Request {
    name: String,
    modulus: Option<f64>,
    bodies: Vec<Body>,
    hardness: Option<f64>,
    pressures: Option<Vec<f64>>,
    separations: Option<Vec<f64>>,
    pub(crate) level: Level,
    roughness: Option<Roughness>,
}

#[derive(Deserialize)]
#[serde(rename_all = "snake_case")]
enum Roughness {
    Moments { m0: f64, m2: f64, m4: f64 },
    Asperities { density: f64, radius: f64, height_std: f64, mean_offset: f64 },
    SelfAffine { hurst: f64, rolloff: f64, cutoff: f64, m0: f64 },
    Fractal { dimension: f64, roughness: f64, area: f64, critical_area: Option<f64> },
}

impl Roughness {
    fn add(&self, model: &str, inputs: &mut Inputs) -> Result<(), Failure> {
        match *self {
            Self::Moments { m0, m2, m4 } => {
                inputs.moments = Some(SpectralMoments { m0, m2, m4 });
            }
            Self::Asperities { density, radius, height_std, mean_offset } => {
                let given = AsperityStatistics { density, radius, height_std, mean_offset };
                inputs.asperities = Some(given);
            }
            Self::SelfAffine { hurst, rolloff, cutoff, m0 } => {
                let refused = |e| Failure::from_error(&e);
                let spectrum = SelfAffineSpectrum::from_wavelengths(hurst, rolloff, cutoff, m0)
                    .map_err(refused)?;
                inputs.self_affine = Some(spectrum);
                inputs.moments = Some(spectrum.moments());
                if matches!(model, "stacked" | "multiscale") {
                    let amplitudes = spectrum.profile_amplitudes(rolloff).map_err(refused)?;
                    inputs.amplitudes = Some(amplitudes);
                }
            }
            Self::Fractal { dimension, roughness, area, critical_area } => {
                inputs.fractal = Some(FractalParameters { dimension, roughness });
                inputs.nominal_area = Some(area);
                inputs.critical_area = critical_area;
            }
        }
        Ok(())
    }
}

/// What helps where a model lacks something.
pub(crate) const WAY_OUT: &str = "give pressure, or what the model needs: rc.Moments, rc.Asperities, rc.SelfAffine, \
                                  rc.Fractal or a surface; rc.models() lists the inputs";

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

    pub(crate) fn modulus(&self) -> Result<ContactModulus, Failure> {
        match self.modulus {
            Some(pascals) => bodies::of_modulus(pascals),
            None => bodies::contact_modulus(&self.bodies),
        }
    }

    /// With what no roughness says.
    pub(crate) fn complete(&self, inputs: Inputs) -> Inputs {
        let hardness = self.hardness.or(inputs.hardness);
        Inputs { hardness, poisson: compare::poisson(&self.bodies), ..inputs }
    }

    pub(crate) fn questions(&self) -> Vec<Question> {
        let pressures = self.pressures.iter().flatten().map(|&p| Question::Pressure(p));
        let separations = self.separations.iter().flatten().map(|&d| Question::Separation(d));
        pressures.chain(separations).collect()
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
    let mut inputs = request.complete(Inputs::new(request.modulus()?));
    let (mut rows, mut spikes, mut cleaned, mut level) = (None, Spikes::default(), None, None);
    let mut pair = None;
    if let Some((mut surface, facts)) = surface {
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
        inputs = measured(&request.name, inputs, &path, surface.heights, missing, how)?;
        level = Some(used.name());
    }
    if let Some(roughness) = &request.roughness {
        roughness.add(&request.name, &mut inputs)?;
    }
    let questions = request.questions();
    let found = asked(theory, &inputs, &questions).map_err(|e| e.failure(WAY_OUT))?;
    let mut json = object(theory.card(), &inputs, &questions, &found, None);
    let mut findings = scene(&inputs, &found, rows).findings();
    findings.extend(compare::spiky(&spikes, None));
    findings.extend(pair.as_ref().map(compare::of_pair).into_iter().flatten());
    findings.sort_by_key(|f| f.weight);
    json["findings"] = report::findings_json(&findings);
    json["level"] = json!(level);
    json["cleaning"] = report::cleaning_json(&cleaned.unwrap_or_default());
    json["pair"] = pair.as_ref().map_or(serde_json::Value::Null, report::pair_json);
    json["bodies"] = report::bodies_json(pair.as_ref(), &request.bodies);
    Ok((json.to_string(), trouble(&found)))
}
