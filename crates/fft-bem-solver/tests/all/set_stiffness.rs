//! The mixed problem: stiffness and conductance of contact sets.

use crate::common;
use crate::npy;

use common::{curve, self_affine, solver, unit_grid};
use contact_types::Grid;
use fft_bem_solver::{Boundary, SetStiffness, Solver};
use std::f64::consts::PI;

/// The stiffness of a set of pixels, one E* Pa.
fn stiffness(grid: Grid, boundary: Boundary, set: impl Fn(usize) -> bool + Send) -> SetStiffness {
    solver(grid, Solver::builder().boundary(boundary)).contact_stiffness(set).unwrap()
}

/// That of a disc in the middle, and the radius of a disc of its area.
fn disc(n: usize, radius: f64, boundary: Boundary) -> (SetStiffness, f64) {
    let middle = |i: usize| i as f64 + 0.5 - 0.5 * n as f64;
    let is_in = |i: usize| middle(i / n).hypot(middle(i % n)) < radius;
    let area = (0..n * n).filter(|i| is_in(*i)).count() as f64;
    let found = stiffness(unit_grid(n, n), boundary, is_in);
    assert!(found.residual <= 1e-8 && found.transforms < 7.0, "{}", found.transforms);
    (found, (area / PI).sqrt())
}

/// A square array of circles: k = (2 a E*/L²) / (1 - 1.40087 e + 0.36 e³), e = a sqrt(pi)/L. The first coefficient
/// is the Wigner lattice sum.
#[test]
fn square_array_of_circles() {
    let n = 512;
    for radius in [51.0, 80.0, 100.0] {
        let (found, a) = disc(n, radius, Boundary::Periodic);
        let e = a * PI.sqrt() / n as f64;
        assert!(e <= 0.35);
        let exact = 2.0 * a / (n * n) as f64 / (1.0 - 1.40087 * e + 0.36 * e.powi(3));
        let error = found.per_area / exact - 1.0;
        assert!(error.abs() < 5e-3, "a = {radius}: {error:e}");
    }
}

/// One circle on a half space: Holm's resistance, k A = 2 E* a. The error falls with the pixel.
#[test]
fn one_circle_is_holm() {
    let mut last = f64::INFINITY;
    for n in [32, 64, 128, 256] {
        let (found, a) = disc(n, 0.4 * n as f64, Boundary::Free);
        let error = (found.per_area * (n * n) as f64 / (2.0 * a) - 1.0).abs();
        assert!(error < 0.75 * last, "{n}: {error:e} after {last:e}");
        last = error;
    }
    assert!(last < 5e-3, "{last:e}");
}

/// The stiffness of an elastic contact is the slope of its loading curve.
#[test]
fn agrees_with_the_secant_of_the_load() {
    let map = self_affine(unit_grid(256, 256), 0.8, 64.0, 8.0, 2);
    for load in [0.01, 0.04, 0.2] {
        let mut solver = solver(map.grid(), Solver::builder().tolerance(1e-9));
        let three = curve(&mut solver, &map, &[0.999, 1.001, 1.0].map(|x| x * load));
        let secant = 0.002 * load / (three[1].approach - three[0].approach);
        let found = solver.contact_stiffness(|i| three[2].pressure[i] > 0.0).unwrap();
        let off = found.per_area / secant - 1.0;
        assert!(off.abs() < 2e-3, "p = {load}: {off:e}");
        assert!(found.residual <= 1e-8 && found.transforms < 7.0, "{}", found.transforms);
    }
}

/// The slope is the stiffness of what has not yielded, thirty times too small.
#[test]
fn conductance_of_a_yielded_contact_is_not_the_slope_of_its_curve() {
    let map = npy::unit_cell("rough256.npy");
    let mut solver = solver(map.grid(), Solver::builder().tolerance(1e-9).hardness(0.05));
    let three = curve(&mut solver, &map, &[0.9995, 1.0005, 1.0].map(|x| x * 0.04));
    // The level of the flat is the mean gap but for a constant, with what is flattened counted as negative.
    let slope = 0.001 * 0.04 / (three[1].approach - three[0].approach);
    let found = solver.contact_stiffness(|i| three[2].pressure[i] > 0.0).unwrap();
    assert!((found.per_area - 281.0).abs() < 3.0, "{}", found.per_area);
    assert!((slope - 8.6).abs() < 0.5, "{slope}");
    assert!(found.residual <= 1e-8 && found.transforms < 7.0, "{}", found.transforms);
}

#[test]
fn limits_are_answers() {
    let grid = Grid::new([12, 10], [1e-6, 2e-6]).unwrap();
    assert!(stiffness(grid, Boundary::Periodic, |_| true).per_area.is_infinite());
    assert!(stiffness(grid, Boundary::Free, |_| true).per_area.is_finite());
    assert!(stiffness(grid, Boundary::Periodic, |i| i == 37).per_area > 0.0);
    assert!(stiffness(grid, Boundary::Periodic, |_| false).per_area <= 0.0);
}
