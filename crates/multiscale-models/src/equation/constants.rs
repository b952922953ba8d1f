//! The constants, as `cargo xtask equation` fits and rounds them (the book, "The equation").

/// How many constants the law for numbers has.
pub const NUMBER_TERMS: usize = 5;
/// How many the law for a map has.
pub const MAP_TERMS: usize = 16;

/// Of the law for numbers, in the order of [`number_terms`](super::number_terms).
pub(super) const NUMBERS: [f64; NUMBER_TERMS] = [0.448, -0.363, -0.057, -0.03, 0.034];

/// Of the law for a map, in the order of [`map_terms`](super::map_terms).
pub(super) const MAP: [f64; MAP_TERMS] = [
    0.33, -0.243, -0.027, -0.616, 0.489, -0.429, -0.308, 0.121, 0.193, -1.416, 1.331, -0.865,
    0.108, -0.415, -0.049, 0.035,
];

/// Of the half width of the interval for numbers: floor and chance.
pub(super) const NUMBERS_SPREAD: [f64; 2] = [0.001, 0.405];
/// Of that for a map, in the logarithm of the load.
pub(super) const MAP_SPREAD: [f64; super::INTERVAL_TERMS] =
    [0.045, 0.032, 0.214, 0.587, 1.416, 0.992, 0.179];

/// Bandwidths the laws were fitted on, with some room \[-\].
pub(super) const BANDWIDTH: [f64; 2] = [1.5, 150.0];
/// Beyond these the bandwidth counts as the nearer of them.
pub(super) const BANDWIDTH_USED: [f64; 2] = [1.5, 1000.0];
/// Above this rms gradient a half-space with small slopes is no longer meant.
pub(super) const STEEP: f64 = 1.0;
/// Areas the laws were fitted on.
pub(super) const AREA: [f64; 2] = [0.001, 0.995];
