//! Inner loops in versions for several sets of vector instructions, chosen while the program runs.

use crate::Real;
use fearless_simd::{Level, Simd, SimdBase};

/// Evaluates an expression in the version for the widest vectors that this processor has.
///
/// Each operation and the order of sums are those of the source: the results are the same to the last bit. What the
/// expression calls belongs to a version only if it is inlined. With a name before it, the expression is given the
/// vectors of its version. Loops that sum are written in vectors of four ([`four`]), since the order of additions is
/// not for the compiler to change.
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

/// Four numbers of a field, from `i` on.
#[inline(always)]
#[allow(clippy::inline_always, reason = "inner loops belong to each version of `vectorised!`")]
pub(crate) fn four<S: Simd, T: Real>(vectors: S, field: &[T], i: usize) -> T::Four<S> {
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
    if IS_PLAIN.load(std::sync::atomic::Ordering::Relaxed) {
        return Level::baseline();
    }
    Level::new()
}

/// Makes every pass of the tests take the version that all processors have.
#[cfg(test)]
pub(crate) static IS_PLAIN: std::sync::atomic::AtomicBool =
    std::sync::atomic::AtomicBool::new(false);
