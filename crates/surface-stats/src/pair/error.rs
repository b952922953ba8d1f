//! Why two maps make no pair.

use crate::StatsError;

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
