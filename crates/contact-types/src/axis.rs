//! A direction in the plane of a map.

use crate::Named;

/// A direction in the plane of a map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum Axis {
    /// Along a row, from the first column to the last.
    X,
    /// Along a column, from the first row to the last.
    Y,
}

impl Named for Axis {
    const NAMES: &'static [(Self, &'static str)] = &[(Self::X, "x"), (Self::Y, "y")];
}
