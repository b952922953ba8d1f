//! Planned row and column transforms.

use crate::float::{Float, Plans};
use rustfft::Fft;
use rustfft::num_complex::Complex;
use std::sync::Arc;

/// How many columns are gathered at a time, so that a cache line is used whole.
const COLUMN_BLOCK: usize = 8;

/// A planned transform for fields of `ny * nx` real numbers. Plan once, run many: running
/// allocates nothing.
pub struct GridFft<T: Float> {
    shape: [usize; 2],
    plans: Plans<T>,
    real_row: Vec<T>,
    columns: Vec<Complex<T>>,
    scratch: Vec<Complex<T>>,
}

impl<T: Float> std::fmt::Debug for GridFft<T> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("GridFft").field("shape", &self.shape).finish_non_exhaustive()
    }
}

impl<T: Float> GridFft<T> {
    /// Plans transforms for `shape = [ny, nx]`.
    ///
    /// # Panics
    /// If a side is 0.
    pub fn new(shape: [usize; 2]) -> Self {
        let [ny, nx] = shape;
        assert!(ny > 0 && nx > 0, "a transform needs at least one pixel along each axis");
        let plans = T::plan(shape);
        let scratch = plans.scratch_len();
        let zero = Complex::new(T::zero(), T::zero());
        Self {
            shape,
            plans,
            real_row: vec![T::zero(); nx],
            columns: vec![zero; ny * COLUMN_BLOCK],
            scratch: vec![zero; scratch],
        }
    }

    /// Shape of the field, `[ny, nx]`.
    pub fn shape(&self) -> [usize; 2] {
        self.shape
    }

    /// Shape of the half spectrum, `[ny, nx/2 + 1]`.
    pub fn spectrum_shape(&self) -> [usize; 2] {
        [self.shape[0], self.shape[1] / 2 + 1]
    }

    /// A spectrum of zeros.
    pub fn new_spectrum(&self) -> Vec<Complex<T>> {
        let [ny, nq] = self.spectrum_shape();
        vec![Complex::new(T::zero(), T::zero()); ny * nq]
    }

    /// `spectrum[ky, kx] = sum field[iy, ix] exp(-i (qy y + qx x))`, for `kx` in `0..=nx/2`.
    ///
    /// # Panics
    /// If a slice does not have the length planned for.
    pub fn forward(&mut self, field: &[T], spectrum: &mut [Complex<T>]) {
        let [ny, nx] = self.shape;
        let nq = nx / 2 + 1;
        assert!(field.len() == ny * nx && spectrum.len() == ny * nq, "field or spectrum length");
        for (row, wave) in field.chunks_exact(nx).zip(spectrum.chunks_exact_mut(nq)) {
            self.real_row.copy_from_slice(row);
            self.plans
                .row_forward
                .process_with_scratch(&mut self.real_row, wave, &mut self.scratch)
                .expect("lengths are as planned");
        }
        self.transform_columns(spectrum, &self.plans.column_forward.clone());
    }

    /// The inverse of [`forward`](Self::forward), with its factor 1/(ny nx). The spectrum is
    /// used as scratch and left undefined.
    ///
    /// # Panics
    /// If a slice does not have the length planned for.
    pub fn inverse(&mut self, spectrum: &mut [Complex<T>], field: &mut [T]) {
        let [ny, nx] = self.shape;
        let nq = nx / 2 + 1;
        assert!(field.len() == ny * nx && spectrum.len() == ny * nq, "field or spectrum length");
        self.transform_columns(spectrum, &self.plans.column_inverse.clone());
        let scale = T::one() / T::from_usize(ny * nx).expect("a pixel count fits a float");
        for (wave, row) in spectrum.chunks_exact_mut(nq).zip(field.chunks_exact_mut(nx)) {
            // The coefficients that a real row makes real; rounding left a trace of imaginary part.
            wave[0].im = T::zero();
            if nx % 2 == 0 {
                wave[nq - 1].im = T::zero();
            }
            self.plans
                .row_inverse
                .process_with_scratch(wave, row, &mut self.scratch)
                .expect("lengths are as planned and the ends are real");
            for value in row {
                *value = *value * scale;
            }
        }
    }

    fn transform_columns(&mut self, spectrum: &mut [Complex<T>], fft: &Arc<dyn Fft<T>>) {
        let [ny, nq] = self.spectrum_shape();
        for first in (0..nq).step_by(COLUMN_BLOCK) {
            let width = COLUMN_BLOCK.min(nq - first);
            for (iy, row) in spectrum.chunks_exact(nq).enumerate() {
                for (k, &value) in row[first..first + width].iter().enumerate() {
                    self.columns[k * ny + iy] = value;
                }
            }
            fft.process_with_scratch(&mut self.columns[..width * ny], &mut self.scratch);
            for (iy, row) in spectrum.chunks_exact_mut(nq).enumerate() {
                for (k, value) in row[first..first + width].iter_mut().enumerate() {
                    *value = self.columns[k * ny + iy];
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::f64::consts::TAU;

    proptest! {
        /// Against the defining sum, on any small grid, and back again.
        #[test]
        fn equals_the_defining_sum(ny in 1usize..13, nx in 1usize..13, seed in 0u64..1000) {
            let value = |i: usize| ((i as f64 + 1.3) * (seed as f64 + 0.7) * 12.9898).sin();
            let field: Vec<f64> = (0..ny * nx).map(value).collect();
            let mut fft = GridFft::new([ny, nx]);
            let mut spectrum = fft.new_spectrum();
            fft.forward(&field, &mut spectrum);
            let nq = nx / 2 + 1;
            for ky in 0..ny {
                for kx in 0..nq {
                    let mut sum = Complex::new(0.0, 0.0);
                    for iy in 0..ny {
                        for ix in 0..nx {
                            let turns = (ky * iy) as f64 / ny as f64 + (kx * ix) as f64 / nx as f64;
                            sum += field[iy * nx + ix] * Complex::from_polar(1.0, -TAU * turns);
                        }
                    }
                    prop_assert!((sum - spectrum[ky * nq + kx]).norm() < 1e-12 * (ny * nx) as f64);
                }
            }
            let mut back = vec![0.0; ny * nx];
            fft.inverse(&mut spectrum, &mut back);
            for (a, b) in field.iter().zip(&back) {
                prop_assert!((a - b).abs() < 1e-13);
            }
        }
    }
}
