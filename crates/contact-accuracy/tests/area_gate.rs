//! Where an interval around the area is given, and where it is refused.

#![allow(clippy::unwrap_used, reason = "a check that cannot be made has failed")]

use contact_accuracy::budget::Map;
use contact_accuracy::{AreaAccuracy, NoAreaInterval};
use contact_types::{ContactModulus, Grid, HeightMap};
use fft_bem_solver::{Load, Method, Solver};
use surface_stats::clean::resample;
use surface_stats::synthesis::{Scale, SelfAffine};

fn modulus() -> ContactModulus {
    ContactModulus::from_pascals(1.0).unwrap()
}

/// 64 x 64 unit pixels, rms gradient 1.
fn self_affine(hurst: f64, rolloff: f64, cutoff: f64, seed: u64) -> HeightMap {
    let grid = Grid::new([64, 64], [1.0, 1.0]).unwrap();
    let scale = Scale::RmsGradient(1.0);
    let recipe = SelfAffine { grid, hurst, rolloff, cutoff, scale, seed, quantise: None };
    recipe.generate().unwrap()
}

/// The interval for the area holds the area of the same surface on a grid four times finer, for
/// most maps; 30 % of the correction is no bound but a 95 % interval.
#[test]
fn area_interval_holds_the_refined_area() {
    let (mut inside, mut all) = (0, 0);
    for seed in 0..6 {
        for (hurst, cutoff) in [(0.8, 6.0), (0.8, 12.0), (0.3, 8.0)] {
            let map = self_affine(hurst, 32.0, cutoff, seed);
            let accuracy = AreaAccuracy::of(&map).unwrap();
            for load in [0.03, 0.15] {
                let solve = |map: &HeightMap| {
                    Solver::builder()
                        .tolerance(1e-5)
                        .build(map.grid(), modulus())
                        .unwrap()
                        .solve(map, Load::MeanPressure(load))
                        .unwrap()
                };
                let Ok([low, high]) = accuracy.interval(&solve(&map)) else { continue };
                assert!(high - low < 0.12 * high);
                let truth =
                    solve(&resample(&map, [256, 256], surface_stats::Edges::Periodic).unwrap())
                        .diagnostics
                        .area_fraction_corrected;
                all += 1;
                inside += usize::from(low <= truth && truth <= high);
            }
        }
    }
    println!("inside: {inside} of {all}");
    assert!(all >= 24, "the gate let too few through: {all}");
    assert!(inside * 10 >= all * 9, "{inside} of {all}");
}

/// Where no interval is known none is given, and the reason is.
#[test]
fn area_interval_is_refused_outside_its_gate() {
    let solve = |map: &HeightMap, load: f64, tolerance: f64| {
        Solver::builder()
            .tolerance(tolerance)
            .build(map.grid(), modulus())
            .unwrap()
            .solve(map, Load::MeanPressure(load))
            .unwrap()
    };
    let to_the_pixel = self_affine(0.3, 16.0, 2.0, 5);
    assert!(matches!(
        AreaAccuracy::of(&to_the_pixel).unwrap().interval(&solve(&to_the_pixel, 0.1, 1e-5)),
        Err(NoAreaInterval::Unresolved { .. })
    ));
    let smooth = self_affine(0.8, 64.0, 16.0, 5);
    assert!(matches!(
        AreaAccuracy::of(&smooth).unwrap().interval(&solve(&smooth, 1e-6, 1e-5)),
        Err(NoAreaInterval::SpotsTooSmall { .. })
    ));
    // The chord iteration does not stop that early.
    let loosely = Solver::builder().method(Method::PolonskyKeer).tolerance(0.3);
    let mut loosely = loosely.build(smooth.grid(), modulus()).unwrap();
    assert!(matches!(
        AreaAccuracy::of(&smooth)
            .unwrap()
            .interval(&loosely.solve(&smooth, Load::MeanPressure(0.1)).unwrap()),
        Err(NoAreaInterval::TooLooselySolved { .. })
    ));
    // The solution of a map is none of a part of it.
    let part = HeightMap::from_fn(Grid::new([32, 32], [1.0, 1.0]).unwrap(), |y, x| {
        smooth.at(y as usize, x as usize)
    });
    let refused = AreaAccuracy::of(&smooth).unwrap().interval(&solve(&part.unwrap(), 0.1, 1e-5));
    let Err(other @ NoAreaInterval::OtherGrid { .. }) = refused else { panic!("{refused:?}") };
    assert!(other.to_string().contains("32 x 32") && other.to_string().contains("64 x 64"));
    // Full contact has no contact line.
    let full = solve(&smooth, 10.0, 1e-5);
    let [low, high] = AreaAccuracy::of(&smooth).unwrap().interval(&full).unwrap();
    assert!(low >= 1.0 && high >= 1.0);
}

/// One judge: what a map says of the area it says in the budget too, tilted or stepped.
#[test]
fn a_map_is_judged_once() {
    let grid = Grid::new([64, 64], [1.0, 1.0]).unwrap();
    let smooth = self_affine(0.8, 64.0, 16.0, 5);
    let of = |change: &dyn Fn(f64, f64) -> f64| {
        let height = |y: f64, x: f64| change(smooth.at(y as usize, x as usize), x);
        HeightMap::from_fn(grid, height).unwrap()
    };
    let plain = AreaAccuracy::of(&smooth).unwrap();
    // A tilt of one rms gradient jumps at the edges by 64 pixels: no waves that are not resolved.
    let tilted = of(&|h, x| h + x);
    let stepped = of(&|h, _| (h / 0.05).round() * 0.05);
    for map in [&smooth, &tilted, &stepped] {
        assert_eq!(AreaAccuracy::of(map).unwrap(), Map::of(map).unwrap().accuracy);
    }
    let tilted = AreaAccuracy::of(&tilted).unwrap();
    assert!(tilted.gate().is_ok() && (tilted.resolution - plain.resolution).abs() < 0.01);
    assert!((AreaAccuracy::of(&stepped).unwrap().step_ratio - 0.05).abs() < 1e-3);
}
