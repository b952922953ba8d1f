//! Do the bars hold for a surface that is more than the smooth one through its points?
//!
//! Surfaces given by formulas, most of them with creases, corners, tips or steps that no map shows, on 128² points
//! against 1024² points of the same formula, at six loads from 0.0001 to 0.03 of E\* times the rms gradient, or from 0.1 to 1.5: for each how many
//! intervals of area, gap and stiffness hold, and how far the farthest answer lies, in half widths. All the intervals are those
//! that `compare` states; *refined* are those that a twice finer grid gives.
//!
//! `cargo run --release -p contact-accuracy --example creases -- light 6 0` (or `heavy`; seeds, and the first of them; a minute each).

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a program of its own")]

use contact_accuracy::TwiceFiner;
use contact_accuracy::budget::grid::Line;
use contact_accuracy::budget::{Between, Budget, Estimate, Map, Stiffness};
use contact_types::{ContactModulus, Grid, HeightMap};
use fft_bem_solver::{Boundary, Load, Solver};
use std::f64::consts::TAU;

const POINTS: usize = 128;
const FINER: usize = 1024;
/// Mean pressures over E\* times the rms gradient.
const LIGHT: [f64; 6] = [1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2];
const HEAVY: [f64; 6] = [0.1, 0.3, 0.5, 0.8, 1.1, 1.5];

/// A number from 0 to 1 for each place in a sequence.
struct Dice(u64);

impl Dice {
    fn roll(&mut self) -> f64 {
        // SplitMix64 (Steele, Lea & Flood 2014, doi:10.1145/2660193.2660195).
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// A height at each place of the unit square, which repeats.
type Heights = Box<dyn Fn(f64, f64) -> f64>;

/// Waves up to `most` on a side, of rms 1, self-affine from the third on.
fn waves(dice: &mut Dice, hurst: f64, most: i32) -> Heights {
    let mut waves = Vec::new();
    for ky in -most..=most {
        for kx in 0..=most {
            let (k, phase) = (f64::from(kx).hypot(f64::from(ky)), TAU * dice.roll());
            if (3.0..=f64::from(most)).contains(&k) && (kx > 0 || ky > 0) {
                waves.push([f64::from(ky), f64::from(kx), phase, k.powf(-1.0 - hurst)]);
            }
        }
    }
    let rms = (waves.iter().map(|w| 0.5 * w[3] * w[3]).sum::<f64>()).sqrt();
    Box::new(move |y, x| {
        let wave = |w: &[f64; 4]| w[3] * (TAU * (w[0] * y + w[1] * x) + w[2]).cos();
        waves.iter().map(wave).sum::<f64>() / rms
    })
}

/// From the middle of a period to both sides.
fn off(s: f64) -> f64 {
    s - (s + 0.5).floor()
}

/// Distances to the nearest two of `count` places.
fn distances(dice: &mut Dice, count: usize) -> impl Fn(f64, f64) -> [f64; 2] + use<> {
    let places: Vec<[f64; 2]> = (0..count).map(|_| [dice.roll(), dice.roll()]).collect();
    move |y, x| {
        places.iter().fold([9.0, 9.0], |[first, second], p| {
            let d = off(y - p[0]).hypot(off(x - p[1]));
            [first.min(d), second.min(d.max(first))]
        })
    }
}

/// Straight lines, of a whole number of periods along both sides: distances to the nearest of each of `count`.
fn lines(dice: &mut Dice, count: usize, most: f64) -> impl Fn(f64, f64) -> Vec<f64> + use<> {
    let mut one = || {
        let mut whole = || ((2.0 * most + 1.0) * dice.roll()).floor() - most;
        let (a, b) = (whole(), whole());
        [a, if a.abs() + b.abs() < 0.5 { 1.0 } else { b }, dice.roll()]
    };
    let lines: Vec<[f64; 3]> = (0..count).map(|_| one()).collect();
    move |y, x| lines.iter().map(|[a, b, c]| off(a * y + b * x + c).abs() / a.hypot(*b)).collect()
}

/// The highest of 25 pyramids.
fn pyramids(dice: &mut Dice) -> Heights {
    let all: Vec<[f64; 4]> =
        (0..25).map(|_| [dice.roll(), dice.roll(), 3.0 * dice.roll(), dice.roll()]).collect();
    Box::new(move |y, x| {
        let one = |p: &[f64; 4]| {
            let (dy, dx) = (off(y - p[0]), off(x - p[1]));
            let (u, v) = (p[2].cos() * dx + p[2].sin() * dy, p[2].cos() * dy - p[2].sin() * dx);
            0.05 * p[3] - u.abs().max(v.abs())
        };
        all.iter().map(one).fold(-9.0, f64::max)
    })
}

/// Each family from its own seeds.
fn family(name: &str, seed: u64) -> Option<Heights> {
    let dice = &mut Dice(1000 * seed + name.bytes().map(u64::from).sum::<u64>());
    let rough = waves(dice, 0.8, 8);
    let d = distances(dice, 14);
    let positive = |z: f64| z.max(0.0);
    Some(match name {
        "waves" => waves(dice, 0.8, 16),
        "short waves" => waves(dice, 0.3, 15),
        "log-normal" => Box::new(move |y, x| (0.8 * rough(y, x)).exp()),
        "exponential tails" => Box::new(move |y, x| (1.2 * rough(y, x)).exp()),
        "balls" => Box::new(move |y, x| positive(0.04 - d(y, x)[0].powi(2)).sqrt()),
        "foam" => Box::new(move |y, x| d(y, x)[1] - d(y, x)[0]),
        "folded, valleys" => Box::new(move |y, x| rough(y, x).abs()),
        "higher of two" => {
            let other = waves(dice, 0.8, 8);
            Box::new(move |y, x| rough(y, x).max(other(y, x)))
        }
        "lower of two" => {
            let other = waves(dice, 0.8, 8);
            Box::new(move |y, x| rough(y, x).min(other(y, x)))
        }
        "two levels" => Box::new(move |y, x| (6.0 * rough(y, x)).tanh() + 0.1 * rough(y, x)),
        "cut" => Box::new(move |y, x| rough(y, x).min(0.3)),
        "burrs" => Box::new(move |y, x| rough(y, x) + 3.0 * (-(d(y, x)[0] / 0.02).powi(2)).exp()),
        "tips" => Box::new(move |y, x| 0.3 * rough(y, x) + 4.0 * (-d(y, x)[0] / 0.03).exp()),
        "cones" => Box::new(move |y, x| -d(y, x)[0]),
        "pyramids" => pyramids(dice),
        "ridges" => Box::new(move |y, x| d(y, x)[0] - d(y, x)[1]),
        "wedges" => Box::new(move |y, x| 0.02 * rough(y, x) - (d(y, x)[1] - d(y, x)[0]).min(0.08)),
        "folded, ridges" => Box::new(move |y, x| -rough(y, x).abs()),
        "fractional parts" => Box::new(move |y, x| off(0.35 * rough(y, x)).abs()),
        "cusps" => Box::new(move |y, x| -rough(y, x).abs().sqrt()),
        "ridges of ridges" => {
            let mut part = |share: f64, most: i32| (share, waves(dice, 0.8, most));
            let all = [part(1.0, 4), part(0.5, 8), part(0.25, 16)];
            Box::new(move |y, x| all.iter().map(|(share, waves)| -share * waves(y, x).abs()).sum())
        }
        "ploughed" => {
            let lines = lines(dice, 8, 2.0);
            Box::new(move |y, x| {
                let groove = |s: f64| {
                    positive(1.0 - (s - 0.03).abs() / 0.01) - 2.0 * positive(1.0 - s / 0.02)
                };
                rough(y, x) + lines(y, x).into_iter().map(groove).sum::<f64>()
            })
        }
        "lay of creases" => {
            let lines = lines(dice, 9, 5.0);
            Box::new(move |y, x| lines(y, x).iter().sum())
        }
        _ => return None,
    })
}

const SMOOTH: [&str; 10] = [
    "waves",
    "short waves",
    "log-normal",
    "exponential tails",
    "balls",
    "foam",
    "folded, valleys",
    "higher of two",
    "lower of two",
    "two levels",
];
const SHARP: [&str; 13] = [
    "cut",
    "burrs",
    "tips",
    "cones",
    "pyramids",
    "ridges",
    "wedges",
    "folded, ridges",
    "fractional parts",
    "cusps",
    "ridges of ridges",
    "ploughed",
    "lay of creases",
];

fn map(points: usize, heights: &Heights) -> HeightMap {
    let pixel = 1.0 / points as f64;
    let grid = Grid::new([points, points], [pixel, pixel]).unwrap();
    HeightMap::from_fn(grid, heights).unwrap()
}

/// Rms gradient by differences between neighbours.
fn rms_gradient(map: &HeightMap) -> f64 {
    let n = map.grid().shape()[0];
    let square = |i: usize| {
        let (y, x) = (i / n, i % n);
        let [down, right] = [map.at((y + 1) % n, x), map.at(y, (x + 1) % n)];
        (down - map.at(y, x)).powi(2) + (right - map.at(y, x)).powi(2)
    };
    (0..n * n).map(square).sum::<f64>().sqrt() // n² points of size 1/n
}

/// A number that is stated and what it should be.
#[derive(Default)]
struct Count {
    all: usize,
    held: usize,
    farthest: f64,
    half_widths: Vec<f64>,
}

impl Count {
    fn add(&mut self, stated: &Estimate, truth: f64) {
        let Ok(half) = stated.comparison_half_width() else { return };
        let away = (truth - stated.value).abs() / half.max(f64::MIN_POSITIVE);
        self.all += 1;
        self.held += usize::from(away <= 1.0);
        self.farthest = self.farthest.max(away);
        self.half_widths.push(half / truth);
    }

    fn show(&mut self) -> String {
        self.half_widths.sort_by(f64::total_cmp);
        let median = self.half_widths.get(self.all / 2).map_or(0.0, |half| 100.0 * half);
        format!(" {} of {}, ±{median:.2} %, {:.2} |", self.held, self.all, self.farthest)
    }
}

fn main() {
    let asked =
        |k: usize, else_: u64| std::env::args().nth(k).map_or(else_, |s| s.parse().unwrap());
    let (seeds, first) = (asked(2, 1), asked(3, 0));
    let loads = if std::env::args().nth(1).is_some_and(|a| a == "heavy") { HEAVY } else { LIGHT };
    let modulus = ContactModulus::from_pascals(1.0).unwrap();
    println!("Held, median half width, farthest answer in half widths.\n");
    println!("| surfaces | area | refined | gap | refined | stiffness | refined |");
    println!("|---|---|---|---|---|---|---|");
    let mut all: [Count; 6] = Default::default();
    for name in SMOOTH.into_iter().chain(SHARP) {
        let mut counts: [Count; 6] = Default::default();
        for seed in first..first + seeds {
            let heights = family(name, seed).unwrap();
            let (given, fine) = (map(POINTS, &heights), map(FINER, &heights));
            let known = Map::of(&given).unwrap();
            let unit = rms_gradient(&given);
            let mut coarse = Solver::builder().build(given.grid(), modulus).unwrap();
            let mut exact = Solver::builder().build(fine.grid(), modulus).unwrap();
            let builder = Solver::builder();
            let mut finer =
                TwiceFiner::of(&given, &known, Boundary::Periodic, builder, modulus).unwrap();
            for load in loads.map(|load| Load::MeanPressure(load * unit)) {
                let solution = coarse.solve(&given, load).unwrap();
                let mut budget = Budget::of(&solution, &known);
                if let Some(found) = Between::of(&given, true, &solution.pressure, modulus) {
                    budget = budget.between(&found);
                }
                if let Some(set) = Stiffness::of_set(&mut coarse, &solution).unwrap() {
                    budget = budget.with_stiffness(&set, &known, Line::of(&solution));
                }
                let refined = TwiceFiner::is_wanted(&budget, &known);
                if refined {
                    budget = budget.refined(&finer.solve(load, &budget).unwrap());
                }
                let truth = exact.solve(&fine, load).unwrap();
                let set = Stiffness::of_set(&mut exact, &truth).unwrap();
                let k = usize::from(refined);
                for counts in [&mut counts, &mut all] {
                    counts[k].add(&budget.area, truth.diagnostics.area_fraction_corrected);
                    if let (Some(stated), Some(gap)) = (&budget.mean_gap, truth.state.mean_gap) {
                        counts[2 + k].add(stated, gap);
                    }
                    if let (Some(stated), Some(set)) = (&budget.stiffness, &set) {
                        counts[4 + k].add(stated, set.value);
                    }
                }
            }
        }
        println!("| {name} |{}", counts.iter_mut().map(Count::show).collect::<String>());
    }
    println!("| **all** |{}", all.iter_mut().map(Count::show).collect::<String>());
}
