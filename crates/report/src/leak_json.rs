//! The leak through the gap, for other programs. SI units.

use contact_accuracy::{Leak, Leaks, NotSolved};
use contact_compare::{Comparison, LeakRequest, SurfaceComparison};
use contact_types::Named;
use serde_json::{Map, Value, json};

/// What was asked, and whether the gap is that of bodies that yield.
pub fn leak(asked: &LeakRequest, yields: bool) -> Value {
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
pub fn point(asked: &LeakRequest, leaks: &Leaks) -> Value {
    let plates = leaks.mean_gap.powi(3);
    let mut object = Map::new();
    for (axis, found) in &leaks.along {
        object.insert(axis.name().to_owned(), along(asked, found, plates));
    }
    let form = |(name, permeability, seconds): (&str, f64, f64)| {
        let error = |found: &Result<Leak, NotSolved>| found.as_ref().ok()?.error_of(permeability);
        let errors: Map<String, Value> = leaks
            .along
            .iter()
            .map(|(axis, found)| (axis.name().to_owned(), json!(error(found))))
            .collect();
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
pub(crate) fn of_study(surface: &SurfaceComparison, comparison: &Comparison) -> Value {
    let settings = &comparison.settings;
    settings.leak.map_or(Value::Null, |asked| {
        let mut json = leak(&asked, settings.hardness.is_some());
        let points = surface.leaks.iter().map(|leaks| leaks.as_ref().map(|l| point(&asked, l)));
        json["points"] = points.collect();
        json
    })
}
