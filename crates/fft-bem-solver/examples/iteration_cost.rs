//! What one chord iteration costs beside the FFT pair it contains: milliseconds per pair, per
//! iteration, and their ratio; and what it brings: pair times per digit of the estimate.
//!
//! ```console
//! $ cargo run --release -p fft-bem-solver --example iteration_cost -- 1001 1024 2048
//! ```
//! A pair is one `Convolution` of the same size, type and threads, whose symbol lies in a table. An
//! iteration is everything between one look of the observer and the next, from the first iteration
//! to an estimate of 1e-6 (single precision 1e-4). Pairs and solves alternate; the least of the
//! repeats counts. The steps before the first pair are not in it: they are in the times of
//! `work_table`. Those before later ones are.

#![allow(clippy::print_stdout, reason = "a program that prints a table")]

#[path = "common/surface.rs"]
mod surface;

use contact_types::{ContactModulus, HeightMap};
use fft_bem_solver::{Iteration, Load, Precision, Real, Solver};
use grid_fft::{Convolution, parallel};
use std::error::Error;
use std::ops::ControlFlow;
use std::time::Instant;
use surface::{LOAD, surface};

const REPEATS: usize = 9;

fn main() -> Result<(), Box<dyn Error>> {
    let sizes: Vec<usize> =
        std::env::args().skip(1).map(|a| a.parse()).collect::<Result<_, _>>()?;
    println!(
        "| size | type | threads | one pair, ms | one iteration, ms | pairs per iteration | per digit |"
    );
    println!("|---|---|---:|---:|---:|---:|---:|");
    for n in sizes {
        let surface = surface(n)?;
        for threads in [1, parallel::threads()] {
            for (name, precision) in [("f64", Precision::Double), ("f32", Precision::Single)] {
                let [pair, iteration, digits] = if precision == Precision::Double {
                    measure::<f64>(&surface, precision, threads, 1e-6)?
                } else {
                    measure::<f32>(&surface, precision, threads, 1e-4)?
                };
                let ratio = iteration / pair;
                let (pair, iteration) = (1e3 * pair, 1e3 * iteration);
                let by_digit = ratio / digits;
                println!(
                    "| {n} | {name} | {threads} | {pair:.2} | {iteration:.2} | {ratio:.2} | {by_digit:.2} |"
                );
            }
        }
    }
    Ok(())
}

/// Least seconds of a pair and of an iteration, and the digits that one brings.
fn measure<T: Real>(
    surface: &HeightMap,
    precision: Precision,
    threads: usize,
    tolerance: f64,
) -> Result<[f64; 3], Box<dyn Error>> {
    let [ny, nx] = surface.grid().shape();
    let builder = Solver::builder().precision(precision).tolerance(tolerance).threads(threads);
    let mut solver = builder.build(surface.grid(), ContactModulus::from_pascals(1.0)?)?;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
    let convolution = pool.install(|| Convolution::<T>::new([ny, nx]));
    let symbol = vec![T::of(0.9); (ny / 2 + 1) * (nx / 2 + 1)];
    let field: Vec<T> = (0..ny * nx).map(|i| T::of((0.37 * i as f64).sin())).collect();
    let mut out = field.clone();
    let column = |kx: usize, column: &mut [T]| {
        let length = column.len();
        column.copy_from_slice(&symbol[kx * length..][..length]);
    };
    let (mut pair, mut iteration, mut digits) = (f64::INFINITY, f64::INFINITY, 0.0);
    for _ in 0..REPEATS {
        for _ in 0..4 {
            let clock = Instant::now();
            pool.install(|| convolution.apply(&field, column, &mut out));
            pair = pair.min(clock.elapsed().as_secs_f64());
        }
        solver.forget();
        let (mut first, mut last) = (None, (0, 0.0, 0.0));
        let clock = Instant::now();
        let mut watch = |it: &Iteration<'_>| {
            let seconds = clock.elapsed().as_secs_f64();
            first.get_or_insert((seconds, it.residual));
            last = (it.number, seconds, it.residual);
            ControlFlow::Continue(())
        };
        solver.solve_observed(surface, Load::MeanPressure(LOAD), &mut watch)?;
        let (iterations, end, residual) = last;
        let (begin, before) = first.unwrap_or((end, residual));
        iteration = iteration.min((end - begin) / iterations as f64);
        digits = (before / residual).log10() / iterations as f64;
    }
    Ok([pair, iteration, digits])
}
