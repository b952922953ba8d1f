//! Field to field through the spectrum, in three passes over memory.

use crate::float::{Float, Plans};
use crate::parallel::prelude::*;
use crate::parallel::{thread_index, threads};
use crate::rows::RowScratch;
use rustfft::num_complex::Complex;
use std::ops::Range;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Rows transformed together; also the height of a tile.
const TILE_ROWS: usize = 16;
/// Waves in a tile: two cache lines of each of its rows.
const TILE: usize = 8 * TILE_ROWS;

/// Multiplies the spectrum of a field by a real symbol that is even in the wave vector.
///
/// The three passes are: real transforms of blocks of 16 rows, whose spectra are stored in
/// transposed tiles of two cache lines width; then for each column of the spectrum the forward
/// transform, the symbol and the inverse transform, while it is in cache; then the inverse row
/// transforms. Running allocates nothing.
pub struct Convolution<T: Float> {
    shape: [usize; 2],
    /// Shape of the transforms, at least `shape`.
    padded: [usize; 2],
    tile_columns: usize,
    plans: Plans<T>,
    /// Tile (group of columns, block of rows) at `group * blocks + block`, column-major inside. In one piece: thousands
    /// of small ones take longer to allocate than a transform.
    tiles: Vec<Mutex<[Complex<T>; TILE]>>,
    /// One per thread.
    scratch: Vec<Mutex<Scratch<T>>>,
}

struct Scratch<T> {
    rows: RowScratch<T>,
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
    /// transformed.
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
        let tile_columns = TILE / TILE_ROWS.min(ny);
        let tiles = ny.div_ceil(TILE_ROWS) * nq.div_ceil(tile_columns);
        let tiles = (0..tiles).map(|_| Mutex::new([zero; TILE])).collect();
        let fft_scratch = plans.column_scratch_len();
        let scratch = (0..threads())
            .map(|_| {
                Mutex::new(Scratch {
                    rows: plans.rows.scratch(),
                    waves: vec![zero; TILE_ROWS.min(ny) * nq],
                    columns: vec![zero; tile_columns.min(nq) * py],
                    symbol: vec![T::zero(); py / 2 + 1],
                    fft: vec![zero; fft_scratch],
                })
            })
            .collect();
        Self { shape, padded, tile_columns, plans, tiles, scratch }
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
        let groups = self.tiles.par_chunks(self.blocks()).enumerate();
        groups.for_each(|(group, tiles)| self.filter(group, tiles, &symbol, factor));
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

    fn blocks(&self) -> usize {
        self.shape[0].div_ceil(TILE_ROWS)
    }

    /// The tiles of a block of rows, with their columns.
    fn tiles_of(
        &self,
        block: usize,
    ) -> impl Iterator<Item = (Range<usize>, MutexGuard<'_, [Complex<T>; TILE]>)> {
        let tiles = self.tiles.iter().skip(block).step_by(self.blocks());
        tiles.enumerate().map(|(group, tile)| (self.columns_of(group), lock(tile)))
    }

    fn columns_of(&self, group: usize) -> Range<usize> {
        let first = group * self.tile_columns;
        first..(first + self.tile_columns).min(self.padded[1] / 2 + 1)
    }

    fn scratch(&self) -> MutexGuard<'_, Scratch<T>> {
        lock(&self.scratch[thread_index() % self.scratch.len()])
    }

    /// Real transforms of one block of rows, stored in tiles.
    fn analyse(&self, block: usize, rows: &[T]) {
        let nx = self.shape[1];
        let nq = self.padded[1] / 2 + 1;
        let Scratch { rows: scratch, waves, .. } = &mut *self.scratch();
        let height = rows.len() / nx;
        self.plans.rows.forward(rows, &mut waves[..height * nq], scratch);
        for (columns, mut tile) in self.tiles_of(block) {
            for (c, column) in columns.zip(tile.chunks_exact_mut(height)) {
                for (r, value) in column.iter_mut().enumerate() {
                    *value = waves[r * nq + c];
                }
            }
        }
    }

    /// Forward transform, symbol times `factor` and inverse transform of one group of columns.
    fn filter(
        &self,
        group: usize,
        tiles: &[Mutex<[Complex<T>; TILE]>],
        write_symbol: &impl Fn(usize, &mut [T]),
        factor: T,
    ) {
        let ny = self.shape[0];
        let [py, px] = self.padded;
        let waves = self.columns_of(group);
        let Scratch { columns, symbol, fft, .. } = &mut *self.scratch();
        let columns = &mut columns[..waves.len() * py];
        let rows = |block: usize| block * TILE_ROWS..ny.min((block + 1) * TILE_ROWS);
        for (block, tile) in tiles.iter().enumerate() {
            let (tile, rows) = (lock(tile), rows(block));
            for (from, to) in tile.chunks_exact(rows.len()).zip(columns.chunks_exact_mut(py)) {
                to[rows.clone()].copy_from_slice(from);
            }
        }
        let scale = factor / T::from_usize(py * px).expect("a pixel count fits a float");
        for (kx, column) in waves.zip(columns.chunks_exact_mut(py)) {
            column[ny..].fill(Complex::new(T::zero(), T::zero()));
            self.plans.column_forward.process_with_scratch(column, fft);
            write_symbol(kx, symbol);
            let (rising, falling) = column.split_at_mut(py / 2 + 1);
            for (wave, s) in rising.iter_mut().zip(symbol.iter()) {
                *wave = *wave * (*s * scale);
            }
            for (wave, s) in falling.iter_mut().rev().zip(&symbol[1..]) {
                *wave = *wave * (*s * scale);
            }
            self.plans.column_inverse.process_with_scratch(column, fft);
        }
        for (block, tile) in tiles.iter().enumerate() {
            let (mut tile, rows) = (lock(tile), rows(block));
            for (to, from) in tile.chunks_exact_mut(rows.len()).zip(columns.chunks_exact(py)) {
                to.copy_from_slice(&from[rows.clone()]);
            }
        }
    }

    /// Inverse transforms of one block of rows.
    fn synthesise(&self, block: usize, rows: &mut [T]) {
        let nx = self.shape[1];
        let nq = self.padded[1] / 2 + 1;
        let height = rows.len() / nx;
        let Scratch { rows: scratch, waves, .. } = &mut *self.scratch();
        for (columns, tile) in self.tiles_of(block) {
            for (c, column) in columns.zip(tile.chunks_exact(height)) {
                for (r, value) in column.iter().enumerate() {
                    waves[r * nq + c] = *value;
                }
            }
        }
        self.plans.rows.inverse(&mut waves[..height * nq], rows, scratch);
    }
}
