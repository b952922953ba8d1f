//! TIFF of Park Systems (XEI, SmartScan): the picture is a view, the data stand in a tag.
//!
//! | tag | content |
//! |---|---|
//! | 50432 | 0x0E031301 |
//! | 50433 | version: 0x01000001, 0x01000002 |
//! | 50434 | the data, little endian, rows from the bottom upwards |
//! | 50435 | header, little endian |
//!
//! | byte of the header | type | content |
//! |---|---|---|
//! | 0 | u32 | 0 map, 1 profile, 2 spectra (refused) |
//! | 4 | 64 | name, UTF-16 |
//! | 100, 104 | u32 | points along x, along y |
//! | 140, 148 | f64 | size along x, along y in µm: N pixels |
//! | 220, 228, 236 | f64 | gain, scale, offset |
//! | 244 | 16 | unit, UTF-16 |
//! | 348 | u32 | version 2: 0 i16, 1 i32, 2 f32; version 1 is i16 |
//!
//! Value = stored number × gain × scale, in the unit; the offset is one of the view.
//!
//! Sources: Park Systems, *XEI data structure*, as read by SurfaceTopography (open); a file of
//! SmartScan.

use super::prelude::*;
use crate::encoding::utf16;
use crate::tiff;

pub(crate) const MAGIC: u16 = 50432;
const VERSION: u16 = 50433;
const DATA: u16 = 50434;
const HEADER: u16 = 50435;

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let pages = tiff::pages(b, 1)?;
    let page = pages.first().ok_or_else(|| b.fault(4, "there is no directory"))?;
    let (_, header) = page.raw(HEADER)?;
    let h = b.with(header);
    let kind = h.u32(0)?;
    if kind > 1 {
        return Err(b.unsupported(format!("an image of kind {kind} (maps 0 and profiles 1 are)")));
    }
    let shape = [h.u32(104)? as usize, h.u32(100)? as usize];
    b.check_points(shape)?;
    let code = if page.number(VERSION)? > f64::from(0x0100_0001) { h.u32(348)? } else { 0 };
    let sample = Sample::of_number(code as usize, "i2 i4 f4")
        .ok_or_else(|| h.fault(348, format!("numbers of type {code}, not 0, 1 or 2")))?;
    let size = [h.f64(148)?, h.f64(140)?].map(|um| um * 1e-6);
    let pixel = Pixel::Metres([size[0] / shape[0] as f64, size[1] / shape[1] as f64]);
    let (at, data) = page.raw(DATA)?;
    let needed = shape[0] * shape[1] * sample.size();
    if data.len() < needed {
        let what = format!("{} bytes of data, {needed} are needed", data.len());
        return Err(b.field("tag 50434", what));
    }
    let scale = h.f64(228)?;
    let factor = h.f64(220)? * if scale == 0.0 { 1.0 } else { scale };
    let name = wide(h.slice(4, 64)?);
    let unit = wide(h.slice(244, 16)?);
    let raster = b.raster(at, shape, sample)?;
    let channel = Channel::raster(name, &unit, pixel, raster, move |raw| raw * factor);
    let mut contents = Contents::new(vec![channel.flipped()], []);
    contents.note([("software", page.text(305)), ("date", page.text(306))]);
    Ok(contents)
}

/// UTF-16 up to the first NUL.
fn wide(raw: &[u8]) -> String {
    let text = utf16(raw, u16::from_le_bytes);
    text.split('\0').next().unwrap_or_default().trim().to_owned()
}
