//! How far an answer may be from what a solver finds on the same surface.

/// How many constants a half width has.
pub const INTERVAL_TERMS: usize = 7;

/// What the constants of a half width multiply, at area `a`: a floor and the chance of few contacts,
/// which end with the open area; and, as they move the answer, the slope of the highest part, its evenness,
/// the flattened part, the lay, and how unlike its parts the whole map is.
pub(super) fn terms(a: f64, moved: [f64; 5]) -> [f64; INTERVAL_TERMS] {
    let open = (1.0 - a).max(0.0).sqrt();
    let few = (1e-3 / a.max(1e-4)).sqrt();
    let [slope, even, flat, lay, unlike] = moved.map(|m| open * m.abs());
    [open, open * few, slope, even, flat, lay, unlike]
}

/// The area at a distance of `half` in the logarithm, below and above, at most 1.
pub(super) fn around(area: f64, half: f64) -> [f64; 2] {
    [area * (-half).exp(), (area * half.exp()).min(1.0)]
}
