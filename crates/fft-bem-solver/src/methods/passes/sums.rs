//! Sums and largest values over pieces of fields, in an order that is always the same.

use crate::simd::LANES;

/// Pixels that a pass handles at a time where it needs room for intermediate fields.
pub(super) const TILE: usize = 64;

/// A sum in the making: independent parts, so that additions need not wait for one another.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Sum([f64; LANES]);

impl Sum {
    /// Adds the inner product `<a, b>`.
    #[inline(always)]
    pub(super) fn add_product(&mut self, a: &[f64], b: &[f64]) {
        let ((a, a_rest), (b, b_rest)) = (a.as_chunks::<LANES>(), b.as_chunks::<LANES>());
        for (a, b) in a.iter().zip(b) {
            for lane in 0..LANES {
                self.0[lane] += a[lane] * b[lane];
            }
        }
        for (a, b) in a_rest.iter().zip(b_rest) {
            self.0[0] += a * b;
        }
    }

    pub(super) fn total(self) -> f64 {
        self.0.iter().sum()
    }
}

/// The largest of numbers that are not negative, in the making.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Largest([f64; LANES]);

impl Largest {
    /// Looks at all of `a`.
    #[inline(always)]
    pub(super) fn take(&mut self, a: &[f64]) {
        let larger = |x: f64, y: f64| if y > x { y } else { x };
        let (a, a_rest) = a.as_chunks::<LANES>();
        for a in a {
            for lane in 0..LANES {
                self.0[lane] = larger(self.0[lane], a[lane]);
            }
        }
        for a in a_rest {
            self.0[0] = larger(self.0[0], *a);
        }
    }

    pub(super) fn total(self) -> f64 {
        self.0.into_iter().fold(0.0, f64::max)
    }
}
