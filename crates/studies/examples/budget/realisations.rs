//! Realisations of families of surfaces, and what one of them says of the others.

use crate::families::{FAMILIES, GRADIENT};
use compare::budget::sample::{PARTS, blocks, height_and_gradient};
use contact_types::ContactModulus;
use fft_bem_solver::{Load, Solver};
use std::error::Error;
use std::fmt::Write as _;
use surface_stats::spectrum::{PowerSpectrum, Window};

/// Contact modulus \[Pa\]; every ratio is free of it.
const MODULUS: f64 = 1e11;
/// Mean pressure over E* times the rms gradient expected.
const LOADS: [f64; 4] = [0.003, 0.01, 0.05, 0.2];
/// Realisations of a family.
pub(crate) const REALISATIONS: usize = 30;

pub(crate) fn header() -> &'static str {
    "family,seed,load,area,gap,stiffness,blocks,height"
}

/// The rows of one realisation, one per load.
pub(crate) fn realisation(family: usize, seed: usize) -> Result<String, Box<dyn Error>> {
    let map = FAMILIES[family].generate(family, seed)?;
    let modulus = ContactModulus::from_pascals(MODULUS)?;
    let mut solver = Solver::builder().tolerance(1e-5).threads(1).build(map.grid(), modulus)?;
    let [height, _] = height_and_gradient(&map, &PowerSpectrum::of(&map, Window::None)?);
    let mut rows = String::new();
    for load in LOADS {
        let pressure = load * MODULUS * GRADIENT;
        let found = solver.solve(&map, Load::MeanPressure(pressure))?;
        let more = solver.solve(&map, Load::MeanPressure(1.02 * pressure))?;
        let gap = found.state.mean_gap.ok_or("no gap")?;
        let stiffness = 0.02f64.ln_1p() * pressure / (gap - more.state.mean_gap.ok_or("no gap")?);
        let _ = write!(rows, "{family},{seed},{load}");
        let area = found.diagnostics.area_fraction_corrected;
        let blocks = blocks(&found.pressure, map.grid(), PARTS).map_or(0.0, |b| b.scatter);
        for value in [area, gap, stiffness, blocks, height] {
            let _ = write!(rows, ",{value:.4e}");
        }
        rows.push('\n');
    }
    Ok(rows)
}
