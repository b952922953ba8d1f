//! Statistics, against reference values and at the ends of their ranges. One program of tests, which is linked once.

#![allow(clippy::unwrap_used, reason = "a check that cannot be made has failed")]

#[path = "../common/extremes.rs"]
mod cases;
mod extremes;
mod pair;
mod reference;
#[cfg(feature = "serde")]
mod serde;
mod synthesis;
mod warnings;
