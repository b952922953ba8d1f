//! Many studies on one page.

use crate::failure::bug;
use contact_compare::Settings;
use contact_report::{Provenance, Summary};
use pyo3::prelude::*;
use serde_json::Value;

/// What a page over many maps keeps of a surface of `results.json`; both as JSON.
#[pyfunction]
pub(crate) fn digest(surface: &str) -> PyResult<String> {
    let surface: Value = serde_json::from_str(surface).map_err(|e| bug(&e))?;
    Ok(contact_report::digest(&surface).to_string())
}

/// The page over many maps: names and digests, names and reasons of those without an answer, what was asked, as JSON, and
/// the time of all of it (s).
#[pyfunction]
#[allow(clippy::needless_pass_by_value, reason = "what Python hands over is owned")]
pub(crate) fn summary(
    maps: Vec<(String, String)>,
    failed: Vec<(String, String)>,
    settings: &str,
    seconds: f64,
) -> PyResult<String> {
    let settings: Settings = serde_json::from_str(settings).map_err(|e| bug(&e))?;
    let digests = maps.iter().map(|(_, digest)| serde_json::from_str(digest));
    let digests: Vec<Value> = digests.collect::<Result<_, _>>().map_err(|e| bug(&e))?;
    let maps = maps.into_iter().zip(&digests).map(|((name, _), digest)| (name, digest)).collect();
    let summary = Summary { maps, failed, settings: &settings, seconds };
    let made = Provenance::here("rough_contact.summary in Python");
    Ok(contact_report::summary_html(&summary, &made))
}
