//! FFT pairs of contact under a pressure ceiling, from nothing, over surfaces, loads and hardnesses. Pairs are
//! exact: the same on every machine.
//!
//! ```console
//! $ cargo run --release -p fft-bem-solver --example yielding -- 256
//! ```
//! Surfaces of rms gradient 1, self-affine from an eighth of the side: H = 0.8 down to 8 pixels and to two, H =
//! 0.3 down to two. Mean pressures 0.005, 0.02, 0.1, 0.4 of E*; hardness infinite, 2, 1, 0.5, 0.25. Pairs are
//! those at which the solver's own estimate says 1e-2 / 1e-4 / 1e-6; and those of the stiffness of the
//! contact set afterwards.

#![allow(clippy::print_stdout, reason = "a program that prints a table")]

use contact_types::{ContactModulus, Grid, HeightMap};
use fft_bem_solver::{Load, Solver};
use std::error::Error;
use surface_stats::synthesis::{Scale, SelfAffine};

const TOLERANCES: [f64; 3] = [1e-2, 1e-4, 1e-6];

fn main() -> Result<(), Box<dyn Error>> {
    let n = std::env::args().nth(1).map_or(Ok(256), |n| n.parse())?;
    println!(
        "| hardness | pairs to 1e-2 / 1e-4 / 1e-6: median | worst | stiffness: median | worst |"
    );
    println!("|---|---|---|---|---|");
    let maps =
        [(0.8, 8.0), (0.8, 2.0), (0.3, 2.0)].map(|(hurst, cutoff)| surface(n, hurst, cutoff));
    for hardness in [f64::INFINITY, 2.0, 1.0, 0.5, 0.25] {
        let mut counts: [Vec<f64>; 4] = Default::default();
        for map in &maps {
            let map = map.as_ref().map_err(ToString::to_string)?;
            for load in [0.005, 0.02, 0.1, 0.4].into_iter().filter(|load| *load < hardness) {
                let modulus = ContactModulus::from_pascals(1.0)?;
                for (tolerance, counts) in TOLERANCES.into_iter().zip(&mut counts) {
                    let builder = Solver::builder().tolerance(tolerance).hardness(hardness);
                    let mut solver = builder.build(map.grid(), modulus)?;
                    let found = solver.solve(map, Load::MeanPressure(load))?;
                    counts.push(found.diagnostics.transforms);
                }
                let builder = Solver::builder().tolerance(1e-6).hardness(hardness);
                let mut solver = builder.build(map.grid(), modulus)?;
                solver.solve(map, Load::MeanPressure(load))?;
                counts[3].push(solver.contact_stiffness()?.transforms);
            }
        }
        for counts in &mut counts {
            counts.sort_by(f64::total_cmp);
        }
        let at = |part: f64, counts: &[Vec<f64>]| {
            let one = |c: &Vec<f64>| format!("{:.2}", c[((c.len() - 1) as f64 * part) as usize]);
            counts.iter().map(one).collect::<Vec<_>>().join(" / ")
        };
        let [median, worst] =
            [0.5, 1.0].map(|part| [&counts[..3], &counts[3..]].map(|c| at(part, c)));
        println!("| {hardness} | {} | {} | {} | {} |", median[0], worst[0], median[1], worst[1]);
    }
    Ok(())
}

fn surface(n: usize, hurst: f64, cutoff: f64) -> Result<HeightMap, Box<dyn Error>> {
    let (scale, grid) = (Scale::RmsGradient(1.0), Grid::new([n, n], [1.0, 1.0])?);
    let rolloff = n as f64 / 8.0;
    Ok(SelfAffine { grid, hurst, rolloff, cutoff, scale, seed: 1, quantise: None }.generate()?)
}
