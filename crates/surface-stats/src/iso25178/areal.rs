//! All areal parameters of a map.

use super::material_ratio::MaterialRatioCurve;
use super::spatial::texture_direction;
use super::{CoreRoughness, Hybrid, Spatial, Volumes};
use crate::{Edges, HeightStatistics, StatsError};
use contact_types::HeightMap;

/// Height, hybrid, spatial, material-ratio and volume parameters.
#[derive(Debug, Clone)]
pub struct Iso {
    /// Height parameters.
    pub heights: HeightStatistics,
    /// Slopes and developed area.
    pub hybrid: Hybrid,
    /// From the autocorrelation.
    pub spatial: Spatial,
    /// Std: direction of the texture (degrees from x), if it has one.
    pub direction: Option<f64>,
    /// The Sk family.
    pub core: CoreRoughness,
    /// Volumes per area (m).
    pub volumes: Volumes,
    /// Sxp (m).
    pub peak_extreme_height: f64,
}

impl Iso {
    /// Of a levelled map.
    ///
    /// # Errors
    /// [`StatsError::TooFewPoints`] below 10 points, [`StatsError::TooSmall`] below 2 x 2, [`StatsError::OutOfRange`],
    /// [`StatsError::Surface`] if an open map is too large to be continued by zeros.
    pub fn of(map: &HeightMap, edges: Edges) -> Result<Self, StatsError> {
        let curve = MaterialRatioCurve::of(map)?;
        Ok(Self {
            heights: HeightStatistics::of(map),
            hybrid: Hybrid::of(map)?,
            spatial: Spatial::of(map, edges)?,
            direction: texture_direction(map)?,
            core: curve.core(),
            volumes: curve.volumes(),
            peak_extreme_height: curve.peak_extreme_height(),
        })
    }
}
