//! The surfaces of the study: 256 x 256 points of about 1 um, rms gradient near 0.1, in classes,
//! drawn by low-discrepancy sequences, so that any first part of a class covers its ranges.

use contact_types::{Grid, HeightMap};
use std::error::Error;
use studies::drawing::{bent, log_between, van_der_corput};
use surface_stats::clean::resample;
use surface_stats::synthesis::{Scale, SelfAffine};
use surface_stats::{Edges, Level, level};

/// Points along each side.
pub(crate) const POINTS: usize = 256;
/// Pixel \[m\].
const PIXEL: f64 = 1e-6;
/// Rms gradient before heights are bent, rounded or made noisy \[-\].
const GRADIENT: f64 = 0.1;

/// How a surface was made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Class {
    /// Isotropic, Gaussian, shortest waves of at least 4 points.
    Resolved,
    /// Isotropic, Gaussian, shortest waves of 2 to 4 points.
    Short,
    /// Heights bent to positive or negative skewness.
    Skewed,
    /// Heights with heavy tails.
    Tailed,
    /// With a lay.
    Anisotropic,
    /// Heights rounded to steps.
    Stepped,
    /// White noise on top.
    Noisy,
    /// Cut from a larger map, levelled, edges that do not match.
    Cropped,
    /// Pixels of unequal sides.
    Oblong,
}

/// How many of each class, and its name in the table.
pub(crate) const CLASSES: [(Class, usize, &str); 9] = [
    (Class::Resolved, 32, "resolved"),
    (Class::Short, 16, "short waves"),
    (Class::Skewed, 14, "skewed"),
    (Class::Tailed, 12, "heavy tails"),
    (Class::Anisotropic, 14, "with a lay"),
    (Class::Stepped, 16, "stepped"),
    (Class::Noisy, 14, "noisy"),
    (Class::Cropped, 16, "cropped"),
    (Class::Oblong, 10, "oblong pixels"),
];

/// What one surface is made from.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Recipe {
    pub(crate) class: Class,
    pub(crate) name: &'static str,
    pub(crate) hurst: f64,
    /// Shortest wavelength in pixels.
    pub(crate) cutoff: f64,
    /// Roll-off wavelength in pixels.
    pub(crate) rolloff: f64,
    /// What makes the class, in its own measure.
    strength: f64,
    seed: u64,
}

/// All recipes, class by class.
pub(crate) fn recipes() -> Vec<Recipe> {
    let mut list = Vec::new();
    for (class, count, name) in CLASSES {
        for i in 1..=count {
            list.push(recipe(class, name, i, 5000 + list.len() as u64));
        }
    }
    list
}

fn recipe(class: Class, name: &'static str, i: usize, seed: u64) -> Recipe {
    let [a, b, c, d] = [2, 3, 5, 7].map(|base| van_der_corput(i, base));
    let cutoff = match class {
        Class::Resolved => log_between(4.0, 16.0, b),
        Class::Short => log_between(2.0, 4.0, b),
        _ => log_between(2.5, 12.0, b),
    };
    let rolloff = match class {
        Class::Cropped => POINTS as f64 / log_between(1.0, 8.0, c),
        _ => (POINTS as f64 / log_between(2.0, 16.0, c)).max(2.0 * cutoff),
    };
    let strength = match class {
        Class::Resolved | Class::Short | Class::Cropped => 0.0,
        Class::Skewed => 1.2 * d - 0.6,
        Class::Tailed => log_between(0.65, 0.95, d),
        Class::Anisotropic => log_between(1.3, 8.0, d),
        Class::Stepped => log_between(0.05, 2.0, d),
        Class::Noisy => log_between(0.01, 0.4, d),
        Class::Oblong => log_between(1.1, 2.0, d),
    };
    Recipe { class, name, hurst: 0.3 + 0.6 * a, cutoff, rolloff, strength, seed }
}

/// The map of a recipe as a user would give it to the solver (`factor` 1), or the surface through
/// its points on `factor` times as many along each side. A map that repeats is band-limited, so
/// that these are fixed by it; of a crop they are cut from its larger map, which knows what lies
/// between the points next to the seam.
pub(crate) fn make(recipe: &Recipe, factor: usize) -> Result<HeightMap, Box<dyn Error>> {
    if recipe.class == Class::Cropped {
        return cropped(recipe, factor);
    }
    let map = given(recipe)?;
    let [ny, nx] = map.grid().shape();
    Ok(if factor == 1 { map } else { resample(&map, [factor * ny, factor * nx], Edges::Periodic)? })
}

fn cropped(recipe: &Recipe, factor: usize) -> Result<HeightMap, Box<dyn Error>> {
    let large = Grid::new([2 * POINTS, 2 * POINTS], [PIXEL, PIXEL])?;
    let (n, pixel) = (factor * POINTS, PIXEL / factor as f64);
    let mut whole = waves(recipe, large, recipe.seed).generate()?;
    if factor > 1 {
        whole = resample(&whole, [2 * n, 2 * n], Edges::Periodic)?;
    }
    let rows = whole.heights().chunks_exact(2 * n).take(n);
    let crop = rows.flat_map(|row| row[..n].iter().copied()).collect();
    Ok(level(&HeightMap::new(Grid::new([n, n], [pixel, pixel])?, crop)?, Level::Plane)?)
}

fn waves(recipe: &Recipe, grid: Grid, seed: u64) -> SelfAffine {
    SelfAffine {
        grid,
        hurst: recipe.hurst,
        rolloff: recipe.rolloff * PIXEL,
        cutoff: recipe.cutoff * PIXEL,
        scale: Scale::RmsGradient(GRADIENT),
        seed,
        quantise: None,
    }
}

fn given(recipe: &Recipe) -> Result<HeightMap, Box<dyn Error>> {
    let square = Grid::new([POINTS, POINTS], [PIXEL, PIXEL])?;
    let waves = |grid, seed| waves(recipe, grid, seed);
    Ok(match recipe.class {
        Class::Resolved | Class::Short | Class::Cropped => waves(square, recipe.seed).generate()?,
        Class::Skewed => {
            bent(&waves(square, recipe.seed).generate()?, recipe.strength, 1.0, recipe.cutoff)?
        }
        Class::Tailed => {
            bent(&waves(square, recipe.seed).generate()?, 0.0, recipe.strength, recipe.cutoff)?
        }
        Class::Anisotropic => {
            // Made on pixels that are short in y, then called square: lengths along y come out
            // longer.
            let made = Grid::new([POINTS, POINTS], [PIXEL / recipe.strength, PIXEL])?;
            HeightMap::new(square, waves(made, recipe.seed).generate()?.into_heights())?
        }
        Class::Stepped => {
            let step = recipe.strength * PIXEL * GRADIENT;
            SelfAffine { quantise: Some(step), ..waves(square, recipe.seed) }.generate()?
        }
        Class::Noisy => {
            let map = waves(square, recipe.seed).generate()?;
            // Waves of all lengths down to two points with a flat spectrum.
            let noise = SelfAffine {
                cutoff: 2.0 * PIXEL,
                rolloff: 2.0 * PIXEL,
                scale: Scale::RmsHeight(recipe.strength * GRADIENT * PIXEL),
                ..waves(square, recipe.seed + 100_000)
            }
            .generate()?;
            let sum = map.heights().iter().zip(noise.heights()).map(|(h, n)| h + n).collect();
            HeightMap::new(square, sum)?
        }
        Class::Oblong => {
            let grid = Grid::new([POINTS, POINTS], [PIXEL, PIXEL / recipe.strength])?;
            waves(grid, recipe.seed).generate()?
        }
    })
}
