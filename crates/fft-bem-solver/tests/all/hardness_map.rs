//! Contact under a ceiling that varies from pixel to pixel: against its conditions, against a slow solution made
//! another way, and where it has to be that of one hardness.

#![allow(clippy::float_cmp, reason = "what is to be the same to the last bit")]

use crate::common;

use common::{displaced, self_affine, solve, unit_grid, unit_modulus, violation};
use contact_types::HeightMap;
use fft_bem_solver::{Boundary, Load, Precision, Solver, SolverError};

/// Hard islands in a soft ground: `[soft, hard]`, in squares a quarter of the map wide.
fn islands(map: &HeightMap, [soft, hard]: [f64; 2]) -> Vec<f64> {
    let [ny, nx] = map.grid().shape();
    let is_hard = |i: usize| (4 * (i / nx) / ny + 4 * (i % nx) / nx).is_multiple_of(2);
    (0..ny * nx).map(|i| if is_hard(i) { hard } else { soft }).collect()
}

/// A map of equal numbers is one number, to the last bit; in both precisions, with both boundaries.
#[test]
fn equal_numbers_are_one_hardness() {
    let map = self_affine(unit_grid(64, 60), 0.8, 16.0, 4.0, 1);
    let all = vec![0.3; 64 * 60];
    for boundary in [Boundary::Periodic, Boundary::Free] {
        for precision in [Precision::Double, Precision::Single] {
            let builder = Solver::builder().boundary(boundary).precision(precision);
            let one = solve(&map, builder.clone().hardness(0.3), 0.1);
            let each = solve(&map, builder.hardness_map(&all), 0.1);
            assert_eq!(one.pressure, each.pressure);
            assert_eq!(one.gap, each.gap);
            assert_eq!(one.diagnostics.yielded, each.diagnostics.yielded);
        }
    }
}

/// One pixel that bears more than the others, far below everything that touches, changes nothing but rounding:
/// the two ways through the solver have the same answer.
#[test]
fn a_pixel_out_of_contact_changes_nothing() {
    let map = self_affine(unit_grid(64, 60), 0.8, 16.0, 4.0, 1);
    let heights = map.heights();
    let lowest = (0..heights.len()).min_by(|a, b| heights[*a].total_cmp(&heights[*b])).unwrap();
    let mut hardness = vec![0.3; heights.len()];
    hardness[lowest] = 0.5;
    for boundary in [Boundary::Periodic, Boundary::Free] {
        let builder = Solver::builder().boundary(boundary).tolerance(1e-10).certified(true);
        let one = solve(&map, builder.clone().hardness(0.3), 0.05);
        let each = solve(&map, builder.hardness_map(&hardness), 0.05);
        let pairs = one.pressure.iter().zip(&each.pressure);
        pairs.for_each(|(x, y)| assert!((x - y).abs() < 1e-8, "{x} and {y}"));
        let [a, b] = [one, each].map(|s| s.diagnostics.yielded.unwrap());
        assert_eq!(a.area_fraction, b.area_fraction);
        assert!((a.load_share - b.load_share).abs() < 1e-8);
    }
}

/// Hard islands in a soft ground, from light loads to almost all that the two bear, some of them above what the
/// ground bears; odd sides; with copies all around and without; warm and cold.
#[test]
fn conditions_hold_on_islands() {
    for map in [
        self_affine(unit_grid(64, 64), 0.8, 16.0, 8.0, 1),
        self_affine(unit_grid(61, 75), 0.3, 16.0, 2.0, 2),
    ] {
        for boundary in [Boundary::Periodic, Boundary::Free] {
            for bears in [[0.25, 1.0], [0.05, 0.5], [0.01, 1e3]] {
                let hardness = islands(&map, bears);
                let most = hardness.iter().sum::<f64>() / hardness.len() as f64;
                let builder =
                    Solver::builder().boundary(boundary).tolerance(1e-9).hardness_map(&hardness);
                let mut warm = builder.build(map.grid(), unit_modulus()).unwrap();
                for load in [0.004, 0.02, 0.1, 0.2].into_iter().filter(|p| *p < 0.97 * most) {
                    let found = warm.solve(&map, Load::MeanPressure(load)).unwrap();
                    let wrong = violation(&map, &found, |i| hardness[i], load);
                    let d = &found.diagnostics;
                    assert!(wrong < 1e-7, "{boundary:?} {bears:?} P = {load}: {wrong:e}");
                    assert!(d.yielded.unwrap().load_share > 0.0 || bears[0] > 0.2);
                    assert!(d.transforms < 60.0, "{boundary:?} {bears:?} {load}: {}", d.transforms);
                    warm.forget();
                    let cold = warm.solve(&map, Load::MeanPressure(load)).unwrap();
                    let wrong = violation(&map, &cold, |i| hardness[i], load);
                    assert!(wrong < 1e-7, "cold {boundary:?} {bears:?} P = {load}: {wrong:e}");
                }
            }
        }
    }
}

/// Projected gradients with steps small enough to be sure of, on 12 x 10 points: slow, and made of nothing but
/// the matrix of the half space and a clipping.
#[test]
fn projected_gradients_have_the_same_pressure() {
    let map = self_affine(unit_grid(12, 10), 0.8, 5.0, 2.0, 3);
    let (hardness, load, n) = (islands(&map, [0.06, 0.4]), 0.04, 120);
    let column = |j: usize| {
        let mut unit = vec![0.0; n];
        unit[j] = 1.0;
        displaced(map.grid(), Boundary::Periodic, &unit)
    };
    let matrix: Vec<Vec<f64>> = (0..n).map(column).collect();
    let stiffest = matrix.iter().map(|row| row.iter().map(|x| x.abs()).sum::<f64>());
    let step = 1.0 / stiffest.fold(0.0, f64::max);
    let clipped = |field: &[f64]| -> Vec<f64> {
        let at =
            |shift: f64| field.iter().zip(&hardness).map(move |(p, h)| (p + shift).clamp(0.0, *h));
        let (mut low, mut high) = (-10.0, 10.0);
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if at(middle).sum::<f64>() > load * n as f64 { high = middle } else { low = middle }
        }
        at(low).collect()
    };
    let mut p = clipped(&vec![load; n]);
    for _ in 0..40_000 {
        let gap = |i: usize| (0..n).map(|j| matrix[j][i] * p[j]).sum::<f64>() - map.heights()[i];
        let moved: Vec<f64> = (0..n).map(|i| p[i] - step * gap(i)).collect();
        p = clipped(&moved);
    }
    let found = solve(&map, Solver::builder().tolerance(1e-11).hardness_map(&hardness), load);
    let soft = (0..n).filter(|i| p[*i] >= hardness[*i]).count();
    assert!(soft > 3 && p.iter().any(|p| *p <= 0.0), "{soft} pixels yield: the case shows nothing");
    for (i, (ours, theirs)) in found.pressure.iter().zip(&p).enumerate() {
        assert!((ours - theirs).abs() < 1e-9, "pixel {i}: {ours} and {theirs}");
    }
}

/// The gap and the approach of a load lead back to it; a contact that yields all over; a flat surface.
#[test]
fn ends_and_controls() {
    let map = self_affine(unit_grid(48, 40), 0.8, 12.0, 4.0, 2);
    let hardness = islands(&map, [0.1, 0.3]);
    let most = hardness.iter().sum::<f64>() / hardness.len() as f64;
    let builder = Solver::builder().tolerance(1e-9).hardness_map(&hardness);
    let of =
        |load: Load| builder.clone().build(map.grid(), unit_modulus()).unwrap().solve(&map, load);
    let found = of(Load::MeanPressure(0.08)).unwrap();
    for again in [Load::MeanGap(found.state.mean_gap.unwrap()), Load::Approach(found.approach)] {
        let back = of(again).unwrap().state.mean_pressure;
        assert!((back / 0.08 - 1.0).abs() < 1e-6, "{again:?}: {back}");
    }
    let all = of(Load::MeanPressure(most)).unwrap();
    assert_eq!(all.pressure, hardness);
    assert!((all.state.mean_gap.unwrap()).abs() < 1e-12);
    assert!(matches!(of(Load::MeanPressure(1.01 * most)), Err(SolverError::AboveHardness { .. })));
    assert!(of(Load::Approach(1e3)).is_err());

    let flat = HeightMap::new(map.grid(), vec![0.0; 48 * 40]).unwrap();
    let even = solve(&flat, builder.clone(), 0.09);
    assert!(even.pressure.iter().all(|p| (p - 0.09).abs() < 1e-12));
    let uneven = solve(&flat, builder, 0.15);
    assert!(uneven.pressure.iter().zip(&hardness).all(|(p, h)| p <= h));
    let carried = uneven.pressure.iter().sum::<f64>() / 1920.0;
    assert!((carried - 0.15).abs() < 1e-12, "{carried}");
}

/// What is no map of hardness.
#[test]
fn bad_maps_are_refused() {
    let grid = unit_grid(8, 8);
    let odd = |value: f64| [vec![1.0; 63], vec![value]].concat();
    let odd = [f64::INFINITY, -1.0, 0.0, f64::NAN].map(odd);
    for bad in [vec![], vec![1.0; 63], vec![f64::NAN; 64]].into_iter().chain(odd) {
        let built = Solver::builder().hardness_map(&bad).build(grid, unit_modulus());
        assert!(matches!(built, Err(SolverError::BadSetting { .. })), "{bad:?}");
    }
}
