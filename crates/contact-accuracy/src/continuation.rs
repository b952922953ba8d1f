//! What lies beyond the edges of a map: itself, or its mirror images; and the same surface on
//! another number of points, which depends on it.

use contact_types::HeightMap;
use surface_stats::StatsError;
use surface_stats::clean::{resample, resample_mirrored};

/// The map on `shape` points: by its waves if it repeats, by its cosines otherwise, so that the jump
/// at its edges does not ring.
///
/// # Errors
/// [`StatsError`].
pub fn regrid(map: &HeightMap, shape: [usize; 2], repeats: bool) -> Result<HeightMap, StatsError> {
    if repeats { resample(map, shape) } else { resample_mirrored(map, shape) }
}
