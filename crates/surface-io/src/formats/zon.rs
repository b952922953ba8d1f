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

use super::archive::Archive;
use crate::binary::{Bytes, Sample};
use crate::entries::Entries;
use crate::measurement::{Channel, Contents, Pixel};
use crate::{Format, Limits, ReadError, xml};
use std::collections::BTreeMap;

const FORMAT: Format = Format::Zon;
const HEIGHTS: &str = "4cdb0c75-5706-48cc-a9a1-adf395d609ae";
const MASK: &str = "9e7ca6dd-0e6a-4d7b-8986-f0a7b773c916";
const CALIBRATION: &str = "686613b8-27b5-4a29-8ffc-438c2780873e";
const ABOUT: [&str; 2] =
    ["1d35862b-3b48-4df2-9235-833ef590b043", "cbc1d39b-215f-4d56-a20e-cf8e5f570755"];

pub(crate) fn sniff(bytes: &[u8]) -> bool {
    bytes.starts_with(b"KPK0") || bytes.starts_with(b"KPK1")
}

pub(crate) fn parse<'a>(bytes: &'a [u8], limits: &Limits) -> Result<Contents<'a>, ReadError> {
    let mut archive = Archive::open(bytes, FORMAT, limits)?;
    let calibration = member(&mut archive, CALIBRATION, limits)?;
    let fields = xml::fields(&calibration, FORMAT, "calibration", limits)?;
    let entries = Entries::new(FORMAT, &fields, "is missing");
    let pixel = Pixel::Metres([entries.number("XYCalibration/MeterPerPixel")?; 2]);
    let step = entries.number("ZCalibration/MeterPerUnit")?;
    let heights = Matrix::new(member(&mut archive, HEIGHTS, limits)?, 4, HEIGHTS, limits)?;
    let shape = heights.shape;
    let decode = move || heights.values(Sample::I32);
    let mut channel = Channel::new("Height", Some("m"), shape, pixel, decode);
    channel = channel.converted(move |raw| raw * step);
    if archive.names.iter().any(|name| name == MASK) {
        let mask = Matrix::new(member(&mut archive, MASK, limits)?, 1, MASK, limits)?;
        if mask.shape != shape {
            let [ny, nx] = mask.shape;
            return Err(FORMAT.field(MASK, format!("a mask of {ny} x {nx} points")));
        }
        channel = channel.masked(move || mask.values(Sample::U8));
    }
    let mut metadata = BTreeMap::new();
    for name in ABOUT {
        if let Ok(xml) = member(&mut archive, name, limits)
            && let Ok(fields) = xml::fields(&xml, FORMAT, name, limits)
        {
            metadata.extend(fields);
        }
    }
    Ok(Contents { channels: vec![channel], metadata })
}

/// A member of the archive, unpacked once more if it is packed with zstd.
fn member(
    archive: &mut Archive<'_>,
    name: &'static str,
    limits: &Limits,
) -> Result<Vec<u8>, ReadError> {
    let raw = archive.unpack(name, limits)?;
    if !raw.starts_with(b"\x28\xb5\x2f\xfd") {
        return Ok(raw);
    }
    let most = usize::try_from(limits.unpacked_bytes).unwrap_or(usize::MAX).saturating_add(1);
    let unpacked = crate::unpack::zstd(&raw, most).map_err(|what| FORMAT.field(name, what))?;
    limits.check_unpacked(FORMAT, unpacked.len() as u64)?;
    Ok(unpacked)
}

/// Rows of numbers behind a header of 16 bytes.
struct Matrix {
    raw: Vec<u8>,
    shape: [usize; 2],
    row_bytes: usize,
}

impl Matrix {
    fn new(
        raw: Vec<u8>,
        size: u32,
        name: &'static str,
        limits: &Limits,
    ) -> Result<Self, ReadError> {
        let b = Bytes::little(&raw, FORMAT);
        let shape = [b.u32(4)? as usize, b.u32(0)? as usize];
        limits.check_points(FORMAT, shape)?;
        let row_bytes = b.u32(12)? as usize;
        if b.u32(8)? != size || row_bytes < shape[1] * size as usize {
            let what = format!("{} bytes a point in rows of {row_bytes} bytes", b.u32(8)?);
            return Err(b.field(name, what));
        }
        b.slice(16, row_bytes.saturating_mul(shape[0]))?;
        Ok(Self { raw, shape, row_bytes })
    }

    fn values(&self, sample: Sample) -> Result<Vec<f64>, ReadError> {
        Bytes::little(&self.raw, FORMAT).rows(16, self.shape, self.row_bytes, sample)
    }
}
