//! Budget, and what has yielded, as keys of a point in JSON: the same for `solve --json` and `results.json`.

use contact_accuracy::{Budget, Estimate};
use contact_compare::Yielded;
use serde_json::{Map, Value, json};

/// Intervals `[low, high]` of every number: `NAME_interval` as the number of this map (of what was prescribed, a load
/// or a gap, the number itself twice); `NAME_prediction_interval` as a number of the surface, with the sampling
/// variability; `null` where there is none. Stiffness (Pa/m) and its intervals are `null` if it was not computed.
/// An end that is not known is 0 or `null`. `budget` lists the half widths by source.
pub fn budget_keys(budget: Option<&Budget>) -> Map<String, Value> {
    let mut keys = Map::new();
    let area = budget.map(|b| b.area);
    let gap = budget.and_then(|b| b.mean_gap);
    let stiffness = budget.and_then(|b| b.stiffness);
    let load = budget.map(|b| b.mean_pressure);
    let all =
        [("mean_pressure", load), ("area", area), ("mean_gap", gap), ("stiffness", stiffness)];
    for (name, estimate) in all {
        let [comparison, prediction] =
            [estimate.and_then(|e| e.interval().ok()), estimate.and_then(|e| e.prediction())];
        keys.insert(format!("{name}_interval"), json!(comparison));
        keys.insert(format!("{name}_prediction_interval"), json!(prediction));
    }
    let reason = area.and_then(|a| Some(a.half_width().err()?.to_string()));
    keys.insert("area_interval_reason".into(), json!(reason));
    let real = budget.and_then(Budget::real_pressure);
    // An area that may be 0 leaves the pressure without an upper end, which JSON writes as null.
    keys.insert("real_pressure".into(), json!(real.map(|r| r.value)));
    keys.insert("real_pressure_interval".into(), json!(real.and_then(|r| r.interval)));
    keys.insert("real_pressure_prediction_interval".into(), json!(real.and_then(|r| r.prediction)));
    keys.insert("stiffness".into(), json!(stiffness.map(|s| s.value)));
    let indicator = budget.and_then(|b| b.indicator);
    let budget = json!({
        "area": area.map(sources),
        "mean_gap": gap.map(sources),
        "stiffness": stiffness.map(sources),
    });
    keys.insert("budget".into(), budget);
    keys.insert("interpolation_indicator".into(), json!(indicator));
    keys
}

fn sources(estimate: Estimate) -> Value {
    let parts = estimate.uncertainty.ok();
    json!({
        "coarser": parts.map(|p| p.coarser),
        "contact_line": parts.map(|p| p.contact_line),
        "counting": parts.map(|p| p.counting),
        "finer": parts.map(|p| p.finer),
        "iteration": parts.map(|p| p.iteration),
        "sampling": estimate.sampling,
        "materials": estimate.materials,
    })
}

/// Names of the keys.
pub const YIELD_KEYS: [&str; 3] =
    ["saturated_fraction", "plastic_load_fraction", "elastic_area_fraction"];

/// Area at the hardness, the share of the load that it carries, and the rest of `touching_fraction`; nothing
/// for elastic bodies.
pub fn yield_keys(yielded: Option<Yielded>, touching: f64) -> Map<String, Value> {
    let Some(Yielded { area_fraction: saturated, load_share, .. }) = yielded else {
        return Map::new();
    };
    // Rounded sums: no area is below 0.
    let rest = (touching - saturated).max(0.0);
    let values = [saturated, load_share, rest];
    YIELD_KEYS.into_iter().zip(values).map(|(key, value)| (key.to_owned(), json!(value))).collect()
}
