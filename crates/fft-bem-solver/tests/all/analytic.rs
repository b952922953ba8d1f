//! Exact solutions: the error falls at the expected order when the grid is refined.

use crate::common;

use common::{solve, to, unit_modulus};
use contact_types::{Grid, HeightMap};
use fft_bem_solver::reference::Hertz;
use fft_bem_solver::validation::{self, Options, ValidationRow};
use fft_bem_solver::{Boundary, Method};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

#[test]
fn errors_fall_at_the_expected_order() {
    let options = Options { finest: 128, ..Options::default() };
    let rows = validation::run(&options, |_| ()).unwrap();
    let finest: Vec<&ValidationRow> =
        rows.iter().filter(|r| r.shape[1] == 128 || r.shape[1] == 16 * 128).collect();
    assert_eq!(finest.len(), 3 * rows.len() / 9, "three grids per case");
    for row in finest {
        let limit = match (row.quantity, row.shape[0]) {
            ("closing pressure", _) => 1e-12,
            ("pressure, rms", _) if row.case == "full contact" => 1e-12,
            ("pressure, rms", 1) => 3e-4,
            ("pressure, rms", _) => 8e-3,
            ("mean gap" | "gap, rms" | "mean gap / amplitude", _) => 2e-5,
            ("approach" | "maximum pressure", _) if !row.case.contains("punch") => 6e-5,
            ("approach", _) => 5e-3,
            // A pixel more or less on each side of a profile, a fraction of one all round a spot.
            ("area fraction", 1) => 2.0 / (0.37 * 2048.0),
            _ => 3e-3,
        };
        assert!(row.error.abs() < limit, "{row:?}");
        if let (Some(expected), Some(observed)) = (row.expected_order, row.observed_order) {
            // The table of the bi-sinusoid and the edge of the punch leave scatter.
            let scatter = if row.case.starts_with(['b', 'f']) { 1.2 } else { 0.25 };
            assert!(observed > expected - scatter && observed < expected + 0.75, "{row:?}");
        }
    }
}

/// The force of 4/3 E* sqrt(R) delta^(3/2) at the approach found, by every method.
#[test]
fn hertz_by_every_method() {
    let contact = Hertz::at_approach([40.0; 2], unit_modulus(), 4.0).unwrap();
    let grid = Grid::new([48, 40], [0.8, 1.0]).unwrap();
    let map = HeightMap::from_fn(grid, |y, x| contact.height(y - 18.8, x - 19.5)).unwrap();
    for method in [Method::Auto, Method::PolonskyKeer, Method::StanleyKato] {
        let builder = to(1e-7).boundary(Boundary::Free).method(method);
        let found = solve(&map, builder, contact.force / grid.area());
        // First touch is at the highest pixel, a little below the summit.
        let approach = found.approach - map.range().1;
        assert!(((approach / 4.0).powf(1.5) - 1.0).abs() < 2e-3, "{method:?}: {approach}");
    }
}

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

/// Two scales of a Weierstrass profile: short fine waves see the pressure of the coarse ones as a
/// mean pressure of their own (Westergaard). The error falls as the ratio of the scales or faster.
///
/// Source: Ciavarella, Demelio, Barber & Jang (2000), doi:10.1098/rspa.2000.0522.
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
            let found = solve(&map, to(1e-6), load * closes);
            found.touching_fraction() / two_levels(load, fine) - 1.0
        };
        let [near, far] = [16, 64].map(error);
        assert!(near.abs() < 0.06 && far.abs() < 0.01, "{near} {far}");
        assert!(far.abs() < 0.5 * near.abs(), "{near} {far}");
    }
}
