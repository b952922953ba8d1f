//! The constants, as `cargo xtask equation` fits and rounds them (the book, "The equation").

/// How many constants the law for numbers has.
pub const NUMBER_TERMS: usize = 5;
/// How many the law for a map has.
pub const MAP_TERMS: usize = 13;

/// Of the law for numbers, in the order of [`number_terms`](super::number_terms).
pub(super) const NUMBERS: [f64; NUMBER_TERMS] = [0.401, -0.651, 0.346, -0.027, 0.027];

/// Of the law for a map, in the order of [`map_terms`](super::map_terms).
pub(super) const MAP: [f64; MAP_TERMS] =
    [0.38, -0.499, 0.122, -0.041, 0.062, -1.091, 1.233, -1.369, 1.766, -1.541, 0.095, 0.04, -0.058];

/// Of the half width of the interval for numbers, in the order of [`numbers_spread`](super::interval).
pub(super) const NUMBERS_SPREAD: [f64; super::INTERVAL_TERMS] =
    [0.05, 0.247, 0.0, 0.0, 0.0, 0.0, 0.0];
/// Of that for a map.
pub(super) const MAP_SPREAD: [f64; super::INTERVAL_TERMS] =
    [0.045, 0.055, 0.0, 0.377, 0.985, 0.041, 0.11];

/// Bandwidths the laws were fitted on, with some room \[-\].
pub(super) const BANDWIDTH: [f64; 2] = [1.5, 150.0];
/// Beyond these the bandwidth counts as the nearer of them.
pub(super) const BANDWIDTH_USED: [f64; 2] = [1.5, 1000.0];
/// Above this rms gradient a half-space with small slopes is no longer meant.
pub(super) const STEEP: f64 = 1.0;
/// Areas the laws were fitted on.
pub(super) const AREA: [f64; 2] = [0.001, 0.995];
