//! The study as a whole. One program of tests, which is linked once.

#![allow(clippy::unwrap_used, reason = "a check that cannot be made has failed")]

use contact_types::{Grid, HeightMap};
use surface_stats::synthesis::{Scale, SelfAffine};

mod mirrored;
mod pair;
mod persson_gap;
mod profiles;
mod yielding;

/// A random surface with an rms gradient of 0.1, its longest and shortest wave (m).
fn rough(grid: Grid, hurst: f64, [rolloff, cutoff]: [f64; 2], seed: u64) -> HeightMap {
    let scale = Scale::RmsGradient(0.1);
    SelfAffine { grid, hurst, rolloff, cutoff, scale, seed, quantise: None }.generate().unwrap()
}
