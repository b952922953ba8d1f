//! What a solution says about its own error, against its true error.

use crate::common;

use common::{difference, energy_norm, iterate, measured_like, self_affine, solve, to, unit_grid};
use contact_types::HeightMap;
use fft_bem_solver::{Boundary, Method, Solution, Solver, SolverBuilder};

/// Rough surfaces resolved (A8), rough to the pixel (B8, B3), like a measurement (C), and a ball.
fn families(n: usize, seed: u64) -> Vec<(&'static str, HeightMap)> {
    let grid = unit_grid(n, n);
    let rolloff = n as f64 / 8.0;
    let ball = |y: f64, x: f64| {
        let r2 = (y - 0.47 * n as f64).powi(2) + (x - 0.5 * n as f64).powi(2);
        -r2 / n as f64
    };
    vec![
        ("A8", self_affine(grid, 0.8, rolloff, 8.0, seed)),
        ("B8", self_affine(grid, 0.8, rolloff, 2.0, seed)),
        ("B3", self_affine(grid, 0.3, rolloff, 2.0, seed)),
        ("C", measured_like(n, seed)),
        ("D", HeightMap::from_fn(grid, ball).unwrap()),
    ]
}

fn certified(method: Method, boundary: Boundary) -> SolverBuilder {
    Solver::builder().method(method).boundary(boundary).certified(true)
}

fn exact(map: &HeightMap, boundary: Boundary, load: f64) -> Solution {
    solve(map, certified(Method::Auto, boundary).tolerance(1e-11), load)
}

/// The bound holds for every iterate of every method, and is not far above the truth.
#[test]
fn energy_bound_is_never_violated_and_tight() {
    let mut ratios = Vec::new();
    for boundary in [Boundary::Periodic, Boundary::Free] {
        for seed in 1..=2 {
            for (name, map) in families(40, seed) {
                for load in [0.005, 0.05, 0.3] {
                    let truth = exact(&map, boundary, load);
                    let size = energy_norm(map.grid(), boundary, &truth.pressure);
                    for (method, counts) in [
                        (Method::Auto, [1, 2, 4, 6]),
                        (Method::PolonskyKeer, [2, 6, 15, 40]),
                        (Method::StanleyKato, [2, 6, 15, 40]),
                    ] {
                        for count in counts {
                            let found = iterate(&map, certified(method, boundary), load, count);
                            let pairs = found.pressure.iter().zip(&truth.pressure);
                            let difference: Vec<f64> = pairs.map(|(a, b)| a - b).collect();
                            let error = energy_norm(map.grid(), boundary, &difference);
                            let bound = found.diagnostics.energy_bound.unwrap()
                                * energy_norm(map.grid(), boundary, &found.pressure);
                            let place = format!("{name} {load} {boundary:?} {method:?} {count}");
                            if error > 1e-8 * size {
                                let holds = error <= bound * (1.0 + 1e-6);
                                assert!(holds, "{place}: {error} > {bound}");
                                ratios.push(bound / error);
                            }
                            // The duality gap bounds twice the energy error as well.
                            let gap = found.diagnostics.duality_gap * map.grid().len() as f64;
                            let most = 2.0 * gap * (1.0 + 1e-6) + 1e-18 * size * size;
                            assert!(error * error <= most, "{place}: {error} and {gap}");
                        }
                    }
                }
            }
        }
    }
    assert!(ratios.len() > 400, "{}", ratios.len());
    ratios.sort_by(f64::total_cmp);
    let quantile = |q: f64| ratios[(q * (ratios.len() - 1) as f64) as usize];
    assert!(quantile(0.5) < 2.5, "median {}", quantile(0.5));
    assert!(quantile(0.95) < 7.0, "95 % {}", quantile(0.95));
}

/// The residual at which each method stops predicts the true relative rms error of the pressure.
#[test]
fn tolerance_is_the_error_reached() {
    for (name, map) in families(64, 3) {
        for load in [0.01, 0.1, 0.5] {
            let truth = exact(&map, Boundary::Periodic, load);
            for method in [Method::Auto, Method::PolonskyKeer, Method::StanleyKato] {
                for tolerance in [1e-2, 1e-4, 1e-6] {
                    let found = solve(&map, to(tolerance).method(method), load);
                    let error = difference(&found.pressure, &truth.pressure);
                    let limit = tolerance * if method == Method::Auto { 1.5 } else { 2.0 };
                    assert!(error < limit, "{name} {load} {method:?}: {error:e} {tolerance:e}");
                }
            }
        }
    }
}
