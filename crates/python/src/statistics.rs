//! Roughness statistics.

use crate::failure::{bug, raise};
use crate::surface::{LaidBody, Second, form, subject, surface_of};
use crate::watched::quietly;
use contact_front_end::{Failure, StatisticsRequest};
use numpy::{PyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use surface_stats::StatsError;
use surface_stats::spectrum::{PowerSpectrum, Ring};

/// What `rough-contact stats` answers, as JSON.
#[pyfunction]
#[pyo3(signature = (heights, facts, request, threads, against=None))]
pub(crate) fn statistics(
    py: Python<'_>,
    heights: PyReadonlyArray2<'_, f64>,
    facts: &str,
    request: &str,
    threads: usize,
    against: Option<Second<'_>>,
) -> PyResult<String> {
    let request: StatisticsRequest = serde_json::from_str(request).map_err(|e| bug(&e))?;
    let (surface, facts) = surface_of(&heights, facts)?;
    let laid = LaidBody::of(against.as_ref())?;
    let found = quietly(py, threads, move || {
        let subject = subject(surface, &facts, laid, request.level)?;
        contact_front_end::statistics(&subject, &request).map(|found| found.json.to_string())
    })?;
    found.map_err(|e| raise(&e))
}

/// Wavenumbers (rad/m) and isotropic power spectrum (m⁴) of the levelled map, as it repeats or under a Hann window.
#[pyfunction]
pub(crate) fn psd<'py>(
    py: Python<'py>,
    heights: PyReadonlyArray2<'py, f64>,
    facts: &str,
    level: &str,
    threads: usize,
) -> PyResult<[Bound<'py, PyArray1<f64>>; 2]> {
    let (surface, facts) = surface_of(&heights, facts)?;
    let form = form(level)?;
    let rings = quietly(py, threads, move || {
        let (_, levelled) = surface.origin.level(form).taken_off(surface.heights)?;
        Ok::<_, StatsError>(PowerSpectrum::of(&levelled, surface.origin.edges())?.rings())
    })?;
    let rings = rings.map_err(|e| raise(&Failure::in_file(facts.path(), &e)))?;
    let of = |one: fn(&Ring) -> f64| PyArray1::from_vec(py, rings.iter().map(one).collect());
    Ok([of(|r| r.wavenumber), of(|r| r.psd)])
}
