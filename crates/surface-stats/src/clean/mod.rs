//! Honest cleaning of measured maps: every step is asked for, and every step says what it did.
//!
//! Functions here take heights as slices in which NaN marks a missing point, so that they work
//! before anything is filled in. Missing points stay missing; none becomes a height.

mod form;
mod form_name;
mod gaussian;
mod mirror;
mod outliers;
mod plan;
mod rows;
mod transform;

pub use form::{FittedForm, Form, FormParameters, fit_form};
pub use form_name::FormNameError;
pub use gaussian::{gaussian_filter, l_filter, s_filter};
pub use mirror::{mirrored, resample_mirrored};
pub use outliers::{OutlierRule, Outliers, find_outliers};
pub use plan::{Record, Step, apply};
pub use rows::{RowOffsets, row_offsets};
pub(crate) use transform::{Along, interpolated};
pub use transform::{Facing, combine, equivalent, flip, resample};
