//! Areal parameters of ISO 25178-2 for `stats --iso`, as a table.

use crate::text::{self, Table};
use rough_contact::front_end::Iso;
use rough_contact::surface_stats::iso25178::Volumes;

/// The parameters as a table.
pub(crate) fn describe(iso: &Iso) -> String {
    let or_dash = |x: Option<String>| x.unwrap_or_else(|| "–".to_owned());
    let joined =
        |lengths: &[f64]| lengths.iter().map(|&l| text::length(l)).collect::<Vec<_>>().join(", ");
    let mut t = Table::default();
    let Iso { heights, hybrid, spatial, direction, core, volumes, peak_extreme_height } = iso;
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
