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
//! archive whose member `Vk4File` is a VK4. The spacing is stored, so the question of N or N − 1
//! intervals does not arise. The format has no mark for missing points; 0 is a height.
//!
//! Sources: SurfaceTopography, surfalize (both open readers); a VK6 file of a VK-X3000.

use crate::binary::{Bytes, Sample};
use crate::measurement::{Channel, Contents, Pixel, Raster};
use crate::{Format, Limits, ReadError};

const FORMAT: Format = Format::Vk;

pub(crate) fn sniff(bytes: &[u8]) -> bool {
    matches!(bytes, [b'V', b'K', b'3' | b'4', b'_', ..] | [b'V', b'K', b'6' | b'7', ..])
}

pub(crate) fn parse<'a>(bytes: &'a [u8], limits: &Limits) -> Result<Contents<'a>, ReadError> {
    if matches!(bytes, [_, _, b'6' | b'7', ..]) {
        return packed(bytes, limits);
    }
    let images = images(bytes, limits)?;
    let b = Bytes::little(bytes, FORMAT);
    let channels = images.into_iter().map(|image| {
        let Image { name, raster: (at, shape, sample), pixel, step } = image;
        let raster = Raster { bytes: b, at, shape, sample };
        Channel::raster(name, Some("m"), pixel, raster, move |raw| raw * step)
    });
    Ok(Contents { channels: channels.collect::<Result<_, _>>()?, metadata: metadata(b)? })
}

/// A height image: where it is and what it means.
struct Image {
    name: String,
    raster: (usize, [usize; 2], Sample),
    pixel: Pixel,
    /// Metres per stored number.
    step: f64,
}

fn images(bytes: &[u8], limits: &Limits) -> Result<Vec<Image>, ReadError> {
    let b = Bytes::little(bytes, FORMAT);
    if b.u32(8)? != 0 {
        return Err(b.fault(8, "4 zeros expected here"));
    }
    let conditions = b.from(b.u32(12)? as usize)?;
    let picometres = |at: usize| conditions.u32(at).map(|pm| f64::from(pm) * 1e-12);
    let pixel = Pixel::Metres([picometres(172)?, picometres(168)?]);
    let step = picometres(176)?;
    let mut images = Vec::new();
    for (number, place) in [36, 40, 44].into_iter().enumerate() {
        let at = b.u32(place)? as usize;
        if at == 0 {
            continue;
        }
        let image = b.from(at)?;
        let shape = [image.u32(4)? as usize, image.u32(0)? as usize];
        limits.check_points(FORMAT, shape)?;
        let sample = match image.u32(8)? {
            8 => Sample::U8,
            16 => Sample::U16,
            32 => Sample::U32,
            bits => return Err(b.fault(at + 8, format!("{bits} bits a point, not 8, 16 or 32"))),
        };
        let length = b.map_length(at + 796, shape, sample)?;
        if image.u32(16)? as usize != length {
            let what = format!("{} bytes for {} x {} points", image.u32(16)?, shape[0], shape[1]);
            return Err(b.fault(at + 16, what));
        }
        let name = if number == 0 { "Height".to_owned() } else { format!("Height {}", number + 1) };
        images.push(Image { name, raster: (at + 796, shape, sample), pixel, step });
    }
    if images.is_empty() {
        return Err(b.fault(36, "the file has no height image"));
    }
    Ok(images)
}

fn metadata(b: Bytes<'_>) -> Result<std::collections::BTreeMap<String, String>, ReadError> {
    let conditions = b.from(b.u32(12)? as usize)?;
    let mut date = [0; 6];
    for (i, part) in date.iter_mut().enumerate() {
        *part = conditions.u32(4 + 4 * i)?;
    }
    let [year, month, day, hour, minute, second] = date;
    let date = format!("{year}-{month:02}-{day:02} {hour:02}:{minute:02}:{second:02}");
    Ok([("date".to_owned(), date)].into())
}

#[cfg(feature = "zip")]
fn packed<'a>(bytes: &'a [u8], limits: &Limits) -> Result<Contents<'a>, ReadError> {
    use super::archive::Archive;
    let mut archive = Archive::open(bytes, FORMAT, limits)?;
    let inner = std::rc::Rc::new(archive.unpack("Vk4File", limits)?);
    let images = images(&inner, limits)?;
    let metadata = metadata(Bytes::little(&inner, FORMAT))?;
    let channels = images.into_iter().map(|image| {
        let inner = std::rc::Rc::clone(&inner);
        let Image { name, raster: (at, shape, sample), pixel, step } = image;
        Channel::new(name, Some("m"), shape, pixel, move || {
            let b = Bytes::little(&inner, FORMAT);
            let mut values = b.samples(at, shape[0] * shape[1], sample)?;
            values.iter_mut().for_each(|value| *value *= step);
            Ok(values)
        })
    });
    Ok(Contents { channels: channels.collect(), metadata })
}

#[cfg(not(feature = "zip"))]
fn packed<'a>(_: &'a [u8], _: &Limits) -> Result<Contents<'a>, ReadError> {
    let feature = "VK6 and VK7 without the feature `zip`".into();
    Err(ReadError::Unsupported { format: FORMAT, feature })
}
