//! Field to field through the spectrum, in three passes over memory.

use crate::float::{Float, Plans};
use crate::parallel::prelude::*;
use crate::parallel::{for_each_index, thread_index, threads};
use rustfft::num_complex::Complex;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Rows transformed together; also the height of a tile.
const TILE_ROWS: usize = 16;

/// Multiplies the spectrum of a field by a real symbol that is even in the wave vector.
///
/// The three passes are: real transforms of blocks of 16 rows, whose spectra are stored in
/// transposed tiles of two cache lines width; then for each column of the spectrum the forward
/// transform, the symbol and the inverse transform, while it is in cache; then the inverse row
/// transforms. A field is read once and written once, its half spectrum read and written twice.
/// Running allocates nothing.
///
/// The convention is that of [`GridFft`](crate::GridFft); the mean of the field is the wave (0, 0).
pub struct Convolution<T: Float> {
    shape: [usize; 2],
    /// Shape of the transforms, at least `shape`.
    padded: [usize; 2],
    tile_columns: usize,
    plans: Plans<T>,
    /// Tile (block of rows, group of columns) at `block * groups + group`, column-major inside.
    tiles: Vec<Mutex<Vec<Complex<T>>>>,
    /// One per thread.
    scratch: Vec<Mutex<Scratch<T>>>,
}

struct Scratch<T> {
    /// One row of the field.
    row: Vec<T>,
    /// Half spectra of a block of rows.
    waves: Vec<Complex<T>>,
    /// A group of columns of the spectrum.
    columns: Vec<Complex<T>>,
    /// The symbol on one column, `ky` in `0..=ny/2`.
    symbol: Vec<T>,
    fft: Vec<Complex<T>>,
}

impl<T: Float> std::fmt::Debug for Convolution<T> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let mut shown = f.debug_struct("Convolution");
        shown.field("shape", &self.shape).field("padded", &self.padded).finish_non_exhaustive()
    }
}

/// A lock is never held across a panic that matters: the data are scratch.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl<T: Float> Convolution<T> {
    /// Plans for fields of `shape = [ny, nx]`, and for the threads of the pool it is called in.
    ///
    /// # Panics
    /// If a side is 0.
    pub fn new(shape: [usize; 2]) -> Self {
        Self::padded(shape, shape)
    }

    /// As [`new`](Self::new), for fields that are continued with zeros to `padded = [py, px]`
    /// before the transform, and cut back to `shape` after it. Rows of zeros are neither stored nor
    /// transformed: with both sides doubled this costs three times the transform of the field, not
    /// four, and stores two times its spectrum.
    ///
    /// # Panics
    /// If a side is 0 or padded to less than its length.
    pub fn padded(shape: [usize; 2], padded: [usize; 2]) -> Self {
        let [ny, nx] = shape;
        let [py, px] = padded;
        assert!(ny > 0 && nx > 0, "a transform needs at least one pixel along each axis");
        assert!(py >= ny && px >= nx, "padding cannot shorten a side");
        let nq = px / 2 + 1;
        let plans = T::plan(padded);
        let zero = Complex::new(T::zero(), T::zero());
        let tile_columns = (128 / size_of::<Complex<T>>()).max(1);
        let mut tiles = Vec::with_capacity(ny.div_ceil(TILE_ROWS) * nq.div_ceil(tile_columns));
        for first_row in (0..ny).step_by(TILE_ROWS) {
            for first_column in (0..nq).step_by(tile_columns) {
                let rows = TILE_ROWS.min(ny - first_row);
                let columns = tile_columns.min(nq - first_column);
                tiles.push(Mutex::new(vec![zero; rows * columns]));
            }
        }
        let fft_scratch = plans.scratch_len();
        let scratch = (0..threads())
            .map(|_| {
                Mutex::new(Scratch {
                    row: vec![T::zero(); px],
                    waves: vec![zero; TILE_ROWS.min(ny) * nq],
                    columns: vec![zero; tile_columns.min(nq) * py],
                    symbol: vec![T::zero(); py / 2 + 1],
                    fft: vec![zero; fft_scratch],
                })
            })
            .collect();
        Self { shape, padded, tile_columns, plans, tiles, scratch }
    }

    /// Shape of the fields, `[ny, nx]`.
    pub fn shape(&self) -> [usize; 2] {
        self.shape
    }

    /// How many rows [`apply_around`](Self::apply_around) handles at a time: this many, but for the
    /// last block. The number of blocks is `ny.div_ceil(BLOCK_ROWS)`.
    pub const BLOCK_ROWS: usize = TILE_ROWS;

    /// `output = IFFT[ symbol FFT[input] ]`.
    ///
    /// `symbol(kx, column)` writes the symbol of the waves `(0..=ny/2, kx)` to `column`; the waves
    /// of negative `ky` take the same values. With padding, `ny` and `kx` are those of the padded
    /// shape.
    ///
    /// # Panics
    /// If a slice does not have the length planned for.
    pub fn apply(&self, input: &[T], symbol: impl Fn(usize, &mut [T]) + Sync, output: &mut [T]) {
        assert_eq!(input.len(), output.len(), "field lengths");
        self.analyse_all(input);
        self.filter_all(symbol, T::one());
        self.synthesise_all(output);
    }

    /// As [`apply`](Self::apply), in place.
    ///
    /// # Panics
    /// If the field does not have the length planned for.
    pub fn apply_in_place(&self, field: &mut [T], symbol: impl Fn(usize, &mut [T]) + Sync) {
        self.analyse_all(field);
        self.filter_all(symbol, T::one());
        self.synthesise_all(field);
    }

    /// As [`apply`](Self::apply), with work on blocks of rows while they are in cache:
    ///
    /// - `prepare(first_row, input)` may change a block of the input before it is transformed;
    /// - `factor(results)` sees what that returned for each block, in order, and says by what the
    ///   output is to be multiplied, or stops here with `None`;
    /// - `finish(first_row, factor, input, output, companion)` may change a block of both and of a
    ///   third field, whatever it holds, once the output is there; what it returns replaces `results`.
    ///
    /// Sums taken from the results in order do not depend on the number of threads. Returns the
    /// factor.
    ///
    /// # Panics
    /// If a slice does not have the length planned for; there is one result per block.
    #[allow(clippy::too_many_arguments, reason = "three fields and what is done with them")]
    pub fn apply_around<C: Send, R: Send>(
        &self,
        input: &mut [T],
        prepare: impl Fn(usize, &mut [T]) -> R + Sync + Send,
        factor: impl FnOnce(&[R]) -> Option<T>,
        symbol: impl Fn(usize, &mut [T]) + Sync,
        output: &mut [T],
        companion: &mut [C],
        finish: impl Fn(usize, T, &mut [T], &mut [T], &mut [C]) -> R + Sync + Send,
        results: &mut [R],
    ) -> Option<T> {
        let [ny, nx] = self.shape;
        let is_whole = |length: usize| length == ny * nx;
        assert!(is_whole(input.len()) && is_whole(output.len()), "field lengths");
        assert!(is_whole(companion.len()), "companion length");
        assert_eq!(results.len(), ny.div_ceil(TILE_ROWS), "one result per block of rows");
        let size = TILE_ROWS * nx;
        let blocks = input.par_chunks_mut(size).zip(results.par_iter_mut());
        blocks.enumerate().for_each(|(block, (rows, result))| {
            *result = prepare(block * TILE_ROWS, rows);
            self.analyse(block, rows);
        });
        let factor = factor(results)?;
        self.filter_all(symbol, factor);
        input
            .par_chunks_mut(size)
            .zip(output.par_chunks_mut(size))
            .zip(companion.par_chunks_mut(size))
            .zip(results.par_iter_mut())
            .enumerate()
            .for_each(|(block, (((input, output), companion), result))| {
                self.synthesise(block, output);
                *result = finish(block * TILE_ROWS, factor, input, output, companion);
            });
        Some(factor)
    }

    fn filter_all(&self, symbol: impl Fn(usize, &mut [T]) + Sync, factor: T) {
        for_each_index(self.groups(), |group| self.filter(group, &symbol, factor));
    }

    fn analyse_all(&self, input: &[T]) {
        let [ny, nx] = self.shape;
        assert_eq!(input.len(), ny * nx, "field length");
        let blocks = input.par_chunks(TILE_ROWS * nx);
        blocks.enumerate().for_each(|(block, rows)| self.analyse(block, rows));
    }

    fn synthesise_all(&self, output: &mut [T]) {
        let [ny, nx] = self.shape;
        assert_eq!(output.len(), ny * nx, "field length");
        let blocks = output.par_chunks_mut(TILE_ROWS * nx);
        blocks.enumerate().for_each(|(block, rows)| self.synthesise(block, rows));
    }

    /// Number of groups of columns.
    fn groups(&self) -> usize {
        (self.padded[1] / 2 + 1).div_ceil(self.tile_columns)
    }

    fn scratch(&self) -> MutexGuard<'_, Scratch<T>> {
        lock(&self.scratch[thread_index() % self.scratch.len()])
    }

    /// Real transforms of one block of rows, stored in tiles.
    fn analyse(&self, block: usize, rows: &[T]) {
        let nx = self.shape[1];
        let nq = self.padded[1] / 2 + 1;
        let Scratch { row, waves, fft, .. } = &mut *self.scratch();
        for (values, wave) in rows.chunks_exact(nx).zip(waves.chunks_exact_mut(nq)) {
            row[..nx].copy_from_slice(values);
            row[nx..].fill(T::zero()); // the transform used it as scratch
            self.plans
                .row_forward
                .process_with_scratch(row, wave, fft)
                .expect("lengths are as planned");
        }
        let height = rows.len() / nx;
        for group in 0..self.groups() {
            let mut tile = lock(&self.tiles[block * self.groups() + group]);
            for (c, column) in tile.chunks_exact_mut(height).enumerate() {
                let kx = group * self.tile_columns + c;
                for (r, value) in column.iter_mut().enumerate() {
                    *value = waves[r * nq + kx];
                }
            }
        }
    }

    /// Forward transform, symbol times `factor` and inverse transform of one group of columns.
    fn filter(&self, group: usize, write_symbol: &impl Fn(usize, &mut [T]), factor: T) {
        let ny = self.shape[0];
        let [py, px] = self.padded;
        let first = group * self.tile_columns;
        let width = self.tile_columns.min(px / 2 + 1 - first);
        let Scratch { columns, symbol, fft, .. } = &mut *self.scratch();
        let columns = &mut columns[..width * py];
        let blocks = ny.div_ceil(TILE_ROWS);
        for block in 0..blocks {
            let tile = lock(&self.tiles[block * self.groups() + group]);
            let height = tile.len() / width;
            for (from, to) in tile.chunks_exact(height).zip(columns.chunks_exact_mut(py)) {
                to[block * TILE_ROWS..][..height].copy_from_slice(from);
            }
        }
        let scale = factor / T::from_usize(py * px).expect("a pixel count fits a float");
        for (c, column) in columns.chunks_exact_mut(py).enumerate() {
            column[ny..].fill(Complex::new(T::zero(), T::zero()));
            self.plans.column_forward.process_with_scratch(column, fft);
            write_symbol(first + c, symbol);
            let (rising, falling) = column.split_at_mut(py / 2 + 1);
            for (wave, s) in rising.iter_mut().zip(symbol.iter()) {
                *wave = *wave * (*s * scale);
            }
            for (wave, s) in falling.iter_mut().rev().zip(&symbol[1..]) {
                *wave = *wave * (*s * scale);
            }
            self.plans.column_inverse.process_with_scratch(column, fft);
        }
        for block in 0..blocks {
            let mut tile = lock(&self.tiles[block * self.groups() + group]);
            let height = tile.len() / width;
            for (to, from) in tile.chunks_exact_mut(height).zip(columns.chunks_exact(py)) {
                to.copy_from_slice(&from[block * TILE_ROWS..][..height]);
            }
        }
    }

    /// Inverse transforms of one block of rows.
    fn synthesise(&self, block: usize, rows: &mut [T]) {
        let nx = self.shape[1];
        let px = self.padded[1];
        let nq = px / 2 + 1;
        let height = rows.len() / nx;
        let Scratch { row, waves, fft, .. } = &mut *self.scratch();
        for group in 0..self.groups() {
            let tile = lock(&self.tiles[block * self.groups() + group]);
            for (c, column) in tile.chunks_exact(height).enumerate() {
                let kx = group * self.tile_columns + c;
                for (r, value) in column.iter().enumerate() {
                    waves[r * nq + kx] = *value;
                }
            }
        }
        for (wave, values) in waves.chunks_exact_mut(nq).zip(rows.chunks_exact_mut(nx)) {
            // The coefficients that a real row makes real; rounding left a trace of imaginary part.
            wave[0].im = T::zero();
            if px.is_multiple_of(2) {
                wave[nq - 1].im = T::zero();
            }
            let out = if px == nx { &mut *values } else { row.as_mut_slice() };
            self.plans
                .row_inverse
                .process_with_scratch(wave, out, fft)
                .expect("lengths are as planned and the ends are real");
            if px > nx {
                values.copy_from_slice(&row[..nx]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::GridFft;
    use proptest::prelude::*;

    proptest! {
        /// The same as forward transform, multiplication and inverse transform one by one.
        #[test]
        fn equals_the_three_steps(ny in 1usize..70, nx in 1usize..70, seed in 0u64..1000) {
            let value = |i: usize| ((i as f64 + 1.3) * (seed as f64 + 0.7) * 12.9898).sin();
            let field: Vec<f64> = (0..ny * nx).map(value).collect();
            let symbol = |ky: usize, kx: usize| 1.0 + (ky * ky + 3 * kx) as f64;

            let mut fft = GridFft::new([ny, nx]);
            let mut spectrum = fft.new_spectrum();
            fft.forward(&field, &mut spectrum);
            let nq = nx / 2 + 1;
            for (i, wave) in spectrum.iter_mut().enumerate() {
                *wave *= symbol((i / nq).min(ny - i / nq), i % nq);
            }
            let mut expected = vec![0.0; ny * nx];
            fft.inverse(&mut spectrum, &mut expected);

            let convolution = Convolution::new([ny, nx]);
            let write = |kx: usize, column: &mut [f64]| {
                for (ky, s) in column.iter_mut().enumerate() {
                    *s = symbol(ky, kx);
                }
            };
            let mut found = vec![0.0; ny * nx];
            convolution.apply(&field, write, &mut found);
            let size = symbol(ny / 2, nq - 1);
            for (a, b) in expected.iter().zip(&found) {
                prop_assert!((a - b).abs() < 1e-13 * size);
            }
        }

        /// What is done with the rows on the way is what can be done before and after.
        #[test]
        fn work_around_the_transform_is_seen(ny in 1usize..70, nx in 1usize..40) {
            let field: Vec<f64> = (0..ny * nx).map(|i| ((i as f64 + 1.3) * 12.9898).sin()).collect();
            let write = |kx: usize, column: &mut [f64]| {
                for (ky, s) in column.iter_mut().enumerate() {
                    *s = 1.0 / (1.0 + (ky * ky + 3 * kx) as f64);
                }
            };
            let convolution = Convolution::new([ny, nx]);
            let doubled: Vec<f64> = field.iter().map(|x| 2.0 * x).collect();
            let mut expected = vec![0.0; ny * nx];
            convolution.apply(&doubled, write, &mut expected);
            let (mut input, mut output) = (field.clone(), vec![0.0; ny * nx]);
            let mut rows_of = vec![0; ny * nx];
            let mut results = vec![0.0; ny.div_ceil(Convolution::<f64>::BLOCK_ROWS)];
            let prepare = |_: usize, rows: &mut [f64]| {
                for x in rows.iter_mut() {
                    *x *= 2.0;
                }
                rows.len() as f64
            };
            let factor = |counts: &[f64]| Some(counts.iter().sum::<f64>() / (2 * ny * nx) as f64);
            let finish = |row: usize, factor: f64, x: &mut [f64], y: &mut [f64], rows_of: &mut [usize]| {
                assert!((factor - 0.5).abs() < 1e-15);
                for (i, r) in rows_of.iter_mut().enumerate() {
                    *r = row + i / nx;
                }
                for y in y.iter_mut() {
                    *y *= 2.0;
                }
                x.iter().sum()
            };
            let found = convolution.apply_around(
                &mut input, prepare, factor, write, &mut output, &mut rows_of, finish, &mut results,
            );
            prop_assert_eq!(found, Some(0.5));
            prop_assert!(rows_of.iter().enumerate().all(|(i, r)| *r == i / nx));
            for (a, b) in expected.iter().zip(&output) {
                prop_assert!((a - b).abs() < 1e-14);
            }
            prop_assert!((results.iter().sum::<f64>() - doubled.iter().sum::<f64>()).abs() < 1e-10);
        }

        /// Padding is continuing with zeros and cutting back.
        #[test]
        fn padding_equals_zeros_by_hand(
            ny in 1usize..40, nx in 1usize..40, more_y in 0usize..40, more_x in 0usize..40,
        ) {
            let [py, px] = [ny + more_y, nx + more_x];
            let value = |i: usize| ((i as f64 + 1.3) * 12.9898).sin();
            let field: Vec<f64> = (0..ny * nx).map(value).collect();
            let mut large = vec![0.0; py * px];
            for (row, to) in field.chunks_exact(nx).zip(large.chunks_exact_mut(px)) {
                to[..nx].copy_from_slice(row);
            }
            let write = |kx: usize, column: &mut [f64]| {
                for (ky, s) in column.iter_mut().enumerate() {
                    *s = 1.0 / (1.0 + (ky * ky + 3 * kx) as f64);
                }
            };
            let mut expected = vec![0.0; py * px];
            Convolution::new([py, px]).apply(&large, write, &mut expected);
            let padded = Convolution::padded([ny, nx], [py, px]);
            let mut found = vec![0.0; ny * nx];
            for _ in 0..2 {
                padded.apply(&field, write, &mut found);
                for (row, from) in found.chunks_exact(nx).zip(expected.chunks_exact(px)) {
                    for (a, b) in row.iter().zip(from) {
                        prop_assert!((a - b).abs() < 1e-13);
                    }
                }
            }
        }
    }
}
