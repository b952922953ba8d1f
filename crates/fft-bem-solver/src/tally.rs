//! What an answer says of its fields, taken in one pass: sums, extremes, means over blocks.
//! In the scaled units of the iteration, block row by block row: in an order that does not depend on the threads.

use crate::methods::Ceiling;
use crate::simd::{LANES, four, rest, vectorised};
use crate::{Boundary, Real};
use fearless_simd::{Select, Simd, SimdBase, SimdFloat, f64x4};
use grid_fft::parallel::prelude::*;
use std::ops::Range;

/// Sums of, in this order (*full* pixels are those at the ceiling, whose overlap was flattened),
/// - the pressure of the pixels that are not full;
/// - pixels that carry pressure, and those of them that are full;
/// - `p u`;
/// - `p |g|`, of the full only where they stand off;
/// - `p g`; under a ceiling H, `p max(g, 0) + (H - p) max(-g, 0)`;
/// - the gap: 0 where it is closed, which all of the contact is under a free boundary, and the full anywhere;
///
/// and least gap, of the full 0, and largest pressure.
type Tally = ([f64; 7], [f64; 2]);

const NO_EXTREMES: [f64; 2] = [f64::INFINITY, f64::NEG_INFINITY];

/// Pixels of block `block` of so many along an axis of `n`.
pub(crate) fn pixels(block: usize, blocks: usize, n: usize) -> Range<usize> {
    (block * n).div_ceil(blocks)..((block + 1) * n).div_ceil(blocks)
}

/// Goes through pressure, displacement and heights, of `ny` rows of `nx`; the gap is `u - h - level`. Writes the mean
/// gap of each block to `means`, of which there are `[by, bx]`; in contact it counts as 0.
pub(crate) fn tally<T: Real, C: Ceiling<T>>(
    ceiling: C,
    fields: [&[T]; 3],
    level: f64,
    boundary: Boundary,
    [ny, nx]: [usize; 2],
    [by, bx]: [usize; 2],
    means: &mut [f64],
) -> Tally {
    let mut rows = vec![([0.0; 7], NO_EXTREMES); by];
    let blocks = rows.par_iter_mut().zip(means.par_chunks_mut(bx)).enumerate();
    blocks.for_each(|(block, (row, means))| {
        let lines = pixels(block, by, ny);
        let is_free = boundary == Boundary::Free;
        let all = lines.clone();
        *row = vectorised!(x => block_row(x, ceiling, fields, level, is_free, nx, all, means));
        for (column, mean) in means.iter_mut().enumerate() {
            *mean /= (lines.len() * pixels(column, bx, nx).len()) as f64;
        }
    });
    let (mut sums, mut extremes) = ([0.0; 7], NO_EXTREMES);
    for (more, [lowest, largest]) in rows {
        sums.iter_mut().zip(more).for_each(|(sum, x)| *sum += x);
        extremes = [extremes[0].min(lowest), extremes[1].max(largest)];
    }
    (sums, extremes)
}

/// The rows `lines`; adds the gap beside the contact to each block.
#[inline(always)]
#[allow(clippy::inline_always, reason = "inner loops belong to each version of `vectorised!`")]
#[allow(clippy::too_many_arguments, reason = "a pass over three fields")]
fn block_row<S: Simd, T: Real, C: Ceiling<T>>(
    x: S,
    ceiling: C,
    fields: [&[T]; 3],
    level: f64,
    is_free: bool,
    nx: usize,
    lines: Range<usize>,
    blocks: &mut [f64],
) -> Tally {
    let (zero, one) = (f64x4::splat(x, 0.0), f64x4::splat(x, 1.0));
    let positive = |a: f64x4<S>| a.simd_gt(zero).select(a, zero);
    let mut sums = [zero; 7];
    let [mut lowest, mut largest] = NO_EXTREMES.map(|none| f64x4::splat(x, none));
    blocks.fill(0.0);
    let count = blocks.len();
    for iy in lines {
        for (column, block) in blocks.iter_mut().enumerate() {
            let piece = pixels(column, count, nx);
            let piece = iy * nx + piece.start..iy * nx + piece.end;
            let mut sum = zero;
            for i in piece.clone().step_by(LANES) {
                let left = piece.end - i;
                let [p, u, h] = fields.map(|field| {
                    let field = &field[i..piece.end];
                    T::widened(if left < LANES {
                        four(x, &rest(field), 0)
                    } else {
                        four(x, field, 0)
                    })
                });
                let mut gap = u - h - f64x4::splat(x, level);
                if left < LANES {
                    // Behind the last pixel there are zeros.
                    let exists = [0, 1, 2, 3].map(|lane| if lane < left { 1.0 } else { 0.0 });
                    gap = f64x4::from_slice(x, &exists).simd_gt(zero).select(gap, zero);
                }
                let is_on = p.simd_gt(zero);
                let (open, overlap) = (positive(gap), positive(-gap));
                sum += is_on.select(zero, open);
                let mut counted = if is_free { is_on.select(zero, gap) } else { gap };
                let (mut below, mut off) = (p, open + overlap);
                let (mut least, mut bound) = (gap, p * gap);
                let [load, contact, full, work, complementarity, duality, mean] = &mut sums;
                if C::IS_FINITE {
                    let top = f64x4::splat(x, ceiling.top().wide());
                    let is_full = p.simd_ge(top);
                    below = is_full.select(zero, p);
                    off = is_full.select(open, off);
                    least = is_full.select(zero, gap);
                    counted = is_full.select(zero, counted);
                    bound = p * open + (top - p) * overlap;
                    // The zeros behind the last pixel are not full, whatever H is.
                    *full += is_on.select(is_full.select(one, zero), zero);
                }
                *load += below;
                *contact += is_on.select(one, zero);
                *work += p * u;
                *complementarity += p * off;
                *duality += bound;
                *mean += counted;
                lowest = least.simd_lt(lowest).select(least, lowest);
                largest = p.simd_gt(largest).select(p, largest);
            }
            *block += sum.iter().sum::<f64>();
        }
    }
    let least = lowest.iter().copied().fold(f64::INFINITY, f64::min);
    let most = largest.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    (sums.map(|lanes| lanes.iter().sum()), [least, most])
}
