//! How far is the area of a contact that yields from what its load asks for at least?
//!
//! No pressure exceeds the hardness H, so the area is at least P/H, on any grid. Surfaces that their points
//! resolve badly or well, plain and with bent heights, against four times as many points along each side by three ways to interpolate:
//! printed for each hardness and load the range of `(A' - A)/(A - P/H)`, A corrected on the given points, A' on the finer ones.
//! At -1 the finer area is P/H itself.
//!
//! `cargo run --release -p contact-accuracy --example yielding_floor` (minutes).

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a program of its own")]

use contact_types::{ContactModulus, Grid, HeightMap};
use fft_bem_solver::{Load, Solver};
use surface_stats::Edges;
use surface_stats::clean::resample;
use surface_stats::synthesis::{Scale, SelfAffine};

const GRADIENT: f64 = 0.1;
const N: usize = 128;
const TIMES: usize = 4;
/// Over E* times the rms gradient.
const HARDNESSES: [f64; 5] = [0.5, 0.2, 0.1, 0.05, 0.02];
/// Over the hardness.
const LOADS: [f64; 5] = [0.003, 0.03, 0.1, 0.4, 0.9];
/// Excesses below this part of the area are rounding and tolerance.
const LEAST: f64 = 2e-3;

/// Heights `sinh(b z)/b` of a random surface, one side only if `bend` asks for it.
fn surface(hurst: f64, cutoff: f64, bend: f64) -> HeightMap {
    let recipe = SelfAffine {
        grid: Grid::new([N, N], [1.0, 1.0]).unwrap(),
        hurst,
        rolloff: N as f64 / 6.0,
        cutoff,
        scale: Scale::RmsGradient(GRADIENT),
        seed: 11,
        quantise: None,
    };
    let map = recipe.generate().unwrap();
    if bend.abs() < 1e-9 {
        return map;
    }
    let rms = (map.heights().iter().map(|h| h * h).sum::<f64>() / map.grid().len() as f64).sqrt();
    let heights =
        map.heights().iter().map(|h| ((bend * h / rms).exp() - 1.0) / bend * rms).collect();
    HeightMap::new(map.grid(), heights).unwrap()
}

/// The map on finer points between which heights are linear, or constant.
fn between(map: &HeightMap, is_linear: bool) -> HeightMap {
    let n = N * TIMES;
    let at = |i: usize| {
        let t = (i % TIMES) as f64 / TIMES as f64;
        (i / TIMES, (i / TIMES + 1) % N, if is_linear { t } else { 0.0 })
    };
    let height = |iy: usize, ix: usize| {
        let ((y, yy, v), (x, xx, u)) = (at(iy), at(ix));
        let row = |y: usize| map.at(y, x) * (1.0 - u) + map.at(y, xx) * u;
        row(y) * (1.0 - v) + row(yy) * v
    };
    let heights = (0..n * n).map(|i| height(i / n, i % n)).collect();
    let pixel = map.grid().pixel().map(|p| p / TIMES as f64);
    HeightMap::new(Grid::new([n, n], pixel).unwrap(), heights).unwrap()
}

fn areas(map: &HeightMap, hardness: f64) -> [[f64; 2]; LOADS.len()] {
    let builder = Solver::builder().hardness(hardness * GRADIENT);
    let mut solver = builder.build(map.grid(), ContactModulus::from_pascals(1.0).unwrap()).unwrap();
    LOADS.map(|load| {
        let found = solver.solve(map, Load::MeanPressure(load * hardness * GRADIENT)).unwrap();
        [found.diagnostics.area_fraction_corrected, found.state.area_fraction]
    })
}

fn main() {
    let ways = ["waves", "linear", "constant"];
    for hardness in HARDNESSES {
        let mut ranges = [[[f64::INFINITY, f64::NEG_INFINITY]; 3]; LOADS.len()];
        let mut most = [0.0f64; LOADS.len()];
        for cutoff in [2.0, 3.0, 4.5, 8.0] {
            for (hurst, bend) in [(0.8, 0.0), (0.3, 0.0), (0.8, 0.7), (0.3, -0.7)] {
                let map = surface(hurst, cutoff, bend);
                let finer = [
                    resample(&map, [TIMES * N; 2], Edges::Periodic).unwrap(),
                    between(&map, true),
                    between(&map, false),
                ];
                let given = areas(&map, hardness);
                for (way, finer) in finer.iter().enumerate() {
                    for (k, found) in areas(finer, hardness).into_iter().enumerate() {
                        let excess = given[k][1] - LOADS[k];
                        most[k] = most[k].max(excess / given[k][0]);
                        let change = (found[0] - given[k][0]) / excess.max(LEAST * given[k][0]);
                        let [low, high] = &mut ranges[k][way];
                        (*low, *high) = (low.min(change), high.max(change));
                    }
                }
            }
        }
        for (k, load) in LOADS.iter().enumerate() {
            print!("H/E*g {hardness:<5} P/H {load:<6} excess up to {:>4.1} %", 100.0 * most[k]);
            for (way, [low, high]) in ways.iter().zip(ranges[k]) {
                print!(" | {way} {low:+.2} to {high:+.2}");
            }
            println!();
        }
    }
}
