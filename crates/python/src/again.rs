//! A run file, and the solver against exact solutions: what is repeated.

use crate::failure::{bug, raise};
use crate::reading::FileReading;
use crate::watched::quietly;
use contact_compare::{Method, Origin, RunFile};
use contact_front_end::Failure;
use fft_bem_solver::validation::{self, Options};
use pyo3::prelude::*;
use serde_json::{Value, json};
use std::path::Path;
use surface_io::Cut;

/// A run file as it stands in a folder.
#[pyfunction]
pub(crate) fn run_file_in(text: &str, folder: &str) -> PyResult<String> {
    // Of heights that a program handed over nothing is named, and nothing can be repeated.
    let Ok(run) = RunFile::parse(text) else { return Ok(text.to_owned()) };
    contact_front_end::run_file_in(run, Path::new(folder)).to_toml().map_err(|e| bug(&e))
}

/// A run file as JSON: settings, and surfaces that Python has to read or make again.
#[pyfunction]
pub(crate) fn run_file(text: &str) -> PyResult<String> {
    let run = RunFile::parse(text).map_err(|e| raise(&Failure::from(&e)))?;
    let again = |name: String, origin: Origin| match origin {
        Origin::File(mut file) => {
            let (path, hash) = (file.path.clone(), std::mem::take(&mut file.sha256));
            let crop = file.crop.map(|part| Cut::Rectangle(part).to_string());
            let reading = FileReading { file, crop, ..FileReading::default() };
            Ok(json!({ "name": name, "file": (path, hash, reading), "recipe": null }))
        }
        Origin::Recipe(recipe) => Ok(json!({ "name": name, "file": null, "recipe": recipe })),
        _ => {
            let message = format!(
                "{name} is of two bodies; give them to rc.compare with against=, or use `rough-contact compare --from`"
            );
            Err(raise(&Failure::refused("pair", message)))
        }
    };
    let surfaces = run.surfaces.into_iter().map(|s| again(s.name, s.origin));
    let surfaces = surfaces.collect::<PyResult<Vec<Value>>>()?;
    Ok(json!({ "settings": run.settings, "surfaces": surfaces }).to_string())
}

/// What `rough-contact validate` answers, as JSON.
#[pyfunction]
pub(crate) fn validate(py: Python<'_>, method: &str, finest: usize) -> PyResult<String> {
    let method: Method = serde_json::from_value(method.into()).map_err(|e| bug(&e))?;
    let options = Options { method, finest };
    let rows = quietly(py, 1, move || validation::run(&options, |_| {}))?;
    let rows = rows.map_err(|e| raise(&Failure::from(&e)))?;
    Ok(json!({ "rows": rows }).to_string())
}
