//! What a caller can add so that a file can be read after all, and how a text was read.

use contact_types::Named;
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
    /// The decimal mark of a text: [`ReadOptions::decimal`](crate::ReadOptions).
    DecimalMark,
    /// What marks a missing point: [`ReadOptions::missing`](crate::ReadOptions).
    MissingMark,
    /// A unit of the heights in place of the one in the file:
    /// [`HeightUnit::Always`](crate::HeightUnit).
    OtherHeightUnit,
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
            Self::DecimalMark => "decimal mark",
            Self::MissingMark => "mark of missing points",
            Self::OtherHeightUnit => "height unit in place of the one in the file",
            Self::Fill => "rule for missing points",
            Self::Limits => "larger limit",
        })
    }
}

/// How the columns of a text were read where they could mean something else.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct Ambiguity {
    /// The reading, and what else it could be.
    pub what: &'static str,
    /// The layouts to ask for if this reading is wrong.
    pub needs: &'static [Need],
}

/// What the columns of a text file are, where it can be more than one thing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Layout {
    /// Heights, every row a row of the map.
    Matrix,
    /// Coordinates and a height: x y z, or x z of a profile.
    List,
    /// Positions, then the heights of one or more traces at them: x z z z.
    Traces,
}

impl Named for Layout {
    const NAMES: &'static [(Self, &'static str)] =
        &[(Self::Matrix, "matrix"), (Self::List, "list"), (Self::Traces, "traces")];
}

/// The decimal mark of the numbers in a text file; the other mark then parts thousands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum DecimalMark {
    /// 1.5
    Point,
    /// 1,5
    Comma,
}

impl Named for DecimalMark {
    const NAMES: &'static [(Self, &'static str)] =
        &[(Self::Point, "point"), (Self::Comma, "comma")];
}

impl DecimalMark {
    pub(crate) fn char(self) -> char {
        match self {
            Self::Point => '.',
            Self::Comma => ',',
        }
    }
}
