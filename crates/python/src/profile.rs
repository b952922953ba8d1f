//! Profiles: traces of a stylus, their statistics and what closed forms say of them.

use crate::failure::{bug, raise};
use crate::model::{ModelAnswer, ModelArguments};
use crate::reading::{FileReading, Unread, unmade};
use crate::study::REPEAT;
use crate::surface::{HeightFacts, array, form, measurement};
use crate::watched::quietly;
use contact_compare::{
    Level, Origin, ProfileComparison, ProfileSurface, RunFile, Settings, built_in,
};
use contact_front_end::Failure;
use contact_front_end::model::ModelSubject;
use contact_report::Provenance;
use numpy::ndarray::Axis;
use numpy::{PyArray2, PyReadonlyArray2};
use pyo3::prelude::*;
use std::collections::BTreeMap;
use std::path::Path;
use surface_io::Measurement;
use surface_stats::profile::Trace;

/// Traces (m), one in each row; their spacing (m); the format; what is known of them; what `rough-contact stats` answers, as
/// JSON.
type Profile<'py> = (Bound<'py, PyArray2<f64>>, f64, String, String, String);

/// Reads the traces of a file, or takes `rows` (m) at the distance of `pixel`, and takes their statistics.
#[pyfunction]
#[pyo3(signature = (path, request, level, threads, content=None, rows=None))]
pub(crate) fn profile<'py>(
    py: Python<'py>,
    path: &str,
    request: &str,
    level: &str,
    threads: usize,
    content: Option<Vec<u8>>,
    rows: Option<PyReadonlyArray2<'py, f64>>,
) -> PyResult<Profile<'py>> {
    let how = FileReading { is_array: rows.is_some(), ..FileReading::of(path, request, content)? };
    let given = rows.as_ref().map(|rows| -> Result<Vec<_>, Failure> {
        let pixel = how.file.pixel.unwrap_or_default();
        rows.as_array().axis_chunks_iter(Axis(0), 1).map(|row| measurement(row, pixel)).collect()
    });
    let given = given.transpose().map_err(|e| raise(&e))?;
    let level = form(level)?;
    let found = quietly(py, threads, move || traces(how, level, given))?;
    let (traces, json) = found.map_err(|e| e.raise(Path::new(path)))?;
    let ProfileSurface { name, origin, traces, uneven } = traces;
    let (count, points) = (traces.len(), traces.first().map_or(0, |trace| trace.heights().len()));
    let spacing = traces.first().map_or(0.0, Trace::spacing);
    let heights = traces.iter().flat_map(|t| t.heights().iter().copied()).collect();
    let format = if let Origin::File(file) = &origin { file.format.clone() } else { String::new() };
    let facts = HeightFacts { uneven, ..HeightFacts::of(name, [spacing; 2], origin) };
    Ok((array(py, [count, points], heights)?, spacing, format, facts.text()?, json))
}

fn traces(
    mut how: FileReading,
    level: Level,
    given: Option<Vec<Measurement>>,
) -> Result<(ProfileSurface, String), Unread> {
    let measurements = given.map_or_else(|| how.measurements(), Ok)?;
    let path = Path::new(&how.file.path);
    if measurements.first().is_some_and(|m| !m.is_profile()) {
        let why = format!("{}: this is a map; read it with rc.read", path.display());
        return Err(Unread::Other(Failure::refused("profile", why)));
    }
    let (_, fill) = contact_front_end::reading(&how.file)?;
    let traces = contact_front_end::traces(measurements, how.file.clone(), fill)
        .map_err(|e| unmade(path, &e, &how))?;
    let (_, json) = contact_front_end::profile_statistics(path, &traces, level)?;
    Ok((traces, json.to_string()))
}

/// Traces that Python has kept, with what is known of them.
fn kept(heights: &PyReadonlyArray2<'_, f64>, facts: &str) -> PyResult<ProfileSurface> {
    let HeightFacts { name, pixel, origin, uneven, .. } = HeightFacts::of_text(facts)?;
    let rows = heights.as_array();
    let traces = rows.rows().into_iter().map(|row| Trace::new(pixel[1], row.to_vec()));
    let traces = traces.collect::<Result<_, _>>().map_err(|e| raise(&Failure::from(&e)))?;
    Ok(ProfileSurface { name, origin, traces, uneven })
}

/// What `rough-contact model` answers of traces, as JSON, and the first refusal, as kind and message.
#[pyfunction]
pub(crate) fn profile_model(
    py: Python<'_>,
    request: &str,
    heights: PyReadonlyArray2<'_, f64>,
    facts: &str,
    threads: usize,
) -> PyResult<ModelAnswer> {
    let request: ModelArguments = serde_json::from_str(request).map_err(|e| bug(&e))?;
    let traces = kept(&heights, facts)?;
    let found = quietly(py, threads, move || -> Result<ModelAnswer, Failure> {
        let theory = request.theory()?;
        let card = theory.card();
        let path = match &traces.origin {
            Origin::File(file) => Path::new(&file.path),
            _ => Path::new(&traces.name),
        };
        let modulus = request.modulus(card)?;
        let mut subject = ModelSubject::of_traces(modulus, path, &traces, request.level)?;
        subject.inputs = request.complete(card, subject.inputs)?;
        request.ask(theory, subject)
    })?;
    found.map_err(|e| raise(&e))
}

/// What `rough-contact compare` answers of profiles: its files.
#[pyfunction]
pub(crate) fn profile_study(
    py: Python<'_>,
    profiles: Vec<(PyReadonlyArray2<'_, f64>, String, String)>,
    settings: &str,
) -> PyResult<BTreeMap<String, String>> {
    let settings: Settings = serde_json::from_str(settings).map_err(|e| bug(&e))?;
    let mut given = Vec::with_capacity(profiles.len());
    for (heights, facts, name) in &profiles {
        given.push(ProfileSurface { name: name.clone(), ..kept(heights, facts)? });
    }
    let threads = settings.threads;
    let found = quietly(py, threads, move || -> Result<_, Failure> {
        let run_file = RunFile::of(&settings, given.iter().map(|s| (&s.name, &s.origin)));
        let study = |s| ProfileComparison::run(s, settings.clone(), built_in());
        let studies = given.into_iter().map(study).collect::<Result<Vec<_>, _>>();
        let studies = studies.map_err(|e| Failure::from(&e))?;
        contact_front_end::profile_documents(&studies, &Provenance::here(REPEAT), &run_file)
    })?;
    found.map(BTreeMap::from_iter).map_err(|e| raise(&e))
}
