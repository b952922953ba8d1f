//! How much work each method needs for the same true error, in FFT pairs and seconds, and the
//! time of a load curve of 16 points.
//!
//! ```console
//! $ cargo run --release -p fft-bem-solver --example work_table -- 1001 1024
//! ```
//! The true error is the relative rms difference to a solution at tolerance 1e-12; the time spent
//! on measuring it is not counted. Pairs are exact, times are those of this run on this machine.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a program that prints a table")]

#[path = "common/pair.rs"]
mod pair;
#[path = "common/surface.rs"]
mod surface;

use contact_types::{ContactModulus, HeightMap};
use fft_bem_solver::{Iteration, Load, Method, Solution, Solver, SolverError};
use pair::one_pair;
use std::error::Error;
use std::ops::ControlFlow;
use std::time::Instant;
use surface::{LOAD, surface};

const ERRORS: [f64; 3] = [1e-2, 1e-4, 1e-6];
const MOST_SECONDS: f64 = 120.0;

fn main() -> Result<(), Box<dyn Error>> {
    let sizes: Vec<usize> =
        std::env::args().skip(1).map(|a| a.parse()).collect::<Result<_, _>>()?;
    println!("| size | threads | method | pairs to 1e-2 / 1e-4 / 1e-6 | seconds | one pair, ms |");
    println!("|---|---|---|---|---|---|");
    for n in sizes {
        let surface = surface(n)?;
        let exact =
            solver(&surface, Method::Chord, 1e-12, 4)?.solve(&surface, Load::MeanPressure(LOAD))?;
        for threads in [1, 4] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
            let modulus = ContactModulus::from_pascals(1.0)?;
            let pair = pool.install(|| one_pair::<f64>(surface.grid(), modulus, 10))?;
            for method in [Method::Chord, Method::PolonskyKeer, Method::StanleyKato] {
                let work = work(&surface, method, threads, &exact)?;
                let show = |k: usize, digits: usize| {
                    let cell = |w: &Option<[f64; 2]>| {
                        w.map_or("–".to_string(), |w| format!("{:.digits$}", w[k]))
                    };
                    work.each_ref().map(cell).join(" / ")
                };
                let (pairs, seconds, pair) = (show(0, 1), show(1, 2), 1e3 * pair);
                println!("| {n} | {threads} | {method} | {pairs} | {seconds} | {pair:.1} |");
            }
        }
        for tolerance in [1e-2, 1e-4, 1e-6] {
            let (pairs, seconds) = curve(&surface, tolerance)?;
            println!(
                "curve of 16 loads, {n} x {n}, {tolerance:e}: {pairs:.2} pairs per load, {seconds:.2} s"
            );
        }
    }
    Ok(())
}

fn solver(
    surface: &HeightMap,
    method: Method,
    tolerance: f64,
    threads: usize,
) -> Result<Solver, Box<dyn Error>> {
    let modulus = ContactModulus::from_pascals(1.0)?;
    let builder = Solver::builder().method(method).tolerance(tolerance).threads(threads);
    Ok(builder.build(surface.grid(), modulus)?)
}

/// Pairs and seconds until the true error stays below each of [`ERRORS`].
fn work(
    surface: &HeightMap,
    method: Method,
    threads: usize,
    exact: &Solution,
) -> Result<[Option<[f64; 2]>; 3], Box<dyn Error>> {
    let norm = |p: &[f64]| p.iter().map(|p| p * p).sum::<f64>().sqrt();
    let size = norm(&exact.pressure);
    let mut reached = [None; 3];
    let (mut spent, mut clock) = (0.0, Instant::now());
    let mut next_look = 0.0;
    let mut watch = |it: &Iteration<'_>| {
        spent += clock.elapsed().as_secs_f64();
        // A slow method need not be measured at every step: a look every 2 % of its pairs.
        if it.transforms >= next_look {
            next_look = 1.02 * it.transforms;
            let [p, _] = it.pressure_and_gap();
            let difference: Vec<f64> = p.iter().zip(&exact.pressure).map(|(a, b)| a - b).collect();
            let error = norm(&difference) / size;
            for (reached, limit) in reached.iter_mut().zip(ERRORS) {
                if error > limit {
                    *reached = None;
                } else if reached.is_none() {
                    *reached = Some([it.transforms, spent]);
                }
            }
        }
        clock = Instant::now();
        let is_done = reached.iter().all(Option::is_some) || spent > MOST_SECONDS;
        if is_done { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let mut solver = solver(surface, method, 1e-9, threads)?;
    match solver.solve_observed(surface, Load::MeanPressure(LOAD), &mut watch) {
        Ok(_) | Err(SolverError::Stopped(_) | SolverError::NotConverged(_)) => Ok(reached),
        Err(error) => Err(error.into()),
    }
}

/// Mean pairs per load and seconds of a curve from 0.005 to 1.
fn curve(surface: &HeightMap, tolerance: f64) -> Result<(f64, f64), Box<dyn Error>> {
    let loads: Vec<f64> = (0..16).map(|k| 0.005 * 200_f64.powf(f64::from(k) / 15.0)).collect();
    let mut solver = solver(surface, Method::Chord, tolerance, 4)?;
    let clock = Instant::now();
    let found = solver.curve(surface, &loads).into_iter().collect::<Result<Vec<_>, _>>()?;
    let pairs = found.iter().map(|solution| solution.diagnostics.transforms).sum::<f64>();
    Ok((pairs / loads.len() as f64, clock.elapsed().as_secs_f64()))
}
