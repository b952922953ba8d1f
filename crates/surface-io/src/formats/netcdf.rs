//! NetCDF classic: CDF-1, CDF-2 (64-bit offsets), CDF-5 (64-bit data). All numbers big endian.
//!
//! | part | content |
//! |---|---|
//! | start | `CDF`, u8 version 1, 2 or 5; number of records |
//! | dimensions | tag 10, count; each: name, length (0: record dimension) |
//! | attributes | tag 12, count; each: name, type, count, values |
//! | variables | tag 11, count; each: name, rank, dimension numbers, attributes, type, size, offset |
//! | name | length, bytes, padded to 4 |
//! | counts and lengths | u32, u64 in version 5; offsets u32 in version 1, else u64 |
//! | types | 1 i8, 2 text, 3 i16, 4 i32, 5 f32, 6 f64, 7 u8, 8 u16, 9 u32, 10 i64, 11 u64 |
//!
//! Every variable of two dimensions, and of others of length 1 before them, is a channel. A dimension
//! named `x` stored first is the slow one: the map is transposed so that rows run along x. Spacing: the
//! values of the coordinate variable, (last − first) / (N − 1); for a single point its attribute `length`.
//! Units: attribute `unit`, `units` or `length_unit`; `heights` without one have that of their
//! coordinates, as SurfaceTopography and contact.engineering write them. Missing points: NaN, the
//! marks of [`Packing`], and points where a variable `mask` on the same dimensions is not 0.
//!
//! GXSM: the channels are those along `dimy` and `dimx`, in steps of the number `dz`; it and the spacings `dy` and `dx`
//! are in ångström whatever unit they are shown in.
//!
//! In a file without them the variables of one dimension are profiles; positions are the variable
//! called like the dimension, or `x`.
//!
//! Sources: Unidata, *NetCDF classic format specification*,
//! <https://docs.unidata.ucar.edu/netcdf-c/current/file_format_specifications.html>; the files of
//! SurfaceTopography (an open reader and writer), files of GXSM. NetCDF-4 files are HDF5.

use super::npy::transpose;
use super::prelude::*;
use super::scattered::{Line, profile};
use crate::cells::Digits;
use crate::packed::Packing;

/// An attribute as text and, if it is numeric, its first numbers.
struct Attribute {
    text: String,
    numbers: Vec<f64>,
}

type Attributes = BTreeMap<String, Attribute>;

struct Variable {
    name: String,
    dimensions: Vec<usize>,
    attributes: Attributes,
    /// None of a text, which can be a coordinate all the same: it has a unit and a length.
    sample: Option<Sample>,
    at: usize,
}

impl Variable {
    fn unit(&self) -> Option<&str> {
        ["unit", "units", "length_unit"]
            .iter()
            .find_map(|key| self.attributes.get(*key))
            .map(|attribute| attribute.text.as_str())
    }

    /// Reads its values; NaN where one is missing.
    fn values<'a>(
        &self,
        b: Bytes<'a>,
        sample: Sample,
        count: usize,
    ) -> impl Fn() -> Result<Vec<f64>, ReadError> + use<'a> {
        let numbers = |key: &str| self.attributes.get(key).map(|a| &a.numbers[..]);
        let packing = Packing::of(|key| numbers(key).filter(|numbers| !numbers.is_empty()));
        let at = self.at;
        move || {
            let mut values = b.samples(at, count, sample)?;
            packing.unpack(&mut values);
            Ok(values)
        }
    }

    fn positions(&self, b: Bytes<'_>, sample: Sample, count: usize) -> Result<Line, ReadError> {
        let line = Line::new(&self.values(b, sample, count)()?, Digits::NONE);
        line.map_err(|what| b.field(format!("coordinate {}", self.name), what))
    }
}

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let b = Bytes { order: ByteOrder::Big, ..b };
    let mut header = HeaderCursor { file: Cursor { b, at: 4 }, version: b.u8(3)? };
    header.count()?; // number of records
    let mut dimensions = Vec::new();
    for _ in 0..header.list(10)? {
        dimensions.push((header.name()?, header.count()?));
    }
    let attributes = header.attributes()?;
    let mut variables = Vec::new();
    for _ in 0..header.list(11)? {
        let name = header.name()?;
        let rank = header.count()?;
        b.check_items(rank as u64)?;
        let of = (0..rank).map(|_| header.count()).collect::<Result<Vec<_>, _>>()?;
        if let Some(bad) = of.iter().find(|&&d| d >= dimensions.len()) {
            return Err(b.fault(header.file.at, format!("dimension {bad} of {}", dimensions.len())));
        }
        let attributes = header.attributes()?;
        let sample = sample(header.file.word()?);
        header.count()?; // size of the variable, which follows from its shape
        let at = header.size(header.version > 1)?;
        variables.push(Variable { name, dimensions: of, attributes, sample, at });
    }

    let metadata = attributes.into_iter().map(|(key, attribute)| (key, attribute.text)).collect();
    let mut contents = Contents { metadata, ..Contents::default() };
    let angstrom = |name: &str| {
        let is_in = |v: &Variable| v.attributes.get("var_unit").is_some_and(|a| a.text == "Ang");
        let one = variables.iter().find(|v| v.name == name && v.dimensions.is_empty() && is_in(v));
        let number = one.and_then(|v| Some((v.at, v.sample?)));
        number.map(|(at, sample)| Ok::<_, ReadError>(b.samples(at, 1, sample)?[0])).transpose()
    };
    let [dz, dy, dx] = [angstrom("dz")?, angstrom("dy")?, angstrom("dx")?];
    let in_metres = |number: Option<f64>| Some((number?, Some(1e-10)));
    let gxsm = dz.zip(in_metres(dy).zip(in_metres(dx)));
    let mask = variables.iter().find(|v| v.name == "mask" && v.sample == Some(Sample::I8));
    for variable in &variables {
        if mask.is_some_and(|mask| std::ptr::eq(mask, variable)) {
            continue;
        }
        let parts = variable.dimensions.split_last_chunk().zip(variable.sample);
        let Some(((before, &[slow, fast]), sample)) = parts else { continue };
        let axes = [&dimensions[slow], &dimensions[fast]];
        let stored = axes.map(|axis| axis.1);
        let is_other = gxsm.is_some() && axes.map(|axis| &axis.0[..]) != ["dimy", "dimx"];
        // Records are interleaved with those of other variables.
        if stored[0] == 0 || before.iter().any(|&d| dimensions[d].1 != 1) || is_other {
            continue;
        }
        b.raster(variable.at, stored, sample)?;
        let is_x_slow = axes[0].0 == "x";
        let [y, x] = if is_x_slow { [axes[1], axes[0]] } else { axes };
        let spacing = |axis: &(String, usize)| spacing(b, &variables, &axis.0, axis.1);
        let spacings = match gxsm {
            Some((_, spacings)) => Some(spacings),
            None => spacing(y)?.zip(spacing(x)?),
        };
        let pixel =
            spacings.map_or(Pixel::Unknown, |((dy, y), (dx, x))| Pixel::scaled([dy, dx], [y, x]));
        let along = variables.iter().find(|v| axes.iter().any(|(name, _)| v.name == *name));
        let unit = unit_of(variable, along);
        let is_length = |unit: &&str| *unit == "AA" || metres_per(unit).is_some();
        let unit = gxsm.and(unit.filter(is_length)).and(Some("\u{c5}")).or(unit);
        let shape = [y.1, x.1];
        let count = stored[0] * stored[1];
        let in_rows = move |v: Vec<f64>| if is_x_slow { transpose(&v, stored) } else { v };
        let values = variable.values(b, sample, count);
        let decode = move || values().map(in_rows);
        let mut channel = Channel::new(variable.name.clone(), unit, shape, pixel, decode);
        if let Some(mask) = mask.filter(|mask| mask.dimensions == variable.dimensions) {
            let at = mask.at;
            channel = channel.masked(move || b.samples(at, count, Sample::U8).map(in_rows));
        }
        if let Some((dz, _)) = gxsm {
            channel = channel.converted(move |z| z * dz);
        }
        contents.channels.push(channel);
    }
    if contents.channels.is_empty() {
        contents.channels = profiles(b, &dimensions, &variables)?;
    }
    Ok(contents)
}

/// The unit of a variable along the coordinates `along`.
fn unit_of<'v>(variable: &'v Variable, along: Option<&'v Variable>) -> Option<&'v str> {
    let is_silent = |v: &&Variable| v.name == "heights";
    variable.unit().or_else(|| Some(variable).filter(is_silent).and(along)?.unit())
}

/// The variables of one dimension that are no positions.
fn profiles<'a>(
    b: Bytes<'a>,
    dimensions: &[(String, usize)],
    variables: &[Variable],
) -> Result<Vec<Channel<'a>>, ReadError> {
    let mut found = Vec::new();
    let is_position = |v: &Variable, name: &str| v.name == name || v.name == "x";
    for variable in variables {
        let (&[dimension], Some(sample)) = (&variable.dimensions[..], variable.sample) else {
            continue;
        };
        let (name, count) = &dimensions[dimension];
        if *count < 2 || is_position(variable, name) {
            continue;
        }
        b.raster(variable.at, [1, *count], sample)?;
        let x = variables.iter().find(|v| v.dimensions == [dimension] && is_position(v, name));
        let line = match x.and_then(|x| Some((x, x.sample?))) {
            Some((x, sample)) => Some((x.positions(b, sample, *count)?, x.unit())),
            None => None,
        };
        let (unit, decode) = (unit_of(variable, x), variable.values(b, sample, *count));
        found.push(profile(&variable.name, unit, *count, line, decode));
    }
    Ok(found)
}

/// Distance of the points along a dimension and metres per unit, from its coordinate variable.
fn spacing(
    b: Bytes<'_>,
    variables: &[Variable],
    name: &str,
    count: usize,
) -> Result<Option<(f64, Option<f64>)>, ReadError> {
    let variable = variables.iter().find(|v| v.name == name && v.dimensions.len() == 1);
    let Some(variable) = variable else { return Ok(None) };
    let scale = variable.unit().and_then(metres_per);
    let (true, Some(sample)) = (count > 1, variable.sample) else {
        let length = variable.attributes.get("length").and_then(|a| a.numbers.first());
        return Ok(length.map(|length| (length / count as f64, scale)));
    };
    let line = variable.positions(b, sample, count)?;
    if line.uneven.is_some() {
        return Err(b.field(format!("coordinate {name}"), "the points are not evenly spaced"));
    }
    Ok(Some((line.step, scale)))
}

fn sample(code: usize) -> Option<Sample> {
    Sample::of_number(code, "- i1 - i2 i4 f4 f8 u1 u2 u4 i8 u8")
}

struct HeaderCursor<'a> {
    file: Cursor<'a>,
    version: u8,
}

impl<'a> HeaderCursor<'a> {
    fn size(&mut self, is_long: bool) -> Result<usize, ReadError> {
        if !is_long {
            return self.file.word();
        }
        let Cursor { b, at } = self.file;
        self.file.at += 8;
        let size = b.u64(at)?;
        usize::try_from(size).map_err(|_| b.fault(at, format!("a size of {size}")))
    }

    fn count(&mut self) -> Result<usize, ReadError> {
        self.size(self.version == 5)
    }

    fn list(&mut self, tag: usize) -> Result<usize, ReadError> {
        let Cursor { b, at } = self.file;
        let found = self.file.word()?;
        let count = self.count()?;
        if found != tag && (found != 0 || count != 0) {
            return Err(b.fault(at, format!("list tag {found}, expected {tag}")));
        }
        b.check_items(count as u64)?;
        Ok(count)
    }

    /// Bytes, padded to a multiple of 4.
    fn padded(&mut self, length: usize) -> Result<&'a [u8], ReadError> {
        let raw = self.file.b.slice(self.file.at, length)?;
        self.file.at += length.next_multiple_of(4);
        Ok(raw)
    }

    fn name(&mut self) -> Result<String, ReadError> {
        let length = self.count()?;
        Ok(text(self.padded(length)?))
    }

    fn attributes(&mut self) -> Result<Attributes, ReadError> {
        let mut attributes = Attributes::new();
        for _ in 0..self.list(12)? {
            let name = self.name()?;
            let Cursor { b, at } = self.file;
            let code = self.file.word()?;
            let count = self.count()?;
            let attribute = if let Some(sample) = sample(code) {
                let length = count.checked_mul(sample.size());
                let length = length.ok_or_else(|| b.fault(at, "an endless attribute"))?;
                let numbers = sample.decode(self.padded(length)?, b.order);
                let numbers: Vec<f64> = numbers.into_iter().take(8).collect();
                let shown: Vec<String> = numbers.iter().map(f64::to_string).collect();
                Attribute { text: shown.join(" "), numbers }
            } else if code == 2 {
                Attribute { text: text(self.padded(count)?), numbers: Vec::new() }
            } else {
                return Err(b.fault(at, format!("an attribute of unknown type {code}")));
            };
            attributes.insert(name, attribute);
        }
        Ok(attributes)
    }
}
