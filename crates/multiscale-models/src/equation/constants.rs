//! The constants, as `cargo xtask equation` fits and rounds them (the book, "The equation").

/// How many constants the law for numbers has.
pub const NUMBER_TERMS: usize = 5;
/// How many the law for a map has.
pub const MAP_TERMS: usize = 24;

/// Of the law for numbers, in the order of [`number_terms`](super::number_terms).
pub(super) const NUMBERS: [f64; NUMBER_TERMS] = [0.445, -0.357, -0.059, -0.029, 0.032];

/// Of the law for a map, in the order of [`map_terms`](super::map_terms).
pub(super) const MAP: [f64; MAP_TERMS] = [
    0.238, -0.121, -0.029, -0.213, -0.631, 0.758, -0.733, -1.395, -0.823, 0.659, -0.487, 0.371,
    0.617, 0.213, -0.275, -0.193, -0.55, -0.855, 0.263, -0.762, -2.189, 2.454, -2.566, 2.192,
];

/// Of the half width of the interval for numbers: floor and chance.
pub(super) const NUMBERS_SPREAD: [f64; 2] = [0.002, 0.384];
/// Of that for a map, in the logarithm of the load.
pub(super) const MAP_SPREAD: [f64; super::INTERVAL_TERMS] =
    [0.065, 0.047, 0.161, 1.019, 1.573, 0.181, 1.019, 0.808];

/// Bandwidths the laws were fitted on, with some room \[-\].
pub(super) const BANDWIDTH: [f64; 2] = [1.5, 150.0];
/// Beyond these the bandwidth counts as the nearer of them.
pub(super) const BANDWIDTH_USED: [f64; 2] = [1.5, 1000.0];
/// Above this rms gradient a half-space with small slopes is no longer meant.
pub(super) const STEEP: f64 = 1.0;
/// Areas the laws were fitted on.
pub(super) const AREA: [f64; 2] = [0.001, 0.995];
