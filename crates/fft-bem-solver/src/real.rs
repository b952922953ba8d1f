//! The two floating-point types a solve can run in.

#![allow(clippy::inline_always, reason = "inner loops belong to each version of `vectorised!`")]

use fearless_simd::{Simd, SimdBase, SimdFloat, f32x4, f64x4};
use grid_fft::Float;
use std::ops::{AddAssign, DivAssign, MulAssign, SubAssign};

/// `f64` or `f32`: the type in which the fields of a solve are stored. Sums are always `f64`.
pub trait Real:
    Float + PartialOrd + AddAssign + SubAssign + MulAssign + DivAssign + Default
{
    /// Distance from 1 to the next number.
    const EPSILON: f64;
    /// Relative pressure error below which rounding may keep a method from going: the worst of the surfaces of
    /// `tests/certificate.rs`, with the free boundary.
    const ATTAINABLE: f64;
    /// A vector of four of them.
    #[doc(hidden)]
    type Four<S: Simd>: SimdFloat<S, Element = Self>;
    /// The same four numbers as `f64`, exactly.
    #[doc(hidden)]
    fn widened<S: Simd>(four: Self::Four<S>) -> f64x4<S>;
    /// The nearest number of this type.
    fn of(value: f64) -> Self;
    /// The same number as `f64`, exactly.
    fn wide(self) -> f64;
    /// The nearest `f32`.
    #[inline(always)]
    fn narrow(self) -> f32 {
        self.wide() as f32
    }
    /// The square root.
    #[must_use]
    fn root(self) -> Self;
    /// The memory of a field as numbers of single precision, at least as many.
    fn as_single(field: &mut [Self]) -> &mut [f32];
    /// The larger of two numbers.
    #[must_use]
    fn larger(self, other: Self) -> Self {
        if other > self { other } else { self }
    }
}

impl Real for f64 {
    const EPSILON: f64 = f64::EPSILON;
    const ATTAINABLE: f64 = 1e-11;
    type Four<S: Simd> = f64x4<S>;
    #[inline(always)]
    fn widened<S: Simd>(four: f64x4<S>) -> f64x4<S> {
        four
    }
    fn of(value: f64) -> Self {
        value
    }
    fn wide(self) -> f64 {
        self
    }
    fn root(self) -> Self {
        self.sqrt()
    }
    fn as_single(field: &mut [Self]) -> &mut [f32] {
        bytemuck::cast_slice_mut(field)
    }
}

impl Real for f32 {
    const EPSILON: f64 = f32::EPSILON as f64;
    const ATTAINABLE: f64 = 3e-5;
    type Four<S: Simd> = f32x4<S>;
    #[inline(always)]
    fn widened<S: Simd>(four: f32x4<S>) -> f64x4<S> {
        f64x4::from_slice(four.witness(), &four.map(f64::from))
    }
    fn of(value: f64) -> Self {
        value as Self
    }
    fn wide(self) -> f64 {
        f64::from(self)
    }
    fn root(self) -> Self {
        self.sqrt()
    }
    fn as_single(field: &mut [Self]) -> &mut [f32] {
        field
    }
}
