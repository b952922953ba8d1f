//! The constants, as `cargo xtask equation` fits and rounds them (the book, "The equation").

/// How many constants the law for numbers has.
pub const NUMBER_TERMS: usize = 5;
/// How many the law for a map has.
pub const MAP_TERMS: usize = 17;

/// Of the law for numbers, in the order of [`number_terms`](super::number_terms).
pub(super) const NUMBERS: [f64; NUMBER_TERMS] = [0.445, -0.358, -0.057, -0.029, 0.033];

/// Of the law for a map, in the order of [`map_terms`](super::map_terms).
pub(super) const MAP: [f64; MAP_TERMS] = [
    0.352, -0.258, -0.027, -0.794, 0.693, -0.249, -0.359, 0.133, -1.243, 1.509, -1.057, 0.699,
    0.083, -0.552, -0.039, -0.904, 0.035,
];

/// Of the half width of the interval for numbers: floor and chance.
pub(super) const NUMBERS_SPREAD: [f64; 2] = [0.001, 0.406];
/// Of that for a map, in the logarithm of the load.
pub(super) const MAP_SPREAD: [f64; super::INTERVAL_TERMS] =
    [0.031, 0.03, 0.245, 0.659, 2.001, 0.591, 0.219];

/// Bandwidths the laws were fitted on, with some room \[-\].
pub(super) const BANDWIDTH: [f64; 2] = [1.5, 150.0];
/// Beyond these the bandwidth counts as the nearer of them.
pub(super) const BANDWIDTH_USED: [f64; 2] = [1.5, 1000.0];
/// Above this rms gradient a half-space with small slopes is no longer meant.
pub(super) const STEEP: f64 = 1.0;
/// Areas the laws were fitted on.
pub(super) const AREA: [f64; 2] = [0.001, 0.995];
