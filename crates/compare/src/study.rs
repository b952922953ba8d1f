//! The study itself: statistics, the deterministic curve, every model over the loads.

use crate::budget::Map;
use crate::curve::{Curve, ToCurve};
use crate::models::{BuildError, Inputs, MODELS, ModelEntry, MomentSource};
use crate::plan::{self, BadRequest, PlanError, Request, Task};
use crate::refine::refine;
use crate::result::{
    Comparison, DeterministicPoint, ModelComparison, ModelCurve, Spectral, SurfaceComparison,
};
use crate::settings::{LevelName, MethodName, PrecisionName};
use crate::survey::{Query, Survey, peak_slope};
use crate::verdict::verdict;
use crate::{Origin, Settings, Surface, contact_spots, default_pressures};
use contact_types::{
    ContactModel, ContactModulus, ContactState, HeightMap, ModelError, SurfaceError,
};
use fft_bem_solver::{Load, Maps, Method, Precision, Solver, SolverBuilder, SolverError};
use std::f64::consts::TAU;
use std::hint::black_box;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};
use surface_stats::spectrum::{Axis, PowerSpectrum, Ring, Window, amplitudes};
use surface_stats::{Boundary, Level, StatsError, StatsOptions, SurfaceStatistics, level};

/// What a study reports while it works.
#[derive(Debug, Clone, Copy)]
pub enum Progress<'a> {
    /// A surface begins: its place among `count`, and how many loads it will be asked at.
    Surface {
        /// Name.
        name: &'a str,
        /// From 0.
        index: usize,
        /// Surfaces in all.
        count: usize,
        /// Loads.
        loads: usize,
    },
    /// A load is solved.
    Solved {
        /// From 0, by rising pressure.
        index: usize,
        /// Nominal pressure (Pa).
        mean_pressure: f64,
        /// Area fraction, if there is an answer.
        area_fraction: Option<f64>,
    },
    /// The models are being asked.
    Models,
}

/// Why there is no study.
#[derive(Debug, Clone, thiserror::Error)]
#[non_exhaustive]
pub enum StudyError {
    /// No surface was given.
    #[error("a study needs at least one surface")]
    NoSurface,
    /// The modulus is no modulus.
    #[error(transparent)]
    Material(#[from] SurfaceError),
    /// A pressure that is no load.
    #[error(
        "nominal pressure {value:e} Pa cannot be applied: it must be finite and greater than 0"
    )]
    BadPressure {
        /// The value (Pa).
        value: f64,
    },
    /// The headline is not among the loads.
    #[error(
        "the headline pressure {value:e} Pa is not among the pressures of the study; add it to them"
    )]
    HeadlineNotComputed {
        /// The value (Pa).
        value: f64,
    },
    /// Statistics refuse the surface.
    #[error("{surface}: {source}")]
    Statistics {
        /// Its name.
        surface: String,
        /// Why.
        source: StatsError,
    },
    /// The solver refuses the settings.
    #[error("{surface}: {source}")]
    Solver {
        /// Name of the surface.
        surface: String,
        /// Why.
        source: Box<SolverError>,
    },
    /// The accuracy asked for is none.
    #[error(transparent)]
    Accuracy {
        /// Why.
        source: BadRequest,
    },
    /// The observer asked to stop.
    #[error("stopped")]
    Stopped,
}

impl Comparison {
    /// Runs a study. `progress` is told what happens and may stop it.
    ///
    /// # Errors
    /// [`StudyError`]. A load at which the solver does not converge and a model that does not
    /// apply are results, not errors.
    pub fn run(
        surfaces: Vec<Surface>,
        settings: Settings,
        progress: &mut dyn FnMut(Progress<'_>) -> ControlFlow<()>,
    ) -> Result<Self, StudyError> {
        let start = Instant::now();
        if surfaces.is_empty() {
            return Err(StudyError::NoSurface);
        }
        let modulus = ContactModulus::from_pascals(settings.modulus)?;
        check_pressures(&settings)?;
        let count = surfaces.len();
        let mut done = Vec::with_capacity(count);
        for (index, surface) in surfaces.into_iter().enumerate() {
            done.push(compare(surface, modulus, &settings, [index, count], progress)?);
        }
        Ok(Self { settings, surfaces: done, seconds: start.elapsed().as_secs_f64() })
    }
}

fn check_pressures(settings: &Settings) -> Result<(), StudyError> {
    let given = settings.pressures.iter().flatten().chain(&settings.headline);
    match given.copied().find(|p| !(p.is_finite() && *p > 0.0)) {
        Some(value) => Err(StudyError::BadPressure { value }),
        None if settings.pressures.as_ref().is_some_and(Vec::is_empty) => {
            Err(StudyError::BadPressure { value: 0.0 })
        }
        None => Ok(()),
    }
}

fn compare(
    surface: Surface,
    modulus: ContactModulus,
    settings: &Settings,
    [index, count]: [usize; 2],
    progress: &mut dyn FnMut(Progress<'_>) -> ControlFlow<()>,
) -> Result<SurfaceComparison, StudyError> {
    let Surface { name, origin, heights } = surface;
    let refused = |source| StudyError::Statistics { surface: name.clone(), source };
    let setup = Instant::now();
    let (map, statistics) = describe(&heights, &origin, settings).map_err(refused)?;
    let inputs = model_inputs(&map, &statistics, modulus).map_err(refused)?;
    let (spectral, known) = spectral(&map, &origin, &statistics).map_err(refused)?;
    let setup_seconds = setup.elapsed().as_secs_f64();

    let gradient = inputs.rms_gradient();
    let pressures = loads(settings, modulus, gradient);
    let mut tell = |p: Progress<'_>| match progress(p) {
        ControlFlow::Continue(()) => Ok(()),
        ControlFlow::Break(()) => Err(StudyError::Stopped),
    };
    tell(Progress::Surface { name: &name, index, count, loads: pressures.len() })?;

    let mut curve = Curve::new(known, settings.headline);
    let plan = match settings.accuracy {
        None => {
            let mut solver = builder(settings)
                .build(map.grid(), modulus)
                .map_err(|e| StudyError::Solver { surface: name.clone(), source: Box::new(e) })?;
            for (i, &p) in pressures.iter().enumerate() {
                curve.take(p, solver.solve(&map, Load::MeanPressure(p)));
                tell(curve.news(i))?;
            }
            None
        }
        Some(accuracy) => {
            let request =
                Request::new(accuracy).map_err(|source| StudyError::Accuracy { source })?;
            let task = Task {
                map: &map,
                height_step: statistics.height_step,
                modulus,
                pressures: &pressures,
                request,
                method: method(settings.method),
                certified: false,
                maps: Maps::Pressure,
                threads: settings.threads,
            };
            let mut sink = ToCurve {
                curve: &mut curve,
                given: map.grid(),
                pressures: &pressures,
                tell: &mut tell,
            };
            Some(plan::run(&task, &mut sink).map_err(|e| refused_plan(e, &name))?)
        }
    };
    let Curve { points: mut deterministic, headline, pressure, solved, .. } = curve;
    // A plan says itself what a finer grid would do.
    let refined_seconds = match plan {
        None => refine(&map, &known, modulus, settings, &mut deterministic, headline),
        Some(_) => 0.0,
    };
    if let Some(value) = settings.headline
        && !same(deterministic[headline].mean_pressure, value)
    {
        return Err(StudyError::HeadlineNotComputed { value });
    }

    let spots = contact_spots(&pressure, solved.as_ref().unwrap_or(&map).grid());
    tell(Progress::Models)?;
    let alike = likeness(&map, &statistics, &inputs, &spectral, &deterministic[headline]);
    let models = MODELS
        .iter()
        .filter(|m| m.in_study)
        .map(|entry| ask(entry, &inputs, &deterministic, &statistics, alike.as_ref()))
        .collect();
    Ok(SurfaceComparison {
        name,
        origin,
        surface: map,
        statistics,
        inputs,
        spectral,
        setup_seconds,
        deterministic,
        map: known,
        refined_seconds,
        coarser: Vec::new(),
        closer: None,
        plan,
        solved,
        headline,
        pressure,
        spots,
        models,
    })
}

/// Removes the form and takes the statistics. A map made from a recipe repeats; a measured one
/// does not.
fn describe(
    heights: &HeightMap,
    origin: &Origin,
    settings: &Settings,
) -> Result<(HeightMap, SurfaceStatistics), StatsError> {
    let form = form(settings.level);
    let (boundary, missing, height_step) = match origin {
        Origin::Recipe(_) => (Boundary::Periodic, 0, None),
        Origin::File(file) => (Boundary::Open, file.missing, file.height_step),
    };
    let fractal_range = settings.fractal_range;
    let options = StatsOptions { level: form, boundary, fractal_range, missing, height_step };
    // From the heights as given, so that a tilt that is removed is still reported.
    let statistics = SurfaceStatistics::of(heights, &options)?;
    Ok((level(heights, form)?, statistics))
}

/// One set of moments for all models, by finite differences: they stay inside the map, so that a
/// map that does not repeat brings no jump at its edges, and they see less of the noise near two
/// points than the spectrum does.
fn model_inputs(
    map: &HeightMap,
    statistics: &SurfaceStatistics,
    modulus: ContactModulus,
) -> Result<Inputs, StatsError> {
    Ok(Inputs {
        moments: Some(statistics.moments()).filter(|m| m.m2 > 0.0 && m.m4 > 0.0),
        source: MomentSource::FiniteDifferences,
        amplitudes: Some(amplitudes(map, Axis::X)?),
        fractal: statistics.fractal(),
        dimension: statistics.dimension,
        nominal_area: Some(map.grid().area()),
        ..Inputs::new(modulus)
    })
}

/// Moments and radial PSD by the spectrum: of the map as it repeats if it does, under a Hann
/// window otherwise, or the jump at the edges would count as roughness.
fn spectral(
    map: &HeightMap,
    origin: &Origin,
    statistics: &SurfaceStatistics,
) -> Result<(Spectral, Map), StatsError> {
    let window = match origin {
        Origin::Recipe(_) => Window::None,
        Origin::File(_) => Window::Hann,
    };
    let power = PowerSpectrum::of(map, window)?;
    let repeats = window == Window::None || plan::repeats(map);
    let known = Map::known(map, &power, statistics.height_step.unwrap_or(0.0), repeats);
    let spectral = Spectral {
        moments: power.moments().0,
        resolved: power.resolved_gradient().unwrap_or(1.0),
        windowed: window != Window::None,
        psd: thinned(&power.rings()),
    };
    Ok((spectral, known))
}

/// The PSD in about 12 bins per octave of wavenumber, `[wavelength, C]`: what a figure can show.
fn thinned(rings: &[Ring]) -> Vec<[f64; 2]> {
    let mut bins: Vec<(i64, f64, f64, f64)> = Vec::new(); // bin, waves, sum C, sum ln q
    for ring in rings.iter().filter(|r| r.wavenumber > 0.0) {
        let bin = (12.0 * ring.wavenumber.log2()).floor() as i64;
        let waves = ring.waves as f64;
        let (c, q) = (waves * ring.psd, waves * ring.wavenumber.ln());
        match bins.last_mut() {
            Some(last) if last.0 == bin => {
                last.1 += waves;
                last.2 += c;
                last.3 += q;
            }
            _ => bins.push((bin, waves, c, q)),
        }
    }
    bins.into_iter().map(|(_, waves, c, q)| [TAU / (q / waves).exp(), c / waves]).collect()
}

fn refused_plan(error: PlanError, name: &str) -> StudyError {
    let surface = name.to_owned();
    match error {
        PlanError::Statistics(source) => StudyError::Statistics { surface, source },
        PlanError::Solver(source) => StudyError::Solver { surface, source: Box::new(source) },
        PlanError::Stopped => StudyError::Stopped,
    }
}

pub(crate) fn builder(settings: &Settings) -> SolverBuilder {
    Solver::builder()
        .method(method(settings.method))
        .precision(precision(settings.precision))
        .tolerance(settings.tolerance)
        .threads(settings.threads.max(1))
}

/// The pressures of a study on one surface, rising and distinct.
fn loads(settings: &Settings, modulus: ContactModulus, rms_gradient: f64) -> Vec<f64> {
    let mut loads = settings
        .pressures
        .clone()
        .unwrap_or_else(|| default_pressures(modulus.pascals(), rms_gradient));
    loads.sort_by(f64::total_cmp);
    loads.dedup_by(|a, b| same(*a, *b));
    loads
}

/// Equal but for the rounding of a decimal.
fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * a.abs().max(b.abs())
}

/// Asks a model at every load, with its time.
fn ask(
    entry: &'static ModelEntry,
    inputs: &Inputs,
    deterministic: &[DeterministicPoint],
    statistics: &SurfaceStatistics,
    alike: Option<&Query>,
) -> ModelComparison {
    let outcome = entry.build(inputs).and_then(|model| {
        let (points, seconds) = timed(model.as_ref(), deterministic);
        // A theory that refuses every load does not apply: its reason is the outcome.
        if let Some(Err(first)) = points.first()
            && points.iter().all(Result::is_err)
        {
            return Err(BuildError::Model(first.clone()));
        }
        let errors = points.iter().zip(deterministic).map(|(m, d)| error(m, d)).collect();
        Ok(ModelCurve { points, seconds, errors })
    });
    let verdict = verdict(entry, inputs, &outcome, deterministic, statistics);
    let experience = alike.and_then(|query| Survey::built_in().ask(entry.name, query));
    ModelComparison { entry, outcome, verdict, experience }
}

/// This surface at this load as the survey sees it; `None` for a flat map or without a solution.
fn likeness(
    map: &HeightMap,
    statistics: &SurfaceStatistics,
    inputs: &Inputs,
    spectral: &Spectral,
    point: &DeterministicPoint,
) -> Option<Query> {
    let gradient = inputs.rms_gradient();
    let [dy, dx] = map.grid().pixel();
    Some(Query {
        bandwidth: inputs.moments?.bandwidth(),
        resolved: spectral.resolved,
        anisotropy: statistics.anisotropy?,
        skewness: statistics.skewness?,
        kurtosis: statistics.kurtosis?,
        step: statistics.height_step.map_or(0.0, |q| q / (dy.min(dx) * gradient)),
        peak_slope: peak_slope(map, point.answer.as_ref()?.area_fraction_corrected),
        load: point.mean_pressure / (inputs.modulus.pascals() * gradient),
    })
}

/// Signed relative error of an area.
fn error(model: &Result<ContactState, ModelError>, reference: &DeterministicPoint) -> Option<f64> {
    let area = model.as_ref().ok()?.area_fraction;
    let truth = reference.answer.as_ref()?.area_fraction_corrected;
    (truth > 0.0).then(|| area / truth - 1.0)
}

/// A model's answers and its seconds per load: the median of passes over all loads, as many as
/// fit in 20 ms, at least three.
fn timed(
    model: &dyn ContactModel,
    loads: &[DeterministicPoint],
) -> (Vec<Result<ContactState, ModelError>>, f64) {
    let pass = || -> Vec<_> {
        loads.iter().map(|p| model.at_pressure(black_box(p.mean_pressure))).collect()
    };
    let begin = Instant::now();
    let mut passes: Vec<Duration> = Vec::new();
    let mut answers = Vec::new();
    while passes.len() < 3 || (begin.elapsed() < Duration::from_millis(20) && passes.len() < 999) {
        let start = Instant::now();
        answers = black_box(pass());
        passes.push(start.elapsed());
    }
    passes.sort();
    (answers, passes[passes.len() / 2].as_secs_f64() / loads.len().max(1) as f64)
}

fn form(name: LevelName) -> Level {
    match name {
        LevelName::None => Level::None,
        LevelName::Mean => Level::Mean,
        LevelName::Plane => Level::Plane,
        LevelName::Quadratic => Level::Quadratic,
    }
}

fn method(name: MethodName) -> Method {
    match name {
        MethodName::Auto => Method::Auto,
        MethodName::Chord => Method::Chord,
        MethodName::PolonskyKeer => Method::PolonskyKeer,
        MethodName::StanleyKato => Method::StanleyKato,
    }
}

fn precision(name: PrecisionName) -> Precision {
    match name {
        PrecisionName::F64 => Precision::Double,
        PrecisionName::F32 => Precision::Single,
    }
}
