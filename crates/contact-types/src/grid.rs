//! A regular grid of rectangular pixels and its wavenumbers.

use crate::{Named, SurfaceError};
use std::f64::consts::TAU;

/// `[ny, nx]` pixels of `[dy, dx]` metres. The cell that repeats in periodic calculations is
/// `ny dy` by `nx dx`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Grid {
    shape: [usize; 2],
    pixel: [f64; 2],
}

impl Grid {
    /// Makes a grid of `shape = [ny, nx]` pixels, each `pixel = [dy, dx]` metres.
    ///
    /// # Errors
    /// [`SurfaceError::EmptyGrid`], [`SurfaceError::GridTooLarge`] or
    /// [`SurfaceError::BadPixel`].
    pub fn new(shape: [usize; 2], pixel: [f64; 2]) -> Result<Self, SurfaceError> {
        let [ny, nx] = shape;
        if ny == 0 || nx == 0 {
            return Err(SurfaceError::EmptyGrid(shape));
        }
        if ny.checked_mul(nx).is_none_or(|n| n > isize::MAX as usize / 16) {
            return Err(SurfaceError::GridTooLarge(shape));
        }
        for (axis, value) in ['y', 'x'].into_iter().zip(pixel) {
            if !value.is_normal() || value < 0.0 {
                return Err(SurfaceError::BadPixel { axis, value });
            }
        }
        Ok(Self { shape, pixel })
    }

    /// `[ny, nx]`.
    pub fn shape(&self) -> [usize; 2] {
        self.shape
    }

    /// `[dy, dx]` in metres.
    pub fn pixel(&self) -> [f64; 2] {
        self.pixel
    }

    /// Number of pixels, `ny nx`.
    #[allow(clippy::len_without_is_empty, reason = "a Grid is never empty")]
    pub fn len(&self) -> usize {
        self.shape[0] * self.shape[1]
    }

    /// `[ny dy, nx dx]`: the sides of the cell in metres.
    pub fn size(&self) -> [f64; 2] {
        [self.shape[0] as f64 * self.pixel[0], self.shape[1] as f64 * self.pixel[1]]
    }

    /// Nominal area of the cell in m².
    pub fn area(&self) -> f64 {
        let [ly, lx] = self.size();
        ly * lx
    }

    /// Wave vector `[qy, qx]` in rad/m of the Fourier coefficient (iy, ix).
    ///
    /// `iy` runs over `0..ny`; `ix` over `0..nx`, or over the half spectrum `0..=nx/2` that a
    /// real transform keeps: both number the same waves. Indices above the Nyquist frequency
    /// stand for negative wavenumbers.
    pub fn wave_vector(&self, iy: usize, ix: usize) -> [f64; 2] {
        let [ly, lx] = self.size();
        let signed = |i: usize, n: usize| {
            if 2 * i <= n { i as f64 } else { i as f64 - n as f64 }
        };
        [TAU * signed(iy, self.shape[0]) / ly, TAU * signed(ix, self.shape[1]) / lx]
    }

    /// Length of [`wave_vector`](Self::wave_vector): angular wavenumber |q| in rad/m.
    pub fn wavenumber(&self, iy: usize, ix: usize) -> f64 {
        let [qy, qx] = self.wave_vector(iy, ix);
        qy.hypot(qx)
    }
}

/// A direction in the plane of a map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum Axis {
    /// Along a row, from the first column to the last.
    X,
    /// Along a column, from the first row to the last.
    Y,
}

impl Named for Axis {
    const NAMES: &'static [(Self, &'static str)] = &[(Self::X, "x"), (Self::Y, "y")];
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nyquist_and_negative_waves_of_odd_and_even_sides() {
        let g = Grid::new([5, 4], [1.0, 0.5]).unwrap();
        // nx = 4, Lx = 2 m: ix = 2 is Nyquist, pi/dx; ix = 3 is minus one wave per cell.
        assert!((g.wave_vector(0, 2)[1] - TAU).abs() < 1e-15);
        assert!((g.wave_vector(0, 3)[1] + TAU / 2.0).abs() < 1e-15);
        assert!((g.wave_vector(3, 0)[0] + TAU * 2.0 / 5.0).abs() < 1e-15);
    }

    #[test]
    fn refuses_what_is_no_grid() {
        assert!(matches!(Grid::new([0, 3], [1.0, 1.0]), Err(SurfaceError::EmptyGrid { .. })));
        assert!(matches!(
            Grid::new([usize::MAX, 3], [1.0, 1.0]),
            Err(SurfaceError::GridTooLarge { .. })
        ));
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-310] {
            assert!(matches!(
                Grid::new([2, 2], [1.0, bad]),
                Err(SurfaceError::BadPixel { axis: 'x', .. })
            ));
        }
    }
}
