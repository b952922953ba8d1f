//! Nothing is allocated that a call does not need: closed forms nothing at all, transforms and
//! further loads nothing per iteration, readers and statistics a stated number of maps.

mod cases;

use cases::{Case, all};

/// Most that a call may hold at once, in maps of heights, beyond what was there before. Small
/// tables and plans of transforms are the decimals.
const LIMITS: &[(&str, f64)] = &[
    ("transform and back, planned", 0.0),
    ("read NPY", 1.1),
    ("read X3P", 2.1),
    ("m2 and m4 (for GW, BGT, elliptical)", 0.01),
    ("radial spectrum (for Persson)", 2.2),
    ("amplitudes of rows (for stacked)", 0.1),
    ("scales and power law (for Majumdar–Bhushan)", 2.2),
    ("all statistics, periodic", 2.2),
    ("all statistics, open", 2.2),
    ("build and solve one load", 11.0),
    ("build and solve one load, with maps", 13.0),
    ("one more load", 0.1),
    ("one more load, with maps", 2.1),
    ("study of 128 × 128 points at three loads, with its solvers", 63.6),
];

#[test]
fn calls_hold_no_more_than_they_need() {
    let cases = all(300);
    let (closed, on_maps): (Vec<&Case>, Vec<&Case>) = cases.iter().partition(|c| c.map.is_none());
    assert!(closed.len() >= 13);
    for case in closed {
        let (count, bytes) = (case.found.count_total, case.found.bytes_total);
        assert_eq!((count, bytes), (0, 0), "{}, {} allocates", case.package, case.call);
    }
    for case in &on_maps {
        let limit = LIMITS.iter().find(|(call, _)| *call == case.call);
        let limit = limit.unwrap_or_else(|| panic!("'{}' has no limit", case.call)).1;
        let arrays = case.arrays().expect("a call on a map");
        assert!(
            arrays <= limit,
            "{}, {}: {arrays:.3} maps, limit {limit}",
            case.package,
            case.call
        );
        // A limit that is far above what is needed holds nothing.
        assert!(arrays >= 0.8 * limit - 0.1, "{}: {arrays:.3} maps, lower the limit", case.call);
    }
    assert_eq!(on_maps.len(), LIMITS.len());
}
