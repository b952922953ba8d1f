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
            let stored = Stored::of(b, section, limits)?;
            let length = b.map_length(at, stored.shape, stored.sample)?;
            limits.check_items(FORMAT, contents.channels.len() as u64 + 1)?;
            // Spectra and curves stand beside the images; they must not cost them.
            let channel = read_channel(&stored, b, at, section).unwrap_or_else(|fault| {
                let name = section.get("Dim2Name").or_else(|| section.get("Dim1Name"));
                Channel::unreadable(name.map_or("", String::as_str), fault)
            });
            contents.channels.push(channel);
            at += length;
        }
    }
    contents.metadata = sections.remove("DataSet-Info").unwrap_or_default();
    Ok(contents)
}

/// How the numbers of a channel are stored.
struct Stored {
    shape: [usize; 2],
    sample: Sample,
    order: Order,
    is_signed: bool,
    /// Number of values the type can hold.
    levels: f64,
}

impl Stored {
    fn of(b: Bytes<'_>, section: &Section, limits: &Limits) -> Result<Self, ReadError> {
        let get = |key| get(b, section, key);
        let side = |key: &'static str| {
            let text = get(key)?;
            text.parse::<usize>().map_err(|_| b.field(key, format!("{text:?} is no size")))
        };
        if get("SaveMode")? != "Binary" {
            let feature = format!("data saved as {}", get("SaveMode")?);
            return Err(ReadError::Unsupported { format: FORMAT, feature: feature.into() });
        }
        let order = if get("SaveOrder")? == "Intel" { Order::Little } else { Order::Big };
        let is_signed = get("SaveSign")? == "Signed";
        let (sample, levels) = match (get("SaveBits")?, is_signed) {
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
        Ok(Self { shape, sample, order, is_signed, levels })
    }
}

fn get<'s>(b: Bytes<'_>, section: &'s Section, key: &'static str) -> Result<&'s str, ReadError> {
    section.get(key).map(String::as_str).ok_or_else(|| b.field(key, "is missing"))
}

fn read_channel<'a>(
    stored: &Stored,
    b: Bytes<'a>,
    at: usize,
    section: &Section,
) -> Result<Channel<'a>, ReadError> {
    let get = |key| get(b, section, key);
    let number = |key: &'static str| {
        let text = get(key)?;
        text.parse::<f64>().map_err(|_| b.field(key, format!("{text:?} is no number")))
    };
    let &Stored { shape, sample, order, is_signed, levels } = stored;
    let step_x = number("Dim0Range")? / shape[1] as f64;
    let step_y = number("Dim1Range")? / shape[0] as f64;
    let pixel = match (metres_per(get("Dim1Unit")?), metres_per(get("Dim0Unit")?)) {
        (Some(y), Some(x)) => Pixel::Metres([step_y * y, step_x * x]),
        _ => Pixel::Unknown,
    };
    let step = number("Dim2Range")? / levels;
    let lowest = number("Dim2Min")? + if is_signed { 0.5 * levels * step } else { 0.0 };
    let name = format!("{} ({})", get("Frame")?, get("Dim2Name")?);
    let raster = Raster { bytes: Bytes { order, ..b }, at, shape, sample };
    let convert = move |raw: f64| raw * step + lowest;
    let channel = Channel::raster(name, Some(get("Dim2Unit")?), pixel, raster, convert)?;
    Ok(channel.flipped())
}
