//! What a caller says about a file.

use crate::layout::{DecimalMark, Layout};
use crate::limits::Limits;

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
///
/// ```
/// use surface_io::ReadOptions;
///
/// let options = ReadOptions::default().with_pixel([1e-6, 1e-6]).with_height_unit(1e-9);
/// assert_eq!(options.pixel, Some([1e-6, 1e-6]));
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
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

impl ReadOptions {
    /// Reads this channel: its name, or `#2` for the second.
    #[must_use]
    pub fn with_channel(self, name: impl Into<String>) -> Self {
        Self { channel: Some(name.into()), ..self }
    }

    /// `[dy, dx]` in metres, whatever the file says.
    #[must_use]
    pub fn with_pixel(self, pixel: [f64; 2]) -> Self {
        Self { pixel: Some(pixel), ..self }
    }

    /// Metres per unit of the coordinates x and y, if the file gives no unit for them.
    #[must_use]
    pub fn with_lateral_unit(self, metres: f64) -> Self {
        Self { lateral_unit: Some(metres), ..self }
    }

    /// Metres per unit of the heights, if the file gives no unit.
    #[must_use]
    pub fn with_height_unit(self, metres: f64) -> Self {
        Self { height_unit: Some(HeightUnit::IfSilent(metres)), ..self }
    }

    /// Metres per unit of the heights, whatever the file says.
    #[must_use]
    pub fn overriding_height_unit(self, metres: f64) -> Self {
        Self { height_unit: Some(HeightUnit::Always(metres)), ..self }
    }

    /// What the columns of a text file are.
    #[must_use]
    pub fn with_layout(self, layout: Layout) -> Self {
        Self { layout: Some(layout), ..self }
    }

    /// The decimal mark of a text file.
    #[must_use]
    pub fn with_decimal(self, mark: DecimalMark) -> Self {
        Self { decimal: Some(mark), ..self }
    }

    /// One more mark of missing points.
    #[must_use]
    pub fn with_missing(mut self, mark: impl Into<String>) -> Self {
        self.missing.push(mark.into());
        self
    }

    /// What reading may cost.
    #[must_use]
    pub fn with_limits(self, limits: Limits) -> Self {
        Self { limits, ..self }
    }
}
