//! From the bytes of a file, or the name of a built-in surface, to a map, and what says most of it.

use crate::request::Request;
use crate::trouble::Trouble;
use contact_compare::{FileOrigin, Level, Surface, built_in_recipes, sha256_hex};
use contact_front_end::{Failure, complete, reading};
use contact_types::{HeightMap, SpectralMoments};
use surface_io::Measurement;
use surface_stats::Edges;

pub(crate) fn measurement(request: &Request, file: &[u8]) -> Result<Measurement, Trouble> {
    let found = surface_io::read_bytes(file, &request.options()?).map_err(Trouble::Unread)?;
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
    recipe.make().map_err(|e| Failure::from(&e).into())
}

pub(crate) fn of_measurement(
    request: &Request,
    file: &[u8],
    measured: Measurement,
) -> Result<Surface, Trouble> {
    let surface = completed(measured, request, sha256_hex(file))?;
    Ok(Surface { name: request.name.clone(), ..surface })
}

fn completed(measured: Measurement, request: &Request, sha256: String) -> Result<Surface, Trouble> {
    let origin = FileOrigin { sha256, ..request.origin()? };
    let (_, fill) = reading(&origin)?;
    complete(measured, origin, fill).map_err(Trouble::Incomplete)
}

/// The map of a measurement with the remedies as ticked, its form taken off.
pub(crate) fn prepared(measured: &Measurement, request: &Request) -> Result<HeightMap, Trouble> {
    let surface = completed(measured.clone(), request, String::new())?;
    levelled(&surface.heights, request.remedies.level())
}

pub(crate) fn levelled(map: &HeightMap, level: Level) -> Result<HeightMap, Trouble> {
    Ok(level.taken_off(map.clone()).map_err(|e| Failure::from(&e))?.1)
}

/// Of these Sq and Sdq are said, as in the statistics of the report.
pub(crate) fn roughness(map: &HeightMap) -> Result<SpectralMoments, Trouble> {
    Ok(surface_stats::moments(map, Edges::Open).map_err(|e| Failure::from(&e))?.0)
}
