//! The surface and the load that the measurements of work share.

use contact_types::{Grid, HeightMap};
use std::error::Error;
use surface_stats::synthesis::{Scale, SelfAffine};

/// Mean pressure over E* times the rms gradient \[-\].
pub(crate) const LOAD: f64 = 0.05;

/// H = 0.8 from an eighth of the side of `n` pixels down to 8 pixels, rms gradient 1, unit pixels.
pub(crate) fn surface(n: usize) -> Result<HeightMap, Box<dyn Error>> {
    let recipe = SelfAffine {
        grid: Grid::new([n, n], [1.0, 1.0])?,
        hurst: 0.8,
        rolloff: n as f64 / 8.0,
        cutoff: 8.0,
        scale: Scale::RmsGradient(1.0),
        seed: 1,
        quantise: None,
    };
    Ok(recipe.generate()?)
}
