//! Roughness statistics.

use crate::failure::{bug, raise};
use crate::surface::{Laid, Second, surface_of};
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
#[pyo3(signature = (heights, facts, request, threads, against=None))]
pub(crate) fn statistics(
    py: Python<'_>,
    heights: PyReadonlyArray2<'_, f64>,
    facts: &str,
    request: &str,
    threads: usize,
    against: Option<Second<'_>>,
) -> PyResult<String> {
    let request: Request = serde_json::from_str(request).map_err(|e| bug(&e))?;
    let (surface, facts) = surface_of(&heights, facts)?;
    let edges = match request.boundary {
        Boundary::Open => Edges::Open,
        Boundary::Periodic => Edges::Periodic,
    };
    let laid = Laid::of(against.as_ref())?;
    let found = quietly(py, threads, move || {
        let surface = match laid {
            Some(laid) => laid.on(surface, request.level)?,
            None => surface,
        };
        let pair = surface.origin.pair();
        let (missing, height_step, cleaned) = match pair {
            Some(_) => (surface.origin.missing(), surface.origin.height_step(), &[][..]),
            None => (facts.missing, facts.height_step, &facts.cleaned[..]),
        };
        let options = StatsOptions::default()
            .with_level(request.level)
            .with_edges(edges)
            .with_missing(missing)
            .with_height_step(height_step);
        let from = Measured { path: facts.path(), cleaned, pair };
        answers::statistics(&surface.heights, &options, from, request.iso, request.scales)
            .map(|found| found.json.to_string())
    })?;
    found.map_err(|e| raise(&e))
}
