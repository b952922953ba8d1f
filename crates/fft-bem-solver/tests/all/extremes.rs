//! Problems at the ends of what can be asked, and what must be refused.

use crate::common;

use common::{self_affine, unit_grid, unit_modulus};
use contact_types::{ContactModulus, Grid, HeightMap};
use fft_bem_solver::{
    Boundary, End, Iteration, Load, Method, Precision, Solution, Solver, SolverError,
};
use std::f64::consts::PI;
use std::ops::ControlFlow;

const METHODS: [Method; 3] = [Method::Auto, Method::PolonskyKeer, Method::StanleyKato];

fn modulus(pascals: f64) -> ContactModulus {
    ContactModulus::from_pascals(pascals).unwrap()
}

fn solve(
    map: &HeightMap,
    e_star: f64,
    method: Method,
    load: Load,
) -> Result<Solution, SolverError> {
    let builder = Solver::builder().method(method).tolerance(1e-6);
    builder.build(map.grid(), modulus(e_star))?.solve(map, load)
}

/// From one pixel in contact to a hundred times the load that closes every gap.
#[test]
fn from_one_pixel_to_beyond_full_contact() {
    let map = self_affine(unit_grid(40, 36), 0.8, 18.0, 4.0, 3);
    for method in METHODS {
        for precision in [Precision::Double, Precision::Single] {
            let builder = Solver::builder().method(method).precision(precision);
            let mut solver = builder.build(map.grid(), unit_modulus()).unwrap();
            let first = solver.solve(&map, Load::MeanPressure(1e-9)).unwrap();
            assert_eq!(first.diagnostics.exact, Some("single pixel in contact"));
            assert_eq!(first.diagnostics.contact_pixels, 1);
            assert!(first.diagnostics.transforms <= 1.0);
            let closed = solver.solve(&map, Load::MeanGap(0.0)).unwrap();
            let least = closed.state.mean_pressure;
            let mut last = 0.0;
            for ratio in [1e-6, 1e-4, 1e-2, 0.3, 0.9, 0.999, 1.001, 2.0, 100.0] {
                let found = solver.solve(&map, Load::MeanPressure(ratio * least)).unwrap();
                let area = found.touching_fraction();
                assert!(area >= last, "{method:?} {ratio}");
                last = area;
                let sum: f64 = found.pressure.iter().sum();
                assert!((sum / 1440.0 / ratio / least - 1.0).abs() < 1e-6);
                let is_simple = ratio > 1.0 || found.diagnostics.contact_pixels == 1;
                assert_eq!(found.diagnostics.exact.is_some(), is_simple, "{method:?} {ratio}");
                if ratio > 1.0 {
                    assert!(area >= 1.0 && found.diagnostics.transforms <= 2.0);
                    assert!(found.gap.iter().all(|g| g.abs() < 1e-5));
                }
            }
        }
    }
}

#[test]
fn a_single_pixel_map() {
    let grid = Grid::new([1, 1], [1e-6, 2e-6]).unwrap();
    let map = HeightMap::new(grid, vec![3e-9]).unwrap();
    let found = solve(&map, 1e9, Method::Auto, Load::MeanPressure(7.0)).unwrap();
    assert!(found.pressure == [7.0] && found.gap == [0.0]);
    let mut free = Solver::builder().boundary(Boundary::Free).build(grid, modulus(1e9)).unwrap();
    let found = free.solve(&map, Load::MeanPressure(7.0)).unwrap();
    // Under the middle of a uniformly loaded rectangle (Johnson 1985, eq. 3.25).
    let dent = 2.0 / PI * (1e-6 * 2f64.asinh() + 2e-6 * 0.5f64.asinh()) * 7.0 / 1e9;
    assert!((found.approach / dent - 1.0).abs() < 1e-12);
}

#[test]
fn no_load_and_flat_surfaces_are_answered_at_once() {
    let rough = self_affine(unit_grid(16, 16), 0.8, 8.0, 4.0, 5);
    let depth = rough.range().1 - rough.mean();
    for method in METHODS {
        let idle = solve(&rough, 1.0, method, Load::MeanPressure(0.0)).unwrap();
        assert_eq!(idle.diagnostics.exact, Some("no load"));
        assert!(idle.touching_fraction().abs() < 1e-300 && idle.diagnostics.transforms < 1e-300);
        assert!((idle.state.mean_gap.unwrap() / depth - 1.0).abs() < 1e-12);
        // A mean gap wider than at first touch: apart by the difference.
        let apart = solve(&rough, 1.0, method, Load::MeanGap(2.0 * depth)).unwrap();
        assert_eq!(apart.diagnostics.contact_pixels, 0);
        assert!((apart.state.mean_gap.unwrap() / depth - 2.0).abs() < 1e-12);
        assert!(apart.gap.iter().all(|g| *g >= 0.99 * depth));

        let flat = HeightMap::new(unit_grid(8, 9), vec![-3.5; 72]).unwrap();
        let pressed = solve(&flat, 1e9, method, Load::MeanPressure(2.0)).unwrap();
        assert_eq!(pressed.diagnostics.exact, Some("flat surface"));
        assert!(pressed.pressure.iter().all(|p| (p - 2.0).abs() < 1e-15));
        assert!(pressed.gap.iter().all(|g| g.abs() < 1e-300));
        assert!(pressed.touching_fraction() >= 1.0);
    }
    // All digits lost to an offset: a flat surface, and answered as one.
    let lost = rough.heights().iter().map(|h| h * 1e-12 + 1e6).collect();
    let lost = HeightMap::new(rough.grid(), lost).unwrap();
    let found = solve(&lost, 1e9, Method::Auto, Load::MeanPressure(5.0)).unwrap();
    assert_eq!(found.diagnostics.exact, Some("flat surface"));
}

#[test]
fn bad_loads_are_refused_by_name() {
    let rough = self_affine(unit_grid(16, 16), 0.8, 8.0, 4.0, 5);
    for value in [-1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for load in [Load::MeanPressure(value), Load::MeanGap(value)] {
            let error = solve(&rough, 1.0, Method::Auto, load).unwrap_err();
            assert!(matches!(error, SolverError::BadLoad { .. }), "{error}");
            assert!(error.to_string().contains("negative"), "{error}");
        }
    }
    let deep = solve(&rough, 1.0, Method::Auto, Load::MeanGap(1e-300)).unwrap_err();
    assert!(matches!(deep, SolverError::BadLoad { quantity: "mean gap", .. }), "{deep}");
    let mut free =
        Solver::builder().boundary(Boundary::Free).build(rough.grid(), unit_modulus()).unwrap();
    let error = free.solve(&rough, Load::MeanGap(1.0)).unwrap_err();
    assert!(matches!(error, SolverError::Combination { .. }), "{error}");
    // The solver is still usable.
    assert!(free.solve(&rough, Load::MeanPressure(0.1)).is_ok());
}

#[test]
fn bad_settings_and_wrong_grids_are_refused_by_name() {
    let grid = unit_grid(8, 8);
    let with = Solver::builder;
    let tolerances = [0.0, -1.0, 1.0, f64::NAN, f64::INFINITY];
    let tolerances = tolerances.map(|t| (with().tolerance(t), "tolerance"));
    for (builder, name) in tolerances.into_iter().chain([(with().threads(0), "threads")]) {
        let error = builder.build(grid, unit_modulus()).unwrap_err();
        let is_named = matches!(error, SolverError::BadSetting { setting, .. } if setting == name);
        assert!(is_named, "{name}: {error}");
    }
    let mut solver = with().build(grid, unit_modulus()).unwrap();
    let mut on = |grid: Grid| {
        let map = HeightMap::new(grid, vec![0.0; grid.len()]).unwrap();
        solver.solve(&map, Load::MeanPressure(1.0)).unwrap_err()
    };
    let stretched = Grid::new([8, 8], [1.0, 2.0]).unwrap();
    for other in [unit_grid(8, 9), stretched] {
        let error = on(other);
        assert!(matches!(error, SolverError::Grid { found, .. } if found == other), "{error}");
    }
}

/// Running out of iterations and being stopped both hand over what was reached.
#[test]
fn nothing_is_lost_when_a_run_ends_early() {
    // Steepest descent on pixels of 1 : 100 000 needs more than its 20 000 steps.
    let noise = self_affine(unit_grid(6, 7), 0.2, 4.0, 2.0, 4).into_heights();
    let long = HeightMap::new(Grid::new([6, 7], [1e5, 1.0]).unwrap(), noise).unwrap();
    let error = solve(&long, 1.0, Method::StanleyKato, Load::MeanPressure(0.03)).unwrap_err();
    assert!(matches!(error, SolverError::NotConverged(_)), "{error}");
    let reached = error.solution().unwrap();
    assert_eq!(reached.diagnostics.iterations, 20_000);
    assert!(reached.diagnostics.residuals.preconditioned.is_finite());
    assert!((reached.pressure.iter().sum::<f64>() / 42.0 / 0.03 - 1.0).abs() < 1e-12);

    let map = self_affine(unit_grid(64, 64), 0.8, 16.0, 2.0, 6);
    for method in METHODS {
        let mut seen = Vec::new();
        let observer = |now: &Iteration<'_>| {
            assert!(now.touching_fraction() > 0.0 && now.tolerance > 0.0);
            seen.push((now.number, now.transforms));
            if now.number >= 2 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let builder = Solver::builder().method(method).tolerance(1e-12);
        let mut solver = builder.build(map.grid(), unit_modulus()).unwrap();
        let error = solver.solve_observed(&map, Load::MeanPressure(0.05), observer).unwrap_err();
        assert!(matches!(error, SolverError::Stopped(_)));
        let reached = error.solution().unwrap();
        assert_eq!(reached.diagnostics.iterations, 2);
        assert!((reached.pressure.iter().sum::<f64>() / 4096.0 / 0.05 - 1.0).abs() < 1e-12);
        assert!(seen.windows(2).all(|w| w[0].0 <= w[1].0 && w[0].1 <= w[1].1));
    }
}

/// A tolerance that rounding does not let a method reach ends where rounding does, and says where.
#[test]
fn tolerances_below_rounding_end() {
    let map = self_affine(unit_grid(48, 48), 0.8, 12.0, 4.0, 7);
    for boundary in [Boundary::Periodic, Boundary::Free] {
        for (precision, limit) in [(Precision::Double, 1e-11), (Precision::Single, 3e-5)] {
            for method in [Method::Auto, Method::PolonskyKeer] {
                let builder = Solver::builder().method(method).boundary(boundary);
                let builder = builder.precision(precision).tolerance(1e-18);
                let mut solver = builder.build(map.grid(), unit_modulus()).unwrap();
                let error = solver.solve(&map, Load::MeanPressure(0.3)).unwrap_err();
                assert!(matches!(error, SolverError::Rounding(_)), "{error}");
                let found = &error.solution().unwrap().diagnostics;
                assert_eq!(found.end, End::Rounding);
                let residual = found.residuals.preconditioned;
                assert!(residual <= limit, "{boundary:?} {precision:?} {method:?}: {residual:e}");
                assert!(found.iterations < 2000);
            }
        }
    }
}

/// Near full contact a loose tolerance leaves more overlap than gap. Each of these loads had a negative gap once.
#[test]
fn bodies_do_not_overlap_on_average() {
    for (seed, load) in [(1, 1.5), (1, 1.6), (2, 1.3), (3, 1.6), (3, 3.0)] {
        let map = self_affine(unit_grid(64, 64), 0.8, 32.0, 4.0, seed);
        let mut solver = Solver::builder().tolerance(1e-2).build(map.grid(), modulus(1.0)).unwrap();
        let found = solver.solve(&map, Load::MeanPressure(load)).unwrap();
        let (gap, is_full) = (found.state.mean_gap.unwrap(), found.touching_fraction() >= 1.0);
        assert!(if is_full { gap == 0.0 } else { gap > 0.0 }, "{seed}, {load}: {:?}", found.state);
        assert!(found.touching_fraction() > 0.99, "{seed}, {load}: {:?}", found.state);
    }
}
