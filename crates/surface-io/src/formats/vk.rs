//! VK3, VK4, VK6 and VK7 of Keyence laser microscopes (VK-9700, VK-X). All numbers little endian.
//!
//! | byte | type | content |
//! |---|---|---|
//! | 0 | 4 | `VK4_` or `VK3_` |
//! | 8 | u32 | 0 |
//! | 12 | u32 | offset of the conditions of measurement |
//! | 36, 40, 44 | u32 | offsets of up to three height images, 0 if there is none |
//! | conditions + 4 … 24 | 6 × u32 | year, month, day, hour, minute, second |
//! | conditions + 168, 172 | u32 | pm per point along x, along y |
//! | conditions + 176 | u32 | pm per stored height |
//! | image + 0, 4 | u32 | points along x, along y |
//! | image + 8, 16 | u32 | bits per point (8, 16, 32, unsigned), bytes of data |
//! | image + 796 | | heights in rows (behind a palette of 768 bytes) |
//!
//! VK6 and VK7 are the three letters, u32 length of a preview picture, the picture, and a ZIP
//! archive whose member `Vk4File` is a VK4. The format has no mark for missing points; 0 is a
//! height.
//!
//! Sources: SurfaceTopography, surfalize (both open readers); a VK6 file of a VK-X3000.

use super::prelude::*;

/// True for a file around a VK4, which is taken out of it before.
pub(crate) fn is_packed(bytes: &[u8]) -> bool {
    matches!(bytes, [b'V', b'K', b'6' | b'7', ..])
}

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    if is_packed(b.data) {
        return Err(b.unsupported("a VK6 or VK7 that was not unpacked (feature `zip`)"));
    }
    if b.u32(8)? != 0 {
        return Err(b.fault(8, "4 zeros expected here"));
    }
    let conditions = b.from(b.u32(12)? as usize)?;
    let picometres = |at: usize| conditions.u32(at).map(|pm| f64::from(pm) * 1e-12);
    let pixel = Pixel::Metres([picometres(172)?, picometres(168)?]);
    let step = picometres(176)?;
    let mut channels = Vec::new();
    for (number, place) in [36, 40, 44].into_iter().enumerate() {
        let at = b.u32(place)? as usize;
        if at == 0 {
            continue;
        }
        let image = b.from(at)?;
        let shape = [image.u32(4)? as usize, image.u32(0)? as usize];
        let bits = image.u32(8)? as usize;
        let sample = Sample::of_bits(bits, false);
        let fault = || b.fault(at + 8, format!("{bits} bits a point, not 8, 16 or 32"));
        let sample = sample.ok_or_else(fault)?;
        let raster = b.raster(at + 796, shape, sample)?;
        if image.u32(16)? as usize != raster.end - (at + 796) {
            let what = format!("{} bytes for {} x {} points", image.u32(16)?, shape[0], shape[1]);
            return Err(b.fault(at + 16, what));
        }
        let name = if number == 0 { "Height".to_owned() } else { format!("Height {}", number + 1) };
        channels.push(Channel::raster(name, "m", pixel, raster, move |raw| raw * step));
    }
    if channels.is_empty() {
        return Err(b.fault(36, "the file has no height image"));
    }
    let part = |i: usize| conditions.u32(4 + 4 * i);
    let [year, month, day] = [part(0)?, part(1)?, part(2)?];
    let [hour, minute, second] = [part(3)?, part(4)?, part(5)?];
    let date = format!("{year}-{month:02}-{day:02} {hour:02}:{minute:02}:{second:02}");
    Ok(Contents::new(channels, [("date", date)]))
}
