//! Areal parameters of ISO 25178-2 for `stats --iso`, under the symbols of the standard.

use crate::text::{self, Table};
use contact_types::HeightMap;
use serde_json::{Value, json};
use surface_stats::iso25178::{
    Autocorrelation, CoreRoughness, Hybrid, MaterialRatioCurve, Spatial, Volumes, texture_direction,
};
use surface_stats::{Edges, HeightStatistics, StatsError};

/// Height, hybrid, spatial, material-ratio and volume parameters.
pub(crate) struct Iso {
    heights: HeightStatistics,
    hybrid: Hybrid,
    spatial: Spatial,
    direction: Option<f64>,
    core: CoreRoughness,
    volumes: Volumes,
    peak_extreme_height: f64,
}

impl Iso {
    /// Of a levelled map.
    pub(crate) fn of(map: &HeightMap, edges: Edges) -> Result<Self, StatsError> {
        let curve = MaterialRatioCurve::of(map)?;
        Ok(Self {
            heights: HeightStatistics::of(map),
            hybrid: Hybrid::of(map)?,
            spatial: Autocorrelation::of(map, edges)?.spatial(),
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

    pub(crate) fn describe(&self) -> String {
        let or_dash = |x: Option<String>| x.unwrap_or_else(|| "–".to_owned());
        let joined = |lengths: &[f64]| {
            lengths.iter().map(|&l| text::length(l)).collect::<Vec<_>>().join(", ")
        };
        let mut t = Table::default();
        let Self { heights, hybrid, spatial, direction, core, volumes, peak_extreme_height } = self;
        let (peak, pit) = (heights.peak_height, heights.pit_depth);
        t.row("Sp, Sv, Sz", joined(&[peak, pit, peak + pit]));
        let seven = or_dash(hybrid.rms_gradient_seven_point.map(text::number));
        t.row("Sdq", format!("{}, seven-point {seven}", text::number(hybrid.rms_gradient)));
        t.row("Sdr", text::percent(hybrid.developed_area_ratio));
        t.row("Sal", or_dash(spatial.autocorrelation_length.map(text::length)));
        t.row("Str", or_dash(spatial.texture_aspect_ratio.map(text::number)));
        t.row("Std", or_dash(direction.map(|d| format!("{}° from x", text::digits(d)))));
        let heights = [core.core_height, core.reduced_peak_height, core.reduced_valley_depth];
        t.row("Sk, Spk, Svk", joined(&heights));
        let ratios = [core.peak_ratio, core.valley_ratio].map(text::percent);
        t.row("Smr1, Smr2", ratios.join(", "));
        t.row("Sxp", text::length(*peak_extreme_height));
        let Volumes { peak_material, core_material, core_void, valley_void } = *volumes;
        let shown = joined(&[peak_material, core_material, core_void, valley_void]);
        t.row("Vmp, Vmc, Vvc, Vvv", format!("{shown} (m³ per m²)"));
        t.to_string()
    }
}
