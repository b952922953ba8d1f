//! FRT of FormFactor FRT MicroProf. All numbers little endian.
//!
//! | byte | type | content |
//! |---|---|---|
//! | 0 | 16 | `FRTM_GLIDERV1.00`, or 1.01 with lengths of 8 bytes |
//! | 16 | u16 | number of blocks |
//! | 18 | | blocks: tag u16, length u32, content |
//!
//! | tag | content |
//! |---|---|
//! | 0x65, 0x77 | comment |
//! | 0x66 | u32 u32 u32: points along x, along y, bits per point (16, 32) |
//! | 0x67 | f64 f64: total size along x, along y in metres: N pixels |
//! | 0x6C | u32, f64: range; metres per stored unit |
//! | 0x0B | the heights, u16 or i32, in rows from the bottom; 1 is a missing point |
//!
//! Source: the block list of several free readers, checked against files.

use super::prelude::*;

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let mut contents = Contents::default();
    let (mut grid, mut size, mut step, mut data) = (None, None, None, None);
    let is_wide = b.slice(12, 4)? == b"1.01";
    let mut at = 18;
    for _ in 0..b.u16(16)? {
        if at == b.data.len() {
            break;
        }
        let tag = b.u16(at)?;
        let (length, head) =
            if is_wide { (b.u64(at + 2)?, 10) } else { (u64::from(b.u32(at + 2)?), 6) };
        let length = usize::try_from(length).unwrap_or(usize::MAX);
        at += head;
        b.slice(at, length)?;
        match tag {
            0x65 | 0x77 => contents.note([(&format!("comment {tag:#x}"), b.text(at, length)?)]),
            0x66 => {
                let [nx, ny, bits] = [b.u32(at)?, b.u32(at + 4)?, b.u32(at + 8)?];
                grid = Some([ny as usize, nx as usize, bits as usize]);
            }
            0x67 => size = Some([b.f64(at + 8)?, b.f64(at)?]),
            0x6c => step = Some(b.f64(at + 4)?),
            0x0b => data = Some(at),
            _ => {}
        }
        at += length;
    }
    let missing = |name: &'static str| b.field(name, "the block is missing");
    let [ny, nx, bits] = grid.ok_or_else(|| missing("0x66 (points)"))?;
    let [ly, lx] = size.ok_or_else(|| missing("0x67 (size)"))?;
    let step = step.ok_or_else(|| missing("0x6C (height scale)"))?;
    let data = data.ok_or_else(|| missing("0x0B (heights)"))?;
    let sample = match bits {
        16 => Sample::U16,
        32 => Sample::I32,
        _ => return Err(b.field("0x66 (points)", format!("{bits} bits per point, not 16 or 32"))),
    };
    let pixel = Pixel::Metres([ly / ny as f64, lx / nx as f64]);
    let raster = b.raster(data, [ny, nx], sample)?;
    let convert =
        move |raw: f64| if raw.to_bits() == 1f64.to_bits() { f64::NAN } else { raw * step };
    contents.channels.push(Channel::raster("Height", "m", pixel, raster, convert).flipped());
    Ok(contents)
}
