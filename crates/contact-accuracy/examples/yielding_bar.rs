//! Does the bar of the area that was counted on elastic contact hold where the contact yields?
//!
//! Random surfaces on 256 x 256 points, solved at several loads and hardnesses with the default
//! tolerance, against the same waves on four times as many points along each side. Printed: how often
//! area, mean gap and stiffness lie within their bars of grid and iteration, and the worst of each.
//!
//! `cargo run --release -p contact-accuracy --example yielding_bar -- 12` (seeds of each kind).

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a program of its own")]

use contact_accuracy::budget::{AREA_PER_RESIDUAL, Map, grid};
use contact_types::{ContactModulus, Grid, HeightMap};
use fft_bem_solver::{Load, Solution, Solver};
use surface_stats::Edges;
use surface_stats::clean::resample;
use surface_stats::synthesis::{Scale, SelfAffine};

const GRADIENT: f64 = 0.1;
const LOADS: [f64; 4] = [0.005, 0.02, 0.08, 0.3];
const HARDNESSES: [f64; 4] = [1.0, 0.5, 0.25, 0.1];
const N: usize = 256;

fn surface(hurst: f64, cutoff: f64, seed: u64) -> HeightMap {
    let recipe = SelfAffine {
        grid: Grid::new([N, N], [1.0, 1.0]).unwrap(),
        hurst,
        rolloff: N as f64 / 6.0,
        cutoff,
        scale: Scale::RmsGradient(GRADIENT),
        seed,
        quantise: None,
    };
    recipe.generate().unwrap()
}

/// Solutions at all loads the hardness can carry, each with its stiffness.
fn solved(map: &HeightMap, hardness: f64, tolerance: f64) -> Vec<(f64, Solution, f64)> {
    let modulus = ContactModulus::from_pascals(1.0).unwrap();
    let builder = Solver::builder().tolerance(tolerance).hardness(hardness * GRADIENT);
    let mut solver = builder.build(map.grid(), modulus).unwrap();
    let loads = LOADS.into_iter().filter(|load| load / hardness <= 0.4);
    loads
        .map(|load| {
            let found = solver.solve(map, Load::MeanPressure(load * GRADIENT)).unwrap();
            let stiffness = solver.contact_stiffness().unwrap().per_area;
            (load, found, stiffness)
        })
        .collect()
}

#[derive(Default)]
struct Count {
    all: usize,
    held: [usize; 3],
    worst: [f64; 3],
    error: [f64; 3],
    bar: [f64; 3],
}

/// What is counted, in the order of the arrays.
const NAMES: [&str; 3] = ["area", "gap", "stiffness"];

fn main() {
    let seeds: u64 = std::env::args().nth(1).and_then(|n| n.parse().ok()).unwrap_or(4);
    for hardness in HARDNESSES {
        for cutoff in [6.0, 8.0, 12.0] {
            let mut counts = [(); LOADS.len()].map(|()| Count::default());
            for (hurst, seed) in
                [0.8, 0.4].into_iter().flat_map(|h| (0..seeds).map(move |s| (h, s)))
            {
                let map = surface(hurst, cutoff, 100 * seed + 7);
                let fine = resample(&map, [4 * N; 2], Edges::Periodic).unwrap();
                let known = Map::of(&map).unwrap();
                let coarse = solved(&map, hardness, 1e-4);
                let truth = solved(&fine, hardness, 1e-5);
                for ((load, a, k), (_, b, l)) in coarse.into_iter().zip(truth) {
                    // The bar of elastic contact: what yield widens it by is to be found here.
                    let Ok(half) = known.accuracy.grid_half_width(&a) else { continue };
                    let found = &a.diagnostics;
                    let area = found.area_fraction_corrected;
                    let iteration = AREA_PER_RESIDUAL * found.residuals.preconditioned * area;
                    let line = grid::Line::of(&a);
                    let [g, h] = [&a, &b].map(|s| s.state.mean_gap.unwrap());
                    let gap_bar = grid::gap_half_width(&known, line)
                        .max(grid::gap_of_open_places(&known, line, g));
                    let k_bar = k * grid::stiffness_half_width(&known, line);
                    let errors = [area - b.diagnostics.area_fraction_corrected, g - h, k - l];
                    let bars = [half + iteration, gap_bar, k_bar];
                    let count = &mut counts[LOADS.iter().position(|l| *l >= load).unwrap()];
                    count.all += 1;
                    for (i, unit) in [area, known.rms_height, k].into_iter().enumerate() {
                        let ratio = errors[i].abs() / bars[i];
                        count.held[i] += usize::from(ratio <= 1.0);
                        count.worst[i] = count.worst[i].max(ratio);
                        count.error[i] += errors[i] / unit;
                        count.bar[i] += bars[i] / unit;
                    }
                }
            }
            for (load, c) in LOADS.iter().zip(&counts).filter(|(_, c)| c.all > 0) {
                let n = c.all as f64;
                print!("H/E*g {hardness:<5} {cutoff:>4} points p/E*g {load:<6} n {:>3}", c.all);
                for (i, what) in NAMES.into_iter().enumerate() {
                    print!(
                        " | {what} held {:>3}, worst {:>5.2}, mean error {:+.2} %, bar {:.2} %",
                        c.held[i],
                        c.worst[i],
                        100.0 * c.error[i] / n,
                        100.0 * c.bar[i] / n
                    );
                }
                println!();
            }
        }
    }
}
