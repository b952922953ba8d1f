//! The leak through the gap of a solution holds that of four times the points.

use crate::families::{family, map};
use contact_accuracy::{
    Answered, Axis, ContactModulus, Grid, HeightMap, Ladder, Leak, Load, Map, Maps, Setup, Solver,
    with_images,
};
use gap_flow::Gap;
use std::borrow::Cow;
use surface_stats::synthesis::{Scale, SelfAffine};

fn answered(given: HeightMap, pressure: f64, mirrored: bool) -> Answered {
    let rms = Map::of(&given).rms_height;
    let setup = Setup {
        finer: false,
        mirrored,
        leak: vec![Axis::X],
        ..Setup::new(Solver::builder(), ContactModulus::from_pascals(1.0).unwrap())
    };
    let mut ladder = Ladder::new(given, setup).unwrap();
    ladder.solve(Load::MeanPressure(pressure * rms), |_| ()).unwrap()
}

fn of(points: usize, name: &str) -> HeightMap {
    map(points, &family(name, 41).unwrap())
}

fn leak(points: usize, name: &str, pressure: f64) -> Leak {
    let leaks = answered(of(points, name), pressure, false).leak.unwrap();
    assert!(leaks.mean_gap >= 0.0 && leaks.seconds[0] > 0.0);
    leaks.along.into_iter().next().unwrap().1.unwrap()
}

#[cfg(feature = "serde")]
#[test]
fn an_answer_serialises_with_its_leak() {
    let found = answered(of(64, "waves, 8 points"), 0.3, false);
    let json = serde_json::to_value(&found).unwrap();
    assert_eq!(json["solution"]["state"]["area_fraction"], found.solution.state.area_fraction);
    let leak = &json["leak"]["along"][0];
    assert_eq!(leak[0], "x");
    let flow = &found.leak.unwrap().along[0].1.clone().unwrap().flow;
    assert_eq!(leak[1]["Ok"]["flow"]["permeability"], flow.permeability);
    assert_eq!(leak[1]["Ok"]["flow"]["flux"].as_array().unwrap().len(), 64 * 64);
}

/// Five families at three loads: intervals of K on 64 × 64 points hold K on 192 × 192, and what has no rate is bounded.
#[test]
fn intervals_hold_the_leak_of_a_finer_grid() {
    let names = ["waves, 8 points", "short waves", "lay", "log-normal", "balls"];
    let (mut all, mut missed) = (0, Vec::new());
    for name in names {
        for pressure in [0.3, 3.0, 8.0] {
            let given = leak(64, name, pressure);
            // Sealed at this resolution is no statement on a finer one.
            let Some([low, high]) = given.interval() else { continue };
            let fine = leak(192, name, pressure).flow.permeability;
            all += 1;
            if fine < low || fine > high {
                missed.push((name, pressure, fine / given.flow.permeability));
            }
        }
    }
    assert!(all >= 10 && missed.len() * 20 <= all, "{} of {all}: {missed:?}", missed.len());
}

/// A map continued by its mirror images leaks as the whole of them given as a map that repeats.
#[test]
fn mirror_images_are_a_map_that_repeats() {
    let given = of(48, "waves, 8 points");
    let whole = with_images(Cow::Borrowed(&given), true).unwrap().into_owned();
    let [own, whole] = [(given, true), (whole, false)].map(|(map, mirrored)| {
        let leaks = answered(map, 0.3, mirrored).leak.unwrap();
        leaks.along[0].1.as_ref().unwrap().flow.permeability
    });
    assert!((own / whole - 1.0).abs() < 1e-10 && own > 0.0, "{own} and {whole}");
}

/// Ten self-affine maps are sealed from 38 to 46 % of real area on (0.42 for elastic contact: Dapp et al. 2012). Thirty-two of the
/// longest waves a side: with eight, one of ten maps is sealed at 0.47, with sixteen one at 0.37.
#[test]
#[ignore = "slow: ten maps of 1024 x 1024 points, twelve loads each"]
fn random_maps_are_sealed_at_about_forty_two_per_cent() {
    let grid = Grid::new([1024, 1024], [1.0 / 1024.0; 2]).unwrap();
    let modulus = ContactModulus::from_pascals(1.0).unwrap();
    let mut areas = Vec::new();
    for seed in 0..10 {
        let recipe = SelfAffine {
            grid,
            hurst: 0.8,
            rolloff: 1.0 / 32.0,
            cutoff: 8.0 / 1024.0,
            scale: Scale::RmsGradient(0.1),
            seed,
            quantise: None,
        };
        let builder = Solver::builder().maps(Maps::PressureAndGap);
        let mut solver = builder.build(grid, modulus).unwrap();
        solver.take_surface(&recipe.generate().unwrap()).unwrap();
        let mut at = |pressure: f64| {
            let found = solver.solve_again(Load::MeanPressure(pressure), None, |_| ()).unwrap();
            let flow = Gap::new(grid, &found.open_gap()).flow(Axis::X).unwrap();
            (flow.bottleneck.is_none(), found.state.area_fraction)
        };
        let (mut open, mut sealed, mut area) = (0.01, 0.05, [0.0; 2]);
        for _ in 0..12 {
            let middle = 0.5 * (open + sealed);
            let (is_sealed, here) = at(middle);
            area[usize::from(is_sealed)] = here;
            if is_sealed { sealed = middle } else { open = middle }
        }
        areas.push(0.5 * (area[0] + area[1]));
    }
    assert!(areas.iter().all(|a| (0.38..0.46).contains(a)), "{areas:?}");
}
