//! How the second body of a pair lies on the first.

use crate::StatsError;
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

/// Two maps that cannot be laid on each other.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PairError {
    /// The maps hardly meet.
    #[error(
        "with the second map moved by {shift:e} m, {found} rows or columns of the two lie on each other, \
         and at least 2 must; shift less"
    )]
    TooLittle {
        /// How far the second was moved (m).
        shift: f64,
        /// Points in common along the axis.
        found: f64,
    },
    /// The coarser map has too few points where the other lies.
    #[error(
        "the points are {:e} m apart in the first map and {:e} m in the second, so that the part in \
         common has {own:.1} points of the {}, and at least 4 are needed; measure the two at like \
         point spacings",
        pixels[0], pixels[1], ["first", "second"][*which]
    )]
    TooCoarse {
        /// Which map is the coarser, 0 or 1.
        which: usize,
        /// Its points in the common part along the axis.
        own: f64,
        /// Point spacing of both along that axis (m).
        pixels: [f64; 2],
    },
    /// The sum cannot be made.
    #[error(transparent)]
    Statistics(#[from] StatsError),
}
