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

use super::prelude::*;
use crate::binary::Raster;
use crate::entries::sections;

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let end = find(b.data, b"\n#!").ok_or_else(|| b.fault(b.data.len(), "there are no data"))?;
    let mut sections = sections(b, &text::decode(&b.data[..end]), "=")?;
    let mut contents = Contents::default();
    let directory = sections.get("DataSet").ok_or_else(|| b.field("[DataSet]", "is missing"))?;
    let directory = Entries::new(b, directory);
    let count = |key: &str| {
        let count = directory.parsed(key, "whole number")?;
        b.check_items(count).map(|()| count)
    };
    let mut at = end + 3;
    for group in 0..count("GroupCount")? {
        for channel in 0..count(&format!("Gr{group}-Count"))? {
            let section = directory.get(&format!("Gr{group}-Ch{channel}"));
            let Some(section) = section.and_then(|name| sections.get(name)) else { continue };
            let section = Entries::new(b, section);
            let raster = raster(b, at, section)?;
            at = raster.end;
            b.check_items(contents.channels.len() as u64 + 1)?;
            // Spectra and curves stand beside the images.
            let name = section.get("Dim2Name").or(section.get("Dim1Name")).unwrap_or_default();
            contents.add(name, read_channel(raster, section));
        }
    }
    contents.metadata = sections.remove("DataSet-Info").unwrap_or_default();
    Ok(contents)
}

fn raster<'a>(b: Bytes<'a>, at: usize, section: Entries<'_>) -> Result<Raster<'a>, ReadError> {
    let mode = section.text("SaveMode")?;
    if mode != "Binary" {
        return Err(b.unsupported(format!("data saved as {mode}")));
    }
    let is_little = section.text("SaveOrder")? == "Intel";
    let order = if is_little { ByteOrder::Little } else { ByteOrder::Big };
    let is_signed = section.text("SaveSign")? == "Signed";
    let bits: usize = section.parsed("SaveBits", "whole number")?;
    let sample = Sample::of_bits(bits, is_signed);
    let sample = sample.ok_or_else(|| b.field("SaveBits", format!("{bits}, not 8, 16 or 32")))?;
    let shape = [section.parsed("Lines", "size")?, section.parsed("Points", "size")?];
    Bytes { order, ..b }.raster(at, shape, sample)
}

fn read_channel<'a>(raster: Raster<'a>, section: Entries<'_>) -> Result<Channel<'a>, ReadError> {
    let [ny, nx] = raster.shape.map(|n| n as f64);
    let steps = [section.number("Dim1Range")? / ny, section.number("Dim0Range")? / nx];
    let pixel = Pixel::in_units(steps, [section.text("Dim1Unit")?, section.text("Dim0Unit")?]);
    // Number of values the type can hold.
    let levels = (1u64 << (8 * raster.sample.size())) as f64;
    let step = section.number("Dim2Range")? / levels;
    let is_signed = matches!(raster.sample, Sample::I8 | Sample::I16 | Sample::I32);
    let lowest = section.number("Dim2Min")? + if is_signed { 0.5 * levels * step } else { 0.0 };
    let name = format!("{} ({})", section.text("Frame")?, section.text("Dim2Name")?);
    let convert = move |raw: f64| raw * step + lowest;
    let unit = section.text("Dim2Unit")?;
    Ok(Channel::raster(name, unit, pixel, raster, convert).flipped())
}
