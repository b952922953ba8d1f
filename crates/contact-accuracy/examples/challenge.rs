//! A map by the recipe of the contact-mechanics challenge (Müser et al. 2017, doi:10.1007/s11249-017-0900-2), without its
//! adhesion, from light load to full contact: area, gap and stiffness, convolutions, time and memory.
//!
//! ```console
//! $ cargo run --release -p contact-accuracy --example challenge -- 2048 4096 8192
//! $ cargo run --release -p contact-accuracy --example challenge -- single 16384
//! ```
//! H = 0.8, flat beyond 20 µm, shortest wave 0.1 µm, side 100 µm, rms gradient 1. The same recipe on every grid,
//! but not the same map: the noise that is filtered is drawn point by point. Every load is solved cold, to 1e-4. Time is that
//! of the solve, in seconds and in units of the least of three convolutions before it. Memory is the peak of the first
//! solve (Linux, `VmHWM`), without the map.

#![allow(clippy::print_stdout, reason = "a program that prints a table")]

use contact_accuracy::{Map, Numbers};
use contact_types::{ContactModulus, Grid};
use fft_bem_solver::{
    Diagnostics, HalfSpace, Load, Maps, Precision, Real, Solution, Solver, SolverError,
};
use std::error::Error;
use std::time::Instant;
use surface_stats::synthesis::{Scale, SelfAffine};

/// Side, roll-off and shortest wave (m).
const SIDE: f64 = 100e-6;
const ROLLOFF: f64 = 20e-6;
const SHORTEST: f64 = 0.1e-6;
/// Contact modulus (Pa), that of the challenge: nothing below depends on it.
const MODULUS: f64 = 25e6;
/// Mean pressure over E*, which is E* times the gradient. That of the challenge is 0.01.
const LOADS: [f64; 9] = [0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0, 2.0, 4.0];
const TOLERANCE: f64 = 1e-4;
const REPEATS: usize = 3;

fn main() -> Result<(), Box<dyn Error>> {
    let mut precision = Precision::Double;
    for argument in std::env::args().skip(1) {
        match argument.as_str() {
            "double" => precision = Precision::Double,
            "single" => precision = Precision::Single,
            side => table(side.parse()?, precision)?,
        }
    }
    Ok(())
}

fn table(n: usize, precision: Precision) -> Result<(), Box<dyn Error>> {
    let pixel = SIDE / n as f64;
    let recipe = SelfAffine {
        grid: Grid::new([n, n], [pixel, pixel])?,
        hurst: 0.8,
        rolloff: ROLLOFF,
        cutoff: SHORTEST,
        scale: Scale::RmsGradient(1.0),
        seed: 1,
        quantise: None,
    };
    let surface = recipe.generate()?;
    let (grid, known) = (surface.grid(), Map::of(&surface));
    let modulus = ContactModulus::from_pascals(MODULUS)?;
    let pair = match precision {
        Precision::Single => pair::<f32>(grid, modulus)?,
        _ => pair::<f64>(grid, modulus)?,
    };
    let before = memory("VmRSS:");
    let builder = Solver::builder().precision(precision).tolerance(TOLERANCE).maps(Maps::None);
    let mut solver = builder.build(grid, modulus)?;
    let rms = known.rms_height;
    println!(
        "\n{n} x {n}, {precision:?}, {:.1} points per shortest wave, {} threads, one convolution {:.1} ms, \
         rms height {:.3} µm\n",
        SHORTEST / pixel,
        std::thread::available_parallelism().map_or(1, usize::from),
        1e3 * pair,
        1e6 * rms
    );
    println!(
        "| p/E* | area | gap / rms height | stiffness × rms height / E* | steps | convolutions | s | convolution times |"
    );
    println!("|---:|---:|---:|---:|---:|---:|---:|---:|");
    let mut peak = f64::NAN;
    forget_peak();
    for load in LOADS {
        solver.forget();
        let solution = match solver.solve(&surface, Load::MeanPressure(load * MODULUS)) {
            Ok(solution) => solution,
            Err(error) => {
                println!("| {load} | {error} |");
                continue;
            }
        };
        // The stiffness of the first load leaves memory behind that the system counts.
        if load == LOADS[0] {
            peak = (memory("VmHWM:") - before) / (8.0 * (n * n) as f64);
        }
        let numbers = numbers(&mut solver, &solution, &known)?;
        let Diagnostics { iterations, transforms, seconds, .. } = solution.diagnostics;
        println!(
            "| {load} | {numbers} | {iterations} | {transforms:.2} | {seconds:.2} | {:.1} |",
            seconds / pair
        );
    }
    println!("\nthe first solve took {peak:.1} doubles per point");
    Ok(())
}

/// Area, gap and stiffness.
fn numbers(solver: &mut Solver, solution: &Solution, known: &Map) -> Result<String, SolverError> {
    let set = match solver.contact_stiffness() {
        Ok(set) => Some(set),
        // The largest grids: beside the solver there is no room for it.
        Err(error @ SolverError::Memory { .. }) => {
            eprintln!("no stiffness: {error}");
            None
        }
        Err(error) => return Err(error),
    };
    let found = Numbers::of(solution, set.as_ref(), None);
    let show = |number: Option<f64>, unit: f64| {
        number.map_or("–".to_owned(), |number| format!("{:.5}", unit * number))
    };
    let rms = known.rms_height;
    let gap = show(found.mean_gap, 1.0 / rms);
    Ok(format!("{:.5} | {gap} | {}", found.area, show(found.stiffness, rms / MODULUS)))
}

/// Seconds of one FFT convolution, the least of a few.
fn pair<T: Real>(grid: Grid, modulus: ContactModulus) -> Result<f64, SolverError> {
    let mut half_space = HalfSpace::<T>::new(grid, modulus);
    let mut field: Vec<T> = (0..grid.len()).map(|i| T::of((i % 97) as f64)).collect();
    let mut least = f64::INFINITY;
    for _ in 0..REPEATS {
        let clock = Instant::now();
        half_space.displace(&mut field)?;
        least = least.min(clock.elapsed().as_secs_f64());
    }
    Ok(least)
}

/// Memory of this process (bytes), now or at most; not a number where the system does not say.
fn memory(which: &str) -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix(which));
    let kib = line.and_then(|rest| rest.split_whitespace().next()?.parse::<f64>().ok());
    kib.map_or(f64::NAN, |kib| 1024.0 * kib)
}

/// From now on the peak is counted anew, where the system can do that (Linux).
fn forget_peak() {
    let _ = std::fs::write("/proc/self/clear_refs", "5");
}
