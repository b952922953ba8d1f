//! What a file holds, and roughness statistics: what `rough-contact info` and `stats` answer.

use crate::complete::Subject;
use crate::failure::Failure;
use contact_compare::{
    Adhesion, Finding, Inputs, Level, ProfileSurface, Settings, Spikes, WorkOfAdhesion,
};
use contact_types::{ContactModulus, HeightMap, SpectralMoments};
use serde::Deserialize;
use serde_json::{Value, json};
use std::path::Path;
use surface_io::Measurement;
use surface_stats::iso25178::{self, IsoParameter};
use surface_stats::profile::ProfileStatistics;
use surface_stats::spectrum::radial;
use surface_stats::{
    ByDistance, Edges, Spectra, StatsError, StatsOptions, SurfaceStatistics, by_distance,
};

/// What is asked of a map.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StatisticsRequest {
    /// Form that is taken off first.
    pub level: Level,
    /// What lies beyond the edges; absent: as the surface was made.
    pub boundary: Option<Edges>,
    /// Wavelengths (m) between which the fractal dimension is fitted; absent: chosen from the spectrum.
    pub fractal_range: Option<[f64; 2]>,
    /// Areal parameters of ISO 25178-2 too.
    pub iso: bool,
    /// Slope, curvature and autocorrelation by distance too.
    pub scales: bool,
    /// Whether bodies of this modulus stick, where no load is known.
    #[serde(skip)]
    pub adhesion: Option<(WorkOfAdhesion, ContactModulus)>,
}

/// What was found.
#[derive(Debug)]
pub struct Statistics {
    /// The object that scripts see.
    pub json: Value,
    /// The numbers.
    pub statistics: SurfaceStatistics,
    /// What may change a conclusion, worst first.
    pub findings: Vec<Finding>,
    /// Areal parameters, if they were asked for.
    pub iso: Option<Vec<IsoParameter>>,
    /// Along x and y by distance, if that was asked for.
    pub scales: Option<[Vec<ByDistance>; 2]>,
}

/// The statistics of a map.
///
/// # Errors
/// [`Failure`] of a map that has none.
pub fn statistics(subject: &Subject<'_>, asked: &StatisticsRequest) -> Result<Statistics, Failure> {
    let (origin, map) = (&subject.surface.origin, &subject.surface.heights);
    let refused = |e: StatsError| Failure::in_file(subject.path, &e);
    let edges = asked.boundary.unwrap_or_else(|| origin.edges());
    let fractal_range = asked.fractal_range;
    let options = StatsOptions { edges, fractal_range, ..origin.options(asked.level) };
    let (s, Spectra { surface: levelled, .. }) =
        SurfaceStatistics::with_spectra(map, &options).map_err(refused)?;
    let spikes = Spikes::left(map, &subject.cleaned, origin.pair());
    let mut json = contact_report::statistics_json(&s);
    json["cleaning"] = contact_report::cleaning_json(&subject.cleaned);
    json["pair"] = origin.pair().map_or(Value::Null, contact_report::pair_json);
    let (mut iso, mut scales, mut adhesion) = (None, None, None);
    if asked.iso {
        let found = iso25178::parameters(&levelled, edges).map_err(refused)?;
        json["iso25178"] = found.iter().map(|p| (p.symbol.to_owned(), json!(p.value))).collect();
        iso = Some(found);
    }
    if asked.scales {
        let found = by_distance(&levelled);
        json["scales"] = json!({ "x": found[0], "y": found[1] });
        scales = Some(found);
    }
    if let Some((given, modulus)) = asked.adhesion {
        let inputs = with_spectrum(&levelled, modulus, s.moments());
        let found = Adhesion::of(given, &inputs, s.cutoff, &[]);
        json["adhesion"] = json!(found);
        adhesion = Some(found);
    }
    let findings = contact_compare::measured(&s, &spikes, origin.pair(), adhesion);
    json["findings"] = contact_report::findings_json(&findings);
    Ok(Statistics { json, statistics: s, findings, iso, scales })
}

/// The statistics of traces as one sample, this form taken off each.
///
/// # Errors
/// [`Failure`] of traces too short for the filters.
pub fn profile_statistics(
    path: &Path,
    traces: &ProfileSurface,
    level: Level,
) -> Result<(ProfileStatistics, Value), Failure> {
    let options = traces.options(&Settings { level, ..Settings::default() });
    let found = ProfileStatistics::of(&traces.traces, &options);
    let (found, ..) = found.map_err(|e| Failure::in_file(path, &e))?;
    let mut json = contact_report::profile_statistics_json(&found);
    json["missing"] = json!(traces.origin.missing());
    json["uneven"] = contact_report::unevenness_json(traces.uneven);
    json["cleaning"] = contact_report::cleaning_json(traces.origin.cleaned());
    Ok((found, json))
}

/// Points, unit, channels and what else the file says, without the heights.
pub fn info(m: &Measurement) -> Value {
    let summary = m.height_summary();
    let channels: Vec<Value> = m
        .channels
        .iter()
        .map(|c| {
            json!({
                "name": c.name, "unit": c.unit, "is_height": c.is_height, "shape": c.shape,
                "pixel": c.pixel, "is_trace": c.is_trace, "fault": c.fault,
            })
        })
        .collect();
    json!({
        "format": m.format,
        "shape": m.grid().shape(),
        "pixel": m.grid().pixel(),
        "missing": m.missing(),
        "height_min": summary.map(|s| s.0),
        "height_max": summary.map(|s| s.1),
        "height_mean": summary.map(|s| s.2),
        "channel": m.channel,
        "channels": channels,
        "is_profile": m.is_profile(),
        "uneven_steps": m.uneven,
        "ambiguity": m.ambiguity.map(|a| a.what),
        "metadata": m.metadata,
    })
}

/// What adhesion depends on, of a levelled map with these moments.
pub(crate) fn with_spectrum(
    map: &HeightMap,
    modulus: ContactModulus,
    m: SpectralMoments,
) -> Inputs {
    Inputs { moments: Some(m), spectrum: radial(map).ok(), ..Inputs::new(modulus) }
}
