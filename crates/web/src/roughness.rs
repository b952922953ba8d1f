//! A map levelled, and the two numbers that say most of it.

use crate::trouble::Trouble;
use contact_compare::Level;
use contact_front_end::Failure;
use contact_types::HeightMap;
use surface_stats::{DirectionalMoments, Edges, HeightStatistics, StatsError};

pub(crate) fn levelled(map: &HeightMap, level: Level) -> Result<HeightMap, Trouble> {
    surface_stats::level(map, level).map_err(|e| Failure::from_error(&e).into())
}

/// The two numbers that say most.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Roughness {
    /// Sq (m).
    pub(crate) height: f64,
    /// Sdq (-), as the statistics of the report.
    pub(crate) gradient: f64,
}

impl Roughness {
    pub(crate) fn of(map: &HeightMap) -> Result<Self, Trouble> {
        let refused = |e: StatsError| Trouble::Refused(Failure::from_error(&e));
        let slopes = DirectionalMoments::of(map, Edges::Open).map_err(refused)?;
        Ok(Self {
            height: HeightStatistics::of(map).rms_height,
            gradient: (slopes.m2_x + slopes.m2_y).sqrt(),
        })
    }
}
