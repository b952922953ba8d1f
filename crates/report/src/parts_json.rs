//! Parts of results that several answers have, for other programs: intervals and budget of a load, what has yielded, what
//! a contact conducts, its leak, a pair of bodies. SI units.

use crate::messages::conduction::{conductance, kinds};
use contact_accuracy::{Budget, Estimate, Leak, Leaks, NotSolved};
use contact_compare::{
    Body, Comparison, Conducted, DeterministicPoint, Diagnostics, End, GapGas, LeakRequest,
    PairOrigin, SurfaceComparison,
};
use contact_types::Named;
use serde_json::{Map, Value, json};

/// What is known of a solution: how it was found, from the fraction of points that touch, its approach (m) and its
/// diagnostics; the errors of its numbers; and where bodies yield the area at the hardness, the share of the load that it
/// carries, and the rest of what touches. The errors are `null` of a load without a solution.
///
/// Intervals `[low, high]` of every number: `NAME_interval` as the number of this map (of what was prescribed, a load
/// or a gap, the number itself twice); `NAME_prediction_interval` as a number of the surface, with the sampling
/// variability; `null` where there is none. Stiffness (Pa/m) and its intervals are `null` if it was not computed.
/// An end that is not known is 0 or `null`. `budget` lists the half widths by source.
pub fn solution_keys(found: Option<([f64; 2], &Diagnostics, &Budget)>) -> Map<String, Value> {
    let budget = found.map(|(.., budget)| budget);
    let area = budget.map(|b| b.area);
    let gap = budget.and_then(|b| b.mean_gap);
    let stiffness = budget.and_then(|b| b.stiffness);
    let load = budget.map(|b| b.mean_pressure);
    let real = budget.and_then(Budget::real_pressure);
    let mut keys = keys_of(json!({
        "area_interval_reason": area.and_then(|a| Some(a.half_width().err()?.to_string())),
        "real_pressure": real.map(|r| r.value),
        "stiffness": stiffness.map(|s| s.value),
        "interpolation_indicator": budget.and_then(|b| b.indicator),
        "budget": {
            "area": area.map(sources), "mean_gap": gap.map(sources), "stiffness": stiffness.map(sources),
        },
    }));
    for (name, e) in
        [("mean_pressure", load), ("area", area), ("mean_gap", gap), ("stiffness", stiffness)]
    {
        let ends = [e.and_then(|e| e.interval().ok()), e.and_then(|e| e.prediction())];
        intervals(&mut keys, name, ends);
    }
    // An area that may be 0 leaves the pressure without an upper end, which JSON writes as null.
    let ends = [real.and_then(|r| r.interval), real.and_then(|r| r.prediction)];
    intervals(&mut keys, "real_pressure", ends);
    let of = found.map(|(_, d, _)| d);
    keys.extend(keys_of(json!({
        "touching_fraction": found.map(|([touching, _], ..)| touching),
        "approach": found.map(|([_, approach], ..)| approach),
        "max_pressure": of.map(|d| d.max_pressure),
        "stopped_at_rounding": of.is_some_and(|d| d.end == End::Rounding),
        "iterations": of.map(|d| d.iterations),
        "transforms": of.map(|d| d.transforms),
        "seconds": of.map(|d| d.seconds),
        "residuals": of.map(|d| &d.residuals),
        "duality_gap": of.map(|d| d.duality_gap),
    })));
    let Some(([touching, _], d, _)) = found else { return keys };
    keys.extend(keys_of(json!({
        "energy_bound": d.energy_bound,
        "contact_pixels": d.contact_pixels,
        "contact_perimeter": d.contact_perimeter,
    })));
    if let Some(y) = d.yielded {
        keys.extend(keys_of(json!({
            "saturated_fraction": y.area_fraction,
            "plastic_load_fraction": y.load_share,
            // Rounded sums: no area is below 0.
            "elastic_area_fraction": (touching - y.area_fraction).max(0.0),
        })));
    }
    keys
}

pub(crate) fn keys_of(object: Value) -> Map<String, Value> {
    if let Value::Object(keys) = object { keys } else { Map::new() }
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

/// What a joint conducts, as keys of a point: `electrical_conductance` (S/m²),
/// `thermal_conductance`, `gas_conductance` and their sum `joint_conductance` (W/m²/K); `electrical_resistance` (Ω) and
/// `thermal_resistance` (K/W, with the gas if there is one) of the nominal area, if that is known; each with `_interval` of this map and
/// `_prediction_interval` of the surface; `electrical_resistance_one_spot`, `thermal_resistance_one_spot`, Holm's. JSON has
/// no infinity: no resistance is 0, no end of a number `null`.
pub fn conducted_keys(found: &Conducted) -> Map<String, Value> {
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
        keys.insert(format!("{name}_conductance"), json!(h.value));
        intervals(&mut keys, &format!("{name}_conductance"), ends);
    }
    let both = found.resistances().into_iter().zip(found.one_spot);
    for (name, (resistance, spot)) in ["electrical", "thermal"].into_iter().zip(both) {
        let Some(r) = resistance else { continue };
        keys.insert(format!("{name}_resistance"), json!(r.value));
        intervals(&mut keys, &format!("{name}_resistance"), [r.interval, r.prediction]);
        keys.insert(format!("{name}_resistance_one_spot"), json!(spot));
    }
    keys
}

/// The intervals of a number, of this map and of the surface; `null` where an end is infinite.
fn intervals(
    keys: &mut Map<String, Value>,
    name: &str,
    [interval, prediction]: [Option<[f64; 2]>; 2],
) {
    keys.insert(format!("{name}_interval"), json!(interval));
    keys.insert(format!("{name}_prediction_interval"), json!(prediction));
}

/// A gas with what is taken of it: conductivity (W/m/K), mean free path (m), length of the temperature jumps M (m).
pub fn gas_json(gas: &GapGas) -> Value {
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
        let value = |kind| json!(stiffness.map(|k| conductance(kind, k)));
        let kinds = kinds(found).into_iter();
        let each = kinds.map(|kind| (format!("{}_conductance", kind.name), value(kind)));
        each.chain([("stiffness".into(), json!(stiffness))]).collect()
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
    let point = |(i, point): (usize, &DeterministicPoint)| {
        let mut all = all(found.stiffness[i]);
        all.extend(surface.conducted(i).as_ref().map(conducted_keys).unwrap_or_default());
        all.insert("mean_pressure".into(), json!(point.mean_pressure));
        Value::Object(all)
    };
    let points: Vec<Value> = surface.deterministic.iter().enumerate().map(point).collect();
    json!({
        "area": found.joint.area,
        "gas": found.joint.gas.as_ref().map(gas_json),
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

/// What was asked, and whether the gap is that of bodies that yield.
pub fn leak_json(asked: &LeakRequest, yields: bool) -> Value {
    json!({
        "axes": asked.along.axes().iter().map(|axis| axis.name()).collect::<Vec<_>>(),
        "gap": if yields { "yielded" } else { "elastic" },
        "viscosity": asked.seal.map(|s| s.viscosity),
        "pressure_drop": asked.seal.map(|s| s.pressure_drop),
        "seal_length": asked.seal.map(|s| s.length),
        "seal_width": asked.seal.map(|s| s.width),
    })
}

/// A load: along each axis, and what closed forms make of the same gap.
pub fn leak_point_json(asked: &LeakRequest, leaks: &Leaks) -> Value {
    let plates = leaks.mean_gap.powi(3);
    let mut object = Map::new();
    for (axis, found) in &leaks.along {
        object.insert(axis.name().to_owned(), along(asked, found, plates));
    }
    let form = |(name, permeability, seconds): (&str, f64, f64)| {
        let error = |found: &Result<Leak, NotSolved>| found.as_ref().ok()?.error_of(permeability);
        let along =
            leaks.along.iter().map(|(axis, found)| (axis.name().to_owned(), json!(error(found))));
        let errors: Map<String, Value> = along.collect();
        json!({ "name": name, "permeability": permeability, "error": errors, "seconds": seconds })
    };
    object.insert("closed_forms".to_owned(), json!(leaks.closed_forms().map(form)));
    object.insert("seconds".to_owned(), json!(leaks.seconds[0]));
    Value::Object(object)
}

fn along(asked: &LeakRequest, found: &Result<Leak, NotSolved>, plates: f64) -> Value {
    let leak = match found {
        Ok(leak) => leak,
        Err(error) => return json!({ "error": error.to_string() }),
    };
    let (k, flow) = (leak.permeability(), &leak.flow);
    let rate = |k: f64| asked.seal.map(|seal| seal.rate(k));
    let interval = leak.interval();
    json!({
        "channel": leak.channel(),
        "permeability": k,
        "interval": interval,
        "flow_factor": k.map(|k| k / plates).filter(|f| f.is_finite()),
        "rate": k.and_then(rate),
        "rate_interval": interval.and_then(|ends| Some([rate(ends[0])?, rate(ends[1])?])),
        "bottleneck": flow.bottleneck.map(|b| json!({
            "row": b.place[0], "column": b.place[1], "height": b.height, "points_across": b.width,
        })),
        "arithmetic_faces": flow.arithmetic,
        "coarser": leak.coarser,
        "imbalance": flow.imbalance,
    })
}

/// Under `leak` of a surface of a study: what was asked and a point for each load; `null` unless it was.
pub(crate) fn leak_of_study(surface: &SurfaceComparison, comparison: &Comparison) -> Value {
    let settings = &comparison.settings;
    settings.leak.map_or(Value::Null, |asked| {
        let mut json = leak_json(&asked, settings.hardness.is_some());
        let points =
            surface.leaks.iter().map(|leaks| leaks.as_ref().map(|l| leak_point_json(&asked, l)));
        json["points"] = points.collect();
        json
    })
}

/// Both bodies, how they lie, and how far their moments are from adding up. Lengths `[y, x]`.
pub fn pair_json(pair: &PairOrigin) -> Value {
    let mut object = json!({
        "first": { "name": pair.names[0], "origin": pair.bodies[0].without_folders() },
        "second": { "name": pair.names[1], "origin": pair.bodies[1].without_folders() },
        "flip": pair.placing.flip.name(),
        "shift_asked": pair.placing.shift,
    });
    let Some((placed, independence)) = &pair.found else { return object };
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
pub fn bodies_json(pair: Option<&PairOrigin>, bodies: &[Body]) -> Value {
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
