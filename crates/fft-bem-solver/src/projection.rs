//! The nearest pressure that is nowhere negative and carries the load.

use crate::{Real, fields};

/// Replaces `field` by `max(field + c, 0)` with the `c` that gives it the mean `load`: its
/// projection on the admissible pressures.
///
/// The load carried is a convex, piecewise linear function of `c`; Newton's method from the side
/// where too much is carried follows it to the end in a few passes. It is there when a step leaves
/// the carrying pixels as they were: on one piece the step is exact.
pub(crate) fn onto_admissible<T: Real>(field: &mut [T], load: f64) {
    let n = field.len();
    let total = load * n as f64;
    let (mut shift, mut before) = (0.0, f64::INFINITY);
    let mut found = fields::positive_part(field, shift);
    if found[0] < total {
        // Everything positive at this shift carries at least the total.
        shift = load - fields::sum(field) / n as f64;
        found = fields::positive_part(field, shift);
    }
    // Fewer pixels from step to step, so that this ends.
    while found[1] > 0.0 && found[1] < before {
        before = found[1];
        shift -= (found[0] - total) / before;
        found = fields::positive_part(field, shift);
    }
    let scale = if found[0] > 0.0 { total / found[0] } else { 1.0 }; // rounding
    fields::write(field, |_, p| T::of((p.wide() + shift).max(0.0) * scale));
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// The conditions that single out a projection: admissible, and what was taken from the
        /// carrying pixels is the same everywhere and at least what the others lacked.
        #[test]
        fn is_the_nearest_admissible_field(
            field in prop::collection::vec(-1e3..1e3f64, 1..60), load in 1e-6..1e3f64,
        ) {
            let mut projected = field.clone();
            onto_admissible(&mut projected, load);
            let n = field.len() as f64;
            let mean = projected.iter().sum::<f64>() / n;
            prop_assert!((mean - load).abs() <= 1e-12 * load);
            let size = 1e3 + load * n;
            let shifts = || projected.iter().zip(&field).filter(|(p, _)| **p > 0.0).map(|(p, x)| p - x);
            let shift = shifts().next().unwrap();
            prop_assert!(shifts().all(|s| (s - shift).abs() < 1e-12 * size));
            for (p, x) in projected.iter().zip(&field) {
                prop_assert!(*p > 0.0 || x + shift <= 1e-12 * size);
            }
        }
    }
}
