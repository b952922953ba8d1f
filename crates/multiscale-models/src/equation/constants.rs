//! The constants, as `cargo xtask equation` fits and rounds them (the book, "The equation").

/// How many constants the law for numbers has.
pub const NUMBER_TERMS: usize = 5;
/// How many the law for a map has.
pub const MAP_TERMS: usize = 20;

/// Of the law for numbers, in the order of [`number_terms`](super::number_terms).
pub(super) const NUMBERS: [f64; NUMBER_TERMS] = [0.446, -0.36, -0.059, -0.029, 0.034];

/// Of the law for a map, in the order of [`map_terms`](super::map_terms).
pub(super) const MAP: [f64; MAP_TERMS] = [
    0.233, -0.127, -0.025, -0.585, -0.887, 1.292, -0.301, 0.546, -0.711, -1.37, 0.643, -0.443,
    0.395, 0.791, -0.12, -0.15, -0.146, -2.013, 0.264, -0.664,
];

/// Of the half width of the interval for numbers: floor and chance.
pub(super) const NUMBERS_SPREAD: [f64; 2] = [0.002, 0.391];
/// Of that for a map, in the logarithm of the load.
pub(super) const MAP_SPREAD: [f64; super::INTERVAL_TERMS] =
    [0.042, 0.068, 0.163, 1.288, 0.876, 0.13, 0.819, 0.83];

/// Bandwidths the laws were fitted on, with some room \[-\].
pub(super) const BANDWIDTH: [f64; 2] = [1.5, 150.0];
/// Beyond these the bandwidth counts as the nearer of them.
pub(super) const BANDWIDTH_USED: [f64; 2] = [1.5, 1000.0];
/// Above this rms gradient a half-space with small slopes is no longer meant.
pub(super) const STEEP: f64 = 1.0;
/// Areas the laws were fitted on.
pub(super) const AREA: [f64; 2] = [0.001, 0.995];
