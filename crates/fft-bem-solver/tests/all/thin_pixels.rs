//! Pixels longer one way than the other, up to 1 : 1000, cost about what square ones cost.

use crate::common;

use common::{curve, difference, self_affine, solve, solver, to, unit_grid};
use contact_types::{Grid, HeightMap};
use fft_bem_solver::{Boundary, Load, Precision, Solution};

const SHAPE: [usize; 2] = [112, 91];

/// Surfaces of rms gradient 1 on these pixels.
fn surfaces(pixel: [f64; 2]) -> Vec<(&'static str, HeightMap)> {
    let grid = Grid::new(SHAPE, pixel).unwrap();
    let [extent, short] = [grid.size()[0].max(grid.size()[1]), pixel[0].min(pixel[1])];
    let alike_in_metres = self_affine(grid, 0.8, extent / 8.0, 2.0 * short, 1).into_heights();
    let alike_in_pixels =
        self_affine(unit_grid(SHAPE[0], SHAPE[1]), 0.8, 16.0, 4.0, 1).into_heights();
    let rms = (alike_in_metres.iter().map(|h| h * h).sum::<f64>() / grid.len() as f64).sqrt();
    let worn = alike_in_metres.iter().map(|h| h.min(0.5 * rms)).collect();
    let spike = |i: usize| if i == grid.len() / 3 { 1.0 } else { 0.0 };
    let spike = (0..grid.len()).map(spike).collect();
    let all = [
        ("alike in metres", alike_in_metres),
        ("alike in pixels", alike_in_pixels),
        ("worn to a plateau", worn),
        ("one spike", spike),
    ];
    all.map(|(name, h)| (name, with_unit_gradient(grid, &h))).into()
}

fn with_unit_gradient(grid: Grid, h: &[f64]) -> HeightMap {
    let ([ny, nx], [dy, dx]) = (grid.shape(), grid.pixel());
    let square = |i: usize| {
        let (right, below) = (i / nx * nx + (i + 1) % nx, (i + nx) % (ny * nx));
        ((h[right] - h[i]) / dx).powi(2) + ((h[below] - h[i]) / dy).powi(2)
    };
    let gradient = ((0..h.len()).map(square).sum::<f64>() / h.len() as f64).sqrt();
    HeightMap::new(grid, h.iter().map(|h| h / gradient).collect()).unwrap()
}

/// Pairs spent, and the relative rms error of the pressure.
fn spent_and_missed(found: &Solution, exact: &Solution) -> (f64, f64) {
    (found.diagnostics.transforms, difference(&found.pressure, &exact.pressure))
}

/// To an estimate of 1e-10; square pixels need up to 12.
#[test]
fn thin_pixels_need_at_most_twenty_pairs() {
    for ratio in [2.0, 8.0, 100.0, 1000.0] {
        for pixel in [[ratio, 1.0], [1.0, ratio]] {
            for (name, map) in surfaces(pixel) {
                for load in [0.02, 0.2] {
                    let pairs = solve(&map, to(1e-10), load).diagnostics.transforms;
                    assert!(pairs <= 20.0, "{pixel:?}, {name}, {load}: {pairs:.1} pairs");
                }
            }
        }
    }
}

/// Copies of these would be nearer than their own ends, and the estimate many times too small.
#[test]
fn slender_isolated_maps_need_few_pairs_and_know_their_error() {
    let long = |shape: [usize; 2]| {
        let map = self_affine(unit_grid(shape[0], shape[1]), 0.8, 16.0, 4.0, 1);
        ("long", with_unit_gradient(map.grid(), map.heights()))
    };
    let mut maps = surfaces([1000.0, 1.0]);
    maps.extend(surfaces([1.0, 100.0]));
    maps.extend([long([16, 512]), long([512, 16])]);
    for (name, map) in maps {
        for load in [0.02, 0.2] {
            let free = |tolerance| solve(&map, to(tolerance).boundary(Boundary::Free), load);
            let exact = free(1e-12);
            for tolerance in [1e-4, 1e-10] {
                let (pairs, error) = spent_and_missed(&free(tolerance), &exact);
                let place = format!("{:?}, {name}, {load}, {tolerance}", map.grid());
                assert!(pairs <= 27.0, "{place}: {pairs:.1} pairs");
                assert!(error <= 1.5 * tolerance, "{place}: error {error:.1e}");
            }
        }
    }
}

/// Warm starts, mean gaps and single precision on the thinnest pixels.
#[test]
fn curves_gaps_and_single_precision_on_thin_pixels() {
    for (name, map) in surfaces([1000.0, 1.0]) {
        let loads = [0.01, 0.03, 0.1, 0.3];
        let exact = loads.map(|load| solve(&map, to(1e-11), load));
        let mut solver = solver(map.grid(), to(1e-6));
        for (k, found) in curve(&mut solver, &map, &loads).iter().enumerate() {
            let (pairs, error) = spent_and_missed(found, &exact[k]);
            assert!(pairs <= 16.0 && error <= 3e-6, "{name}, load {k}: {pairs:.1}, {error:.1e}");
        }
        let found = solve(&map, to(1e-3).precision(Precision::Single), loads[2]);
        let (pairs, error) = spent_and_missed(&found, &exact[2]);
        assert!(pairs <= 10.0 && error <= 2e-3, "{name}, single: {pairs:.1}, {error:.1e}");

        if name == "one spike" {
            continue;
        }
        let gap = exact[2].state.mean_gap.unwrap();
        solver.forget();
        let found = solver.solve(&map, Load::MeanGap(gap)).unwrap();
        let (pairs, error) = spent_and_missed(&found, &exact[2]);
        assert!(pairs <= 25.0 && error <= 1e-5, "{name}, gap: {pairs:.1}, {error:.1e}");
    }
}
