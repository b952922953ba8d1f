//! The upper bound of the pressure: none, or the hardness.
//!
//! A type and not a number, so that the passes of an elastic solve know nothing of it: what asks for
//! it is not compiled there.

use crate::{Real, fields};

/// The bounds `0 <= p <= H` of a pressure.
pub(crate) trait Ceiling<T: Real>: Copy + Send + Sync {
    const IS_FINITE: bool;

    /// H; infinite if there is none.
    fn top(self) -> T;

    /// The nearest pressure within the bounds.
    #[inline(always)]
    fn clip(self, p: T) -> T {
        let p = p.larger(T::zero());
        if Self::IS_FINITE && p > self.top() { self.top() } else { p }
    }

    /// Whether a node at `p` can be pressed no harder.
    #[inline(always)]
    fn is_reached(self, p: T) -> bool {
        Self::IS_FINITE && p >= self.top()
    }

    /// Whether a field, times a factor, comes anywhere to lie above it.
    fn is_passed(self, factor: f64, field: &[T]) -> bool {
        Self::IS_FINITE && factor * fields::max(field) > self.top().wide()
    }
}

/// None: the bodies stay elastic.
#[derive(Debug, Clone, Copy)]
pub(crate) struct NoCeiling;

impl<T: Real> Ceiling<T> for NoCeiling {
    const IS_FINITE: bool = false;
    #[inline(always)]
    fn top(self) -> T {
        T::of(f64::INFINITY)
    }
}

/// The softer body yields at this pressure.
#[derive(Debug, Clone, Copy)]
pub(crate) struct HardnessCeiling<T>(pub(crate) T);

impl<T: Real> Ceiling<T> for HardnessCeiling<T> {
    const IS_FINITE: bool = true;
    #[inline(always)]
    fn top(self) -> T {
        self.0
    }
}

/// Compiles an expression for both kinds of bound; an infinite number is none.
macro_rules! under {
    ($top:expr, $ceiling:ident => $body:expr) => {
        if $top.is_finite() {
            let $ceiling = $crate::methods::HardnessCeiling($crate::Real::of($top));
            $body
        } else {
            let $ceiling = $crate::methods::NoCeiling;
            $body
        }
    };
}
pub(crate) use under;
