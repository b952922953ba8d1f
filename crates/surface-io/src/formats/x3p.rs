//! X3P, ISO 25178-72 (formerly ISO 5436-2): a ZIP archive with `main.xml` and, for large maps,
//! binary data beside it.
//!
//! | member or element | content |
//! |---|---|
//! | `main.xml` | in the top folder, or in one folder below it |
//! | `Record1/FeatureType` | `SUR` map, `PRF` profile, `PCL` point cloud (refused) |
//! | `Record1/Axes/CX`, `CY`, `CZ` | `AxisType` `I` incremental or `A` absolute; `DataType` `I` i16, `L` i32, `F` f32, `D` f64; `Increment`, `Offset` in metres |
//! | `Record2` | instrument, date, creator: metadata |
//! | `Record3/MatrixDimension` | `SizeX` (fastest), `SizeY`, `SizeZ` (layers, slowest) |
//! | `Record3/DataList/Datum` | one z per element as text; an empty element is a missing point |
//! | `Record3/DataLink/PointDataLink` | path of the binary z, little endian, beside `main.xml` |
//! | `Record3/DataLink/ValidPointsLink` | path of the mask: one bit per point, lowest bit first, 1 = valid |
//!
//! Heights are `z * Increment + Offset` for integers; floating point heights are metres already
//! and only the offset applies. NaN and infinity are missing points. `Increment` is the distance of neighbouring
//! points. A document type declaration
//! is refused, so no entity is ever expanded.
//!
//! Source: ISO 25178-72:2017; the schema `ISO5436_2.xsd` and sample files of openGPS,
//! <https://sourceforge.net/p/open-gps>.

use super::archive::is_main_xml;
use super::prelude::*;
use crate::meaning::UNUSED;

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let mut archive = Archive::open(b)?;
    let mains = archive.names.iter().filter(|name| is_main_xml(name));
    let main = mains.min_by_key(|name| name.matches('/').count()).cloned();
    let main = main.ok_or_else(|| b.field("archive", "there is no main.xml"))?;
    let folder = &main[..main.len() - "main.xml".len()];
    let xml = archive.unpack(&main)?;
    let (fields, list, bad) = main_xml(b.with(&xml))?;
    let entries = Entries::new(b, &fields);
    let [nx, ny, layers] = size(b, entries)?;
    let points = nx.saturating_mul(ny).saturating_mul(layers);
    b.check_points([points, 1])?;
    b.check_items(layers as u64)?;

    let pixel = Pixel::Metres(pixel(b, entries, ny)?);
    let mut unpack = |name: &'static str| match entries.get(&format!("Record3/DataLink/{name}")) {
        Some(link) => {
            let fault = || b.field(name, format!("the archive has no member {link:?}"));
            archive.unpack(&member(&archive, folder, link).ok_or_else(fault)?).map(Some)
        }
        None => Ok(None),
    };
    let raw = unpack("PointDataLink")?;
    let mask = if raw.is_some() { unpack("ValidPointsLink")? } else { None };
    let offset = entries.number_or("Record1/Axes/CZ/Offset", 0.0)?;
    let increment = entries.number_or("Record1/Axes/CZ/Increment", 1.0)?;
    let (sample, factor) = match entries.text("Record1/Axes/CZ/DataType")? {
        "I" => (Sample::I16, increment),
        "L" => (Sample::I32, increment),
        "F" => (Sample::F32, 1.0),
        "D" => (Sample::F64, 1.0),
        other => {
            let what = format!("{other:?} is none of I, L, F, D");
            return Err(b.field("Record1/Axes/CZ/DataType", what));
        }
    };
    let mut z = match raw {
        Some(raw) if raw.len() / sample.size() >= points => {
            let mut z = sample.decode(&raw[..points * sample.size()], ByteOrder::Little);
            // Some writers mark a missing point by infinity instead of NaN.
            z.iter_mut().filter(|z| z.is_infinite()).for_each(|z| *z = f64::NAN);
            z
        }
        Some(raw) => {
            let (n, size) = (raw.len(), sample.size());
            let what = format!("{n} bytes for {points} points of {size} bytes");
            return Err(b.field("PointDataLink", what));
        }
        None if list.len() != points => {
            let what = format!("{} values for {points} points", list.len());
            return Err(b.field("Record3/DataList", what));
        }
        None => bad.map_or(Ok(list), Err)?,
    };
    for z in &mut z {
        *z = *z * factor + offset;
    }
    if let Some(mask) = mask {
        if mask.len() < points.div_ceil(8) {
            return Err(b.field("ValidPointsLink", "the mask is shorter than the map"));
        }
        for (i, z) in z.iter_mut().enumerate() {
            if mask[i / 8] >> (i % 8) & 1 == 0 {
                *z = f64::NAN;
            }
        }
    }

    // From the end, so that each layer is moved once.
    let mut parts: Vec<_> = (1..layers).rev().map(|layer| z.split_off(layer * nx * ny)).collect();
    parts.push(z);
    let layer = |(number, z): (usize, Vec<f64>)| {
        let name = match layers {
            1 => "Topography".to_owned(),
            _ => format!("Topography, layer {}", number + 1),
        };
        Channel::new(name, Some("m"), [ny, nx], pixel, move || Ok(z))
    };
    let channels = parts.into_iter().rev().enumerate().map(layer).collect();
    let metadata = fields.iter().filter_map(|(path, value)| {
        let key = path.strip_prefix("Record2/").or_else(|| path.strip_prefix("Record1/"))?;
        (!key.starts_with("Axes/")).then(|| (key.to_owned(), value.clone()))
    });
    let unused = (factor.to_bits() != increment.to_bits()).then(|| {
        (UNUSED.to_owned(), format!("Increment of heights stored in metres = {increment:e}"))
    });
    let metadata = metadata.chain(unused);
    Ok(Contents { channels, metadata: metadata.collect() })
}

/// A link is relative to `main.xml`; some writers start it at the top folder.
fn member(archive: &Archive<'_>, folder: &str, link: &str) -> Option<String> {
    let link = link.trim().trim_start_matches("./").replace('\\', "/");
    [format!("{folder}{link}"), link.trim_start_matches('/').to_owned()]
        .into_iter()
        .find(|name| archive.names.contains(name))
}

/// `main.xml`, flattened: the text of every element by its path below the root, every Datum, and the refusal of the
/// first one that is no number.
type MainXml = (BTreeMap<String, String>, Vec<f64>, Option<ReadError>);

fn main_xml(b: Bytes<'_>) -> Result<MainXml, ReadError> {
    let (mut fields, mut list, mut bad) = (BTreeMap::new(), Vec::new(), None);
    xml::walk(b, "main.xml", |element| {
        let [_root, path @ ..] = element.path else { return Ok(()) };
        let text = element.text.trim();
        if element.name() == "Datum" {
            let number = list.len() + 1;
            b.check_points([number, 1])?;
            let z = text.parse();
            if z.is_err() && !text.is_empty() {
                let what = if text.contains(';') {
                    "several coordinates in one Datum (only z of evenly spaced axes is read)"
                } else {
                    "no number"
                };
                let fault = || b.field(format!("Datum {number}"), format!("{text:?}: {what}"));
                bad.get_or_insert_with(fault);
            }
            list.push(z.unwrap_or(f64::NAN));
        } else if !text.is_empty() {
            b.check_items(fields.len() as u64 + 1)?;
            fields.insert(path.join("/"), text.to_owned());
        }
        Ok(())
    })?;
    Ok((fields, list, bad))
}

/// `[SizeX, SizeY, SizeZ]`.
fn size(b: Bytes<'_>, entries: Entries<'_>) -> Result<[usize; 3], ReadError> {
    let feature = entries.text("Record1/FeatureType")?;
    if !matches!(feature, "SUR" | "PRF") {
        let kinds = "(maps SUR and profiles PRF are)";
        return Err(b.unsupported(format!("feature type {feature} {kinds}")));
    }
    if feature == "PRF" && entries.get("Record3/ListDimension").is_some() {
        return Ok([entries.parsed("Record3/ListDimension", "whole number")?, 1, 1]);
    }
    let side = |name: &str| {
        let path = format!("Record3/MatrixDimension/{name}");
        match entries.parsed(&path, "size")? {
            0 => Err(b.field(path, "is 0")),
            side => Ok(side),
        }
    };
    Ok([side("SizeX")?, side("SizeY")?, side("SizeZ")?])
}

/// `[dy, dx]` of incremental axes.
fn pixel(b: Bytes<'_>, entries: Entries<'_>, ny: usize) -> Result<[f64; 2], ReadError> {
    let step = |axis: &str| {
        let kind = entries.text(&format!("Record1/Axes/{axis}/AxisType"))?;
        if kind != "I" {
            let feature = format!("axis {axis} of type {kind} (evenly spaced axes, I, are)");
            return Err(b.unsupported(feature));
        }
        entries.number(&format!("Record1/Axes/{axis}/Increment"))
    };
    let dx = step("CX")?;
    // The y axis of a profile has no steps.
    let dy = if ny == 1 { step("CY").unwrap_or(dx) } else { step("CY")? };
    Ok([dy, dx])
}
