//! ZON of Keyence profilers (VR series): a preview picture, then a ZIP archive.
//!
//! | byte | type | content |
//! |---|---|---|
//! | 0 | 4 | `KPK0`; `KPK1` if members are packed with zstd |
//! | 4 | u32 | length of the preview picture, which follows |
//! | | | a ZIP archive, members named by UUID |
//!
//! | member | content |
//! |---|---|
//! | `4cdb0c75-…` | heights: u32 points along x, points along y, bytes per point (4), bytes per row; i32 in rows |
//! | `9e7ca6dd-…` | mask with the same header, 1 byte a point: 0 is measured, anything else a missing point |
//! | `686613b8-…` | XML: `XYCalibration/MeterPerPixel`, `ZCalibration/MeterPerUnit` |
//! | `1d35862b-…`, `cbc1d39b-…` | XML: `ScanDateTime`, `DeviceModelName` |
//!
//! All numbers little endian. Height = stored number × `MeterPerUnit`. The calibration of the user
//! (`7d5ea102-…`) is not applied: it is part of `MeterPerPixel` or it is not, no description says.
//!
//! Sources: SurfaceTopography, surfalize (both open readers); a file of a VR-6100.

use super::prelude::*;

const HEIGHTS: &str = "4cdb0c75-5706-48cc-a9a1-adf395d609ae";
const MASK: &str = "9e7ca6dd-0e6a-4d7b-8986-f0a7b773c916";
const CALIBRATION: &str = "686613b8-27b5-4a29-8ffc-438c2780873e";
const ABOUT: [&str; 2] =
    ["1d35862b-3b48-4df2-9235-833ef590b043", "cbc1d39b-215f-4d56-a20e-cf8e5f570755"];

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let mut archive = Archive::open(b)?;
    let calibration = member(&mut archive, CALIBRATION)?;
    let fields = xml::fields(b.with(&calibration), "calibration")?;
    let entries = Entries::new(b, &fields);
    let pixel = Pixel::Metres([entries.number("XYCalibration/MeterPerPixel")?; 2]);
    let step = entries.number("ZCalibration/MeterPerUnit")?;
    let heights = member(&mut archive, HEIGHTS)?;
    let (shape, heights) = matrix(b.with(&heights), Sample::I32, HEIGHTS)?;
    let mut channel = Channel::new("Height", Some("m"), shape, pixel, || Ok(heights));
    channel = channel.converted(move |raw| raw * step);
    if archive.names.iter().any(|name| name == MASK) {
        let mask = member(&mut archive, MASK)?;
        let ([ny, nx], marks) = matrix(b.with(&mask), Sample::U8, MASK)?;
        if [ny, nx] != shape {
            return Err(b.field(MASK, format!("a mask of {ny} x {nx} points")));
        }
        channel = channel.masked(|| Ok(marks));
    }
    let mut metadata = BTreeMap::new();
    for name in ABOUT {
        if let Ok(xml) = member(&mut archive, name)
            && let Ok(fields) = xml::fields(b.with(&xml), name)
        {
            metadata.extend(fields);
        }
    }
    Ok(Contents { channels: vec![channel], metadata })
}

/// A member of the archive, unpacked once more if it is packed with zstd.
fn member(archive: &mut Archive<'_>, name: &'static str) -> Result<Vec<u8>, ReadError> {
    let b = archive.b;
    let raw = archive.unpack(name)?;
    if !raw.starts_with(b"\x28\xb5\x2f\xfd") {
        return Ok(raw);
    }
    let most = b.options.limits.unpacked_bytes.saturating_add(1);
    let unpacked = crate::unpack::zstd(&raw, most).map_err(|what| b.field(name, what))?;
    b.options.limits.check_unpacked(b.format, unpacked.len() as u64)?;
    Ok(unpacked)
}

/// Rows of numbers behind a header of 16 bytes, and how many.
fn matrix(
    m: Bytes<'_>,
    sample: Sample,
    name: &'static str,
) -> Result<([usize; 2], Vec<f64>), ReadError> {
    let shape = [m.u32(4)? as usize, m.u32(0)? as usize];
    m.check_points(shape)?;
    let (size, row_bytes) = (m.u32(8)? as usize, m.u32(12)? as usize);
    if size != sample.size() || row_bytes < shape[1] * size {
        let what = format!("{size} bytes a point in rows of {row_bytes} bytes");
        return Err(m.field(name, what));
    }
    m.slice(16, row_bytes.saturating_mul(shape[0]))?;
    Ok((shape, m.rows(16, shape, row_bytes, sample)?))
}
