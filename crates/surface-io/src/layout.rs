//! What the columns of a text file are, and how its numbers are written.

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

impl Layout {
    /// Every layout.
    pub const ALL: &'static [Self] = &[Self::Matrix, Self::List, Self::Traces];

    /// Its name in one word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Matrix => "matrix",
            Self::List => "list",
            Self::Traces => "traces",
        }
    }

    /// The layout of that name.
    pub fn of_name(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|layout| layout.name() == name)
    }
}

/// The decimal mark of the numbers in a text file; the other mark then parts thousands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum DecimalMark {
    /// 1.5
    Point,
    /// 1,5
    Comma,
}

impl DecimalMark {
    /// Both.
    pub const ALL: &'static [Self] = &[Self::Point, Self::Comma];

    /// Its name in one word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Point => "point",
            Self::Comma => "comma",
        }
    }

    /// The mark of that name.
    pub fn of_name(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|mark| mark.name() == name)
    }

    pub(crate) fn char(self) -> char {
        match self {
            Self::Point => '.',
            Self::Comma => ',',
        }
    }
}
