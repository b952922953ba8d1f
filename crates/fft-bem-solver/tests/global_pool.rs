//! A solver does not start rayon's global pool, whose threads a forked child would wait for in vain. A test
//! of its own process, since the pool is one per process.

#![cfg(feature = "parallel")]
#![allow(clippy::unwrap_used, reason = "tests may stop where their input is wrong")]

mod common;

use common::{self_affine, unit_grid, unit_modulus};
use fft_bem_solver::{Boundary, Load, Method, Solver};

#[test]
fn is_left_alone() {
    let map = self_affine(unit_grid(96, 100), 0.8, 16.0, 4.0, 3);
    // What made the map may use it; what solves may not.
    let is_untouched = || rayon::ThreadPoolBuilder::new().num_threads(1).build_global().is_ok();
    for boundary in [Boundary::Periodic, Boundary::Free] {
        for method in [Method::Auto, Method::PolonskyKeer, Method::StanleyKato] {
            let builder = Solver::builder().method(method).boundary(boundary).certified(true);
            let mut solver = builder.build(map.grid(), unit_modulus()).unwrap();
            solver.solve(&map, Load::MeanPressure(0.05)).unwrap();
            solver.forget();
            drop(solver.curve(&map, &[0.01, 0.02, 0.04]));
        }
    }
    assert!(is_untouched(), "a solver has started the global pool");
    assert!(!is_untouched(), "this would not be seen");
}
