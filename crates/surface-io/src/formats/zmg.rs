//! ZMG of Zeta Instruments (KLA Zeta profilers). All numbers little endian.
//!
//! | byte | type | content |
//! |---|---|---|
//! | 0 | 16 | `Zeta-Instruments` |
//! | 85, 89 | u32 | points along x, along y |
//! | 97, 101, 105 | f32 | µm per point along x, along y; µm per stored height |
//! | 117 | u32 | length of the comment |
//! | 205 | | the comment, then heights as i16 in rows |
//!
//! A mark for missing points is not known.
//!
//! Sources: SurfaceTopography, surfalize (both open readers). Not checked against a real file.

use super::prelude::*;

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let shape = [b.u32(89)? as usize, b.u32(85)? as usize];
    let pixel = Pixel::Metres([b.f32(101)?, b.f32(97)?].map(|um| f64::from(um) * 1e-6));
    let step = f64::from(b.f32(105)?);
    let comment = b.u32(117)? as usize;
    let text = b.text(205, comment)?;
    let raster = b.raster(205 + comment, shape, Sample::I16)?;
    let convert = move |raw| raw * step;
    let channel = Channel::raster("Height", "\u{b5}m", pixel, raster, convert);
    Ok(Contents::new(vec![channel], [("comment", text)]))
}
