//! The contact problem in its own units.
//!
//! Heights are counted from the highest point in units of their range `h0`, lengths in units of
//! the finer pixel side `d`, pressures in units of `E* h0 / d`. So `K` has the symbol `2 / |q|`.

use crate::simd::vectorised;
use crate::{Real, SolverError};
use contact_types::{ContactModulus, Grid, HeightMap};
use std::ops::Range;

/// What one unit of the scaled problem is in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Units {
    /// Height of the highest point (m).
    pub(crate) origin: f64,
    /// Heights, displacements and gaps (m).
    pub(crate) height: f64,
    /// Pressures (Pa).
    pub(crate) pressure: f64,
}

impl Units {
    fn scaled<T: Real>(&self, height: f64) -> T {
        T::of((height - self.origin) / self.height)
    }
}

/// A surface pressed against a flat, scaled.
#[derive(Debug, Clone)]
pub(crate) struct Problem<T> {
    /// As given, in metres.
    pub(crate) given: Grid,
    /// Shape as given; the finer pixel side (of the axes with more than one pixel) is 1.
    pub(crate) grid: Grid,
    /// From -1 to 0, row-major. All 0 for a flat surface.
    pub(crate) heights: Vec<T>,
    pub(crate) mean_height: f64,
    pub(crate) units: Units,
}

/// The grid with its finer pixel side as unit of length.
pub(crate) fn scaled_grid(grid: Grid) -> Result<Grid, SolverError> {
    let fine = fine_pixel(grid);
    Grid::new(grid.shape(), grid.pixel().map(|d| d / fine)).map_err(|_| SolverError::Range {
        quantity: "ratio of the pixel sides",
        value: grid.pixel()[0] / grid.pixel()[1],
        way_out: "choose pixels whose sides are more alike",
    })
}

/// Finer pixel side among the axes that have more than one pixel (m).
pub(crate) fn fine_pixel(grid: Grid) -> f64 {
    let sides = grid.shape().into_iter().zip(grid.pixel());
    let fine = sides.filter(|&(n, _)| n > 1).map(|(_, d)| d).fold(f64::INFINITY, f64::min);
    if fine.is_finite() { fine } else { grid.pixel()[0].min(grid.pixel()[1]) }
}

impl<T: Real> Problem<T> {
    pub(crate) fn new(
        surface: &HeightMap,
        scaled: Grid,
        modulus: ContactModulus,
    ) -> Result<Self, SolverError> {
        let raw = surface.heights();
        let [lowest, highest] = crate::fields::range(raw);
        let flat = lowest >= highest;
        let length = fine_pixel(surface.grid());
        let height = if flat { length } else { highest - lowest };
        let pressure = modulus.pascals() * (height / length);
        let units = Units { origin: highest, height, pressure };
        let unusable = |x: f64| !x.is_normal();
        if unusable(height) || unusable(pressure) {
            return Err(SolverError::Range {
                quantity: "range of the heights",
                value: height,
                way_out: "state the heights in metres and the modulus in pascals",
            });
        }
        let heights: Vec<T> = crate::fields::filled(raw.len(), |i| units.scaled(raw[i]));
        let mean_height = crate::fields::mean(&heights);
        Ok(Self { given: surface.grid(), grid: scaled, heights, mean_height, units })
    }

    /// Heights that are scaled already.
    pub(crate) fn unscaled(grid: Grid, heights: Vec<T>) -> Self {
        let mean_height = crate::fields::mean(&heights);
        let units = Units { origin: 0.0, height: 1.0, pressure: 1.0 };
        Self { given: grid, grid, heights, mean_height, units }
    }

    /// Whether `surface` is the one this problem was made from.
    pub(crate) fn is_of(&self, surface: &HeightMap) -> bool {
        let differ = |(h, k): (&f64, &T)| u32::from(self.units.scaled::<T>(*h) != *k);
        let others = |range: Range<usize>| {
            let pairs = surface.heights()[range.clone()].iter().zip(&self.heights[range]);
            vectorised!(pairs.map(differ).sum::<u32>())
        };
        crate::fields::by_blocks(0..self.heights.len(), &others, &|a, b| a + b) == 0
    }

    pub(crate) fn is_flat(&self) -> bool {
        self.heights.iter().all(|h| *h >= T::zero())
    }
}
