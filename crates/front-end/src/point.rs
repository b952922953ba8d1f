//! One load that was solved for, as an object.

use contact_accuracy::{Leaks, Numbers};
use contact_compare::{Conducted, DeterministicAnswer, NoUncertainty};
use fft_bem_solver::Load;
use serde_json::{Value, json};

/// A load that was solved for.
#[derive(Debug)]
pub struct Point {
    /// What was prescribed.
    pub load: Load,
    /// The object that scripts see; once all loads are answered it is part of theirs.
    pub(crate) json: Value,
    /// Its mean pressure as a force (N), if forces were asked for.
    pub force: Option<f64>,
    /// Its numbers; none of a load that was refused.
    pub answer: Option<DeterministicAnswer>,
    /// Why its area has no uncertainty, if it has none.
    pub(crate) without_uncertainty: Option<NoUncertainty>,
    /// What it conducts, if that was asked for.
    pub conducted: Option<Conducted>,
    /// What leaks through it, if that was asked for.
    pub leak: Option<Leaks>,
}

/// The numbers of another rung.
fn numbers(found: &Numbers) -> Value {
    json!({
        "area_fraction": found.area,
        "mean_pressure": found.mean_pressure,
        "mean_gap": found.mean_gap,
        "stiffness": found.stiffness,
    })
}

/// A load with its numbers, if it has any, and why it has none or misses its tolerance.
pub(crate) fn object(
    load: Load,
    found: Option<&DeterministicAnswer>,
    error: Option<Value>,
) -> Value {
    let (pressure, gap) = match (found, load) {
        (Some(a), _) => (Some(a.budget.mean_pressure.value), a.mean_gap),
        (None, Load::MeanPressure(p)) => (Some(p), None),
        (None, Load::MeanGap(g)) => (None, Some(g)),
        _ => (None, None),
    };
    let mut json = json!({
        "mean_pressure": pressure,
        "area_fraction": found.map(|a| a.area_fraction),
        "mean_gap": gap,
        "converged": error.is_none(),
        "error": error,
    });
    let keys = found.map(|a| ([a.touching_fraction, a.approach], &a.diagnostics, &a.budget));
    extend(&mut json, contact_report::solution_keys(keys));
    if let Some(a) = found {
        json["exact"] = json!(a.diagnostics.exact);
        if a.converged {
            json["coarser"] = json!(a.coarser.iter().map(numbers).collect::<Vec<_>>());
            json["finer"] = json!(a.finer.as_ref().map(numbers));
        }
        return json;
    }
    for key in [
        "touching_fraction",
        "approach",
        "max_pressure",
        "iterations",
        "transforms",
        "seconds",
        "residuals",
        "duality_gap",
    ] {
        json[key] = Value::Null;
    }
    json["stopped_at_rounding"] = json!(false);
    json
}

/// Adds keys to an object.
pub(crate) fn extend(object: &mut Value, keys: impl IntoIterator<Item = (String, Value)>) {
    if let Value::Object(own) = object {
        own.extend(keys);
    }
}
