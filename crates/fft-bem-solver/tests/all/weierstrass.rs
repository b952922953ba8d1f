//! Two scales of a Weierstrass profile: ridges on ridges, whose contact has a closed form where the scales
//! are far apart.
//!
//! Source: Ciavarella, Demelio, Barber & Jang (2000), doi:10.1098/rspa.2000.0522. Where the fine waves are short, each sees
//! the pressure of the coarse ones as a mean pressure of its own (Westergaard).

use crate::common::solve;
use contact_types::{Grid, HeightMap};
use fft_bem_solver::Solver;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Part of a sinusoid that touches at a mean pressure over that which closes it (Westergaard).
fn westergaard(pressure: f64) -> f64 {
    pressure.clamp(0.0, 1.0).sqrt().asin() / FRAC_PI_2
}

/// Part of the profile that touches, in the limit of far apart scales: `load` is the mean pressure, `fine`
/// the pressure that closes the fine waves, both over that which closes the coarse ones.
fn two_levels(load: f64, fine: f64) -> f64 {
    let steps = 400_000;
    let step = FRAC_PI_2 / f64::from(steps);
    let term = |t: f64| {
        let rest = (1.0 - load * t.sin().powi(2)).sqrt();
        let pressure = 2.0 * load.sqrt() * rest * t.cos();
        westergaard(pressure / fine) * load.sqrt() * t.cos() / rest
    };
    (0..steps).map(|i| term((f64::from(i) + 0.5) * step)).sum::<f64>() * step / FRAC_PI_2
}

/// The solver goes to the closed form as the scales part: the error falls as their ratio or faster.
#[test]
fn contact_on_two_scales_goes_to_its_limit() {
    for (load, fine) in [(0.3, 0.7), (0.7, 1.2), (0.3, 0.3)] {
        let error = |ratio: usize| {
            let n = 256 * ratio;
            let grid = Grid::new([1, n], [1.0 / n as f64; 2]).unwrap();
            // pi E* amplitude / wavelength closes a wave.
            let closes = 1e-3;
            let (coarse, small) = (closes / PI, fine * closes / PI / ratio as f64);
            let wave = |x: f64| coarse * (TAU * x).cos() + small * (TAU * ratio as f64 * x).cos();
            let map = HeightMap::from_fn(grid, |_, x| wave(x)).unwrap();
            let found = solve(&map, Solver::builder().tolerance(1e-6), load * closes);
            found.touching_fraction() / two_levels(load, fine) - 1.0
        };
        let [near, far] = [16, 64].map(error);
        assert!(near.abs() < 0.06 && far.abs() < 0.01, "{near} {far}");
        assert!(far.abs() < 0.5 * near.abs(), "{near} {far}");
    }
}
