//! The mixed problem: stiffness and conductance of contact sets.

use crate::common;
use crate::npy;

use common::{self_affine, unit_grid, unit_modulus};
use contact_types::Grid;
use fft_bem_solver::{Boundary, Load, Solver, SolverError, set_stiffness};
use std::f64::consts::PI;

/// Pixels whose centre is in the disc in the middle, and the radius of the disc of their area.
fn disc(n: usize, radius: f64) -> (Vec<bool>, f64) {
    let middle = |i: usize| i as f64 + 0.5 - 0.5 * n as f64;
    let set: Vec<bool> = (0..n * n).map(|i| middle(i / n).hypot(middle(i % n)) < radius).collect();
    let area = set.iter().filter(|on| **on).count() as f64;
    (set, (area / PI).sqrt())
}

/// A square array of circles: k = (2 a E*/L²) / (1 - 1.40087 e + 0.36 e³), e = a sqrt(pi)/L. The first coefficient
/// is the Wigner lattice sum.
#[test]
fn square_array_of_circles() {
    let n = 512;
    let grid = unit_grid(n, n);
    for radius in [51.0, 80.0, 100.0] {
        let (set, a) = disc(n, radius);
        let found = set_stiffness(grid, unit_modulus(), Boundary::Periodic, &set).unwrap();
        let e = a * PI.sqrt() / n as f64;
        assert!(e <= 0.35);
        let exact = 2.0 * a / (n * n) as f64 / (1.0 - 1.40087 * e + 0.36 * e.powi(3));
        let error = found.per_area / exact - 1.0;
        assert!(error.abs() < 5e-3, "a = {radius}: {error:e}");
        assert!(found.residual <= 1e-8 && found.transforms < 25.0, "{}", found.transforms);
        assert!(found.density.iter().zip(&set).all(|(j, on)| (*j > 0.0) == *on));
    }
}

/// One circle on a half space: Holm's resistance, k A = 2 E* a. The error falls with the pixel.
#[test]
fn one_circle_is_holm() {
    let mut last = f64::INFINITY;
    for n in [32, 64, 128, 256] {
        let (set, a) = disc(n, 0.4 * n as f64);
        let found = set_stiffness(unit_grid(n, n), unit_modulus(), Boundary::Free, &set).unwrap();
        let error = (found.per_area * (n * n) as f64 / (2.0 * a) - 1.0).abs();
        assert!(error < 0.75 * last, "{n}: {error:e} after {last:e}");
        last = error;
        assert!(found.residual <= 1e-8 && found.transforms < 25.0, "{}", found.transforms);
    }
    assert!(last < 5e-3, "{last:e}");
}

/// The stiffness of an elastic contact is the slope of its loading curve.
#[test]
fn agrees_with_the_secant_of_the_load() {
    let map = self_affine(unit_grid(256, 256), 0.8, 64.0, 8.0, 2);
    for load in [0.01, 0.04, 0.2] {
        let builder = Solver::builder().tolerance(1e-9);
        let mut solver = builder.build(map.grid(), unit_modulus()).unwrap();
        let [low, high] =
            [0.999, 1.001].map(|x| solver.solve(&map, Load::MeanPressure(x * load)).unwrap());
        let secant = 0.002 * load / (high.approach - low.approach);
        solver.solve(&map, Load::MeanPressure(load)).unwrap();
        let found = solver.contact_stiffness().unwrap();
        let off = found.per_area / secant - 1.0;
        assert!(off.abs() < 2e-3, "p = {load}: {off:e}");
        assert!(found.residual <= 1e-8 && found.transforms < 25.0, "{}", found.transforms);
    }
}

/// The trap: the slope of the loading curve of a yielding contact is the stiffness of what has not yielded,
/// thirty times too small for the conductance of the contact.
#[test]
fn conductance_of_a_yielded_contact_is_not_the_slope_of_its_curve() {
    let map = npy::unit_cell("rough256.npy");
    let builder = Solver::builder().tolerance(1e-9).hardness(0.05);
    let mut solver = builder.build(map.grid(), unit_modulus()).unwrap();
    let [low, high] =
        [0.9995, 1.0005].map(|x| solver.solve(&map, Load::MeanPressure(x * 0.04)).unwrap());
    // The level of the flat is the mean gap but for a constant, with what is flattened counted as negative.
    let slope = 0.001 * 0.04 / (high.approach - low.approach);
    solver.solve(&map, Load::MeanPressure(0.04)).unwrap();
    let found = solver.contact_stiffness().unwrap();
    assert!((found.per_area - 281.0).abs() < 3.0, "{}", found.per_area);
    assert!((slope - 8.6).abs() < 0.5, "{slope}");
    assert!(found.residual <= 1e-8 && found.transforms < 25.0, "{}", found.transforms);
}

/// Nothing, everything, one pixel; and what is no set.
#[test]
fn limits_are_answers() {
    let grid = Grid::new([12, 10], [1e-6, 2e-6]).unwrap();
    let of = |set: &[bool], boundary| set_stiffness(grid, unit_modulus(), boundary, set).unwrap();
    let none = of(&[false; 120], Boundary::Periodic);
    let all = of(&[true; 120], Boundary::Periodic);
    let mut some = [false; 120];
    some[37] = true;
    let one = of(&some, Boundary::Periodic);
    assert!(none.per_area <= 0.0 && all.per_area.is_infinite() && one.per_area > 0.0);
    assert!(of(&[true; 120], Boundary::Free).per_area.is_finite());
    let other = set_stiffness(grid, unit_modulus(), Boundary::Periodic, &[true; 7]);
    assert!(matches!(other, Err(SolverError::Shape { .. })));
    let mut fresh = Solver::builder().build(grid, unit_modulus()).unwrap();
    assert!(matches!(fresh.contact_stiffness(), Err(SolverError::NoSurface)));
}
