//! Areal parameters of ISO 25178-2:2021 beyond those of the heights, each with the discrete definition used.
//!
//! The book, chapter "Surface statistics", lists the differences to two other programs.

mod areal;
mod hybrid;
mod material_ratio;
mod spatial;

pub use areal::{IsoParameter, parameters};
pub(crate) use hybrid::seven_point_slope;
pub(crate) use material_ratio::MaterialRatioCurve;
