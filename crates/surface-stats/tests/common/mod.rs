//! What tests and examples share.

pub(crate) mod extremes;
