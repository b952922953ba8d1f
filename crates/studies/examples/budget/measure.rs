//! One surface: the answers on the grid as given, on two and on four times as many points along
//! each side, and on the given grid when the iteration stops early.

use crate::ensemble;
use crate::fresh;
use compare::budget::Stiffness;
use contact_accuracy::round_to_digits;
use contact_types::{ContactModulus, HeightMap};
use fft_bem_solver::{Load, Solution, Solver};
use std::error::Error;
use std::fmt::Write as _;
use surface_stats::spectrum::{PowerSpectrum, Window};
use surface_stats::{DirectionalMoments, Edges, height_step};

/// Contact modulus \[Pa\]; every number kept is free of it.
const MODULUS: f64 = 1e11;
/// Mean pressure over E* h'_rms of the study.
const LOADS: [f64; 5] = [0.003, 0.01, 0.03, 0.1, 0.3];
/// Tolerance of what is compared between grids.
const TIGHT: f64 = 1e-6;
/// Tolerances whose iteration error is looked at.
const LOOSE: [f64; 3] = [1e-2, 1e-3, DEFAULT];
/// The tolerance of an answer.
const DEFAULT: f64 = 1e-4;
/// Factor to the loads on both sides for the stiffness, that of [`Stiffness`].
const STEP: f64 = 1.01;

/// A map of the study, or of those that took no part.
pub(crate) trait Surface: Sync {
    /// Its class.
    fn name(&self) -> &'static str;
    /// Hurst exponent, shortest and roll-off wavelength in points.
    fn spectrum(&self) -> [f64; 3];
    /// Mean pressures over E* h'_rms.
    fn loads(&self) -> [f64; 5];
    /// As given (`factor` 1), or on `factor` times as many points along each side.
    fn make(&self, factor: usize) -> Result<HeightMap, Box<dyn Error>>;
}

impl Surface for ensemble::Recipe {
    fn name(&self) -> &'static str {
        self.name
    }
    fn spectrum(&self) -> [f64; 3] {
        [self.hurst, self.cutoff, self.rolloff]
    }
    fn loads(&self) -> [f64; 5] {
        LOADS
    }
    fn make(&self, factor: usize) -> Result<HeightMap, Box<dyn Error>> {
        ensemble::make(self, factor)
    }
}

impl Surface for fresh::Recipe {
    fn name(&self) -> &'static str {
        self.name
    }
    fn spectrum(&self) -> [f64; 3] {
        [self.hurst, self.cutoff, self.rolloff]
    }
    fn loads(&self) -> [f64; 5] {
        fresh::LOADS
    }
    fn make(&self, factor: usize) -> Result<HeightMap, Box<dyn Error>> {
        fresh::Recipe::make(self, factor)
    }
}

/// First line of the table.
pub(crate) fn header() -> String {
    let mut line =
        String::from("surface,class,hurst,cutoff,rolloff,resolution,resolution_hann,step,load");
    for grid in ["1", "2", "4"] {
        let _ = write!(line, ",count{grid},edges{grid},gap{grid},stiffness{grid}");
    }
    for tolerance in ["2", "3", "4"] {
        let _ = write!(
            line,
            ",area_e{tolerance},gap_e{tolerance},residual_e{tolerance},eta_e{tolerance}"
        );
    }
    line.push_str(",stiffness_e4,stiffness_left_e4");
    line
}

/// What is kept of a solution.
struct Answer {
    count: f64,
    edges: f64,
    gap: f64,
    stiffness: f64,
}

/// The rows of one surface, one per load.
pub(crate) fn surface(index: usize, surface: &dyn Surface) -> Result<String, Box<dyn Error>> {
    let map = surface.make(1)?;
    let modulus = ContactModulus::from_pascals(MODULUS)?;
    let n = map.grid().len() as f64;
    let mean = map.mean();
    let rms = (map.heights().iter().map(|h| (h - mean).powi(2)).sum::<f64>() / n).sqrt();
    let moments = DirectionalMoments::of(&map, Edges::Periodic)?.isotropic(rms * rms);
    let gradient = moments.rms_gradient();
    let resolution = |window| -> Result<f64, Box<dyn Error>> {
        Ok(PowerSpectrum::of(&map, window)?.resolved_gradient().unwrap_or(1.0))
    };
    let [dy, dx] = map.grid().pixel();
    let step = height_step(map.heights()).map_or(0.0, |q| q / (gradient * dy.min(dx)));
    let seen = [resolution(Window::None)?, resolution(Window::Hann)?, step];
    let fixed = surface.spectrum().into_iter().chain(seen);
    let loads = surface.loads();
    let pressures = loads.map(|x| x * MODULUS * gradient);
    let mut grids = Vec::new();
    for factor in [1, 2, 4] {
        grids.push(answers(&surface.make(factor)?, modulus, &pressures, rms)?);
    }
    let mut rows = String::new();
    for (k, &pressure) in pressures.iter().enumerate() {
        let _ = write!(rows, "{index},{}", surface.name());
        let answers = grids.iter().flat_map(|g| {
            let a = &g[k];
            [a.count, a.edges, a.gap, a.stiffness]
        });
        let numbers = fixed.clone().chain([loads[k]]).chain(answers);
        let early = early(&map, modulus, pressure, rms)?;
        for value in numbers.chain(early) {
            let _ = write!(rows, ",{}", round_to_digits(value, 6));
        }
        rows.push('\n');
    }
    Ok(rows)
}

/// Area, gap over rms height and stiffness times rms height over E* at every load.
fn answers(
    map: &HeightMap,
    modulus: ContactModulus,
    pressures: &[f64],
    rms: f64,
) -> Result<Vec<Answer>, Box<dyn Error>> {
    let mut solver = Solver::builder().tolerance(TIGHT).threads(1).build(map.grid(), modulus)?;
    let mut list = Vec::new();
    for &pressure in pressures {
        let mut at = |pressure| solver.solve(map, Load::MeanPressure(pressure));
        let (less, at, more) = (at(pressure / STEP)?, at(pressure)?, at(pressure * STEP)?);
        let closed = gap(&less)? - gap(&more)?;
        list.push(Answer {
            count: at.state.area_fraction,
            edges: at.diagnostics.contact_perimeter,
            gap: gap(&at)? / rms,
            stiffness: 2.0 * STEP.ln() * pressure / closed * rms / modulus.pascals(),
        });
    }
    Ok(list)
}

/// Corrected area, gap, residual and energy bound where the iteration stops early; stiffness and
/// what is left of it at the last tolerance.
fn early(
    map: &HeightMap,
    modulus: ContactModulus,
    pressure: f64,
    rms: f64,
) -> Result<Vec<f64>, Box<dyn Error>> {
    let mut list = Vec::new();
    for tolerance in LOOSE {
        let solver = Solver::builder().tolerance(tolerance).threads(1).certified(true);
        let mut solver = solver.build(map.grid(), modulus)?;
        let found = solver.solve(map, Load::MeanPressure(pressure))?;
        let d = &found.diagnostics;
        list.extend([
            d.area_fraction_corrected,
            gap(&found)? / rms,
            d.residuals.preconditioned,
            d.energy_bound.ok_or("no energy bound")?,
        ]);
        if tolerance <= DEFAULT {
            let found = Stiffness::near(&mut solver, map, pressure)?.ok_or("no stiffness")?;
            let left = found.iteration.map_err(|why| format!("{why:?}"))?;
            list.extend([found.value * rms / modulus.pascals(), left]);
        }
    }
    Ok(list)
}

fn gap(solution: &Solution) -> Result<f64, Box<dyn Error>> {
    Ok(solution.state.mean_gap.ok_or("no mean gap")?)
}
