//! What a file holds: the map as measured and with its remedies, the facts, its defects; or what it does
//! not say.

use crate::defects;
use crate::numbers::{count, length};
use crate::request::{Request, parse, unit};
use crate::surface::{levelled, measurement, roughness};
use crate::trouble::Trouble;
use contact_compare::{Level, Surface};
use contact_front_end::units::Dimension;
use contact_front_end::{Failure, raw, shown};
use contact_report::numbers::significant;
use contact_types::{Grid, HeightMap};
use serde_json::{Value, json};
use surface_io::{ChannelInfo, Cut, Fill, Measurement, Need, ReadError};
use surface_stats::SurfaceStatistics;

/// Most pixels of a picture along its longer side.
const PICTURE: usize = 640;

/// Gradients between which a surface is usual.
const USUAL_GRADIENTS: [f64; 2] = [1e-4, 2.0];

pub(crate) fn answer(request: &Request, file: &[u8]) -> Result<Value, Trouble> {
    if request.example.is_some() {
        let surface = crate::surface::of(request, file)?;
        let statistics = statistics(&surface, request.remedies.level())?;
        let picture = picture(&levelled(&surface.heights, request.remedies.level())?, &[], "made");
        let plan = known(&statistics, &surface.heights);
        return Ok(json!({ "state": "made", "plan": plan, "svg": picture }));
    }
    match measurement(request, file) {
        Err(Trouble::Unread(ReadError::MissingScale { .. })) => ask(request, file),
        measured => read(request, file, measured?),
    }
}

fn read(request: &Request, file: &[u8], measured: Measurement) -> Result<Value, Trouble> {
    let facts = facts(&measured);
    let channel = |c: &ChannelInfo| {
        let label = match (&c.unit, &c.fault) {
            (_, Some(fault)) => format!("{}: {fault}", c.name),
            (Some(unit), None) => format!("{} ({unit})", c.name),
            (None, None) => c.name.clone(),
        };
        json!({
            "name": c.name, "label": label, "chosen": c.name == measured.channel,
            "readable": c.is_height && c.fault.is_none() && c.shape[0] > 1,
        })
    };
    let channels: Vec<Value> = measured.channels.iter().map(channel).collect();
    let parts = parts(&measured, request.reading.part()?);
    let about = format!("{} · {} · {}", request.name, measured.format, bytes(file.len()));
    let [ly, lx] = measured.grid().size();
    let spikes = defects::spikes(&measured)?;
    let mut pictures = before(&measured, &spikes.indices)?;
    let defects = defects::of(&measured, &spikes, request)?;
    let surface = crate::surface::of_measurement(request, file, measured)?;
    let statistics = statistics(&surface, request.remedies.level())?;
    let map = surface.heights;
    let after = picture(&levelled(&map, request.remedies.level())?, &[], "after");
    pictures.push(json!({ "name": "With the ticked remedies", "svg": after }));
    let found = defects::beyond(&statistics);
    let checks = defects.iter().filter(|d| d["tag"] == "check").count();
    let claim = match checks {
        0 => "Nothing has to be cleaned.".to_owned(),
        1 => "One thing should be cleaned first.".to_owned(),
        2 => "Two things should be cleaned first.".to_owned(),
        3 => "Three things should be cleaned first.".to_owned(),
        n => format!("{n} things should be cleaned first."),
    };
    Ok(json!({
        "state": "read", "about": about,
        "heading": [
            ["A height map of ", false], [format!("{} × {}", length(lx), length(ly)), true], [". ", false],
            [claim, checks > 0],
        ],
        "facts": facts, "channels": channels, "parts": parts,
        "pictures": pictures,
        "numbers": [
            ["rms height Sq", length(statistics.rms_height)],
            ["rms gradient Sdq", significant(statistics.rms_gradient, 3)],
        ],
        "defects": defects, "findings": found,
        "plan": known(&statistics, &map),
    }))
}

/// The parts of a map that can be chosen; the last one where points are missing, or were before it was chosen.
fn parts(measured: &Measurement, chosen: Option<Cut>) -> Vec<Value> {
    let all = [
        (None, "All of it"),
        (Some(Cut::Middle), "Middle half of each side"),
        (Some(Cut::Complete), "Largest part without missing points"),
    ];
    let is_offered = |(cut, _): &(Option<Cut>, _)| {
        *cut != Some(Cut::Complete) || *cut == chosen || measured.missing() > 0
    };
    let part = |(cut, label): (Option<Cut>, &str)| json!({ "value": cut.map(|c| c.to_string()), "label": label, "chosen": cut == chosen });
    all.into_iter().filter(is_offered).map(part).collect()
}

fn statistics(surface: &Surface, level: Level) -> Result<SurfaceStatistics, Trouble> {
    SurfaceStatistics::of(&surface.heights, &surface.origin.options(level))
        .map_err(|e| Failure::from(&e).into())
}

fn known(statistics: &SurfaceStatistics, map: &HeightMap) -> Value {
    json!({
        "gradient": statistics.moments().rms_gradient(), "points": map.grid().len() as f64,
        "area": map.grid().area(),
    })
}

fn facts(measured: &Measurement) -> Vec<[String; 2]> {
    let [ny, nx] = measured.grid().shape();
    let [dy, dx] = measured.grid().pixel();
    let said = |given: bool| if given { "from the file" } else { "as you said" };
    let own = measured.channels.iter().find(|c| c.name == measured.channel);
    let pixel_in_file = own.is_some_and(|c| c.pixel.is_some());
    let unit_in_file = own.is_some_and(|c| c.unit.is_some());
    let cut = |[y0, x0, ..]: [usize; 4]| format!(", cut out from row {y0}, column {x0}");
    let part = measured.cropped.map_or_else(String::new, cut);
    let mut facts = vec![
        ["Points".to_owned(), format!("{ny} rows × {nx} columns{part}")],
        ["Pixel".to_owned(), format!("{} × {}, {}", length(dx), length(dy), said(pixel_in_file))],
    ];
    if let Some((low, high, _)) = measured.height_summary() {
        let range = shown::length_range(low, high);
        facts.push(["Heights".to_owned(), format!("{range}, unit {}", said(unit_in_file))]);
    }
    let missing = match measured.missing() {
        0 => "none".to_owned(),
        n => {
            format!("{} ({})", count(n), shown::percent(n as f64 / measured.heights().len() as f64))
        }
    };
    facts.push(["Missing points".to_owned(), missing]);
    facts.extend(measured.ambiguity.map(|a| ["Read as".to_owned(), a.what.to_owned()]));
    for (name, value) in measured.metadata.iter().take(6) {
        facts.push([short(name, 40), short(value, 80)]);
    }
    facts
}

fn short(text: &str, most: usize) -> String {
    let all: Vec<char> = text.chars().filter(|c| !c.is_control()).collect();
    if all.len() <= most {
        return all.into_iter().collect();
    }
    let end = &all[all.len() - most / 2..];
    all[..most / 2].iter().chain(&['…']).chain(end).collect()
}

fn bytes(count: usize) -> String {
    match count as f64 {
        n if n >= 1e6 => format!("{} MB", significant(n / 1e6, 3)),
        n if n >= 1e3 => format!("{} kB", significant(n / 1e3, 3)),
        n => format!("{n} bytes"),
    }
}

/// The pictures of a map before any remedy: as measured, and level with its `spikes` ringed if it has any. Holes are
/// filled by their neighbours, so that there is something to see.
fn before(measured: &Measurement, spikes: &[usize]) -> Result<Vec<Value>, Trouble> {
    let map = filled(measured)?;
    let mut pictures = vec![json!({ "name": "As measured", "svg": picture(&map, &[], "before") })];
    if !spikes.is_empty() {
        let ringed = picture(&levelled(&map, Level::Plane)?, spikes, "spikes");
        pictures.push(json!({ "name": "Level, spikes ringed", "svg": ringed }));
    }
    Ok(pictures)
}

/// Heights above the mean of a map, with rings round some of its points.
fn picture(map: &HeightMap, points: &[usize], key: &str) -> String {
    let mean = map.mean();
    let heights: Vec<f64> = map.heights().iter().map(|h| h - mean).collect();
    contact_report::height_map(&heights, map.grid(), points, PICTURE, key)
}

/// The state `ask`: numbers as they stand in the file, and what the fields filled in so far would mean.
fn ask(request: &Request, file: &[u8]) -> Result<Value, Trouble> {
    let found = raw(request.options()?, |options| surface_io::read_bytes(file, options));
    let (raw, missing) = found.map_err(Trouble::Unread)?;
    if raw.is_profile() {
        return Err(Trouble::Profile { points: raw.heights().len() });
    }
    let [ny, nx] = raw.grid().shape();
    let (low, high, _) = raw.height_summary().unwrap_or_default();
    let about =
        format!("{} · {} · {ny} × {nx} numbers, {low:e} to {high:e}", request.name, raw.format);
    let asked = |need: &Need| match need {
        Need::PixelSize => ("pixel", "pixel size"),
        Need::LateralUnit => ("lateral_unit", "unit of x and y"),
        _ => ("height_unit", "height unit"),
    };
    let (keys, said): (Vec<&str>, Vec<&str>) = missing.iter().map(asked).unzip();
    let pronoun = if said.len() > 1 { "What are they?" } else { "What is it?" };
    Ok(json!({
        "state": "ask", "about": about, "needs": keys,
        "heading": [
            ["The file says ", false], [format!("no {}", said.join(" and no ")), true],
            [format!(". {pronoun}"), false],
        ],
        // The page scales these by what is filled in and asks `meaning` for the words.
        "raw": {
            "shape": [ny, nx], "pixel": raw.grid().pixel(), "range": high - low,
            "gradient": roughness(&filled(&raw)?)?.rms_gradient(),
        },
    }))
}

fn filled(measured: &Measurement) -> Result<HeightMap, Trouble> {
    measured.clone().fill(Fill::Nearest).map_err(|e| Trouble::Incomplete(e.into()))
}

/// What units that are filled in would mean: size, heights, gradient, and whether that is a surface.
pub(crate) fn meaning(request: &Request) -> Result<Value, Trouble> {
    let wrong = || Failure::refused("internal", "no raw numbers");
    let raw = request.raw.as_ref().ok_or_else(wrong)?;
    let reading = &request.reading;
    let lateral = match &reading.pixel {
        Some(text) => parse(text, Dimension::Length)?,
        None => unit(reading.lateral_unit.as_deref())?.unwrap_or(1.0),
    };
    if lateral <= 0.0 {
        let message = "A distance above zero is needed, such as 0.5 µm.";
        return Err(Failure::refused("usage", message).into());
    }
    let height = unit(reading.height_unit.as_deref())?.unwrap_or(1.0);
    let pixel = raw.pixel.map(|p| p * lateral);
    let grid = Grid::new(raw.shape, pixel).map_err(|e| Failure::from(&e))?;
    let [ly, lx] = grid.size();
    let gradient = raw.gradient * height / lateral;
    let (tag, text) = match gradient {
        g if g < USUAL_GRADIENTS[0] => (
            "check",
            "That would be flatter than any measured surface: is the height unit too small?",
        ),
        g if g > USUAL_GRADIENTS[1] => (
            "check",
            "That would be steeper than 60°: is the height unit too large or the distance too small?",
        ),
        _ => ("passed", "A gradient usual for a machined surface."),
    };
    Ok(json!({
        "size": format!("{} × {}", length(lx), length(ly)), "heights": length(raw.range * height),
        "gradient": significant(gradient, 2), "tag": tag, "text": text,
    }))
}
