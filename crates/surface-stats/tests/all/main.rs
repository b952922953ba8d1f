//! Statistics, against reference values and at the ends of their ranges. One program of tests, which is linked once.

#![allow(clippy::unwrap_used, reason = "a check that cannot be made has failed")]

mod cases;
mod extremes;
mod pair;
mod reference;
#[cfg(feature = "serde")]
mod serde;
mod synthesis;
mod warnings;

use contact_types::Grid;
use surface_stats::synthesis::{Scale, SelfAffine};

/// Points 1 µm apart with H = 0.8 and an rms height of 0.5 µm, by shape and by roll-off and cut-off (µm).
fn recipe(shape: [usize; 2], [rolloff, cutoff]: [f64; 2]) -> SelfAffine {
    SelfAffine {
        grid: Grid::new(shape, [1e-6, 1e-6]).unwrap(),
        hurst: 0.8,
        rolloff: 1e-6 * rolloff,
        cutoff: 1e-6 * cutoff,
        scale: Scale::RmsHeight(0.5e-6),
        seed: 1,
        quantise: None,
    }
}
