//! Wyko (Veeco, Bruker) OPD of the Vision software. All numbers little endian.
//!
//! | byte | type | content |
//! |---|---|---|
//! | 0 | u16 | 1 |
//! | 2 | 24 each | directory: name (16), type i16, length i32, attribute u16; the first entry, `Directory`, is the directory itself and its length is that of all entries |
//! | then | | the blocks, in the order of the directory, each `length` bytes |
//!
//! | block | type | content |
//! |---|---|---|
//! | `RAW DATA`, `RAW_DATA`, `OPD`, `Raw` | u16 u16 u16, data | points along x, along y, bytes per point (1 u8, 2 i16, 4 f32); column by column, each from the bottom upwards, in waves / `Mult` |
//! | `Wavelength` | f32 | nm |
//! | `Mult` | i16 | 1 if absent |
//! | `Aspect` | f32 | dy / dx, 1 if absent |
//! | `Pixel_size` | f32 | mm along x |
//!
//! Missing points: 255, 32766 and above, and beyond 10^32 or not finite, for 1, 2 and 4 bytes.
//!
//! The export as text starts with `Wyko ASCII Data File Format 0 0 1`; lines `X Size`, `Y Size`, then
//! blocks of name, type, length and value between tabs. Behind the name of a map every line is a
//! column of it, from the top downwards; `Bad` is a missing point. Where the second number of the
//! first line is 1 the heights are in nm, not in waves.
//!
//! Source: Wyko, *Vision 32 OPD file format* as implemented by several free readers; the files.

use super::npy::transpose;
use super::prelude::*;

const ENTRY: usize = 24;
pub(crate) const TEXT: &[u8] = b"Wyko ASCII Data File Format";
const MAPS: [&str; 5] = ["RAW DATA", "RAW_DATA", "OPD", "Raw", "SAMPLE_DATA"];

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    if b.data.starts_with(TEXT) {
        return parse_text(b);
    }
    let length = |at: usize| {
        let length = b.i32(at + 18)?;
        usize::try_from(length).map_err(|_| b.fault(at + 18, format!("a length of {length}")))
    };
    let directory = length(2)?;
    let count = directory / ENTRY;
    b.check_items(count as u64)?;
    let mut maps = Vec::new();
    let (mut wavelength, mut pixel) = (None, None);
    let (mut multiplier, mut aspect) = (1.0, 1.0);
    let mut contents = Contents::default();
    let mut at = 2usize.saturating_add(directory);
    for entry in (1..count).map(|i| 2 + ENTRY * i) {
        let name = b.text(entry, 16)?;
        let size = length(entry)?;
        if size == 0 {
            continue;
        }
        b.slice(at, size)?;
        match name.as_str() {
            map if MAPS.contains(&map) => maps.push((name, at)),
            "Wavelength" => wavelength = Some(f64::from(b.f32(at)?)),
            "Mult" => multiplier = f64::from(b.i16(at)?),
            "Aspect" => aspect = f64::from(b.f32(at)?),
            "Pixel_size" => pixel = Some(f64::from(b.f32(at)?) * 1e-3),
            "Title" | "Note" | "Date" | "Time" | "Objective" => {
                contents.metadata.insert(name, b.text(at, size)?);
            }
            _ => {}
        }
        at += size;
    }
    let wavelength = wavelength.ok_or_else(|| b.field("Wavelength", "the block is missing"))?;
    let pixel = pixel.map_or(Pixel::Unknown, |dx| Pixel::Metres([dx * aspect, dx]));
    if multiplier == 0.0 {
        return Err(b.field("Mult", "is 0"));
    }
    for (name, at) in maps {
        let (nx, ny) = (usize::from(b.u16(at)?), usize::from(b.u16(at + 2)?));
        let (sample, missing) = match b.u16(at + 4)? {
            1 => (Sample::U8, 255.0),
            2 => (Sample::I16, 32766.0),
            4 => (Sample::F32, 1e32),
            size => return Err(b.fault(at + 4, format!("{size} bytes per point, not 1, 2, 4"))),
        };
        let raster = b.raster(at + 6, [ny, nx], sample)?;
        let step = wavelength / multiplier;
        let decode = move || Ok(transpose(&raster.values(), [nx, ny]));
        let convert = move |raw: f64| {
            let is_missing = raw.is_nan() || raw >= missing || raw <= -1e32;
            if is_missing { f64::NAN } else { raw * step }
        };
        let channel = Channel::new(name, Some("nm"), [ny, nx], pixel, decode);
        contents.channels.push(channel.converted(convert).flipped());
    }
    Ok(contents)
}

fn parse_text(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let content = text::decode(b.data);
    let mut lines = text::lines(&content);
    let first = lines.next().map_or("", |(_, line)| line);
    let is_in_nm = first.split_whitespace().nth(6) == Some("1");
    let mut fields = BTreeMap::<String, String>::new();
    let mut maps = Vec::new();
    while let Some((number, line)) = lines.next() {
        b.check_items(fields.len() as u64)?;
        let mut cells = line.split('\t').map(str::trim);
        let (Some(name), Some(value)) = (cells.next(), cells.next_back()) else { continue };
        let is_other = ["Image", "Intensity", "SecArr_0"].contains(&name);
        if !MAPS.contains(&name) && !is_other {
            fields.insert(name.to_owned(), value.to_owned());
            continue;
        }
        let side = |key: &str| fields.get(key).and_then(|text| text.parse::<usize>().ok());
        let (Some(nx), Some(ny)) = (side("X Size"), side("Y Size")) else {
            return Err(b.line(number, "neither X Size nor Y Size before the map"));
        };
        b.check_points([ny, nx])?;
        let mut values = Vec::new();
        for _ in 0..nx {
            let next = lines.next();
            let (number, line) =
                next.ok_or_else(|| b.line(number, format!("not {nx} columns follow")))?;
            let before = values.len();
            for value in b.numbers((number, &line.replace(',', "."))) {
                values.push(value?);
            }
            let found = values.len() - before;
            if found != ny {
                return Err(b.line(number, format!("{found} points, a column has {ny}")));
            }
        }
        maps.push((name.to_owned(), is_other, [nx, ny], values));
    }
    let number = |key: &'static str, default: Option<f64>| match fields.get(key) {
        None => default.ok_or_else(|| b.field(key, "the block is missing")),
        Some(text) => match text.replace(',', ".").parse::<f64>() {
            Ok(value) if value.is_finite() && value > 0.0 => Ok(value),
            _ => Err(b.field(key, format!("{text:?} is no number above 0"))),
        },
    };
    let step =
        if is_in_nm { 1.0 } else { number("Wavelength", None)? / number("Mult", Some(1.0))? };
    let mut pixel = Pixel::Unknown;
    if fields.contains_key("Pixel_size") {
        let dx = 1e-3 * number("Pixel_size", None)?;
        pixel = Pixel::Metres([dx * number("Aspect", Some(1.0))?, dx]);
    }
    let mut contents = Contents::default();
    for (name, is_other, stored, values) in maps {
        let (unit, step) = if is_other { ("counts", 1.0) } else { ("nm", step) };
        let shape = [stored[1], stored[0]];
        let decode = move || Ok(transpose(&values, stored));
        let channel = Channel::new(name, Some(unit), shape, pixel, decode);
        contents.channels.push(channel.converted(move |value| value * step));
    }
    contents.metadata = fields;
    Ok(contents)
}
