//! Does the ± of a conductance hold, that is of the stiffness of a contact set, from the grid?
//!
//! Six families of surfaces on 512 x 512 points; every fourth point of each is a map of 128 x 128, some 6 points to
//! its shortest wave, solved elastic and yielding with the default tolerance. Printed: how often the conductance of the
//! finer grid lies within the bar of the coarser.
//!
//! `cargo run --release -p contact-accuracy --example conductance_bar -- 6` (maps of each family).

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a program of its own")]

use contact_accuracy::budget::{Between, Budget, Map, Stiffness, grid};
use contact_types::{ContactModulus, Grid, HeightMap};
use fft_bem_solver::{Load, Solver};
use surface_stats::synthesis::{Scale, SelfAffine};

const FINE: usize = 512;
const TIMES: usize = 4;
const GRADIENT: f64 = 0.1;
const LOADS: [f64; 4] = [0.005, 0.02, 0.08, 0.3];
const HARDNESSES: [f64; 4] = [f64::INFINITY, 1.0, 0.5, 0.25];
const FAMILIES: [&str; 6] = ["Gaussian", "lay", "bent heights", "clipped", "turned", "patchy"];

/// Self-affine, repeating, of rms height 1; pixels `[dy, dx]` set a lay.
fn waves(pixel: [f64; 2], seed: u64) -> Vec<f64> {
    let side = FINE as f64;
    let recipe = SelfAffine {
        grid: Grid::new([FINE; 2], pixel).unwrap(),
        hurst: if seed.is_multiple_of(2) { 0.8 } else { 0.5 },
        rolloff: side / 6.0,
        cutoff: 6.0 * TIMES as f64,
        scale: Scale::RmsHeight(1.0),
        seed,
        quantise: None,
    };
    recipe.generate().unwrap().into_heights()
}

fn heights(family: &str, seed: u64) -> Vec<f64> {
    let plain = || waves([1.0; 2], seed);
    match family {
        "lay" => waves([1.0, 0.25], seed),
        "bent heights" => plain().into_iter().map(|h| (0.5 * h).exp()).collect(),
        "clipped" => plain().into_iter().map(|h| h.min(1.2)).collect(),
        "turned" => {
            // Ridges of a tool under roughness a tenth as high.
            let ridge = |i: usize| {
                let phase = 8.0 * (i % FINE) as f64 / FINE as f64 + 0.02 * plain_wave(i);
                2.0 * (std::f64::consts::TAU * phase).cos()
            };
            plain().into_iter().enumerate().map(|(i, h)| ridge(i) + 0.2 * h).collect()
        }
        "patchy" => {
            let where_ = waves([1.0; 2], seed + 1000);
            plain().into_iter().zip(where_).map(|(h, w)| h * (0.6 * w).exp()).collect()
        }
        _ => plain(),
    }
}

/// A slow wobble along the ridges.
fn plain_wave(i: usize) -> f64 {
    (std::f64::consts::TAU * (i / FINE) as f64 / FINE as f64).sin()
}

/// The fine map and every fourth of its points, both with the rms gradient of the fine one.
fn maps(family: &str, seed: u64) -> [HeightMap; 2] {
    let raw = heights(family, seed);
    let at = |iy: usize, ix: usize| raw[iy % FINE * FINE + ix % FINE];
    let slope2: f64 = (0..FINE * FINE)
        .map(|i| {
            let (iy, ix) = (i / FINE, i % FINE);
            (at(iy + 1, ix) - at(iy, ix)).powi(2) + (at(iy, ix + 1) - at(iy, ix)).powi(2)
        })
        .sum();
    let factor = GRADIENT / (slope2 / (FINE * FINE) as f64).sqrt();
    let n = FINE / TIMES;
    let fine = raw.iter().map(|h| factor * h).collect();
    let coarse = (0..n * n).map(|i| factor * at(i / n * TIMES, i % n * TIMES)).collect();
    let grid = |n: usize, d: f64| Grid::new([n; 2], [d; 2]).unwrap();
    [
        HeightMap::new(grid(FINE, 1.0), fine).unwrap(),
        HeightMap::new(grid(n, TIMES as f64), coarse).unwrap(),
    ]
}

/// Of a load: the stiffness of the contact set, and its interval if it has one.
fn solved(map: &HeightMap, hardness: f64, tolerance: f64) -> Vec<(f64, f64, Option<[f64; 2]>)> {
    let modulus = ContactModulus::from_pascals(1.0).unwrap();
    let builder = Solver::builder().tolerance(tolerance).hardness(hardness * GRADIENT);
    let mut solver = builder.build(map.grid(), modulus).unwrap();
    let known = Map::of(map).unwrap();
    let mut all = Vec::new();
    for load in LOADS.into_iter().filter(|load| load / hardness <= 0.4) {
        let found = solver.solve(map, Load::MeanPressure(load * GRADIENT)).unwrap();
        let mut budget = Budget::of(&found, &known);
        if let Some(between) = Between::of(map, true, &found.pressure, modulus) {
            budget = budget.between(&between);
        }
        let Some(near) = Stiffness::of_set(&mut solver, &found).unwrap() else { continue };
        budget = budget.with_stiffness(&near, &known, grid::Line::of(&found));
        let interval = budget.stiffness.and_then(|k| k.comparison().ok());
        all.push((load, near.value, interval));
    }
    all
}

fn main() {
    let count: u64 = std::env::args().nth(1).and_then(|n| n.parse().ok()).unwrap_or(4);
    println!(
        "family, H/(E* g): conductances with a bar | held | median half width | worst error, in half widths | mean error"
    );
    for family in FAMILIES {
        for hardness in HARDNESSES {
            let (mut all, mut held, mut worst, mut sum) = (0, 0, 0.0_f64, 0.0);
            let mut halves = Vec::new();
            let mut bare = 0;
            for seed in 0..count {
                let [fine, coarse] = maps(family, 10 * seed + seed % 2);
                let truth = solved(&fine, hardness, 1e-5);
                for (load, k, interval) in solved(&coarse, hardness, 1e-4) {
                    let Some((_, exact, _)) = truth.iter().find(|t| t.0 >= load) else { continue };
                    let Some([low, high]) = interval else {
                        bare += 1;
                        continue;
                    };
                    let half = 0.5 * (high - low);
                    all += 1;
                    held += usize::from((low..=high).contains(exact));
                    worst = worst.max((k - exact).abs() / half);
                    sum += k / exact - 1.0;
                    halves.push(half / k);
                }
            }
            halves.sort_by(f64::total_cmp);
            let median = halves.get(halves.len() / 2).copied().unwrap_or(f64::NAN);
            println!(
                "{family}, {hardness}: {all} (and {bare} without) | {held} | {:.2} % | {worst:.2} | {:+.2} %",
                100.0 * median,
                100.0 * sum / f64::from(all.max(1))
            );
        }
    }
}
