//! Contact under a pressure ceiling: against another program, against its conditions, and where it has to be
//! the elastic one.

#![allow(clippy::float_cmp, reason = "what is to be the same to the last bit")]

use crate::common;
use crate::npy;

use common::{
    curve, difference, displaced, energy_norm, measured_like, self_affine, solver, unit_grid,
    unit_modulus,
};
use contact_types::{Grid, HeightMap};
use fft_bem_solver::{Boundary, Load, Method, Precision, Solution, Solver, SolverError};

fn solve(map: &HeightMap, hardness: f64, load: f64, tolerance: f64) -> Solution {
    common::solve(map, Solver::builder().tolerance(tolerance).hardness(hardness), load)
}

/// `KatoSaturated` of Tamaas 2.9 has the same pixels in contact and at the ceiling, and the same pressure.
#[test]
fn another_program_has_the_same_contact() {
    let map = npy::unit_cell("rough128.npy");
    for (load, hardness) in [(0.004, 0.1), (0.02, 0.05)] {
        let file = format!("tamaas_P{load}_H{hardness}.npy");
        let theirs = npy::numbers(&file);
        let ours = solve(&map, hardness, load, 1e-9);
        for (i, (a, b)) in ours.pressure.iter().zip(&theirs).enumerate() {
            assert_eq!(*a > 0.0, *b > 0.0, "pixel {i} of {file}");
            assert_eq!(*a >= hardness, *b >= hardness * (1.0 - 1e-12), "pixel {i} of {file}");
        }
        let apart = difference(&ours.pressure, &theirs);
        assert!(apart < 1e-7, "{file}: {apart:e}");
    }
}

/// The conditions of contact over surfaces, loads and hardnesses; and what it costs beside the elastic answer.
#[test]
fn conditions_hold_at_the_cost_of_the_elastic_answer() {
    let grid = unit_grid(128, 128);
    for map in [
        self_affine(grid, 0.8, 16.0, 8.0, 1),
        self_affine(grid, 0.3, 16.0, 2.0, 2),
        self_affine(unit_grid(97, 131), 0.8, 16.0, 2.0, 3),
        measured_like(128, 1),
    ] {
        for load in [0.005, 0.1, 0.4] {
            let elastic = solve(&map, f64::INFINITY, load, 1e-6).diagnostics.transforms;
            for hardness in [2.0, 1.0, 0.5, 0.25].into_iter().filter(|h| *h > load) {
                let found = solve(&map, hardness, load, 1e-9);
                let wrong = violation(&map, &found, hardness, load);
                assert!(wrong < 1e-8, "P = {load}, H = {hardness}: {wrong:e}");
                let pairs = solve(&map, hardness, load, 1e-6).diagnostics.transforms;
                assert!(pairs < 1.6 * elastic, "P = {load}, H = {hardness}: {pairs}, {elastic}");
            }
        }
    }
}

/// Single spots, flat punches, arrays of them, profiles, spikes; from almost nothing to almost all of the
/// surface at the ceiling; with copies all around and without.
#[test]
fn conditions_hold_for_spots_punches_and_arrays() {
    let made = |ny: usize, nx: usize, f: &dyn Fn(f64, f64) -> f64| {
        let place = |i: usize, n: usize| i as f64 / n as f64 - 0.5;
        let height = |i: usize| f(place(i / nx, ny), place(i % nx, nx));
        HeightMap::new(unit_grid(ny, nx), (0..ny * nx).map(height).collect()).unwrap()
    };
    let turn = std::f64::consts::TAU;
    let spot =
        |y: f64, x: f64| ((4.0 * x).rem_euclid(1.0) - 0.5).hypot((4.0 * y).rem_euclid(1.0) - 0.5);
    let maps = [
        ("sphere", made(61, 75, &|y, x| -6.0 * (x * x + y * y))),
        ("punch", made(64, 64, &|y, x| if x.hypot(y) < 0.2 { 0.0 } else { -20.0 })),
        ("plateau", made(64, 64, &|y, x| if x.hypot(y) < 0.2 { 0.0 } else { -0.05 })),
        ("array", made(64, 64, &|y, x| if spot(y, x) < 0.3 { 0.0 } else { -3.0 })),
        ("sines", made(64, 64, &|y, x| (4.0 * turn * x).cos() * (4.0 * turn * y).cos())),
        ("profile", made(1, 256, &|_, x| 8.0 * (turn * x).cos())),
        (
            "spike",
            made(64, 64, &|y, x| if x.hypot(y) < 0.01 { 10.0 } else { 0.1 * (turn * x).cos() }),
        ),
        ("few", made(3, 4, &|y, x| (7.0 * x + 3.0 * y).sin())),
    ];
    for (name, map) in &maps {
        for boundary in [Boundary::Periodic, Boundary::Free] {
            if boundary == Boundary::Free && map.grid().shape()[0] == 1 {
                continue;
            }
            for hardness in [0.7, 0.03, 1e-4] {
                for part in [1e-4, 0.1, 0.5, 0.99, 1.0 - 1e-9] {
                    let builder = Solver::builder().tolerance(1e-9).hardness(hardness);
                    let load = part * hardness;
                    let found = common::solve(map, builder.boundary(boundary), load);
                    let wrong = violation(map, &found, hardness, load);
                    assert!(wrong < 1e-7, "{name} {boundary:?} {hardness} {part}: {wrong:e}");
                }
            }
        }
    }
}

#[test]
fn without_yielding_the_answer_is_elastic() {
    let map = self_affine(unit_grid(96, 128), 0.8, 16.0, 4.0, 5);
    let elastic = solve(&map, f64::INFINITY, 0.03, 1e-9);
    assert!(elastic.diagnostics.yielded.is_none());
    let hard = solve(&map, 1.01 * elastic.diagnostics.max_pressure, 0.03, 1e-9);
    let yielded = hard.diagnostics.yielded.unwrap();
    assert!(yielded.area_fraction <= 0.0);
    for (a, b) in elastic.pressure.iter().zip(&hard.pressure) {
        assert!((a - b).abs() < 1e-8 * elastic.diagnostics.max_pressure);
    }
}

/// Under the load that is all it can bear, the surface yields everywhere; above, there is no contact.
#[test]
fn the_load_is_at_most_the_hardness() {
    let map = self_affine(unit_grid(48, 64), 0.8, 16.0, 4.0, 5);
    for boundary in [Boundary::Periodic, Boundary::Free] {
        let mut solver = solver(map.grid(), Solver::builder().hardness(0.3).boundary(boundary));
        let all = solver.solve(&map, Load::MeanPressure(0.3)).unwrap();
        assert!(all.pressure.iter().all(|p| *p == 0.3));
        assert!(all.gap.iter().all(|g| *g <= 1e-12) && all.state.mean_gap.unwrap() <= 0.0);
        let yielded = all.diagnostics.yielded.unwrap();
        assert!((yielded.load_share - 1.0).abs() < 1e-12);
        let refused = solver.solve(&map, Load::MeanPressure(0.301)).unwrap_err();
        assert!(matches!(refused, SolverError::AboveHardness { .. }), "{refused}");
        let said = refused.to_string();
        assert!(said.contains("3.01000e-1") && said.contains("3.00000e-1"), "{said}");
        // And the next load is solved as if nothing had been.
        let after = solver.solve(&map, Load::MeanPressure(0.1)).unwrap();
        assert!(after.touching_fraction() > 1.0 / 3.0);
    }
    let of = |hardness| Solver::builder().hardness(hardness);
    let methods = [Method::PolonskyKeer, Method::StanleyKato].map(|m| of(1.0).method(m));
    for builder in [0.0, -1.0, f64::NAN].map(of).into_iter().chain(methods) {
        assert!(builder.clone().build(map.grid(), unit_modulus()).is_err(), "{builder:?}");
    }
}

#[test]
fn a_gap_finds_its_load() {
    let map = self_affine(unit_grid(64, 64), 0.8, 16.0, 4.0, 3);
    for hardness in [1.0, 0.2] {
        for part in [0.003, 0.2, 0.9] {
            let builder = Solver::builder().tolerance(1e-6).hardness(hardness);
            let load = part * hardness;
            let gap = common::solve(&map, builder.clone(), load).state.mean_gap.unwrap();
            let found = solver(map.grid(), builder).solve(&map, Load::MeanGap(gap)).unwrap();
            let off = (found.state.mean_pressure / load - 1.0).abs();
            assert!(off < 1e-5, "{gap} at H = {hardness}: {off:e}");
        }
    }
}

/// Warm and cold, up and down, in both precisions, elastic and yielding: one answer, and elastic for fewer convolutions.
#[test]
fn curves_have_the_answers_of_cold_starts() {
    let map = self_affine(unit_grid(96, 108), 0.8, 24.0, 2.0, 7);
    for (boundary, hardness) in [
        (Boundary::Periodic, f64::INFINITY),
        (Boundary::Periodic, 0.4),
        (Boundary::Free, f64::INFINITY),
        (Boundary::Free, 0.4),
    ] {
        let to = |tolerance| {
            Solver::builder().hardness(hardness).boundary(boundary).tolerance(tolerance)
        };
        let closes = hardness.is_infinite() && boundary == Boundary::Periodic;
        let most: f64 = if closes { 1000.0 } else { 40.0 };
        let up: Vec<f64> = (0..8).map(|k| 0.005 * most.powf(f64::from(k) / 7.0)).collect();
        let loads: Vec<f64> = up.iter().chain(up.iter().rev()).copied().collect();
        let cold: Vec<Solution> = up.iter().map(|p| common::solve(&map, to(1e-8), *p)).collect();
        let warm = curve(&mut solver(map.grid(), to(1e-8)), &map, &loads);
        let single = to(1e-4).precision(Precision::Single);
        let rough = curve(&mut solver(map.grid(), single), &map, &loads);
        let mut pairs = [0.0; 2];
        for (k, (warm, rough)) in warm.iter().zip(&rough).enumerate() {
            let (load, cold) = (loads[k], &cold[k.min(loads.len() - 1 - k)]);
            let error = |found: &Solution| difference(&found.pressure, &cold.pressure);
            assert!(error(warm) < 3e-8, "{load} {boundary:?}: {:e}", error(warm));
            assert!(error(rough) < 2e-4, "{load} {boundary:?}: {:e}", error(rough));
            assert!(rough.pressure.iter().all(|p| *p <= hardness));
            pairs =
                [pairs[0] + warm.diagnostics.transforms, pairs[1] + cold.diagnostics.transforms];
        }
        assert!(hardness.is_finite() || pairs[0] < pairs[1], "{pairs:?}");
    }
}

/// The bound is one: the energy norm of the difference to a much better answer is below it, and not far.
#[test]
fn the_bound_of_the_error_holds() {
    let map = self_affine(unit_grid(96, 96), 0.8, 16.0, 4.0, 9);
    for hardness in [0.7, 0.3] {
        for tolerance in [1e-2, 1e-4] {
            let exact = solve(&map, hardness, 0.05, 1e-11);
            let builder = Solver::builder().tolerance(tolerance).hardness(hardness).certified(true);
            let found = common::solve(&map, builder, 0.05);
            let energy = |p: &[f64]| energy_norm(map.grid(), Boundary::Periodic, p);
            let off: Vec<f64> =
                found.pressure.iter().zip(&exact.pressure).map(|(a, b)| a - b).collect();
            let error = energy(&off) / energy(&exact.pressure);
            let bound = found.diagnostics.energy_bound.unwrap();
            assert!(error <= bound && bound < 30.0 * error, "{error:e} and {bound:e}");
        }
    }
}

/// Units change nothing, and the ceiling is met to the last digit in any.
#[test]
fn the_ceiling_is_met_in_any_unit() {
    let map = self_affine(unit_grid(64, 64), 0.8, 16.0, 4.0, 3);
    let scaled = map.heights().iter().map(|h| 1.7e-8 * h).collect();
    let grid = Grid::new([64, 64], [1.3e-7, 1.3e-7]).unwrap();
    let small = HeightMap::new(grid, scaled).unwrap();
    let unit = 1.7e-8 / 1.3e-7 * 137e9;
    let modulus = contact_types::ContactModulus::from_pascals(137e9).unwrap();
    let [hardness, load] = [0.3, 0.1].map(|x| x * unit);
    let builder = Solver::builder().tolerance(1e-8).hardness(hardness);
    let found =
        builder.build(grid, modulus).unwrap().solve(&small, Load::MeanPressure(load)).unwrap();
    let reference = solve(&map, 0.3, 0.1, 1e-8).diagnostics.yielded.unwrap();
    let yielded = found.diagnostics.yielded.unwrap();
    assert_eq!(yielded.area_fraction, reference.area_fraction);
    let full = found.pressure.iter().filter(|p| **p >= hardness).count();
    assert_eq!(full as f64 / 4096.0, yielded.area_fraction);
    assert!(full > 100);
}

/// How far the conditions of contact under a ceiling are violated, in rms heights; that the pressure is within
/// its bounds and carries the load, and that no smaller area would.
fn violation(map: &HeightMap, found: &Solution, hardness: f64, load: f64) -> f64 {
    let (p, h, n) = (&found.pressure, map.heights(), map.heights().len() as f64);
    let all = || 0..p.len();
    assert!(p.iter().all(|p| (0.0..=hardness).contains(p)), "a pressure beyond its bounds");
    let carried = p.iter().sum::<f64>() / n;
    assert!((carried / load - 1.0).abs() < 1e-9, "{carried} in place of {load}");
    let area = found.touching_fraction();
    assert!(area >= load / hardness * (1.0 - 1e-12), "{area} is less than {load} / {hardness}");
    let u = displaced(map.grid(), found.diagnostics.boundary, p);
    // The level is not part of the question: whichever suits the nodes between the bounds or, without any,
    // those at the ceiling.
    let between: Vec<usize> = all().filter(|i| p[*i] > 0.0 && p[*i] < hardness).collect();
    let full = all().filter(|i| p[*i] >= hardness);
    let level = match between.len() {
        0 => full.map(|i| u[i] - h[i]).fold(f64::NEG_INFINITY, f64::max),
        count => between.iter().map(|i| u[*i] - h[*i]).sum::<f64>() / count as f64,
    };
    let wrong = |i: usize| {
        let gap = u[i] - h[i] - level;
        match p[i] {
            p if p <= 0.0 => gap.min(0.0),
            p if p >= hardness => gap.max(0.0),
            _ => gap,
        }
    };
    let mean = h.iter().sum::<f64>() / n;
    let rms = (h.iter().map(|h| (h - mean).powi(2)).sum::<f64>() / n).sqrt();
    (all().map(|i| wrong(i).powi(2)).sum::<f64>() / n).sqrt() / rms
}
