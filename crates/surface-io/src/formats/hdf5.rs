//! HDF5: every data set of two axes (others of length 1 beside them) is a channel, called by its
//! path. NetCDF-4, MATLAB 7.3 and Zygo's DATX are HDF5 with conventions of their own.
//!
//! | attribute of a data set | content |
//! |---|---|
//! | `unit`, `units`, `Unit`, `Units` | unit of the numbers |
//! | `scale_factor`, `add_offset`, marks of missing points | as [`Packing`] has them; NaN is missing anyway |
//! | `MATLAB_class` | MATLAB 7.3 stores by columns: the map is transposed |
//! | `pixel`, `pixel_unit` | [dy, dx] and its unit, as [`write::hdf5`](crate::write::hdf5) writes them |
//! | `X Converter`, `Y Converter` | DATX: a compound of category, base unit and parameters, of which the second is the pixel size in metres |
//!
//! A data set without them has neither unit nor pixel size, as an array has. Chunks that were
//! never written are missing points. In a file without maps the data sets of one axis are profiles;
//! a data set `x` beside them has the positions.
//!
//! Sources: The HDF Group, *HDF5 File Format Specification*; for DATX SurfaceTopography and prysm (both
//! open readers). DATX was not checked against a real file.

use super::npy::transpose;
use super::prelude::*;
use super::scattered::{Line, profile};
use crate::cells::Digits;
use crate::hdf5::{self, AttributeValue, Dataset};
use crate::packed::Packing;

/// Attributes that are understood, and have a number or a unit.
const USED: [&str; 8] =
    ["unit", "units", "Unit", "Units", "pixel", "pixel_unit", "scale_factor", "add_offset"];

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let file = hdf5::File::open(b)?;
    let (paths, fault) = hdf5::datasets(&file)?;
    let mut contents = Contents::default();
    let mut lines = Vec::new();
    for (path, at) in paths {
        match Dataset::at(&file, at) {
            // Its stored numbers are counts, whatever unit they claim.
            Ok(Some(set)) if set.attributes.iter().any(|(name, _)| name.starts_with("jpkspm")) => {
                let way_out = "export the image in JPK's program as JPK or TIFF, or as text";
                return Err(b.unsupported(format!("a scan of JPK in HDF5 ({way_out})")));
            }
            Ok(Some(dataset)) => match sides(&dataset)[..] {
                [_, _] => {
                    let attributes = dataset.attributes.iter();
                    for (name, value) in attributes.filter(|(name, _)| !USED.contains(&&name[..])) {
                        let shown = match value {
                            AttributeValue::Text(text) => text.clone(),
                            AttributeValue::Numbers(numbers) if numbers.len() <= 3 => {
                                numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(" ")
                            }
                            _ => continue,
                        };
                        contents.not_used(&format!("{path}/{name}"), &shown);
                    }
                    contents.channels.push(channel(b, path, dataset)?);
                }
                [_] => lines.push((path, dataset)),
                // A single number beside the maps, as MATLAB saves a variable.
                [] if !dataset.shape.contains(&0) => {
                    if let Some(number) = dataset.values().ok().and_then(|v| v.first().copied()) {
                        contents.not_used(&path, &number.to_string());
                    }
                }
                _ => {}
            },
            Ok(None) => {} // texts and compounds
            Err(fault) => contents.add(&path, Err(fault)),
        }
    }
    if contents.channels.is_empty() {
        contents.channels = profiles(b, lines)?;
    }
    match fault {
        Some(fault) if contents.channels.is_empty() => Err(fault),
        _ => Ok(contents),
    }
}

fn channel<'a>(b: Bytes<'_>, path: String, dataset: Dataset<'a>) -> Result<Channel<'a>, ReadError> {
    let sides = sides(&dataset);
    let stored = [sides[0], sides[1]];
    b.check_points(stored)?;
    let is_by_columns = dataset.attribute(&["MATLAB_class"]).is_some();
    let shape = if is_by_columns { [stored[1], stored[0]] } else { stored };
    let pixel = match (pixel(&dataset, "Y Converter"), pixel(&dataset, "X Converter")) {
        (Some(dy), Some(dx)) => Pixel::Metres([dy, dx]),
        _ => written_pixel(&dataset).map_or(Pixel::Unknown, Pixel::Metres),
    };
    let unit = unit(&dataset).map(str::to_owned);
    Ok(Channel::new(path, unit.as_deref(), shape, pixel, move || {
        let values = values(&dataset)?;
        Ok(if is_by_columns { transpose(&values, stored) } else { values })
    }))
}

/// Sizes of the axes of more than one point; none of a data set without points.
fn sides(dataset: &Dataset<'_>) -> Vec<usize> {
    if dataset.shape.contains(&0) {
        return Vec::new();
    }
    dataset.shape.iter().copied().filter(|&side| side != 1).collect()
}

fn unit<'d>(dataset: &'d Dataset<'_>) -> Option<&'d str> {
    dataset.attribute(&["unit", "units", "Unit", "Units"])?.text()
}

/// The numbers of a data set, unpacked.
fn values(dataset: &Dataset<'_>) -> Result<Vec<f64>, ReadError> {
    let packing = Packing::of(|key| dataset.attribute(&[key])?.numbers());
    let mut values = dataset.values()?;
    packing.unpack(&mut values);
    Ok(values)
}

/// Data sets of one axis, and their positions if a data set `x` of as many points is beside them.
fn profiles<'a>(
    b: Bytes<'_>,
    lines: Vec<(String, Dataset<'a>)>,
) -> Result<Vec<Channel<'a>>, ReadError> {
    let is_x = |path: &str| path == "x" || path.ends_with("/x");
    let (positions, lines): (Vec<_>, Vec<_>) = lines.into_iter().partition(|(path, _)| is_x(path));
    let mut found = Vec::new();
    for (path, dataset) in lines {
        let count = sides(&dataset)[0];
        b.check_points([1, count])?;
        let beside = format!("{}x", &path[..path.rfind('/').map_or(0, |at| at + 1)]);
        let x = positions.iter().find(|(name, x)| *name == beside && sides(x) == [count]);
        let line = x.map(|(name, x)| {
            let line = Line::new(&values(x)?, Digits::NONE);
            Ok::<_, ReadError>((line.map_err(|what| b.field(name.clone(), what))?, unit(x)))
        });
        let line = line.transpose()?;
        let unit = unit(&dataset).map(str::to_owned);
        let decode = move || values(&dataset);
        found.push(profile(path, unit.as_deref(), count, line, decode));
    }
    Ok(found)
}

/// `[dy, dx]` (m), as this crate writes it.
fn written_pixel(dataset: &Dataset<'_>) -> Option<[f64; 2]> {
    let sides = dataset.attribute(&["pixel"])?.numbers()?.try_into().ok();
    sides.filter(|_| dataset.attribute(&["pixel_unit"]).and_then(AttributeValue::text) == Some("m"))
}

/// Metres per point of a converter in points.
fn pixel(dataset: &Dataset<'_>, name: &str) -> Option<f64> {
    let AttributeValue::Members(members) = dataset.attribute(&[name])? else { return None };
    let mut texts = members.iter().filter_map(AttributeValue::text);
    let is_lateral = texts.any(|text| matches!(text, "LateralCat" | "Pixels"));
    members.iter().find_map(AttributeValue::numbers).filter(|_| is_lateral)?.get(1).copied()
}
