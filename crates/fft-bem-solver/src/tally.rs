//! What an answer says of its fields, taken in one pass: sums, extremes, means over blocks.
//!
//! In the scaled units of the iteration. Every sum is made block row by block row, in an order that does not
//! depend on the number of threads.

use crate::methods::Ceiling;
use crate::simd::{LANES, four, rest, vectorised};
use crate::{Boundary, Real};
use fearless_simd::{Select, Simd, SimdBase, SimdFloat, f64x4};
use grid_fft::parallel::prelude::*;
use std::ops::Range;

/// Pressure, displacement and heights with the level of the flat: the gap is `u - h - level`.
#[derive(Clone, Copy)]
pub(crate) struct AnswerFields<'a, T> {
    pub(crate) pressure: &'a [T],
    pub(crate) displacement: &'a [T],
    pub(crate) heights: &'a [T],
    pub(crate) level: f64,
}

/// Sums and extremes. *Full* pixels are those at the ceiling, whose overlap is what was flattened.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Tally {
    /// Sum of the pressure of the pixels that are not full.
    pub(crate) load: f64,
    /// Pixels that carry pressure, and those of them that are full.
    pub(crate) contact: f64,
    pub(crate) full: f64,
    /// Sum of the pressure of the full.
    pub(crate) borne: f64,
    /// `<p, u>`.
    pub(crate) work: f64,
    /// Sum of `p |g|`; of the full only where they stand off.
    pub(crate) complementarity: f64,
    /// Sum of `p g`; under a ceiling H, of `p max(g, 0) + (H - p) max(-g, 0)`.
    pub(crate) duality: f64,
    /// Sum of the gap: 0 where it is closed, which all of the contact is under a free boundary, and the full
    /// anywhere.
    pub(crate) open: f64,
    /// Sum of the depths by which the full are flattened.
    pub(crate) depth: f64,
    /// Least gap, of the full 0; largest `|u|`; largest pressure.
    pub(crate) lowest: f64,
    pub(crate) highest: f64,
    pub(crate) largest: f64,
}

/// Least gap, largest `|u|` and largest pressure of no pixel.
const NO_EXTREMES: [f64; 3] = [f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];

/// The same in lanes.
struct Lanes<S: Simd> {
    sums: [f64x4<S>; 9],
    lowest: f64x4<S>,
    highest: f64x4<S>,
    largest: f64x4<S>,
}

/// Pixels of block `block` of so many along an axis of `n`.
pub(crate) fn pixels(block: usize, blocks: usize, n: usize) -> Range<usize> {
    (block * n).div_ceil(blocks)..((block + 1) * n).div_ceil(blocks)
}

/// Goes through the fields, of `ny` rows of `nx`. Writes the mean gap of each block to `means`, of which there are
/// `[by, bx]`; in contact it counts as 0.
pub(crate) fn tally<T: Real, C: Ceiling<T>>(
    ceiling: C,
    fields: AnswerFields<'_, T>,
    boundary: Boundary,
    [ny, nx]: [usize; 2],
    [by, bx]: [usize; 2],
    means: &mut [f64],
) -> Tally {
    let mut rows = vec![([0.0; 9], NO_EXTREMES); by];
    rows.par_iter_mut().zip(means.par_chunks_mut(bx)).enumerate().for_each(
        |(block, (row, means))| {
            let lines = pixels(block, by, ny);
            *row =
                vectorised!(x => block_row(x, ceiling, fields, boundary, nx, lines.clone(), means));
            for (column, mean) in means.iter_mut().enumerate() {
                *mean /= (lines.len() * pixels(column, bx, nx).len()) as f64;
            }
        },
    );
    let (mut sums, mut extremes) = ([0.0; 9], NO_EXTREMES);
    for (more, [lowest, highest, largest]) in rows {
        sums.iter_mut().zip(more).for_each(|(sum, x)| *sum += x);
        extremes = [extremes[0].min(lowest), extremes[1].max(highest), extremes[2].max(largest)];
    }
    let [load, contact, full, borne, work, complementarity, duality, open, depth] = sums;
    let [lowest, highest, largest] = extremes;
    Tally {
        load,
        contact,
        full,
        borne,
        work,
        complementarity,
        duality,
        open,
        depth,
        lowest,
        highest,
        largest,
    }
}

/// The rows `lines`; adds the gap beside the contact to each block.
#[inline(always)]
#[allow(clippy::inline_always, reason = "inner loops belong to each version of `vectorised!`")]
fn block_row<S: Simd, T: Real, C: Ceiling<T>>(
    x: S,
    ceiling: C,
    fields: AnswerFields<'_, T>,
    boundary: Boundary,
    nx: usize,
    lines: Range<usize>,
    blocks: &mut [f64],
) -> ([f64; 9], [f64; 3]) {
    let zero = f64x4::splat(x, 0.0);
    let (inf, minus) = (f64x4::splat(x, f64::INFINITY), f64x4::splat(x, f64::NEG_INFINITY));
    let mut lanes = Lanes { sums: [zero; 9], lowest: inf, highest: minus, largest: minus };
    let kernel = PixelTally { ceiling, level: fields.level, is_free: boundary == Boundary::Free };
    blocks.fill(0.0);
    let count = blocks.len();
    for iy in lines {
        for (column, block) in blocks.iter_mut().enumerate() {
            let piece = pixels(column, count, nx);
            let piece = iy * nx + piece.start..iy * nx + piece.end;
            let [p, u, h] = [fields.pressure, fields.displacement, fields.heights]
                .map(|field| &field[piece.clone()]);
            let mut beside = zero;
            let from = piece.start;
            for i in (0..p.len() - p.len() % LANES).step_by(LANES) {
                let here = [p, u, h].map(|field| T::widened(four(x, field, i)));
                beside += kernel.add(x, from + i, here, None, &mut lanes);
            }
            let left = p.len() % LANES;
            if left > 0 {
                let here = [p, u, h].map(|field| T::widened(four(x, &rest(field), 0)));
                beside += kernel.add(x, piece.end - left, here, Some(left), &mut lanes);
            }
            *block += beside.iter().sum::<f64>();
        }
    }
    let least = |lanes: f64x4<S>| lanes.iter().copied().fold(f64::INFINITY, f64::min);
    let most = |lanes: f64x4<S>| lanes.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let sums = lanes.sums.map(|lanes| lanes.iter().sum());
    (sums, [least(lanes.lowest), most(lanes.highest), most(lanes.largest)])
}

/// What is done with four pixels.
#[derive(Clone, Copy)]
struct PixelTally<C> {
    ceiling: C,
    level: f64,
    is_free: bool,
}

impl<C> PixelTally<C> {
    /// Adds `[p, u, h]` of four pixels from `node` on, or of the first few of them. Returns their gap beside the contact.
    #[inline(always)]
    #[allow(clippy::inline_always, reason = "inner loops belong to each version of `vectorised!`")]
    fn add<S: Simd, T: Real>(
        self,
        x: S,
        node: usize,
        [p, u, h]: [f64x4<S>; 3],
        first: Option<usize>,
        lanes: &mut Lanes<S>,
    ) -> f64x4<S>
    where
        C: Ceiling<T>,
    {
        let (zero, one) = (f64x4::splat(x, 0.0), f64x4::splat(x, 1.0));
        let mut gap = u - h - f64x4::splat(x, self.level);
        if let Some(first) = first {
            let exists = [0, 1, 2, 3].map(|lane| if lane < first { 1.0 } else { 0.0 });
            gap = f64x4::from_slice(x, &exists).simd_gt(zero).select(gap, zero);
        }
        let positive = |a: f64x4<S>| a.simd_gt(zero).select(a, zero);
        let larger = |a: f64x4<S>, b: f64x4<S>| a.simd_gt(b).select(a, b);
        let is_on = p.simd_gt(zero);
        let (open, overlap) = (positive(gap), positive(-gap));
        let beside = is_on.select(zero, open);
        let mut counted = if self.is_free { is_on.select(zero, gap) } else { gap };
        let (mut load, mut off, mut least, mut bound) = (p, open + overlap, gap, p * gap);
        let [load_sum, contact, full_sum, borne, work, complementarity, duality, open_sum, depth] =
            &mut lanes.sums;
        if C::IS_FINITE {
            let top = self.ceiling.four(x, node);
            let is_full = p.simd_ge(top);
            load = is_full.select(zero, p);
            off = is_full.select(open, off);
            least = is_full.select(zero, gap);
            counted = is_full.select(zero, counted);
            bound = p * open + (top - p) * overlap;
            // Behind the last pixel there are zeros, whatever H is.
            let full = is_on.select(is_full.select(one, zero), zero);
            *full_sum += full;
            *borne += full * p;
            *depth += is_full.select(overlap, zero);
        }
        *load_sum += load;
        *contact += is_on.select(one, zero);
        *work += p * u;
        *complementarity += p * off;
        *duality += bound;
        *open_sum += counted;
        lanes.lowest = least.simd_lt(lanes.lowest).select(least, lanes.lowest);
        lanes.highest = larger(larger(u, -u), lanes.highest);
        lanes.largest = larger(p, lanes.largest);
        beside
    }
}
