//! What must hold for any surface and load, whatever the method, the threads, the shape of the grid.

use crate::common;

use common::{Uniform, difference, self_affine, solver, to, unit_grid};
use contact_types::{ContactModulus, Grid, HeightMap};
use fft_bem_solver::{Boundary, Load, Method, Precision, Solution, Solver};
use proptest::prelude::*;

const TOLERANCE: f64 = 1e-8;

/// Rough heights of any character: noise, smooth waves, plateaus, steps.
fn heights(n: usize, seed: u64) -> Vec<f64> {
    let mut random = Uniform(seed);
    let kind = seed % 4;
    let (a, b) = (0.1 + random.next(), 0.1 + random.next());
    (0..n)
        .map(|i| {
            let wave = (a * i as f64).sin() + (b * (i * i) as f64 * 0.01).cos();
            match kind {
                0 => random.normal(),
                1 => wave,
                2 => wave.min(0.3),
                _ => (4.0 * (wave + 0.2 * random.normal())).round() / 4.0,
            }
        })
        .collect()
}

fn solve(map: &HeightMap, method: Method, boundary: Boundary, load: f64) -> Solution {
    common::solve(map, to(TOLERANCE).method(method).boundary(boundary), load)
}

fn any_method() -> impl Strategy<Value = Method> {
    prop_oneof![Just(Method::Auto), Just(Method::PolonskyKeer), Just(Method::StanleyKato)]
}

fn any_boundary() -> impl Strategy<Value = Boundary> {
    prop_oneof![Just(Boundary::Periodic), Just(Boundary::Free)]
}

fn assert_same_field(a: &[f64], b: &[f64], tolerance: f64) {
    let size = a.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    for (i, (x, y)) in a.iter().zip(b).enumerate() {
        assert!((x - y).abs() <= tolerance * size, "pixel {i}: {x} and {y}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 60,
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    /// Load carried, no tension, no overlap, no pressure across a gap.
    #[test]
    fn conditions_of_contact(
        ny in 1usize..20, nx in 1usize..20, dy in 0.2..5.0f64, seed in 0u64..10000,
        log_load in -5.0..1.5f64, method in any_method(), boundary in any_boundary(),
    ) {
        let grid = Grid::new([ny, nx], [dy, 1.0]).unwrap();
        let map = HeightMap::new(grid, heights(grid.len(), seed)).unwrap();
        let load = 10f64.powf(log_load);
        let found = solve(&map, method, boundary, load);
        let n = grid.len() as f64;
        let (low, high) = map.range();
        let range = (high - low).max(1e-300);

        let carried = found.pressure.iter().sum::<f64>() / n;
        prop_assert!((carried / load - 1.0).abs() < 1e-12);
        prop_assert!(found.pressure.iter().all(|p| *p >= 0.0));
        let d = &found.diagnostics;
        prop_assert!(d.residuals.preconditioned <= TOLERANCE);
        if high > low {
            let deepest = found.gap.iter().fold(0.0_f64, |m, g| m.max(-g));
            prop_assert!((deepest - d.residuals.penetration * range).abs() <= 1e-12 * range);
            // The residual times the compliance of the longest wave.
            let compliance = load * n.max(ny as f64 * dy) * d.max_pressure / load;
            prop_assert!(deepest <= 10.0 * TOLERANCE * (compliance + range), "{deepest} {compliance}");
            let weighted: f64 = found.pressure.iter().zip(&found.gap).map(|(p, g)| p * g).sum();
            prop_assert!(weighted.abs() <= 1e-9 * load * n * (range + compliance));
        }
        let contact = found.pressure.iter().filter(|p| **p > 0.0).count();
        prop_assert_eq!(contact, d.contact_pixels);
        prop_assert!((found.touching_fraction() - contact as f64 / n).abs() < 1e-15);
        let open = |i: usize| boundary == Boundary::Periodic || found.pressure[i] <= 0.0;
        let mean_gap = (0..grid.len()).filter(|i| open(*i)).map(|i| found.gap[i]).sum::<f64>() / n;
        prop_assert!((mean_gap - found.state.mean_gap.unwrap()).abs() <= 1e-12 * range);
        prop_assert!(d.duality_gap >= 0.0);
    }

    /// More load, more contact, smaller gap, and never the other way.
    #[test]
    fn area_and_approach_grow_with_load(seed in 0u64..10000, method in any_method()) {
        let grid = Grid::new([13, 16], [1.0, 0.7]).unwrap();
        let map = HeightMap::new(grid, heights(grid.len(), seed)).unwrap();
        let mut last = (0, 0.0);
        for load in [1e-3, 0.01, 0.1, 0.5, 2.0] {
            let found = solve(&map, method, Boundary::Periodic, load);
            let now = (found.diagnostics.contact_pixels, found.approach);
            prop_assert!(now.0 >= last.0 && now.1 >= last.1 * (1.0 - 1e-9), "{last:?} {now:?}");
            last = now;
        }
    }

    /// A shifted or transposed surface has the shifted or transposed solution.
    #[test]
    fn shift_and_transpose(
        sy in 0usize..11, sx in 0usize..14, seed in 0u64..10000, method in any_method(),
    ) {
        let (ny, nx) = (11, 14);
        let grid = Grid::new([ny, nx], [0.6, 1.0]).unwrap();
        let h = heights(grid.len(), seed);
        let load = 0.1;
        let original = solve(&HeightMap::new(grid, h.clone()).unwrap(), method, Boundary::Periodic, load);

        let shift = |f: &[f64]| -> Vec<f64> {
            (0..ny * nx).map(|i| f[(i / nx + sy) % ny * nx + (i % nx + sx) % nx]).collect()
        };
        let shifted = solve(&HeightMap::new(grid, shift(&h)).unwrap(), method, Boundary::Periodic, load);
        assert_same_field(&shift(&original.pressure), &shifted.pressure, 1e-6);

        let transpose = |f: &[f64]| -> Vec<f64> {
            (0..ny * nx).map(|i| f[i % ny * nx + i / ny]).collect()
        };
        let across = Grid::new([nx, ny], [1.0, 0.6]).unwrap();
        let map = HeightMap::new(across, transpose(&h)).unwrap();
        let transposed = solve(&map, method, Boundary::Periodic, load);
        assert_same_field(&transpose(&original.pressure), &transposed.pressure, 1e-6);
    }

    /// Powers of two, which do not round, leave every bit; any other number all but rounding.
    #[test]
    fn units_change_nothing(
        seed in 0u64..10000, log_h in -12.0..3.0f64, log_d in -9.0..3.0f64, log_e in 0.0..12.0f64,
        is_exact in any::<bool>(), method in any_method(), boundary in any_boundary(),
    ) {
        let unit = |log: f64| {
            if is_exact { 2f64.powi((3.32 * log) as i32) } else { 10f64.powf(log) }
        };
        let (h0, d0, e0) = (unit(log_h), unit(log_d), unit(log_e));
        let (grid, h) = (Grid::new([9, 12], [1.0, 1.5]).unwrap(), heights(108, seed));
        let (load, p0) = (0.05, e0 * (h0 / d0));
        let original = solve(&HeightMap::new(grid, h.clone()).unwrap(), method, boundary, load);
        let grid = Grid::new([9, 12], [d0, 1.5 * d0]).unwrap();
        let map = HeightMap::new(grid, h.iter().map(|h| h * h0).collect()).unwrap();
        let builder = to(TOLERANCE).method(method).boundary(boundary);
        let mut solver = builder.build(grid, ContactModulus::from_pascals(e0).unwrap()).unwrap();
        let scaled = solver.solve(&map, Load::MeanPressure(load * p0)).unwrap();
        let pressure: Vec<f64> = scaled.pressure.iter().map(|p| p / p0).collect();
        let gap: Vec<f64> = scaled.gap.iter().map(|g| g / h0).collect();
        if is_exact {
            prop_assert_eq!(scaled.diagnostics.iterations, original.diagnostics.iterations);
            prop_assert_eq!(&original.pressure, &pressure);
            prop_assert_eq!(&original.gap, &gap);
        }
        assert_same_field(&original.pressure, &pressure, 10.0 * TOLERANCE);
        assert_same_field(&original.gap, &gap, 10.0 * TOLERANCE);
    }

    /// What the load gives, the gap asks for: control by mean gap returns the load.
    #[test]
    fn control_by_gap_returns_the_load(seed in 0u64..10000, log_load in -3.0..0.0f64, method in any_method()) {
        let grid = Grid::new([12, 15], [1.0, 1.0]).unwrap();
        let map = HeightMap::new(grid, heights(grid.len(), seed)).unwrap();
        let load = 10f64.powf(log_load);
        let by_load = solve(&map, method, Boundary::Periodic, load);
        let gap = by_load.state.mean_gap.unwrap();
        prop_assume!(gap > 1e-3);
        let mut solver = solver(grid, to(TOLERANCE).method(method));
        let found = solver.solve(&map, Load::MeanGap(gap)).unwrap();
        prop_assert!((found.state.mean_pressure / load - 1.0).abs() < 1e-6);
        prop_assert!((found.state.mean_gap.unwrap() - gap).abs() < 1e-6 * (gap + by_load.approach));
        prop_assert!((found.approach - by_load.approach).abs() < 1e-6 * (gap + by_load.approach));
        assert_same_field(&by_load.pressure, &found.pressure, 1e-5);
    }

    #[test]
    fn single_precision(seed in 0u64..10000, log_load in -3.0..0.5f64, method in any_method()) {
        let grid = Grid::new([24, 25], [1.0, 1.0]).unwrap();
        let map = HeightMap::new(grid, heights(grid.len(), seed)).unwrap();
        let load = 10f64.powf(log_load);
        let double = solve(&map, method, Boundary::Periodic, load);
        let single = to(1e-4).method(method).precision(Precision::Single);
        let single = common::solve(&map, single, load);
        let error = difference(&single.pressure, &double.pressure);
        prop_assert!(error < 3e-4, "{error}");
    }
}

/// Sums are taken piece by piece, so the number of threads changes no bit, whatever the method.
#[test]
fn threads_change_no_bit() {
    let surface = self_affine(unit_grid(260, 233), 0.8, 30.0, 2.0, 11);
    let with = |method| Solver::builder().method(method);
    let free = with(Method::Chord).boundary(Boundary::Free);
    for builder in [
        with(Method::Chord),
        with(Method::Chord).precision(Precision::Single),
        free,
        with(Method::PolonskyKeer).tolerance(0.05),
        with(Method::StanleyKato).tolerance(0.05),
    ] {
        let solved = [1, 2, 3].map(|n| common::solve(&surface, builder.clone().threads(n), 0.05));
        let bits = |s: &Solution| -> Vec<u64> {
            let fields = s.pressure.iter().chain(&s.gap).chain([&s.diagnostics.transforms]);
            fields.map(|x| x.to_bits()).collect()
        };
        let [one, two, three] = solved.each_ref().map(bits);
        assert!(one == two && one == three, "{builder:?}");
        let [one, two, three] = solved.map(|s| s.diagnostics.iterations);
        assert!(one == two && one == three, "{builder:?}");
    }
}

/// From 1 x N to pixels of 1:1000, from a single spike to a plateau, all loads.
#[test]
fn odd_grids_and_surfaces_converge() {
    let mut random = Uniform(7);
    let maps: [([usize; 2], [f64; 2]); 8] = [
        ([1, 1], [1.0, 1.0]),
        ([1, 2], [1.0, 1.0]),
        ([3, 2], [1.0, 5.0]),
        ([1, 1009], [1.0, 1.0]),
        ([1009, 1], [1.0, 1.0]),
        ([5, 331], [1.0, 1.0]),
        ([127, 131], [1.0, 1.0]),
        ([64, 96], [1.0, 1000.0]),
    ];
    for (shape, pixel) in maps {
        let grid = Grid::new(shape, pixel).unwrap();
        let noise: Vec<f64> = (0..grid.len()).map(|_| random.normal()).collect();
        let mut spike = vec![0.0; grid.len()];
        spike[grid.len() / 2] = 1.0;
        let plateau: Vec<f64> = noise.iter().map(|h| h.min(0.0)).collect();
        let offset: Vec<f64> = noise.iter().map(|h| 1e6 + h).collect();
        for (kind, heights) in
            [("noise", noise), ("spike", spike), ("plateau", plateau), ("offset", offset)]
        {
            let surface = HeightMap::new(grid, heights).unwrap();
            for load in [1e-9, 1e-3, 0.1, 100.0] {
                let mut solver = solver(grid, to(1e-8).method(Method::Chord));
                let found = solver.solve(&surface, Load::MeanPressure(load));
                let found = found.unwrap_or_else(|e| {
                    panic!("{kind} on {shape:?} of {pixel:?} at {load:e}: {e}")
                });
                let mean = found.pressure.iter().sum::<f64>() / grid.len() as f64;
                assert!((mean / load - 1.0).abs() < 1e-9, "{shape:?}: {mean} for {load}");
                assert!(found.pressure.iter().all(|p| *p >= 0.0));
            }
        }
    }
}

#[test]
fn single_precision_reaches_what_it_states() {
    let surface = self_affine(unit_grid(128, 150), 0.8, 20.0, 2.0, 2);
    let exact = common::solve(&surface, to(1e-10), 0.05);
    let found = common::solve(&surface, to(2e-5).precision(Precision::Single), 0.05);
    let error = difference(&found.pressure, &exact.pressure);
    assert!(error < 2e-5, "{error:e}");
}
