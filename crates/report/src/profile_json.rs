//! Profiles as JSON: SI units, absent numbers `null`.

use crate::json::{answers, cleaning, findings, warned};
use crate::provenance::Provenance;
use contact_compare::{ProfileComparison, Unevenness};
use serde_json::{Value, json};
use surface_stats::profile::{ParameterMean, ProfileStatistics, Setting, SettingSource};

/// Mean and standard deviation of every parameter by its symbol.
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
