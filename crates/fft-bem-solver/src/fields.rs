//! Sums over fields. Each is a tree of partial sums over blocks of fixed length, so that the result
//! does not depend on the number of threads, and is accumulated in `f64`.

use crate::Real;
use crate::simd::{LANES, four, rest, vectorised};
use fearless_simd::{Select, SimdBase, SimdFloat, f64x4};
use grid_fft::parallel::{join, prelude::*};
use std::ops::Range;

/// Pixels per partial sum.
const BLOCK: usize = 4096;

/// Combines `piece(range)` of all blocks of `range`, two by two.
pub(crate) fn by_blocks<A: Send>(
    range: Range<usize>,
    piece: &(dyn Fn(Range<usize>) -> A + Sync),
    combine: &(dyn Fn(A, A) -> A + Sync),
) -> A {
    let blocks = range.len().div_ceil(BLOCK);
    if blocks <= 1 {
        return piece(range);
    }
    let middle = range.start + blocks / 2 * BLOCK;
    let (left, right) = (range.start..middle, middle..range.end);
    let both = [left, right].map(|half| move || by_blocks(half, piece, combine));
    let [left, right] = both;
    let (a, b) = if blocks > 4 { join(left, right) } else { (left(), right()) };
    combine(a, b)
}

pub(crate) fn sum_of(n: usize, term: impl Fn(usize) -> f64 + Sync) -> f64 {
    by_blocks(0..n, &|range| range.map(&term).sum(), &|a, b| a + b)
}

/// Sum of `x + shift` over the pixels where it is positive, and the number of these.
pub(crate) fn positive_part<T: Real>(field: &[T], shift: f64) -> [f64; 2] {
    let piece = |range: Range<usize>| {
        let field = &field[range];
        vectorised!(x => {
            let (zero, one) = (f64x4::splat(x, 0.0), f64x4::splat(x, 1.0));
            let [mut carried, mut count] = [zero; 2];
            for i in (0..field.len() - field.len() % LANES).step_by(LANES) {
                let p = T::widened(four(x, field, i)) + shift;
                let is_positive = p.simd_gt(zero);
                carried += is_positive.select(p, zero);
                count += is_positive.select(one, zero);
            }
            let (_, rest) = field.as_chunks::<LANES>();
            let rest = rest.iter().map(|p| p.wide() + shift).filter(|p| *p > 0.0);
            rest.fold([carried, count].map(|lanes| lanes.iter().sum()), |[sum, n]: [f64; 2], p| {
                [sum + p, n + 1.0]
            })
        })
    };
    by_blocks(0..field.len(), &piece, &|a, b| [a[0] + b[0], a[1] + b[1]])
}

/// Least `term(i)` over `0..n`; `+inf` if there is none.
pub(crate) fn least_of(n: usize, term: impl Fn(usize) -> f64 + Sync) -> f64 {
    by_blocks(0..n, &|range| range.map(&term).fold(f64::INFINITY, f64::min), &f64::min)
}

/// Largest `term(i)` over `0..n`; `-inf` if there is none.
pub(crate) fn largest_of(n: usize, term: impl Fn(usize) -> f64 + Sync) -> f64 {
    -least_of(n, |i| -term(i))
}

pub(crate) fn filled<T: Real>(n: usize, value: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let mut field = vec![T::zero(); n];
    write(&mut field, |i, _| value(i));
    field
}

/// Replaces every value `x` by `new(i, x)`.
pub(crate) fn write<T: Real>(field: &mut [T], new: impl Fn(usize, T) -> T + Sync + Send) {
    field.par_chunks_mut(BLOCK).enumerate().for_each(|(k, block)| {
        for (i, x) in block.iter_mut().enumerate() {
            *x = new(k * BLOCK + i, *x);
        }
    });
}

pub(crate) fn fill<T: Real>(value: f64, field: &mut [T]) {
    field.par_chunks_mut(BLOCK).for_each(|block| block.fill(T::of(value)));
}

pub(crate) fn scale<T: Real>(factor: f64, field: &mut [T]) {
    let factor = T::of(factor);
    write(field, |_, x| x * factor);
}

/// Values for the pixels `on` alone, written to their places in a field that is zero elsewhere.
pub(crate) fn scatter(values: &[f64], on: &[usize], field: &mut [f64]) {
    fill(0.0, field);
    for (i, value) in on.iter().zip(values) {
        field[*i] = *value;
    }
}

pub(crate) fn sum<T: Real>(a: &[T]) -> f64 {
    let piece = |range: Range<usize>| {
        let a = &a[range];
        vectorised!(x => {
            let mut sum = f64x4::splat(x, 0.0);
            for i in (0..a.len() - a.len() % LANES).step_by(LANES) {
                sum += T::widened(four(x, a, i));
            }
            let (_, rest) = a.as_chunks::<LANES>();
            sum.iter().sum::<f64>() + rest.iter().map(|x| x.wide()).sum::<f64>()
        })
    };
    by_blocks(0..a.len(), &piece, &|a, b| a + b)
}

pub(crate) fn mean<T: Real>(a: &[T]) -> f64 {
    sum(a) / a.len() as f64
}

/// Sums of `w (a - b)` and of `w`.
pub(crate) fn weighted_difference<T: Real>(w: &[T], [a, b]: [&[T]; 2]) -> [f64; 2] {
    let piece = |range: Range<usize>| {
        let [w, a, b] = [w, a, b].map(|x| &x[range.clone()]);
        vectorised!(x => {
            let [mut sum, mut weight] = [f64x4::splat(x, 0.0); 2];
            let mut add = |w: &[T], a: &[T], b: &[T], i: usize| {
                let [w, a, b] = [w, a, b].map(|field| T::widened(four(x, field, i)));
                sum += w * (a - b);
                weight += w;
            };
            for i in (0..w.len() - w.len() % LANES).step_by(LANES) {
                add(w, a, b, i);
            }
            add(&rest(w), &rest(a), &rest(b), 0);
            [sum, weight].map(|lanes| lanes.iter().sum())
        })
    };
    by_blocks(0..w.len(), &piece, &|a, b| [a[0] + b[0], a[1] + b[1]])
}

pub(crate) fn dot<T: Real>(a: &[T], b: &[T]) -> f64 {
    sum_of(a.len(), |i| a[i].wide() * b[i].wide())
}

/// Smallest and largest value; `+inf` and `-inf` for an empty field. NaN counts as none.
pub(crate) fn range<T: Real>(a: &[T]) -> [f64; 2] {
    let piece = |range: Range<usize>| {
        let a = &a[range];
        vectorised!(x => {
            let mut least = f64x4::splat(x, f64::INFINITY);
            let mut most = f64x4::splat(x, f64::NEG_INFINITY);
            for i in (0..a.len() - a.len() % LANES).step_by(LANES) {
                let a = T::widened(four(x, a, i));
                least = a.simd_lt(least).select(a, least);
                most = a.simd_gt(most).select(a, most);
            }
            let (_, rest) = a.as_chunks::<LANES>();
            let rest = || rest.iter().map(|x| x.wide());
            let least = least.iter().copied().chain(rest()).fold(f64::INFINITY, f64::min);
            [least, most.iter().copied().chain(rest()).fold(f64::NEG_INFINITY, f64::max)]
        })
    };
    by_blocks(0..a.len(), &piece, &|a, b| [a[0].min(b[0]), a[1].max(b[1])])
}

/// Largest value; `-inf` for an empty field.
pub(crate) fn max<T: Real>(a: &[T]) -> f64 {
    range(a)[1]
}

/// Smallest value; `+inf` for an empty field.
pub(crate) fn min<T: Real>(a: &[T]) -> f64 {
    range(a)[0]
}

pub(crate) fn contact_count<T: Real>(pressure: &[T]) -> usize {
    sum_of(pressure.len(), |i| if pressure[i] > T::zero() { 1.0 } else { 0.0 }) as usize
}
