//! Roughness statistics.

use crate::failure::{bug, raise};
use crate::surface::surface_of;
use crate::watched::quietly;
use answers::Measured;
use compare::Level;
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;
use serde::Deserialize;
use surface_stats::{Edges, StatsOptions};

#[derive(Deserialize)]
struct Request {
    level: Level,
    boundary: Boundary,
    iso: bool,
    scales: bool,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Boundary {
    Open,
    Periodic,
}

/// What `rough-contact stats` answers, as JSON.
#[pyfunction]
pub(crate) fn statistics(
    py: Python<'_>,
    heights: PyReadonlyArray2<'_, f64>,
    facts: &str,
    request: &str,
    threads: usize,
) -> PyResult<String> {
    let request: Request = serde_json::from_str(request).map_err(|e| bug(&e))?;
    let (surface, facts) = surface_of(&heights, facts)?;
    let edges = match request.boundary {
        Boundary::Open => Edges::Open,
        Boundary::Periodic => Edges::Periodic,
    };
    let options = StatsOptions::default()
        .with_level(request.level)
        .with_edges(edges)
        .with_missing(facts.missing)
        .with_height_step(facts.height_step);
    let found = quietly(py, threads, move || {
        let from =
            Measured { path: facts.path(), cleaned: &facts.cleaned, pair: surface.origin.pair() };
        answers::statistics(&surface.heights, &options, from, request.iso, request.scales)
            .map(|found| found.json.to_string())
    })?;
    found.map_err(|e| raise(&e))
}
