//! From the bytes of a file, or the name of a built-in surface, to a map, and the two numbers that say most of it.

use crate::request::Request;
use crate::trouble::Trouble;
use contact_compare::{FileOrigin, Level, Origin, Surface, built_in_recipes, sha256_hex};
use contact_front_end::{Complete, Failure, complete};
use contact_types::HeightMap;
use surface_io::Measurement;
use surface_stats::{Edges, StatsError, moments};

/// The measurement in a file.
pub(crate) fn measurement(request: &Request, file: &[u8]) -> Result<Measurement, Trouble> {
    let options = request.reading.options(request.place.limits())?;
    let found = surface_io::read_bytes(file, &options).map_err(Trouble::Unread)?;
    if found.is_profile() {
        return Err(Trouble::Profile { points: found.heights().len() });
    }
    match request.reading.part()? {
        None => Ok(found),
        Some(cut) => found.crop(cut).map_err(Trouble::Unread),
    }
}

/// A complete map with the remedies that are ticked.
pub(crate) fn completed(measurement: Measurement, request: &Request) -> Result<Complete, Trouble> {
    let remedies = &request.remedies;
    complete(measurement, remedies.cleaning(), remedies.fill()).map_err(Trouble::Incomplete)
}

/// The surface of the study.
pub(crate) fn of(request: &Request, file: &[u8]) -> Result<Surface, Trouble> {
    let Some(name) = &request.example else {
        return of_measurement(request, file, measurement(request, file)?);
    };
    let unknown = || Failure::refused("setting", format!("no built-in surface is called {name:?}"));
    let all = built_in_recipes().map_err(|e| Failure::from_error(&e))?;
    let recipe = all.into_iter().find(|r| r.name == *name).ok_or_else(unknown)?;
    recipe.make().map_err(|e| Failure::from_error(&e).into())
}

/// The surface of the study from what was read.
pub(crate) fn of_measurement(
    request: &Request,
    file: &[u8],
    measured: Measurement,
) -> Result<Surface, Trouble> {
    let Complete { map, missing, cleaned, height_step, format, crop } =
        completed(measured, request)?;
    let reading = &request.reading;
    let origin = FileOrigin {
        path: request.name.clone(),
        sha256: sha256_hex(file),
        format,
        channel: reading.channel.clone(),
        pixel: reading.pixel()?,
        lateral_unit: reading.lateral_unit()?,
        height_unit: reading.height_unit()?,
        override_height_unit: reading.override_height_unit()?,
        layout: reading.layout.clone(),
        decimal: reading.decimal.clone(),
        missing_marks: reading.missing.clone(),
        crop,
        fill: request.remedies.rule().to_owned(),
        missing,
        cleaning: request.remedies.cleaning(),
        cleaned,
        height_step,
    };
    Ok(Surface { name: request.name.clone(), origin: Origin::File(origin), heights: map })
}

/// The map of a measurement with the remedies as ticked, its form taken off.
pub(crate) fn prepared(measured: &Measurement, request: &Request) -> Result<HeightMap, Trouble> {
    levelled(&completed(measured.clone(), request)?.map, request.remedies.level())
}

pub(crate) fn levelled(map: &HeightMap, level: Level) -> Result<HeightMap, Trouble> {
    surface_stats::level(map, level).map_err(|e| Failure::from_error(&e).into())
}

/// The two numbers that say most.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RoughnessNumbers {
    /// Sq (m).
    pub(crate) height: f64,
    /// Sdq (-), as the statistics of the report.
    pub(crate) gradient: f64,
}

impl RoughnessNumbers {
    pub(crate) fn of(map: &HeightMap) -> Result<Self, Trouble> {
        let refused = |e: StatsError| Trouble::Refused(Failure::from_error(&e));
        let moments = moments(map, Edges::Open).map_err(refused)?;
        Ok(Self { height: moments.rms_height(), gradient: moments.rms_gradient() })
    }
}
