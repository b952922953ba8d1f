//! The maps of one family: what each answers, and what it says of the others.

use crate::{fresh, judged, tuning};
use contact_accuracy::budget::grid::Line;
use contact_accuracy::budget::{Budget, Map, Stiffness};
use contact_types::{ContactModulus, Grid, HeightMap};
use fft_bem_solver::{Load, Solver};
use std::error::Error;
use std::fmt::Write as _;
use studies::maps::{Draw, PIXEL, gradient};
use surface_stats::{Level, level};

/// Points along each side.
const POINTS: usize = 128;
/// Contact modulus \[Pa\]; every number kept is free of it.
const MODULUS: f64 = 1e11;
/// Mean pressure over E* times the rms gradient of the family.
const LOADS: [f64; 5] = [0.001, 0.005, 0.03, 0.15, 0.6];
/// Maps that say the rms gradient of a family.
const GRADIENTS: u64 = 10;

/// First line of the table: numbers, and the half width of their finite sample.
pub(crate) const HEADER: &str =
    "family,map,load,repeats,area,area_half,gap,gap_half,stiffness,stiffness_half";

/// The rows of a family, one per map and load.
pub(crate) fn family(family: &str, maps: usize) -> Result<String, Box<dyn Error>> {
    let mut squares = 0.0;
    for seed in 0..GRADIENTS {
        let map = made(family, seed)?;
        squares += (gradient(map.heights(), POINTS) / PIXEL).powi(2);
    }
    let gradient = (squares / GRADIENTS as f64).sqrt();
    let mut rows = String::new();
    for seed in 0..maps {
        let map = made(family, seed as u64)?;
        let known = Map::of(&map)?;
        let modulus = ContactModulus::from_pascals(MODULUS)?;
        let mut solver = Solver::builder().tolerance(1e-5).threads(1).build(map.grid(), modulus)?;
        for load in LOADS {
            let pressure = load * MODULUS * gradient;
            let solution = solver.solve(&map, Load::MeanPressure(pressure))?;
            let mut budget = Budget::of(&solution, &known);
            if let Some(near) = Stiffness::near(&mut solver, &map, pressure)? {
                budget = budget.with_stiffness(&near, &known, Line::of(&solution));
            }
            let _ = write!(rows, "\"{family}\",{seed},{load},{}", u8::from(known.repeats));
            for number in [Some(budget.area), budget.mean_gap, budget.stiffness] {
                let value = number.map_or(f64::NAN, |n| n.value);
                let half = number.and_then(|n| n.sample).unwrap_or(f64::NAN);
                let _ = write!(rows, ",{value:.5e},{half:.3e}");
            }
            rows.push('\n');
        }
    }
    Ok(rows)
}

/// One map of a family, levelled as the command does unless it is to keep its tilt.
fn made(family: &str, seed: u64) -> Result<HeightMap, Box<dyn Error>> {
    let (is_fresh, is_judged) = (fresh::FRESH.contains(&family), judged::JUDGED.contains(&family));
    let first = if is_fresh || is_judged { 9_000_000 } else { 1_000_000 };
    let draw = Draw { n: POINTS, seed: first + seed, t: [0.0; 4] };
    let heights = match (is_fresh, is_judged) {
        (true, _) => fresh::heights(family, &draw),
        (false, true) => judged::heights(family, &draw),
        (false, false) => tuning::heights(family, &draw),
    }?;
    let grid = Grid::new([POINTS; 2], [PIXEL; 2])?;
    let map = HeightMap::new(grid, heights.iter().map(|h| h * PIXEL).collect())?;
    let form = if family.contains("tilted") { Level::Mean } else { Level::Plane };
    Ok(level(&map, form)?)
}
