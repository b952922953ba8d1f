//! One load that was solved for, as an object.

use crate::failure::variant;
use contact_accuracy::{Answered, Leaks, Map, Numbers};
use contact_compare::{Budget, Conducted, NoUncertainty};
use fft_bem_solver::{End, Load, Solution, SolverError};
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
    /// The solution without its maps; none of a load that was refused.
    pub solution: Option<Solution>,
    /// The errors of its numbers.
    pub budget: Option<Budget>,
    /// Why its area has no uncertainty, if it has none.
    pub(crate) without_uncertainty: Option<NoUncertainty>,
    /// Its numbers on twice the points, if they were solved.
    pub finer: Option<Numbers>,
    /// What it conducts, if that was asked for.
    pub conducted: Option<Conducted>,
    /// What leaks through it, if that was asked for.
    pub leak: Option<Leaks>,
    /// True if it was solved to the tolerance.
    pub converged: bool,
}

impl Point {
    pub(crate) fn of(load: Load, answered: &Answered) -> Self {
        let Answered { solution, budget, coarser, finer, .. } = answered;
        let mut json = object(load, Some((solution, budget)), None);
        json["coarser"] = json!(coarser.iter().map(numbers).collect::<Vec<_>>());
        json["finer"] = json!(finer.as_ref().map(numbers));
        Self { budget: Some(*budget), finer: *finer, converged: true, ..Self::bare(load, json) }
    }

    pub(crate) fn of_error(load: Load, error: &SolverError, known: &Map) -> Self {
        let found = error.solution().map(|s| (s, Budget::of_iterate(s, known)));
        let json = object(load, found.as_ref().map(|(s, b)| (*s, b)), Some(error));
        Self { budget: found.map(|(_, budget)| budget), ..Self::bare(load, json) }
    }

    fn bare(load: Load, json: Value) -> Self {
        Self {
            load,
            json,
            force: None,
            solution: None,
            budget: None,
            without_uncertainty: None,
            finer: None,
            conducted: None,
            leak: None,
            converged: false,
        }
    }
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

fn object(load: Load, found: Option<(&Solution, &Budget)>, error: Option<&SolverError>) -> Value {
    let error_json = error.map(|e| json!({ "kind": variant(e), "message": e.to_string() }));
    let Some((solution, budget)) = found else {
        let asked = if let Load::MeanPressure(p) = load { Some(p) } else { None };
        let json = json!({
                "mean_pressure": asked, "touching_fraction": null, "area_fraction": null,
                "mean_gap": if let Load::MeanGap(g) = load { Some(g) } else { None },
                "approach": null, "max_pressure": null,
                "converged": false, "stopped_at_rounding": false, "iterations": null,
                "transforms": null, "seconds": null,
                "residuals": null, "duality_gap": null, "error": error_json,
        });
        return with(json, contact_report::budget_keys(None));
    };
    let (state, d) = (&solution.state, &solution.diagnostics);
    let json = json!({
        "mean_pressure": state.mean_pressure,
        "touching_fraction": solution.touching_fraction(),
        "area_fraction": state.area_fraction,
        "mean_gap": state.mean_gap,
        "approach": solution.approach,
        "max_pressure": d.max_pressure,
        "converged": error.is_none(),
        "stopped_at_rounding": d.end == End::Rounding,
        "iterations": d.iterations,
        "transforms": d.transforms,
        "seconds": d.seconds,
        "residuals": d.residuals,
        "duality_gap": d.duality_gap,
        "energy_bound": d.energy_bound,
        "contact_pixels": d.contact_pixels,
        "contact_perimeter": d.contact_perimeter,
        "exact": d.exact,
        "error": error_json,
    });
    let json = with(json, contact_report::budget_keys(Some(budget)));
    match d.yielded {
        None => json,
        yielded => with(json, contact_report::yield_keys(yielded, solution.touching_fraction())),
    }
}

/// An object with more keys.
pub(crate) fn with(mut object: Value, keys: impl IntoIterator<Item = (String, Value)>) -> Value {
    if let Value::Object(own) = &mut object {
        own.extend(keys);
    }
    object
}
