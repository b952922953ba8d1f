//! What the grid does to contact that yields, and to the conductance of a contact.

#![allow(clippy::unwrap_used, reason = "tests may stop where their input is wrong")]

use contact_types::{ContactModulus, Grid, HeightMap};
use fft_bem_solver::{Load, Solver};
use surface_stats::Edges;
use surface_stats::clean::resample;
use surface_stats::synthesis::{Scale, SelfAffine};

const GRADIENT: f64 = 0.1;

/// A random surface with so many points to its shortest wave.
fn surface(n: usize, points: f64, hurst: f64, seed: u64) -> HeightMap {
    let recipe = SelfAffine {
        grid: Grid::new([n, n], [1.0, 1.0]).unwrap(),
        hurst,
        rolloff: n as f64 / 8.0,
        cutoff: points,
        scale: Scale::RmsGradient(GRADIENT),
        seed,
        quantise: None,
    };
    recipe.generate().unwrap()
}

/// The same surface on `times` as many points along each side.
fn finer(map: &HeightMap, times: usize) -> HeightMap {
    resample(map, map.grid().shape().map(|n| times * n), Edges::Periodic).unwrap()
}

/// Corrected area fraction and stiffness at a load and a hardness over E* times the rms gradient.
fn solved(map: &HeightMap, load: f64, hardness: f64) -> [f64; 2] {
    let builder = Solver::builder().tolerance(1e-5).hardness(hardness * GRADIENT);
    let mut solver = builder.build(map.grid(), ContactModulus::from_pascals(1.0).unwrap()).unwrap();
    let found = solver.solve(map, Load::MeanPressure(load * GRADIENT)).unwrap();
    let stiffness = solver.contact_stiffness().unwrap().per_area;
    [found.diagnostics.area_fraction_corrected, stiffness]
}

/// From 8 to 32 points per shortest wave the corrected area moves by at most 1 % where H/(E* g) = 0.5.
#[test]
#[ignore = "slow: 1024 x 1024 points; run by `cargo xtask ci --slow`"]
fn area_of_yielding_contact_from_8_to_32_points_per_wave() {
    for (hurst, seed) in [(0.8, 1), (0.4, 2)] {
        let map = surface(256, 8.0, hurst, seed);
        let fine = finer(&map, 4);
        for load in [0.03, 0.1, 0.3] {
            let change = solved(&map, load, 0.5)[0] / solved(&fine, load, 0.5)[0] - 1.0;
            println!("H {hurst}, p/(E* g) {load}: area {:+.2} %", 100.0 * change);
            assert!(change.abs() < 0.01, "H {hurst}, p/(E* g) {load}: {change}");
        }
    }
}

/// From 4 to 16 points per shortest wave the conductance of an elastic contact moves by 0.5 % (root of the
/// mean square), that of a yielding one, whose edges are sharp, by more.
#[test]
#[ignore = "slow: 1024 x 1024 points; run by `cargo xtask ci --slow`"]
fn conductance_from_4_to_16_points_per_wave() {
    for (hardness, limit) in [(f64::INFINITY, 0.005), (0.5, 0.015)] {
        let mut squares = Vec::new();
        for (hurst, seed) in [(0.8, 3), (0.4, 4)] {
            let map = surface(256, 4.0, hurst, seed);
            let fine = finer(&map, 4);
            for load in [0.03, 0.1, 0.3] {
                let [coarse, fine] = [&map, &fine].map(|map| solved(map, load, hardness)[1]);
                let change = coarse / fine - 1.0;
                println!(
                    "H {hurst}, hardness {hardness}, p/(E* g) {load}: {:+.2} %",
                    100.0 * change
                );
                squares.push(change * change);
            }
        }
        let rms = (squares.iter().sum::<f64>() / squares.len() as f64).sqrt();
        assert!(rms < limit, "hardness {hardness}: {rms}");
    }
}
