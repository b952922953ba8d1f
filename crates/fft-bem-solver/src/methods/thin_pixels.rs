//! What changes where pixels are longer one way than the other.
//!
//! The kernel `|q|/2` of waves across long pixels is small: a load moved from one line of long pixels to the next shifts
//! both by much. So nothing is averaged over lines before it is averaged along them.

/// Pixels longer than this many times their width are refused: beyond it the preconditioner, in single precision,
/// cannot resolve the lowest transverse mode. Up to 3e4 a solve takes as many convolutions as at 10, at 1e5 up to 35,
/// at 1e6 hundreds (to 1e-4, both axes).
pub(crate) const LARGEST_RATIO: f64 = 1e5;

/// Longer over shorter of two sides, of the pixels or of the map; 1 for a single line of pixels.
pub(crate) fn ratio(shape: [usize; 2], [y, x]: [f64; 2]) -> f64 {
    if shape.iter().all(|n| *n > 1) { (y / x).max(x / y) } else { 1.0 }
}

/// The entry of `cells` for these pixels, by axis. They are pixels per cell `[along the longer sides, along the
/// shorter]` for each octave of the ratio; the last holds for all ratios beyond.
pub(crate) fn cell(pixel: [f64; 2], cells: &[[usize; 2]]) -> [usize; 2] {
    let octave = (pixel[0] / pixel[1]).log2();
    let [long, short] = cells[(octave.abs().round() as usize).min(cells.len() - 1)];
    if octave > 0.0 { [long, short] } else { [short, long] }
}
