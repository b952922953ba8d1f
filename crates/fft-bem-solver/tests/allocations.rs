//! Iterations allocate nothing: a solve of many iterations makes as many allocations as one of few.

#![cfg(feature = "parallel")]
#![allow(clippy::unwrap_used, reason = "tests may stop where their input is wrong")]

mod common;

use common::{self_affine, unit_grid, unit_modulus};
use fft_bem_solver::{Boundary, Load, Maps, Method, Precision, Solver, SolverBuilder};

/// Allocations and iterations of a cold solve, everything on the thread that counts.
fn cold_solve(builder: SolverBuilder, tolerance: f64, load: Load) -> (u64, usize) {
    let grid = unit_grid(150, 140); // more than one task, odd rows of cells
    let surface = self_affine(grid, 0.8, 20.0, 4.0, 1);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    pool.install(|| {
        let mut solver =
            builder.maps(Maps::None).tolerance(tolerance).build(grid, unit_modulus()).unwrap();
        solver.solve(&surface, load).unwrap(); // threads and queues warm up
        solver.forget();
        let mut iterations = 0;
        let counted = allocation_counter::measure(|| {
            iterations = solver.solve(&surface, load).unwrap().diagnostics.iterations;
        });
        (counted.count_total, iterations)
    })
}

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
