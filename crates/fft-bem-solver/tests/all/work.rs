//! Work done, in iterations and FFT convolutions: a slowdown fails here, on any machine. The counts are
//! those of today; fewer is fine, more needs a reason.

use crate::common;

use common::{curve, measured_like, self_affine, solve, solver, to, unit_grid};
use fft_bem_solver::{Boundary, Load, Method, Solver};

/// Convolutions to 1e-4 by chord, Polonsky-Keer, Stanley-Kato, and with the free boundary.
#[test]
fn pairs() {
    let n = 128;
    let grid = unit_grid(n, n);
    let surfaces = [
        ("A8", self_affine(grid, 0.8, 16.0, 8.0, 1)),
        ("B3", self_affine(grid, 0.3, 16.0, 2.0, 1)),
        ("C", measured_like(n, 1)),
    ];
    let most = [
        [[5.3, 42.0, 41.0, 6.3], [5.3, 94.0, 109.0, 7.4]],
        [[5.3, 43.0, 41.0, 6.3], [4.3, 182.0, 147.0, 7.4]],
        [[7.4, 50.0, 63.0, 8.4], [6.4, 142.0, 154.0, 7.4]],
    ];
    let with = |method| Solver::builder().method(method);
    let builders = [
        with(Method::Chord),
        with(Method::PolonskyKeer),
        with(Method::StanleyKato),
        with(Method::Auto).boundary(Boundary::Free),
    ];
    for ((name, map), most) in surfaces.iter().zip(most) {
        for (load, most) in [0.02, 0.2].into_iter().zip(most) {
            for (builder, most) in builders.iter().zip(most) {
                let found = solve(map, builder.clone().tolerance(1e-4), load).diagnostics;
                let spent = found.transforms;
                assert!(spent <= most, "{name}, {load}, {builder:?}: {spent:.2}, limit {most}");
            }
        }
    }
}

/// Where a thousandth and less touches, the first trial beats the constant pressure a thousandfold and is still wrong.
#[test]
fn a_light_load_from_nothing_takes_no_more_pairs() {
    let n = 256;
    let grid = unit_grid(n, n);
    let surfaces = [self_affine(grid, 0.8, 32.0, 8.0, 1), self_affine(grid, 0.3, 32.0, 2.0, 1)];
    for map in &surfaces {
        for load in [2e-4, 5e-4, 1e-3, 2e-3] {
            let found = solve(map, Solver::builder().tolerance(1e-4), load).diagnostics;
            assert!(found.transforms < 7.5, "{load}: {:.2} convolutions", found.transforms);
        }
    }
}

/// A single pixel leaves no residual at any load: only the gap says what is wrong with the iterate.
#[test]
fn a_gap_at_which_one_pixel_touches_takes_few_pairs() {
    let map = self_affine(unit_grid(128, 128), 0.8, 32.0, 8.0, 1);
    for load in [1e-10, 1e-9, 1e-7, 1e-6] {
        let one = solve(&map, Solver::builder(), load);
        let gap = Load::MeanGap(one.state.mean_gap.unwrap());
        let found = solver(map.grid(), Solver::builder()).solve(&map, gap).unwrap();
        let pixels = [&one, &found].map(|found| found.diagnostics.contact_pixels);
        assert_eq!(pixels, [1, 1], "{load}");
        assert!((found.state.mean_pressure / load - 1.0).abs() < 1e-4, "{load}");
        assert!(found.diagnostics.transforms < 25.0, "{load}: {}", found.diagnostics.transforms);
    }
}

/// Hurst exponent, load, and iterations and convolutions to three tolerances.
type ChordWork = (f64, f64, [(usize, f64); 3]);

/// Self-affine surfaces down to the pixel, H = 0.8 and 0.3, roll-off an eighth of the side, at
/// three loads: iterations, and convolutions rounded to hundredths, to an estimate of 1e-2, 1e-4, 1e-6.
#[test]
fn pairs_and_iterations_of_the_chord() {
    let expected: [ChordWork; 6] = [
        (0.8, 0.02, [(3, 3.19), (5, 5.28), (7, 7.38)]),
        (0.8, 0.10, [(3, 3.19), (5, 5.28), (6, 6.33)]),
        (0.8, 0.40, [(2, 2.14), (4, 4.23), (6, 6.33)]),
        (0.3, 0.02, [(3, 3.19), (5, 5.28), (6, 6.33)]),
        (0.3, 0.10, [(3, 3.19), (5, 5.28), (6, 6.33)]),
        (0.3, 0.40, [(2, 2.14), (4, 4.23), (6, 6.33)]),
    ];
    let grid = unit_grid(256, 256);
    let mut found = Vec::new();
    for (hurst, load, _) in expected {
        let surface = self_affine(grid, hurst, 32.0, 2.0, 1);
        let work = [1e-2, 1e-4, 1e-6].map(|tolerance| {
            let d = solve(&surface, to(tolerance).method(Method::Chord), load).diagnostics;
            (d.iterations, (100.0 * d.transforms).round() / 100.0)
        });
        found.push((hurst, load, work));
    }
    assert_eq!(found, expected, "iterations or convolutions changed");
}

/// 16 loads over two decades, all together, on a map that is stepped and does not repeat.
#[test]
fn iterations_along_a_curve() {
    let n = 256;
    let surface = measured_like(n, 1);
    let loads: Vec<f64> = (0..16).map(|k| 0.005 * 200_f64.powf(f64::from(k) / 15.0)).collect();
    let found = [1e-2, 1e-4, 1e-6].map(|tolerance| {
        let mut solver = solver(unit_grid(n, n), to(tolerance).method(Method::Chord));
        let points = curve(&mut solver, &surface, &loads);
        points.iter().map(|found| found.diagnostics.iterations).sum::<usize>()
    });
    assert_eq!(found, [49, 81, 113], "iterations changed");
}

/// Each load begins with the answer to the one before. Where the roughness has no roll-off, and where some of it
/// yields, that must not be worse than to begin anew.
#[test]
fn a_curve_takes_no_more_iterations_than_its_loads_one_by_one() {
    let n = 512;
    let (grid, loads) = (unit_grid(n, n), [0.05, 0.1, 0.2, 0.35, 0.6, 0.9, 1.3]);
    for (rolloff, hardness) in [(512.0, f64::INFINITY), (128.0, 1.5)] {
        let map = self_affine(grid, 1.0, rolloff, 16.0, 3);
        let builder = Solver::builder().hardness(hardness);
        let mut solver = solver(grid, builder.clone());
        let along = curve(&mut solver, &map, &loads);
        let anew = loads.map(|load| solve(&map, builder.clone(), load));
        let [along, anew] = [&along[..], &anew]
            .map(|found| found.iter().map(|s| s.diagnostics.iterations).sum::<usize>());
        assert!(along <= anew, "{along} and {anew}");
    }
}
