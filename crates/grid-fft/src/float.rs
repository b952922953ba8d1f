//! The two floating-point types, and where their transforms are planned.

use crate::rows::Rows;
use rustfft::{Fft, FftNum, FftPlanner};
use std::sync::Arc;

/// `f64` or `f32`, the types that fields are transformed in.
///
/// Transforms are planned in here and not where they are used: a planner brings the code of every
/// transform along, which is much, and a crate that planned for itself would compile it again.
pub trait Float: FftNum {
    /// Plans rows of `nx` real numbers and columns of `ny` complex ones, `[ny, nx]`.
    #[doc(hidden)]
    fn plan(shape: [usize; 2]) -> Plans<Self>;
}

/// Transforms of rows and columns.
#[derive(Clone)]
#[doc(hidden)]
pub struct Plans<T> {
    pub(crate) rows: Rows<T>,
    pub(crate) column_forward: Arc<dyn Fft<T>>,
    pub(crate) column_inverse: Arc<dyn Fft<T>>,
}

impl<T> std::fmt::Debug for Plans<T> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Plans").finish_non_exhaustive()
    }
}

impl<T: FftNum> Plans<T> {
    fn of([ny, nx]: [usize; 2]) -> Self {
        let mut planner = FftPlanner::new();
        Self {
            rows: Rows::plan(nx, &mut planner),
            column_forward: planner.plan_fft_forward(ny),
            column_inverse: planner.plan_fft_inverse(ny),
        }
    }

    /// The longest scratch that a transform of columns asks for.
    pub(crate) fn column_scratch_len(&self) -> usize {
        let forward = self.column_forward.get_inplace_scratch_len();
        forward.max(self.column_inverse.get_inplace_scratch_len())
    }
}

impl Float for f64 {
    #[inline(never)]
    fn plan(shape: [usize; 2]) -> Plans<Self> {
        Plans::of(shape)
    }
}

impl Float for f32 {
    #[inline(never)]
    fn plan(shape: [usize; 2]) -> Plans<Self> {
        Plans::of(shape)
    }
}
