//! The study itself: statistics, the deterministic curve, every model over the loads.

use crate::ask::curve_of;
use crate::conducted::Conduction;
use crate::curve::{Curve, solved};
use crate::findings::rows_jump;
use crate::materials::MaterialUse;
use crate::needs::Inputs;
use crate::progress::{Listener, Progress, StudyError};
use crate::result::{
    Comparison, DeterministicPoint, ModelComparison, ModelCurve, Refused, Spectral,
    SurfaceComparison,
};
use crate::scene::{excess, gradient_of_loads};
use crate::settings::default_pressures;
use crate::theory::{Assumes, Theory};
use crate::verdict::{Judged, verdict};
use crate::{Adhesion, OfMap, Registry, Settings, Spikes, Surface, WorkOfAdhesion, poisson};
use contact_accuracy::{
    AccuracyRequest, Aim, Ladder, LadderError, Map, Setup, Task, climb, round_to_digits,
};
use contact_types::{AmplitudeSpectrum, Clock, ContactModulus, ContactState, HeightMap};
use fft_bem_solver::{Load, Maps, SolverError};
use grid_fft::parallel::{join, on_threads};
use std::f64::consts::TAU;
use std::ops::ControlFlow;
use surface_stats::spectrum::{Ring, radial};
use surface_stats::{Edges, Level, Spectra, StatsOptions, SurfaceStatistics};

impl Comparison {
    /// Runs a study: every surface solved over the loads, and the theories of `registry` that the
    /// settings ask beside it. `progress` is told what happens, down to every iteration, and may stop it
    /// there. It is called on a thread of the solver.
    ///
    /// # Errors
    /// [`StudyError`]. Of several surfaces one that is refused costs the others nothing: it is listed
    /// under `refused`, and only if all are, the first reason is the error. A load at which the solver does not converge and a model that does not
    /// apply are results, not errors.
    pub fn run(
        surfaces: Vec<Surface>,
        settings: Settings,
        registry: &Registry,
        progress: &mut Listener<'_>,
    ) -> Result<Self, StudyError> {
        let start = Clock::now();
        if surfaces.is_empty() {
            return Err(StudyError::NoSurface);
        }
        let modulus = ContactModulus::from_pascals(settings.modulus)?;
        check_request(&settings, registry)?;
        check_combinations(&settings)?;
        let asked = (&settings, registry);
        let (done, refused) =
            on_threads(settings.threads, || all(surfaces, modulus, asked, progress))?;
        let seconds = start.elapsed().as_secs_f64();
        Ok(Self { settings, surfaces: done, refused, seconds })
    }
}

/// One surface after the other: what was found, and those that are refused. If all are, the first reason is the error.
fn all(
    surfaces: Vec<Surface>,
    modulus: ContactModulus,
    asked: (&Settings, &Registry),
    progress: &mut Listener<'_>,
) -> Result<(Vec<SurfaceComparison>, Vec<Refused>), StudyError> {
    let count = surfaces.len();
    let mut done = Vec::with_capacity(count);
    let mut refused = Vec::new();
    let mut first = None;
    for (index, surface) in surfaces.into_iter().enumerate() {
        let name = surface.name.clone();
        match compare(surface, modulus, asked, [index, count], progress) {
            Ok(found) => done.push(found),
            Err(StudyError::Stopped) => return Err(StudyError::Stopped),
            Err(why) => {
                refused.push(Refused { name, reason: why.to_string() });
                first.get_or_insert(why);
            }
        }
    }
    match first {
        Some(why) if done.is_empty() => Err(why),
        _ => Ok((done, refused)),
    }
}

fn check_combinations(settings: &Settings) -> Result<(), StudyError> {
    settings.joint().check()?;
    if let Some(value) = settings.gamma.filter(|g| !(0.01..=1.0).contains(g)) {
        return Err(StudyError::BadGamma(value));
    }
    match settings.hardness {
        Some(value) if !(value > 0.0 && value.is_finite()) => Err(StudyError::BadHardness(value)),
        _ => Ok(()),
    }
}

/// Refuses loads that are none, and models that there are not.
pub(crate) fn check_request(settings: &Settings, registry: &Registry) -> Result<(), StudyError> {
    let given = settings.pressures.iter().flatten().chain(&settings.headline);
    let is_empty = settings.pressures.as_ref().is_some_and(Vec::is_empty).then_some(0.0);
    let wrong = given.copied().find(|p| !(p.is_finite() && *p > 0.0)).or(is_empty);
    if let Some(value) = wrong {
        return Err(StudyError::BadPressure(value));
    }
    let Some(names) = &settings.models else { return Ok(()) };
    let known: Vec<&str> = registry.of_studies().map(|t| t.card().name.as_ref()).collect();
    let listed = known.join(", ");
    match names.iter().find(|name| !known.contains(&name.as_str())) {
        Some(name) => Err(StudyError::UnknownModel { name: name.clone(), known: listed }),
        None if names.is_empty() => Err(StudyError::NoModel(listed)),
        None => Ok(()),
    }
}

fn compare(
    surface: Surface,
    modulus: ContactModulus,
    (settings, registry): (&Settings, &Registry),
    [index, count]: [usize; 2],
    progress: &mut Listener<'_>,
) -> Result<SurfaceComparison, StudyError> {
    let Surface { name, origin, heights } = surface;
    let refused = |source| StudyError::Statistics { surface: name.clone(), source };
    let setup = Clock::now();
    let asked = (settings, registry);
    let fractal_range = settings.fractal_range;
    let options = StatsOptions { fractal_range, ..origin.options(settings.level) };
    // Spikes of the map before levelling, as they are removed; a tilt that is removed is still reported.
    let (spikes, described) = join(
        || Spikes::left(&heights, origin.cleaned(), origin.pair()),
        || SurfaceStatistics::with_spectra(&heights, &options),
    );
    let (statistics, spectra) = described.map_err(refused)?;
    // Under a Hann window, or the jump at the edges would count as roughness.
    let windowed = statistics.edges == Edges::Open;
    let Spectra { surface, amplitudes, seconds, moments, resolved, rings, .. } = spectra;
    let map = if statistics.level == Level::None { heights } else { surface };
    let spectral = Spectral { moments, resolved, windowed, psd: thinned(&rings) };
    let mut inputs = model_inputs(&map, &statistics, amplitudes, modulus, asked);
    inputs.surface = Some(name.clone());
    let setup_seconds = setup.elapsed().as_secs_f64();

    let gradient = inputs.rms_gradient();
    let pressures = loads(settings, modulus, gradient);
    let wanted = headline(settings, &pressures)?;
    let loads = pressures.len();
    tell(progress, Progress::Surface { name: &name, index, count, loads })?;

    let solver = settings.solver().maps(Maps::PressureAndGap);
    let setup = settings.setup(solver, modulus);
    let mirrored = setup.mirrored;
    let aim = match (settings.accuracy, settings.fast) {
        (Some(accuracy), _) => Aim::Within(AccuracyRequest::new(accuracy)?),
        (None, true) => Aim::Fast,
        (None, false) => Aim::AsGiven,
    };
    let loads: Vec<Load> = pressures.iter().map(|&p| Load::MeanPressure(p)).collect();
    let found = SurfaceComparison {
        spikes,
        name,
        origin,
        surface: map.clone(),
        edges: settings.edges,
        statistics,
        inputs,
        spectral,
        setup_seconds,
        deterministic: Vec::new(),
        elastic: Vec::new(),
        map: Map::default(),
        beside_seconds: [0.0; 2],
        coarser: Vec::new(),
        choices: None,
        conduction: None,
        leaks: Vec::new(),
        adhesion: None,
        plan: None,
        solved: None,
        headline: 0,
        load_area: settings.load_area,
        pressure: Vec::new(),
        solution: None,
        first_contact: None,
        pressure_maps: None,
        sections: Vec::new(),
        distributions: Vec::new(),
        models: Vec::new(),
    };
    let materials = &settings.materials[..];
    let (pressures, score) = (&pressures[..], f64::INFINITY);
    let row = telling_row(&map);
    let mut curve = Curve { found, pressures, materials, row, wanted, score, progress };
    let plan = climb(Task { map, setup, loads: &loads, aim, kept: &mut None }, &mut curve);
    let Curve { mut found, progress, .. } = curve;
    let refused = |e| refused_ladder(e, &found.name);
    found.plan = Some(plan.map_err(refused)?).filter(|_| aim != Aim::AsGiven);
    if settings.hardness.is_some() {
        let elastic = settings.solver().hardness(f64::INFINITY).maps(Maps::Pressure);
        let elastic = Setup { mirrored, ..Setup::new(elastic, modulus) };
        let mut ladder = Ladder::new(found.solved_map().clone(), elastic).map_err(refused)?;
        found.elastic = elastic_beside(&found, &mut ladder, materials, progress)?;
    }

    tell(progress, Progress::Models)?;
    let statistics = &found.statistics;
    let judged = Judged {
        gradient: statistics.rms_gradient,
        rows_jump: rows_jump(statistics),
        anisotropy: statistics.anisotropy,
        heights: statistics.skewness.zip(statistics.kurtosis),
        fractal_range: statistics.fractal_range,
        excess: excess(&found.deterministic, &found.elastic),
    };
    let ask = |theory| ask(theory, &found, seconds, &judged);
    found.models = settings.asked_models(registry).map(ask).collect();
    found.conduction = Conduction::of(&found, settings);
    found.adhesion = settings.adhesion.map(|given| sticking(given, &found));
    Ok(found)
}

fn tell(progress: &mut Listener<'_>, news: Progress<'_>) -> Result<(), StudyError> {
    match progress(news) {
        ControlFlow::Continue(()) => Ok(()),
        ControlFlow::Break(()) => Err(StudyError::Stopped),
    }
}

/// The solutions of elastic bodies beside those of bodies that yield. Where nothing has yielded they are the same.
fn elastic_beside(
    found: &SurfaceComparison,
    ladder: &mut Ladder,
    materials: &[MaterialUse],
    progress: &mut Listener<'_>,
) -> Result<Vec<DeterministicPoint>, StudyError> {
    let mut beside = Vec::new();
    for (index, point) in found.deterministic.iter().enumerate() {
        let yielded = point.answer.as_ref().and_then(|a| a.diagnostics.yielded);
        if yielded.is_some_and(|y| y.area_fraction <= 0.0) {
            beside.push(point.clone());
            continue;
        }
        let load = Load::MeanPressure(point.mean_pressure);
        let result = ladder.solve(load, |now| progress(Progress::Iterated { index, now: *now }));
        if matches!(result, Err(SolverError::Stopped(_))) {
            return Err(StudyError::Stopped);
        }
        beside.push(solved(point.mean_pressure, result, materials, &found.map).0);
    }
    Ok(beside)
}

/// Whether the bodies stick at the loads that were solved.
fn sticking(given: WorkOfAdhesion, found: &SurfaceComparison) -> Adhesion {
    let converged = |p: &DeterministicPoint| {
        let answer = p.answer.as_ref().filter(|a| a.converged)?;
        Some([p.mean_pressure, answer.area_fraction])
    };
    let contacts: Vec<[f64; 2]> = found.deterministic.iter().filter_map(converged).collect();
    Adhesion::of(given, &found.inputs_with_spectrum(), found.statistics.cutoff, &contacts)
}

fn refused_ladder(error: LadderError, name: &str) -> StudyError {
    let surface = name.to_owned();
    match error {
        LadderError::Statistics(source) => StudyError::Statistics { surface, source },
        LadderError::Solver(source) => StudyError::Solver { surface, source: Box::new(source) },
        LadderError::Stopped => StudyError::Stopped,
    }
}

/// The pressures (Pa) of a study on one surface, rising and distinct. Where nobody chose them the real area runs from about
/// 0.1 % to half of the surface, five loads to a decade, and stays below what bodies bear in their volume.
pub fn loads(settings: &Settings, modulus: ContactModulus, rms_gradient: f64) -> Vec<f64> {
    let mut loads = settings.pressures.clone().unwrap_or_else(|| {
        let gradient = gradient_of_loads(rms_gradient, modulus, settings.hardness);
        default_pressures(modulus.pascals(), gradient)
    });
    loads.sort_by(f64::total_cmp);
    loads.dedup_by(|a, b| same(*a, *b));
    loads
}

/// The load whose ratio to this one is least.
pub(crate) fn nearest(loads: &[f64], to: f64) -> usize {
    let distance = |i: &usize| (loads[*i] / to).ln().abs();
    (0..loads.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
}

/// The load of the headline, if one was asked for.
pub(crate) fn headline(settings: &Settings, loads: &[f64]) -> Result<Option<usize>, StudyError> {
    let Some(value) = settings.headline else { return Ok(None) };
    let place = nearest(loads, value);
    if named(loads[place], value) {
        Ok(Some(place))
    } else {
        Err(StudyError::HeadlineNotComputed(value))
    }
}

/// Equal but for the rounding of a decimal.
fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * a.abs().max(b.abs())
}

/// True if `value` names this load: equal, or what it is to three digits, as it is printed.
fn named(load: f64, value: f64) -> bool {
    same(load, value)
        || same(round_to_digits(load, 3), value)
        || same(round_to_digits(load, 4), value)
}

/// Asks a model at every load, with its time. It is judged by the solution for the bodies it is about, which yield or are
/// elastic. `seconds` were spent on moments, amplitudes and spectrum.
fn ask(
    theory: &dyn Theory,
    found: &SurfaceComparison,
    [moments, amplitudes, spectrum]: [f64; 3],
    judged: &Judged,
) -> ModelComparison {
    let card = theory.card().clone();
    let SurfaceComparison { deterministic, elastic, inputs, .. } = found;
    let loads = if card.yields || elastic.is_empty() { deterministic } else { elastic };
    // A theory of elastic bodies is asked as one, also if it could take a hardness.
    let hardness = inputs.hardness.filter(|_| card.yields);
    let asked = Inputs { hardness, ..inputs.clone() };
    let preparation = moments
        + match card.of_map {
            OfMap::Moments => 0.0,
            OfMap::Spectrum => inputs.spectrum.as_ref().map_or(0.0, |_| spectrum),
            OfMap::Amplitudes => amplitudes,
            OfMap::Fractal => spectrum,
        };
    let pressures: Vec<f64> = deterministic.iter().map(|p| p.mean_pressure).collect();
    let outcome = curve_of(theory, &asked, &pressures).map(|curve| {
        let error = |(model, solved): (&Result<ContactState, _>, &DeterministicPoint)| {
            let area = model.as_ref().ok()?.area_fraction;
            let truth = solved.answer.as_ref()?.area_fraction;
            (truth > 0.0).then(|| area / truth - 1.0)
        };
        let errors = curve.points.iter().zip(loads).map(error).collect();
        ModelCurve { preparation, errors, ..curve }
    });
    let verdict = verdict(&card, inputs, &outcome, &pressures, judged);
    ModelComparison { card, outcome, verdict }
}

/// One set of moments for all models, by finite differences: they stay inside the map, so that a
/// map that does not repeat brings no jump at its edges, and they see less of the noise near two
/// points than the spectrum does. Amplitudes are kept if a
/// model that is asked needs them, or may need them.
fn model_inputs(
    map: &HeightMap,
    statistics: &SurfaceStatistics,
    amplitudes: AmplitudeSpectrum,
    modulus: ContactModulus,
    (settings, registry): (&Settings, &Registry),
) -> Inputs {
    let has_use = settings
        .asked_models(registry)
        .any(|t| matches!(t.card().assumes, Assumes::Amplitudes | Assumes::Unstated));
    Inputs {
        moments: Some(statistics.moments()).filter(|m| m.m2 > 0.0 && m.m4 > 0.0),
        is_measured: true,
        amplitudes: Some(amplitudes).filter(|_| has_use),
        fractal: statistics.fractal(),
        dimension: statistics.dimension,
        nominal_area: Some(map.grid().area()),
        hardness: settings.hardness,
        gamma: settings.gamma,
        // The mean gap is told where its weight was asked for.
        spectrum: settings.gamma.and_then(|_| radial(map).ok()),
        poisson: poisson(&settings.bodies),
        ..Inputs::new(modulus)
    }
}

/// The PSD in about 12 bins per octave of wavenumber, `[wavelength, C]`: what a figure can show.
fn thinned(rings: &[Ring]) -> Vec<[f64; 2]> {
    let rings: Vec<&Ring> = rings.iter().filter(|r| r.wavenumber > 0.0).collect();
    let bin = |ring: &Ring| (12.0 * ring.wavenumber.log2()).floor() as i64;
    let mean = |rings: &[&Ring]| {
        let waves: f64 = rings.iter().map(|r| r.waves as f64).sum();
        let of = |part: fn(&Ring) -> f64| -> f64 {
            rings.iter().map(|r| r.waves as f64 * part(r)).sum::<f64>() / waves
        };
        [TAU / of(|r| r.wavenumber.ln()).exp(), of(|r| r.psd)]
    };
    rings.chunk_by(|a, b| bin(a) == bin(b)).map(mean).collect()
}

/// Share of the points that counts as high: about what touches at a typical load.
const HIGH: f64 = 0.02;
/// Classes of height by which the high points are found.
const CLASSES: usize = 4096;

/// The row of the middle four fifths of a map that has the most high points, where contact is soonest and
/// longest seen; the first of several.
fn telling_row(map: &HeightMap) -> usize {
    let [ny, nx] = map.grid().shape();
    let (low, high) = map.range();
    if high <= low {
        return ny / 2;
    }
    let class = |h: f64| (((h - low) / (high - low) * CLASSES as f64) as usize).min(CLASSES - 1);
    let rows = ny / 10..ny - ny / 10;
    let middle = &map.heights()[rows.start * nx..rows.end * nx];
    let mut counts = vec![0_usize; CLASSES];
    for h in middle {
        counts[class(*h)] += 1;
    }
    let wanted = (HIGH * middle.len() as f64).ceil() as usize;
    let mut above = 0;
    let level = (0..CLASSES).rev().find(|k| {
        above += counts[*k];
        above >= wanted
    });
    let level = level.unwrap_or(0);
    let count = |row: usize| {
        let row = &map.heights()[row * nx..(row + 1) * nx];
        row.iter().filter(|h| class(**h) >= level).count()
    };
    rows.map(|row| (count(row), row))
        .max_by_key(|(count, row)| (*count, ny - row))
        .map_or(0, |m| m.1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use contact_types::Grid;

    #[test]
    fn the_row_crosses_the_most_summits_away_from_the_edges() {
        let grid = Grid::new([50, 60], [1e-6, 1e-6]).unwrap();
        let mut heights: Vec<f64> = (0..3000).map(|i| f64::from((i * 37) % 101) * 1e-9).collect();
        for x in 0..60 {
            heights[2 * 60 + x] = 3e-7; // too near the edge
        }
        for x in 10..35 {
            heights[31 * 60 + x] = 2e-7;
            heights[40 * 60 + x - 5] = if x < 15 { 0.0 } else { 2e-7 };
        }
        let map = HeightMap::new(grid, heights).unwrap();
        assert_eq!(telling_row(&map), 31);
        let flat = HeightMap::from_fn(grid, |_, _| 1.0).unwrap();
        assert_eq!(telling_row(&flat), 25);
        let line = Grid::new([1, 60], [1e-6, 1e-6]).unwrap();
        assert_eq!(telling_row(&HeightMap::from_fn(line, |_, x| x).unwrap()), 0);
    }
}
