//! The uncertainties hold on surfaces given by formulas, whatever is asked, and an accuracy is climbed to.

use crate::families::{FEW, family, gas, map};
use contact_accuracy::{
    AccuracyRequest, Aim, Answered, Boundary, ContactModulus, Estimate, Grid, HeightMap, Ladder,
    Load, Map, NoUncertainty, Reached, Setup, Sink, Solver, SolverBuilder, SolverError, Task,
    climb,
};
use std::f64::consts::{PI, TAU};
use std::ops::ControlFlow;

fn setup(builder: SolverBuilder) -> Setup {
    Setup::new(builder, ContactModulus::from_pascals(1.0).unwrap())
}

/// Distance of the truth over the half width.
fn off(stated: &Estimate, truth: f64) -> f64 {
    (stated.value - truth).abs() / stated.half_width().unwrap().max(f64::MIN_POSITIVE)
}

/// Ten families at three loads, on seeds that took part in nothing, by pressure and by gap: every interval of
/// area, gap, stiffness, gas and pressure holds the surface of the formula on four times the points.
#[test]
fn uncertainties_hold_the_surface_of_the_formula() {
    let (mut all, mut missed) = (0, Vec::new());
    for (k, name) in FEW.into_iter().chain(["crop", "egg box"]).enumerate() {
        let heights = family(name, 31).unwrap();
        let (given, fine) = (map(64, &heights), map(256, &heights));
        let rms = Map::of(&given).rms_height;
        // Temperature jumps of a rough and of a smooth surface in air.
        let jump = if k % 2 == 0 { 0.05 } else { 1.0 } * rms;
        let mut ladder = Ladder::new(
            given,
            Setup { jump: Some(jump), stiffness: true, ..setup(Solver::builder()) },
        )
        .unwrap();
        let mut exact =
            Solver::builder().build(fine.grid(), setup(Solver::builder()).modulus).unwrap();
        for load in [0.3, 3.0, 20.0].map(|p| Load::MeanPressure(p * rms)) {
            let found = ladder.solve(load, |_| ()).unwrap().budget;
            let truth = exact.solve(&fine, load).unwrap();
            let set = exact.contact_stiffness(|i| truth.pressure[i] > 0.0).unwrap();
            let gap = found.mean_gap.unwrap();
            let by_gap = ladder.solve(Load::MeanGap(gap.value), |_| ()).unwrap().budget;
            let of_gap = exact.solve(&fine, Load::MeanGap(gap.value)).unwrap();
            for (what, off) in [
                ("area", off(&found.area, truth.state.area_fraction)),
                ("gap", off(&gap, truth.state.mean_gap.unwrap())),
                ("stiffness", off(&found.stiffness.unwrap(), set.per_area)),
                ("gas", off(&found.gas.unwrap(), gas(&truth, jump))),
                ("pressure", off(&by_gap.mean_pressure, of_gap.state.mean_pressure)),
                ("area by gap", off(&by_gap.area, of_gap.state.area_fraction)),
            ] {
                all += 1;
                if off > 1.0 {
                    missed.push((name, what, load, off));
                }
            }
        }
    }
    assert!(missed.len() * 50 <= all, "{} of {all}: {missed:?}", missed.len());
}

/// A surface on so many points a side.
type Make<'a> = &'a dyn Fn(usize) -> HeightMap;

/// Bodies that yield, an isolated ball, oblong pixels, against four times the points.
#[test]
fn no_map_is_without_an_uncertainty() {
    let heights = family("waves, 8 points", 32).unwrap();
    let rms = Map::of(&map(128, &heights)).rms_height;
    let hard = |hardness| setup(Solver::builder().hardness(hardness));
    let oblong = |n: usize| {
        let grid = Grid::new([n, n], [1.0 / n as f64, 3.0 / n as f64]).unwrap();
        HeightMap::from_fn(grid, |y, x| heights(y, x / 3.0)).unwrap()
    };
    let ball = |n: usize| {
        let grid = Grid::new([n, n], [1.0 / n as f64; 2]).unwrap();
        HeightMap::from_fn(grid, |y, x| -0.5 * ((y - 0.51).powi(2) + (x - 0.48).powi(2))).unwrap()
    };
    let square = |n: usize| map(n, &heights);
    let free = setup(Solver::builder().boundary(Boundary::Free));
    let cases: [(Make<'_>, Setup, f64); 3] = [
        (&square, hard(30.0 * rms), 3.0 * rms),
        (&oblong, setup(Solver::builder()), rms),
        (&ball, free, 0.01),
    ];
    for (case, (map, setup, pressure)) in cases.into_iter().enumerate() {
        let load = Load::MeanPressure(pressure);
        let found = Ladder::new(map(128), setup.clone()).unwrap().solve(load, |_| ()).unwrap();
        let fine = map(512);
        let truth =
            setup.builder.build(fine.grid(), setup.modulus).unwrap().solve(&fine, load).unwrap();
        let area = off(&found.budget.area, truth.state.area_fraction);
        assert!(area <= 1.0, "{case}: {area}");
        if case == 0 {
            let [low, _] = found.budget.area.interval().unwrap();
            assert!(low >= 3.0 / 30.0, "at least P/H: {low}");
        }
    }
}

/// A wave along the rows, its crest on a point, between two and elsewhere, at loads from 0.3 to 95 % of full contact, by
/// Westergaard's formula: all rows round alike.
#[test]
fn ridges_along_the_points_are_held() {
    let (n, mut held) = (64, 0);
    let loads = [0.003, 0.01, 0.03, 0.1, 0.2, 0.4, 0.6, 0.8, 0.95];
    for phase in [0.0, 0.1, 0.25, 0.3, 0.4, 0.5] {
        let grid = Grid::new([n, n], [1.0 / n as f64; 2]).unwrap();
        let wave = |y: f64, _: f64| 0.01 * (TAU * (y + phase / n as f64)).cos();
        let map = HeightMap::from_fn(grid, wave).unwrap();
        let mut ladder = Ladder::new(map, setup(Solver::builder())).unwrap();
        for share in loads {
            let load = Load::MeanPressure(share * PI * 0.01);
            let exact = 2.0 / PI * f64::sqrt(share).asin();
            held += u32::from(off(&ladder.solve(load, |_| ()).unwrap().budget.area, exact) <= 1.0);
        }
    }
    assert!(held >= 51, "{held} of 54");
}

#[test]
fn too_few_points_and_no_contact_say_so() {
    let heights = family("waves, long", 33).unwrap();
    let solve = |n: usize, load| {
        let mut ladder = Ladder::new(map(n, &heights), setup(Solver::builder())).unwrap();
        ladder.solve(load, |_| ()).unwrap().budget.area.half_width()
    };
    let light = Load::MeanPressure(1e-3);
    assert_eq!(solve(15, light), Err(NoUncertainty::TooFewPoints { shape: [15, 15] }));
    assert!(solve(16, light).is_ok());
    assert_eq!(solve(64, Load::MeanGap(1e3)), Err(NoUncertainty::NoContact));
}

/// Where the formula has a crease, the uncertainty covers both ways to read the points.
#[test]
fn an_answer_that_depends_on_interpolation_is_solved_on_twice_the_points() {
    let heights = family("cut", 34).unwrap();
    let ladder = || Ladder::new(map(128, &heights), setup(Solver::builder())).unwrap();
    let (load, mut calls) = (Load::MeanPressure(1.0), 0);
    let found = ladder().solve(load, |_| calls += 1).unwrap();
    // The last map to be solved is the finer one.
    let stopped = ladder().solve(load, |_| {
        calls -= 1;
        if calls > 0 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    });
    assert!(matches!(stopped, Err(SolverError::Stopped(_))));
    let [low, high] = found.budget.area.interval().unwrap();
    assert!(found.budget.indicator.unwrap() > contact_accuracy::INDICATOR_LIMIT);
    assert!((low..=high).contains(&found.finer.unwrap().area));
}

#[test]
fn another_map_is_taken() {
    let (a, b) =
        (map(64, &family("waves, long", 1).unwrap()), map(64, &family("waves, long", 2).unwrap()));
    let load = Load::MeanPressure(1.0);
    let tight = setup(Solver::builder().tolerance(1e-9));
    let mut kept = Ladder::new(a, tight.clone()).unwrap();
    kept.solve(load, |_| ()).unwrap();
    kept.take_map(b.clone()).unwrap();
    let again = kept.solve(load, |_| ()).unwrap().budget;
    let fresh = Ladder::new(b, tight).unwrap().solve(load, |_| ()).unwrap().budget;
    assert!((again.area.value - fresh.area.value).abs() < 1e-9);
    let [again, fresh] = [again, fresh].map(|b| b.area.half_width().unwrap());
    assert!((again / fresh - 1.0).abs() < 1e-6, "{again} {fresh}");
}

/// Takes nothing.
struct Nowhere(usize);

impl Sink for Nowhere {
    fn begin(&mut self, _: &HeightMap, _: &Map) {
        self.0 = 0;
    }

    fn take(&mut self, _: usize, result: Result<Answered, SolverError>) -> ControlFlow<()> {
        self.0 += usize::from(result.is_ok());
        ControlFlow::Continue(())
    }
}

/// Down to what the map can say; the fast one is the widest.
#[test]
fn asking_for_more_never_gives_less() {
    let heights = family("waves, 8 points", 35).unwrap();
    let map = map(128, &heights);
    let loads = [1.0, 3.0].map(Load::MeanPressure);
    let reach = |aim| -> Reached {
        let (map, setup, kept) = (map.clone(), setup(Solver::builder()), &mut None);
        let task = Task { map, setup, loads: &loads, aim, kept };
        let mut sink = Nowhere(0);
        let reached = climb(task, &mut sink).unwrap();
        assert_eq!(sink.0, loads.len());
        reached
    };
    let fast = reach(Aim::Fast);
    assert!(fast.factor() < 0.6 && fast.unmet.is_none());
    assert!(fast.next.is_some_and(|n| n.shape == [128, 128]));
    let mut last = f64::INFINITY;
    for percent in [40.0, 8.0, 4.0, 1.0, 0.1] {
        let request = AccuracyRequest::new(percent / 100.0).unwrap();
        let reached = reach(Aim::Within(request));
        let width = reached.half_width.unwrap();
        assert!(reached.unmet.is_none() == (width <= request.relative()), "{reached:?}");
        assert!(width <= 1.05 * last, "{percent} %: {width} after {last}");
        last = width;
    }
}
