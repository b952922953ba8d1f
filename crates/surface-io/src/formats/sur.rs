//! SUR and PRO of Digital Surf (MountainsMap, NanoScope Analysis exports, many instruments).
//!
//! All numbers little endian. An object is a header of 512 bytes, a comment, a private zone and
//! the data; a file may hold several objects.
//!
//! | byte | type | content |
//! |---|---|---|
//! | 0 | 12 | `DIGITAL SURF`, or `DSCOMPRESSED` |
//! | 14 | i16 | number of objects |
//! | 18 | i16 | kind: 1 profile, 2 surface, 8 and 11 surfaces of several layers, others are refused |
//! | 20, 50 | 30, 30 | name, operator or instrument |
//! | 86 | i16 | 1 if there are missing points |
//! | 98 | i16 | bits per point, 16 or 32 (signed) |
//! | 100, 104 | i32 | smallest and largest stored value; a missing point is the smallest − 2, if byte 86 says that there are any |
//! | 108, 112 | i32 | points per line, lines |
//! | 120, 124, 128 | f32 | spacing along x, along y, height step |
//! | 164 | 16 | name of the height axis |
//! | 180, 196, 212 | 16 | units of these three, Latin-1 |
//! | 306–316 | 6 × i16 | second, minute, hour, day, month, year |
//! | 324 | u32 | packed size of compressed data |
//! | 334, 336 | u16 | length of the comment and of the private zone |
//! | 474 | f32 | height of stored value 0, in the unit of byte 212 |
//!
//! Compressed data: u32 number of streams; u32 unpacked and u32 packed size of each; the zlib
//! streams.
//!
//! Sources: Digital Surf, *Surf File Format* (2018), and the files of several writers.

use super::prelude::*;
use crate::unpack::zlib;

const HEADER: usize = 512;
const COMPRESSED: &[u8] = b"DSCOMPRESSED";

pub(crate) fn sniff(bytes: &[u8]) -> bool {
    bytes.starts_with(b"DIGITAL SURF") || bytes.starts_with(COMPRESSED)
}

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let mut contents = Contents::default();
    let count = match b.i16(18)? {
        1 | 2 => 1,
        8 | 11 => b.i16(14)?.max(1),
        kind => {
            let kinds = "(profiles 1 and surfaces 2, 8, 11 are)";
            return Err(b.unsupported(format!("an object of kind {kind} {kinds}")));
        }
    };
    let mut at = 0;
    for _ in 0..count {
        let (channel, next) = object(b, at)?;
        contents.channels.push(channel);
        at = next;
    }
    let comment = b.text(HEADER, usize::from(b.u16(334)?))?;
    contents.note([("name", b.text(20, 30)?), ("operator", b.text(50, 30)?), ("comment", comment)]);
    let [second, minute, hour, day, month, year] =
        [b.i16(306)?, b.i16(308)?, b.i16(310)?, b.i16(312)?, b.i16(314)?, b.i16(316)?];
    if year > 0 {
        let date = format!("{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}");
        contents.metadata.insert("date".into(), date);
    }
    Ok(contents)
}

/// One object from byte `at`, and where the next one starts.
fn object(b: Bytes<'_>, at: usize) -> Result<(Channel<'_>, usize), ReadError> {
    let o = b.from(at)?;
    if !sniff(o.data) {
        return Err(b.fault(at, "an object does not start with its name"));
    }
    let side = |place: usize| {
        let n = o.i32(place)?;
        let side = usize::try_from(n).ok().filter(|&n| n > 0);
        side.ok_or_else(|| b.fault(at + place, format!("{n} points; at least 1 is needed")))
    };
    let shape = [side(112)?, side(108)?];
    b.check_points(shape)?;
    let sample = match o.i16(98)? {
        16 => Sample::I16,
        32 => Sample::I32,
        bits => return Err(b.fault(at + 98, format!("{bits} bits per point, not 16 or 32"))),
    };
    let data = HEADER + usize::from(o.u16(334)?) + usize::from(o.u16(336)?);

    let steps = [o.f32(124)?, o.f32(120)?].map(f64::from);
    // A profile has one line: unit and spacing of y are often empty.
    let y_unit = if shape[0] == 1 { 180 } else { 196 };
    let pixel = Pixel::in_units(steps, [&o.text(y_unit, 16)?, &o.text(180, 16)?]);
    let (step, offset) = (f64::from(o.f32(128)?), f64::from(o.f32(474)?));
    let mark = (o.i16(86)? != 0).then_some(f64::from(o.i32(100)?) - 2.0);
    let convert = move |raw: f64| {
        let is_missing = mark.is_some_and(|mark| raw.to_bits() == mark.to_bits());
        if is_missing { f64::NAN } else { raw * step + offset }
    };
    let (name, unit) = (o.text(164, 16)?, o.text(212, 16)?);
    let name = if name.is_empty() { "Z".to_owned() } else { name };

    if !o.data.starts_with(COMPRESSED) {
        let raster = o.raster(data, shape, sample)?;
        let channel = Channel::raster(name, &unit, pixel, raster, convert);
        return Ok((channel, at + raster.end));
    }
    let (unpacked, end) = unpack(o, data)?;
    let wanted = shape[0] * shape[1];
    let channel = Channel::new(name, Some(&unit), shape, pixel, move || {
        let values = sample.decode(&unpacked, ByteOrder::Little);
        if values.len() != wanted {
            let what = format!("{} points unpacked, {wanted} expected", values.len());
            return Err(o.fault(data, what));
        }
        Ok(values)
    });
    Ok((channel.converted(convert), at + end))
}

fn unpack(o: Bytes<'_>, at: usize) -> Result<(Vec<u8>, usize), ReadError> {
    let streams = o.u32(at)? as usize;
    o.check_items(streams as u64)?;
    let sizes = (0..streams)
        .map(|i| Ok([o.u32(at + 4 + 8 * i)?, o.u32(at + 8 + 8 * i)?]))
        .collect::<Result<Vec<_>, ReadError>>()?;
    o.options.limits.check_unpacked(o.format, sizes.iter().map(|s| u64::from(s[0])).sum())?;
    let mut at = at + 4 + 8 * streams;
    let mut unpacked = Vec::new();
    for [plain, packed] in sizes {
        let stream = zlib(o.slice(at, packed as usize)?, plain as usize)
            .map_err(|what| o.fault(at, format!("compressed data: {what}")))?;
        if stream.len() != plain as usize {
            return Err(o.fault(at, "the compressed data end too early"));
        }
        unpacked.extend(stream);
        at += packed as usize;
    }
    Ok((unpacked, at))
}
