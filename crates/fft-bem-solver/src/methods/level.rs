//! The level of the flat under a pressure.

use super::ceiling::Ceiling;
use crate::Real;
use crate::row_work::{Partial, sums, total};
use crate::simd::{LANES, four, rest, vectorised};
use fearless_simd::{Select, Simd, SimdBase, SimdFloat, f64x4};

/// The level of the flat: the plain mean of `u - h` over the contact, `p > 0`.
pub(crate) fn level<T: Real>([p, u, h]: [&[T]; 3], partial: &mut [Partial]) -> f64 {
    let of = |from: usize, p: &[T]| {
        let [u, h] = [u, h].map(|x| &x[from..][..p.len()]);
        vectorised!(x => contact_sums(x, p, u, h))
    };
    let [sum, contact] = sums(p, &of, partial);
    sum / contact.max(1.0)
}

/// The same from the [`contact_sums`] of all pieces.
pub(super) fn mean_of_sums(partial: &[Partial]) -> f64 {
    let [sum, contact] = total(partial);
    sum / contact.max(1.0)
}

/// Sum over the contact (`p > 0`) of `u - h`, and its number of nodes.
#[inline(always)]
pub(super) fn contact_sums<S: Simd, T: Real>(vectors: S, p: &[T], u: &[T], h: &[T]) -> Partial {
    let [sum, count] = contact_sums_by_fours(vectors, p, u, h);
    let [more, others] = contact_sums_by_fours(vectors, &rest(p), &rest(u), &rest(h));
    [sum + more, count + others, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
}

#[inline(always)]
fn contact_sums_by_fours<S: Simd, T: Real>(vectors: S, p: &[T], u: &[T], h: &[T]) -> [f64; 2] {
    let (zero, one) = (f64x4::splat(vectors, 0.0), f64x4::splat(vectors, 1.0));
    let (mut sum, mut count) = (zero, zero);
    for i in (0..p.len() - p.len() % LANES).step_by(LANES) {
        let is_contact = T::widened(four(vectors, p, i)).simd_gt(zero);
        let rise = T::widened(four(vectors, u, i) - four(vectors, h, i));
        sum += is_contact.select(rise, zero);
        count += is_contact.select(one, zero);
    }
    [sum.iter().sum(), count.iter().sum()]
}

/// Most steps of the search below; a few are enough.
const NEWTON_STEPS: usize = 60;

/// The level of the flat under a pressure with a ceiling: that at which the gap has no mean over the
/// nodes that have still to give way, those between the bounds, those at the ceiling that stand off and
/// those without load that overlap. Where there is none, any level is right that parts the loaded from
/// the others, and this one does. By Newton's method.
pub(crate) fn level_under<T: Real, C: Ceiling<T>>(
    ceiling: C,
    [p, u, h]: [&[T]; 3],
    partial: &mut [Partial],
) -> f64 {
    // Sums over the nodes that have still to give way, and over those at the ceiling.
    let mut rises = |level: Option<f64>| -> [f64; 4] {
        let of = |from: usize, p: &[T]| {
            let fields = u[from..].iter().zip(&h[from..]);
            vectorised!(_vectors => {
                let (mut sum, mut count, mut full, mut its_sum) = (0.0, 0.0, 0.0, 0.0);
                for (p, (u, h)) in p.iter().zip(fields.clone()) {
                    let rise = (*u - *h).wide();
                    let (is_loaded, is_full) = (*p > T::zero(), ceiling.is_reached(*p));
                    let counts = match level {
                        Some(level) if !is_loaded => rise < level,
                        Some(level) if is_full => rise > level,
                        _ => is_loaded & !is_full,
                    };
                    sum += if counts { rise } else { 0.0 };
                    count += f64::from(u8::from(counts));
                    its_sum += if is_full { rise } else { 0.0 };
                    full += f64::from(u8::from(is_full));
                }
                [sum, count, its_sum, full, 0.0, 0.0, 0.0, 0.0]
            })
        };
        sums(p, &of, partial)
    };
    let [sum, count, full_sum, full] = rises(None);
    let mut level = if count > 0.0 { sum / count } else { full_sum / full.max(1.0) };
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    for _ in 0..NEWTON_STEPS {
        let [sum, count, ..] = rises(Some(level));
        if count <= 0.0 {
            break;
        }
        let next = sum / count;
        if next > level {
            low = level;
        } else if next < level {
            high = level;
        } else {
            break;
        }
        level = if next > low && next < high { next } else { 0.5 * (low + high) };
    }
    level
}
