//! What a contact conducts, for other programs. SI units.

use crate::words::conduction::{conductance, kinds};
use compare::SurfaceComparison;
use serde_json::{Map, Value, json};

/// Under `conduction` of a surface: stiffness and conductances at each load, what correlations of the field say,
/// and the headline without the shortest octaves. JSON has no infinity: full contact is `null`.
pub(crate) fn conduction(surface: &SurfaceComparison) -> Value {
    let Some(found) = &surface.conduction else { return Value::Null };
    let area = surface.surface.grid().area();
    let all = |stiffness: Option<f64>| -> Map<String, Value> {
        let mut keys = Map::new();
        keys.insert("stiffness".into(), json!(stiffness));
        for kind in kinds(found) {
            let value = stiffness.map(|k| conductance(kind, k));
            keys.insert(format!("{}_conductance", kind.name), json!(value));
            let of_map = value.map(|h| h * area);
            keys.insert(format!("{}_conductance_of_map", kind.name), json!(of_map));
        }
        keys
    };
    let line = |values: &[Option<f64>]| -> Value { values.iter().map(|k| all(*k)).collect() };
    let points: Vec<Value> = surface
        .deterministic
        .iter()
        .zip(&found.stiffness)
        .map(|(point, k)| {
            let mut keys = all(*k);
            keys.insert("mean_pressure".into(), json!(point.mean_pressure));
            Value::Object(keys)
        })
        .collect();
    json!({
        "points": points,
        "theories": found.theories.iter().map(|theory| json!({
            "model": theory.name, "gamma": theory.gamma, "points": line(&theory.stiffness),
        })).collect::<Vec<_>>(),
        "mikic": line(&found.mikic),
        "cooper_mikic_yovanovich": (!found.yovanovich.is_empty()).then(|| line(&found.yovanovich)),
        "octaves": found.octaves.iter().map(|o| {
            let mut keys = all(Some(o.stiffness));
            keys.insert("shortest_wavelength".into(), json!(o.shortest));
            keys.insert("area_fraction_corrected".into(), json!(o.area));
            Value::Object(keys)
        }).collect::<Vec<_>>(),
        "conductance_hardly_depends_on_shortest_waves": found.is_sturdy(),
        "seconds": found.seconds,
    })
}
