//! HDF5: every data set of two axes (others of length 1 beside them) is a channel, called by its
//! path. NetCDF-4, MATLAB 7.3 and Zygo's DATX are HDF5 with conventions of their own.
//!
//! | attribute of a data set | content |
//! |---|---|
//! | `unit`, `units`, `Unit`, `Units` | unit of the numbers |
//! | `No Data`, `_FillValue`, `missing_value` | the number that marks a missing point; NaN does anyway |
//! | `pixel`, `pixel_unit` | [dy, dx] and its unit, as [`write::hdf5`](crate::write::hdf5) writes them |
//! | `X Converter`, `Y Converter` | DATX: a compound of category, base unit and parameters, of which the second is the pixel size in metres |
//!
//! A data set without them has neither unit nor pixel size, as an array has. Chunks that were
//! never written are missing points.
//!
//! Sources: The HDF Group, *HDF5 File Format Specification*; for DATX SurfaceTopography and prysm (both
//! open readers). DATX was not checked against a real file.

use crate::binary::{Bytes, find};
use crate::hdf5::{self, Dataset, Value};
use crate::measurement::{Channel, Contents, Pixel};
use crate::{Format, Limits, ReadError};

pub(crate) fn sniff(bytes: &[u8]) -> bool {
    [0, 512, 1024, 2048]
        .iter()
        .any(|&at| bytes.get(at..).is_some_and(|rest| rest.starts_with(hdf5::MAGIC)))
}

pub(crate) fn parse<'a>(bytes: &'a [u8], limits: &Limits) -> Result<Contents<'a>, ReadError> {
    parse_as(bytes, Format::Hdf5, limits)
}

/// DATX is HDF5 whose data sets say how to convert their axes.
pub(crate) fn is_datx(bytes: &[u8]) -> bool {
    sniff(bytes) && find(bytes, b"X Converter").is_some()
}

/// The data sets under the name of one of the formats.
pub(crate) fn parse_as<'a>(
    bytes: &'a [u8],
    format: Format,
    limits: &Limits,
) -> Result<Contents<'a>, ReadError> {
    let file = hdf5::File::open(bytes, format, limits)?;
    let listing = hdf5::datasets(&file)?;
    let mut contents = Contents::default();
    for (path, at) in listing.datasets {
        match Dataset::at(&file, at) {
            Ok(Some(dataset)) => contents.channels.extend(channel(path, dataset, format, limits)?),
            Ok(None) => {} // texts and compounds
            Err(fault) => contents.channels.push(Channel::unreadable(path, fault)),
        }
    }
    match listing.fault {
        Some(fault) if contents.channels.is_empty() => Err(fault),
        _ => Ok(contents),
    }
}

fn channel<'a>(
    path: String,
    dataset: Dataset<'a>,
    format: Format,
    limits: &Limits,
) -> Result<Option<Channel<'a>>, ReadError> {
    let sides: Vec<u64> = dataset.shape.iter().copied().filter(|&side| side != 1).collect();
    let [ny, nx] = sides[..] else { return Ok(None) };
    if ny == 0 || nx == 0 {
        return Ok(None);
    }
    let side = |n: u64| usize::try_from(n).unwrap_or(usize::MAX);
    let shape = [side(ny), side(nx)];
    limits.check_points(format, shape)?;
    let unit = match dataset.attribute(&["unit", "units", "Unit", "Units"]) {
        Some(Value::Text(text)) => Some(text.clone()),
        _ => None,
    };
    let pixel = match (pixel(&dataset, "Y Converter"), pixel(&dataset, "X Converter")) {
        (Some(dy), Some(dx)) => Pixel::Metres([dy, dx]),
        _ => written_pixel(&dataset).map_or(Pixel::Unknown, Pixel::Metres),
    };
    let missing = match dataset.attribute(&["No Data", "_FillValue", "missing_value"]) {
        Some(Value::Numbers(numbers)) => numbers.first().copied(),
        _ => None,
    };
    Ok(Some(Channel::new(path, unit.as_deref(), shape, pixel, move || {
        let mut values = dataset.values()?;
        if let Some(missing) = missing {
            for value in &mut values {
                if value.to_bits() == missing.to_bits() {
                    *value = f64::NAN;
                }
            }
        }
        if values.len() != shape[0] * shape[1] {
            return Err(Bytes::little(&[], format).field("data", "of another size"));
        }
        Ok(values)
    })))
}

/// `[dy, dx]` (m), as this crate writes it.
fn written_pixel(dataset: &Dataset<'_>) -> Option<[f64; 2]> {
    let (Some(Value::Numbers(sides)), Some(Value::Text(unit))) =
        (dataset.attribute(&["pixel"]), dataset.attribute(&["pixel_unit"]))
    else {
        return None;
    };
    let &[dy, dx] = &sides[..] else { return None };
    (unit == "m").then_some([dy, dx])
}

/// Metres per point of a converter in points.
fn pixel(dataset: &Dataset<'_>, name: &str) -> Option<f64> {
    let Some(Value::Members(members)) = dataset.attribute(&[name]) else { return None };
    let texts: Vec<&str> = members
        .iter()
        .filter_map(|(_, value)| match value {
            Value::Text(text) => Some(text.as_str()),
            _ => None,
        })
        .collect();
    let numbers = members.iter().find_map(|(_, value)| match value {
        Value::Numbers(numbers) => Some(numbers),
        _ => None,
    });
    let is_lateral = texts.contains(&"LateralCat") || texts.contains(&"Pixels");
    numbers.filter(|_| is_lateral)?.get(1).copied()
}
