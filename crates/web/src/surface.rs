//! From the bytes of a file, or the name of a built-in surface, to a map, and the two numbers that say most of it.

use crate::request::{Request, unit};
use crate::trouble::Trouble;
use contact_compare::{FileOrigin, Level, Surface, built_in_recipes, sha256_hex};
use contact_front_end::{Failure, complete};
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

/// The surface of the study.
pub(crate) fn of(request: &Request, file: &[u8]) -> Result<Surface, Trouble> {
    let Some(name) = &request.example else {
        return of_measurement(request, file, measurement(request, file)?);
    };
    let unknown = || Failure::refused("setting", format!("no built-in surface is called {name:?}"));
    let recipe = built_in_recipes().into_iter().find(|r| r.name == *name).ok_or_else(unknown)?;
    recipe.make().map_err(|e| Failure::from_error(&e).into())
}

/// The surface of the study from what was read.
pub(crate) fn of_measurement(
    request: &Request,
    file: &[u8],
    measured: Measurement,
) -> Result<Surface, Trouble> {
    let reading = &request.reading;
    let origin = FileOrigin {
        path: request.name.clone(),
        sha256: sha256_hex(file),
        channel: reading.channel.clone(),
        pixel: reading.pixel()?,
        lateral_unit: unit(reading.lateral_unit.as_deref())?,
        height_unit: unit(reading.height_unit.as_deref())?,
        override_height_unit: unit(reading.override_height_unit.as_deref())?,
        layout: reading.layout.clone(),
        decimal: reading.decimal.clone(),
        missing_marks: reading.missing.clone(),
        ..FileOrigin::default()
    };
    let surface = completed(measured, request, origin)?;
    Ok(Surface { name: request.name.clone(), ..surface })
}

/// With the remedies that are ticked.
fn completed(
    measured: Measurement,
    request: &Request,
    origin: FileOrigin,
) -> Result<Surface, Trouble> {
    let remedies = &request.remedies;
    let origin = FileOrigin { cleaning: remedies.cleaning(), ..origin };
    complete(measured, origin, remedies.fill()).map_err(Trouble::Incomplete)
}

/// The map of a measurement with the remedies as ticked, its form taken off.
pub(crate) fn prepared(measured: &Measurement, request: &Request) -> Result<HeightMap, Trouble> {
    let surface = completed(measured.clone(), request, FileOrigin::default())?;
    levelled(&surface.heights, request.remedies.level())
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
