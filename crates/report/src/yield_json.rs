//! What has yielded, as keys of a point: the same for `solve` and `compare`.

use contact_compare::Yielded;
use serde_json::{Map, Value, json};

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
