//! Roughness statistics of one map: what `rough-contact stats` answers.

use crate::failure::Failure;
use crate::iso;
use crate::scene;
use contact_compare::{Finding, Level, PairOrigin, Spikes, WorkOfAdhesion};
use contact_types::{ContactModulus, HeightMap};
use serde_json::{Value, json};
use std::path::Path;
use surface_stats::clean::Record;
use surface_stats::iso25178::Iso;
use surface_stats::{ByDistance, StatsError, StatsOptions, SurfaceStatistics, by_distance, level};

/// Where a map comes from, for what is said of it.
#[derive(Clone, Copy, Debug)]
pub struct Measured<'a> {
    /// Name in front of what is refused.
    pub path: &'a Path,
    /// Steps of cleaning.
    pub cleaned: &'a [Record],
    /// The two bodies, if it is a pair.
    pub pair: Option<&'a PairOrigin>,
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
    /// Areal parameters of ISO 25178-2, if they were asked for.
    pub iso: Option<Iso>,
    /// Slope, curvature and autocorrelation along x and y by distance, if they were asked for.
    pub scales: Option<[Vec<ByDistance>; 2]>,
}

impl Statistics {
    /// Adds whether bodies with these heights stick, where no load is known.
    ///
    /// # Errors
    /// [`Failure`] of a map that is too small.
    pub fn stick(
        &mut self,
        given: WorkOfAdhesion,
        map: &HeightMap,
        form: Level,
        modulus: ContactModulus,
        path: &Path,
    ) -> Result<(), Failure> {
        let refused = |e: StatsError| Failure::in_file(path, &e);
        let map = level(map, form).map_err(refused)?;
        let found = scene::adhesion(given, &map, modulus, &[]).map_err(refused)?;
        self.findings.push(contact_compare::sticking(found));
        self.findings.sort_by_key(|f| f.weight);
        self.json["findings"] = contact_report::findings_json(&self.findings);
        self.json["adhesion"] = json!(found);
        Ok(())
    }
}

/// The statistics of a map before it is levelled.
///
/// # Errors
/// [`Failure`] of a map that has none.
pub fn statistics(
    map: &HeightMap,
    options: &StatsOptions,
    Measured { path, cleaned, pair }: Measured<'_>,
    with_iso: bool,
    with_scales: bool,
) -> Result<Statistics, Failure> {
    let refused = |e: StatsError| Failure::in_file(path, &e);
    let s = SurfaceStatistics::of(map, options).map_err(refused)?;
    let spikes = Spikes::left(map, cleaned, pair);
    let findings = contact_compare::measured(&s, &spikes, pair);
    let mut json = contact_report::statistics_json(&s);
    json["findings"] = contact_report::findings_json(&findings);
    json["cleaning"] = contact_report::cleaning_json(cleaned);
    json["pair"] = pair.map_or(Value::Null, contact_report::pair_json);
    let levelled = (with_iso || with_scales).then(|| level(map, s.level));
    let levelled = levelled.transpose().map_err(refused)?;
    let iso = match levelled.as_ref().filter(|_| with_iso) {
        Some(map) => Some(Iso::of(map, options.edges).map_err(refused)?),
        None => None,
    };
    if let Some(iso) = &iso {
        json["iso25178"] = iso::json(iso);
    }
    let scales = levelled.as_ref().filter(|_| with_scales).map(by_distance);
    if let Some([along_x, along_y]) = &scales {
        json["scales"] = json!({ "x": along_x, "y": along_y });
    }
    Ok(Statistics { json, statistics: s, findings, iso, scales })
}
