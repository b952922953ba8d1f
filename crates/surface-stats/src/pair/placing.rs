//! How the second body is laid on the first.

use contact_types::Named;

/// How the second body is turned over. Instruments look at both bodies from above; to lie face down
/// on the first, the second has to be turned over, and that mirrors its map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum Flip {
    /// As a book is closed, the maps being its two open pages: the first column meets the last.
    #[default]
    Columns,
    /// As a page of a wall calendar is turned: the first row meets the last.
    Rows,
    /// Not at all: the map already shows the body as it lies on the first.
    None,
}

impl Named for Flip {
    const NAMES: &'static [(Self, &'static str)] =
        &[(Self::Columns, "columns"), (Self::Rows, "rows"), (Self::None, "none")];
}

/// How the second body is laid on the first.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Placing {
    /// How it is turned over.
    pub flip: Flip,
    /// How far it is moved then along `[y, x]` (m), towards higher rows and columns of the first.
    pub shift: [f64; 2],
}
