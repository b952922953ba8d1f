//! No map gives NaN: a typed error or finite values, at every extreme.

use crate::cases::map;
use contact_types::{Grid, HeightMap};
use proptest::prelude::*;
use std::fmt::Debug;
use surface_stats::clean::{Form, Step, apply};
use surface_stats::iso25178::{IsoParameter, parameters};
use surface_stats::{Edges, Level, StatsError, StatsOptions, SurfaceStatistics, Warning};

fn ripple(iy: usize, ix: usize) -> f64 {
    (0.9 * iy as f64).sin() + (1.7 * ix as f64 + 0.3 * iy as f64).cos()
}

/// That no number among these is NaN or infinite.
fn finite(found: &impl Debug) {
    // Of parallel ridges one direction has no slope: a ratio without end.
    let text = format!("{found:?}").replace("Anisotropic { ratio: inf }", "");
    assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
}

fn all_finite(m: &HeightMap) -> SurfaceStatistics {
    let mut last = None;
    for edges in [Edges::Open, Edges::Periodic] {
        for level in [Level::None, Level::Mean, Level::Plane, Level::Quadratic] {
            let options = StatsOptions { level, edges, ..StatsOptions::default() };
            let s = SurfaceStatistics::of(m, &options).unwrap();
            finite(&s);
            last = Some(s);
        }
    }
    last.unwrap()
}

#[test]
fn flat_surfaces_are_answered() {
    for height in [0.0, 76e-3, -1e6, 1e300] {
        for shape in [[3, 3], [3, 40], [17, 16]] {
            let m = map(shape, [1e-6, 2e-6], |_, _| height);
            let s = all_finite(&m);
            assert_eq!((s.rms_height, s.m2, s.m4, s.bandwidth), (0.0, 0.0, 0.0, None));
            assert_eq!((s.m0, s.m4_spectral), (0.0, 0.0));
            assert_eq!((s.skewness, s.kurtosis), (None, None));
            let flat =
                |w: &Warning| matches!(w, Warning::Flat { rms_height, .. } if *rms_height <= 0.0);
            assert!(s.warnings.len() == 1 && flat(&s.warnings[0]), "{:?}", s.warnings);
            assert!(s.asperities.is_none() && s.hurst.is_none() && s.cutoff.is_none());
            assert_eq!((s.summits.count, s.summits.plateaus), (0, 0));
            assert_eq!((s.summits.height_mean, s.summits.curvature_mean), (None, None));
            for edges in [Edges::Open, Edges::Periodic] {
                let Some(iso) = iso(&m, edges) else { continue };
                let value = |symbol| iso.iter().find(|p| p.symbol == symbol).unwrap().value;
                assert_eq!(["Sal", "Str", "Std"].map(value), [None; 3]);
                for symbol in ["Sk", "Spk", "Svk", "Sxp", "Vvc"] {
                    assert!(value(symbol).unwrap().abs() <= 0.0, "{symbol}");
                }
            }
        }
    }
}

/// Areal parameters, but of fewer than ten points, and that they are finite.
fn iso(m: &HeightMap, edges: Edges) -> Option<Vec<IsoParameter>> {
    match parameters(m, edges) {
        Err(StatsError::TooFewPoints { needed: 10, .. }) => None,
        found => {
            let found = found.unwrap();
            finite(&found);
            Some(found)
        }
    }
}

/// A tilted plane is flat after levelling, and says that what is left is rounding.
#[test]
fn a_tilted_plane_is_flat_once_levelled() {
    let m = map([33, 47], [1e-6, 1e-6], |iy, ix| 76e-3 + 1e-7 * iy as f64 + 3e-7 * ix as f64);
    let options = StatsOptions { level: Level::Plane, ..StatsOptions::default() };
    let s = SurfaceStatistics::of(&m, &options).unwrap();
    assert!(matches!(s.warnings[..], [Warning::Flat { .. }]));
    all_finite(&m);
}

/// From 1e-50 m to 1e50 m of height and pixel.
#[test]
fn scales_with_its_units() {
    let base = all_finite(&map([24, 31], [1.5, 1.0], ripple));
    for (z, l) in [(1e-50, 1.0), (1e50, 1.0), (1e-9, 1e-25), (1e-9, 1e25), (1e-20, 1e-20)] {
        let s = all_finite(&map([24, 31], [1.5 * l, l], |iy, ix| z * ripple(iy, ix)));
        let same = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-9, "{a:e} {b:e}");
        same(s.rms_height, z * base.rms_height);
        same(s.rms_gradient, z / l * base.rms_gradient);
        same(s.m4.sqrt(), z / l / l * base.m4.sqrt());
        same(s.bandwidth.unwrap(), base.bandwidth.unwrap());
        same(s.asperities.unwrap().radius, l / z * l * base.asperities.unwrap().radius);
        assert_eq!(s.summits.count, base.summits.count);
    }
}

#[test]
fn what_cannot_be_answered_is_refused_with_the_limit() {
    let refused = |map: &HeightMap, fractal_range| {
        SurfaceStatistics::of(map, &StatsOptions { fractal_range, ..StatsOptions::default() })
    };
    for shape in [[1, 100], [2, 100], [100, 1], [1, 1]] {
        let error = refused(&map(shape, [1.0, 1.0], ripple), None);
        assert!(matches!(error, Err(StatsError::TooSmall { needed: [3, 3], .. })), "{shape:?}");
    }
    for (z, l) in
        [(1e-70, 1.0), (1e70, 1.0), (1e-300, 1.0), (1e307, 1.0), (1.0, 1e-40), (1.0, 1e40)]
    {
        let error = refused(&map([5, 5], [l, l], |iy, ix| z * ripple(iy, ix)), None);
        assert!(matches!(error, Err(StatsError::OutOfRange { .. })), "{z:e} {l:e}");
    }
    for range in [[0.0, 1.0], [2.0, 1.0], [f64::NAN, 1.0], [1.0, f64::INFINITY]] {
        let error = refused(&map([5, 5], [1.0, 1.0], ripple), Some(range));
        assert!(matches!(error, Err(StatsError::BadSetting { .. })), "{range:?}");
    }
}

/// Parameters beyond `SurfaceStatistics`, and all cleaning, of the same maps.
fn further_parameters(m: &HeightMap) {
    for edges in [Edges::Open, Edges::Periodic] {
        iso(m, edges);
    }
    let grid = m.grid();
    let cutoff = 3.0 * grid.pixel()[0].max(grid.pixel()[1]);
    for step in steps(cutoff) {
        let mut heights = m.heights().to_vec();
        heights[0] = f64::NAN;
        match apply(grid, &mut heights, &[step]) {
            Ok(_) => {
                assert!(heights[0].is_nan());
                heights.retain(|h| !h.is_nan()); // spikes are missing points then
                finite(&heights);
            }
            // A form that the points do not determine.
            Err(error) => assert!(matches!(step, Step::Form(_)), "{error}"),
        }
    }
}

/// Every way to clean a map.
fn steps(cutoff: f64) -> [Step; 7] {
    let [polynomial, sphere, cylinder] =
        [Form::Polynomial(3), Form::Sphere, Form::Cylinder].map(Step::Form);
    let (s, l) = (Step::SFilter(cutoff), Step::LFilter(cutoff));
    [polynomial, sphere, cylinder, Step::Outliers(8.0), s, l, Step::Rows]
}

#[test]
fn infinite_heights_are_refused_by_name() {
    let grid = Grid::new([3, 4], [1e-6, 1e-6]).unwrap();
    let mut heights = vec![0.0; 12];
    heights[6] = f64::INFINITY;
    for step in steps(4e-6) {
        let message = apply(grid, &mut heights, &[step]).unwrap_err().to_string();
        assert!(message.starts_with("height at row 1, column 2 is inf"), "{step:?}: {message}");
    }
}

/// Two peaks and a pit of 5e59 m in a flat map, a case that the random maps below once found.
#[test]
fn huge_peaks_and_a_pit() {
    let map = map([10, 4], [1.0, 1.0], |iy, ix| match (iy, ix) {
        (5 | 9, 3) => 5e59,
        (7, 3) => -5e59,
        _ => 0.0,
    });
    all_finite(&map);
    further_parameters(&map);
}

/// Heights as files have them at their worst: ties, steps, spikes of fifty decades, signed zeros.
fn odd_height() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => (-20i32..20).prop_map(|k| f64::from(k) * 1e-8),
        2 => -1e-6..1e-6,
        1 => prop_oneof![Just(0.0), Just(-0.0), Just(1e-300), Just(5e59), Just(-5e59), Just(1e6)],
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// Whatever the heights, side lengths and pixels: finite numbers or a typed error, no panic.
    #[test]
    fn any_map_gives_finite_numbers_or_a_typed_error(
        shape in [1usize..14, 1usize..14],
        heights in prop::collection::vec(odd_height(), 14 * 14),
        pixel in [-30i32..30, -30i32..30],
    ) {
        let pixel = pixel.map(|e| 10f64.powi(e));
        let m = map(shape, pixel, |iy, ix| heights[14 * iy + ix]);
        match SurfaceStatistics::of(&m, &StatsOptions::default()) {
            Ok(_) => {
                all_finite(&m);
                further_parameters(&m);
            }
            Err(StatsError::TooSmall { .. }) => prop_assert!(shape[0] < 3 || shape[1] < 3),
            Err(StatsError::OutOfRange { .. }) => {}
            Err(other) => prop_assert!(false, "{other}"),
        }
    }
}
