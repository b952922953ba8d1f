//! What a load of a curve costs: FFT pairs, and time in units of one pair, one thread, 16 loads from 0.005 to 1 of E*
//! times the rms gradient; each from the last two solutions, as `Solver::curve` does it, and from the last alone.
//!
//! ```console
//! $ cargo run --release -p fft-bem-solver --example curve -- 512 1024
//! ```
//! Pairs and curves alternate; of each load the least time over the repeats counts.

#![allow(clippy::print_stdout, reason = "a program that prints a table")]

#[path = "common/pair.rs"]
mod pair;
#[path = "common/surface.rs"]
#[allow(dead_code, reason = "its load is that of other programs")]
mod surface;

use contact_types::{ContactModulus, HeightMap};
use fft_bem_solver::{Load, Maps, Solver};
use pair::one_pair;
use std::error::Error;
use surface::surface;

const LOADS: usize = 16;
const REPEATS: usize = 5;

fn main() -> Result<(), Box<dyn Error>> {
    println!("| size | tolerance | start | pairs per load | pair times per load | most |");
    println!("|---|---|---|---:|---:|---:|");
    for size in std::env::args().skip(1) {
        let surface = surface(size.parse()?)?;
        for tolerance in [1e-2, 1e-4, 1e-6] {
            for (name, extrapolates) in [("last two", true), ("last", false)] {
                let [pairs, times, most] = cost(&surface, tolerance, extrapolates)?;
                println!(
                    "| {size}² | {tolerance:e} | {name} | {pairs:.2} | {times:.1} | {most:.1} |"
                );
            }
        }
    }
    Ok(())
}

/// Pairs and pair times per load, the first of which is solved cold; and pair times of the dearest of the others.
fn cost(
    surface: &HeightMap,
    tolerance: f64,
    extrapolates: bool,
) -> Result<[f64; 3], Box<dyn Error>> {
    let modulus = ContactModulus::from_pascals(1.0)?;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    let builder = Solver::builder().threads(1).tolerance(tolerance).maps(Maps::None);
    let mut solver = builder.build(surface.grid(), modulus)?;
    let loads: Vec<f64> =
        (0..LOADS).map(|k| 0.005 * 200_f64.powf(k as f64 / (LOADS - 1) as f64)).collect();
    let (mut pair, mut seconds, mut pairs) = (f64::INFINITY, [f64::INFINITY; LOADS], 0.0);
    for _ in 0..REPEATS {
        pair = pair.min(pool.install(|| one_pair::<f64>(surface.grid(), modulus, 4))?);
        solver.forget();
        pairs = 0.0;
        let found = if extrapolates {
            solver.curve(surface, &loads)
        } else {
            loads.iter().map(|&p| solver.solve(surface, Load::MeanPressure(p))).collect()
        };
        for (seconds, solution) in seconds.iter_mut().zip(found) {
            let found = solution?.diagnostics;
            *seconds = seconds.min(found.seconds);
            pairs += found.transforms;
        }
    }
    let all: f64 = seconds.iter().sum();
    let most = seconds[1..].iter().copied().fold(0.0, f64::max);
    let loads = LOADS as f64;
    Ok([pairs / loads, all / loads / pair, most / pair])
}
