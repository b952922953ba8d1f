//! Profiles: traces of a stylus.

use crate::failure::bug;
use crate::surface::{Reading, Unread, array, rule, unmade};
use crate::watched::quietly;
use answers::{Failure, Traces};
use compare::Level;
use numpy::PyArray2;
use pyo3::prelude::*;
use std::path::Path;
use surface_stats::clean::Form;

/// Traces (m), one in each row; their spacing (m); the format; what `rough-contact stats` answers, as JSON.
type Profile<'py> = (Bound<'py, PyArray2<f64>>, f64, String, String);

/// Reads the traces of a file and takes their statistics.
#[pyfunction]
pub(crate) fn profile<'py>(
    py: Python<'py>,
    path: &str,
    request: &str,
    level: &str,
    threads: usize,
) -> PyResult<Profile<'py>> {
    let how: Reading = serde_json::from_str(request).map_err(|e| bug(&e))?;
    let unknown = || bug(&format!("level = {level:?} is no form"));
    let level = Level::ALL.iter().find(|l| l.name() == level).copied().ok_or_else(unknown)?;
    let at = Path::new(path);
    let file = path.to_owned();
    let found = quietly(py, threads, move || traces(Path::new(&file), &how, level))?;
    let (traces, json) = found.map_err(|e| e.raise(at))?;
    let (count, points) = (traces.each.len(), traces.each.first().map_or(0, |t| t.len()));
    let spacing = traces.each.first().map_or(0.0, |t| t.spacing());
    let heights = traces.each.iter().flat_map(|t| t.heights().iter().copied()).collect();
    Ok((array(py, [count, points], heights)?, spacing, traces.format, json))
}

fn traces(path: &Path, how: &Reading, level: Level) -> Result<(Traces, String), Unread> {
    let measurements = how.measurements(path)?;
    if measurements.first().is_some_and(|m| !m.is_profile()) {
        let message = format!("{}: this is a map; read it with rc.read", path.display());
        return Err(Unread::Other(Failure::refused("profile", message)));
    }
    let refused = |message: &str| {
        Err(Unread::Other(Failure::refused("profile", format!("{}: {message}", path.display()))))
    };
    if how.cleaning.align_rows {
        return refused(
            "align_rows puts the rows of a map in line, and this is a profile; leave it out",
        );
    }
    if let Some(Form::Sphere | Form::Cylinder) = how.cleaning.form {
        return refused(
            "sphere and cylinder are forms of maps, and this is a profile; give form='polynomial:2', or another degree",
        );
    }
    let traces =
        Traces::of(measurements, how.cleaning, rule(&how.fill)?).map_err(|e| unmade(path, &e))?;
    let statistics = traces.statistics(level.degree().unwrap_or(0));
    let (_, json) = statistics.map_err(|e| Failure::in_file(path, &e))?;
    Ok((traces, json.to_string()))
}
