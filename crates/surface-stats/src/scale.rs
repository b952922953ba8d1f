//! The lengths for which moments and spectra stay inside the range of a double.

use crate::StatsError;
use contact_types::{Grid, HeightMap, SurfaceError};
use std::ops::RangeInclusive;

/// Pixel sides (m): the fourth power of a wavenumber must be a normal number.
const PIXEL: RangeInclusive<f64> = 1e-30..=1e30;

/// Peak-to-valley height (m), unless 0: its square divided by the fourth power of a pixel must
/// be a normal number.
const RANGE: RangeInclusive<f64> = 1e-60..=1e60;

/// Refuses a map whose moments could overflow or vanish. No surface made of matter is refused.
pub(crate) fn check(map: &HeightMap) -> Result<(), StatsError> {
    check_lengths(map.grid(), map.range())
}

/// The same for heights in which NaN marks a missing point, whose lowest and highest one it returns, 0 if there is none;
/// also refuses infinite ones and a number of heights that does not fit the grid.
pub(crate) fn check_measured(grid: Grid, heights: &[f64]) -> Result<(f64, f64), StatsError> {
    if heights.len() != grid.len() {
        let (expected, found) = (grid.len(), heights.len());
        return Err(StatsError::Shape { what: "heights", expected, found });
    }
    // `min` and `max` pass over NaN.
    let extent = |(low, high): (f64, f64), &h: &f64| (low.min(h), high.max(h));
    let (low, high) = heights.iter().fold((f64::INFINITY, f64::NEG_INFINITY), extent);
    let range = if low <= high { (low, high) } else { (0.0, 0.0) };
    if !(range.1 - range.0).is_finite()
        && let Some(first) = heights.iter().position(|h| h.is_infinite())
    {
        let nx = grid.shape()[1];
        return Err(StatsError::Surface(SurfaceError::NotFinite {
            iy: first / nx,
            ix: first % nx,
            value: heights[first],
            count: heights.iter().filter(|h| h.is_infinite()).count(),
        }));
    }
    check_lengths(grid, range)?;
    Ok(range)
}

fn check_lengths(grid: Grid, (low, high): (f64, f64)) -> Result<(), StatsError> {
    for (quantity, value) in ["pixel size dy", "pixel size dx"].into_iter().zip(grid.pixel()) {
        if !PIXEL.contains(&value) {
            return Err(StatsError::OutOfRange { quantity, value, domain: PIXEL });
        }
    }
    let value = high - low;
    if value > 0.0 && !RANGE.contains(&value) {
        let quantity = "peak-to-valley height";
        return Err(StatsError::OutOfRange { quantity, value, domain: RANGE });
    }
    Ok(())
}
