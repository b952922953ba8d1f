//! A convolution against its three steps.

use grid_fft::{Convolution, GridFft};
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
