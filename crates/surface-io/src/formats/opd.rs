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
//! Source: Wyko, *Vision 32 OPD file format* as implemented by several free readers; the files.

use super::npy::transpose;
use crate::binary::{Bytes, Sample};
use crate::measurement::{Channel, Contents, Pixel};
use crate::{Format, Limits, ReadError};

const FORMAT: Format = Format::Opd;
const ENTRY: usize = 24;

pub(crate) fn sniff(bytes: &[u8]) -> bool {
    bytes.get(2..12) == Some(b"Directory\0")
}

pub(crate) fn parse<'a>(bytes: &'a [u8], limits: &Limits) -> Result<Contents<'a>, ReadError> {
    let b = Bytes::little(bytes, FORMAT);
    let length = |at: usize| {
        let length = b.i32(at + 18)?;
        usize::try_from(length).map_err(|_| b.fault(at + 18, format!("a length of {length}")))
    };
    let directory = length(2)?;
    let count = directory / ENTRY;
    limits.check_items(FORMAT, count as u64)?;
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
            "RAW DATA" | "RAW_DATA" | "OPD" | "Raw" => maps.push((name, at)),
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
        limits.check_points(FORMAT, [ny, nx])?;
        b.map_length(at + 6, [ny, nx], sample)?;
        let step = wavelength / multiplier;
        let channel = Channel::new(name, Some("nm"), [ny, nx], pixel, move || {
            let mut values = b.samples(at + 6, ny * nx, sample)?;
            for value in &mut values {
                let is_missing = value.is_nan() || *value >= missing || *value <= -1e32;
                *value = if is_missing { f64::NAN } else { *value * step };
            }
            Ok(transpose(&values, [nx, ny]))
        });
        contents.channels.push(channel.flipped());
    }
    Ok(contents)
}
