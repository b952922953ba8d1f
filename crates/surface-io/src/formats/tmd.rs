//! TMD of TrueMap (GelSight). All numbers little endian.
//!
//! | byte | type | content |
//! |---|---|---|
//! | 0 | 32 | `Binary TrueMap Data File v2.0`, end of line, NUL |
//! | 32 | text | comment of any length, ended by NUL |
//! | then | u32 u32 | points along x, along y |
//! | then | f32 f32 | length along x, along y in mm: N pixels |
//! | then | f32 f32 | offsets in mm |
//! | then | f32 | heights in mm, in rows; NaN is a missing point |
//!
//! Source: `readtmd.m` of the vendor, <https://github.com/gelsightinc/gsmatlab>.

use super::prelude::*;

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let comment = b.from(32)?.data;
    let length = comment
        .iter()
        .position(|&byte| byte == 0)
        .ok_or_else(|| b.fault(32, "the comment has no end"))?;
    let at = 32 + length + 1;
    let shape = [b.u32(at + 4)? as usize, b.u32(at)? as usize];
    let [lx, ly] = [b.f32(at + 8)?, b.f32(at + 12)?].map(|mm| f64::from(mm) * 1e-3);
    let pixel = Pixel::Metres([ly / shape[0] as f64, lx / shape[1] as f64]);
    let raster = b.raster(at + 24, shape, Sample::F32)?;
    let channel = Channel::raster("Height", "mm", pixel, raster, |mm| mm);
    Ok(Contents::new(vec![channel], [("comment", b.text(32, length)?)]))
}
