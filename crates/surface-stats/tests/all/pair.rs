//! Two bodies as one: what must be exact is exact, what adds in the mean adds within its scatter.

use crate::recipe;
use contact_types::{Grid, HeightMap, Named};
use surface_stats::pair::{Composite, Flip, Independence, Placing};
use surface_stats::synthesis::SelfAffine;
use surface_stats::{Edges, Level, StatsError};

fn rough(shape: [usize; 2], seed: u64) -> HeightMap {
    SelfAffine { seed, ..recipe(shape, [16.0, 6.0]) }.generate().unwrap()
}

/// A part that does not repeat.
fn part(map: &HeightMap, shape: [usize; 2]) -> HeightMap {
    let grid = Grid::new(shape, map.grid().pixel()).expect("a grid");
    let heights = (0..shape[0]).flat_map(|y| (0..shape[1]).map(move |x| (y, x)));
    HeightMap::new(grid, heights.map(|(y, x)| map.at(y + 3, x + 5)).collect()).expect("finite")
}

fn laid(first: &HeightMap, second: &HeightMap, flip: Flip, shift: [f64; 2]) -> Composite {
    Composite::of(first, second, &Placing { flip, shift }).unwrap()
}

fn negative(map: &HeightMap) -> HeightMap {
    HeightMap::new(map.grid(), map.heights().iter().map(|h| -h).collect()).unwrap()
}

fn mirrored(map: &HeightMap, how: Flip) -> HeightMap {
    let [ny, nx] = map.grid().shape();
    let height = |i: usize| match how {
        Flip::Columns => map.at(i / nx, nx - 1 - i % nx),
        Flip::Rows => map.at(ny - 1 - i / nx, i % nx),
        Flip::None => map.heights()[i],
    };
    HeightMap::new(map.grid(), (0..ny * nx).map(height).collect()).unwrap()
}

/// A flat body changes no bit, and one mates with its own negative.
#[test]
fn a_flat_body_and_the_negative() {
    for map in [rough([48, 64], 1), part(&rough([64, 64], 1), [40, 30])] {
        let flat = HeightMap::from_fn(map.grid(), |_, _| 0.0).unwrap();
        for how in Flip::all() {
            let pair = laid(&map, &flat, how, [0.0; 2]);
            assert_eq!(pair.map, map);
            assert!(pair.placed.shares.iter().all(|share| share.to_bits() == 1.0f64.to_bits()));
            let found = Independence::of(&pair, Level::Plane, Edges::Open).unwrap();
            assert!(found.holds() && found.excess.iter().all(|e| e.abs() < 1e-12), "{found:?}");

            let pair = laid(&map, &negative(&mirrored(&map, how)), how, [0.0; 2]);
            assert!(pair.map.is_flat() && pair.map.at(3, 4).abs() < f64::MIN_POSITIVE, "{how:?}");
            let found = Independence::of(&pair, Level::Plane, Edges::Open).unwrap();
            let mates = found.excess.iter().all(|e| (e + 1.0).abs() < 1e-12);
            assert!(!found.holds() && mates, "{found:?}");
        }
    }
}

/// The bodies change places: the same gap, seen from the other side.
#[test]
fn the_order_of_the_bodies_does_not_matter() {
    let (a, b) = (rough([48, 64], 1), rough([48, 64], 2));
    for (a, b) in [(part(&a, [32, 40]), part(&b, [32, 40])), (a, b)] {
        for how in Flip::all() {
            let shift = [3e-6, 5e-6];
            let one = laid(&a, &b, how, shift);
            // Seen from the other side, the first body moved back, mirrored as the map is.
            let back = match how {
                Flip::Columns => [-shift[0], shift[1]],
                Flip::Rows => [shift[0], -shift[1]],
                Flip::None => [-shift[0], -shift[1]],
            };
            let other = laid(&b, &a, how, back);
            let seen = mirrored(&other.map, how);
            if one.placed.is_rolled {
                // A roll of a periodic map: the same up to where it begins.
                let mut all = [one.map.heights().to_vec(), seen.heights().to_vec()];
                for heights in &mut all {
                    heights.sort_by(f64::total_cmp);
                }
                assert_eq!(all[0], all[1]);
            } else {
                assert_eq!(one.map, seen, "{how:?}");
            }
        }
    }
}

#[test]
fn a_shift_by_a_period_is_none() {
    let (a, b) = (rough([48, 64], 1), rough([48, 64], 2));
    let unmoved = laid(&a, &b, Flip::Columns, [0.0; 2]);
    for shift in [[48e-6, 0.0], [0.0, -64e-6], [-96e-6, 640e-6]] {
        let moved = laid(&a, &b, Flip::Columns, shift);
        assert!(moved.placed.is_rolled);
        assert_eq!(moved.map, unmoved.map);
    }
    // By one point right and two down, by hand.
    let moved = laid(&a, &b, Flip::None, [2e-6, 1e-6]);
    for (y, x) in [(0, 0), (5, 7), (47, 63)] {
        let other = b.at((y + 46) % 48, (x + 63) % 64);
        assert_eq!(moved.map.at(y, x).to_bits(), (a.at(y, x) + other).to_bits());
    }
}

/// Without a period the common part is what is left, and it is where it should be.
#[test]
fn open_maps_keep_what_they_have_in_common() {
    let (a, b) = (rough([64, 64], 1), rough([64, 64], 2));
    let (a, b) = (part(&a, [40, 30]), part(&b, [40, 30]));
    let pair = laid(&a, &b, Flip::None, [10.3e-6, -4e-6]);
    assert_eq!(pair.map.grid().shape(), [30, 26]);
    assert_eq!(pair.map.at(0, 0).to_bits(), (a.at(10, 0) + b.at(0, 4)).to_bits());
    assert!((pair.placed.shift[0] - 10e-6).abs() < 1e-18, "whole points");
    let [first, second] = pair.placed.shares;
    assert!((first - 30.0 * 26.0 / 1200.0).abs() < 1e-12 && first.to_bits() == second.to_bits());
    let far = Composite::of(&a, &b, &Placing { flip: Flip::None, shift: [0.0, 29e-6] });
    assert!(matches!(far, Err(StatsError::TooLittle { .. })));
}

/// m0, m2, m4 of two independent surfaces add, on the average exactly and each time within the scatter
/// that is reported: of 60 pairs the deviations in units of it have mean 0 and spread 1, to four of
/// their own standard errors.
#[test]
fn moments_of_independent_surfaces_add_within_the_scatter_reported() {
    for is_open in [false, true] {
        let mut deviations = [Vec::new(), Vec::new(), Vec::new()];
        for seed in 0..60 {
            let map = |seed| {
                let map = rough([80, 96], seed);
                if is_open { part(&map, [72, 80]) } else { map }
            };
            let (a, b) = (map(2 * seed), map(2 * seed + 1));
            let pair = laid(&a, &b, Flip::Rows, [0.0; 2]);
            let found = Independence::of(&pair, Level::Mean, Edges::Open).unwrap();
            for (k, all) in deviations.iter_mut().enumerate() {
                all.push(found.excess[k] / found.chance[k]);
            }
        }
        let n = 60.0;
        for (k, all) in deviations.iter().enumerate() {
            let mean = all.iter().sum::<f64>() / n;
            let spread = (all.iter().map(|z| z * z).sum::<f64>() / n).sqrt();
            assert!(mean.abs() < 4.0 / f64::sqrt(n), "m{} open {is_open}: mean {mean}", 2 * k);
            let most = 4.0 / f64::sqrt(2.0 * n);
            assert!((spread - 1.0).abs() < most, "m{} open {is_open}: spread {spread}", 2 * k);
        }
    }
}

/// A coarse map of long waves is what a fine one of the same waves is.
#[test]
fn different_points_give_the_same_sum() {
    let wave = |y: f64, x: f64| 1e-7 * ((y / 9e-6).sin() + (x / 7e-6 + y / 20e-6).cos());
    let on = |shape, pixel: f64, y0: f64, x0: f64| {
        let grid = Grid::new(shape, [pixel; 2]).unwrap();
        HeightMap::from_fn(grid, |y, x| wave(y + y0, x + x0)).unwrap()
    };
    // Centres on each other: the fine map is 40.5 um wide, the coarse one 40.
    let fine = on([82, 82], 0.5e-6, 0.0, 0.0);
    let coarse = on([41, 41], 1e-6, 0.25e-6, 0.25e-6);
    let pair = laid(&fine, &coarse, Flip::None, [0.0; 2]);
    assert_eq!(pair.placed.resampled, [false, true]);
    assert!((pair.placed.pixel_ratio - 2.0).abs() < 1e-12);
    assert_eq!(pair.map.grid().shape(), [80, 80]);
    let worst = pair.map.heights().iter().zip(pair.parts[0].heights());
    let worst = worst.map(|(sum, own)| (sum - 2.0 * own).abs()).fold(0.0, f64::max);
    // Keys: third order at the edges, h³|f'''|/… ≈ 1e-7 (1/7)³ of a micrometre wave.
    assert!(worst < 1e-7 * (1.0f64 / 7.0).powi(3), "{worst:e}");
    let swapped = laid(&coarse, &fine, Flip::None, [0.0; 2]);
    assert_eq!(swapped.placed.resampled, [true, false]);
    for (a, b) in swapped.map.heights().iter().zip(pair.map.heights()) {
        assert!((a - b).abs() < 1e-18);
    }
}

/// Maps that repeat are put on the finer points without loss of a wave.
#[test]
fn periodic_maps_keep_their_waves() {
    use std::f64::consts::TAU;
    let cell = |n: usize| {
        let grid = Grid::new([n, n], [64e-6 / n as f64; 2]).unwrap();
        HeightMap::from_fn(grid, |y, x| {
            1e-7 * ((TAU * y / 16e-6).sin() + (TAU * (x - 2.0 * y) / 64e-6).cos())
        })
        .unwrap()
    };
    let pair = laid(&cell(128), &cell(32), Flip::None, [0.0; 2]);
    assert!(pair.placed.is_rolled && pair.placed.resampled == [false, true]);
    for (sum, own) in pair.map.heights().iter().zip(cell(128).heights()) {
        assert!((sum - 2.0 * own).abs() < 1e-20);
    }
}
