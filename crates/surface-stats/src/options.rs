//! What a user can choose about statistics.

use crate::{Edges, Level, StatsError};
use contact_types::HeightMap;

/// How statistics are taken.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StatsOptions {
    /// What is removed by least squares first. The mean is always taken off: `None` is the same as `Mean` here, and so
    /// is `Auto` where `edges` say that the map repeats.
    pub level: Level,
    /// What lies beyond the edges.
    pub edges: Edges,
    /// Shortest and longest wavelength of the fractal fit (m); by default from the cut-off to the
    /// roll-off, as found among the waves that stand out of the noise.
    pub fractal_range: Option<[f64; 2]>,
    /// Points of the map that were filled in, as its reader counted; passed through.
    pub missing: usize,
    /// Height step of the data as measured (m), where filling or removing a form has hidden it;
    /// by default it is looked for in the map.
    pub height_step: Option<f64>,
}

impl StatsOptions {
    /// The form taken off this map.
    pub(crate) fn level_on(&self, map: &HeightMap) -> Result<Level, StatsError> {
        match (self.level, self.edges) {
            (Level::Auto, Edges::Periodic) => Ok(Level::Mean),
            (level, _) => level.on(map),
        }
    }
}

/// Whether the wavelengths of a fit make a range.
pub(crate) fn check_range(range: Option<[f64; 2]>) -> Result<(), StatsError> {
    let Some([short, long]) = range else { return Ok(()) };
    let requirement = "wavelengths must be finite and greater than 0, the shorter one first";
    let positive = short.is_finite() && short > 0.0;
    StatsError::require("shortest wavelength of the fractal fit", short, positive, requirement)?;
    let longer = long.is_finite() && long > short;
    StatsError::require("longest wavelength of the fractal fit", long, longer, requirement)
}
