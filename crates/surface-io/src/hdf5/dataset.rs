//! A data set: what it is, and its numbers, in one piece or in chunks that a chain of filters packs.

use super::file::{File, LAYOUT, Message, WAY_OUT, points};
use super::types::{AttributeValue, Type, read_attribute, read_shape, read_type};
use crate::binary::{ByteOrder, Bytes, Sample};
use crate::error::ReadError;
use crate::unpack::zlib;
use std::borrow::Cow;

pub(crate) struct Dataset<'a> {
    file: File<'a>,
    /// Sizes of the axes, the slowest first.
    pub(crate) shape: Vec<usize>,
    sample: Sample,
    order: ByteOrder,
    layout: Storage,
    pub(crate) attributes: Vec<(String, AttributeValue)>,
}

enum Storage {
    /// One after the other from this byte.
    Contiguous(usize),
    /// Chunks of so many points along every axis.
    Chunks(Vec<usize>, Vec<Filter>, Index),
    /// Never written.
    Empty,
}

/// One filter of the chain.
struct Filter {
    id: u16,
    /// First number of its settings: of shuffle, the bytes of an element.
    setting: usize,
}

/// Where the chunks of a data set are.
enum Index {
    /// In a B-tree at this address.
    Tree(usize),
    /// There is one, at this address; with filters, its packed size and the filters left out.
    Only(usize, Option<(usize, u32)>),
}

impl<'a> Dataset<'a> {
    /// The data set whose header is at `at`; `None` if it does not hold numbers.
    pub(crate) fn at(file: &File<'a>, at: usize) -> Result<Option<Self>, ReadError> {
        let messages = file.messages(at)?;
        let find = |kind: u16| messages.iter().copied().find(|message| message.kind == kind);
        let missing = |what: &'static str| file.b.fault(at, format!("a data set without {what}"));
        let kind = find(0x03).ok_or_else(|| missing("type"))?;
        let (Type::Number(sample, order), _) = read_type(file, kind.at, 0)? else {
            return Ok(None);
        };
        let shape = find(0x01).ok_or_else(|| missing("dataspace"))?;
        let shape = read_shape(file, shape.at)?;
        let mut attributes = Vec::new();
        for message in messages.iter().filter(|message| message.kind == 0x0c) {
            attributes.extend(read_attribute(file, message.at)?);
        }
        let filters =
            find(0x0b).map_or(Ok(Vec::new()), |message| read_filters(file, message.at))?;
        let layout = find(LAYOUT).ok_or_else(|| missing("layout"))?;
        let layout = read_layout(file, layout, shape.len(), filters)?;
        Ok(Some(Self { file: *file, shape, sample, order, layout, attributes }))
    }

    /// The value of an attribute, by one of its names.
    pub(crate) fn attribute(&self, names: &[&str]) -> Option<&AttributeValue> {
        let found = self.attributes.iter().find(|(name, _)| names.contains(&name.as_str()));
        found.map(|(_, value)| value)
    }

    /// All numbers, the last axis fastest; NaN where nothing was ever written.
    pub(crate) fn values(&self) -> Result<Vec<f64>, ReadError> {
        let points = points(&self.shape);
        let b = Bytes { order: self.order, ..self.file.b };
        b.check_points([points, 1])?;
        match &self.layout {
            Storage::Contiguous(at) => b.samples(*at, points, self.sample),
            Storage::Chunks(sides, filters, index) => self.chunks(sides, filters, index, points),
            Storage::Empty => Err(b.field("data", "the data set was never written")),
        }
    }

    fn chunks(
        &self,
        sides: &[usize],
        filters: &[Filter],
        index: &Index,
        points: usize,
    ) -> Result<Vec<f64>, ReadError> {
        let (file, b, shape) = (self.file, self.file.b, &self.shape);
        // Each place once: a tree that names a chunk again and again is refused, not unpacked.
        let chunk: usize = sides.iter().product();
        let chunk_bytes = chunk * self.sample.size();
        let across = shape.iter().zip(sides).map(|(axis, side)| axis.div_ceil(*side));
        let needed = across.fold(1, usize::saturating_mul);
        let work = needed.saturating_mul(chunk) / 4; // chunks stick out beyond the edges
        b.check_points([work, 1])?;
        let mut values = vec![f64::NAN; points];
        let mut place = |at: usize, (size, skip): (usize, u32), origin: &[usize]| {
            let mut data = Cow::Borrowed(b.slice(at, size)?);
            for (i, filter) in filters.iter().enumerate().rev() {
                if skip >> i & 1 == 0 {
                    let unpacked = unpack(filter, &data, chunk_bytes);
                    data = Cow::Owned(unpacked.map_err(|what| b.fault(at, what))?);
                }
            }
            let numbers = self.sample.decode(&data, self.order);
            if numbers.len() < chunk {
                let what = format!("a chunk of {} numbers, {chunk} are needed", numbers.len());
                return Err(b.fault(at, what));
            }
            copy_inside(&numbers, sides, origin, &mut values, shape);
            Ok(())
        };
        let mut nodes = match *index {
            Index::Tree(at) => vec![at],
            Index::Only(at, packed) => {
                place(at, packed.unwrap_or((chunk_bytes, 0)), &vec![0; shape.len()])?;
                Vec::new()
            }
        };
        let (mut chunks, mut read) = (0, 0);
        while let Some(node) = nodes.pop() {
            read += 1;
            b.check_items(read)?;
            if b.slice(node, 4)? != b"TREE" || b.u8(node + 4)? != 1 {
                return Err(b.fault(node, "a B-tree of chunks is expected here"));
            }
            let level = b.u8(node + 5)?;
            let key = 8 + 8 * (shape.len() + 1);
            let mut at = node + 8 + 2 * file.address_size;
            for _ in 0..b.u16(node + 6)? {
                let Some(child) = file.address(at + key)? else {
                    return Err(b.fault(at + key, "a chunk without address"));
                };
                if level > 0 {
                    nodes.push(child);
                    b.check_items(nodes.len() as u64)?;
                } else {
                    chunks += 1;
                    if chunks > needed {
                        return Err(b.fault(at, format!("more than the {needed} chunks")));
                    }
                    let packed = (b.u32(at)? as usize, b.u32(at + 4)?);
                    let origin: Result<Vec<usize>, ReadError> =
                        (0..shape.len()).map(|i| file.unsigned(at + 8 + 8 * i, 8)).collect();
                    place(child, packed, &origin?)?;
                }
                at += key + file.address_size;
            }
        }
        Ok(values)
    }
}

/// Writes the numbers of a chunk that lie inside the data set.
fn copy_inside(
    numbers: &[f64],
    sides: &[usize],
    origin: &[usize],
    values: &mut [f64],
    shape: &[usize],
) {
    let Some((&last, outer)) = sides.split_last() else { return };
    let (start, width) = (origin[outer.len()], shape[outer.len()]);
    for (row, numbers) in numbers.chunks_exact(last).enumerate().take(outer.iter().product()) {
        // Place of the row in the data set, from the fastest axis on.
        let (mut rest, mut target, mut scale) = (row, start, width);
        let mut is_inside = start < width;
        for axis in (0..outer.len()).rev() {
            let place = origin[axis].saturating_add(rest % outer[axis]);
            rest /= outer[axis];
            is_inside &= place < shape[axis];
            target = target.saturating_add(place.saturating_mul(scale));
            scale = scale.saturating_mul(shape[axis]);
        }
        if is_inside {
            let count = last.min(width - start);
            values[target..target + count].copy_from_slice(&numbers[..count]);
        }
    }
}

fn unpack(filter: &Filter, data: &[u8], bytes: usize) -> Result<Vec<u8>, String> {
    match filter.id {
        // A checksum may stand behind the data.
        1 => zlib(data, bytes + 4),
        2 => {
            // The first bytes of all elements, then the second ones, and so on.
            let size = filter.setting.max(1);
            let count = data.len() / size;
            let mut mixed = data.to_vec();
            for element in 0..count {
                for byte in 0..size {
                    mixed[element * size + byte] = data[byte * count + element];
                }
            }
            Ok(mixed)
        }
        _ => Ok(data[..data.len().saturating_sub(4)].to_vec()),
    }
}

/// The chain of filters in a message.
fn read_filters(file: &File<'_>, at: usize) -> Result<Vec<Filter>, ReadError> {
    let b = file.b;
    let (version, count) = (b.u8(at)?, b.u8(at + 1)?);
    let mut place = at + if version == 1 { 8 } else { 2 };
    let mut filters = Vec::new();
    for _ in 0..count {
        let id = b.u16(place)?;
        let has_name = version == 1 || id >= 256;
        let name = if has_name { usize::from(b.u16(place + 2)?) } else { 0 };
        let numbers = place + if has_name { 6 } else { 4 };
        let settings = usize::from(b.u16(numbers)?);
        let name = if version == 1 { name.div_ceil(8) * 8 } else { name };
        let first = numbers + 2 + name;
        let setting = if settings > 0 { b.u32(first)? as usize } else { 0 };
        place = first + 4 * settings + if version == 1 { settings % 2 * 4 } else { 0 };
        if !matches!(id, 1..=3) {
            return Err(b.unsupported(format!(
                "filter {id} (deflate, shuffle and Fletcher-32 are; {WAY_OUT})"
            )));
        }
        filters.push(Filter { id, setting });
    }
    Ok(filters)
}

fn read_layout(
    file: &File<'_>,
    message: Message,
    rank: usize,
    filters: Vec<Filter>,
) -> Result<Storage, ReadError> {
    let (b, at) = (file.b, message.at);
    let unsupported = |feature: String| Err(b.unsupported(feature));
    let (version, class) = (b.u8(at)?, b.u8(at + 1)?);
    if !matches!(version, 3 | 4) {
        return unsupported(format!("a data layout of version {version} ({WAY_OUT})"));
    }
    let (sides, index) = match (class, version) {
        (0, _) => return Ok(Storage::Contiguous(at + 4)),
        (1, _) => return Ok(file.address(at + 2)?.map_or(Storage::Empty, Storage::Contiguous)),
        (2, 3) => {
            let axes = usize::from(b.u8(at + 2)?);
            if axes != rank + 1 {
                return Err(b.fault(at + 2, format!("chunks of {axes} axes for {rank}")));
            }
            let sides = at + 3 + file.address_size;
            let sides: Result<Vec<usize>, ReadError> =
                (0..rank).map(|i| file.unsigned(sides + 4 * i, 4)).collect();
            (sides, file.address(at + 3)?.map(Index::Tree))
        }
        (2, _) => {
            let (flags, axes, width) =
                (b.u8(at + 2)?, usize::from(b.u8(at + 3)?), usize::from(b.u8(at + 4)?));
            if axes != rank + 1 || !(1..=8).contains(&width) {
                return Err(b.fault(at + 3, format!("chunks of {axes} axes for {rank}")));
            }
            let sides = (0..rank).map(|i| file.unsigned(at + 5 + width * i, width)).collect();
            let index = at + 5 + width * axes;
            if b.u8(index)? != 1 {
                return unsupported(format!("chunks with an index of a newer form ({WAY_OUT})"));
            }
            let mut place = index + 1;
            let mut packed = None;
            if flags & 2 != 0 {
                packed = Some((file.length(place)?, b.u32(place + file.length_size)?));
                place += file.length_size + 4;
            }
            (sides, file.address(place)?.map(|only| Index::Only(only, packed)))
        }
        (class, _) => return unsupported(format!("a data layout of class {class}")),
    };
    let Some(index) = index else { return Ok(Storage::Empty) };
    let sides = sides?;
    let points = points(&sides);
    if points == 0 {
        return Err(b.field("chunks", "of no points"));
    }
    b.check_points([points, 1])?;
    Ok(Storage::Chunks(sides, filters, index))
}
