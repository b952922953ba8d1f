//! Do the bars hold for a surface with creases that no map shows? Ridges by formula, against the same formula on eight
//! times the points; many more kinds are in `examples/creases.rs`.

#![allow(clippy::unwrap_used, reason = "a check that cannot be made has failed")]

use contact_accuracy::TwiceFiner;
use contact_accuracy::budget::grid::Line;
use contact_accuracy::budget::{Between, Budget, Estimate, Map, NoAreaInterval, Stiffness};
use contact_accuracy::plan::{self, PlanError, Request, Sink, Task};
use contact_types::{ContactModulus, Grid, HeightMap};
use fft_bem_solver::{Boundary, Load, Maps, Method, Solution, Solver, SolverError};
use std::f64::consts::TAU;
use std::ops::ControlFlow;

/// Ridges where a sum of waves is zero, on a unit square; valleys for `side` -1.
fn ridges(points: usize, side: f64) -> HeightMap {
    let pixel = 1.0 / points as f64;
    let grid = Grid::new([points, points], [pixel, pixel]).unwrap();
    let wave = |y: f64, x: f64| {
        let one = |(ky, kx, phase): (f64, f64, f64)| (TAU * (ky * y + kx * x) + phase).cos();
        [(3.0, 1.0, 0.3), (-2.0, 3.0, 1.1), (1.0, 4.0, 2.9), (4.0, -3.0, 4.0), (2.0, 2.0, 5.3)]
            .map(one)
            .iter()
            .sum::<f64>()
    };
    HeightMap::from_fn(grid, |y, x| -0.02 * side * wave(y, x).abs()).unwrap()
}

#[test]
fn bars_hold_on_ridges_sharper_than_the_points_show() {
    let modulus = ContactModulus::from_pascals(1.0).unwrap();
    let (given, fine) = (ridges(96, 1.0), ridges(768, 1.0));
    let known = Map::of(&given).unwrap();
    let mut coarse = Solver::builder().build(given.grid(), modulus).unwrap();
    let mut exact = Solver::builder().build(fine.grid(), modulus).unwrap();
    let mut finer =
        TwiceFiner::of(&given, &known, Boundary::Periodic, Solver::builder(), modulus).unwrap();
    let mut would_have_missed = 0;
    for load in [1e-3, 2e-3, 4e-3].map(Load::MeanPressure) {
        let solution = coarse.solve(&given, load).unwrap();
        let between = Between::of(&given, true, &solution.pressure, modulus).unwrap();
        assert!(between.bend.is_creased(), "{between:?}");
        let budget = Budget::of(&solution, &known).between(&between);
        assert!(matches!(budget.area.grid, Err(NoAreaInterval::SpotsTooSmall { .. })));
        let set = Stiffness::of_set(&mut coarse, &solution).unwrap().unwrap();
        let budget = budget.with_stiffness(&set, &known, Line::of(&solution));
        let mut smooth = budget;
        smooth.bend = None;
        let smooth = smooth.refined(&finer.solve(load, &smooth).unwrap());
        let budget = budget.refined(&finer.solve(load, &budget).unwrap());
        let truth = exact.solve(&fine, load).unwrap();
        let set = Stiffness::of_set(&mut exact, &truth).unwrap().unwrap();
        let area = truth.diagnostics.area_fraction_corrected;
        let holds = |stated: &Estimate, truth: f64| {
            let [low, high] = stated.comparison().unwrap();
            (low..=high).contains(&truth)
        };
        assert!(holds(&budget.area, area), "{:?} {area}", budget.area);
        let (gap, true_gap) = (budget.mean_gap.unwrap(), truth.state.mean_gap.unwrap());
        assert!(holds(&gap, true_gap), "{gap:?} {true_gap}");
        let stiffness = budget.stiffness.unwrap();
        assert!(holds(&stiffness, set.value), "{stiffness:?} {}", set.value);
        would_have_missed += usize::from(!holds(&smooth.area, area));
        would_have_missed += usize::from(!holds(&smooth.stiffness.unwrap(), set.value));
    }
    assert!(would_have_missed >= 3, "these ridges are no test: {would_have_missed}");
}

#[test]
fn slits_in_valleys_sharper_than_the_points_show_widen_the_area() {
    let modulus = ContactModulus::from_pascals(1.0).unwrap();
    let (given, fine) = (ridges(96, -1.0), ridges(768, -1.0));
    let known = Map::of(&given).unwrap();
    let mut coarse = Solver::builder().build(given.grid(), modulus).unwrap();
    let mut exact = Solver::builder().build(fine.grid(), modulus).unwrap();
    let mut would_have_missed = 0;
    for load in [0.6, 0.8, 1.0].map(Load::MeanPressure) {
        let solution = coarse.solve(&given, load).unwrap();
        let between = Between::of(&given, true, &solution.pressure, modulus).unwrap();
        let budget = Budget::of(&solution, &known);
        let mut smooth = between;
        smooth.slits = 0.0;
        let truth = exact.solve(&fine, load).unwrap().diagnostics.area_fraction_corrected;
        assert!(truth > 0.8 && between.slits > 0.0, "{truth} {between:?}");
        let [low, high] = budget.between(&between).area.comparison().unwrap();
        assert!((low..=high).contains(&truth), "{low} {high} {truth}");
        let [low, high] = budget.between(&smooth).area.comparison().unwrap();
        would_have_missed += usize::from(!(low..=high).contains(&truth));
    }
    assert!(would_have_missed >= 1, "these valleys are no test");
}

struct Areas(Vec<f64>);

impl Sink for Areas {
    fn begin(&mut self, _map: &HeightMap) {
        self.0.clear();
    }
    fn take(
        &mut self,
        _index: usize,
        result: Result<Solution, SolverError>,
        _budget: Option<Budget>,
    ) -> ControlFlow<()> {
        self.0.push(result.unwrap().diagnostics.area_fraction_corrected);
        ControlFlow::Continue(())
    }
}

/// Cusps between spheres ring on the tops of a finer grid by waves; the given grid is gone back to, and its answer is nearer.
#[test]
fn no_accuracy_is_claimed_on_waves_that_ring() -> Result<(), PlanError> {
    let spheres = |points: usize| {
        let pixel = 1.0 / points as f64;
        let grid = Grid::new([points, points], [pixel, pixel]).unwrap();
        let off = |s: f64| s - (s + 0.5).floor();
        let place = |k: usize, by: f64| (k as f64 * by).fract();
        let height = |y: f64, x: f64| {
            let one = |k: usize| {
                let [dy, dx] = [off(y - place(k, 0.754_877_666)), off(x - place(k, 0.569_840_290))];
                0.05 - dy * dy - dx * dx
            };
            (0..14).map(one).fold(0.0, f64::max).sqrt()
        };
        HeightMap::from_fn(grid, |y, x| 0.1 * height(y, x)).unwrap()
    };
    let (map, modulus) = (spheres(128), ContactModulus::from_pascals(1.0).unwrap());
    let known = Map::of(&map).unwrap();
    let loads = [Load::MeanPressure(3e-4)];
    let task = Task {
        map: &map,
        known: &known,
        modulus,
        loads: &loads,
        boundary: Boundary::Periodic,
        request: Request::new(0.02).unwrap(),
        method: Method::Auto,
        certified: false,
        maps: Maps::default(),
        section: None,
        threads: 1,
    };
    let mut found = Areas(Vec::new());
    let outcome = plan::run(&task, &mut found)?;
    assert_eq!(outcome.grid, map.grid(), "{outcome:?}");
    assert!(!outcome.met, "{outcome:?}");
    let fine = spheres(1024);
    let mut exact = Solver::builder().build(fine.grid(), modulus).unwrap();
    let truth = exact.solve(&fine, loads[0]).unwrap().diagnostics.area_fraction_corrected;
    let half = outcome.half_width.unwrap();
    assert!((found.0[0] / truth - 1.0).abs() < half, "{:?} {truth} {half}", found.0);
    Ok(())
}
