//! The upper bound of the pressure: none, or a hardness.
//!
//! A type and not a number, so that the passes of an elastic solve know nothing of it: what asks for
//! it is not compiled there.

use crate::Real;

/// The bounds `0 <= p <= H` of a pressure.
pub(crate) trait Ceiling<T: Real>: Copy + Send + Sync {
    /// Whether there is an upper one.
    const IS_FINITE: bool;

    /// H; infinite if there is none.
    fn value(self) -> T;

    /// The nearest pressure within the bounds.
    #[inline(always)]
    fn clip(self, p: T) -> T {
        let p = p.larger(T::zero());
        if Self::IS_FINITE && p > self.value() { self.value() } else { p }
    }

    /// Whether a node at `p` can be pressed no harder.
    #[inline(always)]
    fn is_reached(self, p: T) -> bool {
        Self::IS_FINITE && p >= self.value()
    }
}

/// None: the bodies stay elastic.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Elastic;

impl<T: Real> Ceiling<T> for Elastic {
    const IS_FINITE: bool = false;
    #[inline(always)]
    fn value(self) -> T {
        T::of(f64::INFINITY)
    }
}

/// The softer body yields at this pressure.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Hardness<T>(pub(crate) T);

impl<T: Real> Ceiling<T> for Hardness<T> {
    const IS_FINITE: bool = true;
    #[inline(always)]
    fn value(self) -> T {
        self.0
    }
}
