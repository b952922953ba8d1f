//! AL3D of Alicona (Bruker) InfiniteFocus. Header as text, data little endian.
//!
//! | byte | type | content |
//! |---|---|---|
//! | 0 | 17 | `AliconaImaging`, NUL, CR LF |
//! | 17 | 52 each | tags: key (20), value (30), CR LF; first `Version`, then `TagCount`, then that many |
//!
//! | tag | content |
//! |---|---|
//! | `Cols`, `Rows` | points along x, along y |
//! | `PixelSizeXMeter`, `PixelSizeYMeter` | spacing in metres |
//! | `DepthImageOffset` | where the heights (f32, metres) start |
//! | `TextureImageOffset` | where the image starts, 0 if there is none |
//! | `InvalidPixelValue` | a missing point |
//!
//! Rows are packed, or padded to 8 bytes or to 8 points: whatever fills the space to the image or
//! to the end of the file exactly; 8 bytes if nothing does. NaN is a missing point as well.
//!
//! Source: Alicona, *Description of the AL3D file format*; the files.

use super::prelude::*;

pub(crate) const MAGIC: &[u8] = b"AliconaImaging\0\r\n";
const TAG: usize = 52;

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let tag = |index: usize| {
        let raw = b.slice(MAGIC.len() + TAG * index, TAG)?;
        if &raw[50..] != b"\r\n" {
            return Err(b.fault(MAGIC.len() + TAG * index + 50, "a tag does not end with CR LF"));
        }
        Ok((text(&raw[..20]), text(&raw[20..50])))
    };
    let (key, count) = tag(1)?;
    let count = match count.parse::<usize>() {
        Ok(count) if key == "TagCount" => count,
        _ => return Err(b.field("TagCount", format!("{count:?} is no whole number"))),
    };
    b.check_items(count as u64)?;
    let metadata: BTreeMap<String, String> =
        (2..2 + count).map(tag).collect::<Result<_, ReadError>>()?;
    let tags = Entries::new(b, &metadata);
    let whole = |key: &'static str| match tags.number(key)? {
        n if (0.0..1e15).contains(&n) && n.fract() == 0.0 => Ok(n as usize),
        n => Err(b.field(key, format!("{n} is no whole number"))),
    };
    let (ny, nx, at) = (whole("Rows")?, whole("Cols")?, whole("DepthImageOffset")?);
    b.raster(at, [ny, nx], Sample::F32)?;
    let end = whole("TextureImageOffset").ok().filter(|&texture| texture > at);
    let space = end.unwrap_or(b.data.len()).saturating_sub(at);
    // Packed, padded to 8 bytes, or padded to 8 points: what fills the space exactly.
    let paddings = [4 * nx, (4 * nx).next_multiple_of(8), (4 * nx).next_multiple_of(32)];
    let fitting = paddings.into_iter().find(|stride| stride.checked_mul(ny) == Some(space));
    let stride = fitting.unwrap_or(paddings[1]);
    b.map_length(at, [ny, stride], Sample::U8)?;

    let pixel = Pixel::Metres([tags.number("PixelSizeYMeter")?, tags.number("PixelSizeXMeter")?]);
    // Printed with about 11 digits, stored as f32.
    let invalid = tags.number("InvalidPixelValue").ok();
    let convert = move |z: f64| match invalid {
        Some(invalid) if (z - invalid).abs() <= 1.5e-7 * invalid.abs() => f64::NAN,
        _ => z,
    };
    let decode = move || b.rows(at, [ny, nx], stride, Sample::F32);
    let channel = Channel::new("Depth", Some("m"), [ny, nx], pixel, decode).converted(convert);
    Ok(Contents { channels: vec![channel], metadata })
}
