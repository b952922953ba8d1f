//! `results.json`: everything, in SI units, for other programs. Absent numbers are `null`.

use crate::error::ReportError;
use crate::messages;
use crate::messages::finding::finding;
use crate::messages::plan as plan_messages;
use crate::provenance::Provenance;
use contact_accuracy::{AccuracyRequest, Reached};
use contact_compare::{
    Comparison, DeterministicPoint, Finding, ModelComparison, ModelCurve, SurfaceComparison,
};
use contact_types::{ContactState, ModelError, Named};
use serde_json::{Value, json};
use std::io::Write;
use surface_stats::clean::{FormParameters, Record};
use surface_stats::{SurfaceStatistics, Warning};

/// Writes the results.
///
/// # Errors
/// [`ReportError::Io`] or [`ReportError::Json`].
pub fn write(
    comparison: &Comparison,
    provenance: &Provenance,
    out: &mut impl Write,
) -> Result<(), ReportError> {
    serde_json::to_writer_pretty(&mut *out, &self::comparison(comparison, provenance))?;
    writeln!(out)?;
    Ok(())
}

/// The results as one object.
pub fn comparison(comparison: &Comparison, provenance: &Provenance) -> Value {
    json!({
        "surfaces": comparison.surfaces.iter().map(|s| surface(s, comparison)).collect::<Vec<_>>(),
        "refused": comparison.refused,
        "settings": comparison.settings,
        "materials": crate::messages::materials::materials_json(&comparison.settings.materials),
        "versions": { "rough-contact": provenance.version, "platform": provenance.platform },
        "seconds": comparison.seconds,
    })
}

/// Findings with their words.
pub fn findings(found: &[Finding]) -> Value {
    let one = |f: &Finding| {
        let [claim, text] = finding(f);
        json!({
            "weight": f.weight.name(),
            "subject": f.subject(),
            "claim": claim,
            "text": text,
            "fact": match &f.body {
                Some(body) => json!({ "of_body": { "body": body, "fact": f.fact } }),
                None => json!(f.fact),
            },
        })
    };
    found.iter().map(one).collect()
}

/// One surface of a study, as [`comparison`] lists it.
pub fn surface(s: &SurfaceComparison, comparison: &Comparison) -> Value {
    let grid = s.solved_map().grid();
    let settings = &comparison.settings;
    let (precision, tolerance) = s
        .plan
        .as_ref()
        .map_or((settings.precision, settings.tolerance), |p| (p.precision, p.tolerance));
    let method = s.deterministic.iter().find_map(|p| Some(p.answer.as_ref()?.method.clone()));
    json!({
        "name": s.name,
        "origin": s.origin.without_folders(),
        "pair": s.origin.pair().map(crate::pair_json::pair),
        "bodies": crate::pair_json::bodies(s.origin.pair(), &settings.bodies),
        "cleaning": cleaning(s.origin.cleaned()),
        "findings": findings(&contact_compare::findings(s)),
        "statistics": statistics(&s.statistics),
        "inputs": {
            "moments": s.inputs.moments,
            "source": s.inputs.source.name(),
            "gamma": s.inputs.has_gap().then(|| s.inputs.gamma()),
        },
        "headline_pressure": s.headline_pressure(),
        "headline_load": s.load_area.map(|area| s.headline_pressure() * area),
        "resolved": s.spectral.resolved,
        "contact_spots": s.spots.map(|c| json!({
            "count": c.count,
            "median_area": c.median_area,
            "largest_area": c.largest_area,
        })),
        "distributions": s.distributions.get(s.headline),
        "finer": finer(s),
        "choices": s.closer.as_ref().map(|c| c.choices.iter().map(|c| json!({
            "choice": c.kind.name(),
            "area_effect": c.effect,
        })).collect::<Vec<_>>()),
        "coarser": s.coarser.iter().map(|c| json!({
            "mean_pressure": s.headline_pressure(),
            "factor": c.factor,
            "shape": c.shape,
            "touching_fraction": c.touching_fraction,
            "area_fraction": c.area_fraction,
            "area_error": c.error,
            "seconds": c.seconds,
        })).collect::<Vec<_>>(),
        "setup_seconds": s.setup_seconds,
        "deterministic": {
            "shape": grid.shape(),
            "pixel": grid.pixel(),
            "boundary": "periodic",
            "method": method,
            "precision": precision,
            "modulus": settings.modulus,
            "hardness": settings.hardness,
            "tolerance": tolerance,
            "accuracy": s.plan.as_ref().map(accuracy),
            "points": s.deterministic.iter().map(point).collect::<Vec<_>>(),
        },
        "conduction": crate::conduction_json::conduction(s),
        "leak": crate::leak_json::of_study(s, comparison),
        "plasticity": contact_compare::hardness_of(s).map(|h| h.indices(s.inputs.asperities())),
        "elastic_limit": contact_compare::elastic_limit(s),
        "adhesion": s.adhesion,
        "elastic": settings.hardness.map(|_| json!({
            "points": s.elastic.iter().map(point).collect::<Vec<_>>(),
        })),
        "models": s.models.iter().map(|m| model(m, s)).collect::<Vec<_>>(),
    })
}

/// The headline load on twice the points, if it was solved there.
fn finer(s: &SurfaceComparison) -> Value {
    let finer = s.headline_answer().and_then(|a| a.finer);
    finer.map_or(Value::Null, |f| {
        json!({
            "mean_pressure": s.headline_pressure(),
            "area_fraction": f.area,
            "mean_gap": f.mean_gap,
            "seconds": s.beside_seconds[1],
            "loads": s.deterministic.iter().filter_map(|p| p.answer.as_ref()?.finer).count(),
        })
    })
}

/// One load of the deterministic curve, with the keys of `solve --json`.
fn point(p: &DeterministicPoint) -> Value {
    let Some(a) = &p.answer else {
        return json!({
            "mean_pressure": p.mean_pressure,
            "touching_fraction": null,
            "area_fraction": null,
            "converged": false,
            "trouble": p.trouble,
        });
    };
    let mut point = json!({
        "mean_pressure": p.mean_pressure,
        "touching_fraction": a.touching_fraction,
        "area_fraction": a.area_fraction,
        "area_interval_covers": "this map",
        "no_interval_because": a.budget.area.half_width().err().map(|r| r.to_string()),
        "mean_gap": a.mean_gap,
        "approach": a.approach,
        "max_pressure": a.max_pressure,
        "converged": a.converged,
        "stopped_at_rounding": a.stopped_at_rounding,
        "trouble": p.trouble,
        "iterations": a.iterations,
        "transforms": a.transforms,
        "seconds": a.seconds,
        "residuals": {
            "preconditioned": a.residuals.preconditioned,
            "complementarity": a.residuals.complementarity,
            "penetration": a.residuals.penetration,
        },
        "duality_gap": a.duality_gap,
        "energy_bound": a.energy_bound,
        "contact_pixels": a.contact_pixels,
        "contact_perimeter": a.contact_perimeter,
    });
    if let Value::Object(keys) = &mut point {
        keys.extend(crate::point_json::budget_keys(Some(&a.budget)));
        keys.extend(crate::point_json::yield_keys(a.yielded, a.touching_fraction));
    }
    point
}

fn model(m: &ModelComparison, surface: &SurfaceComparison) -> Value {
    let curve = m.outcome.as_ref().ok();
    json!({
        "model": m.card.name,
        "citation": m.card.citation,
        "applicable": m.outcome.is_ok(),
        "verdict": m.verdict.answer.word(),
        "reason": messages::reason(m),
        "preparation_seconds": curve.map(|c| c.preparation),
        "seconds": curve.map(|c| c.seconds),
        "area_error": curve.map(|c| area_error(c, m, surface)),
        "points": curve.map_or(Vec::new(), |c| {
            let points = c.points.iter().zip(&surface.deterministic).enumerate();
            points.map(|(k, (r, p))| answer(p.mean_pressure, r, c.area_intervals.get(k).copied().flatten())).collect()
        }),
    })
}

fn area_error(curve: &ModelCurve, m: &ModelComparison, surface: &SurfaceComparison) -> Value {
    let summary = curve.worst_and_mean();
    let of_elastic = !m.card.yields && !surface.elastic.is_empty();
    json!({
        "against": if of_elastic { "elastic" } else { "deterministic" },
        "signed": curve.errors,
        "headline": curve.errors.get(surface.headline),
        "worst": summary.map(|(worst, _)| worst),
        "mean_absolute": summary.map(|(_, mean)| mean),
    })
}

/// What a model says at a load.
pub(crate) fn answer(
    mean_pressure: f64,
    result: &Result<ContactState, ModelError>,
    interval: Option<[f64; 2]>,
) -> Value {
    match result {
        Ok(s) => json!({
            "mean_pressure": mean_pressure,
            "area_fraction": s.area_fraction,
            "area_interval": interval,
            "real_pressure": s.real_pressure(),
            "separation": s.separation,
            "mean_gap": s.mean_gap,
            "caveat": s.caveat.as_ref().map(ToString::to_string),
            "error": null,
        }),
        Err(e) => json!({
            "mean_pressure": mean_pressure,
            "area_fraction": null,
            "error": { "message": e.to_string() },
        }),
    }
}

/// What was chosen for a request, and why.
pub fn accuracy(reached: &Reached) -> Value {
    json!({
        "requested": reached.request.map(AccuracyRequest::relative),
        "met": reached.met,
        "given": reached.given.shape(),
        "grid": reached.grid.shape(),
        "factor": reached.factor(),
        "precision": reached.precision.name(),
        "tolerance": reached.tolerance,
        "half_width": reached.half_width,
        "seconds": reached.seconds,
        "next": reached.next.map(|next| json!({
            "grid": next.shape,
            "half_width": next.half_width,
            "seconds": next.seconds,
        })),
        "reason": plan_messages::reason(reached),
        "explanation": plan_messages::explanation(reached),
    })
}

/// What cleaning did, one object per step in the order in which it was done.
pub fn cleaning(records: &[Record]) -> Value {
    records.iter().map(cleaning_step).collect()
}

fn cleaning_step(record: &Record) -> Value {
    let mut object = match *record {
        Record::Outliers { threshold, count, limit, largest } => json!({
            "step": "outliers",
            "threshold": threshold,
            "window": 5,
            "count": count,
            "limit": limit,
            "largest": largest,
        }),
        Record::Rows { jump, largest } => {
            json!({ "step": "rows", "jump": jump, "largest": largest })
        }
        Record::Form { parameters, points } => {
            let mut form = form(parameters);
            form["step"] = json!("form");
            form["points"] = json!(points);
            form
        }
        Record::SFilter { nesting_index } => {
            json!({ "step": "s_filter", "nesting_index": nesting_index })
        }
        Record::LFilter { nesting_index } => {
            json!({ "step": "l_filter", "nesting_index": nesting_index })
        }
    };
    object["message"] = json!(record.to_string());
    object
}

/// A radius is positive if convex and `null` for a plane.
fn form(parameters: FormParameters) -> Value {
    let finite = |radius: f64| radius.is_finite().then_some(radius);
    match parameters {
        FormParameters::Polynomial { degree } => json!({ "form": "polynomial", "degree": degree }),
        FormParameters::Sphere { radius, apex } => {
            json!({ "form": "sphere", "radius": finite(radius), "apex": apex })
        }
        FormParameters::Cylinder { radius, direction, tilt } => json!({
            "form": "cylinder", "radius": finite(radius), "direction": direction, "tilt": tilt,
        }),
    }
}

/// A warning of the statistics, in the words of the page.
pub(crate) fn warned(warning: &Warning) -> Value {
    json!({ "kind": warning.kind(), "message": warning.to_string() })
}

/// Statistics with the keys of `stats --json`.
pub fn statistics(s: &SurfaceStatistics) -> Value {
    let mut value = json!(s);
    value["warnings"] = s.warnings.iter().map(warned).collect();
    value
}
