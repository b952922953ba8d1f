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
//! | `voidpixels` | a missing point if it is 32767 or beyond, else how many there are; 32767 in bcrstm and the largest f32 in bcrf are missing points anyway |
//! | data | i16 for bcrstm, f32 for bcrf, in rows |
//!
//! Some writers store (N − 1) pixels as `xlength`; the file cannot tell. It is taken literally.
//!
//! Source: Image Metrology, *BCR-STM and BCRF file formats* (SPIP reference guide).

use super::prelude::*;
use crate::cells::is_mark;
use crate::encoding::{latin1, utf16};

const START: &str = "fileformat = bcr";

fn is_wide(bytes: &[u8]) -> bool {
    let bytes = bytes.strip_prefix(b"\xff\xfe").unwrap_or(bytes);
    bytes.get(1) == Some(&0)
}

fn characters(bytes: &[u8]) -> String {
    if is_wide(bytes) { utf16(bytes, u16::from_le_bytes) } else { latin1(bytes) }
}

pub(crate) fn sniff(bytes: &[u8]) -> bool {
    let start = characters(&bytes[..bytes.len().min(128)]);
    start.trim_start_matches('\u{feff}').to_lowercase().starts_with(START)
}

pub(crate) fn parse(mut b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let width = if is_wide(b.data) { 2 } else { 1 };
    let first = characters(&b.data[..b.data.len().min(width * 65536)]);
    let is_size = |(key, _): &(String, String)| key == "headersize";
    let size = text::lines(&first).find_map(|(_, line)| entry(line).filter(is_size));
    let size = size.into_iter().collect();
    let start = Entries::new(b, &size)
        .parsed::<usize>("headersize", "whole number")?
        .checked_mul(width)
        .filter(|&start| start <= b.data.len())
        .ok_or_else(|| b.field("headersize", "is behind the end of the file"))?;
    let mut metadata = BTreeMap::new();
    for (_, line) in text::lines(characters(&b.data[..start]).trim_start_matches('\u{feff}')) {
        b.check_items(metadata.len() as u64)?;
        metadata.extend(entry(line));
    }
    let entries = Entries::new(b, &metadata);

    let is_float = entries.get("fileformat").is_some_and(|f| f.to_lowercase().starts_with("bcrf"));
    if entries.get("intelmode") == Some("0") {
        b.order = ByteOrder::Big;
    }
    let side = |key: &str| entries.parsed::<usize>(key, "whole number");
    let shape = [side("ypixels")?, side("xpixels")?];
    let unit = |key: &str| entries.get(key).unwrap_or("nm");
    let size = [entries.number("ylength")?, entries.number("xlength")?];
    let steps = [size[0] / shape[0] as f64, size[1] / shape[1] as f64];
    let pixel = Pixel::in_units(steps, [unit("yunit"), unit("xunit")]);
    let step = entries.number_or("bit2nm", 1.0)?;
    let (sample, default) =
        if is_float { (Sample::F32, f64::from(f32::MAX)) } else { (Sample::I16, 32767.0) };
    let void = entries.number_or("voidpixels", default)?;
    let marks = [default, if void.abs() < 32767.0 { default } else { void }];
    let convert = move |raw: f64| {
        let is_void = marks.iter().any(|mark| is_mark(raw, *mark));
        if is_void || raw >= f64::from(f32::MAX) { f64::NAN } else { raw * step }
    };
    let raster = b.raster(start, shape, sample)?;
    let channel = Channel::raster("Height", unit("zunit"), pixel, raster, convert);
    Ok(Contents { channels: vec![channel], metadata })
}

/// Key in lower case and value of a line `key = value`.
fn entry(line: &str) -> Option<(String, String)> {
    let (key, value) = line.split_once('=').filter(|_| !line.trim_start().starts_with('%'))?;
    let value = value.trim_matches(|c: char| c.is_whitespace() || c == '\0');
    Some((key.trim().to_lowercase(), value.to_owned()))
}
