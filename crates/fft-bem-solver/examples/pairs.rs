//! FFT pairs the default method needs, over surfaces and loads: from nothing, with the mean gap
//! prescribed, and per load along a curve of 16. Pairs are exact: the same on every machine.
//!
//! ```console
//! $ cargo run --release -p fft-bem-solver --example pairs -- 512 1024
//! ```
//! Surfaces: self-affine from an eighth of the side, H = 0.8 down to 8 pixels (A8), H = 0.8 and 0.3
//! down to two (B8, B3); measured-like, not periodic, in steps of 1 % of the rms height (C). Loads:
//! mean pressure over E* times the rms gradient from 0.005 to 1. Pairs are counted until the *true*
//! relative rms error of the pressure (against a solution at 1e-9) stays below 1e-2 / 1e-4 / 1e-6;
//! along a curve, each load starts from solutions at that tolerance. What the user of a curve waits for
//! is that the solver says so: that count is printed as well, with the largest true error met then.

#![allow(clippy::print_stdout, reason = "a program that prints a table")]

use contact_types::{ContactModulus, Grid, HeightMap};
use fft_bem_solver::{Iteration, Load, Method, Solution, Solver, SolverError};
use std::error::Error;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicUsize, Ordering};
use surface_stats::synthesis::{Scale, SelfAffine};
use surface_stats::{Level, level};

type Outcome<T> = Result<T, Box<dyn Error>>;

const ERRORS: [f64; 3] = [1e-2, 1e-4, 1e-6];
const NAMES: [&str; 4] = ["A8", "B8", "B3", "C"];
/// Every third load is solved on its own as well.
const STRIDE: usize = 3;

fn main() -> Outcome<()> {
    let sizes: Vec<usize> =
        std::env::args().skip(1).map(|a| a.parse()).collect::<Result<_, _>>()?;
    let loads: Vec<f64> = (0..16).map(|k| 0.005 * 200_f64.powf(f64::from(k) / 15.0)).collect();
    println!("| size | surface | | pairs to 1e-2 / 1e-4 / 1e-6: median | worst |");
    println!("|---|---|---|---|---|");
    let [mut cold, mut gap] = [(); 2].map(|()| Counts::default());
    let [mut curve, mut estimated] = [(); 2].map(|()| Counts::default());
    for n in sizes {
        for name in NAMES {
            let map = surface(name, n)?;
            let exact = solutions(&map, 1e-9, &loads)?;
            let [mut by_load, mut by_gap] = [(); 2].map(|()| Counts::default());
            let [mut along, mut said] = [(); 2].map(|()| Counts::default());
            for (k, exact) in exact.iter().enumerate().step_by(STRIDE) {
                by_load.add(pairs(&map, Load::MeanPressure(loads[k]), exact)?);
                if let Some(g) = exact.state.mean_gap.filter(|g| *g > 0.0) {
                    by_gap.add(pairs(&map, Load::MeanGap(g), exact)?);
                }
            }
            let mut largest = [0.0_f64; 3];
            for (t, tolerance) in ERRORS.into_iter().enumerate() {
                for found in along_curve(&map, tolerance, &loads, &exact)? {
                    along.each[t].push(found.to_true_error);
                    said.each[t].push(found.to_estimate);
                    largest[t] = largest[t].max(found.error);
                }
            }
            println!("| {n} | {name} | cold | {by_load} |");
            println!("| {n} | {name} | mean gap | {by_gap} |");
            println!("| {n} | {name} | curve, mean {} | {along} |", along.mean());
            let errors = largest.map(|x| format!("{x:.1e}")).join(" / ");
            let mean = said.mean();
            println!("| {n} | {name} | curve by estimate, mean {mean} (error {errors}) | {said} |");
            cold.append(by_load);
            gap.append(by_gap);
            curve.append(along);
            estimated.append(said);
        }
    }
    println!("| all | all | cold | {cold} |");
    println!("| all | all | mean gap | {gap} |");
    println!("| all | all | curve, mean {} | {curve} |", curve.mean());
    println!("| all | all | curve by estimate, mean {} | {estimated} |", estimated.mean());
    Ok(())
}

/// Pairs to each of [`ERRORS`].
#[derive(Default)]
struct Counts {
    each: [Vec<f64>; 3],
}

impl Counts {
    fn add(&mut self, pairs: [f64; 3]) {
        self.each.iter_mut().zip(pairs).for_each(|(all, one)| all.push(one));
    }

    fn append(&mut self, other: Self) {
        self.each.iter_mut().zip(other.each).for_each(|(all, more)| all.extend(more));
    }

    fn mean(&self) -> String {
        let mean = |x: &Vec<f64>| x.iter().sum::<f64>() / x.len() as f64;
        self.each.each_ref().map(|x| format!("{:.2}", mean(x))).join(" / ")
    }
}

impl std::fmt::Display for Counts {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let at = |q: f64| {
            let one = |x: &Vec<f64>| {
                let mut x = x.clone();
                x.sort_by(f64::total_cmp);
                format!("{:.2}", x[((x.len() - 1) as f64 * q) as usize])
            };
            self.each.each_ref().map(one).join(" / ")
        };
        write!(f, "{} | {}", at(0.5), at(1.0))
    }
}

fn surface(name: &str, n: usize) -> Outcome<HeightMap> {
    let recipe = |n: usize, hurst: f64, rolloff: f64, cutoff: f64| {
        let scale = Scale::RmsGradient(1.0);
        let grid = Grid::new([n, n], [1.0, 1.0])?;
        Ok::<_, Box<dyn Error>>(
            SelfAffine { grid, hurst, rolloff, cutoff, scale, seed: 1, quantise: None }
                .generate()?,
        )
    };
    let long = n as f64 / 8.0;
    Ok(match name {
        "A8" => recipe(n, 0.8, long, 8.0)?,
        "B8" => recipe(n, 0.8, long, 2.0)?,
        "B3" => recipe(n, 0.3, long, 2.0)?,
        _ => {
            let large = recipe(2 * n, 0.8, 8.0 * n as f64, 2.0)?;
            let grid = Grid::new([n, n], [1.0, 1.0])?;
            let crop = (0..n * n).map(|i| large.at(i / n, i % n)).collect();
            let flat = level(&HeightMap::new(grid, crop)?, Level::Plane)?;
            let rms = (flat.heights().iter().map(|h| h * h).sum::<f64>() / (n * n) as f64).sqrt();
            let step = 0.01 * rms;
            let heights: Vec<f64> =
                flat.heights().iter().map(|h| (h / step).round() * step).collect();
            let inner = (0..n * n).filter(|i| i / n + 1 < n && i % n + 1 < n);
            let square = |i: usize| {
                (heights[i + 1] - heights[i]).powi(2) + (heights[i + n] - heights[i]).powi(2)
            };
            let gradient = (inner.map(square).sum::<f64>() / ((n - 1) * (n - 1)) as f64).sqrt();
            HeightMap::new(grid, heights.iter().map(|h| h / gradient).collect())?
        }
    })
}

fn solver(map: &HeightMap, tolerance: f64) -> Outcome<Solver> {
    let modulus = ContactModulus::from_pascals(1.0)?;
    let builder = Solver::builder().method(Method::Chord).tolerance(tolerance);
    Ok(builder.build(map.grid(), modulus)?)
}

/// Solutions along the curve.
fn solutions(map: &HeightMap, tolerance: f64, loads: &[f64]) -> Outcome<Vec<Solution>> {
    let found = solver(map, tolerance)?.curve(map, loads);
    Ok(found.into_iter().collect::<Result<_, SolverError>>()?)
}

/// One load of a curve.
#[derive(Clone, Copy, Default)]
struct OnCurve {
    /// Pairs until the true error stays below the tolerance, and until the solver says so.
    to_true_error: f64,
    to_estimate: f64,
    /// True error of the solution.
    error: f64,
}

/// A curve at a tolerance, against the `exact` solutions of its rising `loads`.
fn along_curve(
    map: &HeightMap,
    tolerance: f64,
    loads: &[f64],
    exact: &[Solution],
) -> Outcome<Vec<OnCurve>> {
    let present = AtomicUsize::new(0); // index of the load
    let mut reached = vec![None; loads.len()];
    let mut watch = |it: &Iteration<'_>| {
        let k = present.load(Ordering::Relaxed);
        let error = error(&it.pressure_and_gap()[0], &exact[k]);
        reached[k] = if error > tolerance { None } else { reached[k].or(Some(it.transforms)) };
        ControlFlow::Continue(())
    };
    let mut found = Vec::new();
    solver(map, tolerance)?.curve_observed(map, loads, &mut watch, |k, result| {
        present.store(k + 1, Ordering::Relaxed);
        found.push(result);
        ControlFlow::Continue(())
    });
    let found = found.into_iter().collect::<Result<Vec<_>, _>>()?;
    let one = |((found, exact), reached): ((&Solution, &Solution), &Option<f64>)| {
        let to_estimate = found.diagnostics.transforms;
        let to_true_error = reached.unwrap_or(to_estimate);
        OnCurve { to_true_error, to_estimate, error: error(&found.pressure, exact) }
    };
    Ok(found.iter().zip(exact).zip(&reached).map(one).collect())
}

fn error(pressure: &[f64], exact: &Solution) -> f64 {
    let norm = |p: &mut dyn Iterator<Item = f64>| p.map(|p| p * p).sum::<f64>().sqrt();
    let difference = norm(&mut pressure.iter().zip(&exact.pressure).map(|(a, b)| a - b));
    difference / norm(&mut exact.pressure.iter().copied())
}

/// Pairs until the true error stays below each of [`ERRORS`].
fn pairs(map: &HeightMap, load: Load, exact: &Solution) -> Outcome<[f64; 3]> {
    let mut reached = [None; 3];
    let mut watch = |it: &Iteration<'_>| {
        let error = error(&it.pressure_and_gap()[0], exact);
        for (reached, limit) in reached.iter_mut().zip(ERRORS) {
            *reached = if error > limit { None } else { reached.or(Some(it.transforms)) };
        }
        ControlFlow::Continue(())
    };
    let found = solver(map, 0.1 * ERRORS[2])?.solve_observed(map, load, &mut watch)?;
    Ok(reached.map(|r| r.unwrap_or(found.diagnostics.transforms)))
}
