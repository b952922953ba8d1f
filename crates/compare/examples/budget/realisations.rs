//! Families of surfaces: realisations of one spectrum, and what one of them says of the others.

use compare::budget::sample::{PARTS, area_scatter, moment_scatter};
use contact_types::{ContactModulus, Grid};
use fft_bem_solver::{Load, Solver};
use std::error::Error;
use std::fmt::Write as _;
use surface_stats::spectrum::{PowerSpectrum, Window};
use surface_stats::synthesis::{Scale, SelfAffine};

/// Points along each side.
const POINTS: usize = 256;
const PIXEL: f64 = 1e-6;
const GRADIENT: f64 = 0.1;
const MODULUS: f64 = 1e11;
/// Mean pressure over E* times the rms gradient expected.
const LOADS: [f64; 4] = [0.003, 0.01, 0.05, 0.2];
/// Realisations of a family.
pub(crate) const REALISATIONS: usize = 30;

/// Hurst exponent, shortest and roll-off wavelength in points. The first twelve calibrate, the
/// others check.
pub(crate) const FAMILIES: [[f64; 3]; 20] = [
    [0.3, 4.0, 64.0],
    [0.3, 8.0, 32.0],
    [0.3, 8.0, 128.0],
    [0.5, 4.0, 16.0],
    [0.5, 8.0, 64.0],
    [0.5, 16.0, 128.0],
    [0.8, 4.0, 32.0],
    [0.8, 8.0, 16.0],
    [0.8, 8.0, 64.0],
    [0.8, 4.0, 256.0],
    [0.9, 16.0, 64.0],
    [0.9, 4.0, 128.0],
    [0.4, 6.0, 48.0],
    [0.4, 12.0, 96.0],
    [0.7, 4.0, 24.0],
    [0.7, 6.0, 96.0],
    [0.8, 8.0, 128.0],
    [0.9, 8.0, 32.0],
    [0.6, 4.0, 200.0],
    [0.85, 16.0, 40.0],
];

pub(crate) fn header() -> &'static str {
    "family,seed,load,area,gap,stiffness,blocks,height"
}

/// The rows of one realisation, one per load.
pub(crate) fn realisation(family: usize, seed: usize) -> Result<String, Box<dyn Error>> {
    let [hurst, cutoff, rolloff] = FAMILIES[family];
    let grid = Grid::new([POINTS, POINTS], [PIXEL, PIXEL])?;
    let map = SelfAffine {
        grid,
        hurst,
        rolloff: rolloff * PIXEL,
        cutoff: cutoff * PIXEL,
        scale: Scale::ExpectedRmsGradient(GRADIENT),
        seed: (20_000 + 1000 * family + seed) as u64,
        quantise: None,
    }
    .generate()?;
    let modulus = ContactModulus::from_pascals(MODULUS)?;
    let mut solver = Solver::builder().tolerance(1e-5).threads(1).build(grid, modulus)?;
    let [height, _] = moment_scatter(&PowerSpectrum::of(&map, Window::None)?);
    let mut rows = String::new();
    for load in LOADS {
        let pressure = load * MODULUS * GRADIENT;
        let found = solver.solve(&map, Load::MeanPressure(pressure))?;
        let more = solver.solve(&map, Load::MeanPressure(1.02 * pressure))?;
        let gap = found.state.mean_gap.ok_or("no gap")?;
        let stiffness = 0.02f64.ln_1p() * pressure / (gap - more.state.mean_gap.ok_or("no gap")?);
        let _ = write!(rows, "{family},{seed},{load}");
        let area = found.diagnostics.area_fraction_corrected;
        let blocks = area_scatter(&found.pressure, grid, PARTS).unwrap_or(0.0);
        for value in [area, gap, stiffness, blocks, height] {
            let _ = write!(rows, ",{value:.4e}");
        }
        rows.push('\n');
    }
    Ok(rows)
}
