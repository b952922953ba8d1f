//! What a caller says about a file.

use crate::limits::Limits;
use crate::need::{DecimalMark, Layout};

/// A unit of heights given by the caller, in metres per unit, and when it counts.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum HeightUnit {
    /// If the file gives none; a unit in the file is kept, and the metadata then say that the
    /// one given was not needed.
    IfSilent(f64),
    /// Whatever the file says; the metadata then keep what it said.
    Always(f64),
}

impl HeightUnit {
    /// Metres per unit.
    pub(crate) fn metres(self) -> f64 {
        match self {
            Self::IfSilent(metres) | Self::Always(metres) => metres,
        }
    }
}

/// What the file does not say, and which part of it is wanted.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ReadOptions {
    /// Channel by name, or `#2` for the second; default is the first one that is a topography.
    pub channel: Option<String>,
    /// `[dy, dx]` in metres: the distance between neighbouring points. Overrides the file, which
    /// is then noted in the metadata.
    pub pixel: Option<[f64; 2]>,
    /// Metres per unit of x and y, for lists of coordinates whose unit the file does not give.
    pub lateral_unit: Option<f64>,
    /// Unit of the heights in the file.
    pub height_unit: Option<HeightUnit>,
    /// What the columns of a text file are; default is what its header and numbers say, and three
    /// columns without a header a list x y z.
    pub layout: Option<Layout>,
    /// The decimal mark of a text file, where its numbers can be read in two ways.
    pub decimal: Option<DecimalMark>,
    /// What marks a missing point, beside NaN, empty cells and the usual words: a word in a text, or a
    /// number in the unit of the file.
    pub missing: Vec<String>,
    /// What reading may cost.
    pub limits: Limits,
}
