//! What the columns of a text file are, and how its numbers are written.

use contact_types::Named;

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
