//! What a contact conducts, for other programs. SI units.

use crate::messages::conduction::{conductance, kinds};
use contact_compare::{Conducted, GapGas, SurfaceComparison};
use serde_json::{Map, Value, json};

/// What a joint conducts, as keys of a point: `electrical_conductance` (S/m²),
/// `thermal_conductance`, `gas_conductance` and their sum `joint_conductance` (W/m²/K); `electrical_resistance` (Ω) and
/// `thermal_resistance` (K/W, with the gas if there is one) of the nominal area, if that is known; each with `_interval` of this map and
/// `_prediction_interval` of the surface; `electrical_resistance_one_spot`, `thermal_resistance_one_spot`, Holm's. JSON has
/// no infinity: no resistance is 0, no end of a number `null`.
pub fn keys(found: &Conducted) -> Map<String, Value> {
    let mut keys = Map::new();
    let all = [
        ("electrical", found.electrical),
        ("thermal", found.thermal),
        ("gas", found.gas),
        ("joint", found.joint),
    ];
    for (name, conductance) in all {
        let Some(h) = conductance else { continue };
        let ends =
            [h.estimate.and_then(|e| e.interval().ok()), h.estimate.and_then(|e| e.prediction())];
        number(&mut keys, &format!("{name}_conductance"), h.value, ends);
    }
    let both = found.resistances().into_iter().zip(found.one_spot);
    for (name, (resistance, spot)) in ["electrical", "thermal"].into_iter().zip(both) {
        let Some(r) = resistance else { continue };
        number(&mut keys, &format!("{name}_resistance"), r.value, [r.interval, r.prediction]);
        keys.insert(format!("{name}_resistance_one_spot"), json!(spot));
    }
    keys
}

/// A number and its intervals, of this map and of the surface.
fn number(
    keys: &mut Map<String, Value>,
    name: &str,
    value: f64,
    [interval, prediction]: [Option<[f64; 2]>; 2],
) {
    let finite = |x: f64| if x.is_finite() { json!(x) } else { Value::Null };
    let ends = |ends: Option<[f64; 2]>| json!(ends.map(|ends| ends.map(finite)));
    keys.insert(name.into(), finite(value));
    keys.insert(format!("{name}_interval"), ends(interval));
    keys.insert(format!("{name}_prediction_interval"), ends(prediction));
}

/// A gas with what is taken of it: conductivity (W/m/K), mean free path (m), length of the temperature jumps M (m).
pub fn gas(gas: &GapGas) -> Value {
    let mut json = json!(gas);
    json["conductivity"] = json!(gas.conductivity());
    json["free_path"] = json!(gas.free_path());
    json["jump"] = json!(gas.jump());
    json
}

/// Under `conduction` of a surface: stiffness, conductances and resistances at each load, what theories and correlations of
/// the field say, and the headline without the shortest octaves. JSON has no infinity: full contact is `null`.
pub(crate) fn conduction(surface: &SurfaceComparison) -> Value {
    let Some(found) = &surface.conduction else { return Value::Null };
    let all = |stiffness: Option<f64>| -> Map<String, Value> {
        let mut keys = Map::new();
        keys.insert("stiffness".into(), json!(stiffness));
        for kind in kinds(found) {
            let value = stiffness.map(|k| conductance(kind, k));
            keys.insert(format!("{}_conductance", kind.name), json!(value));
        }
        keys
    };
    let of_theory = |(i, k): (usize, &Option<f64>), gas: &[Option<f64>]| -> Value {
        let mut point = all(*k);
        let of = found.joint.gas.zip(gas.get(i).copied().flatten());
        if let Some((of, gas)) = of {
            let gas = gas * of.conductivity();
            point.insert("gas_conductance".into(), json!(gas));
            let contact = point.get("thermal_conductance").and_then(Value::as_f64);
            point.insert("joint_conductance".into(), json!(contact.map(|h| h + gas)));
        }
        Value::Object(point)
    };
    let points: Vec<Value> = surface
        .deterministic
        .iter()
        .enumerate()
        .map(|(i, point)| {
            let mut all = all(found.stiffness[i]);
            if let Some(conducted) = surface.conducted(i) {
                all.extend(keys(&conducted));
            }
            all.insert("mean_pressure".into(), json!(point.mean_pressure));
            Value::Object(all)
        })
        .collect();
    json!({
        "area": found.joint.area,
        "gas": found.joint.gas.as_ref().map(gas),
        "points": points,
        "theories": found.theories.iter().map(|theory| json!({
            "model": theory.name, "gamma": theory.gamma,
            "points": theory.stiffness.iter().enumerate().map(|k| of_theory(k, &theory.gas)).collect::<Vec<_>>(),
        })).collect::<Vec<_>>(),
        "octaves": found.octaves.iter().map(|o| {
            let mut keys = all(Some(o.stiffness));
            keys.insert("shortest_wavelength".into(), json!(o.shortest));
            keys.insert("area_fraction".into(), json!(o.area));
            Value::Object(keys)
        }).collect::<Vec<_>>(),
        "conductance_hardly_depends_on_shortest_waves": found.is_sturdy(),
        "seconds": found.seconds,
    })
}
