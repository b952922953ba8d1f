//! Problems at the ends of what can be asked, and what must be refused.

use crate::cases;
use crate::common;

use common::{Uniform, self_affine, unit_grid, unit_modulus};
use contact_types::{ContactModulus, Grid, HeightMap};
use fft_bem_solver::{
    Boundary, End, Iteration, Load, Method, Precision, Solution, Solver, SolverError,
};
use std::ops::ControlFlow;

const METHODS: [Method; 3] = [Method::Auto, Method::PolonskyKeer, Method::StanleyKato];

fn modulus(pascals: f64) -> ContactModulus {
    ContactModulus::from_pascals(pascals).unwrap()
}

fn solve(
    map: &HeightMap,
    e_star: f64,
    method: Method,
    load: Load,
) -> Result<Solution, SolverError> {
    Solver::builder()
        .method(method)
        .tolerance(1e-6)
        .build(map.grid(), modulus(e_star))?
        .solve(map, load)
}

/// The conditions of contact, by the numbers the solution states about itself.
fn check(found: &Solution, load: f64) {
    let n = found.pressure.len() as f64;
    assert!((found.pressure.iter().sum::<f64>() / n / load - 1.0).abs() < 1e-12);
    assert!(found.pressure.iter().all(|p| *p >= 0.0 && p.is_finite()));
    assert!(found.gap.iter().all(|g| g.is_finite()));
    let r = found.diagnostics.residuals;
    assert!(r.preconditioned <= 1e-6 || found.diagnostics.exact.is_some(), "{r:?}");
    assert!(r.complementarity < 1e-4 && r.penetration < 1e-4, "{r:?}");
}

/// Every line of the table in the book, each with its limits.
#[test]
fn known_solutions_at_the_extremes() {
    let cases = cases::cases();
    assert!(cases.len() >= 24, "only {} lines", cases.len());
    for case in cases {
        let (found, limits) = (case.errors, case.limits);
        let holds = found.iter().zip(limits).all(|(error, limit)| *error <= limit);
        let place = format!("{}, {}, against {}", case.what, case.extreme, case.compared_with);
        assert!(holds, "{place}: {found:?}, limits {limits:?}");
    }
}

/// Slopes from 1e-12 to 1e3, moduli from 1 Pa to 1 TPa, pixels from nm to m: the same contact.
#[test]
fn slopes_and_moduli() {
    let unit = self_affine(unit_grid(32, 32), 0.8, 16.0, 4.0, 1);
    for method in METHODS {
        let known = solve(&unit, 1.0, method, Load::MeanPressure(0.1)).unwrap();
        for slope in [1e-12, 1e-6, 1.0, 1e3] {
            for e_star in [1.0, 1e9, 1e12] {
                for d in [1e-9, 1.0] {
                    let grid = Grid::new([32, 32], [d, d]).unwrap();
                    let heights = unit.heights().iter().map(|h| h * slope * d).collect();
                    let map = HeightMap::new(grid, heights).unwrap();
                    let load = 0.1 * e_star * slope;
                    let found = solve(&map, e_star, method, Load::MeanPressure(load)).unwrap();
                    check(&found, load);
                    let (a, b) =
                        (found.diagnostics.contact_pixels, known.diagnostics.contact_pixels);
                    assert!(a.abs_diff(b) <= 1, "{method} {slope} {e_star} {d}: {a} {b}");
                }
            }
        }
    }
}

/// Heights of nanometres on an offset of 1e6 m would have no digits left; on 76 mm (a stage
/// coordinate left in a file) they lose some, and the answer is that of the heights as they are.
#[test]
fn offsets() {
    let grid = Grid::new([24, 24], [1e-6, 1e-6]).unwrap();
    let relief = self_affine(unit_grid(24, 24), 0.8, 12.0, 4.0, 2);
    for (scale, offset) in [(1e-9, 0.076), (1.0, 1e6), (1e-6, -3.0)] {
        let heights: Vec<f64> = relief.heights().iter().map(|h| h * scale + offset).collect();
        // What is left of the relief in f64, moved back exactly.
        let moved = heights.iter().map(|h| h - offset).collect();
        let load = 0.1 * 1e9 * scale / 1e-6;
        let high = HeightMap::new(grid, heights).unwrap();
        let low = HeightMap::new(grid, moved).unwrap();
        for method in METHODS {
            let a = solve(&high, 1e9, method, Load::MeanPressure(load)).unwrap();
            let b = solve(&low, 1e9, method, Load::MeanPressure(load)).unwrap();
            check(&a, load);
            assert_eq!(a.pressure, b.pressure, "{method} {offset}");
            assert_eq!(a.gap, b.gap);
        }
    }
    // All digits lost: a flat surface, and answered as one.
    let lost = relief.heights().iter().map(|h| h * 1e-12 + 1e6).collect();
    let map = HeightMap::new(grid, lost).unwrap();
    let found = solve(&map, 1e9, Method::Auto, Load::MeanPressure(5.0)).unwrap();
    assert_eq!(found.diagnostics.exact, Some("flat surface"));
}

/// From one pixel in contact to a hundred times the load that closes every gap.
#[test]
fn from_one_pixel_to_beyond_full_contact() {
    let map = self_affine(unit_grid(40, 36), 0.8, 18.0, 4.0, 3);
    for method in METHODS {
        for precision in [Precision::Double, Precision::Single] {
            let mut solver = Solver::builder()
                .method(method)
                .precision(precision)
                .tolerance(1e-4)
                .build(map.grid(), unit_modulus())
                .unwrap();
            let first = solver.solve(&map, Load::MeanPressure(1e-9)).unwrap();
            assert_eq!(first.diagnostics.exact, Some("single pixel in contact"));
            assert_eq!(first.diagnostics.contact_pixels, 1);
            assert!(first.diagnostics.transforms <= 1.0);
            let closed = solver.solve(&map, Load::MeanGap(0.0)).unwrap();
            let least = closed.state.mean_pressure;
            let mut last = 0.0;
            for ratio in [1e-6, 1e-4, 1e-2, 0.3, 0.9, 0.999, 1.001, 2.0, 100.0] {
                let found = solver.solve(&map, Load::MeanPressure(ratio * least)).unwrap();
                let area = found.touching_fraction();
                assert!(area >= last, "{method} {ratio}");
                last = area;
                let sum: f64 = found.pressure.iter().sum();
                assert!((sum / 1440.0 / ratio / least - 1.0).abs() < 1e-6);
                let is_simple = ratio > 1.0 || found.diagnostics.contact_pixels == 1;
                assert_eq!(found.diagnostics.exact.is_some(), is_simple, "{method} {ratio}");
                if ratio > 1.0 {
                    assert!(area >= 1.0 && found.diagnostics.transforms <= 2.0);
                    assert!(found.gap.iter().all(|g| g.abs() < 1e-5));
                }
            }
        }
    }
}

#[test]
fn spikes_plateaus_steps_and_noise() {
    let mut random = Uniform(9);
    let rough = self_affine(unit_grid(31, 37), 0.8, 16.0, 4.0, 4);
    let h = rough.heights();
    let surfaces: Vec<(&str, Vec<f64>)> = vec![
        ("spike", (0..h.len()).map(|i| if i == 500 { 100.0 } else { h[i] }).collect()),
        ("plateau", h.iter().map(|h| h.min(0.2)).collect()),
        ("pit", (0..h.len()).map(|i| if i == 500 { -1e6 } else { h[i] }).collect()),
        ("steps", h.iter().map(|h| (h / 0.5).round() * 0.5).collect()),
        ("two levels", h.iter().map(|h| f64::from(u8::from(*h > 0.0))).collect()),
        ("noise", h.iter().map(|_| random.normal()).collect()),
        ("chequerboard", (0..h.len()).map(|i| ((i / 37 + i % 37) % 2) as f64).collect()),
    ];
    for (name, heights) in surfaces {
        let map = HeightMap::new(rough.grid(), heights).unwrap();
        for load in [1e-6, 1e-3, 0.05, 0.5, 20.0] {
            let mut areas = Vec::new();
            for method in METHODS {
                let found = solve(&map, 1.0, method, Load::MeanPressure(load))
                    .unwrap_or_else(|e| panic!("{name} {load} {method}: {e}"));
                check(&found, load);
                areas.push(found.touching_fraction());
            }
            // At the tolerance a few pixels of the contact line are undecided.
            let spread = areas.iter().fold(0.0_f64, |m, a| m.max((a - areas[0]).abs()));
            assert!(spread * 1147.0 <= 3.0, "{name} {load}: {areas:?}");
        }
    }
}

/// Long pixels, profiles, prime sides, tiny maps; periodic and free.
#[test]
fn odd_grids() {
    let cases = [
        ([16, 16], [1e-9, 1e-6]),
        ([16, 16], [1e-3, 1e-6]),
        ([1, 101], [1.0, 1.0]),
        ([97, 1], [1.0, 1.0]),
        ([61, 53], [1.0, 1.0]),
        ([3, 200], [1.0, 0.1]),
        ([2, 2], [1.0, 1.0]),
        ([1, 2], [1.0, 1.0]),
    ];
    for (shape, pixel) in cases {
        let grid = Grid::new(shape, pixel).unwrap();
        let mut random = Uniform(17);
        let heights = (0..grid.len()).map(|_| 1e-7 * random.normal()).collect();
        let map = HeightMap::new(grid, heights).unwrap();
        let fine = pixel[0].min(pixel[1]);
        for boundary in [Boundary::Periodic, Boundary::Free] {
            for ratio in [1e-3, 0.1, 1.0] {
                let load = ratio * 1e9 * 1e-7 / fine;
                // Steepest descent takes as many steps as the stiffest wave is stiffer than the
                // softest: it does not end within its limit on pixels of 1:1000.
                let is_long = pixel[0].max(pixel[1]) > 100.0 * fine;
                for method in &METHODS[..if is_long { 2 } else { 3 }] {
                    let found = Solver::builder()
                        .method(*method)
                        .boundary(boundary)
                        .tolerance(1e-6)
                        .build(grid, modulus(1e9))
                        .unwrap()
                        .solve(&map, Load::MeanPressure(load))
                        .unwrap_or_else(|e| {
                            panic!("{shape:?} {pixel:?} {boundary:?} {ratio} {method}: {e}")
                        });
                    check(&found, load);
                }
            }
        }
    }
}

/// One pixel: nothing to iterate.
#[test]
fn a_single_pixel_map() {
    let grid = Grid::new([1, 1], [1e-6, 2e-6]).unwrap();
    let map = HeightMap::new(grid, vec![3e-9]).unwrap();
    let found = solve(&map, 1e9, Method::Auto, Load::MeanPressure(7.0)).unwrap();
    assert!(found.pressure == [7.0] && found.gap == [0.0]);
    let mut free = Solver::builder().boundary(Boundary::Free).build(grid, modulus(1e9)).unwrap();
    let found = free.solve(&map, Load::MeanPressure(7.0)).unwrap();
    let dent = fft_bem_solver::love([0.0, 0.0], grid.pixel()) * 7.0 / 1e9;
    assert!((found.approach / dent - 1.0).abs() < 1e-12);
}

#[test]
fn no_load_and_flat_surfaces_are_answered_at_once() {
    let rough = self_affine(unit_grid(16, 16), 0.8, 8.0, 4.0, 5);
    let depth = rough.range().1 - rough.mean();
    for method in METHODS {
        let idle = solve(&rough, 1.0, method, Load::MeanPressure(0.0)).unwrap();
        assert_eq!(idle.diagnostics.exact, Some("no load"));
        assert!(idle.touching_fraction().abs() < 1e-300 && idle.diagnostics.transforms < 1e-300);
        assert!((idle.state.mean_gap.unwrap() / depth - 1.0).abs() < 1e-12);
        // A mean gap wider than at first touch: apart by the difference.
        let apart = solve(&rough, 1.0, method, Load::MeanGap(2.0 * depth)).unwrap();
        assert_eq!(apart.diagnostics.contact_pixels, 0);
        assert!((apart.state.mean_gap.unwrap() / depth - 2.0).abs() < 1e-12);
        assert!(apart.gap.iter().all(|g| *g >= 0.99 * depth));

        let flat = HeightMap::new(unit_grid(8, 9), vec![-3.5; 72]).unwrap();
        let pressed = solve(&flat, 1e9, method, Load::MeanPressure(2.0)).unwrap();
        assert_eq!(pressed.diagnostics.exact, Some("flat surface"));
        assert!(pressed.pressure.iter().all(|p| (p - 2.0).abs() < 1e-15));
        assert!(pressed.gap.iter().all(|g| g.abs() < 1e-300));
        assert!(pressed.touching_fraction() >= 1.0);
    }
}

#[test]
fn bad_loads_are_refused_by_name() {
    let rough = self_affine(unit_grid(16, 16), 0.8, 8.0, 4.0, 5);
    for value in [-1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for load in [Load::MeanPressure(value), Load::MeanGap(value), Load::Approach(value)] {
            let error = solve(&rough, 1.0, Method::Auto, load).unwrap_err();
            assert!(matches!(error, SolverError::BadLoad { .. }), "{error}");
            assert!(error.to_string().contains("negative"), "{error}");
        }
    }
    let deep = solve(&rough, 1.0, Method::Auto, Load::Approach(1e6)).unwrap_err();
    assert!(matches!(deep, SolverError::BadLoad { quantity: "approach", .. }), "{deep}");
    let mut free =
        Solver::builder().boundary(Boundary::Free).build(rough.grid(), unit_modulus()).unwrap();
    let error = free.solve(&rough, Load::MeanGap(1.0)).unwrap_err();
    assert!(matches!(error, SolverError::Combination { .. }), "{error}");
    // The solver is still usable.
    assert!(free.solve(&rough, Load::MeanPressure(0.1)).is_ok());
}

#[test]
fn bad_settings_and_wrong_grids_are_refused_by_name() {
    let grid = unit_grid(8, 8);
    let build = |b: fft_bem_solver::SolverBuilder| b.build(grid, unit_modulus()).map(|_| ());
    for tolerance in [0.0, -1.0, 1.0, f64::NAN, f64::INFINITY] {
        let error = build(Solver::builder().tolerance(tolerance)).unwrap_err();
        assert!(matches!(error, SolverError::BadSetting { setting: "tolerance", .. }));
    }
    for error in [
        build(Solver::builder().max_iterations(0)).unwrap_err(),
        build(Solver::builder().threads(0)).unwrap_err(),
    ] {
        assert!(matches!(error, SolverError::BadSetting { .. }));
    }
    let mut solver = Solver::builder().build(grid, unit_modulus()).unwrap();
    let other = HeightMap::new(unit_grid(8, 9), vec![0.0; 72]).unwrap();
    let error = solver.solve(&other, Load::MeanPressure(1.0)).unwrap_err();
    assert!(matches!(error, SolverError::Shape { expected: 64, found: 72 }));
    let stretched = Grid::new([8, 8], [1.0, 2.0]).unwrap();
    let other = HeightMap::new(stretched, vec![0.0; 64]).unwrap();
    let error = solver.solve(&other, Load::MeanPressure(1.0)).unwrap_err();
    assert!(matches!(error, SolverError::Grid { .. }));
}

/// Running out of iterations and being stopped both hand over what was reached.
#[test]
fn nothing_is_lost_when_a_run_ends_early() {
    let map = self_affine(unit_grid(64, 64), 0.8, 16.0, 2.0, 6);
    for method in METHODS {
        let build = |limit: usize| {
            Solver::builder()
                .method(method)
                .tolerance(1e-12)
                .max_iterations(limit)
                .build(map.grid(), unit_modulus())
                .unwrap()
        };
        let error = build(3).solve(&map, Load::MeanPressure(0.05)).unwrap_err();
        assert!(matches!(error, SolverError::NotConverged(_)));
        let reached = error.solution().unwrap();
        assert_eq!(reached.diagnostics.iterations, 3);
        assert!(reached.diagnostics.residuals.preconditioned.is_finite());
        let sum: f64 = reached.pressure.iter().sum();
        assert!((sum / 4096.0 / 0.05 - 1.0).abs() < 1e-12);

        let mut seen = Vec::new();
        let mut observer = |iteration: &Iteration<'_>| {
            let [pressure, gap] = iteration.pressure_and_gap();
            assert!(pressure.len() == 4096 && gap.len() == 4096);
            assert!(iteration.touching_fraction() > 0.0 && iteration.tolerance > 0.0);
            seen.push((iteration.number, iteration.transforms));
            if iteration.number >= 2 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let error =
            build(100).solve_observed(&map, Load::MeanPressure(0.05), &mut observer).unwrap_err();
        assert!(matches!(error, SolverError::Stopped(_)));
        assert_eq!(error.solution().unwrap().diagnostics.iterations, 2);
        assert!(seen.windows(2).all(|w| w[0].0 <= w[1].0 && w[0].1 <= w[1].1));
    }
}

/// A tolerance that rounding does not let a method reach ends where rounding does, and says where.
#[test]
fn tolerances_below_rounding_end() {
    let map = self_affine(unit_grid(48, 48), 0.8, 12.0, 4.0, 7);
    for boundary in [Boundary::Periodic, Boundary::Free] {
        for (precision, limit) in [(Precision::Double, 1e-11), (Precision::Single, 3e-5)] {
            for method in [Method::Auto, Method::PolonskyKeer] {
                let mut solver = Solver::builder()
                    .method(method)
                    .boundary(boundary)
                    .precision(precision)
                    .tolerance(1e-18)
                    .build(map.grid(), unit_modulus())
                    .unwrap();
                let error = solver.solve(&map, Load::MeanPressure(0.3)).unwrap_err();
                assert!(matches!(error, SolverError::Rounding(_)), "{error}");
                let found = error.into_solution().unwrap().diagnostics;
                assert_eq!(found.end, End::Rounding);
                let residual = found.residuals.preconditioned;
                assert!(residual <= limit, "{boundary:?} {precision:?} {method}: {residual:e}");
                assert!(found.iterations < 2000);
            }
        }
    }
}

/// Near full contact a loose tolerance leaves more overlap than gap, and in it rounding may: on average
/// bodies do not overlap. Each of these loads had a negative gap before that was said.
#[test]
fn bodies_do_not_overlap_on_average() {
    for (seed, load) in [(1, 1.5), (1, 1.6), (2, 1.3), (3, 1.6), (3, 3.0)] {
        let map = self_affine(unit_grid(64, 64), 0.8, 32.0, 4.0, seed);
        let mut solver = Solver::builder().tolerance(1e-2).build(map.grid(), modulus(1.0)).unwrap();
        let found = solver.solve(&map, Load::MeanPressure(load)).unwrap();
        assert!(found.state.mean_gap.unwrap() >= 0.0, "{seed}, {load}: {:?}", found.state);
        assert!(found.touching_fraction() > 0.99, "{seed}, {load}: {:?}", found.state);
    }
}
