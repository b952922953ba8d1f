//! PLU of Sensofar. All numbers little endian; there is no magic number.
//!
//! | byte | type | content |
//! |---|---|---|
//! | 0 | 128 | date as text |
//! | 128 | u32 | time in s since 1970 |
//! | 132 | 256 | comment |
//! | 388, 392 | u32 | points along y, along x |
//! | 404, 408 | f32 | µm per point along x, along y |
//! | 428 | u32 | kind: 3 topography (others are refused) |
//! | 489 | u8 | number of layers |
//! | 500 | u32 u32 | points along y, along x of the first layer |
//! | 508 | f32 | heights in µm, in rows; 1000001 is a missing point; then their minimum and maximum |
//!
//! Further layers follow in the same way.
//!
//! Source: Sensofar, *PLu file format* (2009), as implemented by several free readers.

use super::prelude::*;
use crate::ReadOptions;

const DATA: usize = 500;

/// Without a magic number everything that can be checked is: the date is text, the two sizes
/// agree, the spacings are lengths, and the data fit.
pub(crate) fn sniff(bytes: &[u8]) -> bool {
    let options = ReadOptions::default();
    let b = Bytes::little(bytes, "Sensofar PLU", &options);
    let plausible = || -> Result<bool, ReadError> {
        let date = b.slice(0, 128)?.split(|&byte| byte == 0).next().unwrap_or_default();
        let is_date = (6..128).contains(&date.len())
            && date.iter().all(|byte| (0x20..0x7f).contains(byte) || byte.is_ascii_whitespace())
            && date.iter().filter(|byte| byte.is_ascii_digit()).count() >= 4;
        let (ny, nx) = (b.u32(DATA)?, b.u32(DATA + 4)?);
        let [dx, dy] = [b.f32(404)?, b.f32(408)?];
        Ok(is_date
            && b.u32(428)? <= 16
            && ny > 0
            && nx > 0
            && dx > 0.0
            && dy > 0.0
            && u64::from(ny) * u64::from(nx) <= bytes.len() as u64 / 4)
    };
    plausible().unwrap_or(false)
}

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let kind = b.u32(428)?;
    if kind != 3 {
        return Err(b.unsupported(format!("a measurement of kind {kind} (topography, 3, is)")));
    }
    let pixel = Pixel::Metres([b.f32(408)?, b.f32(404)?].map(|um| f64::from(um) * 1e-6));
    let mut channels = Vec::new();
    let mut at = DATA;
    for layer in 0..b.u8(489)?.max(1) {
        let shape = [b.u32(at)? as usize, b.u32(at + 4)? as usize];
        let raster = b.raster(at + 8, shape, Sample::F32)?;
        let convert = |um: f64| if um >= 1000001.0 { f64::NAN } else { um };
        let name = format!("Layer {}", layer + 1);
        channels.push(Channel::raster(name, "\u{b5}m", pixel, raster, convert));
        at = raster.end + 8;
    }
    let metadata = [("date", b.text(0, 128)?), ("comment", b.text(132, 256)?)];
    Ok(Contents::new(channels, metadata))
}
