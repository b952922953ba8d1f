//! Projection on the pressures that are positive and carry the load.

use crate::{Real, fields};

/// Replaces `v` by `max(v + c, 0)`, with `c` such that the mean is `load`: the nearest field that
/// is nowhere negative and has this mean. Newton's method from above is exact in a few steps.
pub(crate) fn to_load<T: Real>(v: &mut [T], load: f64) {
    let total = load * v.len() as f64;
    let mut c = (total - fields::sum_of(v.len(), |i| v[i].wide().max(0.0))) / v.len() as f64;
    for _ in 0..60 {
        let positive = |i: usize| v[i].wide() + c > 0.0;
        let count = fields::sum_of(v.len(), |i| if positive(i) { 1.0 } else { 0.0 });
        let sum = fields::sum_of(v.len(), |i| (v[i].wide() + c).max(0.0));
        let change = if count > 0.0 {
            (total - sum) / count
        } else {
            total / v.len() as f64 - fields::max(v) - c
        };
        c += change;
        if change.abs() * count.max(1.0) <= 1e-15 * total {
            break;
        }
    }
    for x in v.iter_mut() {
        *x = T::of((x.wide() + c).max(0.0));
    }
    let scale = T::of(total / fields::sum(v));
    for x in v.iter_mut() {
        *x *= scale;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Positive, of the right mean, and no feasible field is nearer: `<v - x, y - x> <= 0` for
        /// every feasible y, of which the corners (all load on one node) suffice.
        #[test]
        fn is_the_nearest_feasible_field(
            v in prop::collection::vec(-5.0..5.0_f64, 1..40), load in 1e-3..1e3_f64,
        ) {
            let n = v.len();
            let mut x = v.clone();
            to_load(&mut x, load);
            prop_assert!((x.iter().sum::<f64>() / n as f64 / load - 1.0).abs() < 1e-12);
            prop_assert!(x.iter().all(|x| *x >= 0.0));
            for corner in 0..n {
                let y = |i: usize| if i == corner { load * n as f64 } else { 0.0 };
                let product: f64 = (0..n).map(|i| (v[i] - x[i]) * (y(i) - x[i])).sum();
                prop_assert!(product <= 1e-9 * (load * n as f64 + 5.0).powi(2));
            }
        }
    }
}
