//! BCR-STM and BCRF of Image Metrology (SPIP): a text header, then binary data.
//!
//! | what | content |
//! |---|---|
//! | header | Latin-1 or UTF-16 LE; first line `fileformat = bcrstm`, `bcrf`, or these with `_unicode`; lines `key = value`, `%` starts a comment |
//! | `headersize` | length of the header in characters; the data follow |
//! | `xpixels`, `ypixels` | points along x, along y |
//! | `xlength`, `ylength`, `xunit`, `yunit` | total size: N pixels; nm if no unit is given |
//! | `zunit` | unit of the heights; nm if absent |
//! | `bit2nm` | factor from stored value to `zunit`; 1 if absent |
//! | `intelmode` | 1 little endian (or absent), 0 big endian |
//! | `voidpixels` | a missing point; else 32767 for bcrstm and the largest f32 for bcrf |
//! | data | i16 for bcrstm, f32 for bcrf, in rows |
//!
//! Some writers store (N − 1) pixels as `xlength`; the file cannot tell. It is taken literally.
//!
//! Source: Image Metrology, *BCR-STM and BCRF file formats* (SPIP reference guide).

use crate::binary::{Bytes, Order, Sample};
use crate::measurement::{Channel, Contents, Pixel, Raster};
use crate::text;
use crate::{Format, Limits, ReadError, metres_per};
use std::collections::BTreeMap;

const FORMAT: Format = Format::Bcrf;
const START: &str = "fileformat = bcr";

fn is_wide(bytes: &[u8]) -> bool {
    let bytes = bytes.strip_prefix(b"\xff\xfe").unwrap_or(bytes);
    bytes.get(1) == Some(&0)
}

fn characters(bytes: &[u8]) -> String {
    if is_wide(bytes) {
        let units = bytes.chunks_exact(2).map(|pair| u16::from_le_bytes([pair[0], pair[1]]));
        return char::decode_utf16(units)
            .map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER))
            .collect();
    }
    bytes.iter().map(|&byte| char::from(byte)).collect()
}

pub(crate) fn sniff(bytes: &[u8]) -> bool {
    let start = characters(&bytes[..bytes.len().min(128)]);
    start.trim_start_matches('\u{feff}').to_lowercase().starts_with(START)
}

pub(crate) fn parse<'a>(bytes: &'a [u8], limits: &Limits) -> Result<Contents<'a>, ReadError> {
    let width = if is_wide(bytes) { 2 } else { 1 };
    let fields = fields(&characters(&bytes[..bytes.len().min(width * 65536)]), None, limits)?;
    let mut b = Bytes::little(bytes, FORMAT);
    let start = whole(b, &fields, "headersize")?
        .checked_mul(width)
        .filter(|&start| start <= bytes.len())
        .ok_or_else(|| b.field("headersize", "is behind the end of the file"))?;
    let header = characters(&bytes[..start]);
    let metadata = self::fields(&header, Some(()), limits)?;

    let is_float = metadata.get("fileformat").is_some_and(|f| f.to_lowercase().starts_with("bcrf"));
    if metadata.get("intelmode").is_some_and(|mode| mode == "0") {
        b.order = Order::Big;
    }
    let shape = [whole(b, &metadata, "ypixels")?, whole(b, &metadata, "xpixels")?];
    limits.check_points(FORMAT, shape)?;
    let size = |length: &'static str, unit: &'static str| {
        let unit = metadata.get(unit).map_or("nm", String::as_str);
        let scale = metres_per(unit).ok_or_else(|| b.field("unit", format!("{unit:?}")))?;
        let text = metadata.get(length).ok_or_else(|| b.field(length, "is missing"))?;
        let value: f64 = text.parse().map_err(|_| b.field(length, format!("{text:?}")))?;
        Ok::<f64, ReadError>(value * scale)
    };
    let pixel = Pixel::Metres([
        size("ylength", "yunit")? / shape[0] as f64,
        size("xlength", "xunit")? / shape[1] as f64,
    ]);
    let number = |key: &'static str, default: f64| match metadata.get(key) {
        None => Ok(default),
        Some(text) => text.parse::<f64>().map_err(|_| b.field(key, format!("{text:?}"))),
    };
    let step = number("bit2nm", 1.0)?;
    let (sample, default) =
        if is_float { (Sample::F32, f64::from(f32::MAX)) } else { (Sample::I16, 32767.0) };
    let void = number("voidpixels", default)? as f32;
    let convert = move |raw: f64| {
        // Compared as stored: the mark is printed with fewer digits than it has.
        let is_void = (raw as f32).to_bits() == void.to_bits() || raw >= f64::from(f32::MAX);
        if is_void { f64::NAN } else { raw * step }
    };
    let unit = metadata.get("zunit").map_or("nm", String::as_str);
    let raster = Raster { bytes: b, at: start, shape, sample };
    let channel = Channel::raster("Height", Some(unit), pixel, raster, convert)?;
    Ok(Contents { channels: vec![channel], metadata })
}

/// The `key = value` lines; up to `headersize` only, or all of them.
fn fields(
    header: &str,
    all: Option<()>,
    limits: &Limits,
) -> Result<BTreeMap<String, String>, ReadError> {
    let mut fields = BTreeMap::new();
    for (_, line) in text::lines(header.trim_start_matches('\u{feff}')) {
        let Some((key, value)) = line.split_once('=') else { continue };
        if line.trim_start().starts_with('%') {
            continue;
        }
        limits.check_items(FORMAT, fields.len() as u64)?;
        let value = value.trim_matches(|c: char| c.is_whitespace() || c == '\0');
        fields.insert(key.trim().to_lowercase(), value.to_owned());
        if all.is_none() && fields.contains_key("headersize") {
            break;
        }
    }
    Ok(fields)
}

fn whole(
    b: Bytes<'_>,
    fields: &BTreeMap<String, String>,
    key: &'static str,
) -> Result<usize, ReadError> {
    let text = fields.get(key).ok_or_else(|| b.field(key, "is missing in the header"))?;
    text.parse().map_err(|_| b.field(key, format!("{text:?} is no whole number")))
}
