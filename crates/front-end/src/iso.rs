//! Areal parameters of ISO 25178-2 under the symbols of the standard.

use serde_json::{Value, json};
use surface_stats::iso25178::Iso;

/// Lengths and volumes per area in m, Std in degrees, ratios as fractions.
pub(crate) fn json(iso: &Iso) -> Value {
    let Iso { heights, hybrid, spatial, direction, core, volumes, peak_extreme_height } = iso;
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
