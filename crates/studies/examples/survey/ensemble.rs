//! The surfaces of the survey: 256 x 256 points of 1 um, rms gradient near 0.1, drawn from four
//! families by low-discrepancy sequences, so that any first part of the list covers the ranges.

use compare::survey::Family;
use contact_types::{Grid, HeightMap};
use std::error::Error;
use studies::drawing::{bent, log_between, van_der_corput};
use surface_stats::Edges;
use surface_stats::clean::resample;
use surface_stats::synthesis::{Scale, SelfAffine};

/// Points along each side.
pub(crate) const POINTS: usize = 256;
/// Pixel \[m\].
pub(crate) const PIXEL: f64 = 1e-6;
/// Rms gradient before heights are bent or rounded \[-\].
const GRADIENT: f64 = 0.1;

/// What one surface is made from.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Recipe {
    pub(crate) family: Family,
    pub(crate) hurst: f64,
    /// Shortest wavelength in pixels.
    pub(crate) cutoff: f64,
    /// Roll-off wavelength in pixels.
    pub(crate) rolloff: f64,
    /// Ratio of correlation lengths along y and x.
    pub(crate) stretch: f64,
    /// Shift inside the inverse hyperbolic sine: positive bends heights up (positive skewness).
    pub(crate) bend: f64,
    /// Exponent of the tails: above 1 lighter than Gaussian, below 1 heavier.
    pub(crate) tails: f64,
    /// Height step over pixel and rms gradient; 0 for none.
    pub(crate) step: f64,
    pub(crate) seed: u64,
}

/// How many of each family.
const COUNTS: [(Family, usize); 4] = [
    (Family::Gaussian, 120),
    (Family::Skewed, 48),
    (Family::Anisotropic, 36),
    (Family::Stepped, 36),
];

/// All recipes.
pub(crate) fn recipes() -> Vec<Recipe> {
    let mut list = Vec::new();
    for (family, count) in COUNTS {
        for i in 1..=count {
            list.push(recipe(family, i, list.len() as u64 + 1));
        }
    }
    list
}

fn recipe(family: Family, i: usize, seed: u64) -> Recipe {
    let [a, b, c, d, e] = [2, 3, 5, 7, 11].map(|base| van_der_corput(i, base));
    let cutoff = log_between(2.0, 16.0, b);
    // At least 2 roll-off wavelengths per side, at most 20, and never below twice the cut-off.
    let rolloff = (POINTS as f64 / log_between(2.0, 20.0, c)).max(2.0 * cutoff);
    let plain = Recipe {
        family,
        hurst: 0.2 + 0.75 * a,
        cutoff,
        rolloff,
        stretch: 1.0,
        bend: 0.0,
        tails: 1.0,
        step: 0.0,
        seed,
    };
    match family {
        Family::Gaussian => plain,
        Family::Skewed => Recipe { bend: 1.2 * d - 0.6, tails: log_between(0.75, 1.4, e), ..plain },
        Family::Anisotropic => Recipe { stretch: log_between(1.3, 8.0, d), ..plain },
        Family::Stepped => Recipe { step: log_between(0.05, 2.0, d), ..plain },
    }
}

/// The map of a recipe and the same map on twice as many points, which has no steps.
pub(crate) fn make(recipe: &Recipe) -> Result<[HeightMap; 2], Box<dyn Error>> {
    // A lay along x: the map is made on pixels that are short in y, then called square, so that
    // lengths along y come out `stretch` times longer.
    let made = Grid::new([POINTS, POINTS], [PIXEL / recipe.stretch, PIXEL])?;
    let shortest = recipe.cutoff.max(2.0);
    let map = SelfAffine {
        grid: made,
        hurst: recipe.hurst,
        rolloff: recipe.rolloff * PIXEL,
        cutoff: shortest * PIXEL,
        scale: Scale::RmsGradient(GRADIENT),
        seed: recipe.seed,
        quantise: None,
    }
    .generate()?;
    let square = Grid::new([POINTS, POINTS], [PIXEL, PIXEL])?;
    let mut map = HeightMap::new(square, map.into_heights())?;
    if recipe.family == Family::Skewed {
        map = bent(&map, recipe.bend, recipe.tails, shortest)?;
    }
    let fine = resample(&map, [2 * POINTS, 2 * POINTS], Edges::Periodic)?;
    if recipe.step > 0.0 {
        let step = recipe.step * PIXEL * GRADIENT;
        let rounded = map.heights().iter().map(|h| (h / step).round() * step).collect();
        map = HeightMap::new(square, rounded)?;
    }
    Ok([map, fine])
}
