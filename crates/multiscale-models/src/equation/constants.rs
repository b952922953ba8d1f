//! The constants, as `cargo xtask equation` fits and rounds them (the book, "The equation").

/// How many constants the law for numbers has.
pub const NUMBER_TERMS: usize = 5;
/// How many the law for a map has.
pub const MAP_TERMS: usize = 13;

/// Of the law for numbers, in the order of [`number_terms`](super::number_terms).
pub(super) const NUMBERS: [f64; NUMBER_TERMS] = [0.403, -0.656, 0.352, -0.028, 0.027];

/// Of the law for a map, in the order of [`map_terms`](super::map_terms).
pub(super) const MAP: [f64; MAP_TERMS] = [
    0.444, -0.635, 0.264, -0.04, 0.04, -1.037, 0.638, 0.057, -0.012, -0.142, -0.176, -0.392, 0.761,
];

/// Of the half width of the interval for numbers, in the order of [`numbers_spread`](super::interval).
pub(super) const NUMBERS_SPREAD: [f64; super::INTERVAL_TERMS] = [0.05, 0.247, 0.0, 0.0, 0.0, 0.0];
/// Of that for a map.
pub(super) const MAP_SPREAD: [f64; super::INTERVAL_TERMS] =
    [0.062, 0.024, 0.023, 0.062, 0.108, 0.079];

/// Bandwidths the laws were fitted on, with some room \[-\].
pub(super) const BANDWIDTH: [f64; 2] = [1.5, 150.0];
/// Beyond these the bandwidth counts as the nearer of them.
pub(super) const BANDWIDTH_USED: [f64; 2] = [1.5, 1000.0];
/// Above this rms gradient a half-space with small slopes is no longer meant.
pub(super) const STEEP: f64 = 1.0;
/// Areas the laws were fitted on.
pub(super) const AREA: [f64; 2] = [0.001, 0.995];
