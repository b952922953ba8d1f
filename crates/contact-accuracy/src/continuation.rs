//! What lies beyond the edges of a map: itself, or its mirror images; and the same surface on
//! another number of points, which depends on it.

use contact_types::HeightMap;
use surface_stats::clean::{resample, resample_mirrored};
use surface_stats::spectrum::Window;
use surface_stats::{Boundary, StatsError};

/// Rms jump across the seam over that between neighbours inside, above which a map does not repeat.
const SEAM: f64 = 2.0;

/// Whether opposite edges meet: the jump across them is of the size of those inside.
pub fn repeats(map: &HeightMap) -> bool {
    seam(map) <= SEAM
}

/// The window under which the waves of a map are looked at: none if it repeats; or the jump at its
/// edges would count as waves.
pub(crate) fn window_for(repeats: bool) -> Window {
    if repeats { Window::None } else { Window::Hann }
}

/// Rms jump between opposite edges over that between neighbours inside, the larger of the two axes.
fn seam(map: &HeightMap) -> f64 {
    let [ny, nx] = map.grid().shape();
    let (mut across, mut inside) = ([0.0; 2], [0.0; 2]);
    for iy in 0..ny {
        for ix in 0..nx {
            let here = map.at(iy, ix);
            let down = (map.at((iy + 1) % ny, ix) - here).powi(2);
            let right = (map.at(iy, (ix + 1) % nx) - here).powi(2);
            let sums = if iy + 1 == ny { &mut across } else { &mut inside };
            sums[0] += down / if iy + 1 == ny { 1.0 } else { (ny - 1) as f64 };
            let sums = if ix + 1 == nx { &mut across } else { &mut inside };
            sums[1] += right / if ix + 1 == nx { 1.0 } else { (nx - 1) as f64 };
        }
    }
    let ratio = |axis: usize| {
        if inside[axis] > 0.0 { (across[axis] / inside[axis]).sqrt() } else { 0.0 }
    };
    ratio(0).max(ratio(1))
}

/// The map on `shape` points: by its waves if it repeats, by its cosines otherwise, so that the jump
/// at its edges does not ring.
///
/// # Errors
/// [`StatsError`].
pub fn regrid(map: &HeightMap, shape: [usize; 2], repeats: bool) -> Result<HeightMap, StatsError> {
    if repeats { resample(map, shape, Boundary::Periodic) } else { resample_mirrored(map, shape) }
}
