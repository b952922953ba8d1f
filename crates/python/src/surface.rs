//! Surfaces: arrays with what is known of them.

use crate::failure::{bug, raise};
use crate::reading::{FileReading, Unread, filled};
use crate::watched::quietly;
use contact_compare::{Cleaning, GivenOrigin, Level, Origin, Placing, Recipe, Surface, Unevenness};
use contact_front_end::{Failure, Subject, pressed};
use contact_types::{Grid, HeightMap, Named};
use numpy::ndarray::{Array2, ArrayView2};
use numpy::{Element, PyArray2, PyArrayMethods, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use serde::{Deserialize, Serialize};
use serde_json::json;
use std::io::Cursor;
use std::path::Path;
use surface_io::{Measurement, write};
use surface_stats::Edges;
use surface_stats::clean::Record;

/// What is known of heights, beside them. Python keeps it as text and gives it back; TOML, because it has infinities.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(crate) struct HeightFacts {
    pub(crate) name: String,
    pub(crate) pixel: [f64; 2],
    pub(crate) fill: String,
    pub(crate) height_step: Option<f64>,
    pub(crate) origin: Origin,
    #[serde(default)]
    pub(crate) cleaned: Vec<Record>,
    /// Of traces.
    pub(crate) uneven: Option<Unevenness>,
}

impl HeightFacts {
    /// Of heights that were read or made.
    pub(crate) fn of(name: String, pixel: [f64; 2], origin: Origin) -> Self {
        let (height_step, cleaned) = (origin.height_step(), origin.cleaned().to_vec());
        let fill = if let Origin::File(file) = &origin { &file.fill } else { "refuse" };
        let fill = fill.to_owned();
        Self { name, pixel, fill, height_step, origin, cleaned, uneven: None }
    }

    pub(crate) fn of_text(text: &str) -> PyResult<Self> {
        let mut facts: Self = toml::from_str(text).map_err(|e| bug(&e))?;
        if let Origin::File(file) = &mut facts.origin {
            // A run file does without these; a surface knows them.
            file.cleaned.clone_from(&facts.cleaned);
            file.height_step = facts.height_step;
        }
        Ok(facts)
    }

    pub(crate) fn text(&self) -> PyResult<String> {
        toml::to_string(self).map_err(|e| bug(&e))
    }

    /// What stands in front of a message: the file, if there is one.
    pub(crate) fn path(&self) -> &Path {
        match &self.origin {
            Origin::File(file) => Path::new(&file.path),
            _ => Path::new(&self.name),
        }
    }
}

/// Heights (m) as if measured.
pub(crate) fn measurement(
    rows: ArrayView2<'_, f64>,
    pixel: [f64; 2],
) -> Result<Measurement, Failure> {
    let grid = Grid::new([rows.nrows(), rows.ncols()], pixel).map_err(|e| Failure::from(&e))?;
    Measurement::new(grid, rows.iter().copied().collect()).map_err(|e| Failure::from(&e))
}

/// A surface of the study.
pub(crate) fn surface_of(
    heights: &PyReadonlyArray2<'_, f64>,
    facts: &str,
) -> PyResult<(Surface, HeightFacts)> {
    let facts = HeightFacts::of_text(facts)?;
    let array = heights.as_array();
    let refused = |e| raise(&Failure::from(&e));
    let grid = Grid::new([array.nrows(), array.ncols()], facts.pixel).map_err(refused)?;
    let heights = HeightMap::new(grid, array.iter().copied().collect()).map_err(refused)?;
    let surface = Surface { name: facts.name.clone(), origin: facts.origin.clone(), heights };
    Ok((surface, facts))
}

/// A second body: heights, facts, and where it lies on the first, as JSON.
pub(crate) type Second<'py> = (PyReadonlyArray2<'py, f64>, String, String);

/// A second body that is to be laid on another.
#[derive(Clone)]
pub(crate) struct LaidBody {
    second: Surface,
    placing: Placing,
}

impl LaidBody {
    pub(crate) fn of(against: Option<&Second<'_>>) -> PyResult<Option<Self>> {
        let Some((heights, facts, placing)) = against else { return Ok(None) };
        let placing = serde_json::from_str(placing).map_err(|e| bug(&e))?;
        let (second, _) = surface_of(heights, facts)?;
        Ok(Some(Self { second, placing }))
    }

    /// The first with the second on it. Not on a thread of Python: it computes.
    pub(crate) fn on(self, first: Surface, level: Level) -> Result<Surface, Failure> {
        pressed(first, self.second, &self.placing, level)
    }
}

/// The surface, with the second body on it if there is one, as it is asked about.
pub(crate) fn subject(
    surface: Surface,
    facts: &HeightFacts,
    laid: Option<LaidBody>,
    level: Level,
) -> Result<Subject<'_>, Failure> {
    let (surface, cleaned) = match laid {
        Some(laid) => (laid.on(surface, level)?, Vec::new()),
        None => (surface, facts.cleaned.clone()),
    };
    Ok(Subject { path: facts.path(), surface, cleaned, fill: &facts.fill })
}

pub(crate) fn form(name: &str) -> PyResult<Level> {
    let unknown = || bug(&format!("level = {name:?} is no form"));
    Level::of_name(name).ok_or_else(unknown)
}

pub(crate) fn array<T: Element>(
    py: Python<'_>,
    shape: [usize; 2],
    values: Vec<T>,
) -> PyResult<Bound<'_, PyArray2<T>>> {
    let array = Array2::from_shape_vec(shape, values).map_err(|e| bug(&e))?;
    let array = PyArray2::from_owned_array(py, array);
    array.clone().try_readwrite().map_err(|e| bug(&e))?.make_nonwriteable();
    Ok(array)
}

/// Heights, what is known of them, and what Python shows of that.
type MadeSurface<'py> = (Bound<'py, PyArray2<f64>>, String, String);

fn made<'py>(
    py: Python<'py>,
    map: HeightMap,
    facts: &HeightFacts,
    said: &serde_json::Value,
) -> PyResult<MadeSurface<'py>> {
    let shape = map.grid().shape();
    let mut shown = json!({
        "name": facts.name, "pixel": facts.pixel, "missing": facts.origin.missing(),
        "fill": facts.fill, "height_step": facts.height_step, "cleaning": contact_report::cleaning_json(&facts.cleaned),
    });
    if let (Some(shown), Some(said)) = (shown.as_object_mut(), said.as_object()) {
        shown.extend(said.clone());
    }
    Ok((array(py, shape, map.into_heights())?, facts.text()?, shown.to_string()))
}

/// Reads a file: crop, cleaning, fill, in this order.
#[pyfunction]
#[pyo3(signature = (path, request, threads, content=None))]
pub(crate) fn read<'py>(
    py: Python<'py>,
    path: &str,
    request: &str,
    threads: usize,
    content: Option<Vec<u8>>,
) -> PyResult<MadeSurface<'py>> {
    let mut how = FileReading::of(path, request, content)?;
    let found = quietly(py, threads, move || {
        let measurement = how.measurement()?;
        let path = &how.file.path;
        let said = contact_front_end::info(&measurement);
        if measurement.is_profile() {
            let message = format!(
                "{path}: this is a profile, and a surface has no deterministic answer from one line of it; \
                 read it with rc.read_profile"
            );
            return Err(Unread::Other(Failure::refused("profile", message)));
        }
        Ok((filled(Path::new(path), measurement, &how)?, said, how.file.sha256))
    })?;
    let (Surface { name, origin, heights }, said, hash) =
        found.map_err(|e| e.raise(Path::new(path)))?;
    let facts = HeightFacts::of(name, heights.grid().pixel(), origin);
    let said = json!({
        "format": said["format"], "channel": said["channel"], "channels": said["channels"],
        "metadata": said["metadata"], "ambiguity": said["ambiguity"], "sha256": hash,
    });
    made(py, heights, &facts, &said)
}

/// What a file holds, as `rough-contact info` says it.
#[pyfunction]
#[pyo3(signature = (path, request, content=None))]
pub(crate) fn info(
    py: Python<'_>,
    path: &str,
    request: &str,
    content: Option<Vec<u8>>,
) -> PyResult<String> {
    let mut how = FileReading::of(path, request, content)?;
    let found =
        quietly(py, 1, move || how.measurement().map(|m| contact_front_end::info(&m).to_string()))?;
    found.map_err(|e| e.raise(Path::new(path)))
}

/// Heights of an array (m), NaN where a point is missing.
#[pyfunction]
pub(crate) fn given<'py>(
    py: Python<'py>,
    heights: PyReadonlyArray2<'py, f64>,
    request: &str,
    threads: usize,
) -> PyResult<MadeSurface<'py>> {
    #[derive(Deserialize)]
    struct GivenHeights {
        name: String,
        note: String,
        pixel: [f64; 2],
        fill: String,
        repeats: Option<bool>,
        cleaning: Cleaning,
        before: Option<String>, // what is known of the surface whose heights they were
    }
    let given: GivenHeights = serde_json::from_str(request).map_err(|e| bug(&e))?;
    let measurement = measurement(heights.as_array(), given.pixel).map_err(|e| raise(&e))?;
    let mut how = FileReading { is_array: true, ..FileReading::default() };
    (how.file.fill, how.file.cleaning) = (given.fill.clone(), given.cleaning);
    let name = given.name.clone();
    let found = quietly(py, threads, move || filled(Path::new(&name), measurement, &how))?;
    let Surface { origin: made_of, heights: map, .. } = found.map_err(|e| raise(&e))?;
    let mut origin = GivenOrigin::of(&map, given.note);
    origin.repeats = given.repeats;
    (origin.missing, origin.height_step) = (made_of.missing(), made_of.height_step());
    let (mut fill, mut cleaned) = (given.fill, made_of.cleaned().to_vec());
    if let Some(before) = given.before.as_deref().map(HeightFacts::of_text).transpose()? {
        fill = if origin.missing == 0 { before.fill } else { fill };
        origin.missing += before.origin.missing();
        cleaned.splice(..0, before.cleaned);
    }
    let facts = HeightFacts::of(given.name, given.pixel, Origin::Given(origin));
    made(py, map, &HeightFacts { fill, cleaned, ..facts }, &json!({}))
}

/// A random self-affine surface.
#[pyfunction]
pub(crate) fn synth<'py>(
    py: Python<'py>,
    recipe: &str,
    threads: usize,
) -> PyResult<MadeSurface<'py>> {
    let recipe: Recipe = serde_json::from_str(recipe).map_err(|e| bug(&e))?;
    let surface = quietly(py, threads, move || recipe.make())?;
    let Surface { name, origin, heights } = surface.map_err(|e| raise(&Failure::from(&e)))?;
    let facts = HeightFacts::of(name, heights.grid().pixel(), origin);
    made(py, heights, &facts, &json!({}))
}

/// The surface with a form taken off: heights of another origin.
#[pyfunction]
pub(crate) fn reshape<'py>(
    py: Python<'py>,
    heights: PyReadonlyArray2<'py, f64>,
    facts: &str,
    level: &str,
    threads: usize,
) -> PyResult<MadeSurface<'py>> {
    let (surface, mut facts) = surface_of(&heights, facts)?;
    let form = surface.origin.level(form(level)?);
    let repeats = match &surface.origin {
        Origin::Given(given) => given.repeats,
        made => (made.edges() == Edges::Periodic).then_some(true),
    };
    let levelled = quietly(py, threads, move || form.taken_off(surface.heights))?;
    let (form, map) = levelled.map_err(|e| raise(&Failure::in_file(facts.path(), &e)))?;
    let note = format!("{} with its {} taken off", facts.name, form.name());
    let mut origin = GivenOrigin::of(&map, note);
    (origin.missing, origin.height_step, origin.repeats) =
        (facts.origin.missing(), facts.height_step, repeats);
    facts.origin = Origin::Given(origin);
    made(py, map, &facts, &json!({}))
}

/// The bytes of a file of this format.
#[pyfunction]
pub(crate) fn encode<'py>(
    py: Python<'py>,
    heights: PyReadonlyArray2<'py, f64>,
    facts: &str,
    format: &str,
    comment: &str,
) -> PyResult<Bound<'py, PyBytes>> {
    let (surface, _) = surface_of(&heights, facts)?;
    let map = &surface.heights;
    let mut out = Cursor::new(Vec::new());
    match format {
        "npy" => write::npy(&mut out, map.grid().shape(), map.heights()),
        "x3p" => write::x3p(&mut out, map, comment),
        "sdf" => write::sdf(&mut out, map),
        "txt" => write::text(&mut out, map),
        "vti" => write::vti(&mut out, map.grid(), &[("height", map.heights())]),
        other => {
            let message =
                format!("the ending {other:?} is no format that is written; use .x3p, .npy, .sdf, .txt or .vti");
            return Err(raise(&Failure::refused("setting", message)));
        }
    }
    .map_err(|e| raise(&Failure::refused("setting", e.to_string())))?;
    Ok(PyBytes::new(py, &out.into_inner()))
}
