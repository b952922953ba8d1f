//! Planned row and column transforms.

use crate::float::{Float, Plans};
use crate::rows::RowScratch;
use rustfft::Fft;
use rustfft::num_complex::Complex;
use std::sync::Arc;

/// How many columns are gathered at a time, so that a cache line is used whole.
const COLUMN_BLOCK: usize = 8;

/// A planned transform for fields of `ny * nx` real numbers. Plan once, run many: running
/// allocates nothing.
pub struct GridFft {
    shape: [usize; 2],
    plans: Plans<f64>,
    rows: RowScratch<f64>,
    /// Two rows.
    pair: Vec<f64>,
    columns: Vec<Complex<f64>>,
    scratch: Vec<Complex<f64>>,
}

impl std::fmt::Debug for GridFft {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("GridFft").field("shape", &self.shape).finish_non_exhaustive()
    }
}

impl GridFft {
    /// Plans transforms for `shape = [ny, nx]`.
    ///
    /// # Panics
    /// If a side is 0.
    pub fn new(shape: [usize; 2]) -> Self {
        let [ny, nx] = shape;
        assert!(ny > 0 && nx > 0, "a transform needs at least one pixel along each axis");
        let plans = f64::plan(shape);
        let scratch = plans.column_scratch_len();
        let zero = Complex::new(0.0, 0.0);
        Self {
            shape,
            rows: plans.rows.scratch(),
            pair: vec![0.0; 2 * nx],
            plans,
            columns: vec![zero; ny * COLUMN_BLOCK],
            scratch: vec![zero; scratch],
        }
    }

    /// Shape of the half spectrum, `[ny, nx/2 + 1]`.
    fn spectrum_shape(&self) -> [usize; 2] {
        [self.shape[0], self.shape[1] / 2 + 1]
    }

    /// A spectrum of zeros.
    pub fn new_spectrum(&self) -> Vec<Complex<f64>> {
        let [ny, nq] = self.spectrum_shape();
        vec![Complex::new(0.0, 0.0); ny * nq]
    }

    /// `spectrum[ky, kx] = sum field[iy, ix] exp(-i (qy y + qx x))`, for `kx` in `0..=nx/2`.
    ///
    /// # Panics
    /// If a slice does not have the length planned for.
    pub fn forward(&mut self, field: &[f64], spectrum: &mut [Complex<f64>]) {
        let [ny, nx] = self.shape;
        let nq = nx / 2 + 1;
        assert!(field.len() == ny * nx && spectrum.len() == ny * nq, "field or spectrum length");
        self.forward_rows(|iy, row| row.copy_from_slice(&field[iy * nx..(iy + 1) * nx]), spectrum);
    }

    /// The same of a field of which `row` writes one row, by its index, at a time.
    ///
    /// # Panics
    /// If the spectrum does not have the length planned for.
    pub fn forward_rows(
        &mut self,
        mut row: impl FnMut(usize, &mut [f64]),
        spectrum: &mut [Complex<f64>],
    ) {
        let ([ny, nq], nx) = (self.spectrum_shape(), self.shape[1]);
        assert!(spectrum.len() == ny * nq, "spectrum length");
        for (k, waves) in spectrum.chunks_mut(2 * nq).enumerate() {
            let rows = &mut self.pair[..waves.len() / nq * nx];
            rows.chunks_exact_mut(nx).enumerate().for_each(|(i, own)| row(2 * k + i, own));
            self.plans.rows.forward(rows, waves, &mut self.rows);
        }
        self.transform_columns(spectrum, &self.plans.column_forward.clone());
    }

    /// The inverse of [`forward`](Self::forward), with its factor 1/(ny nx). The spectrum is
    /// used as scratch and left undefined.
    ///
    /// # Panics
    /// If a slice does not have the length planned for.
    pub fn inverse(&mut self, spectrum: &mut [Complex<f64>], field: &mut [f64]) {
        let [ny, nx] = self.shape;
        let nq = nx / 2 + 1;
        assert!(field.len() == ny * nx && spectrum.len() == ny * nq, "field or spectrum length");
        self.transform_columns(spectrum, &self.plans.column_inverse.clone());
        let scale = 1.0 / (ny * nx) as f64;
        // By pairs of rows, scaled while they are in cache.
        for (waves, rows) in spectrum.chunks_mut(2 * nq).zip(field.chunks_mut(2 * nx)) {
            self.plans.rows.inverse(waves, rows, &mut self.rows);
            for value in rows {
                *value *= scale;
            }
        }
    }

    fn transform_columns(&mut self, spectrum: &mut [Complex<f64>], fft: &Arc<dyn Fft<f64>>) {
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
