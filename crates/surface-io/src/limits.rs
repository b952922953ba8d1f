//! What a file may cost.

use crate::error::ReadError;

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
