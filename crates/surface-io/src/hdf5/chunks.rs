//! Chunks: pieces of a data set, each packed by a chain of filters.

use super::file::{File, WAY_OUT};
use crate::binary::{ByteOrder, Sample};
use crate::error::ReadError;
use crate::unpack::zlib;
use std::borrow::Cow;

/// One filter of the chain.
#[derive(Debug, Clone)]
pub(crate) struct Filter {
    id: u16,
    /// First number of its settings: of shuffle, the bytes of an element.
    setting: usize,
}

/// Where the chunks of a data set are.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Index {
    /// In a B-tree at this address.
    Tree(usize),
    /// There is one, at this address; with filters, its packed size and the filters left out.
    Only(usize, Option<(u64, u32)>),
}

/// A data set in chunks.
#[derive(Debug)]
pub(crate) struct Chunked {
    /// Points of a chunk along every axis.
    sides: Vec<u64>,
    filters: Vec<Filter>,
    index: Index,
}

/// The chain of filters in a message.
pub(crate) fn filters(file: &File<'_>, at: usize) -> Result<Vec<Filter>, ReadError> {
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

impl Chunked {
    pub(crate) fn new(
        file: &File<'_>,
        sides: Vec<u64>,
        filters: Vec<Filter>,
        index: Index,
    ) -> Result<Self, ReadError> {
        let points =
            sides.iter().try_fold(1u64, |n, &side| n.checked_mul(side)).unwrap_or(u64::MAX);
        if points == 0 {
            return Err(file.b.field("chunks", "of no points"));
        }
        let points = usize::try_from(points).unwrap_or(usize::MAX);
        file.b.check_points([points, 1])?;
        Ok(Self { sides, filters, index })
    }

    pub(crate) fn values(
        &self,
        file: &File<'_>,
        shape: &[u64],
        sample: Sample,
        order: ByteOrder,
    ) -> Result<Vec<f64>, ReadError> {
        let points = shape.iter().product::<u64>() as usize; // checked by the caller
        // Each place once: a tree that names a chunk again and again is refused, not unpacked.
        let chunk: u64 = self.sides.iter().product();
        let chunk_bytes = chunk as usize * sample.size();
        let needed = shape
            .iter()
            .zip(&self.sides)
            .try_fold(1u64, |n, (&axis, &side)| n.checked_mul(axis.div_ceil(side)));
        let needed = needed.unwrap_or(u64::MAX);
        let work = needed.saturating_mul(chunk) / 4; // chunks stick out beyond the edges
        file.b.check_points([usize::try_from(work).unwrap_or(usize::MAX), 1])?;
        let mut values = vec![f64::NAN; points];
        let mut place = |(at, size, skip): (usize, u64, u32), origin: &[u64]| {
            let size = usize::try_from(size).unwrap_or(usize::MAX);
            let mut data = Cow::Borrowed(file.b.slice(at, size)?);
            for (i, filter) in self.filters.iter().enumerate().rev() {
                if skip >> i & 1 == 0 {
                    data = Cow::Owned(unpack(file, at, filter, &data, chunk_bytes)?);
                }
            }
            let numbers = sample.decode(&data, order);
            if (numbers.len() as u64) < chunk {
                let what = format!("a chunk of {} numbers, {chunk} are needed", numbers.len());
                return Err(file.b.fault(at, what));
            }
            copy_inside(&numbers, &self.sides, origin, &mut values, shape);
            Ok(())
        };
        let mut nodes = match self.index {
            Index::Tree(at) => vec![at],
            Index::Only(at, packed) => {
                let (size, skip) = packed.unwrap_or((chunk_bytes as u64, 0));
                place((at, size, skip), &vec![0; shape.len()])?;
                Vec::new()
            }
        };
        let mut chunks = 0;
        let mut read = 0;
        while let Some(node) = nodes.pop() {
            read += 1;
            file.b.check_items(read)?;
            if file.b.slice(node, 4)? != b"TREE" || file.b.u8(node + 4)? != 1 {
                return Err(file.b.fault(node, "a B-tree of chunks is expected here"));
            }
            let level = file.b.u8(node + 5)?;
            let key = 8 + 8 * (shape.len() + 1);
            let mut at = node + 8 + 2 * file.address_size;
            for _ in 0..file.b.u16(node + 6)? {
                let Some(child) = file.address(at + key)? else {
                    return Err(file.b.fault(at + key, "a chunk without address"));
                };
                if level > 0 {
                    nodes.push(child);
                    file.b.check_items(nodes.len() as u64)?;
                } else {
                    chunks += 1;
                    if chunks > needed {
                        return Err(file.b.fault(at, format!("more than the {needed} chunks")));
                    }
                    let (size, skip) = (u64::from(file.b.u32(at)?), file.b.u32(at + 4)?);
                    let origin: Result<Vec<u64>, ReadError> =
                        (0..shape.len()).map(|i| file.b.u64(at + 8 + 8 * i)).collect();
                    place((child, size, skip), &origin?)?;
                }
                at += key + file.address_size;
            }
        }
        Ok(values)
    }
}

/// Writes the numbers of a chunk that lie inside the data set.
fn copy_inside(numbers: &[f64], sides: &[u64], origin: &[u64], values: &mut [f64], shape: &[u64]) {
    let Some((&last, outer)) = sides.split_last() else { return };
    let (last, rows) = (last as usize, outer.iter().product::<u64>());
    let (start, width) = (origin[outer.len()], shape[outer.len()]);
    for row in 0..rows {
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
            let count = last.min((width - start) as usize);
            let (row, target) = (row as usize * last, target as usize);
            values[target..target + count].copy_from_slice(&numbers[row..row + count]);
        }
    }
}

fn unpack(
    file: &File<'_>,
    at: usize,
    filter: &Filter,
    data: &[u8],
    bytes: usize,
) -> Result<Vec<u8>, ReadError> {
    match filter.id {
        // A checksum may stand behind the data.
        1 => zlib(data, bytes + 4).map_err(|what| file.b.fault(at, what)),
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
