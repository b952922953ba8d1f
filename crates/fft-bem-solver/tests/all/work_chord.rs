//! What the chord iteration costs, pinned: FFT pairs and iterations are exact numbers, the same on
//! every machine, so a slowdown fails here whatever the clock says.

use crate::common;

use common::{measured_like, self_affine, unit_grid, unit_modulus};
use fft_bem_solver::{Load, Method, Solver};

/// Hurst exponent, load, and iterations and pairs to three tolerances.
type Work = (f64, f64, [(usize, f64); 3]);

/// Self-affine surfaces down to the pixel, H = 0.8 and 0.3, roll-off an eighth of the side, at
/// three loads: iterations, and pairs rounded to hundredths, to an estimate of 1e-2, 1e-4, 1e-6.
#[test]
fn pairs_and_iterations() {
    let expected: [Work; 6] = [
        (0.8, 0.02, [(3, 3.19), (5, 5.28), (7, 7.38)]),
        (0.8, 0.10, [(3, 3.19), (5, 5.28), (6, 6.33)]),
        (0.8, 0.40, [(2, 2.14), (4, 4.23), (6, 6.33)]),
        (0.3, 0.02, [(3, 3.19), (5, 5.28), (6, 6.33)]),
        (0.3, 0.10, [(3, 3.19), (5, 5.28), (6, 6.33)]),
        (0.3, 0.40, [(2, 2.14), (4, 4.23), (6, 6.33)]),
    ];
    let grid = unit_grid(256, 256);
    let mut found = Vec::new();
    for (hurst, load, _) in expected {
        let surface = self_affine(grid, hurst, 32.0, 2.0, 1);
        let work = [1e-2, 1e-4, 1e-6].map(|tolerance| {
            let builder = Solver::builder().method(Method::Chord).tolerance(tolerance);
            let mut solver = builder.build(grid, unit_modulus()).unwrap();
            let d = solver.solve(&surface, Load::MeanPressure(load)).unwrap().diagnostics;
            (d.iterations, (100.0 * d.transforms).round() / 100.0)
        });
        found.push((hurst, load, work));
    }
    assert_eq!(found, expected, "iterations or pairs changed");
}

/// A curve of 16 loads over two decades on a map that is stepped and does not repeat: iterations of
/// all its loads together.
#[test]
fn iterations_along_a_curve() {
    let n = 256;
    let surface = measured_like(n, 1);
    let loads: Vec<f64> = (0..16).map(|k| 0.005 * 200_f64.powf(f64::from(k) / 15.0)).collect();
    let found = [1e-2, 1e-4, 1e-6].map(|tolerance| {
        let builder = Solver::builder().method(Method::Chord).tolerance(tolerance);
        let mut solver = builder.build(unit_grid(n, n), unit_modulus()).unwrap();
        let points = solver.curve(&surface, &loads);
        points.into_iter().map(|found| found.unwrap().diagnostics.iterations).sum::<usize>()
    });
    assert_eq!(found, [49, 81, 113], "iterations changed");
}
