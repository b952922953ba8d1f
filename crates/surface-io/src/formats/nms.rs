//! NanoFocus NMS (µsurf, µscan). All numbers little endian.
//!
//! | byte | type | content |
//! |---|---|---|
//! | 16, 24 | f64 | height in µm of the stored values 0 and 65534 |
//! | 32 | 9 | `OM_MS_2.0` |
//! | 52 | text | kind of map |
//! | 1368, 1372 | u32 | points along x, along y |
//! | 1376, 1384 | f64 | spacing along x and y in nm |
//! | 3468 | u16 | heights, in rows |
//! | then | u8 | intensity, in rows |
//!
//! The stored value 65535 occurs as a height just above that of 65534; no mark for missing points
//! is known.
//!
//! Source: found from files and their known physical size.

use super::prelude::*;

const DATA: usize = 3468;

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let shape = [b.u32(1372)? as usize, b.u32(1368)? as usize];
    let pixel = Pixel::Metres([b.f64(1384)? * 1e-9, b.f64(1376)? * 1e-9]);
    let (low, high) = (b.f64(16)?, b.f64(24)?);
    let raster = b.raster(DATA, shape, Sample::U16)?;
    let convert = move |raw: f64| low + raw / 65534.0 * (high - low);
    let mut channels = vec![Channel::raster("Height", "\u{b5}m", pixel, raster, convert)];
    if let Ok(raster) = b.raster(raster.end, shape, Sample::U8) {
        channels.push(Channel::raster("Intensity", "counts", pixel, raster, |raw| raw));
    }
    let metadata = [("version", b.text(32, 20)?), ("kind", b.text(52, 64)?)];
    Ok(Contents::new(channels, metadata))
}
