//! Honest cleaning of measured maps: every step is asked for, and every step says what it did.
//!
//! Functions here take heights as slices in which NaN marks a missing point, so that they work
//! before anything is filled in. Missing points stay missing; none becomes a height.

mod form;
mod gaussian;
mod outliers;
mod plan;
mod resample;
mod rows;

pub use form::{Form, FormParameters};
pub(crate) use gaussian::{gaussian_filter, short_waves};
pub use outliers::{Outliers, find_outliers};
pub use plan::{Record, Step, apply};
pub use resample::{mirrored, resample};
pub use rows::row_jumps;
