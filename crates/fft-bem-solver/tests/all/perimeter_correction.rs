//! The perimeter correction follows from straight edges, and the count exceeds the area by as much.

use crate::common::solver;
use contact_types::{Grid, HeightMap};
use fft_bem_solver::{Load, PERIMETER_CORRECTION, Solver};
use std::f64::consts::{PI, TAU};

/// Excess per length of an edge with the normal (m, n), in pixels: the formula of the module, by Gauss's
/// rule of three points between the kinks of the symbol.
fn excess(m: i32, n: i32) -> f64 {
    let (m, n) = (f64::from(m), f64::from(n));
    let wrapped = |t: f64| t - TAU * (t / TAU).round();
    let integrand = |t: f64| {
        let (x, y) = (wrapped(t * m), wrapped(t * n));
        let cot = 1.0 / (0.5 * t).tan();
        cot * (0.5 * cot - (m * x + n * y) / (x * x + y * y))
    };
    let mut kinks: Vec<f64> = [m, n]
        .iter()
        .flat_map(|k| (1..=*k as u32).map(move |j| PI * f64::from(j) / k))
        .chain([0.0, PI])
        .collect();
    kinks.sort_by(f64::total_cmp);
    let panel = |a: f64, b: f64| {
        let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
        let off = half * 0.6f64.sqrt();
        let ends = integrand(middle - off) + integrand(middle + off);
        half * (5.0 * ends + 8.0 * integrand(middle)) / 9.0
    };
    let between = |ends: &[f64]| {
        let width = (ends[1] - ends[0]) / 8.0;
        (0..8).map(|i| f64::from(i) * width + ends[0]).map(|a| panel(a, a + width)).sum::<f64>()
    };
    let wide = |ends: &&[f64]| ends[1] - ends[0] > 1e-12;
    let integral: f64 = kinks.windows(2).filter(wide).map(between).sum();
    (0.25 + integral / TAU) / m.hypot(n)
}

#[test]
fn the_constant_is_the_mean_over_the_directions_of_straight_edges() {
    assert!((excess(1, 0) - 0.19001).abs() < 1e-4, "{}", excess(1, 0));
    assert!((excess(1, 1) - 0.13436).abs() < 1e-4, "{}", excess(1, 1));
    // Directions that are far from all with small numbers: a prime and whole numbers below it.
    let prime = 101;
    let (mut sum, mut edges) = (0.0, 0.0);
    for n in 1..prime {
        let angle = f64::from(n).atan2(f64::from(prime));
        // Equal steps in n are not equal steps in direction.
        let weight = angle.cos().powi(2);
        sum += weight * excess(prime, n);
        edges += weight * (angle.cos() + angle.sin());
    }
    assert!((sum / edges - PERIMETER_CORRECTION).abs() < 5e-4, "{}", sum / edges);
}

/// Strips: 0.19 points an edge, in the mean over the places of the grid.
#[test]
fn edges_along_rows_exceed_by_as_much_as_the_formula_says() {
    let (n, loads) = (96, 160);
    let grid = Grid::new([4, n], [1.0, 1.0]).unwrap();
    let wave = |x: f64| (TAU * x / n as f64).cos();
    let map = HeightMap::from_fn(grid, |_, x| wave(x)).unwrap();
    let mut solver = solver(grid, Solver::builder().tolerance(1e-9));
    let full = PI / n as f64; // pressure that closes the wave (Westergaard 1939): π E* Δ/λ
    let excess = |k: i32| {
        // Widths 2a that rise by equal steps: sin²(π a/λ) = p/p*.
        let width = 30.0 + 12.0 * f64::from(k) / f64::from(loads);
        let load = full * (PI * width / (2.0 * n as f64)).sin().powi(2);
        let solution = solver.solve(&map, Load::MeanPressure(load)).unwrap();
        let counted = solution.touching_fraction() * n as f64;
        counted - width
    };
    let mean = (0..loads).map(excess).sum::<f64>() / f64::from(loads) / 2.0;
    assert!((mean - 0.19).abs() < 0.01, "{mean}");
}
