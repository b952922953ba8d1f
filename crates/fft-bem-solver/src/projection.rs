//! The nearest pressure that is nowhere negative and carries the load.

use crate::simd::{LANES, four, vectorised};
use crate::{Real, fields};
use fearless_simd::{Select, SimdBase, SimdFloat, f64x4};
use std::ops::Range;

/// Replaces `field` by `max(field + c, 0)` with the `c` that gives it the mean `load`: its
/// projection on the admissible pressures.
///
/// The load carried is a convex, piecewise linear function of `c`: Newton's method from the side where too much is
/// carried, until a step leaves the carrying pixels as they were.
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

/// Replaces `field` by `max(field + c, 0)`, no larger than `ceiling`, with the `c` that gives it the mean
/// `load`, at most `ceiling`: its projection on the pressures between 0 and that.
///
/// The load carried rises with `c`, piecewise linearly: Newton's method, and bisection where it would leave
/// the bracket.
pub(crate) fn between<T: Real>(field: &mut [T], load: f64, ceiling: T) {
    let total = load * field.len() as f64;
    let top = ceiling.wide();
    let mut low = -fields::max(field);
    let mut high = top - fields::min(field);
    let mut shift = low.max(0.0).min(high);
    for _ in 0..MOST_STEPS {
        let [full, sum, free] = cut(field, [1.0, shift], top);
        let carried = full + sum + free * shift;
        if carried > total {
            high = shift;
        } else {
            low = shift;
        }
        let newton = shift - (carried - total) / free;
        if (carried - total).abs() <= f64::EPSILON * total {
            break;
        }
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        // On one piece the step is exact; where nothing is free, a jump is all there is.
        if (next - shift).abs() <= f64::EPSILON * (shift.abs() + f64::EPSILON * top) {
            break;
        }
        shift = next;
    }
    fields::write(field, |_, p| T::of((p.wide() + shift).clamp(0.0, top)));
    scale_below(field, total, ceiling, 1.0); // rounding
}

/// Most steps of a search for the shift or the factor that carries a load.
const MOST_STEPS: usize = 200;

/// Of `factor field + shift`, cut to the bounds: what the nodes at the ceiling carry, the sum of the field over those between
/// the bounds, and their number.
fn cut<T: Real>(field: &[T], [factor, shift]: [f64; 2], top: f64) -> [f64; 3] {
    let piece = |range: Range<usize>| {
        let field = &field[range];
        let whole = field.len() - field.len() % LANES;
        vectorised!(x => {
            let [zero, one, most] = [0.0, 1.0, top].map(|value| f64x4::splat(x, value));
            let [mut full, mut sum, mut free] = [zero; 3];
            for i in (0..whole).step_by(LANES) {
                let p = T::widened(four(x, field, i));
                let moved = p * factor + shift;
                let (is_below, is_loaded) = (moved.simd_lt(most), moved.simd_gt(zero));
                full += is_below.select(zero, most);
                sum += is_below.select(is_loaded.select(p, zero), zero);
                free += is_below.select(is_loaded.select(one, zero), zero);
            }
            let mut sums = [full, sum, free].map(|lanes| lanes.iter().sum());
            for p in &field[whole..] {
                let moved = p.wide() * factor + shift;
                let [full, sum, free] = &mut sums;
                if moved >= top {
                    *full += top;
                } else if moved > 0.0 {
                    (*sum, *free) = (*sum + p.wide(), *free + 1.0);
                }
            }
            sums
        })
    };
    let add = |a: [f64; 3], b: [f64; 3]| [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
    fields::by_blocks(0..field.len(), &piece, &add)
}

/// Multiplies the nodes below `ceiling` by the factor that lets all carry `total`; those that would come above
/// it stay there. False, and nothing done, if no factor within `most` of 1 does.
pub(crate) fn scale_below<T: Real>(field: &mut [T], total: f64, ceiling: T, most: f64) -> bool {
    let top = ceiling.wide();
    let mut factor = 1.0;
    for _ in 0..MOST_STEPS {
        // What is at the ceiling stays there.
        let [full, free, _] = cut(field, [f64::max(factor, 1.0), 0.0], top);
        let next = (total - full) / free;
        if !(next >= 1.0 - most && next <= 1.0 + most) {
            // Nothing to scale, and nothing lacks.
            return free <= 0.0 && (total - full).abs() <= 1e-9 * top;
        }
        let is_same = (next - factor).abs() <= f64::EPSILON;
        factor = next;
        if is_same {
            break;
        }
    }
    fields::write(field, |_, p| {
        let scaled = p.wide() * factor;
        if p.wide() >= top || scaled >= top { ceiling } else { T::of(scaled) }
    });
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// The conditions that single out a projection: within the bounds, and one shift serves. What was added to
        /// the nodes between the bounds is the same everywhere, no more than those at 0 lacked and no less than
        /// those at the ceiling, if there is one, had too little.
        #[test]
        fn is_the_nearest_admissible_field(
            field in prop::collection::vec(-1e3..1e3f64, 1..60),
            ceiling in prop_oneof![1e-3..1e3f64, Just(f64::INFINITY)],
            part in 1e-6..1.0f64,
        ) {
            let mut projected = field.clone();
            let load = part * ceiling.min(1e3);
            if ceiling.is_finite() {
                between(&mut projected, load, ceiling);
            } else {
                onto_admissible(&mut projected, load);
            }
            let mean = projected.iter().sum::<f64>() / field.len() as f64;
            prop_assert!((mean - load).abs() <= 1e-12 * ceiling.min(1e3), "{mean} and {load}");
            let (mut least, mut most) = (f64::NEG_INFINITY, f64::INFINITY);
            for (p, x) in projected.iter().zip(&field) {
                prop_assert!((0.0..=ceiling).contains(p));
                if *p > 0.0 {
                    least = least.max(p - x);
                }
                if *p < ceiling {
                    most = most.min(p - x);
                }
            }
            prop_assert!(least <= most + 1e-9, "{least} and {most}");
        }
    }
}
