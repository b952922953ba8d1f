//! A pair of bodies as an object.

use contact_compare::{Body, PairOrigin};
use contact_types::Named;
use serde_json::{Value, json};

/// Both bodies, how they lie, and how far their moments are from adding up. Lengths `[y, x]`.
pub fn pair(pair: &PairOrigin) -> Value {
    let mut object = json!({
        "first": { "name": pair.names[0], "origin": pair.bodies[0].without_folders() },
        "second": { "name": pair.names[1], "origin": pair.bodies[1].without_folders() },
        "flip": pair.placing.flip.name(),
        "shift_asked": pair.placing.shift,
    });
    let Some(found) = &pair.found else { return object };
    let (placed, independence) = (&found.placed, &found.independence);
    for (k, key) in ["first", "second"].into_iter().enumerate() {
        let body = &mut object[key];
        body["shape"] = json!(placed.grids[k].shape());
        body["pixel"] = json!(placed.grids[k].pixel());
        body["share"] = json!(placed.shares[k]);
        body["interpolated"] = json!(placed.resampled[k]);
        body["moments"] = json!(independence.bodies[k]);
    }
    object["shift"] = json!(placed.shift);
    object["is_rolled"] = json!(placed.is_rolled);
    object["shape"] = json!(placed.common.shape());
    object["pixel"] = json!(placed.common.pixel());
    object["moments"] = json!({
        "of_the_models": "composite",
        "composite": independence.composite,
        "sum": independence.sum(),
        "composite_over_sum_less_1": independence.excess,
        "by_chance": independence.chance,
        "independent": independence.holds(),
    });
    object
}

/// The elastic bodies, of a pair by their names; null where only E* was given.
pub fn bodies(pair: Option<&PairOrigin>, bodies: &[Body]) -> Value {
    if bodies.is_empty() {
        return Value::Null;
    }
    let name = |k: usize| pair.map(|pair| pair.names[k].as_str());
    let elastic = bodies.iter().enumerate().map(|(k, body)| {
        json!({ "name": name(k), "young": body.young, "poisson": body.poisson, "rigid": false })
    });
    let mut all: Vec<Value> = elastic.collect();
    if bodies.len() == 1 {
        all.push(json!({ "name": name(1), "young": null, "poisson": null, "rigid": true }));
    }
    json!(all)
}
