//! Square maps that numpy wrote.

use contact_types::{Grid, HeightMap};
use std::path::Path;

/// The numbers of a file of `f64` or `f32` in `fixtures/external/yielding`.
pub(crate) fn numbers(name: &str) -> Vec<f64> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/external/yielding");
    let bytes = std::fs::read(folder.join(name)).unwrap();
    let header = 10 + usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
    let text = String::from_utf8_lossy(&bytes[10..header]).into_owned();
    let data = &bytes[header..];
    if text.contains("<f4") {
        let (numbers, _) = data.as_chunks::<4>();
        return numbers.iter().map(|x| f64::from(f32::from_le_bytes(*x))).collect();
    }
    assert!(text.contains("<f8"), "{text}");
    let (numbers, _) = data.as_chunks::<8>();
    numbers.iter().map(|x| f64::from_le_bytes(*x)).collect()
}

pub(crate) fn unit_cell(name: &str) -> HeightMap {
    let heights = numbers(name);
    let n = heights.len().isqrt();
    let side = 1.0 / n as f64;
    HeightMap::new(Grid::new([n, n], [side, side]).unwrap(), heights).unwrap()
}
