//! The deterministic solution.

use crate::failure::{bug, raise};
use crate::surface::{LaidBody, Second, array, subject, surface_of};
use crate::watched::{News, Reporter, quietly, watched};
use contact_accuracy::Ladder;
use contact_compare::AccuracyRequest as Accuracy;
use contact_compare::{Iteration, Load, Solution, contact_spots};
use contact_front_end::loads::Spread;
use contact_front_end::{Failure, SolveRequest, Watch};
use contact_types::{ContactModulus, Grid};
use fft_bem_solver::{Boundary, HalfSpace};
use numpy::{PyArray2, PyReadonlyArray2};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::sync::{Arc, Mutex, PoisonError};

/// What to look at where a load over an area is no pressure.
const CHECK: &str = "check the units of load and area";

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SolveArguments {
    request: SolveRequest,
    /// `pressure`, `gap` or `load`, with its values.
    loads: (String, Vec<f64>),
    area: Option<f64>,
    accuracy: Option<String>,
    /// Whether the pressure is kept, and the gap if it is asked for.
    maps: bool,
}

impl SolveArguments {
    /// The request with its loads, forces over this area of the map where no other is given (m²).
    fn question(self, of_map: f64) -> Result<SolveRequest, Failure> {
        let accuracy = self.accuracy.as_deref().map(Accuracy::parse).transpose();
        let accuracy = accuracy.map_err(|e| Failure::refused("setting", e.to_string()))?;
        let (kind, values) = &self.loads;
        let spread = (kind == "load").then(|| Spread::of(values, self.area, of_map, CHECK));
        let spread = spread.transpose()?;
        let values = spread.as_ref().map_or(values, |spread| &spread.pressures);
        let load: fn(f64) -> Load = if kind == "gap" { Load::MeanGap } else { Load::MeanPressure };
        let mut request = self.request;
        request.loads = values.iter().copied().map(load).collect();
        request.settings.accuracy = accuracy.map(Accuracy::relative);
        Ok(SolveRequest { spread, ..request })
    }
}

type Kept = (Grid, Vec<f64>, Vec<f64>);

/// Keeps the maps that are wanted, and tells.
struct KeptMaps<'a> {
    maps: bool,
    keep_gap: bool,
    count: usize,
    reporter: &'a Reporter,
    /// By the place of each load that is done grid, pressure and gap, if they are kept.
    found: BTreeMap<usize, Option<Kept>>,
    name: &'a str,
    last: Option<(f64, f64)>,
}

impl Watch for KeptMaps<'_> {
    fn begin(&mut self, _: Grid, _: usize) {
        self.found.clear();
    }

    fn iterated(&mut self, index: usize, _: Load, now: &Iteration<'_>) -> ControlFlow<()> {
        self.reporter.tell_at_times(|| News {
            surface: self.name.to_owned(),
            ..News::iteration(index, self.count, now)
        });
        if self.reporter.is_stopped() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    fn keep(&mut self, index: usize, grid: Grid, solution: &mut Solution) -> Result<(), Failure> {
        self.last = Some((solution.state.mean_pressure, solution.state.area_fraction));
        if self.maps {
            let gap = if self.keep_gap { solution.open_gap() } else { Vec::new() };
            let pressure = std::mem::take(&mut solution.pressure);
            self.found.insert(index, Some((grid, pressure, gap)));
        }
        Ok(())
    }

    fn done(&mut self, index: usize, _: Load) {
        self.found.entry(index).or_default();
        let last = self.last.take();
        self.reporter.tell(News {
            stage: "load",
            surface: self.name.to_owned(),
            index,
            count: self.count,
            mean_pressure: last.map(|l| l.0),
            area_fraction: last.map(|l| l.1),
            ..News::default()
        });
    }
}

type MapArray<'py> = Option<Bound<'py, PyArray2<f64>>>;

/// JSON of the answer; pressure and gap by the place among its points, if they were kept; what went wrong, as kind and
/// message; the exception that stopped it.
type SolveAnswer<'py> = (
    String,
    Vec<(usize, MapArray<'py>, MapArray<'py>)>,
    Option<(String, String)>,
    Option<Py<PyAny>>,
);

/// A solver that keeps its last solution, for the next call on the same grid. Private.
#[pyclass(frozen)]
#[derive(Default)]
pub(crate) struct Keep(Arc<Mutex<Option<Ladder>>>);

#[pymethods]
impl Keep {
    #[new]
    fn new() -> Self {
        Self::default()
    }

    /// Whether there is a solution to start from.
    fn is_warm(&self) -> bool {
        self.0.try_lock().is_ok_and(|kept| kept.is_some())
    }

    /// Lets the last solution go.
    fn forget(&self) -> PyResult<()> {
        *self.0.try_lock().map_err(|_| busy())? = None;
        Ok(())
    }
}

fn busy() -> PyErr {
    PyRuntimeError::new_err("this Solver is at work on another thread; make one for each")
}

/// Elastic displacement (m), positive into the body, of a pressure (Pa) that repeats or, if `free`, is alone.
#[pyfunction]
pub(crate) fn displacement<'py>(
    py: Python<'py>,
    pressure: PyReadonlyArray2<'py, f64>,
    pixel: [f64; 2],
    modulus: f64,
    free: bool,
    threads: usize,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let (grid, mut field) = field(&pressure, pixel)?;
    let modulus = ContactModulus::from_pascals(modulus).map_err(|e| raise(&(&e).into()))?;
    let found = quietly(py, threads, move || {
        let boundary = if free { Boundary::Free } else { Boundary::Periodic };
        HalfSpace::new(grid, modulus, boundary).displace(&mut field);
        field
    })?;
    array(py, grid.shape(), found)
}

/// The number of the contact spot of each point of a pressure (Pa), from 1; 0 where nothing touches.
#[pyfunction]
pub(crate) fn spots<'py>(
    py: Python<'py>,
    pressure: PyReadonlyArray2<'py, f64>,
    pixel: [f64; 2],
    repeats: bool,
) -> PyResult<Bound<'py, PyArray2<i32>>> {
    let (grid, field) = field(&pressure, pixel)?;
    let (_, labels) = quietly(py, 1, move || contact_spots(&field, grid, repeats))?;
    array(py, grid.shape(), labels)
}

fn field(values: &PyReadonlyArray2<'_, f64>, pixel: [f64; 2]) -> PyResult<(Grid, Vec<f64>)> {
    let values = values.as_array();
    let grid = Grid::new([values.nrows(), values.ncols()], pixel).map_err(|e| raise(&(&e).into()));
    Ok((grid?, values.iter().copied().collect()))
}

/// What `rough-contact solve` answers.
#[pyfunction]
#[pyo3(signature = (heights, facts, request, progress=None, against=None, keep=None))]
pub(crate) fn solve<'py>(
    py: Python<'py>,
    heights: PyReadonlyArray2<'py, f64>,
    facts: &str,
    request: &str,
    progress: Option<Py<PyAny>>,
    against: Option<Second<'py>>,
    keep: Option<Py<Keep>>,
) -> PyResult<SolveAnswer<'py>> {
    let request: SolveArguments = serde_json::from_str(request).map_err(|e| bug(&e))?;
    let (surface, facts) = surface_of(&heights, facts)?;
    if request.request.plane_strain && surface.heights.grid().shape()[0] > 1 {
        let why = "several traces are several solutions; choose one with channel=";
        return Err(raise(&Failure::refused("profile", format!("{}: {why}", surface.name))));
    }
    // Of a pair the area of their common part, which is known when they lie on each other.
    let laid = LaidBody::of(against.as_ref())?;
    let kept = keep.map(|keep| Arc::clone(&keep.get().0));
    if kept.as_ref().is_some_and(|kept| kept.try_lock().is_err()) {
        return Err(busy());
    }
    let (value, stopped_by) =
        watched(py, request.request.settings.threads, progress, move |reporter| {
            let (maps, level) = (request.maps, request.request.settings.level);
            let subject = subject(surface, &facts, laid, level)?;
            let question = request.question(subject.surface.heights.grid().area())?;
            let mut watch = KeptMaps {
                maps,
                keep_gap: question.keep_gap,
                count: question.loads.len(),
                reporter,
                found: BTreeMap::new(),
                name: &facts.name,
                last: None,
            };
            let answer = match &kept {
                None => question.solve(subject, &mut None, &mut watch),
                Some(kept) => {
                    let mut kept = kept.lock().unwrap_or_else(PoisonError::into_inner);
                    question.solve(subject, &mut kept, &mut watch)
                }
            };
            answer.map(|answer| (answer, watch.found))
        })?;
    let stopped_by = stopped_by.map(|e| e.into_value(py).into_any());
    let Some(value) = value else { return Ok((String::new(), Vec::new(), None, stopped_by)) };
    let (answer, found) = value.map_err(|e| raise(&e))?;
    let mut maps = Vec::with_capacity(found.len());
    for (index, kept) in found.into_values().enumerate() {
        let Some((grid, pressure, gap)) = kept else { continue };
        let of = |values: Vec<f64>| -> PyResult<MapArray<'py>> {
            (values.len() == grid.len()).then(|| array(py, grid.shape(), values)).transpose()
        };
        maps.push((index, of(pressure)?, of(gap)?));
    }
    let trouble = answer.trouble.map(|t| (t.kind, t.message));
    Ok((answer.json.to_string(), maps, trouble, stopped_by))
}
