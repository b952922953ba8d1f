//! A surface of 1024 x 1024 pixels at three loads, against figures on which Tamaas 2.9.0 and
//! ContactMechanics 1.8.3 agree to 1e-10.
//!
//! The surface: `w = rfft2(default_rng(1).standard_normal((1024, 1024)))` of numpy, times
//! `max(k, 8)^-1.8` for `0 < k <= 128`, k in waves per cell; `irfft2`; scaled to a spectral rms slope
//! of 0.1 in a cell of 1 x 1; E* = 1.

use crate::common;
use crate::numpy_normal;

use common::unit_modulus;
use contact_types::{Grid, HeightMap};
use fft_bem_solver::{Load, Solver};
use grid_fft::GridFft;
use numpy_normal::{Pcg64, Ziggurat};
use std::f64::consts::TAU;

const SIDE: usize = 1024;

/// Mean pressure; contact area fraction, mean gap counted from the pressure-weighted gap in contact,
/// maximum pressure.
const POINTS: [(f64, [f64; 3]); 3] = [
    (0.002, [0.045_522_690, 1.141_517_956_74e-3, 0.203_980_968_0]),
    (0.01, [0.206_460_953, 4.531_385_482_26e-4, 0.231_265_649_7]),
    (0.04, [0.649_356_842, 6.452_677_268_07e-5, 0.270_220_543_0]),
];

#[test]
fn three_loads_agree_with_two_other_programs() {
    let surface = surface();
    let mut worst = [0.0_f64; 3];
    for (load, expected) in POINTS {
        // A new solver for each, so that no load leans on another.
        let mut solver =
            Solver::builder().tolerance(1e-10).build(surface.grid(), unit_modulus()).unwrap();
        let found = solver.solve(&surface, Load::MeanPressure(load)).unwrap();
        let (state, diagnostics) = (&found.state, &found.diagnostics);
        let values = [found.touching_fraction(), state.mean_gap.unwrap(), diagnostics.max_pressure];
        println!(
            "{load}: area {:.9}, mean gap {:.11e}, maximum pressure {:.10}; {:.2} convolutions",
            values[0], values[1], values[2], diagnostics.transforms
        );
        // The area by its digits, the others relative.
        let errors = [
            (values[0] - expected[0]).abs(),
            (values[1] / expected[1] - 1.0).abs(),
            (values[2] / expected[2] - 1.0).abs(),
        ];
        for (worst, error) in worst.iter_mut().zip(errors) {
            *worst = worst.max(error);
        }
    }
    println!(
        "worst: area {:.1e}, gap {:.1e}, maximum pressure {:.1e}",
        worst[0], worst[1], worst[2]
    );
    // One pixel is 9.5e-7 of the area: to 8 digits, the same pixels are in contact.
    assert!(worst[0] < 5e-9, "area off by {:e}", worst[0]);
    assert!(worst[1] < 1e-9, "mean gap off by {:e}", worst[1]);
    assert!(worst[2] < 1e-9, "maximum pressure off by {:e}", worst[2]);
}

/// Printed by numpy 2.4: `default_rng(1).standard_normal(2**20)`.
#[test]
fn the_numbers_are_those_of_numpy() {
    let first = [
        0.345_584_192_064_786,
        0.821_618_143_501_158_4,
        0.330_437_076_183_387_14,
        -1.303_157_231_604_361,
        0.905_355_866_673_117_7,
        0.446_374_572_364_011_3,
        -0.536_953_235_360_285_2,
        0.581_118_104_196_353_1,
        0.364_572_396_186_075_73,
        0.294_132_496_655_526,
    ];
    let (ziggurat, mut random) = (Ziggurat::new(), Pcg64::numpy_seed_1());
    let numbers: Vec<f64> = (0..SIDE * SIDE).map(|_| ziggurat.normal(&mut random)).collect();
    for (found, expected) in numbers.iter().zip(first) {
        assert!((found / expected - 1.0_f64).abs() < 1e-13, "{found} for {expected}");
    }
    // As many draws as numpy made: no number was refused or kept that numpy would not.
    assert_eq!(random.state(), 0xe6d7_f4e9_5cc2_cb80_6917_df78_e493_1f7b);
    // Rounding of the table moves a number by at most 1e-13; the sums are of random signs.
    let sum: f64 = numbers.iter().sum();
    let weighted: f64 = numbers.iter().zip((1..=1000).cycle()).map(|(x, i)| x * f64::from(i)).sum();
    println!("sum {sum}, weighted {weighted}");
    assert!((sum + 461.954_215_303_330_3).abs() < 1e-9, "{sum}");
    assert!((weighted + 653_374.798_179_512_6).abs() < 1e-6, "{weighted}");
    // The tail beyond 3.654 is a case of its own.
    let farthest = numbers.iter().fold(0.0, |a: f64, x| a.max(x.abs()));
    assert_eq!(numbers.iter().filter(|x| x.abs() > 3.654_152_885_361_008_8).count(), 290);
    assert!((farthest - 5.040_434_135_971_221).abs() < 1e-12, "{farthest}");
}

fn surface() -> HeightMap {
    let grid = Grid::new([SIDE; 2], [1.0 / SIDE as f64; 2]).unwrap();
    let (ziggurat, mut random) = (Ziggurat::new(), Pcg64::numpy_seed_1());
    let white: Vec<f64> = (0..grid.len()).map(|_| ziggurat.normal(&mut random)).collect();
    let mut fft = GridFft::new(grid.shape());
    let mut spectrum = fft.new_spectrum();
    fft.forward(&white, &mut spectrum);
    let nq = fft.spectrum_shape()[1];
    let mut slope2 = 0.0;
    for (i, wave) in spectrum.iter_mut().enumerate() {
        let (row, kx) = (i / nq, i % nq);
        let ky = row.min(SIDE - row);
        // Whole waves, so that k <= 128 is decided exactly.
        let k2 = kx * kx + ky * ky;
        let k = (k2 as f64).sqrt();
        *wave *= if k2 == 0 || k2 > 128 * 128 { 0.0 } else { k.max(8.0).powf(-1.8) };
        let twice = if kx == 0 || 2 * kx == SIDE { 1.0 } else { 2.0 };
        slope2 += twice * (TAU * k).powi(2) * wave.norm_sqr();
    }
    let mut heights = vec![0.0; grid.len()];
    fft.inverse(&mut spectrum, &mut heights);
    let scale = 0.1 * grid.len() as f64 / slope2.sqrt();
    HeightMap::new(grid, heights.iter().map(|h| scale * h).collect()).unwrap()
}
