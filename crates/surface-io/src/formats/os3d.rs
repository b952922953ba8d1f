//! OS3D of OmniSurf3D (Digital Metrology Solutions). All numbers little endian.
//!
//! | what | type | content |
//! |---|---|---|
//! | magic | 10 | `OmniSurf3D` |
//! | version | i32 i32 | major, minor |
//! | identification, date | i32 length and text, each | |
//! | size | i32 i32 | points along x, along y |
//! | spacing | f64 f64 | µm per point along x, along y |
//! | origin | f64 f64 | µm |
//! | heights | f32 | µm, in rows; below −3·10³⁸ is a missing point |
//!
//! Sources: Digital Metrology Solutions, *OmniSurf3D file format*, as read by SurfaceTopography
//! and surfalize (both open readers). Not checked against a real file.

use super::prelude::*;

pub(crate) const MAGIC: &[u8] = b"OmniSurf3D";

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let mut head = Cursor { b, at: MAGIC.len() + 8 };
    let metadata = [("identification", head.text()?), ("date", head.text()?)];
    let at = head.at;
    let shape = [b.u32(at + 4)? as usize, b.u32(at)? as usize];
    let pixel = Pixel::Metres([b.f64(at + 16)?, b.f64(at + 8)?].map(|um| um * 1e-6));
    let raster = b.raster(at + 40, shape, Sample::F32)?;
    let convert = |um: f64| if um < -3e38 { f64::NAN } else { um };
    let channel = Channel::raster("Height", "\u{b5}m", pixel, raster, convert);
    Ok(Contents::new(vec![channel], metadata))
}
