//! NID and EZD of Nanosurf (easyScan): a text header, then data.
//!
//! | what | content |
//! |---|---|
//! | header | `[Section]` and `key=value`; starts with `[DataSet]`, ends before `#!` |
//! | `[DataSet]` | `GroupCount`; `Gr0-Count`; `Gr0-Ch1=DataSet-0:1` names the section of a channel |
//! | `Points`, `Lines` | points along x, along y |
//! | `Dim0Range`, `Dim1Range` with `Dim0Unit`, `Dim1Unit` | total size along x, along y: N pixels |
//! | `Dim2Range`, `Dim2Min`, `Dim2Unit`, `Dim2Name` | height: full range, lowest value, unit, name |
//! | `SaveBits`, `SaveSign`, `SaveOrder` | 8, 16, 32; `Signed`, `Unsigned`; `Intel` (little endian), `Motorola` |
//!
//! The channels follow `#!` one after the other, rows from the bottom upwards. Height =
//! `Dim2Min` + (value − lowest value of the type) × `Dim2Range` / 2^bits.
//!
//! Source: Nanosurf, *NID file format*, as implemented by several free readers.

use crate::binary::{Bytes, Order, Sample, find};
use crate::measurement::{Channel, Contents, Pixel, Raster};
use crate::text;
use crate::{Format, Limits, ReadError, metres_per};
use std::collections::BTreeMap;

const FORMAT: Format = Format::Nid;
type Section = BTreeMap<String, String>;

pub(crate) fn sniff(bytes: &[u8]) -> bool {
    bytes.starts_with(b"[DataSet]")
}

pub(crate) fn parse<'a>(bytes: &'a [u8], limits: &Limits) -> Result<Contents<'a>, ReadError> {
    let b = Bytes::little(bytes, FORMAT);
    let end = find(bytes, b"\n#!").ok_or_else(|| b.fault(bytes.len(), "there are no data"))?;
    let header = text::decode(&bytes[..end]);
    let mut sections: BTreeMap<String, Section> = BTreeMap::new();
    let mut name = String::new();
    let mut count = 0;
    for (_, line) in text::lines(&header) {
        count += 1;
        limits.check_items(FORMAT, count)?;
        let line = line.trim();
        if let Some(section) = line.strip_prefix('[').and_then(|l| l.strip_suffix(']')) {
            section.clone_into(&mut name);
        } else if let Some((key, value)) = line.split_once('=') {
            let section = sections.entry(name.clone()).or_default();
            section.insert(key.trim().to_owned(), value.trim().to_owned());
        }
    }
    let mut contents = Contents::default();
    let directory = sections.get("DataSet").ok_or_else(|| b.field("[DataSet]", "is missing"))?;
    let counted = |key: &str| {
        directory
            .get(key)
            .and_then(|n| n.parse::<u64>().ok())
            .ok_or_else(|| b.field(key.to_owned(), "is missing or no whole number"))
    };
    let mut at = end + 3;
    let groups = counted("GroupCount")?;
    limits.check_items(FORMAT, groups)?;
    for group in 0..groups {
        let channels = counted(&format!("Gr{group}-Count"))?;
        limits.check_items(FORMAT, channels)?;
        for channel in 0..channels {
            let section = directory.get(&format!("Gr{group}-Ch{channel}"));
            let Some(section) = section.and_then(|name| sections.get(name)) else { continue };
            let (channel, length) = read_channel(b, at, section, limits)?;
            contents.channels.push(channel);
            at += length;
        }
    }
    contents.metadata = sections.remove("DataSet-Info").unwrap_or_default();
    Ok(contents)
}

fn read_channel<'a>(
    mut b: Bytes<'a>,
    at: usize,
    section: &Section,
    limits: &Limits,
) -> Result<(Channel<'a>, usize), ReadError> {
    let plain = b;
    let get = |key: &'static str| {
        section.get(key).map(String::as_str).ok_or_else(|| plain.field(key, "is missing"))
    };
    let number = |key: &'static str| {
        let text = get(key)?;
        text.parse::<f64>().map_err(|_| plain.field(key, format!("{text:?} is no number")))
    };
    let side = |key: &'static str| {
        let text = get(key)?;
        text.parse::<usize>().map_err(|_| plain.field(key, format!("{text:?} is no size")))
    };
    if get("SaveMode")? != "Binary" {
        let feature = format!("data saved as {}", get("SaveMode")?);
        return Err(ReadError::Unsupported { format: FORMAT, feature: feature.into() });
    }
    if get("SaveOrder")? != "Intel" {
        b.order = Order::Big;
    }
    let signed = get("SaveSign")? == "Signed";
    let (sample, levels) = match (get("SaveBits")?, signed) {
        ("8", true) => (Sample::I8, 256.0),
        ("8", false) => (Sample::U8, 256.0),
        ("16", true) => (Sample::I16, 65536.0),
        ("16", false) => (Sample::U16, 65536.0),
        ("32", true) => (Sample::I32, 4294967296.0),
        ("32", false) => (Sample::U32, 4294967296.0),
        (bits, _) => return Err(b.field("SaveBits", format!("{bits:?}, not 8, 16 or 32"))),
    };
    let shape = [side("Lines")?, side("Points")?];
    limits.check_points(FORMAT, shape)?;
    let step_x = number("Dim0Range")? / shape[1] as f64;
    let step_y = number("Dim1Range")? / shape[0] as f64;
    let pixel = match (metres_per(get("Dim1Unit")?), metres_per(get("Dim0Unit")?)) {
        (Some(y), Some(x)) => Pixel::Metres([step_y * y, step_x * x]),
        _ => Pixel::Unknown,
    };
    let step = number("Dim2Range")? / levels;
    let lowest = number("Dim2Min")? + if signed { 0.5 * levels * step } else { 0.0 };
    let name = format!("{} ({})", get("Frame")?, get("Dim2Name")?);
    let raster = Raster { bytes: b, at, shape, sample };
    let convert = move |raw: f64| raw * step + lowest;
    let channel = Channel::raster(name, Some(get("Dim2Unit")?), pixel, raster, convert)?;
    Ok((channel.flipped(), b.map_length(at, shape, sample)?))
}
