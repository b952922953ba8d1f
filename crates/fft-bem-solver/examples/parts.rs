//! Where the time of a cold solve goes, by part, in units of one FFT pair.
//!
//! ```console
//! $ cargo run --release -p fft-bem-solver --features parts --example parts -- 512 1024 2048
//! ```
//! The surface is that of `work_table`: H = 0.8 from an eighth of the side down to 8 pixels. On one thread, in double
//! precision, without maps. Pairs, each one application of a `HalfSpace`, and solves alternate; a part counts with
//! the least of its times, in units of the least of a pair, and the last row is the sum: so a busy machine
//! changes little. Every solver is built anew, so that its memory is touched for the first time.

#![allow(clippy::print_stdout, reason = "a program that prints a table")]

#[path = "common/surface.rs"]
#[allow(dead_code, reason = "its load is that of other programs")]
mod surface;

use contact_types::{ContactModulus, HeightMap};
use fft_bem_solver::{HalfSpace, Load, Maps, Solver, take_parts};
use std::error::Error;
use std::time::Instant;
use surface::surface;

/// Mean pressure over E* times the rms gradient.
const LOADS: [f64; 4] = [0.005, 0.02, 0.1, 0.4];
const TOLERANCES: [f64; 2] = [1e-4, 1e-6];
/// Pixels that are solved, in all repeats of one load together.
const PIXELS: usize = 24 << 20;

fn main() -> Result<(), Box<dyn Error>> {
    let sizes: Vec<usize> =
        std::env::args().skip(1).map(|a| a.parse()).collect::<Result<_, _>>()?;
    for n in sizes {
        let surface = surface(n)?;
        for tolerance in TOLERANCES {
            table(&surface, tolerance)?;
        }
    }
    Ok(())
}

/// Prints one table: parts in rows, loads in columns.
fn table(surface: &HeightMap, tolerance: f64) -> Result<(), Box<dyn Error>> {
    let n = surface.grid().shape()[0];
    let repeats = (PIXELS / surface.grid().len()).clamp(6, 40);
    let modulus = ContactModulus::from_pascals(1.0)?;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    let mut half_space = pool.install(|| HalfSpace::<f64>::new(surface.grid(), modulus));
    let mut field: Vec<f64> = (0..n * n).map(|i| (i % 97) as f64).collect();
    let mut other = field.clone();
    let (mut pairs, mut copies) = (Vec::new(), Vec::new());
    let mut names: Vec<String> = Vec::new();
    let mut seconds: Vec<[Vec<f64>; LOADS.len()]> = Vec::new();
    for repeat in 0..repeats {
        for (column, load) in LOADS.into_iter().enumerate() {
            for _ in 0..3 {
                let clock = Instant::now();
                pool.install(|| half_space.displace(&mut field))?;
                pairs.push(clock.elapsed().as_secs_f64());
                let clock = Instant::now();
                pool.install(|| other.copy_from_slice(&field));
                copies.push(clock.elapsed().as_secs_f64());
            }
            take_parts();
            let clock = Instant::now();
            let builder = Solver::builder().threads(1).tolerance(tolerance).maps(Maps::None);
            let mut solver = builder.build(surface.grid(), modulus)?;
            let planning = clock.elapsed().as_secs_f64();
            solver.solve(surface, Load::MeanPressure(load))?;
            let all = clock.elapsed().as_secs_f64();
            let mut parts = take_parts();
            let known: f64 = parts.iter().map(|(_, seconds)| seconds).sum();
            parts.insert(0, ("planning", planning));
            parts.push(("other", all - planning - known));
            let (mut is_guess, mut solves) = (true, false);
            for (part, time) in parts {
                solves |= part == "start";
                is_guess &= part != "pair";
                let name = match part {
                    "answer" | "level of the answer" | "other" => part.to_string(),
                    _ if !solves || part == "start" => part.to_string(),
                    _ if is_guess => format!("guess: {part}"),
                    _ => format!("step: {part}"),
                };
                let row = names.iter().position(|known| *known == name).unwrap_or_else(|| {
                    names.push(name);
                    seconds.push(LOADS.map(|_| Vec::new()));
                    names.len() - 1
                });
                let times = &mut seconds[row][column];
                times.resize(repeat + 1, 0.0);
                times[repeat] += time;
            }
        }
    }
    let pair = least(&pairs);
    let copy = least(&copies) / pair;
    println!("\n{n} x {n}, to {tolerance:e}; one pair {:.2} ms, {repeats} repeats;", 1e3 * pair);
    println!("a field copied, 16 bytes per pixel moved: {copy:.2} pairs\n");
    println!("| part |{} |", LOADS.map(|load| format!(" {load}")).join(" |"));
    println!("|---|{}", "---:|".repeat(LOADS.len()));
    let mut sums = LOADS.map(|_| 0.0);
    for (name, times) in names.iter().zip(&seconds) {
        let times = times.each_ref().map(|times| least(times) / pair);
        sums.iter_mut().zip(times).for_each(|(sum, time)| *sum += time);
        println!("| {name} |{} |", times.map(|time| format!(" {time:.2}")).join(" |"));
    }
    println!("| all |{} |", sums.map(|sum| format!(" {sum:.1}")).join(" |"));
    Ok(())
}

fn least(times: &[f64]) -> f64 {
    times.iter().copied().fold(f64::INFINITY, f64::min)
}
