//! Data types, and values of attributes.

use super::file::{File, points};
use crate::binary::{ByteOrder, Bytes, Sample, text};
use crate::error::ReadError;

/// A data type, as far as it is read.
pub(crate) enum Type {
    Number(Sample, ByteOrder),
    /// Text of so many bytes.
    Text(usize),
    /// Text, or numbers, of any length in the global heap.
    Long(Option<(Sample, ByteOrder)>),
    /// Offsets and types of the members.
    Compound(Vec<(usize, Type)>),
    Other,
}

pub(crate) enum AttributeValue {
    Numbers(Vec<f64>),
    Text(String),
    /// Of a compound.
    Members(Vec<AttributeValue>),
}

impl AttributeValue {
    pub(crate) fn text(&self) -> Option<&str> {
        if let Self::Text(text) = self { Some(text) } else { None }
    }

    pub(crate) fn numbers(&self) -> Option<&[f64]> {
        if let Self::Numbers(numbers) = self { Some(numbers) } else { None }
    }
}

/// Compounds within compounds beyond this are refused.
const DEEPEST: usize = 8;

/// The type at `at`, and the byte behind it.
pub(crate) fn read_type(
    file: &File<'_>,
    at: usize,
    depth: usize,
) -> Result<(Type, usize), ReadError> {
    let b = file.b;
    let head = b.u8(at)?;
    let (version, class) = (head >> 4, head & 15);
    let bits = [b.u8(at + 1)?, b.u8(at + 2)?];
    let size = b.u32(at + 4)? as usize;
    let order = if bits[0] & 1 == 0 { ByteOrder::Little } else { ByteOrder::Big };
    if depth > DEEPEST {
        return Err(b.fault(at, "a data type nested too deep"));
    }
    let number = |sample| Type::Number(sample, order);
    Ok(match class {
        0 => {
            let is_whole = b.u16(at + 8)? == 0 && usize::from(b.u16(at + 10)?) == 8 * size;
            let sample = Sample::whole(size, bits[0] & 8 != 0).filter(|_| is_whole);
            (sample.map_or(Type::Other, number), at + 12)
        }
        1 => {
            // Exponent and mantissa where IEEE 754 has them.
            let fields = [b.u8(at + 12)?, b.u8(at + 13)?, b.u8(at + 15)?];
            let kind = match (size, fields) {
                (4, [23, 8, 23]) => number(Sample::F32),
                (8, [52, 11, 52]) => number(Sample::F64),
                _ => Type::Other,
            };
            (kind, at + 20)
        }
        3 => (Type::Text(size), at + 8),
        6 => {
            let count = usize::from(u16::from_le_bytes(bits));
            let (mut members, mut next) = (Vec::new(), at + 8);
            for _ in 0..count {
                let rest = b.from(next)?.data;
                let length = rest.iter().take(1024).position(|&byte| byte == 0);
                let length = length.ok_or_else(|| b.fault(next, "a name without end"))?;
                next += if version < 3 { (length + 8) / 8 * 8 } else { length + 1 };
                // Later versions take as many bytes as the size has.
                let width = if version < 3 { 4 } else { size.max(1).ilog2() as usize / 8 + 1 };
                let offset = file.unsigned(next, width)?;
                next += width + if version == 1 { 28 } else { 0 };
                let (member, end) = read_type(file, next, depth + 1)?;
                next = end;
                members.push((offset, member));
            }
            (Type::Compound(members), next)
        }
        9 => {
            let (base, end) = read_type(file, at + 8, depth + 1)?;
            let kind = match (bits[0] & 15, base) {
                (1, _) => Type::Long(None),
                (_, Type::Number(sample, order)) => Type::Long(Some((sample, order))),
                _ => Type::Other,
            };
            (kind, end)
        }
        2 => (Type::Other, at + 10),
        4 => (Type::Other, at + 12),
        _ => (Type::Other, at + 8),
    })
}

/// Sizes of the axes in a dataspace message.
pub(crate) fn read_shape(file: &File<'_>, at: usize) -> Result<Vec<usize>, ReadError> {
    let first = if file.b.u8(at)? == 1 { at + 8 } else { at + 4 };
    (0..usize::from(file.b.u8(at + 1)?))
        .map(|i| file.length(first + i * file.length_size))
        .collect()
}

/// The value in an attribute message, with its name; `None` if its type is not read.
pub(crate) fn read_attribute(
    file: &File<'_>,
    at: usize,
) -> Result<Option<(String, AttributeValue)>, ReadError> {
    let b = file.b;
    let version = b.u8(at)?;
    let sizes = [b.u16(at + 2)?, b.u16(at + 4)?, b.u16(at + 6)?].map(usize::from);
    let padded = |size: usize| if version == 1 { size.div_ceil(8) * 8 } else { size };
    let name_at = at + if version < 3 { 8 } else { 9 };
    let type_at = name_at + padded(sizes[0]);
    let space_at = type_at + padded(sizes[1]);
    let data_at = space_at + padded(sizes[2]);
    let name = b.text(name_at, sizes[0])?;
    let (kind, _) = read_type(file, type_at, 0)?;
    let count = points(&read_shape(file, space_at)?);
    Ok(value(file, &kind, data_at, count)?.map(|value| (name, value)))
}

/// `count` values from `at`; of texts and compounds the first.
fn value(
    file: &File<'_>,
    kind: &Type,
    at: usize,
    count: usize,
) -> Result<Option<AttributeValue>, ReadError> {
    let b = file.b;
    if count == 0 {
        return Ok(None);
    }
    Ok(match kind {
        Type::Number(sample, order) => {
            let b = Bytes { order: *order, ..b };
            Some(AttributeValue::Numbers(b.samples(at, count.min(1024), *sample)?))
        }
        Type::Text(size) => Some(AttributeValue::Text(b.text(at, *size)?)),
        Type::Long(base) => {
            let length = b.u32(at)? as usize;
            let Some(heap) = file.address(at + 4)? else { return Ok(None) };
            let raw = global(file, heap, b.u32(at + 4 + file.address_size)?)?;
            Some(match base {
                None => AttributeValue::Text(text(&raw[..length.min(raw.len())])),
                Some((sample, order)) => {
                    let mut numbers = sample.decode(raw, *order);
                    numbers.truncate(length);
                    AttributeValue::Numbers(numbers)
                }
            })
        }
        Type::Compound(members) => {
            let mut values = Vec::new();
            for (offset, member) in members {
                values.extend(value(file, member, at.saturating_add(*offset), 1)?);
            }
            Some(AttributeValue::Members(values))
        }
        Type::Other => None,
    })
}

/// An object of the global heap.
fn global<'a>(file: &File<'a>, heap: usize, wanted: u32) -> Result<&'a [u8], ReadError> {
    let b = file.b;
    if b.slice(heap, 4)? != b"GCOL" {
        return Err(b.fault(heap, "a global heap is expected here"));
    }
    let end = heap.saturating_add(file.length(heap + 8)?);
    let mut at = heap + 8 + file.length_size;
    let mut read = 0;
    while at < end {
        read += 1;
        b.check_items(read)?;
        let (index, size) = (b.u16(at)?, file.length(at + 8)?);
        let data = at + 8 + file.length_size;
        if u32::from(index) == wanted {
            return b.slice(data, size);
        }
        if index == 0 {
            break;
        }
        at = data.saturating_add(size.div_ceil(8).saturating_mul(8));
    }
    Err(b.fault(heap, format!("the global heap has no object {wanted}")))
}
