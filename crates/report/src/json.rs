//! `results.json`: everything, in SI units, for other programs. Absent numbers are `null`.

use crate::messages::finding::finding;
use crate::messages::{plan as plan_messages, reason_of};
use crate::parts_json;
use crate::provenance::Provenance;
use contact_accuracy::{AccuracyRequest, Reached};
use contact_compare::{
    ChoiceKind, Comparison, DeterministicPoint, Finding, ModelComparison, ModelCurve,
    ProfileComparison, SurfaceComparison, Unevenness,
};
use contact_types::{ContactState, ModelError, Named};
use serde_json::{Value, json};
use surface_stats::clean::Record;
use surface_stats::profile::{ParameterMean, ProfileStatistics, Setting, SettingSource};
use surface_stats::{SurfaceStatistics, Warning};

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

fn surface(s: &SurfaceComparison, comparison: &Comparison) -> Value {
    let grid = s.solved_map().grid();
    let settings = &comparison.settings;
    let plan = s.plan.as_ref().map(|plan| (plan.precision, plan.tolerance));
    let (precision, tolerance) = plan.unwrap_or((settings.precision, settings.tolerance));
    let method =
        s.deterministic.iter().find_map(|p| Some(p.answer.as_ref()?.diagnostics.method.name()));
    let spots = s.distributions.get(s.headline).and_then(|found| Some(&found.as_ref()?.spots));
    json!({
        "name": s.name,
        "origin": s.origin.without_folders(),
        "pair": s.origin.pair().map(parts_json::pair_json),
        "bodies": parts_json::bodies_json(s.origin.pair(), &settings.bodies),
        "cleaning": cleaning(s.origin.cleaned()),
        "findings": findings(&contact_compare::findings(s)),
        "statistics": statistics(&s.statistics),
        "inputs": {
            "moments": s.inputs.moments,
            "source": "finite-differences",
            "gamma": s.inputs.gamma(),
        },
        "headline_pressure": s.headline_pressure(),
        "headline_load": s.load_area.map(|area| s.headline_pressure() * area),
        "resolved": s.spectral.resolved,
        "contact_spots": spots.map(|spots| json!({
            "count": spots.count,
            "median_area": spots.median_area,
            "largest_area": spots.largest_area,
        })),
        "distributions": s.distributions.get(s.headline),
        "finer": finer(s),
        "choices": s.choices.as_ref().map(|all| all.iter().map(|(kind, effect)| json!({
            "choice": choice(*kind),
            "area_effect": effect,
        })).collect::<Vec<_>>()),
        "coarser": s.coarser.iter().map(|c| {
            let mut coarser = json!(c);
            coarser["mean_pressure"] = json!(s.headline_pressure());
            coarser
        }).collect::<Vec<_>>(),
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
        "conduction": parts_json::conduction(s),
        "leak": parts_json::leak_of_study(s, comparison),
        "plasticity": contact_compare::hardness_of(s).map(|h| h.indices(s.inputs.asperities())),
        "elastic_limit": contact_compare::elastic_limit(s),
        "adhesion": s.adhesion,
        "elastic": settings.hardness.map(|_| json!({
            "points": s.elastic.iter().map(point).collect::<Vec<_>>(),
        })),
        "models": s.models.iter().map(|m| model(m, s)).collect::<Vec<_>>(),
    })
}

fn choice(kind: ChoiceKind) -> &'static str {
    match kind {
        ChoiceKind::Paraboloid => "paraboloid",
        ChoiceKind::Cutoff(_) => "twice_the_shortest_wavelength",
        ChoiceKind::WithoutSpikes(_) => "without_spikes",
        ChoiceKind::Mirrored => "mirrored",
    }
}

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
    let found = ([a.touching_fraction, a.approach], &a.diagnostics, &a.budget);
    let mut point = parts_json::solution_keys(Some(found));
    point.extend(parts_json::keys_of(json!({
        "mean_pressure": p.mean_pressure,
        "area_fraction": a.area_fraction,
        "mean_gap": a.mean_gap,
        "converged": a.converged,
        "trouble": p.trouble,
    })));
    Value::Object(point)
}

fn model(m: &ModelComparison, surface: &SurfaceComparison) -> Value {
    let curve = m.outcome.as_ref().ok();
    let pressures: Vec<f64> = surface.deterministic.iter().map(|p| p.mean_pressure).collect();
    let mut model = answers(m, &pressures);
    model["preparation_seconds"] = json!(curve.map(|c| c.preparation));
    model["seconds"] = json!(curve.map(|c| c.seconds));
    let of_elastic = !m.card.yields && !surface.elastic.is_empty();
    let area_error = |c: &ModelCurve| {
        let (worst, mean) = c.worst_and_mean().unzip();
        json!({
            "against": if of_elastic { "elastic" } else { "deterministic" },
            "signed": c.errors,
            "headline": c.errors.get(surface.headline),
            "worst": worst,
            "mean_absolute": mean,
        })
    };
    model["area_error"] = json!(curve.map(area_error));
    model
}

/// A model, whether it covers the surface, and what it says at these pressures (Pa).
fn answers(m: &ModelComparison, pressures: &[f64]) -> Value {
    let of_curve = |curve: &ModelCurve| -> Vec<Value> {
        let points = curve.points.iter().zip(&curve.intervals).zip(pressures);
        points.map(|((point, interval), pressure)| answer(*pressure, point, *interval)).collect()
    };
    json!({
        "model": m.card.name,
        "citation": m.card.citation,
        "applicable": m.outcome.is_ok(),
        "verdict": m.verdict.answer.name(),
        "reason": reason_of(&m.card, &m.verdict),
        "points": m.outcome.as_ref().map_or_else(|_| Vec::new(), of_curve),
    })
}

fn answer(
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
        "met": reached.unmet.is_none(),
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

/// What cleaning did, one object per step in the order in which it was done. A radius is positive if convex and `null`
/// for a plane.
pub fn cleaning(records: &[Record]) -> Value {
    let step = |record: &Record| {
        let mut object = json!(record);
        if matches!(record, Record::Outliers { .. }) {
            object["window"] = json!(5);
        }
        object["message"] = json!(record.to_string());
        object
    };
    records.iter().map(step).collect()
}

fn warned(warning: &Warning) -> Value {
    json!({ "kind": warning.kind(), "message": warning.to_string() })
}

/// Statistics with the keys of `stats --json`.
pub fn statistics(s: &SurfaceStatistics) -> Value {
    let mut value = json!(s);
    value["warnings"] = s.warnings.iter().map(warned).collect();
    value
}

fn parameters(all: &[ParameterMean]) -> Value {
    let one = |p: &ParameterMean| {
        (p.symbol.clone(), json!({ "mean": p.mean, "standard_deviation": p.deviation }))
    };
    Value::Object(all.iter().map(one).collect())
}

fn setting(s: &Setting) -> Value {
    let source = match s.source {
        SettingSource::Asked => "asked".to_owned(),
        SettingSource::Class(number) => format!("Sc{number}"),
        SettingSource::Longest(number) => format!("Sc{number}, the coarsest that fits"),
    };
    json!({
        "cutoff": s.cutoff, "short": s.short, "short_unresolved": s.short_unresolved,
        "source": source,
    })
}

/// How uneven the points were.
pub fn unevenness(uneven: Option<Unevenness>) -> Value {
    uneven.map_or(Value::Null, |u| {
        json!({ "shortest_step": u.steps[0], "longest_step": u.steps[1], "spacing": u.spacing })
    })
}

/// Statistics of profiles, with the keys of `stats --json` for a profile.
pub fn profile_statistics(s: &ProfileStatistics) -> Value {
    let warnings: Vec<Value> = s.warnings.iter().map(warned).collect();
    let roughness = s.roughness.as_ref().map_or(Value::Null, |found| {
        json!({
            "setting": setting(&found.setting),
            "sections": found.sections,
            "evaluated": found.evaluated,
            "parameters": parameters(&found.parameters),
        })
    });
    json!({
        "profile": true,
        "traces": s.traces,
        "points": s.points,
        "spacing": s.spacing,
        "length": s.length,
        "polynomial_degree": s.options.degree,
        "s_filter": s.options.short,
        "l_filter": s.options.cutoff,
        "roughness": roughness,
        "no_roughness_because": s.roughness.as_ref().err().map(ToString::to_string),
        "primary": parameters(&s.primary),
        "m0": s.moments.m0,
        "m2": s.moments.m2,
        "m4": s.moments.m4,
        "m0_interval": s.intervals[0],
        "m2_interval": s.intervals[1],
        "m4_interval": s.intervals[2],
        "each": s.each,
        "between_traces": s.between,
        "spectral": s.spectral,
        "seen": s.seen,
        "by_spacing": s.by_spacing.iter().map(|(distance, m)| json!({
            "spacing": distance, "m2": m.m2, "m4": m.m4,
        })).collect::<Vec<_>>(),
        "skewness": s.skewness,
        "kurtosis": s.kurtosis,
        "rms_gradient": s.moments.rms_gradient(),
        "bandwidth": s.bandwidth,
        "asperities": s.asperities,
        "hurst": s.hurst,
        "dimension": s.hurst.map(|h| 2.0 - h),
        "fractal_roughness": s.fractal.map(|f| f.roughness),
        "fractal_range": s.fractal_range,
        "rolloff": s.rolloff,
        "cutoff": s.cutoff,
        "height_step": s.height_step,
        "noise_rms": s.noise_rms,
        "reliable_wavelength": s.reliable_wavelength,
        "warnings": warnings,
    })
}

/// A study of profiles as one object.
pub fn profile_comparison(studies: &[ProfileComparison], provenance: &Provenance) -> Value {
    let one = |s: &ProfileComparison| {
        json!({
            "name": s.surface.name,
            "origin": s.surface.origin.without_folders(),
            "uneven": unevenness(s.surface.uneven),
            "cleaning": cleaning(s.surface.origin.cleaned()),
            "findings": findings(&s.findings()),
            "statistics": profile_statistics(&s.statistics),
            "headline_pressure": s.pressures[s.headline],
            "span": s.span(s.headline).map(|(span, models)| {
                json!({ "area_fraction": span, "models": models })
            }),
            "models": s.models.iter().map(|m| answers(m, &s.pressures)).collect::<Vec<_>>(),
        })
    };
    json!({
        "profiles": studies.iter().map(one).collect::<Vec<_>>(),
        "settings": studies.first().map(|s| &s.settings),
        "versions": { "rough-contact": provenance.version, "platform": provenance.platform },
        "seconds": studies.iter().map(|s| s.seconds).sum::<f64>(),
    })
}
