//! Problems at the extremes whose solution is known, and what the solver makes of them.

#![allow(clippy::print_stdout, reason = "the lines are counted in the book")]

use crate::common::{Uniform, self_affine, unit_grid};
use crate::dense;
use contact_types::{ContactModulus, Grid, HeightMap};
use fft_bem_solver::reference::Westergaard;
use fft_bem_solver::{Load, Solution, Solver};
use std::f64::consts::{PI, SQRT_2, TAU};

struct Case {
    /// Which map, what is extreme about it, and what it is compared with.
    what: String,
    /// Worst errors: of a pressure, relative to the highest; of the area, relative; of a gap,
    /// relative to the range of the heights.
    errors: [f64; 3],
    limits: [f64; 3],
}

/// Every line of the table in the book, each with its limits.
#[test]
fn known_solutions_at_the_extremes() {
    for of in [scales, offsets, loads, shapes_of_heights, shapes_of_grids, profiles] {
        of();
    }
}

/// Estimated relative error of the pressure at which the solves end.
const TOLERANCE: f64 = 1e-10;
const ROUGH: &str = "rough, 14 × 12";
const DENSE: &str = "dense linear algebra";
const DENSE_LIMITS: [f64; 3] = [1e-9, 0.0, 1e-9];
/// Mean pressures over E* times rms gradient: light, medium, nearly closed.
const LOADS: [f64; 3] = [1e-3, 0.05, 0.4];

/// The map most lines start from: rms gradient 1.
fn rough() -> HeightMap {
    self_affine(unit_grid(14, 12), 0.8, 10.0, 3.0, 11)
}

fn modulus(pascals: f64) -> ContactModulus {
    ContactModulus::from_pascals(pascals).expect("positive")
}

fn solve(map: &HeightMap, e_star: f64, load: f64) -> Solution {
    solve_load(map, e_star, Load::MeanPressure(load))
}

fn solve_load(map: &HeightMap, e_star: f64, load: Load) -> Solution {
    Solver::builder()
        .tolerance(TOLERANCE)
        .build(map.grid(), modulus(e_star))
        .and_then(|mut solver| solver.solve(map, load))
        .unwrap_or_else(|e| panic!("{load:?}: {e}"))
}

/// The same heights times `factor`, on pixels of `pixel`.
fn scaled(map: &HeightMap, factor: f64, pixel: [f64; 2]) -> HeightMap {
    let grid = Grid::new(map.grid().shape(), pixel).expect("positive");
    let heights = map.heights().iter().map(|h| h * factor).collect();
    HeightMap::new(grid, heights).expect("finite")
}

fn with_heights(map: &HeightMap, heights: impl IntoIterator<Item = f64>) -> HeightMap {
    HeightMap::new(map.grid(), heights.into_iter().collect()).expect("finite")
}

impl Case {
    fn new(what: &str, extreme: &str, compared_with: &str, limits: [f64; 3]) -> Self {
        let what = format!("{what}, {extreme}, against {compared_with}");
        Self { what, errors: [0.0; 3], limits }
    }

    fn compare(
        &mut self,
        map: &HeightMap,
        found: &Solution,
        pressure: impl Iterator<Item = f64> + Clone,
        area: f64,
        gap: impl Iterator<Item = f64>,
    ) {
        let (bottom, top) = map.range();
        let largest = |a: f64, b: f64| if b <= a { a } else { b }; // and keeps NaN
        let differences = found.pressure.iter().zip(pressure.clone()).map(|(p, q)| (p - q).abs());
        let p = differences.fold(0.0, largest) / pressure.fold(0.0, largest);
        let a = (found.touching_fraction() / area - 1.0).abs();
        let differences = found.gap.iter().zip(gap).map(|(g, q)| (g - q).abs());
        let g = differences.fold(0.0, largest) / (top - bottom);
        for (worst, error) in self.errors.iter_mut().zip([p, a, g]) {
            *worst = largest(*worst, error);
        }
    }

    /// Compares a map of this E*, whose pressures and heights are so many times those of `unit`, with the dense solution
    /// of that, under each of the `loads` of `unit`.
    fn beside(
        mut self,
        unit: &HeightMap,
        loads: &[f64],
        (map, e_star): (&HeightMap, f64),
        [pressure, height]: [f64; 2],
    ) {
        for load in loads {
            let known = dense::solution(unit, *load);
            let found = solve(map, e_star, load * pressure);
            let touching = known.pressure.iter().filter(|p| **p > 0.0).count();
            let area = touching as f64 / known.pressure.len() as f64;
            let pressures = known.pressure.iter().map(|p| p * pressure);
            self.compare(map, &found, pressures, area, known.gap.iter().map(|g| g * height));
        }
        self.hold();
    }

    /// Prints the largest of the errors.
    fn hold(&self) {
        let Self { what, errors, limits } = self;
        println!("fft-bem-solver: {what}: {:.1e}", errors.iter().copied().fold(0.0, f64::max));
        let holds = errors.iter().zip(limits).all(|(error, limit)| error <= limit);
        assert!(holds, "{what}: {errors:?}, limits {limits:?}");
    }
}

/// A map against dense algebra under several loads.
fn dense_case(what: &str, extreme: &str, map: &HeightMap, loads: &[f64]) {
    Case::new(what, extreme, DENSE, DENSE_LIMITS).beside(map, loads, (map, 1.0), [1.0; 2]);
}

/// Slopes, moduli, pixels: the contact is the same but for its units.
fn scales() {
    let unit = rough();
    let middle = (1e9, 0.1, 1e-6);
    for (extreme, (e_star, slope, d)) in [
        ("rms slope 1e−12", (middle.0, 1e-12, middle.2)),
        ("rms slope 1000", (middle.0, 1e3, middle.2)),
        ("E* = 1 Pa", (1.0, middle.1, middle.2)),
        ("E* = 1 TPa", (1e12, middle.1, middle.2)),
        ("pixels of 1e−15 m", (middle.0, middle.1, 1e-15)),
        ("pixels of 1e6 m", (middle.0, middle.1, 1e6)),
        ("all at once: slope 1e−12, 1 Pa, 1e−15 m", (1.0, 1e-12, 1e-15)),
    ] {
        let map = scaled(&unit, slope * d, [d; 2]);
        let case = Case::new(ROUGH, extreme, "dense, in other units", DENSE_LIMITS);
        case.beside(&unit, &LOADS, (&map, e_star), [e_star * slope, slope * d]);
    }
    let extreme = "heights × 2⁻⁵⁰, pixels × 2⁻²⁰, E* × 2³⁰";
    let mut same = Case::new(ROUGH, extreme, "the same in other units: no digit differs", [0.0; 3]);
    let two = |power: i32| 2f64.powi(power);
    for load in LOADS {
        let known = solve(&unit, 1.0, load);
        let map = scaled(&unit, two(-50), [two(-20); 2]);
        let found = solve(&map, two(30), load);
        let gap = known.gap.iter().map(|g| g * two(-50));
        same.compare(&map, &found, known.pressure.iter().copied(), known.touching_fraction(), gap);
    }
    same.hold();
}

/// Heights far from zero: the contact of the heights as they are.
fn offsets() {
    for (extreme, scale, offset) in [
        ("heights of 1 nm on 76 mm", 1e-9, 0.076),
        ("heights of 1 m on 1e6 m", 1.0, 1e6),
        ("heights of 1 nm on 1e6 m, stored in steps of 0.12 nm", 1e-9, 1e6),
    ] {
        let high = with_heights(&rough(), rough().heights().iter().map(|h| h * scale + offset));
        // What is left of the relief in doubles: the difference of two close ones is exact.
        let left = with_heights(&high, high.heights().iter().map(|h| (h - offset) / scale));
        let case = Case::new(ROUGH, extreme, "dense, moved back to 0", DENSE_LIMITS);
        case.beside(&left, &LOADS, (&high, 1.0), [scale; 2]);
    }
}

/// From one node in touch to a hundred times full contact.
fn loads() {
    dense_case(ROUGH, "1e−29 E*: one node carries all", &rough(), &[1e-29]);
    dense_case(ROUGH, "1e−12 E*: one node carries all", &rough(), &[1e-12]);
    let closing = solve_load(&rough(), 1.0, Load::MeanGap(0.0)).state.mean_pressure;
    dense_case(ROUGH, "0.999 of the closing load", &rough(), &[0.999 * closing]);

    // Johnson, Greenwood & Higginson (1985): p* = sqrt(2) pi E* amplitude / wavelength.
    let grid = Grid::new([32, 24], [1.0 / 32.0, 1.0 / 24.0]).expect("positive");
    let map = HeightMap::from_fn(grid, |y, x| 0.1 * (TAU * y).cos() * (TAU * x).cos());
    let (map, closing) = (map.expect("finite"), SQRT_2 * PI * 0.1);
    for (extreme, ratio) in [("1.001 times full contact", 1.001), ("100 times full contact", 100.0)]
    {
        let found = solve(&map, 1.0, ratio * closing);
        let pressure = map.heights().iter().map(|h| closing * (ratio + h / 0.1));
        let limits = [1e-13, 0.0, 1e-13];
        let mut case = Case::new("egg box, 32 × 24", extreme, "closed form", limits);
        case.compare(&map, &found, pressure, 1.0, std::iter::repeat(0.0));
        case.hold();
    }
}

fn shapes_of_heights() {
    let rough = rough();
    let h = rough.heights();
    let mut random = Uniform(9);
    let one = |value: f64| (0..h.len()).map(move |i| if i == 77 { value } else { h[i] });
    let stepped = with_heights(&rough, h.iter().map(|h| (h / 0.5).round() * 0.5));
    // In units of two steps, on pixels of the same size: slopes of order 1.
    let two_steps = 2e-8;
    let in_metres = scaled(&stepped, two_steps, [two_steps; 2]);
    let steps = Case::new("rough in steps of 10 nm", "a handful of levels", DENSE, DENSE_LIMITS);
    let spike = with_heights(&rough, one(1000.0));
    let pit = with_heights(&rough, one(-1e6));
    let plateau = with_heights(&rough, h.iter().map(|h| h.min(0.2)));
    let punch =
        |i: usize| f64::from(u8::from((4..10).contains(&(i / 12)) && (3..9).contains(&(i % 12))));
    let punch = with_heights(&rough, (0..h.len()).map(|i| 1e3 * punch(i)));
    let chequer = with_heights(&rough, (0..h.len()).map(|i| ((i / 12 + i % 12) % 2) as f64));
    let noise = with_heights(&rough, h.iter().map(|_| random.normal()));
    dense_case("rough with one spike", "1000 times the rms height", &spike, &[1e-3, 1.0, 20.0]);
    dense_case("rough with one pit", "1e6 times the rms height deep", &pit, &LOADS);
    dense_case("rough, worn to a plateau", "a flat top with a sharp rim", &plateau, &LOADS);
    dense_case("square punch of 6 × 6 nodes", "walls of slope 1000", &punch, &LOADS);
    steps.beside(&stepped, &LOADS, (&in_metres, 1e9), [1e9, two_steps]);
    dense_case("chequerboard", "the shortest wave, all tops level", &chequer, &LOADS);
    dense_case("white noise", "nothing is resolved", &noise, &LOADS);
}

fn shapes_of_grids() {
    let noise = |shape: [usize; 2], pixel: [f64; 2]| {
        let grid = Grid::new(shape, pixel).expect("positive");
        let mut random = Uniform(17);
        HeightMap::new(grid, (0..grid.len()).map(|_| random.normal()).collect()).expect("finite")
    };
    let prime = self_affine(unit_grid(19, 17), 0.8, 10.0, 3.0, 12);
    dense_case("rough", "prime sides, 19 × 17", &prime, &LOADS);
    dense_case("white noise, 12 × 14", "pixels 1 : 1000", &noise([12, 14], [1e3, 1.0]), &LOADS);
    dense_case("white noise, 12 × 14", "pixels 1000 : 1", &noise([12, 14], [1.0, 1e3]), &LOADS);
    dense_case("white noise", "1 × 101", &noise([1, 101], [1.0, 1.0]), &LOADS);
    dense_case("white noise", "97 × 1", &noise([97, 1], [1.0, 1.0]), &LOADS);
    dense_case("white noise", "2 × 2", &noise([2, 2], [1.0, 1.0]), &LOADS);
    dense_case("white noise", "1 × 2", &noise([1, 2], [1.0, 1.0]), &LOADS);
}

/// One wave on a line of 4096 pixels against the solution of the continuum: what is left is the
/// width of a pixel.
fn profiles() {
    let n = 4096;
    let grid = Grid::new([1, n], [1.0, 1.0 / n as f64]).expect("positive");
    for (extreme, m, limits) in [
        ("1 × 4096, 1e−3 of the closing load", 1e-3, [3e-2, 1e-2, 1e-6]),
        ("1 × 4096, half the closing load", 0.5, [1e-2, 1e-3, 1e-7]),
        ("1 × 4096, 0.999 of the closing load", 0.999, [2e-5, 3e-4, 3e-8]),
        ("1 × 4096, twice the closing load", 2.0, [1e-11, 0.0, 1e-14]),
    ] {
        let known = Westergaard { amplitude: 0.01, wavelength: 1.0, modulus: modulus(1.0), m };
        let map = HeightMap::from_fn(grid, |_, x| known.height(x)).expect("finite");
        let found = solve(&map, 1.0, m * known.closing_pressure());
        let x = || (0..n).map(|i| i as f64 / n as f64);
        let (pressure, gap) = (x().map(|x| known.pressure(x)), x().map(|x| known.gap(x)));
        let mut case = Case::new("one cosine", extreme, "Westergaard (1939)", limits);
        case.compare(&map, &found, pressure, known.area_fraction(), gap);
        case.hold();
    }
}
