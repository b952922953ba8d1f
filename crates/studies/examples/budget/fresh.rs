//! Maps that took no part in fixing any constant of the grid: the nine classes of the study again,
//! made in other ways, on another grid, over wider ranges, from other seeds.

use crate::ensemble::{CLASSES, Class};
use contact_types::{Grid, HeightMap};
use std::error::Error;
use studies::drawing::{bent_by, log_between};
use surface_stats::clean::resample;
use surface_stats::synthesis::{Scale, SelfAffine};
use surface_stats::{Edges, Level, level};

/// Points along each side.
const POINTS: usize = 240;
/// Pixel \[m\].
const PIXEL: f64 = 0.4e-6;
/// Rms gradient before heights are bent, rounded or made noisy \[-\].
const GRADIENT: f64 = 0.25;
/// Maps of each class.
pub(crate) const EACH: usize = 12;
/// Mean pressure over E* h'_rms: between and beyond those of the study.
pub(crate) const LOADS: [f64; 5] = [0.002, 0.008, 0.03, 0.12, 0.45];

/// What one map is made from.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Recipe {
    class: Class,
    pub(crate) name: &'static str,
    pub(crate) hurst: f64,
    /// Shortest wavelength in pixels.
    pub(crate) cutoff: f64,
    /// Roll-off wavelength in pixels.
    pub(crate) rolloff: f64,
    /// What makes the class, from 0 to 1.
    special: f64,
    /// Whether the second way to make the class is taken.
    other: bool,
    seed: u64,
}

/// All recipes, class by class.
pub(crate) fn recipes() -> Vec<Recipe> {
    let mut list = Vec::new();
    for (k, (class, _, name)) in CLASSES.into_iter().enumerate() {
        for i in 0..EACH {
            // Kronecker sequences: even cover of all ranges.
            let t = |root: f64| ((1 + i) as f64 * root.sqrt() + 0.29 * k as f64).fract();
            let cutoff = match class {
                Class::Resolved => log_between(4.0, 20.0, t(2.0)),
                Class::Short => log_between(2.0, 4.0, t(2.0)),
                _ => log_between(2.5, 14.0, t(2.0)),
            };
            let ratio = if class == Class::Cropped { [1.0, 10.0] } else { [1.5, 20.0] };
            let rolloff = POINTS as f64 / log_between(ratio[0], ratio[1], t(3.0));
            list.push(Recipe {
                class,
                name,
                hurst: 0.2 + 0.8 * t(5.0),
                cutoff,
                rolloff: rolloff.max(2.0 * cutoff),
                special: t(7.0),
                other: i % 2 == 1,
                seed: 910_000 + list.len() as u64,
            });
        }
    }
    list
}

impl Recipe {
    /// The map as given (`factor` 1), or the surface through its points on `factor` times as many
    /// along each side.
    pub(crate) fn make(&self, factor: usize) -> Result<HeightMap, Box<dyn Error>> {
        if self.class == Class::Cropped {
            return self.cropped(factor);
        }
        let map = self.given()?;
        let finer = map.grid().shape().map(|n| factor * n);
        Ok(if factor == 1 { map } else { resample(&map, finer, Edges::Periodic)? })
    }

    /// The middle ninth of a larger map, without its plane.
    fn cropped(&self, factor: usize) -> Result<HeightMap, Box<dyn Error>> {
        let n = factor * POINTS;
        let mut whole = self.waves([3 * POINTS, 3 * POINTS], [PIXEL, PIXEL])?;
        if factor > 1 {
            whole = resample(&whole, [3 * n, 3 * n], Edges::Periodic)?;
        }
        let rows = whole.heights().chunks_exact(3 * n).skip(n).take(n);
        let crop = rows.flat_map(|row| row[n..2 * n].iter().copied()).collect();
        let pixel = PIXEL / factor as f64;
        Ok(level(&HeightMap::new(Grid::new([n, n], [pixel, pixel])?, crop)?, Level::Plane)?)
    }

    fn waves(&self, shape: [usize; 2], pixel: [f64; 2]) -> Result<HeightMap, Box<dyn Error>> {
        let recipe = SelfAffine {
            grid: Grid::new(shape, pixel)?,
            hurst: self.hurst,
            rolloff: self.rolloff * PIXEL,
            cutoff: self.cutoff * PIXEL,
            scale: Scale::RmsGradient(GRADIENT),
            seed: self.seed,
            quantise: None,
        };
        Ok(recipe.generate()?)
    }

    fn given(&self) -> Result<HeightMap, Box<dyn Error>> {
        let n = POINTS;
        let square = Grid::new([n, n], [PIXEL, PIXEL])?;
        let plain = || self.waves([n, n], [PIXEL, PIXEL]);
        let map = |heights: Vec<f64>| Ok(HeightMap::new(square, heights)?);
        let relief = GRADIENT * PIXEL;
        match self.class {
            Class::Resolved | Class::Short | Class::Cropped => plain(),
            // Log-normal heights, of either sign.
            Class::Skewed => {
                let s = (0.1 + 0.3 * self.special) * if self.other { -1.0 } else { 1.0 };
                bent_by(&plain()?, |z| (s * z).exp_m1() / s, self.cutoff)
            }
            Class::Tailed => {
                let cubic = log_between(0.01, 0.1, self.special);
                bent_by(&plain()?, |z| z + cubic * z * z * z, self.cutoff)
            }
            // Along x, or along the diagonal.
            Class::Anisotropic => {
                let stretch = log_between(1.3, 10.0, self.special);
                let lay = self.waves([n, n], [PIXEL / stretch, PIXEL])?;
                let shear = usize::from(self.other);
                map((0..n * n).map(|i| lay.at(i / n, (i % n + shear * (i / n)) % n)).collect())
            }
            // Rounded down, so that no level is the mean.
            Class::Stepped => {
                let step = log_between(0.05, 2.0, self.special) * relief;
                map(plain()?.heights().iter().map(|h| (h / step).floor() * step).collect())
            }
            Class::Noisy => {
                let rms = log_between(0.01, 0.4, self.special) * relief;
                let noise = uniform(self.seed, n * n).into_iter().map(|u| rms * 12f64.sqrt() * u);
                map(plain()?.heights().iter().zip(noise).map(|(h, s)| h + s).collect())
            }
            // Pixels longer along x, or along y.
            Class::Oblong => {
                let ratio = log_between(1.1, 2.0, self.special);
                let [dy, dx] = if self.other { [1.0, ratio] } else { [ratio, 1.0] };
                self.waves([n, n], [PIXEL / dy, PIXEL / dx])
            }
        }
    }
}

/// Numbers between -1/2 and 1/2, independent from point to point: white noise.
fn uniform(seed: u64, count: usize) -> Vec<f64> {
    let mut state = seed;
    let mut next = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    (0..count).map(|_| next()).collect()
}
