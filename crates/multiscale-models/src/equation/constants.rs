//! The constants, as `cargo xtask equation` fits and rounds them (the book, "The equation").

/// How many constants the law for numbers has.
pub const NUMBER_TERMS: usize = 5;
/// How many the law for a map has.
pub const MAP_TERMS: usize = 24;

/// Of the law for numbers, in the order of [`number_terms`](super::number_terms).
pub(super) const NUMBERS: [f64; NUMBER_TERMS] = [0.444, -0.356, -0.058, -0.028, 0.031];

/// Of the law for a map, in the order of [`map_terms`](super::map_terms).
pub(super) const MAP: [f64; MAP_TERMS] = [
    0.238, -0.123, -0.029, -0.222, -0.667, 0.797, -0.756, -1.52, -0.828, 0.639, -0.445, 0.355,
    0.628, 0.163, -0.235, -0.184, -0.535, -0.896, 0.253, -0.733, 0.153, -1.612, -1.972, 0.742,
];

/// Of the half width of the interval for numbers: floor and chance.
pub(super) const NUMBERS_SPREAD: [f64; 2] = [0.002, 0.401];
/// Of that for a map, in the logarithm of the load.
pub(super) const MAP_SPREAD: [f64; super::INTERVAL_TERMS] =
    [0.067, 0.051, 0.16, 1.059, 1.219, 0.167, 1.024, 0.857];

/// Bandwidths the laws were fitted on, with some room \[-\].
pub(super) const BANDWIDTH: [f64; 2] = [1.5, 150.0];
/// Beyond these the bandwidth counts as the nearer of them.
pub(super) const BANDWIDTH_USED: [f64; 2] = [1.5, 1000.0];
/// Above this rms gradient a half-space with small slopes is no longer meant.
pub(super) const STEEP: f64 = 1.0;
/// Areas the laws were fitted on.
pub(super) const AREA: [f64; 2] = [0.001, 0.995];
