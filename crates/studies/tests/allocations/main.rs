//! Nothing is allocated that a call does not need: closed forms nothing at all, transforms and
//! further loads nothing per iteration, readers and statistics a stated number of maps.

mod cases;

use cases::{Case, all};

#[test]
fn calls_hold_no_more_than_they_need() {
    let cases = all(300);
    let (closed, on_maps): (Vec<&Case>, Vec<&Case>) = cases.iter().partition(|c| c.map.is_none());
    assert!(closed.len() >= 12);
    for case in closed {
        let (count, bytes) = (case.found.count_total, case.found.bytes_total);
        assert_eq!((count, bytes), (0, 0), "{}, {} allocates", case.package, case.call);
    }
    for case in &on_maps {
        let (arrays, (_, limit)) = case.arrays().zip(case.map).expect("a call on a map");
        let call = format!("{}, {}: {arrays:.3} maps", case.package, case.call);
        assert!(arrays <= limit, "{call}, limit {limit}");
        // A limit that is far above what is needed holds nothing.
        assert!(arrays >= 0.8 * limit - 0.1, "{call}: lower the limit, {limit}");
    }
}
