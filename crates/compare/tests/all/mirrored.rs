//! Mirror images at the edges: the answer is that of the map among its images, and its intervals hold.

use contact_accuracy::{Ladder, Setup};
use contact_types::{ContactModulus, Grid, HeightMap};
use fft_bem_solver::{Load, Solution, Solver};
use std::f64::consts::PI;
use surface_stats::clean::{mirrored, resample};
use surface_stats::{Edges, Level};

fn solve(map: &HeightMap, load: Load, tolerance: f64) -> Solution {
    let modulus = ContactModulus::from_pascals(1e9).unwrap();
    let builder = Solver::builder().tolerance(tolerance).threads(2);
    builder.build(map.grid(), modulus).unwrap().solve(map, load).unwrap()
}

/// Of a map among its mirror images.
fn ladder(map: HeightMap, tolerance: f64) -> Ladder {
    let builder = Solver::builder().tolerance(tolerance).threads(2);
    let setup = Setup::new(builder, ContactModulus::from_pascals(1e9).unwrap());
    Ladder::new(map, Setup { mirrored: true, ..setup }).unwrap()
}

/// Cosines with a crest or a trough at the edges are their own mirror images: on twice the sides
/// they repeat. Odd and even sides, oblong pixels, by pressure and by gap.
#[test]
fn the_answer_is_that_of_the_map_among_its_images() {
    let [ny, nx] = [25, 36];
    let cosines = |shape: [usize; 2]| {
        let height = |i: usize| {
            let place = |i: usize, n: usize| PI * (i as f64 + 0.5) / n as f64;
            let (y, x) = (place(i / shape[1], ny), place(i % shape[1], nx));
            1e-7 * (y.cos() + (2.0 * x).cos() + 0.4 * (5.0 * y).cos() * (3.0 * x).cos())
        };
        let grid = Grid::new(shape, [1.5e-6, 1e-6]).unwrap();
        HeightMap::new(grid, (0..grid.len()).map(height).collect()).unwrap()
    };
    let (part, all) = (cosines([ny, nx]), cosines([2 * ny, 2 * nx]));
    let mut among_images = ladder(part, 1e-10);
    for load in [Load::MeanPressure(2e6), Load::MeanGap(1.5e-7)] {
        let found = among_images.solve(load, |_| ()).unwrap().solution;
        let expected = solve(&all, load, 1e-10);
        assert_eq!((found.pressure.len(), found.gap.len()), (ny * nx, ny * nx));
        let top = expected.diagnostics.max_pressure;
        for iy in 0..ny {
            for ix in 0..nx {
                let (a, b) = (found.pressure[iy * nx + ix], expected.pressure[iy * 2 * nx + ix]);
                assert!((a - b).abs() < 1e-8 * top, "{iy} {ix}: {a} {b}");
            }
        }
        let touching = found.pressure.iter().filter(|p| **p > 0.0).count();
        assert_eq!(found.diagnostics.contact_pixels, touching);
        assert!((found.state.mean_pressure / expected.state.mean_pressure - 1.0).abs() < 1e-8);
        assert!((found.state.area_fraction - expected.state.area_fraction).abs() < 1e-12);
    }
}

/// Crops whose edges do not match, against the same on four times as many points a side.
#[test]
fn the_intervals_hold() {
    for seed in 1..=6 {
        let n = 96;
        let grid = Grid::new([2 * n, 2 * n], [1e-6; 2]).unwrap();
        let waves = [48e-6 * seed as f64 / 2.0, 6e-6];
        let whole = crate::rough(grid, 0.5 + 0.05 * seed as f64, waves, seed);
        let eighths = resample(&whole, [16 * n, 16 * n], Edges::Periodic).unwrap();
        // `factor` points to a pixel, their pixels together those of the crop.
        let crop = |factor: usize| {
            let side = 16 * n;
            let at = |i: usize| (side + 8 * i / factor + 4 / factor - 4) % side;
            let grid = Grid::new([factor * n; 2], [1e-6 / factor as f64; 2]).unwrap();
            let heights = (0..grid.len())
                .map(|i| eighths.at(at(i / (factor * n)), at(i % (factor * n))))
                .collect();
            Level::Plane.taken_off(HeightMap::new(grid, heights).unwrap()).unwrap().1
        };
        let (map, finer) = (crop(1), crop(4));
        let mut ladder = ladder(map, 1e-4);
        for load in [0.02, 0.2] {
            let load = Load::MeanPressure(load * 1e9 * 0.1);
            let answered = ladder.solve(load, |_| ()).unwrap();
            assert_ne!(answered.coarser[0], answered.coarser[1], "seed {seed}: one choice");
            let given = answered.budget;
            let truth = solve(&mirrored(&finer).unwrap(), load, 1e-5);
            let gap = given.mean_gap.unwrap();
            let off = |found: f64, exact: f64, bar: f64| (found - exact).abs() / bar;
            let area =
                off(given.area.value, truth.state.area_fraction, given.area.half_width().unwrap());
            let gap = off(gap.value, truth.state.mean_gap.unwrap(), gap.half_width().unwrap());
            assert!(area <= 1.0 && gap <= 1.0, "seed {seed}: area {area:.2}, gap {gap:.2}");
        }
    }
}
