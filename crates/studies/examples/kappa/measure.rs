//! The maps of the study and the deterministic solution of each over the loads.

use contact_types::{ContactModulus, Grid, HeightMap};
use fft_bem_solver::reference::full_contact;
use fft_bem_solver::{BOUNDARY_CORRECTION, Load, Solver};
use std::error::Error;
use studies::light_load::Row;
use surface_stats::Edges;
use surface_stats::clean::resample;
use surface_stats::spectrum::{PowerSpectrum, Window};
use surface_stats::synthesis::{Scale, SelfAffine};

/// Contact modulus \[Pa\], point spacing \[m\] and rms gradient \[-\]; every ratio is free of them.
const MODULUS: f64 = 1e11;
const PIXEL: f64 = 1e-6;
const GRADIENT: f64 = 0.1;
/// Relative rms pressure error to reach.
const TOLERANCE: f64 = 1e-5;
/// Part of the contact-line correction that is left as uncertainty.
const LEFT_OVER: f64 = 0.3;

/// Loads p/(E* g) of every map: areas of about 0.5 to 18 %.
const RISING: [f64; 9] = [0.0025, 0.004, 0.0063, 0.01, 0.016, 0.025, 0.04, 0.063, 0.1];
/// Further loads of the maps followed to full contact.
const HEAVY: [f64; 9] = [0.2, 0.4, 0.6, 0.8, 1.0, 1.2, 1.4, 1.6, 1.8];
/// And two beside the load that closes the last gap, as parts of it.
const BESIDE: [f64; 2] = [0.999, 1.001];

/// One map and what is asked of it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Case {
    pub(crate) periods: usize,
    pub(crate) breadth: usize,
    /// Points per shortest wavelength the map is made with.
    pub(crate) pixels: usize,
    /// And solved with: the same map on another grid, by Fourier interpolation.
    pub(crate) solved: usize,
    pub(crate) hurst: f64,
    pub(crate) seed: u64,
    pub(crate) to_full_contact: bool,
}

/// Kinds of which one map, with H = 0.8, is also solved on other grids.
const REFINED: [(usize, usize); 2] = [(8, 8), (2, 32)];

/// Every case, in the order of the table: 1024 x 1024 points and one kind of 2048 x 2048, then
/// the maps solved on other grids.
pub(crate) fn cases() -> Vec<Case> {
    let mut list = Vec::new();
    let mut add = |[periods, breadth, pixels]: [usize; 3], hurst: f64, maps: u64| {
        for seed in 1..=maps {
            list.push(Case {
                periods,
                breadth,
                pixels,
                solved: pixels,
                hurst,
                seed,
                to_full_contact: pixels == 16
                    && [(8, 8), (4, 16)].contains(&(periods, breadth))
                    && seed <= 3,
            });
        }
    };
    // Without a self-affine range the Hurst exponent has no meaning.
    add([64, 1, 16], 0.8, 8);
    for hurst in [0.3, 0.5, 0.8] {
        for [periods, breadth] in [[32, 2], [16, 4], [8, 8], [4, 16], [2, 32], [1, 64]] {
            add([periods, breadth, 16], hurst, 8);
        }
    }
    for hurst in [0.3, 0.5, 0.8] {
        for [periods, breadth] in [[2, 64], [1, 128]] {
            add([periods, breadth, 8], hurst, 5);
        }
    }
    add([1, 256, 8], 0.8, 5);
    for (periods, breadth) in REFINED {
        for solved in [8, 32] {
            list.push(Case {
                periods,
                breadth,
                pixels: 16,
                solved,
                hurst: 0.8,
                seed: 1,
                to_full_contact: false,
            });
        }
    }
    list
}

impl Case {
    fn map(&self) -> Result<HeightMap, Box<dyn Error>> {
        let points = self.periods * self.breadth * self.pixels;
        let recipe = SelfAffine {
            grid: Grid::new([points; 2], [PIXEL; 2])?,
            hurst: self.hurst,
            rolloff: (points / self.periods) as f64 * PIXEL,
            cutoff: self.pixels as f64 * PIXEL,
            scale: Scale::RmsGradient(GRADIENT),
            seed: self.seed,
            quantise: None,
        };
        let map = recipe.generate()?;
        if self.solved == self.pixels {
            return Ok(map);
        }
        Ok(resample(&map, [self.periods * self.breadth * self.solved; 2], Edges::Periodic)?)
    }

    /// Its rows.
    pub(crate) fn solve(&self) -> Result<Vec<Row>, Box<dyn Error>> {
        let map = self.map()?;
        let modulus = ContactModulus::from_pascals(MODULUS)?;
        let (moments, _) = PowerSpectrum::of(&map, Window::None)?.moments();
        let unit = MODULUS * moments.rms_gradient();
        let closing = full_contact::pressure(&map, modulus)?.1 / unit;
        let mut loads = RISING.to_vec();
        if self.to_full_contact {
            loads.extend(HEAVY.iter().filter(|x| **x < 0.99 * closing));
            loads.extend(BESIDE.map(|part| part * closing));
        }
        let mut solver =
            Solver::builder().tolerance(TOLERANCE).threads(2).build(map.grid(), modulus)?;
        loads
            .into_iter()
            .map(|load| {
                let solution = solver.solve(&map, Load::MeanPressure(load * unit))?;
                let found = &solution.diagnostics;
                Ok(Row {
                    periods: self.periods,
                    breadth: self.breadth,
                    pixels: self.solved,
                    hurst: self.hurst,
                    seed: self.seed,
                    bandwidth: moments.bandwidth(),
                    closing,
                    load,
                    area: found.area_fraction_corrected,
                    grid: LEFT_OVER * BOUNDARY_CORRECTION * found.contact_perimeter,
                    gap: solution.state.mean_gap.ok_or("no mean gap")? / moments.rms_height(),
                })
            })
            .collect()
    }
}
