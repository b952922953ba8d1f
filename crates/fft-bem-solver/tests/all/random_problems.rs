//! The chord iteration on random problems: any size, odd and prime sides, pixels of any shape,
//! plateaus, spikes, steps, noise, loads from one node to full contact.

use crate::common;

use common::{Uniform, difference, self_affine, solve, unit_modulus};
use contact_types::{Grid, HeightMap};
use fft_bem_solver::{Iteration, Load, Solver};

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
        "plateaus" => h.iter_mut().for_each(|h| *h = h.min(0.5 * rms)),
        "spikes" => {
            for _ in 0..=(20.0 * random.next()) as usize {
                let i = (h.len() as f64 * random.next()) as usize;
                h[i] += 10.0 * rms * random.next();
            }
        }
        "steps" => {
            let step = rms * (0.05 + 0.5 * random.next());
            h.iter_mut().for_each(|h| *h = (*h / step).round() * step);
        }
        "noise" => h.iter_mut().for_each(|h| *h += rms * random.normal()),
        "tilted" => {
            let nx = grid.shape()[1];
            let tilt = |i: usize| 3.0 * rms * (i % nx) as f64 / nx as f64;
            h.iter_mut().enumerate().for_each(|(i, h)| *h += tilt(i));
        }
        _ => {}
    }
    // In units of the rms gradient, 1: from a single node to beyond full contact.
    let load = 10.0_f64.powf(-4.0 + 5.5 * random.next());
    let what = format!("{k}: {shape:?} {:.2?} {kind} H {hurst:.2} load {load:.1e}", grid.pixel());
    (HeightMap::new(grid, h).unwrap(), load, what)
}

/// Each to 1e-10; the convolutions to a true rms pressure error of 1e-2, 1e-4 and 1e-6, median and worst, are a
/// little less than these limits, and no estimate is much smaller than the true error.
#[test]
fn forty_random_problems_converge() {
    let mut pairs = [vec![], vec![], vec![]];
    let mut optimism = 0.0_f64;
    for k in 0..40 {
        let (surface, load, what) = problem(k, 100.0);
        let exact = solve(&surface, Solver::builder().tolerance(1e-12), load);
        let error = |p: &[f64]| difference(p, &exact.pressure);
        let mut history = Vec::new();
        let mut solver =
            Solver::builder().tolerance(1e-10).build(surface.grid(), unit_modulus()).unwrap();
        let watch = |it: &Iteration<'_>| {
            history.push((it.transforms, error(&it.pressure_and_gap()[0]), it.residual));
        };
        let found = solver.solve_observed(&surface, Load::MeanPressure(load), watch);
        let found = found.unwrap_or_else(|e| panic!("{what}: {e}"));
        let last = error(&found.pressure);
        assert!(last <= 3e-10, "{what}: error {last:e}");
        assert!(found.pressure.iter().all(|p| *p >= 0.0), "{what}: tension");
        let deepest = found.diagnostics.residuals.penetration;
        assert!(deepest <= 1e-7, "{what}: penetration {deepest:e}");
        for (pairs, tolerance) in pairs.iter_mut().zip([1e-2, 1e-4, 1e-6]) {
            let first = history.iter().find(|h| h.1 <= tolerance);
            pairs.push(first.map_or(found.diagnostics.transforms, |h| h.0));
        }
        // The first estimate judges a guess; the later ones judge the iterate.
        for (_, error, estimate) in history.iter().skip(2).filter(|h| h.1 > 1e-9) {
            optimism = optimism.max(error / estimate);
        }
    }
    assert!(optimism < 1.5, "the estimate was {optimism:.2} times too small");
    for (pairs, [median, worst]) in pairs.iter_mut().zip([[4.3, 5.9], [5.4, 7.6], [7.5, 9.8]]) {
        pairs.sort_by(f64::total_cmp);
        let (m, w) = (pairs[pairs.len() / 2], pairs[pairs.len() - 1]);
        assert!(m <= median && w <= worst, "median {m:.2}, worst {w:.2}");
    }
}
