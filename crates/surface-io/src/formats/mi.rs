//! MI of Molecular Imaging, Agilent, Keysight (PicoView): a text header, then data.
//!
//! | what | content |
//! |---|---|
//! | header | lines; the first 14 characters are the key |
//! | `fileType` | `Image`; `Spectroscopy` is refused |
//! | `xPixels`, `yPixels` | points along x, along y |
//! | `xLength`, `yLength` | total size in metres: N pixels; may be missing |
//! | `bufferLabel`, `bufferUnit`, `bufferRange` | one group per channel |
//! | `data` | last line: `BINARY` (i16), `BINARY_32` (i32); little endian |
//!
//! The channels follow one after the other, rows from the bottom upwards.
//! Height = value × `bufferRange` / 2^15 (2^31).
//!
//! Source: Molecular Imaging, *MI file format*, as implemented by several free readers.

use super::prelude::*;

const KEY: usize = 14;

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let last = find(b.data, b"\ndata ").ok_or_else(|| b.field("data", "the line is missing"))? + 1;
    let rest = &b.data[last..];
    let end = rest.iter().position(|&byte| byte == b'\n');
    let end = last + end.ok_or_else(|| b.fault(last, "the header has no end"))? + 1;
    let header = text::decode(&b.data[..end]);

    let mut contents = Contents::default();
    let mut buffers: Vec<[String; 3]> = Vec::new(); // label, unit, range
    for (_, line) in text::lines(&header) {
        let Some((key, value)) = line.split_at_checked(KEY.min(line.len())) else { continue };
        let (key, value) = (key.trim(), value.trim().to_owned());
        match (key, buffers.last_mut()) {
            ("bufferLabel", _) => {
                b.check_items(buffers.len() as u64)?;
                buffers.push([value, String::new(), String::new()]);
            }
            ("bufferUnit", Some(buffer)) => buffer[1] = value,
            ("bufferRange", Some(buffer)) => buffer[2] = value,
            ("", _) => {}
            _ => {
                b.check_items(contents.metadata.len() as u64)?;
                contents.metadata.insert(key.to_owned(), value);
            }
        }
    }
    let entries = Entries::new(b, &contents.metadata);
    if let Some(kind) = entries.get("fileType").filter(|kind| *kind != "Image") {
        return Err(b.unsupported(format!("a file of type {kind}")));
    }
    let (sample, full) = match entries.get("data").unwrap_or_default() {
        "BINARY" | "" => (Sample::I16, 32768.0),
        "BINARY_32" => (Sample::I32, 2147483648.0),
        other => return Err(b.unsupported(format!("data written as {other}"))),
    };
    let (nx, ny) = (entries.number("xPixels")?, entries.number("yPixels")?);
    if !(1.0..=1e9).contains(&nx) || !(1.0..=1e9).contains(&ny) {
        return Err(b.field("xPixels, yPixels", format!("{nx} x {ny}")));
    }
    let shape = [ny as usize, nx as usize];
    // Some writers leave the size out: the pixel is then to be given.
    let mut pixel = Pixel::Unknown;
    if entries.get("xLength").and(entries.get("yLength")).is_some() {
        pixel = Pixel::Metres([entries.number("yLength")? / ny, entries.number("xLength")? / nx]);
    }
    let mut at = end;
    for [label, unit, range] in buffers {
        let range: f64 = range.parse().map_err(|_| b.field("bufferRange", format!("{range:?}")))?;
        let raster = b.raster(at, shape, sample)?;
        at = raster.end;
        let convert = move |raw: f64| raw * (range / full);
        let channel = Channel::raster(label, &unit, pixel, raster, convert);
        contents.channels.push(channel.flipped());
    }
    Ok(contents)
}
