//! The study: every model beside the deterministic solution, as a report.

use crate::failure::{bug, raise};
use crate::surface::{LaidBody, Second, surface_of};
use crate::watched::{News, watched};
use contact_compare::{
    BuildError, Card, Citation, Comparison, ContactModel, ContactModulus, ContactState, CurvePoint,
    Inputs, ModelError, Progress, Registry, RunFile, Settings, StudyError, Surface, Tabulated,
    Theory, loads_of_study,
};
use contact_front_end::Failure;
use contact_report::Provenance;
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;
use serde::Deserialize;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ops::{ControlFlow, RangeInclusive};

/// A model that Python computed: a curve for each surface, or why there is none.
#[derive(Deserialize)]
struct OwnModel {
    name: String,
    title: String,
    citation: String,
    /// The year in which it was given.
    year: u16,
    /// By the name of the surface.
    curves: BTreeMap<String, Result<Answers, String>>,
    /// Seconds that Python took for a load, by the name of the surface.
    seconds: BTreeMap<String, f64>,
}

/// By rising load.
#[derive(Deserialize)]
struct Answers {
    points: Vec<CurvePoint>,
    /// Nominal pressures (Pa) at which it has no answer.
    holes: Vec<f64>,
}

/// Ranges of pressure (Pa) without an answer, from the answer below to the answer above.
type Holes = Vec<RangeInclusive<f64>>;

/// The same as a theory of the study.
struct GivenTheory {
    card: Card,
    curves: BTreeMap<String, Result<(Tabulated, Holes), String>>,
}

/// A curve that is not drawn across loads without an answer.
struct Holed {
    title: Cow<'static, str>,
    curve: Box<dyn ContactModel>,
    holes: Holes,
}

impl ContactModel for Holed {
    fn citation(&self) -> Citation {
        self.curve.citation()
    }

    fn at_pressure(&self, mean_pressure: f64) -> Result<ContactState, ModelError> {
        let is_in =
            |r: &&RangeInclusive<f64>| *r.start() < mean_pressure && mean_pressure < *r.end();
        if self.holes.iter().find(is_in).is_none() {
            return self.curve.at_pressure(mean_pressure);
        }
        Err(ModelError::InvalidInput {
            model: self.title.clone(),
            quantity: "mean pressure in Pa".into(),
            value: mean_pressure,
            requirement: "the model returned NaN there".into(),
        })
    }
}

impl GivenTheory {
    fn of(own: OwnModel) -> Result<Self, Failure> {
        let citation = Citation {
            authors: own.title.clone().into(),
            year: own.year,
            title: own.citation.into(),
            journal: "given in Python".into(),
            doi: "".into(),
        };
        let card = Card::new(own.name, own.title, citation);
        let mut curves = BTreeMap::new();
        for (surface, curve) in own.curves {
            let curve = match curve {
                Ok(Answers { points, holes }) => {
                    let around = |hole: f64| {
                        let above = points.partition_point(|p| p.mean_pressure < hole);
                        let at = |i: usize| points.get(i).map(|p| p.mean_pressure);
                        let below = above.checked_sub(1).and_then(at).unwrap_or(0.0);
                        below..=at(above).unwrap_or(f64::INFINITY)
                    };
                    let holes = holes.into_iter().map(around).collect();
                    let curve = Tabulated::new(card.clone(), points).map_err(|e| {
                        Failure::refused("model", format!("{} on {surface}: {e}", card.name))
                    })?;
                    Ok((curve, holes))
                }
                Err(why) => Err(why),
            };
            curves.insert(surface, curve);
        }
        Ok(Self { card, curves })
    }
}

impl Theory for GivenTheory {
    fn card(&self) -> &Card {
        &self.card
    }

    fn build(&self, inputs: &Inputs) -> Result<Box<dyn ContactModel>, BuildError> {
        let model = || self.card.title.clone();
        let needs = |what: String| BuildError::Missing { model: model(), needs: what.into() };
        let surface = inputs.surface.clone().unwrap_or_default();
        match self.curves.get(&surface) {
            Some(Ok((curve, holes))) => Ok(Box::new(Holed {
                title: self.card.title.clone(),
                curve: curve.build(inputs)?,
                holes: holes.clone(),
            })),
            Some(Err(why)) => Err(needs(why.clone())),
            None => Err(needs(format!("a curve of {surface}"))),
        }
    }
}

/// Every built-in model that a study asks, as JSON.
#[pyfunction]
pub(crate) fn models() -> String {
    let described = |theory: &dyn Theory| contact_front_end::model::described(theory.card());
    serde_json::Value::Array(contact_compare::built_in().iter().map(described).collect())
        .to_string()
}

/// Every number that a model may be made from, as JSON: its name, unit, and what it is.
#[pyfunction]
pub(crate) fn model_inputs() -> String {
    serde_json::json!(contact_compare::INPUTS).to_string()
}

/// Nominal pressures (Pa) of a study of these settings on a surface of this slope.
#[pyfunction]
pub(crate) fn study_pressures(settings: &str, rms_gradient: f64) -> PyResult<Vec<f64>> {
    let settings: Settings = serde_json::from_str(settings).map_err(|e| bug(&e))?;
    let modulus =
        ContactModulus::from_pascals(settings.modulus).map_err(|e| raise(&(&e).into()))?;
    Ok(loads_of_study(&settings, modulus, rms_gradient))
}

/// Files by name; what went wrong, as kind and message; the exception that stopped it.
type Studied = (BTreeMap<String, String>, Option<(String, String)>, Option<Py<PyAny>>);

/// What `rough-contact compare` answers: its files.
#[pyfunction]
#[pyo3(signature = (surfaces, settings, own, progress=None, against=None))]
pub(crate) fn study(
    py: Python<'_>,
    surfaces: Vec<(PyReadonlyArray2<'_, f64>, String, String)>,
    settings: &str,
    own: &str,
    progress: Option<Py<PyAny>>,
    against: Option<Second<'_>>,
) -> PyResult<Studied> {
    let settings: Settings = serde_json::from_str(settings).map_err(|e| bug(&e))?;
    let own: Vec<OwnModel> = serde_json::from_str(own).map_err(|e| bug(&e))?;
    let mut given = Vec::with_capacity(surfaces.len());
    for (heights, facts, name) in &surfaces {
        given.push(Surface { name: name.clone(), ..surface_of(heights, facts)?.0 });
    }
    let laid = LaidBody::of(against.as_ref())?;
    let mut registry = contact_compare::built_in().clone();
    let mut times = Times::new();
    for own in own {
        times.insert(own.name.clone(), own.seconds.clone());
        let theory = GivenTheory::of(own).map_err(|e| raise(&e))?;
        let refused = |e: StudyError| raise(&Failure::refused("model", e.to_string()));
        registry = registry.with(theory).map_err(refused)?;
    }
    let threads = settings.threads;
    let (value, stopped_by) = watched(py, threads, progress, move |reporter| {
        let mut told = (String::new(), 0);
        let mut listen = move |news: Progress<'_>| {
            if let Progress::Surface { name, loads, .. } = news {
                told = (name.to_owned(), loads);
            }
            let of = |stage, index| {
                let (surface, count) = told.clone();
                News { stage, surface, index, count, ..News::default() }
            };
            match news {
                Progress::Surface { .. } => reporter.tell(of("surface", 0)),
                Progress::Models => reporter.tell(of("models", 0)),
                Progress::Iterated { index, now } => {
                    reporter.tell_at_times(|| News {
                        surface: told.0.clone(),
                        ..News::iteration(index, told.1, &now)
                    });
                }
                Progress::Solved { index, mean_pressure, area_fraction, .. } => {
                    let mean_pressure = Some(mean_pressure);
                    reporter.tell(News { mean_pressure, area_fraction, ..of("load", index) });
                }
                _ => {}
            }
            if reporter.is_stopped() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let given = match &laid {
            None => given,
            Some(laid) => {
                let on = |first: Surface| laid.clone().on(first, settings.level);
                given.into_iter().map(on).collect::<Result<_, _>>()?
            }
        };
        run(given, settings, &registry, &times, &mut listen)
    })?;
    let stopped_by = stopped_by.map(|e| e.into_value(py).into_any());
    match value {
        Some(Ok((files, trouble))) if stopped_by.is_none() => {
            let trouble = trouble.map(|t| (t.kind, t.message));
            Ok((files, trouble, None))
        }
        Some(Err(failure)) if stopped_by.is_none() => Err(raise(&failure)),
        _ => Ok((BTreeMap::new(), None, stopped_by)),
    }
}

/// Seconds for a load, by model and surface.
type Times = BTreeMap<String, BTreeMap<String, f64>>;

fn run(
    surfaces: Vec<Surface>,
    settings: Settings,
    registry: &Registry,
    times: &Times,
    listen: &mut contact_compare::Listener<'_>,
) -> Result<(BTreeMap<String, String>, Option<Failure>), Failure> {
    let failed = |e: StudyError| Failure::from(&e);
    let run_file = RunFile::of(&settings, surfaces.iter().map(|s| (&s.name, &s.origin)));
    let mut found = Comparison::run(surfaces, settings, registry, listen).map_err(failed)?;
    contact_front_end::look_around(&mut found, listen)?;
    for surface in &mut found.surfaces {
        for model in &mut surface.models {
            let seconds = times.get(model.card.name.as_ref()).and_then(|t| t.get(&surface.name));
            if let (Ok(curve), Some(seconds)) = (&mut model.outcome, seconds) {
                // What was timed is a look into a table; the model itself took this.
                curve.seconds = *seconds;
            }
        }
    }
    let documents = contact_front_end::documents(&found, &Provenance::here(REPEAT), &run_file)?;
    let documents = documents.into_iter().map(|(name, text)| (name.to_owned(), text)).collect();
    Ok((documents, contact_front_end::not_met(&found)))
}

/// The command that repeats a study from the file beside its report.
pub(crate) const REPEAT: &str = "rough-contact compare --from run.toml --out again";
