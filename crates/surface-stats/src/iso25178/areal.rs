//! All areal parameters of a map, under the symbols of the standard.

use super::hybrid::{developed_area, seven_point_gradient};
use super::material_ratio::MaterialRatioCurve;
use super::spatial::{spatial, texture_direction};
use crate::differences::by_differences;
use crate::{Edges, StatsError};
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
/// [`StatsError::TooFewPoints`] below 10 points, [`StatsError::TooSmall`] below 3 x 3, [`StatsError::OutOfRange`],
/// [`StatsError::Surface`] if an open map is too large to be continued by zeros.
pub fn parameters(map: &HeightMap, edges: Edges) -> Result<Vec<IsoParameter>, StatsError> {
    let curve = MaterialRatioCurve::of(map)?;
    let (moments, heights, _) = by_differences(map, edges)?;
    let [sal, aspect] = spatial(map, edges)?;
    let direction = texture_direction(map)?;
    let [sk, spk, svk, smr1, smr2] = curve.core();
    let [vmp, vmc, vvc, vvv] = curve.volumes();
    let (peak, pit) = (heights.peak_height, heights.pit_depth);
    let all = [
        ("Sq", "m", Some(heights.rms_height)),
        ("Sa", "m", Some(heights.mean_abs_height)),
        ("Ssk", "", heights.skewness),
        ("Sku", "", heights.kurtosis),
        ("Sp", "m", Some(peak)),
        ("Sv", "m", Some(pit)),
        ("Sz", "m", Some(peak + pit)),
        ("Sdq", "", Some(moments.rms_gradient())),
        ("Sdq_seven_point", "", seven_point_gradient(map)),
        ("Sdr", "%", Some(developed_area(map))),
        ("Sal", "m", sal),
        ("Str", "", aspect),
        ("Std", "°", direction),
        ("Sk", "m", Some(sk)),
        ("Spk", "m", Some(spk)),
        ("Svk", "m", Some(svk)),
        ("Smr1", "%", Some(smr1)),
        ("Smr2", "%", Some(smr2)),
        // Smc(2.5 %) − Smc(50 %)
        ("Sxp", "m", Some(curve.height(0.025) - curve.height(0.5))),
        ("Vmp", "m³/m²", Some(vmp)),
        ("Vmc", "m³/m²", Some(vmc)),
        ("Vvc", "m³/m²", Some(vvc)),
        ("Vvv", "m³/m²", Some(vvv)),
    ];
    Ok(all.map(|(symbol, unit, value)| IsoParameter { symbol, unit, value }).to_vec())
}
