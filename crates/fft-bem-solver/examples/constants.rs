//! What a constant of the solver is worth: FFT pairs over a set of problems, in one line. Change the
//! constant, run it again; a table in the book was made so (commit adc1dd6).
//!
//! ```console
//! $ cargo run --release -p fft-bem-solver --example constants -- 256
//! ```
//! Three sets. *Square pixels*: self-affine surfaces with H = 0.8 down to 8 pixels and H = 0.3 down to
//! 2, one that does not repeat (a crop of a larger one, stepped) and one worn to a plateau, six loads
//! from 0.005 to 1 times E* times the rms gradient; pairs until the true relative rms error of the
//! pressure stays below 1e-2 / 1e-4 / 1e-6, mean and worst; and with the mean gap prescribed, to an
//! estimate of 1e-6. *Long pixels*: the same surfaces on pixels of 1:8, 1:100, 1:1000, a quarter of the
//! size, two loads, to an estimate of 1e-10. *Level by loads*: Polonsky and Keer's method with the mean
//! gap prescribed on a quarter of the size, to 1e-4: what `control.rs` costs.

#![allow(clippy::print_stdout, reason = "a program that prints a table")]

use contact_types::{ContactModulus, Grid, HeightMap};
use fft_bem_solver::{Iteration, Load, Method, Solution, Solver, SolverError};
use std::error::Error;
use std::ops::ControlFlow;
use surface_stats::synthesis::{Scale, SelfAffine};

type Outcome<T> = Result<T, Box<dyn Error>>;

const ERRORS: [f64; 3] = [1e-2, 1e-4, 1e-6];
const LOADS: [f64; 6] = [0.005, 0.015, 0.045, 0.13, 0.4, 1.0];

fn main() -> Outcome<()> {
    let n: usize =
        std::env::args().nth(1).ok_or("give the number of pixels along a side")?.parse()?;
    let mut square = [(); 3].map(|()| Vec::new());
    let mut gap = Vec::new();
    for map in surfaces(n, [1.0, 1.0])? {
        for load in LOADS {
            let exact = solver(&map, Method::Chord, 1e-9)?.solve(&map, Load::MeanPressure(load))?;
            for (all, pairs) in square.iter_mut().zip(to_true_error(&map, load, &exact)?) {
                all.push(pairs);
            }
            if let Some(g) = exact.state.mean_gap.filter(|g| *g > 1e-6) {
                gap.push(pairs(&map, Method::Chord, Load::MeanGap(g), 1e-6)?);
            }
        }
    }
    let mut long = Vec::new();
    let mut by_loads = Vec::new();
    for ratio in [8.0, 100.0, 1000.0] {
        for pixel in [[ratio, 1.0], [1.0, ratio]] {
            for map in surfaces(n / 4, pixel)? {
                for load in [0.01, 0.2] {
                    long.push(pairs(&map, Method::Chord, Load::MeanPressure(load), 1e-10)?);
                }
            }
        }
    }
    for map in surfaces(n / 4, [1.0, 1.0])? {
        for load in LOADS {
            let exact = solver(&map, Method::Chord, 1e-9)?.solve(&map, Load::MeanPressure(load))?;
            if let Some(g) = exact.state.mean_gap.filter(|g| *g > 1e-6) {
                by_loads.push(pairs(&map, Method::PolonskyKeer, Load::MeanGap(g), 1e-4)?);
            }
        }
    }
    let [a, b, c] = square.each_ref().map(|x| mean_and_worst(x));
    println!(
        "square {a} | {b} | {c}; mean gap {}; long pixels {}; level by loads {}",
        mean_and_worst(&gap),
        mean_and_worst(&long),
        mean_and_worst(&by_loads)
    );
    Ok(())
}

/// Mean and largest.
fn mean_and_worst(pairs: &[f64]) -> String {
    let mean = pairs.iter().sum::<f64>() / pairs.len() as f64;
    format!("{mean:.2}, {:.1}", pairs.iter().fold(0.0_f64, |m, x| m.max(*x)))
}

/// Of rms gradient 1 in units of the pixel (of the longer side, where pixels are long).
fn surfaces(n: usize, pixel: [f64; 2]) -> Outcome<Vec<HeightMap>> {
    let make = |n: usize, hurst: f64, rolloff: f64, cutoff: f64| {
        let (grid, scale) = (Grid::new([n, n], [1.0, 1.0])?, Scale::RmsGradient(1.0));
        let map = SelfAffine { grid, hurst, rolloff, cutoff, scale, seed: 1, quantise: None }
            .generate()?;
        Ok::<_, Box<dyn Error>>(map.heights().to_vec())
    };
    let long = (n as f64 / 8.0).max(8.0);
    let smooth = make(n, 0.8, long, 8.0)?;
    let rough = make(n, 0.3, long, 2.0)?;
    let large = make(2 * n, 0.8, 8.0 * n as f64, 2.0)?;
    let crop: Vec<f64> =
        (0..n * n).map(|i| (large[i / n * 2 * n + i % n] / 0.2).round() * 0.2).collect();
    let rms = (smooth.iter().map(|h| h * h).sum::<f64>() / smooth.len() as f64).sqrt();
    let worn: Vec<f64> = smooth.iter().map(|h| h.min(0.5 * rms)).collect();
    let grid = Grid::new([n, n], pixel)?;
    [smooth, rough, crop, worn].into_iter().map(|h| Ok(HeightMap::new(grid, h)?)).collect()
}

fn solver(map: &HeightMap, method: Method, tolerance: f64) -> Outcome<Solver> {
    let modulus = ContactModulus::from_pascals(1.0)?;
    Ok(Solver::builder().method(method).tolerance(tolerance).build(map.grid(), modulus)?)
}

/// Pairs to an estimate of the tolerance; also where the iterations end first.
fn pairs(map: &HeightMap, method: Method, load: Load, tolerance: f64) -> Outcome<f64> {
    match solver(map, method, tolerance)?.solve(map, load) {
        Ok(found) => Ok(found.diagnostics.transforms),
        Err(SolverError::NotConverged(found)) => Ok(found.diagnostics.transforms),
        Err(error) => Err(error.into()),
    }
}

/// Pairs until the true error stays below each of [`ERRORS`].
fn to_true_error(map: &HeightMap, load: f64, exact: &Solution) -> Outcome<[f64; 3]> {
    let size = exact.pressure.iter().map(|p| p * p).sum::<f64>();
    let mut reached = [None; 3];
    let mut watch = |it: &Iteration<'_>| {
        let [pressure, _] = it.pressure_and_gap();
        let square =
            pressure.iter().zip(&exact.pressure).map(|(a, b)| (a - b).powi(2)).sum::<f64>();
        for (reached, limit) in reached.iter_mut().zip(ERRORS) {
            let is_below = (square / size).sqrt() <= limit;
            *reached = if is_below { reached.or(Some(it.transforms)) } else { None };
        }
        ControlFlow::Continue(())
    };
    let load = Load::MeanPressure(load);
    let found =
        solver(map, Method::Chord, 0.1 * ERRORS[2])?.solve_observed(map, load, &mut watch)?;
    Ok(reached.map(|r| r.unwrap_or(found.diagnostics.transforms)))
}
