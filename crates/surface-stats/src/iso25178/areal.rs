//! All areal parameters of a map, under the symbols of the standard.

use super::hybrid::Hybrid;
use super::material_ratio::MaterialRatioCurve;
use super::spatial::{Spatial, texture_direction};
use crate::{Edges, HeightStatistics, StatsError};
use contact_types::HeightMap;

/// A parameter of ISO 25178-2.
#[derive(Clone, Copy, Debug)]
pub struct IsoParameter {
    /// In the standard.
    pub symbol: &'static str,
    /// SI; `%` of a ratio that is given as a fraction, empty for a pure number, degrees from x for Std.
    pub unit: &'static str,
    /// Its value, if the map has one.
    pub value: Option<f64>,
}

/// Height, hybrid, spatial, material-ratio and volume parameters of a levelled map.
///
/// # Errors
/// [`StatsError::TooFewPoints`] below 10 points, [`StatsError::TooSmall`] below 2 x 2, [`StatsError::OutOfRange`],
/// [`StatsError::Surface`] if an open map is too large to be continued by zeros.
pub fn parameters(map: &HeightMap, edges: Edges) -> Result<Vec<IsoParameter>, StatsError> {
    let curve = MaterialRatioCurve::of(map)?;
    let heights = HeightStatistics::of(map);
    let hybrid = Hybrid::of(map)?;
    let spatial = Spatial::of(map, edges)?;
    let direction = texture_direction(map)?;
    let (core, volumes) = (curve.core(), curve.volumes());
    let (peak, pit) = (heights.peak_height, heights.pit_depth);
    let all = [
        ("Sq", "m", Some(heights.rms_height)),
        ("Sa", "m", Some(heights.mean_abs_height)),
        ("Ssk", "", heights.skewness),
        ("Sku", "", heights.kurtosis),
        ("Sp", "m", Some(peak)),
        ("Sv", "m", Some(pit)),
        ("Sz", "m", Some(peak + pit)),
        ("Sdq", "", Some(hybrid.rms_gradient)),
        ("Sdq_seven_point", "", hybrid.rms_gradient_seven_point),
        ("Sdr", "%", Some(hybrid.developed_area_ratio)),
        ("Sal", "m", spatial.autocorrelation_length),
        ("Str", "", spatial.texture_aspect_ratio),
        ("Std", "°", direction),
        ("Sk", "m", Some(core.core_height)),
        ("Spk", "m", Some(core.reduced_peak_height)),
        ("Svk", "m", Some(core.reduced_valley_depth)),
        ("Smr1", "%", Some(core.peak_ratio)),
        ("Smr2", "%", Some(core.valley_ratio)),
        ("Sxp", "m", Some(curve.peak_extreme_height())),
        ("Vmp", "m³/m²", Some(volumes.peak_material)),
        ("Vmc", "m³/m²", Some(volumes.core_material)),
        ("Vvc", "m³/m²", Some(volumes.core_void)),
        ("Vvv", "m³/m²", Some(volumes.valley_void)),
    ];
    Ok(all.map(|(symbol, unit, value)| IsoParameter { symbol, unit, value }).to_vec())
}
