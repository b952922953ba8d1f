//! What concerns the whole process: allocations, and the global pool of rayon. In a program of their own.

#![cfg(feature = "parallel")]
#![allow(clippy::unwrap_used, reason = "tests may stop where their input is wrong")]

mod common;

use common::{self_affine, solver, unit_grid};
use fft_bem_solver::{Boundary, Load, Maps, Method, Precision, Solver, SolverBuilder};

/// Allocations and iterations of a cold solve, everything on the thread that counts.
fn cold_solve(builder: SolverBuilder, tolerance: f64, load: Load) -> (u64, usize) {
    let grid = unit_grid(150, 140); // more than one task, odd rows of cells
    let surface = self_affine(grid, 0.8, 20.0, 4.0, 1);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    pool.install(|| {
        let mut solver = solver(grid, builder.maps(Maps::None).tolerance(tolerance));
        solver.solve(&surface, load).unwrap(); // threads and queues warm up
        solver.forget();
        let mut iterations = 0;
        let counted = allocation_counter::measure(|| {
            iterations = solver.solve(&surface, load).unwrap().diagnostics.iterations;
        });
        (counted.count_total, iterations)
    })
}

/// A solve of many iterations makes as many allocations as one of few.
#[test]
fn iterations_allocate_nothing() {
    let pressure = Load::MeanPressure(0.05);
    let with = |method| Solver::builder().method(method);
    let cases = [
        ("chord", with(Method::Chord), pressure),
        ("chord, f32", with(Method::Chord).precision(Precision::Single), Load::MeanPressure(0.2)),
        ("chord, mean gap", with(Method::Chord), Load::MeanGap(1.0)),
        ("chord, free", with(Method::Chord).boundary(Boundary::Free), pressure),
        ("Polonsky-Keer", with(Method::PolonskyKeer), pressure),
        ("Stanley-Kato", with(Method::StanleyKato), pressure),
    ];
    for (name, builder, load) in cases {
        let fine = if name == "chord, f32" { 1e-4 } else { 1e-6 };
        let (few, first) = cold_solve(builder.clone(), 3e-2, load);
        let (many, last) = cold_solve(builder, fine, load);
        assert!(last > first + 1, "{name}: {first} and {last} iterations");
        assert!(few > 0, "{name}: what this thread allocates is counted");
        assert_eq!(few, many, "{name}: allocations in {first} and in {last} iterations");
    }
}

/// A solver does not start rayon's global pool, whose threads a forked child would wait for in vain.
#[test]
fn the_global_pool_is_left_alone() {
    let map = self_affine(unit_grid(96, 100), 0.8, 16.0, 4.0, 3);
    // What made the map may use it; what solves may not.
    let is_untouched = || rayon::ThreadPoolBuilder::new().num_threads(1).build_global().is_ok();
    for boundary in [Boundary::Periodic, Boundary::Free] {
        for method in [Method::Auto, Method::PolonskyKeer, Method::StanleyKato] {
            let builder = Solver::builder().method(method).boundary(boundary).certified(true);
            let mut solver = solver(map.grid(), builder);
            solver.solve(&map, Load::MeanPressure(0.05)).unwrap();
            solver.solve(&map, Load::MeanPressure(0.02)).unwrap();
        }
    }
    assert!(is_untouched(), "a solver has started the global pool");
    assert!(!is_untouched(), "this would not be seen");
}
