//! Maps that do not repeat in a solver that repeats them: what the treatment of their edges does
//! to the area.
//!
//! Crops are cut out of larger periodic maps, whose solution tells what each crop carries and how
//! much of it touches in its natural surroundings. Each crop is then levelled and solved alone
//! *at the load it carried there*, so that heights and load are the same and only the
//! surroundings differ.
//!
//! ```console
//! $ cargo run --release -p studies --example edges -- FOLDER
//! ```
//! writes `edges.md` and `edges.csv` into the folder; seconds go to the standard error stream.
#![allow(clippy::print_stderr, reason = "a study tells how far it is")]

mod case;
mod page;
mod treatment;

use case::{Case, Contact, LOADS, WAVES};
use clap::Parser;
use compare::EdgeShare;
use contact_types::{ContactModulus, Grid, HeightMap};
use fft_bem_solver::{BOUNDARY_CORRECTION, Load, Solver};
use rayon::prelude::*;
use std::error::Error;
use std::path::PathBuf;
use std::time::Instant;
use surface_stats::synthesis::{Scale, SelfAffine};
use surface_stats::{Level, level};
use treatment::Treatment;

/// Points along the sides of the large maps and of the crops.
const LARGE: usize = 1024;
const CROP: usize = 256;
const PIXEL: f64 = 1e-6;
const CUTOFF: f64 = 8e-6;
const GRADIENT: f64 = 0.1;
const HURST: [f64; 2] = [0.3, 0.8];

/// Large maps of each kind.
const MAPS: usize = 2;

/// What the treatment of the edges does to the area of maps that do not repeat
#[derive(Parser)]
struct Options {
    /// Folder for edges.md and edges.csv
    folder: PathBuf,
}

fn main() -> Result<(), Box<dyn Error>> {
    let Options { folder } = Options::parse();
    let start = Instant::now();
    let mut cases = Vec::new();
    let mut seed = 0_usize;
    for hurst in HURST {
        for waves in WAVES {
            for _ in 0..MAPS {
                seed += 1;
                cases.extend(study(hurst, waves, seed)?);
            }
            eprintln!("H = {hurst}, {waves} waves: {:.0} s", start.elapsed().as_secs_f64());
        }
    }
    for (k, treatment) in Treatment::ALL.iter().enumerate() {
        let seconds: f64 = cases.iter().map(|c| c.alone[k].seconds).sum();
        eprintln!("{}: {:.3} s per solution", treatment.name(), seconds / cases.len() as f64);
    }
    std::fs::create_dir_all(&folder)?;
    std::fs::write(folder.join("edges.md"), page::section(&cases))?;
    std::fs::write(folder.join("edges.csv"), page::rows(&cases))?;
    Ok(())
}

/// Every second crop of one large map, in a chequerboard, at every load.
fn study(hurst: f64, waves: f64, seed: usize) -> Result<Vec<Case>, Box<dyn Error>> {
    let recipe = SelfAffine {
        grid: Grid::new([LARGE, LARGE], [PIXEL, PIXEL])?,
        hurst,
        rolloff: CROP as f64 * PIXEL / waves,
        cutoff: CUTOFF,
        scale: Scale::RmsGradient(GRADIENT),
        seed: seed as u64,
        quantise: None,
    };
    let map = recipe.generate()?;
    let modulus = ContactModulus::from_pascals(1.0)?;
    let mut solver = Solver::builder().build(map.grid(), modulus)?;
    let mut fields = Vec::new();
    for load in LOADS {
        let solution = solver.solve(&map, Load::MeanPressure(load * GRADIENT))?;
        fields.push((solution.pressure, solution.diagnostics.area_fraction_corrected));
    }
    let side = LARGE / CROP;
    let places: Vec<[usize; 2]> = (0..side * side)
        .map(|i| [i / side, i % side])
        .filter(|[iy, ix]| (iy + ix) % 2 == 0)
        .map(|[iy, ix]| [iy * CROP, ix * CROP])
        .collect();
    let crops: Result<Vec<Vec<Case>>, String> = places
        .par_iter()
        .map(|&place| {
            let cases = crop_cases(&map, &fields, place, modulus).map_err(|e| e.to_string())?;
            Ok(cases.into_iter().map(|c| Case { surface: seed, hurst, waves, ..c }).collect())
        })
        .collect();
    Ok(crops?.into_iter().flatten().collect())
}

/// One crop at every load at which it carries something.
fn crop_cases(
    map: &HeightMap,
    fields: &[(Vec<f64>, f64)],
    place: [usize; 2],
    modulus: ContactModulus,
) -> Result<Vec<Case>, Box<dyn Error>> {
    let grid = Grid::new([CROP, CROP], map.grid().pixel())?;
    let crop = HeightMap::new(grid, window(map.heights(), LARGE, place))?;
    let crop = level(&crop, Level::Plane)?;
    let mut solvers = Vec::new();
    for treatment in Treatment::ALL {
        let given = treatment.apply(&crop);
        let builder = Solver::builder().threads(1).boundary(treatment.boundary());
        solvers.push((treatment, builder.build(given.grid(), modulus)?, given));
    }
    let mut cases = Vec::new();
    for (field, whole_area) in fields {
        let pressure = window(field, LARGE, place);
        let mean = pressure.iter().sum::<f64>() / pressure.len() as f64;
        let Some(load) = nearest(mean / GRADIENT) else { continue };
        let Some(truth) = contact(&pressure, grid) else { continue };
        let mut alone = Vec::new();
        for (treatment, solver, given) in &mut solvers {
            solver.forget(); // every cost from a cold start
            alone.push(solve(*treatment, solver, given, grid, mean)?);
        }
        let nominal = field.iter().sum::<f64>() / field.len() as f64;
        let (treatment, solver, given) = &mut solvers[0];
        let as_sample = solve(*treatment, solver, given, grid, nominal)?.area / whole_area;
        let carried = mean / GRADIENT;
        cases.push(Case {
            surface: 0,
            hurst: 0.0,
            waves: 0.0,
            load,
            carried,
            truth,
            alone,
            as_sample,
        });
    }
    Ok(cases)
}

/// The load of the study nearest to `load`; `None` beyond half a step of its ladder.
fn nearest(load: f64) -> Option<usize> {
    let distance = |k: &usize| (LOADS[*k] / load).ln().abs();
    let k = (0..LOADS.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
    (distance(&k) < (10.0f64 / 3.0).sqrt().ln()).then_some(k)
}

fn solve(
    treatment: Treatment,
    solver: &mut Solver,
    given: &HeightMap,
    grid: Grid,
    mean_pressure: f64,
) -> Result<Contact, Box<dyn Error>> {
    let start = Instant::now();
    let solution = solver.solve(given, Load::MeanPressure(mean_pressure))?;
    let seconds = start.elapsed().as_secs_f64();
    let columns = CROP * treatment.factor();
    let found = contact(&window(&solution.pressure, columns, [0, 0]), grid);
    let found = found.ok_or("nothing touches")?;
    let transforms = solution.diagnostics.transforms * relative_cost(treatment);
    Ok(Contact { transforms, seconds, ..found })
}

/// Points of the solver's transform over those of the crop: a free boundary pads to twice the
/// sides.
fn relative_cost(treatment: Treatment) -> f64 {
    if treatment == Treatment::Free {
        4.0
    } else {
        (treatment.factor() * treatment.factor()) as f64
    }
}

/// A crop of a field with `columns` columns.
fn window(field: &[f64], columns: usize, [y0, x0]: [usize; 2]) -> Vec<f64> {
    field
        .chunks_exact(columns)
        .skip(y0)
        .take(CROP)
        .flat_map(|row| row[x0..x0 + CROP].iter().copied())
        .collect()
}

/// What the pressures on a crop say, by the same rule whatever lies beyond: the contact line is
/// counted inside only.
fn contact(pressure: &[f64], grid: Grid) -> Option<Contact> {
    let edge = EdgeShare::of(pressure, grid)?;
    let touches = |iy: usize, ix: usize| pressure[iy * CROP + ix] > 0.0;
    let mut line = 0;
    let mut points = 0;
    for i in 0..CROP * CROP {
        let (iy, ix) = (i / CROP, i % CROP);
        points += usize::from(touches(iy, ix));
        line += usize::from(ix + 1 < CROP && touches(iy, ix) != touches(iy, ix + 1));
        line += usize::from(iy + 1 < CROP && touches(iy, ix) != touches(iy + 1, ix));
    }
    let inner_edges = 2.0 * (CROP * (CROP - 1)) as f64;
    let line = 2.0 * line as f64 / inner_edges;
    let area = points as f64 / (CROP * CROP) as f64 - BOUNDARY_CORRECTION * line;
    Some(Contact { area, edge, transforms: 0.0, seconds: 0.0 })
}
