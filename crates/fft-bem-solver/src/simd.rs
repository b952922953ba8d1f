//! Inner loops in versions for several sets of vector instructions, chosen while the program runs.

#![allow(clippy::inline_always, reason = "inner loops belong to each version of `vectorised!`")]

use fearless_simd::{Level, Simd, SimdBase, SimdFloat, f32x4, f64x4};

/// Evaluates an expression in the version for the widest vectors that this processor has.
///
/// The versions differ in how many numbers one instruction handles and in nothing else: each
/// operation and the order of sums are those of the source, so that the results are the same to the
/// last bit. What the expression calls belongs to a version only if it is inlined. With a name before
/// it, the expression is given the vectors of its version.
///
/// Loops from field to field need no more than this. Loops that sum are written in vectors of four
/// ([`four`]), since the order of additions is not for the compiler to change.
macro_rules! vectorised {
    ($pass:expr) => {
        fearless_simd::dispatch!($crate::simd::level(), _vectors => $pass)
    };
    ($vectors:ident => $pass:expr) => {
        fearless_simd::dispatch!($crate::simd::level(), $vectors => $pass)
    };
}
pub(crate) use vectorised;

/// Numbers in a vector.
pub(crate) const LANES: usize = 4;

/// A number of which four make a vector.
pub trait Lane: Sized {
    /// Four of them.
    type Four<S: Simd>: SimdFloat<S, Element = Self>;
    /// The same numbers as `f64`, exactly.
    fn widened<S: Simd>(four: Self::Four<S>) -> f64x4<S>;
}

impl Lane for f64 {
    type Four<S: Simd> = f64x4<S>;
    #[inline(always)]
    fn widened<S: Simd>(four: f64x4<S>) -> f64x4<S> {
        four
    }
}

impl Lane for f32 {
    type Four<S: Simd> = f32x4<S>;
    #[inline(always)]
    fn widened<S: Simd>(four: f32x4<S>) -> f64x4<S> {
        f64x4::from_slice(four.witness(), &four.map(f64::from))
    }
}

/// Four numbers of a field, from `i` on.
#[inline(always)]
pub(crate) fn four<S: Simd, T: Lane>(vectors: S, field: &[T], i: usize) -> T::Four<S> {
    <T::Four<S> as SimdBase<S>>::from_slice(vectors, &field[i..i + LANES])
}

/// What is left of a field after whole vectors of it, filled up with zeros.
pub(crate) fn rest<T: Copy + Default>(field: &[T]) -> [T; LANES] {
    let (_, rest) = field.as_chunks::<LANES>();
    let mut four = [T::default(); LANES];
    four[..rest.len()].copy_from_slice(rest);
    four
}

/// The widest vectors.
pub(crate) fn level() -> Level {
    #[cfg(test)]
    if tests::IS_PLAIN.load(std::sync::atomic::Ordering::Relaxed) {
        return Level::baseline();
    }
    Level::new()
}

#[cfg(test)]
mod tests {
    use crate::{Load, Precision, Solver};
    use contact_types::{ContactModulus, Grid, HeightMap};
    use std::sync::atomic::{AtomicBool, Ordering};

    /// Makes every pass take the version that all processors have.
    pub(super) static IS_PLAIN: AtomicBool = AtomicBool::new(false);

    /// Answers are the same to the last bit whatever the vectors of the processor.
    #[test]
    fn vectors_change_no_bit() {
        for shape in [[96, 128], [37, 101]] {
            let grid = Grid::new(shape, [1.0, 1.0]).unwrap();
            let height = |y: f64, x: f64| {
                (0.7 * y).sin() * (0.9 * x + 0.2 * y).cos() + 0.3 * (2.1 * x - 1.3 * y).sin()
            };
            let surface = HeightMap::from_fn(grid, height).unwrap();
            for (precision, tolerance) in [(Precision::Double, 1e-8), (Precision::Single, 1e-3)] {
                let solve = |is_plain: bool| {
                    IS_PLAIN.store(is_plain, Ordering::Relaxed);
                    let modulus = ContactModulus::from_pascals(1.0).unwrap();
                    let builder = Solver::builder().precision(precision).tolerance(tolerance);
                    let mut solver = builder.build(grid, modulus).unwrap();
                    let solution = solver.solve(&surface, Load::MeanPressure(0.05)).unwrap();
                    IS_PLAIN.store(false, Ordering::Relaxed);
                    let bits = |field: &[f64]| field.iter().map(|x| x.to_bits()).collect();
                    let both: [Vec<u64>; 2] = [bits(&solution.pressure), bits(&solution.gap)];
                    both
                };
                assert!(solve(true) == solve(false), "{shape:?} {precision:?}");
            }
        }
    }
}
