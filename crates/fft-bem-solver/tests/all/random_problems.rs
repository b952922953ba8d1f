//! The chord iteration on random problems: any size, odd and prime sides, pixels of any shape,
//! plateaus, spikes, steps, noise, loads from one node to full contact.

use crate::common;

use common::{Uniform, difference, iterate, self_affine, solve};
use contact_types::{Grid, HeightMap};
use fft_bem_solver::{Diagnostics, Method, Solver};

/// Problem number `k`: a surface and a mean pressure.
fn problem(k: u64, longest: f64) -> (HeightMap, f64, String) {
    let mut random = Uniform(1000 + k);
    let side = |r: f64| (16.0 * (longest / 16.0).powf(r)) as usize;
    let mut shape = [side(random.next()), side(random.next())];
    if random.next() < 0.3 {
        shape[0] = shape[1];
    }
    let pixel = [1.0, 8.0_f64.powf(2.0 * random.next() - 1.0)];
    let grid = Grid::new(shape, if random.next() < 0.4 { [1.0, 1.0] } else { pixel }).unwrap();
    let cutoff = [2.0, 4.0, 8.0][(3.0 * random.next()) as usize] * grid.pixel()[0];
    let extent = grid.size()[0].min(grid.size()[1]);
    let hurst = 0.2 + 0.7 * random.next();
    let rough = self_affine(grid, hurst, extent * (0.1 + random.next()), cutoff, k);
    let mut h = rough.into_heights();
    let rms = (h.iter().map(|h| h * h).sum::<f64>() / h.len() as f64).sqrt();
    let kind = ["rough", "plateaus", "spikes", "steps", "noise", "tilted"];
    let kind = kind[(6.0 * random.next()) as usize];
    match kind {
        "plateaus" => {
            for h in &mut h {
                *h = h.min(0.5 * rms);
            }
        }
        "spikes" => {
            for _ in 0..=(20.0 * random.next()) as usize {
                let i = (h.len() as f64 * random.next()) as usize;
                h[i] += 10.0 * rms * random.next();
            }
        }
        "steps" => {
            let step = rms * (0.05 + 0.5 * random.next());
            for h in &mut h {
                *h = (*h / step).round() * step;
            }
        }
        "noise" => {
            for h in &mut h {
                *h += rms * random.normal();
            }
        }
        "tilted" => {
            let nx = grid.shape()[1];
            for (i, h) in h.iter_mut().enumerate() {
                *h += 3.0 * rms * (i % nx) as f64 / nx as f64;
            }
        }
        _ => {}
    }
    // In units of the rms gradient, 1: from a single node to beyond full contact.
    let load = 10.0_f64.powf(-4.0 + 5.5 * random.next());
    let what = format!("{k}: {shape:?} {:.2?} {kind} H {hurst:.2} load {load:.1e}", grid.pixel());
    (HeightMap::new(grid, h).unwrap(), load, what)
}

/// Solves the first `count` problems to 1e-10 and returns the convolutions to a true rms pressure error
/// of 1e-2, 1e-4 and 1e-6, and the largest ratio of true error to estimate.
fn survey(count: u64, longest: f64) -> ([Vec<f64>; 3], f64) {
    let mut pairs = [vec![], vec![], vec![]];
    let mut optimism = 0.0_f64;
    for k in 0..count {
        let (surface, load, what) = problem(k, longest);
        let chord = || Solver::builder().method(Method::Chord).threads(1);
        let exact = solve(&surface, chord().tolerance(1e-12), load);
        let error = |p: &[f64]| difference(p, &exact.pressure);
        let found = solve(&surface, chord().tolerance(1e-10), load);
        let history = (0..=found.diagnostics.iterations).map(|count| {
            let now = iterate(&surface, chord(), load, count);
            let Diagnostics { transforms, residuals, .. } = now.diagnostics;
            (transforms, error(&now.pressure), residuals.preconditioned)
        });
        let history: Vec<(f64, f64, f64)> = history.collect();
        let last = error(&found.pressure);
        assert!(last <= 3e-10, "{what}: error {last:e}");
        assert!(found.pressure.iter().all(|p| *p >= 0.0), "{what}: tension");
        let range = surface.range().1 - surface.range().0;
        let across: f64 = found.pressure.iter().zip(&found.gap).map(|(p, g)| p * g).sum();
        let carried = load * found.pressure.len() as f64;
        assert!(across.abs() <= 1e-7 * range * carried, "{what}: {across:e} across gaps");
        let deepest = found.gap.iter().fold(0.0_f64, |m, g| m.min(*g));
        assert!(-deepest <= 1e-7 * range, "{what}: penetration {deepest:e} of {range:e}");
        for (pairs, tolerance) in pairs.iter_mut().zip([1e-2, 1e-4, 1e-6]) {
            let first = history.iter().find(|h| h.1 <= tolerance);
            pairs.push(first.map_or(found.diagnostics.transforms, |h| h.0));
        }
        // The first estimate judges a guess; the later ones judge the iterate.
        for (_, error, estimate) in history.iter().skip(2).filter(|h| h.1 > 1e-9) {
            optimism = optimism.max(error / estimate);
        }
    }
    for pairs in &mut pairs {
        pairs.sort_by(f64::total_cmp);
    }
    (pairs, optimism)
}

/// Median and worst, a little above what the method needs.
fn check(pairs: &[Vec<f64>; 3], most: [[f64; 2]; 3]) {
    for (pairs, [median, worst]) in pairs.iter().zip(most) {
        let (m, w) = (pairs[pairs.len() / 2], pairs[pairs.len() - 1]);
        assert!(m <= median && w <= worst, "median {m:.2}, worst {w:.2}");
    }
}

#[test]
fn forty_random_problems_converge() {
    let (pairs, optimism) = survey(40, 100.0);
    assert!(optimism < 1.5, "the estimate was {optimism:.2} times too small");
    check(&pairs, [[4.3, 5.9], [5.4, 7.6], [7.5, 9.8]]);
}
