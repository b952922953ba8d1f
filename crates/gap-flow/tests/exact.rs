//! The flow through gaps whose permeability is known.
#![allow(clippy::unwrap_used, reason = "tests: a panic is the report")]

use contact_types::Grid;
use gap_flow::{Axis, Flow, Gap};
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng as _, SeedableRng as _};
use std::f64::consts::TAU;

fn flow(shape: [usize; 2], pixel: [f64; 2], axis: Axis, gap: impl Fn(usize, usize) -> f64) -> Flow {
    let [ny, nx] = shape;
    let map: Vec<f64> = (0..ny * nx).map(|i| gap(i / nx, i % nx)).collect();
    Gap::new(Grid::new(shape, pixel).unwrap(), &map).flow(axis).unwrap()
}

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{found} instead of {expected}");
}

/// g = g0 (1 + ε cos): across the waves g0³ (1−ε²)^{5/2}/(1+ε²/2), along them g0³ (1+3ε²/2), both axes, pixels that are no
/// squares. Across waves the flux is the same everywhere, along them it goes with g³.
#[test]
fn sinusoids_in_series_and_in_parallel() {
    let g0 = 1e-6;
    for (eps, n) in [(0.2648509822006406, 32), (0.5946722903751879, 64)] {
        let wave = |i: usize| g0 * (1.0 + eps * (TAU * (i as f64 + 0.5) / n as f64).cos());
        let series = g0.powi(3) * (1.0 - eps * eps).powf(2.5) / (1.0 + 0.5 * eps * eps);
        let parallel = g0.powi(3) * (1.0 + 1.5 * eps * eps);
        let (wide, high) = ([5, n], [n, 5]);
        let pixel = [2e-7, 3e-7];
        for [across, along] in [[Axis::X, Axis::Y], [Axis::Y, Axis::X]] {
            let shape = if across == Axis::X { wide } else { high };
            let gap = |y: usize, x: usize| wave(if across == Axis::X { x } else { y });
            let found = flow(shape, pixel, across, gap);
            close(found.permeability, series, 1e-8);
            found.flux.iter().for_each(|flux| close(*flux, 1.0, 1e-9));
            let found = flow(shape, pixel, along, gap);
            close(found.permeability, parallel, 1e-11);
            for (i, flux) in found.flux.iter().enumerate() {
                close(*flux, gap(i / shape[1], i % shape[1]).powi(3) / parallel, 1e-9);
            }
        }
    }
}

/// A checkerboard of conductivities κ1, κ2: √(κ1 κ2) (Dykhne 1971). Here with electrodes along lines of mirror symmetry,
/// which change nothing; from below, and as the corners allow.
#[test]
fn checkerboard() {
    let contrast: f64 = 2.0;
    let of = |cells: usize| {
        // One square, and the halves of its neighbours, between walls: mirror lines all around.
        let [half, n] = [cells / 2, 2 * cells];
        let is_second = |i: usize| ((i + half) / cells) % 2;
        let gap = |y: usize, x: usize| match is_second(y) ^ is_second(x) {
            0 => 1.0,
            _ => contrast.cbrt(),
        };
        let map: Vec<f64> = (0..n * n).map(|i| gap(i / n, i % n)).collect();
        let grid = Grid::new([n, n], [1.0, 1.0]).unwrap();
        Gap::new(grid, &map).repeating([false; 2]).flow(Axis::X).unwrap().permeability
            / contrast.sqrt()
    };
    let errors = [16, 32, 64].map(|cells| (of(cells) - 1.0).abs());
    assert!(errors[2] < 1e-3 && errors.windows(2).all(|e| e[1] < 0.5 * e[0]), "{errors:?}");
}

fn random(seed: u64) -> impl FnMut() -> f64 {
    let mut source = Pcg64Mcg::seed_from_u64(seed);
    move || source.next_u64() as f64 / u64::MAX as f64
}

/// Smooth noise, cut at a level: contact below.
fn rough(n: usize, level: f64) -> Vec<f64> {
    let mut of = random(5);
    let waves: Vec<[f64; 4]> = (0..60)
        .map(|_| [(8.0 * of()).floor(), (16.0 * of()).floor() - 8.0, TAU * of(), of()])
        .collect();
    let height = |i: usize| -> f64 {
        let (y, x) = ((i / n) as f64 / n as f64, (i % n) as f64 / n as f64);
        waves.iter().map(|[a, b, phase, size]| size * (TAU * (a * y + b * x) + phase).cos()).sum()
    };
    (0..n * n).map(|i| (height(i) - level).max(0.0) * 1e-6).collect()
}

/// What flows in flows out; arithmetic faces let more through; a transposed map agrees.
#[test]
fn balance_on_a_rough_map() {
    let n = 96;
    let map = rough(n, -1.0);
    let grid = Grid::new([n, n], [1e-6, 1e-6]).unwrap();
    let found = Gap::new(grid, &map).flow(Axis::X).unwrap();
    let contact = map.iter().filter(|g| **g <= 0.0).count() as f64 / map.len() as f64;
    assert!((0.1..0.5).contains(&contact), "{contact}");
    assert!(found.imbalance < 1e-10, "{}", found.imbalance);
    assert!(found.arithmetic > found.permeability && found.permeability > 0.0);
    let transposed: Vec<f64> = (0..n * n).map(|i| map[(i % n) * n + i / n]).collect();
    let other = Gap::new(grid, &transposed).flow(Axis::Y).unwrap();
    close(other.permeability, found.permeability, 1e-11);
    let [here, there] = [found, other].map(|flow| flow.bottleneck.unwrap());
    close(here.height, there.height, 1e-15);
    assert_eq!((here.place, here.width), ([there.place[1], there.place[0]], there.width));
    // Bounds of Wiener: in series and in parallel.
    let cubes: f64 = map.iter().map(|g| g.powi(3)).sum::<f64>() / map.len() as f64;
    assert!(Gap::new(grid, &map).flow(Axis::X).unwrap().permeability < cubes);
}

/// A wall across the flow: nothing, exactly; with a hole of 3 points that is the bottleneck; along the wall what is open.
#[test]
fn a_wall_seals_and_its_hole_is_the_bottleneck() {
    let n = 24;
    let wall = |y: usize, x: usize, hole: bool| {
        let is_hole = hole && (10..13).contains(&y);
        if !(11..14).contains(&x) {
            1e-6
        } else if is_hole {
            4e-7
        } else {
            0.0
        }
    };
    let pixel = [1e-6, 1e-6];
    let sealed = flow([n, n], pixel, Axis::X, |y, x| wall(y, x, false));
    assert!(sealed.permeability <= 0.0 && sealed.arithmetic <= 0.0 && sealed.bottleneck.is_none());
    let along = flow([n, n], pixel, Axis::Y, |y, x| wall(y, x, false));
    close(along.permeability, 21.0 / 24.0 * 1e-18, 1e-12);
    let open = flow([n, n], pixel, Axis::X, |y, x| wall(y, x, true));
    let bottleneck = open.bottleneck.unwrap();
    close(bottleneck.height, 4e-7, 1e-15);
    assert_eq!(bottleneck.width, 3);
    assert!((10..13).contains(&bottleneck.place[0]) && (11..14).contains(&bottleneck.place[1]));
    // Less than the hole alone lets through: 3 points wide and 3 long in a map of 24 × 24.
    assert!(open.permeability < 24.0 / 24.0 * 6.4e-20 && open.permeability > 1e-21);
    // Points that touch at a corner only are no channel.
    let corner = (0..16).map(|i| if (i % 4 < 2) == (i / 4 < 2) { 1e-6 } else { 0.0 });
    let (grid, corner) = (Grid::new([4, 4], pixel).unwrap(), corner.collect::<Vec<f64>>());
    let gap = Gap::new(grid, &corner);
    for gap in [gap, gap.repeating([false; 2])] {
        assert!(gap.flow(Axis::X).unwrap().bottleneck.is_none());
    }
    assert!(flow([4, 4], pixel, Axis::X, |_, _| 0.0).permeability <= 0.0);
}

/// Gaps of twelve decades beside each other, pools behind almost closed gaps: still solved.
#[test]
fn pools_behind_almost_closed_gaps() {
    let n = 40;
    let mut of = random(9);
    let gates: Vec<f64> = (0..n * n).map(|_| 1e-6 * 10f64.powf(-6.0 * of())).collect();
    let gap = |y: usize, x: usize| {
        if y.is_multiple_of(10) || x % 10 == 5 { gates[y * n + x] } else { 1e-6 }
    };
    let found = flow([n, n], [1e-6, 1e-6], Axis::X, gap);
    assert!(found.permeability > 0.0 && found.arithmetic >= found.permeability);
    assert!(found.imbalance < 1e-6, "{}", found.imbalance);
}

/// A map that repeats leaks the same wherever it is cut; with its mirror images as much as alone between ends and walls.
#[test]
fn a_map_that_repeats_has_no_ends() {
    const N: usize = 48;
    let rough = rough(N, -2.0);
    let of = |m: usize, axis: Axis, repeats: bool, from: fn(usize) -> usize| {
        let map: Vec<f64> = (0..m * m).map(|i| rough[from(i / m) * N + from(i % m)]).collect();
        let grid = Grid::new([m, m], [1e-6, 2e-6]).unwrap();
        Gap::new(grid, &map).repeating([repeats; 2]).flow(axis).unwrap()
    };
    for axis in [Axis::X, Axis::Y] {
        let (plain, rolled) = (of(N, axis, true, |i| i), of(N, axis, true, |i| (i + 17) % N));
        let mirrored = of(N, axis, false, |i| i);
        let images = of(2 * N, axis, true, |i| i.min(2 * N - 1 - i));
        for [one, other] in [[&plain, &rolled], [&mirrored, &images]] {
            close(one.permeability, other.permeability, 1e-10);
            close(one.arithmetic, other.arithmetic, 1e-10);
            let [one, other] = [one, other].map(|flow| flow.bottleneck.unwrap());
            close(one.height, other.height, 1e-15);
        }
        assert_eq!(plain.bottleneck.unwrap().width, rolled.bottleneck.unwrap().width);
        close(plain.flux[19 * N + 20], rolled.flux[2 * N + 3], 1e-9);
    }
}

/// A stair that closes after two turns along x and one along y. Cut into one that ends beside its start it is no channel.
#[test]
fn a_channel_meets_itself() {
    let stair = |turn: usize| {
        let gap = move |y: usize, x: usize| (x / 2..=x.div_ceil(2)).any(|at| at % turn == y % turn);
        (0..64).map(|i| if gap(i / 8, i % 8) { 1.0 } else { 0.0 }).collect::<Vec<_>>()
    };
    let (grid, helix, open) = (Grid::new([8, 8], [1.0; 2]).unwrap(), stair(4), stair(8));
    let of = |map: &[f64], axis| Gap::new(grid, map).permeability(axis).unwrap();
    close(of(&helix, Axis::X), 1.0 / 6.0, 1e-12);
    close(of(&helix, Axis::Y), 1.0 / 24.0, 1e-12);
    assert!(of(&open, Axis::X) <= 0.0);
    assert!(Gap::new(grid, &open).repeating([false, true]).permeability(Axis::X).unwrap() > 0.0);
}

/// Layers on the fewest points; a row that goes on over an end, or round the map, is no width.
#[test]
fn small_maps_and_grooves() {
    for shape in [[1, 2], [2, 2], [3, 2]] {
        let gap = |_, x: usize| [1.0, 2.0][x];
        close(flow(shape, [1.0; 2], Axis::X, gap).permeability, 16.0 / 9.0, 1e-14);
        close(flow(shape, [1.0; 2], Axis::Y, gap).permeability, 4.5, 1e-14);
    }
    close(flow([1, 1], [1.0; 2], Axis::X, |_, _| 2.0).permeability, 8.0, 1e-14);
    let groove: Vec<f64> = (0..256).map(|i| if i / 16 < 6 { 1.0 } else { 0.0 }).collect();
    let gap = Gap::new(Grid::new([16, 16], [1.0; 2]).unwrap(), &groove);
    for repeats in [[true; 2], [false, true], [false; 2]] {
        let found = gap.repeating(repeats).flow(Axis::X).unwrap();
        assert_eq!(found.bottleneck.unwrap().width, 6);
        close(found.permeability, 6.0 / 16.0, 1e-12);
    }
}
