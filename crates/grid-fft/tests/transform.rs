//! A transform against the defining sum and its inverse, a convolution against its three steps.

use grid_fft::{Complex, Convolution, GridFft};
use proptest::prelude::*;
use std::f64::consts::TAU;

fn field(n: usize, seed: u64) -> Vec<f64> {
    (0..n).map(|i| ((i as f64 + 1.3) * (seed as f64 + 0.7) * 12.9898).sin()).collect()
}

fn transformed(shape: [usize; 2], field: &[f64]) -> (GridFft, Vec<Complex<f64>>) {
    let mut fft = GridFft::new(shape);
    let mut spectrum = fft.new_spectrum();
    fft.forward(field, &mut spectrum);
    (fft, spectrum)
}

proptest! {
    /// Against the defining sum, on any small grid, and back again.
    #[test]
    fn equals_the_defining_sum(ny in 1usize..13, nx in 1usize..13, seed in 0u64..1000) {
        let field = field(ny * nx, seed);
        let (mut fft, mut spectrum) = transformed([ny, nx], &field);
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
    /// The same as forward transform, multiplication and inverse transform one by one.
    #[test]
    fn equals_the_three_steps(ny in 1usize..70, nx in 1usize..70, seed in 0u64..1000) {
        let field = field(ny * nx, seed);
        let symbol = |ky: usize, kx: usize| 1.0 + (ky * ky + 3 * kx) as f64;
        let (mut fft, mut spectrum) = transformed([ny, nx], &field);
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

    /// Padding is continuing with zeros and cutting back.
    #[test]
    fn padding_equals_zeros_by_hand(
        ny in 1usize..40, nx in 1usize..40, more_y in 0usize..40, more_x in 0usize..40,
    ) {
        let [py, px] = [ny + more_y, nx + more_x];
        let field = field(ny * nx, 0);
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
