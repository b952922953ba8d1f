//! A load curve: the answers of cold starts, whatever the order of the loads, for fewer convolutions.

use crate::common;

use common::{difference, self_affine, solve, unit_grid, unit_modulus};
use fft_bem_solver::{Solution, Solver, SolverError};

#[test]
fn a_curve_equals_cold_starts_in_any_order() {
    let grid = unit_grid(128, 144);
    let surface = self_affine(grid, 0.8, 16.0, 2.0, 5);
    let tolerance = 1e-8;
    let builder = Solver::builder().tolerance(tolerance);
    let build = || builder.clone().build(grid, unit_modulus()).unwrap();
    let loads: Vec<f64> = (0..12).map(|k| 0.005 * 1000.0_f64.powf(f64::from(k) / 11.0)).collect();
    let cold: Vec<Solution> = loads.iter().map(|p| solve(&surface, builder.clone(), *p)).collect();
    let cold_pairs: f64 = cold.iter().map(|s| s.diagnostics.transforms).sum();

    let shuffled = [7, 2, 11, 0, 5, 9, 1, 10, 3, 8, 6, 4];
    for order in [shuffled.to_vec(), (0..12).collect(), (0..12).rev().collect()] {
        let given: Vec<f64> = order.iter().map(|&k: &usize| loads[k]).collect();
        let mut pairs = 0.0;
        let points = build().curve(&surface, &given);
        assert_eq!(points.len(), 12);
        for (index, result) in points.into_iter().enumerate() {
            let (found, exact) = (result.unwrap(), &cold[order[index]]);
            assert!((found.state.mean_pressure / given[index] - 1.0).abs() < 1e-12);
            let error = difference(&found.pressure, &exact.pressure);
            assert!(error <= 3.0 * tolerance, "load {}: {error:e}", given[index]);
            pairs += found.diagnostics.transforms;
        }
        assert!(pairs < cold_pairs, "{pairs} pairs, cold {cold_pairs}");
    }
    // A load that cannot be solved keeps its place.
    let points = build().curve(&surface, &[0.1, -1.0, 0.01]);
    assert!(points[0].is_ok() && points[2].is_ok());
    assert!(matches!(points[1], Err(SolverError::BadLoad { .. })));
}
