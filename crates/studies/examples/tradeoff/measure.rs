//! The measurements: every closed form, and the solver over methods, grids, precisions and
//! tolerances, each with its time and its true error.

use contact_compare::{Comparison, Inputs, Level, Settings, Surface, built_in, built_in_recipes};
use contact_types::{ContactModulus, Grid, HeightMap, Named};
use fft_bem_solver::{
    Boundary, HalfSpace, Iteration, Load, Method, PERIMETER_CORRECTION, Precision, Real, Solution,
    Solver, SolverError,
};
use std::error::Error;
use std::hint::black_box;
use std::ops::ControlFlow;
use std::time::Instant;
use studies::tradeoff::{PAIR, STATISTICS, TradeoffRow};
use surface_stats::clean::resample;
use surface_stats::spectrum::amplitudes;
use surface_stats::{Edges, StatsOptions, SurfaceStatistics};

type RunResult<T> = Result<T, Box<dyn Error>>;

/// Contact modulus \[Pa\]; every ratio is free of it.
const MODULUS: f64 = 1e11;

/// Fewest repeats of a measurement; the shortest counts.
const REPEATS: usize = 3;

/// How much finer than the map the grid of the truth is.
const REFINE: usize = 4;

pub(crate) struct Plan {
    /// Points per side instead of the recipes' own.
    pub(crate) points: Option<usize>,
    /// How many of the built-in surfaces.
    pub(crate) surfaces: usize,
    /// Mean pressures over E* h'_rms.
    pub(crate) loads: &'static [f64],
    /// Points per side of coarser and finer grids over those of the map.
    pub(crate) scales: &'static [f64],
    /// Surface and load at which the slow methods are measured, too.
    pub(crate) close_up: (&'static str, f64),
    /// Tolerances of the chord method at that surface and load, and at the others.
    pub(crate) tolerances: [&'static [f64]; 2],
    /// Tolerances of the slow methods.
    pub(crate) few_tolerances: &'static [f64],
    /// FFT convolutions after which a slow method is stopped.
    pub(crate) most_pairs: f64,
    /// Seconds of repeats that a short measurement gets.
    pub(crate) seconds: f64,
}

impl Plan {
    /// The built-in surfaces as they are.
    pub(crate) const FULL: Self = Self {
        points: None,
        surfaces: 3,
        loads: &[0.005, 0.02, 0.05, 0.2],
        scales: &[0.125, 0.25, 0.5, 1.0, 2.0],
        close_up: ("ground", 0.05),
        tolerances: [
            &[1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10],
            &[1e-1, 1e-2, 1e-3, 1e-4],
        ],
        few_tolerances: &[1e-1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10],
        most_pairs: 600.0,
        seconds: 0.2,
    };

    /// The least that fills every part of the table.
    #[cfg(test)]
    pub(crate) const TINY: Self = Self {
        points: Some(64),
        surfaces: 1,
        loads: &[0.02, 0.05],
        scales: &[0.5, 1.0, 2.0],
        close_up: ("polished", 0.05),
        tolerances: [&[1e-1, 1e-2, 1e-4], &[1e-2, 1e-4]],
        few_tolerances: &[1e-2, 1e-4],
        most_pairs: 40.0,
        seconds: 0.0,
    };

    /// How low a tolerance is worth asking for in this precision.
    fn lowest(precision: Precision) -> f64 {
        if precision == Precision::Single { 1e-5 } else { 1e-10 }
    }
}

/// Measures everything, one row at a time into `take`.
pub(crate) fn run(plan: &Plan, take: &mut dyn FnMut(TradeoffRow)) -> RunResult<()> {
    for mut recipe in built_in_recipes().into_iter().take(plan.surfaces) {
        if let Some(points) = plan.points {
            recipe.shape = [points; 2];
        }
        surface(plan, recipe.make()?, take)?;
    }
    Ok(())
}

fn surface(plan: &Plan, surface: Surface, take: &mut dyn FnMut(TradeoffRow)) -> RunResult<()> {
    let name = surface.name.clone();
    let modulus = ContactModulus::from_pascals(MODULUS)?;
    let (map, inputs) = as_compared(surface)?;
    let blank = TradeoffRow { surface: name.clone(), ..TradeoffRow::default() };
    let options =
        StatsOptions { level: Level::None, edges: Edges::Periodic, ..StatsOptions::default() };
    // Everything a model may need of a map.
    let all =
        || -> RunResult<_> { Ok((SurfaceStatistics::of(&map, &options)?, amplitudes(&map)?)) };
    black_box(all()?);
    let seconds = shortest(0.0, || {
        let clock = Instant::now();
        let _ = black_box(all());
        clock.elapsed().as_secs_f64()
    });
    take(TradeoffRow { method: STATISTICS.into(), seconds, ..blank.clone() });

    let finer =
        |times: usize| resample(&map, map.grid().shape().map(|n| times * n), Edges::Periodic);
    let (half_way, finest) = (finer(REFINE / 2)?, finer(REFINE)?);
    for &load in plan.loads {
        let pressure = load * MODULUS * inputs.rms_gradient();
        let [truth, bar] = truth(&half_way, &finest, modulus, pressure)?;
        let case =
            TradeoffRow { load: Some(load), truth: Some(truth), bar: Some(bar), ..blank.clone() };
        models(plan, &inputs, pressure, &case, take);
        let is_close_up = plan.close_up == (name.as_str(), load);
        for &scale in plan.scales {
            let points = scaled(map.grid().shape()[0], scale);
            let case = TradeoffRow { scale: Some(scale), points: Some(points), ..case.clone() };
            let job = Job { plan, map: &map, points, modulus, pressure, case };
            job.solve(is_close_up, take)?;
        }
        eprintln!(
            "{name}, p = {load} E* h'rms: true area {truth:.5} +- {:.2} %",
            1e2 * bar / truth
        );
    }
    Ok(())
}

/// Points per side of a coarser or finer grid; even when coarser, as transforms like it.
fn scaled(points: usize, scale: f64) -> usize {
    if scale < 1.0 {
        2 * (0.5 * scale * points as f64) as usize
    } else {
        (scale * points as f64).round() as usize
    }
}

/// The map and the numbers that `compare` gives the models.
fn as_compared(surface: Surface) -> RunResult<(HeightMap, Inputs)> {
    let settings = Settings {
        modulus: MODULUS,
        pressures: Some(vec![1e-4 * MODULUS]),
        level: Level::Mean,
        tolerance: 0.1,
        ..Settings::default()
    };
    let mut study =
        Comparison::run(vec![surface], settings, built_in(), &mut |_| ControlFlow::Continue(()))?;
    let found = study.surfaces.pop().ok_or("no surface came back")?;
    Ok((found.surface, found.inputs))
}

/// The true area and its half width, from two refined grids: 0.3 of the correction for the contact
/// line on the finer, or what the last refinement changed, whichever is larger.
fn truth(
    half_way: &HeightMap,
    finest: &HeightMap,
    modulus: ContactModulus,
    pressure: f64,
) -> RunResult<[f64; 2]> {
    let solve = |map: &HeightMap| -> RunResult<[f64; 2]> {
        let mut solver = Solver::builder().tolerance(1e-10).build(map.grid(), modulus)?;
        let found = solver.solve(map, Load::MeanPressure(pressure))?;
        let correction = PERIMETER_CORRECTION * found.diagnostics.contact_perimeter;
        Ok([found.state.area_fraction, correction])
    };
    let ([before, _], [area, correction]) = (solve(half_way)?, solve(finest)?);
    Ok([area, (0.3 * correction).max((area - before).abs())])
}

/// Every model that a map gives all inputs for.
fn models(
    plan: &Plan,
    inputs: &Inputs,
    pressure: f64,
    case: &TradeoffRow,
    take: &mut dyn FnMut(TradeoffRow),
) {
    for theory in built_in().iter().filter(|theory| theory.card().from_map) {
        let Ok(model) = theory.build(inputs) else { continue };
        let Ok(state) = model.at_pressure(pressure) else { continue };
        // Many calls to a reading, so that the clock itself does not count.
        let reading = |calls: u32| {
            let clock = Instant::now();
            for _ in 0..calls {
                let _ = black_box(model.at_pressure(black_box(pressure)));
            }
            clock.elapsed().as_secs_f64()
        };
        let mut calls = 1;
        while reading(calls) < 1e-4 {
            calls *= 2;
        }
        let seconds = shortest(0.1 * plan.seconds, || reading(calls)) / f64::from(calls);
        let area = Some(state.area_fraction);
        take(TradeoffRow { method: theory.card().name.to_string(), area, seconds, ..case.clone() });
    }
}

/// The shortest of at least [`REPEATS`] readings, more while they take less than `budget` seconds
/// together.
fn shortest(budget: f64, mut reading: impl FnMut() -> f64) -> f64 {
    let begin = Instant::now();
    let (mut best, mut done) = (f64::INFINITY, 0);
    while done < REPEATS || begin.elapsed().as_secs_f64() < budget {
        best = best.min(reading());
        done += 1;
    }
    best
}

/// A surface at a load, to be solved on one grid.
struct Job<'a> {
    plan: &'a Plan,
    map: &'a HeightMap,
    points: usize,
    modulus: ContactModulus,
    pressure: f64,
    case: TradeoffRow,
}

impl Job<'_> {
    fn solve(&self, is_close_up: bool, take: &mut dyn FnMut(TradeoffRow)) -> RunResult<()> {
        let Plan { tolerances: [all, some], few_tolerances, .. } = *self.plan;
        let tolerances = if is_close_up { all } else { some };
        if self.points > self.map.grid().shape()[0] {
            // Finer than the map: what comes after the full grid, at the default tolerance.
            return self.over(Method::Chord, Precision::Double, &[1e-4], None, take);
        }
        let exact = if is_close_up {
            self.pairs(take)?;
            let answer = self.answer(Method::Chord, Precision::Double, 1e-12)?;
            Some(answer.0.pressure)
        } else {
            None
        };
        for precision in [Precision::Double, Precision::Single] {
            self.over(Method::Chord, precision, tolerances, exact.as_deref(), take)?;
        }
        if is_close_up {
            for method in [Method::PolonskyKeer, Method::StanleyKato] {
                for precision in [Precision::Double, Precision::Single] {
                    self.over(method, precision, few_tolerances, exact.as_deref(), take)?;
                }
            }
        }
        Ok(())
    }

    /// One method over the tolerances, from loose to tight.
    fn over(
        &self,
        method: Method,
        precision: Precision,
        tolerances: &[f64],
        exact: Option<&[f64]>,
        take: &mut dyn FnMut(TradeoffRow),
    ) -> RunResult<()> {
        for &tolerance in tolerances.iter().filter(|&&t| t >= Plan::lowest(precision)) {
            let answer = || self.answer(method, precision, tolerance);
            let (first, seconds, is_capped) = answer()?;
            let again = || answer().map_or(f64::INFINITY, |(_, again, _)| again);
            let seconds = shortest(self.plan.seconds, again).min(seconds);
            let touching = first.touching_fraction();
            let Solution { state, pressure, diagnostics, .. } = first;
            take(TradeoffRow {
                method: method.name().to_owned(),
                precision: Some(precision.name().to_owned()),
                tolerance: Some(tolerance),
                area: Some(touching),
                corrected: Some(state.area_fraction),
                pressure_error: exact.map(|exact| relative(&pressure, exact)),
                pairs: Some(diagnostics.transforms),
                seconds,
                is_capped,
                ..self.case.clone()
            });
            if is_capped {
                break; // a tighter tolerance would stop at the same place
            }
        }
        Ok(())
    }

    /// One answer, the seconds from the given map in memory to it, resampling, planning and all,
    /// and whether it was stopped.
    fn answer(
        &self,
        method: Method,
        precision: Precision,
        tolerance: f64,
    ) -> RunResult<(Solution, f64, bool)> {
        let most = self.plan.most_pairs;
        let watch = |it: &Iteration<'_>| {
            if it.transforms < most { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        };
        let clock = Instant::now();
        let coarse;
        let map = if self.map.grid().shape() == [self.points; 2] {
            self.map
        } else {
            coarse = resample(self.map, [self.points; 2], Edges::Periodic)?;
            &coarse
        };
        let builder = Solver::builder().method(method).precision(precision).tolerance(tolerance);
        let mut solver = builder.build(map.grid(), self.modulus)?;
        let result = solver.solve_observed(map, Load::MeanPressure(self.pressure), watch);
        let seconds = clock.elapsed().as_secs_f64();
        match result {
            Ok(solution) => Ok((solution, seconds, false)),
            Err(
                SolverError::Stopped(best)
                | SolverError::NotConverged(best)
                | SolverError::Rounding(best),
            ) => Ok((*best, seconds, true)),
            Err(error) => Err(error.into()),
        }
    }

    /// The time of one FFT convolution on this grid in both precisions.
    fn pairs(&self, take: &mut dyn FnMut(TradeoffRow)) -> RunResult<()> {
        let [ny, nx] = [self.points; 2];
        let [ly, lx] = self.map.grid().size();
        let grid = Grid::new([ny, nx], [ly / ny as f64, lx / nx as f64])?;
        let budget = self.plan.seconds;
        for (precision, seconds) in [
            (Precision::Double, one_pair::<f64>(grid, self.modulus, budget)),
            (Precision::Single, one_pair::<f32>(grid, self.modulus, budget)),
        ] {
            let precision = Some(precision.name().to_owned());
            let pair = TradeoffRow { method: PAIR.into(), precision, seconds, ..self.case.clone() };
            take(TradeoffRow { load: None, truth: None, bar: None, ..pair });
        }
        Ok(())
    }
}

fn one_pair<T: Real>(grid: Grid, modulus: ContactModulus, budget: f64) -> f64 {
    let mut half_space = HalfSpace::<T>::new(grid, modulus, Boundary::Periodic);
    let mut field = vec![T::of(1.0); grid.len()];
    shortest(budget, || {
        let clock = Instant::now();
        half_space.displace(&mut field);
        clock.elapsed().as_secs_f64()
    })
}

/// Rms difference over the rms of the exact field.
fn relative(found: &[f64], exact: &[f64]) -> f64 {
    let square: f64 = exact.iter().map(|p| p * p).sum();
    let difference: f64 = found.iter().zip(exact).map(|(a, b)| (a - b).powi(2)).sum();
    (difference / square).sqrt()
}
