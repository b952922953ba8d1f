//! What a caller says about a file, and what it may cost.

use crate::error::ReadError;
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

/// Upper bounds on what reading one file may cost. A file that asks for more is refused with
/// [`ReadError::Limit`] before anything is allocated.
///
/// The memory used is at most the file, one decompressed copy of it, and the heights in `f64`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Limits {
    /// Largest file in bytes (default 4 GiB).
    pub file_bytes: u64,
    /// Most bytes that the members of an archive, or any other compressed part, may unpack to (default 4 GiB).
    pub unpacked_bytes: u64,
    /// Most points of one map (default 2^28, that is 16384 x 16384; 2 GiB of heights).
    pub points: u64,
    /// Most channels, blocks or XML elements in a list (default 65536).
    pub items: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Self { file_bytes: 4 << 30, unpacked_bytes: 4 << 30, points: 1 << 28, items: 1 << 16 }
    }
}

impl Limits {
    pub(crate) fn check_points(
        &self,
        format: &'static str,
        shape: [usize; 2],
    ) -> Result<(), ReadError> {
        let value = (shape[0] as u64).saturating_mul(shape[1] as u64);
        check(format, "points of one map", value, self.points)
    }

    pub(crate) fn check_items(&self, format: &'static str, value: u64) -> Result<(), ReadError> {
        check(format, "listed items", value, self.items)
    }

    pub(crate) fn check_unpacked(&self, format: &'static str, value: u64) -> Result<(), ReadError> {
        check(format, "unpacked bytes", value, self.unpacked_bytes)
    }
}

fn check(
    format: &'static str,
    quantity: &'static str,
    value: u64,
    limit: u64,
) -> Result<(), ReadError> {
    if value > limit {
        return Err(ReadError::Limit { format, quantity, value, limit });
    }
    Ok(())
}
