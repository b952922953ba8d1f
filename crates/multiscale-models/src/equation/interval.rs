//! How far an answer may be from what a solver finds on the same surface.

/// How many constants the half width of the law for a map has.
pub const INTERVAL_TERMS: usize = 8;

/// The chance of few contacts at area `a`, over that at 0.1 %.
pub(super) fn few(a: f64) -> f64 {
    (1e-3 / a.max(1e-4)).sqrt()
}

/// Half width in the logarithm of the law for numbers: a floor and the chance of few contacts, which end with the
/// open area.
pub(super) fn of_numbers(a: f64, [floor, chance]: [f64; 2]) -> f64 {
    (1.0 - a).max(0.0).sqrt() * (floor + chance * few(a))
}

/// The area at a distance of `half` in the logarithm, below and above, at most 1.
pub(super) fn around(area: f64, half: f64) -> [f64; 2] {
    [area * (-half).exp(), (area * half.exp()).min(1.0)]
}
