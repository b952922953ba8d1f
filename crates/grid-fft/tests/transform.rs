//! A transform against the defining sum, exact cases and its inverse.

use grid_fft::{Complex, GridFft};
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
