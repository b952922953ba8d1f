//! The reader of the format whose first extension is in the variable FORMAT, or all, each where it recognises its own.
//! Whatever the bytes, a reader returns a measurement that keeps its promises or a typed error, within small limits.
#![no_main]

use libfuzzer_sys::fuzz_target;
use std::sync::OnceLock;
use surface_io::{FORMATS, FormatSpec, HeightUnit, Layout, Limits, ReadOptions, read_bytes};

/// `None` if none is named: it is recognised.
fn format() -> Option<&'static FormatSpec> {
    static FORMAT: OnceLock<Option<&'static FormatSpec>> = OnceLock::new();
    *FORMAT.get_or_init(|| {
        let named = std::env::var("FORMAT").ok()?;
        let found = FORMATS.iter().find(|spec| spec.extensions[0] == named);
        assert!(found.is_some(), "no format is called {named}");
        found
    })
}

fuzz_target!(|bytes: &[u8]| {
    let limits =
        Limits { file_bytes: 1 << 20, unpacked_bytes: 1 << 20, points: 1 << 16, items: 1 << 10 };
    let options = ReadOptions { limits, ..ReadOptions::default() };
    let pixel = Some([3e-6, 2e-6]);
    let height_unit = Some(HeightUnit::IfSilent(1e-9));
    let given = ReadOptions { pixel, height_unit, ..options.clone() };
    let [matrix, list, traces] = [Layout::Matrix, Layout::List, Layout::Traces]
        .map(|layout| ReadOptions { layout: Some(layout), ..given.clone() });
    for options in [options, given, matrix, list, traces] {
        let result = match format() {
            Some(spec) => spec.read(bytes, &options),
            None => read_bytes(bytes, &options),
        };
        if let Ok(found) = result {
            let [ny, nx] = found.grid().shape();
            assert_eq!(found.heights().len(), ny * nx);
            assert!((ny * nx) as u64 <= limits.points);
            assert!(found.heights().iter().all(|h| !h.is_infinite()));
            assert_eq!(found.heights().iter().filter(|h| h.is_nan()).count(), found.missing());
            assert!(found.grid().pixel().iter().all(|side| side.is_finite() && *side > 0.0));
        }
    }
});
