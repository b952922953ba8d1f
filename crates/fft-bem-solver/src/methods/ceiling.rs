//! The upper bound of the pressure: none, a hardness, or one for each node.
//!
//! A type and not a number, so that the passes of an elastic solve know nothing of it: what asks for
//! it is not compiled there.

use crate::simd::{LANES, four, rest};
use crate::{Real, fields};
use fearless_simd::{Simd, SimdBase, f64x4};

/// The bounds `0 <= p <= H` of a pressure.
pub(crate) trait Ceiling<T: Real>: Copy + Send + Sync {
    /// Whether there is an upper one.
    const IS_FINITE: bool;

    /// H at a node, counted from where the piece of the fields begins; infinite if there is none.
    fn at(self, node: usize) -> T;

    /// That of the piece that begins at this node.
    #[must_use]
    fn after(self, node: usize) -> Self;

    /// H at four nodes; of the last ones of an odd piece, with zeros behind.
    #[inline(always)]
    fn four<S: Simd>(self, vectors: S, node: usize) -> f64x4<S> {
        f64x4::splat(vectors, self.at(node).wide())
    }

    /// The nearest pressure within the bounds.
    #[inline(always)]
    fn clip(self, node: usize, p: T) -> T {
        let p = p.larger(T::zero());
        if Self::IS_FINITE && p > self.at(node) { self.at(node) } else { p }
    }

    /// Whether a node at `p` can be pressed no harder.
    #[inline(always)]
    fn is_reached(self, node: usize, p: T) -> bool {
        Self::IS_FINITE && p >= self.at(node)
    }

    /// Whether a field, times a factor, comes anywhere to lie above it.
    fn is_passed(self, factor: f64, field: &[T]) -> bool {
        let over = |i: usize| factor * field[i].wide() - self.at(i).wide();
        Self::IS_FINITE && fields::largest_of(field.len(), over) > 0.0
    }
}

/// None: the bodies stay elastic.
#[derive(Debug, Clone, Copy)]
pub(crate) struct NoCeiling;

impl<T: Real> Ceiling<T> for NoCeiling {
    const IS_FINITE: bool = false;
    #[inline(always)]
    fn at(self, _: usize) -> T {
        T::of(f64::INFINITY)
    }
    #[inline(always)]
    fn after(self, _: usize) -> Self {
        self
    }
}

/// The softer body yields at this pressure.
#[derive(Debug, Clone, Copy)]
pub(crate) struct UniformCeiling<T>(pub(crate) T);

impl<T: Real> Ceiling<T> for UniformCeiling<T> {
    const IS_FINITE: bool = true;
    #[inline(always)]
    fn at(self, _: usize) -> T {
        self.0
    }
    #[inline(always)]
    fn after(self, _: usize) -> Self {
        self
    }
}

/// It yields at another pressure at each node.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CeilingMap<'a, T>(pub(crate) &'a [T]);

impl<T: Real> Ceiling<T> for CeilingMap<'_, T> {
    const IS_FINITE: bool = true;
    #[inline(always)]
    fn at(self, node: usize) -> T {
        self.0[node]
    }
    #[inline(always)]
    fn after(self, node: usize) -> Self {
        Self(&self.0[node..])
    }
    #[inline(always)]
    fn four<S: Simd>(self, vectors: S, node: usize) -> f64x4<S> {
        let map = &self.0[node..];
        if map.len() < LANES {
            return T::widened(four(vectors, &rest(map), 0));
        }
        T::widened(four(vectors, map, 0))
    }
}

/// The bound of a task, before it is known to the compiler.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Top<'a, T> {
    /// The same everywhere; infinite for elastic bodies.
    Same(f64),
    /// At each node, with the mean of all.
    Map(&'a [T], f64),
}

impl<T: Real> Top<'_, T> {
    /// None.
    pub(crate) const NONE: Self = Self::Same(f64::INFINITY);

    pub(crate) fn is_finite(self) -> bool {
        self.mean().is_finite()
    }

    /// The largest load; infinite if there is none.
    pub(crate) fn mean(self) -> f64 {
        match self {
            Self::Same(top) | Self::Map(_, top) => top,
        }
    }

    #[inline(always)]
    pub(crate) fn at(self, node: usize) -> T {
        match self {
            Self::Same(top) => T::of(top),
            Self::Map(map, _) => map[node],
        }
    }
}

/// Compiles an expression for each kind of bound.
macro_rules! under {
    ($top:expr, $ceiling:ident => $body:expr) => {
        match $top {
            $crate::methods::Top::Same(top) if top.is_finite() => {
                let $ceiling = $crate::methods::UniformCeiling($crate::Real::of(top));
                $body
            }
            $crate::methods::Top::Same(_) => {
                let $ceiling = $crate::methods::NoCeiling;
                $body
            }
            $crate::methods::Top::Map(map, _) => {
                let $ceiling = $crate::methods::CeilingMap(map);
                $body
            }
        }
    };
}
pub(crate) use under;
