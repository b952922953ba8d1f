//! Areal parameters of ISO 25178-2 under the symbols of the standard.

use contact_types::HeightMap;
use serde_json::{Value, json};
use surface_stats::iso25178::{
    CoreRoughness, Hybrid, MaterialRatioCurve, Spatial, Volumes, texture_direction,
};
use surface_stats::{Edges, HeightStatistics, StatsError};

/// Height, hybrid, spatial, material-ratio and volume parameters.
#[derive(Clone, Debug)]
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
    /// [`StatsError`] of a map that is too small or flat.
    pub(crate) fn of(map: &HeightMap, edges: Edges) -> Result<Self, StatsError> {
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

    /// Lengths and volumes per area in m, Std in degrees, ratios as fractions.
    pub(crate) fn json(&self) -> Value {
        let Self { heights, hybrid, spatial, direction, core, volumes, peak_extreme_height } = self;
        json!({
            "Sq": heights.rms_height,
            "Sa": heights.mean_abs_height,
            "Ssk": heights.skewness,
            "Sku": heights.kurtosis,
            "Sp": heights.peak_height,
            "Sv": heights.pit_depth,
            "Sz": heights.peak_height + heights.pit_depth,
            "Sdq": hybrid.rms_gradient,
            "Sdq_seven_point": hybrid.rms_gradient_seven_point,
            "Sdr": hybrid.developed_area_ratio,
            "Sal": spatial.autocorrelation_length,
            "Str": spatial.texture_aspect_ratio,
            "Std": direction,
            "Sk": core.core_height,
            "Spk": core.reduced_peak_height,
            "Svk": core.reduced_valley_depth,
            "Smr1": core.peak_ratio,
            "Smr2": core.valley_ratio,
            "Sxp": peak_extreme_height,
            "Vmp": volumes.peak_material,
            "Vmc": volumes.core_material,
            "Vvc": volumes.core_void,
            "Vvv": volumes.valley_void,
        })
    }
}
