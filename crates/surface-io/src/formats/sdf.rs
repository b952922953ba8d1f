//! SDF, ISO 25178-71 (formerly BCR, EUR 15178): a text and a binary variant.
//!
//! Binary, little endian:
//!
//! | byte | type | field |
//! |---|---|---|
//! | 0 | 8 | `bISO-1.0` or `bBCR-1.0`; in `bISO-2.0` the two numbers of points are u32 and all that follows stands 4 bytes further |
//! | 8, 18, 30 | 10, 12, 12 | ManufacID, CreateDate, ModDate |
//! | 42, 44 | u16 | NumPoints (per profile, along x), NumProfiles |
//! | 46, 54, 62, 70 | f64 | Xscale, Yscale (spacing, metres), Zscale (metres per unit), Zresolution |
//! | 78, 79, 80 | u8 | Compression (0), DataType, CheckType |
//! | 81 | | data, profile by profile, then a trailer |
//!
//! Text: `aISO-1.0`, `aISO-2.0` or `aBCR-1.0`, lines `Field = value`, a line `*`, the numbers, a line `*`,
//! a trailer. `BAD` is a missing point; what follows `;` is a comment.
//!
//! DataType: 0 u8, 1 u16, 2 u32, 3 f32, 4 i8, 5 i16 (in text also `INTEGER`), 6 i32, 7 f64. A missing point is the
//! smallest value of a signed type in ISO, the largest of an unsigned one (in ISO of 16 and 32 bits) and of any whole
//! one in BCR, and NaN or a number at the end of the range of a floating type. Height = value × Zscale.
//!
//! Sources: ISO 25178-71:2017; EUR 15178 for BCR, at second hand.

use super::prelude::*;
use crate::cells::is_mark;

/// Behind the points a trailer of text may follow; more bytes than this or than the points that are no text may not,
/// for then the header lies about the size.
const LONGEST_TRAILER: usize = 1 << 16;

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    if b.data.starts_with(b"b") { binary(b) } else { ascii(b) }
}

/// How a height is stored, and what makes it metres, NaN where the point is missing.
fn encoding(
    b: Bytes<'_>,
    data_type: u8,
    scale: f64,
) -> Result<(Sample, impl Fn(f64) -> f64 + Copy + use<>), ReadError> {
    // The marks of ISO and of BCR.
    let (sample, marks) = match data_type {
        0 => (Sample::U8, [f64::NAN, f64::from(u8::MAX)]),
        1 => (Sample::U16, [f64::from(u16::MAX); 2]),
        2 => (Sample::U32, [f64::from(u32::MAX); 2]),
        3 => (Sample::F32, [f64::NAN; 2]),
        4 => (Sample::I8, [i8::MIN, i8::MAX].map(f64::from)),
        5 => (Sample::I16, [i16::MIN, i16::MAX].map(f64::from)),
        6 => (Sample::I32, [i32::MIN, i32::MAX].map(f64::from)),
        7 => (Sample::F64, [f64::NAN; 2]),
        _ => return Err(b.field("DataType", data_type.to_string())),
    };
    if !(scale.is_finite() && scale > 0.0) {
        return Err(b.field("Zscale", format!("{scale} must be finite and greater than 0")));
    }
    let end = if sample == Sample::F32 { f64::from(f32::MAX) } else { f64::MAX };
    let mark = marks[usize::from(b.data.get(1..4) == Some(b"BCR"))];
    let height = move |raw: f64| {
        let is_missing = raw.is_nan() || raw.abs() >= end || is_mark(raw, mark);
        if is_missing { f64::NAN } else { raw * scale }
    };
    Ok((sample, height))
}

fn binary(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    // Where the scales start, behind the numbers of points.
    let (shape, scales): ([usize; 2], usize) = if b.data.get(5) == Some(&b'2') {
        ([b.u32(46)? as usize, b.u32(42)? as usize], 50)
    } else {
        ([b.u16(44)?.into(), b.u16(42)?.into()], 46)
    };
    refuse_compression(b, b.u8(scales + 32)?.into())?;
    let (sample, height) = encoding(b, b.u8(scales + 33)?, b.f64(scales + 16)?)?;
    let pixel = Pixel::Metres([b.f64(scales + 8)?, b.f64(scales)?]);
    let raster = b.raster(scales + 35, shape, sample)?;
    let trailer = &b.data[raster.end..];
    if trailer.len() >= LONGEST_TRAILER.min(raster.end - scales - 35) && !text::is_text(trailer) {
        let [ny, nx] = shape;
        let what = format!(
            "{} bytes follow the {ny} x {nx} points that the header promises, and they are no text",
            trailer.len()
        );
        return Err(b.fault(raster.end, what));
    }
    let channel = Channel::raster("Z", "m", pixel, raster, height);
    let metadata = [
        ("ManufacID", b.text(8, 10)?),
        ("CreateDate", b.text(18, 12)?),
        ("ModDate", b.text(30, 12)?),
        ("Zresolution", b.f64(scales + 24)?.to_string()),
    ];
    Ok(Contents::new(vec![channel], metadata))
}

fn refuse_compression(b: Bytes<'_>, compression: u64) -> Result<(), ReadError> {
    if compression == 0 {
        return Ok(());
    }
    Err(b.unsupported(format!("Compression = {compression} (the standard defines none)")))
}

fn ascii(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let text = text::decode(b.data);
    let lines = text::lines(&text).skip(1);
    let mut lines = lines.map(|(n, line)| (n, line.split(';').next().unwrap_or_default()));
    let mut metadata = BTreeMap::new();
    for (_, line) in lines.by_ref() {
        if line.trim_start().starts_with('*') {
            break;
        }
        if let Some((key, value)) = line.split_once('=') {
            b.check_items(metadata.len() as u64)?;
            metadata.insert(key.trim().to_owned(), value.trim().to_owned());
        }
    }
    let entries = Entries::new(b, &metadata);
    let whole = |key: &str| entries.parsed::<usize>(key, "whole number");
    refuse_compression(b, whole("Compression").unwrap_or(0) as u64)?;
    let integer = entries.get("DataType").filter(|kind| *kind == "INTEGER").map(|_| Ok(5));
    let data_type = u8::try_from(integer.unwrap_or_else(|| whole("DataType"))?).unwrap_or(u8::MAX);
    let shape = [whole("NumProfiles")?, whole("NumPoints")?];
    let pixel = Pixel::Metres([entries.number("Yscale")?, entries.number("Xscale")?]);
    b.check_points(shape)?;
    let (_, height) = encoding(b, data_type, entries.number("Zscale")?)?;
    let [ny, nx] = shape;
    let mut values = Vec::new(); // grows with the text, whatever the header claims
    for (line, text) in lines {
        let numbers = text.split('*').next().unwrap_or_default();
        for raw in b.numbers((line, numbers)) {
            values.push(height(raw?));
        }
        if numbers.len() < text.len() {
            break;
        }
    }
    if values.len() != ny * nx {
        let what = format!("{} numbers for {ny} profiles of {nx} points", values.len());
        return Err(b.field("data", what));
    }
    let channel = Channel::new("Z", Some("m"), shape, pixel, move || Ok(values));
    Ok(Contents { channels: vec![channel], metadata })
}
