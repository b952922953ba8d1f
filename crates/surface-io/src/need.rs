//! What a caller can add so that a file can be read after all.

use crate::layout::Layout;
use std::fmt;

/// What is missing: something the file does not say, or a choice it leaves open. An error tells
/// its needs; a program that reads files for people says how they are given to it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Need {
    /// The distance between neighbouring points: [`ReadOptions::pixel`](crate::ReadOptions).
    PixelSize,
    /// The unit of x and y: [`ReadOptions::lateral_unit`](crate::ReadOptions).
    LateralUnit,
    /// The unit of the heights: [`ReadOptions::height_unit`](crate::ReadOptions).
    HeightUnit,
    /// Which channel to read: [`ReadOptions::channel`](crate::ReadOptions).
    Channel,
    /// What the columns of a text are, if they are this:
    /// [`ReadOptions::layout`](crate::ReadOptions).
    Layout(Layout),
    /// A rule for missing points: [`Fill`](crate::Fill), or a part without them.
    Fill,
    /// A larger bound: [`ReadOptions::limits`](crate::ReadOptions).
    Limits,
}

impl fmt::Display for Need {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::PixelSize => "pixel size",
            Self::LateralUnit => "unit of x and y",
            Self::HeightUnit => "height unit",
            Self::Channel => "channel",
            Self::Layout(Layout::Matrix) => "layout (a matrix of heights)",
            Self::Layout(Layout::List) => "layout (coordinates and a height)",
            Self::Layout(Layout::Traces) => "layout (positions and the heights of traces)",
            Self::Fill => "rule for missing points",
            Self::Limits => "larger limit",
        })
    }
}

/// How the columns of a text were read where they could mean something else.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct Ambiguity {
    /// Number of columns: 1, 2 (read as a profile) or 3 (read as a list).
    pub columns: usize,
}

impl Ambiguity {
    /// The layout to ask for if this reading is wrong.
    pub fn needs(self) -> Need {
        Need::Layout(Layout::Matrix)
    }
}

impl fmt::Display for Ambiguity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self.columns {
            1 => "the column could be heights, one point to a row",
            2 => "two columns, read as a profile x z; they could as well be heights",
            _ => "three columns, read as a list x y z; they could as well be heights",
        })
    }
}
