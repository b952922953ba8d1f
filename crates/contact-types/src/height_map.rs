//! A complete, finite map of heights.

use crate::{Grid, SurfaceError};

/// Heights in metres on a [`Grid`], row-major, positive out of the material.
///
/// Invariant: every height is finite. A measurement with missing points is filled before it
/// becomes a `HeightMap`, so no formula ever meets a NaN.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct HeightMap {
    grid: Grid,
    heights: Vec<f64>,
}

impl HeightMap {
    /// Takes `ny * nx` heights in metres.
    ///
    /// # Errors
    /// [`SurfaceError::Shape`] if their number is wrong, [`SurfaceError::NotFinite`] if one of
    /// them is NaN or infinite.
    pub fn new(grid: Grid, heights: Vec<f64>) -> Result<Self, SurfaceError> {
        if heights.len() != grid.len() {
            return Err(SurfaceError::Shape { expected: grid.len(), found: heights.len() });
        }
        if let Some(first) = heights.iter().position(|h| !h.is_finite()) {
            let nx = grid.shape()[1];
            return Err(SurfaceError::NotFinite {
                iy: first / nx,
                ix: first % nx,
                value: heights[first],
                count: heights.iter().filter(|h| !h.is_finite()).count(),
            });
        }
        Ok(Self { grid, heights })
    }

    /// Samples `height(y, x)` in metres at the pixel positions `y = iy dy`, `x = ix dx`.
    ///
    /// # Errors
    /// [`SurfaceError::NotFinite`] if the function returns NaN or infinity.
    pub fn from_fn(grid: Grid, height: impl Fn(f64, f64) -> f64) -> Result<Self, SurfaceError> {
        let [ny, nx] = grid.shape();
        let [dy, dx] = grid.pixel();
        let mut heights = Vec::with_capacity(grid.len());
        for iy in 0..ny {
            heights.extend((0..nx).map(|ix| height(iy as f64 * dy, ix as f64 * dx)));
        }
        Self::new(grid, heights)
    }

    /// The grid the heights stand on.
    pub fn grid(&self) -> Grid {
        self.grid
    }

    /// The heights in metres, row-major.
    pub fn heights(&self) -> &[f64] {
        &self.heights
    }

    /// The heights in metres, given away.
    pub fn into_heights(self) -> Vec<f64> {
        self.heights
    }

    /// Height of pixel (iy, ix) in metres.
    ///
    /// # Panics
    /// If there is no such pixel.
    pub fn at(&self, iy: usize, ix: usize) -> f64 {
        let [ny, nx] = self.grid.shape();
        // Without the second test a column too far would be read from the next row.
        let is_inside = iy < ny && ix < nx;
        assert!(is_inside, "pixel ({iy}, {ix}) is outside a map of {ny} x {nx} pixels");
        self.heights[iy * nx + ix]
    }

    /// Lowest and highest height in metres.
    pub fn range(&self) -> (f64, f64) {
        self.heights
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), &h| (lo.min(h), hi.max(h)))
    }

    /// Mean height in metres, summed about the first height so that a large common offset costs
    /// no digits.
    pub fn mean(&self) -> f64 {
        let origin = self.heights[0];
        origin + self.heights.iter().map(|h| h - origin).sum::<f64>() / self.heights.len() as f64
    }

    /// True if all heights are equal.
    pub fn is_flat(&self) -> bool {
        let (lo, hi) = self.range();
        lo >= hi
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn says_where_and_how_many_points_are_not_finite() {
        let grid = Grid::new([2, 3], [1.0, 1.0]).unwrap();
        let err = HeightMap::new(grid, vec![0.0, 1.0, 2.0, 3.0, f64::NAN, f64::INFINITY]);
        assert!(matches!(err, Err(SurfaceError::NotFinite { iy: 1, ix: 1, count: 2, .. })));
    }

    #[test]
    fn a_column_too_far_is_not_read_from_the_next_row() {
        let grid = Grid::new([2, 3], [1.0, 1.0]).unwrap();
        let map = HeightMap::new(grid, (0..6).map(f64::from).collect()).unwrap();
        assert!((map.at(1, 2) - 5.0).abs() <= 0.0);
        for (iy, ix) in [(0, 3), (2, 0), (usize::MAX, 1)] {
            assert!(std::panic::catch_unwind(|| map.at(iy, ix)).is_err());
        }
    }

    #[test]
    fn mean_survives_a_large_offset() {
        let grid = Grid::new([1, 4], [1.0, 1.0]).unwrap();
        let h = vec![76e-3 + 1e-9, 76e-3 - 1e-9, 76e-3 + 3e-9, 76e-3 + 1e-9];
        let mean = HeightMap::new(grid, h).unwrap().mean();
        assert!((mean - (76e-3 + 1e-9)).abs() < 2e-17);
    }
}
