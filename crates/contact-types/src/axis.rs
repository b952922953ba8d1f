//! A direction in the plane of a map.

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

impl Axis {
    /// Both.
    pub const BOTH: [Self; 2] = [Self::X, Self::Y];

    /// `x` or `y`.
    pub fn name(self) -> &'static str {
        match self {
            Self::X => "x",
            Self::Y => "y",
        }
    }

    /// Its place in `[y, x]` pairs.
    pub fn index(self) -> usize {
        match self {
            Self::Y => 0,
            Self::X => 1,
        }
    }
}
