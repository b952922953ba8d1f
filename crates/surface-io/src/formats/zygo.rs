//! Zygo MetroPro DAT. All numbers big endian.
//!
//! | byte | type | field |
//! |---|---|---|
//! | 0 | u32 | 0x881B036F (header 834 bytes), 0x881B0370 (834), 0x881B0371 (4096) |
//! | 6 | u32 | size of the header |
//! | 12 | 30 | date of the software |
//! | 48–56 | i16 i16 u16 u16 u16 | intensity: origin x, y; width, height, number of images |
//! | 60 | u32 | bytes of intensity data (u16), which come first |
//! | 64–70 | i16 i16 u16 u16 | phase: origin x, y; width, height |
//! | 72 | u32 | bytes of phase data (i32), which follow |
//! | 76, 80 | i32, 82 | time stamp, comment |
//! | 164, 168, 176 | f32 | interferometric scale factor S, wavelength W (m), obliquity factor O |
//! | 184 | f32 | lateral resolution (m per point, both directions; 0 if unknown) |
//! | 218 | i16 | phase resolution: R = 4096, 32768 or 131072 for 0, 1, 2 |
//! | 246, 258 | 12, 40 | objective, part name |
//!
//! Height = phase × S W O / R; a phase of 2147483640 or more is a missing point.
//!
//! Exports as text have [a reader of their own](super::zygo_text).
//!
//! Source: Zygo, *MetroPro Reference Guide* OMP-0347, appendix on the data format.

use super::prelude::*;
use super::zygo_text;

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    if zygo_text::sniff(b.data) {
        return zygo_text::parse(b);
    }
    let b = Bytes { order: ByteOrder::Big, ..b };
    let header = b.u32(6)? as usize;
    if !matches!(header, 834 | 4096) {
        return Err(b.fault(6, format!("a header of {header} bytes, not 834 or 4096")));
    }
    let shape = [b.u16(70)?.into(), b.u16(68)?.into()];
    let resolution = match b.i16(218)? {
        0 => 4096.0,
        1 => 32768.0,
        2 => 131072.0,
        code => return Err(b.fault(218, format!("phase resolution {code}, known are 0, 1, 2"))),
    };
    let [scale, wavelength, obliquity] = [b.f32(164)?, b.f32(168)?, b.f32(176)?].map(f64::from);
    let lateral = f64::from(b.f32(184)?);
    let pixel = if lateral == 0.0 { Pixel::Unknown } else { Pixel::Metres([lateral; 2]) };

    let intensity_bytes = b.u32(60)? as usize;
    let raster = b.raster(header + intensity_bytes, shape, Sample::I32)?;
    let step = scale * wavelength * obliquity / resolution;
    let convert = move |raw| if raw >= 2147483640.0 { f64::NAN } else { raw * step };
    let mut channels = vec![Channel::raster("Height", "m", pixel, raster, convert)];

    let shape = [b.u16(54)?.into(), b.u16(52)?.into()];
    let images = usize::from(b.u16(56)?);
    let bytes = 2 * shape[0] * shape[1];
    for image in (0..images).take_while(|image| bytes > 0 && (image + 1) * bytes <= intensity_bytes)
    {
        b.check_items(image as u64)?;
        let name = format!("Intensity {}", image + 1);
        // The heights are there, whatever the size of a picture beside them.
        if let Ok(raster) = b.raster(header + image * bytes, shape, Sample::U16) {
            channels.push(Channel::raster(name, "counts", pixel, raster, |raw| raw));
        }
    }
    let mut contents = Contents { channels, ..Contents::default() };
    contents.note([
        ("software date", b.text(12, 30)?),
        ("comment", b.text(80, 82)?),
        ("objective", b.text(246, 12)?),
        ("part", b.text(258, 40)?),
        ("time stamp", format!("{} s since 1970-01-01", b.i32(76)?)),
        ("wavelength", format!("{wavelength:e} m")),
    ]);
    Ok(contents)
}
