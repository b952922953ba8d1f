//! Areal parameters of ISO 25178-2:2021 beyond the height parameters of
//! [`HeightStatistics`](crate::HeightStatistics), each with the discrete definition used.
//!
//! The standard defines continuous integrals; programs differ in how they discretise them. The
//! book, chapter "Surface statistics", lists the differences to two other programs.

mod hybrid;
mod material_ratio;
mod spatial;

pub use hybrid::Hybrid;
pub(crate) use hybrid::seven_point_slope;
pub use material_ratio::{CoreRoughness, MaterialRatioCurve, Volumes};
pub use spatial::{Spatial, texture_direction};
