//! The lengths for which moments and spectra stay inside the range of a double.

use crate::StatsError;
use contact_types::HeightMap;
use std::ops::RangeInclusive;

/// Pixel sides (m): the fourth power of a wavenumber must be a normal number.
const PIXEL: RangeInclusive<f64> = 1e-30..=1e30;

/// Peak-to-valley height (m), unless 0: its square divided by the fourth power of a pixel must
/// be a normal number.
const RANGE: RangeInclusive<f64> = 1e-60..=1e60;

/// Refuses a map whose moments could overflow or vanish. No surface made of matter is refused.
pub(crate) fn check(map: &HeightMap) -> Result<(), StatsError> {
    for (quantity, value) in ["pixel size dy", "pixel size dx"].into_iter().zip(map.grid().pixel())
    {
        if !PIXEL.contains(&value) {
            return Err(StatsError::OutOfRange { quantity, value, domain: PIXEL });
        }
    }
    let (low, high) = map.range();
    let value = high - low;
    if value > 0.0 && !RANGE.contains(&value) {
        let quantity = "peak-to-valley height";
        return Err(StatsError::OutOfRange { quantity, value, domain: RANGE });
    }
    Ok(())
}
