//! A surface of 1024 x 1024 pixels at three loads, against figures on which Tamaas 2.9.0 and
//! ContactMechanics 1.8.3 agree to 1e-10.
//!
//! The surface: `w = rfft2(default_rng(1).standard_normal((1024, 1024)))` of numpy, times
//! `max(k, 8)^-1.8` for `0 < k <= 128`, k in waves per cell; `irfft2`; scaled to a spectral rms slope
//! of 0.1 in a cell of 1 x 1; E* = 1.

use crate::common;
use crate::numpy_normal;

use common::{filtered, solve};
use contact_types::{Grid, HeightMap};
use fft_bem_solver::Solver;
use numpy_normal::{Ziggurat, numpy_seed_1};

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
    for (load, [area, gap, highest]) in POINTS {
        let found = solve(&surface, Solver::builder().tolerance(1e-10), load);
        // One pixel is 9.5e-7 of the area: to 8 digits, the same pixels are in contact.
        let off = found.touching_fraction() - area;
        assert!(off.abs() < 5e-9, "{load}: area off by {off:e}");
        let off = found.state.mean_gap.unwrap() / gap - 1.0;
        assert!(off.abs() < 1e-9, "{load}: mean gap off by {off:e}");
        let off = found.diagnostics.max_pressure / highest - 1.0;
        assert!(off.abs() < 1e-9, "{load}: maximum pressure off by {off:e}");
    }
}

fn surface() -> HeightMap {
    let grid = Grid::new([SIDE; 2], [1.0 / SIDE as f64; 2]).unwrap();
    let (ziggurat, mut random) = (Ziggurat::new(), numpy_seed_1());
    let white: Vec<f64> = (0..grid.len()).map(|_| ziggurat.normal(&mut random)).collect();
    let steep = filtered(grid, &white, |[row, kx]| {
        // Whole waves, so that k <= 128 is decided exactly.
        let ky = row.min(SIDE - row);
        match kx * kx + ky * ky {
            k2 if k2 == 0 || k2 > 128 * 128 => 0.0,
            k2 => (k2 as f64).sqrt().max(8.0).powf(-1.8),
        }
    });
    HeightMap::new(grid, steep.heights().iter().map(|h| 0.1 * h).collect()).unwrap()
}
