//! What a program that uses the solver may rely on.

use crate::common;

use common::{self_affine, solve, to, unit_grid, unit_modulus};
use fft_bem_solver::{
    Boundary, End, Grid, HeightMap, Iteration, Load, Method, Precision, Solver, SolverError,
};
use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};

fn surface() -> HeightMap {
    self_affine(unit_grid(64, 48), 0.8, 16.0, 4.0, 3)
}

/// Closures that answer nothing, or whether to go on, by value or by reference; a solver that was stopped goes on.
#[test]
fn observers_are_closures() {
    let (map, load) = (surface(), Load::MeanPressure(0.05));
    let mut solver = common::solver(map.grid(), to(1e-4));
    let stop = |_: &Iteration<'_>| ControlFlow::Break(());
    let error = solver.solve_observed(&map, load, stop).unwrap_err();
    assert_eq!(error.solution().unwrap().diagnostics.end, End::Stopped);
    let mut numbers = Vec::new();
    let mut watch = |it: &Iteration<'_>| numbers.push(it.number);
    assert_eq!(solver.solve_again(load, None, &mut watch).unwrap().diagnostics.end, End::Converged);
    assert!(numbers.len() > 1 && numbers[0] == 0);
}

/// A panic of the observer comes out of the call; the solver then finds what it found before, bit for bit.
#[test]
fn a_panic_in_an_observer_leaves_the_solver_usable() {
    let map = surface();
    for method in [Method::Auto, Method::PolonskyKeer, Method::StanleyKato] {
        for load in [Load::MeanPressure(0.05), Load::MeanGap(1.0)] {
            let mut solver = common::solver(map.grid(), to(1e-4).method(method));
            let before = solver.solve(&map, load).unwrap();
            let broken = catch_unwind(AssertUnwindSafe(|| {
                solver.solve_again(load, None, |it| assert!(it.number > 1000, "as wanted"))
            }));
            assert!(broken.is_err());
            let after = solver.solve_again(load, None, |_| ()).unwrap();
            assert_eq!(before.pressure, after.pressure, "{method:?} {load:?}");
            assert_eq!(before.gap, after.gap);
        }
    }
}

/// A grid that no machine holds is refused with the bytes it would take, whatever the settings.
#[test]
fn a_grid_that_does_not_fit_is_refused() {
    let grid = Grid::new([1 << 20, 1 << 20], [1e-6, 1e-6]).unwrap();
    let with = |boundary| Solver::builder().boundary(boundary);
    for builder in [
        with(Boundary::Periodic),
        with(Boundary::Periodic).precision(Precision::Single),
        with(Boundary::Free),
        with(Boundary::Free).method(Method::PolonskyKeer),
    ] {
        let error = builder.build(grid, unit_modulus()).unwrap_err();
        assert!(error.to_string().contains("TiB"), "{error}");
        let SolverError::Memory { shape, bytes, .. } = error else { panic!("{error}") };
        assert_eq!(shape, [1 << 20; 2]);
        assert!(bytes > 28 << 40, "{bytes}"); // at least 7 numbers of 4 bytes
    }
}

/// From the pressure of a solution one convolution says that it is one. What is no pressure is no
/// start.
#[test]
fn a_start_is_a_pressure_of_each_pixel() {
    let (map, load) = (surface(), Load::MeanPressure(0.05));
    for boundary in [Boundary::Periodic, Boundary::Free] {
        let mut solver = common::solver(map.grid(), to(1e-6).boundary(boundary));
        let cold = solver.solve(&map, load).unwrap();
        let mut from =
            |start: &[f64]| solver.solve_again(load, Some(&|i| start[i]), |_| ()).unwrap();
        let again = from(&cold.pressure);
        assert_eq!(again.diagnostics.iterations, 0);
        let close = |(p, q): (&f64, &f64)| (p - q).abs() <= 1e-12 * q;
        assert!(again.pressure.iter().zip(&cold.pressure).all(close));
        let nothing = vec![f64::NAN; map.grid().len()];
        assert_eq!(from(&nothing).pressure, cold.pressure);
    }
}

/// The pressure of the trial that would come next is several times closer, for the same convolutions, and carries the load.
#[test]
fn the_last_trial_is_closer() {
    let map = surface();
    let elastic = [to(1e-2), to(1e-2).boundary(Boundary::Free)];
    for builder in elastic.into_iter().chain([to(1e-2).hardness(0.3)]) {
        let exact = solve(&map, builder.clone().tolerance(1e-9), 0.05).pressure;
        let of = |ends_on_trial| {
            let mut builder = builder.clone();
            builder.ends_on_trial = ends_on_trial;
            let found = solve(&map, builder, 0.05);
            let off = found.pressure.iter().zip(&exact).map(|(p, q)| (p - q).powi(2)).sum::<f64>();
            assert!((found.state.mean_pressure / 0.05 - 1.0).abs() < 1e-12);
            (off.sqrt(), found.diagnostics.transforms)
        };
        let ((iterate, spent), (trial, again)) = (of(false), of(true));
        assert!(trial < 0.3 * iterate && spent <= again && again <= spent, "{trial:e} {iterate:e}");
    }
}

/// With the level prescribed to a method that controls the load.
#[test]
fn an_observer_sees_no_convergence_before_the_level_is_right() {
    let map = surface();
    let tolerance = 1e-3;
    let load = Load::MeanGap(solve(&map, to(1e-6), 0.05).state.mean_gap.unwrap());
    let exact = common::solver(map.grid(), to(1e-9)).solve(&map, load).unwrap();
    let mut solver = common::solver(map.grid(), to(tolerance).method(Method::PolonskyKeer));
    let stop = |it: &Iteration<'_>| {
        if it.residual <= tolerance { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let stopped = solver.solve_observed(&map, load, stop).unwrap_err();
    solver.forget();
    let whole = solver.solve(&map, load).unwrap();
    for found in [stopped.solution().unwrap(), &whole] {
        let off = found.state.mean_pressure / exact.state.mean_pressure - 1.0;
        assert!(off.abs() < 3.0 * tolerance, "converged, it said, at a load wrong by {off:e}");
    }
}

/// Up to 1:30 000 they are solved as fast as others, up to 1:100 000 solved.
#[test]
fn pixels_too_long_are_refused_with_the_reason() {
    let map = self_affine(unit_grid(32, 32), 0.8, 16.0, 4.0, 3);
    for long in [[1.0, 3e4], [3e4, 1.0], [1.0, 1e5], [1e5, 1.0]] {
        let grid = Grid::new([32, 32], long).unwrap();
        let map = HeightMap::new(grid, map.heights().to_vec()).unwrap();
        let found = solve(&map, Solver::builder(), 0.05).diagnostics;
        assert_eq!(found.end, End::Converged);
        let is_fast = long.contains(&3e4);
        assert!(found.transforms < if is_fast { 10.0 } else { 50.0 }, "{}", found.transforms);
        let longer = Grid::new([32, 32], long.map(|side| if side > 1.0 { 1e6 } else { 1.0 }));
        let error = Solver::builder().build(longer.unwrap(), unit_modulus()).unwrap_err();
        assert!(matches!(error, SolverError::Range { .. }));
        assert!(error.to_string().contains("1e6"), "{error}");
    }
}

/// A load that presses every pixel of an isolated map home leaves no gap, however large it is.
#[test]
fn a_free_map_in_full_contact_has_no_gap() {
    let map = self_affine(unit_grid(24, 24), 0.8, 16.0, 4.0, 3);
    for load in [1e3, 1e20] {
        let found = solve(&map, Solver::builder().boundary(Boundary::Free), load);
        assert_eq!(found.diagnostics.contact_pixels, 24 * 24);
        assert!(found.state.mean_gap.unwrap().abs() < 1e-300);
    }
}
