//! A data set: what it is, and its numbers.

use super::chunks::{self, Chunked, Filter, Index};
use super::file::{File, Message, WAY_OUT};
use super::types::{AttributeValue, Type, read_attribute, read_shape, read_type};
use crate::binary::{ByteOrder, Bytes, Sample};
use crate::error::ReadError;

/// A data set of numbers.
#[derive(Debug)]
pub(crate) struct Dataset<'a> {
    file: File<'a>,
    /// Sizes of the axes, the slowest first.
    pub(crate) shape: Vec<u64>,
    sample: Sample,
    order: ByteOrder,
    layout: Storage,
    pub(crate) attributes: Vec<(String, AttributeValue)>,
}

#[derive(Debug)]
enum Storage {
    /// One after the other from this byte.
    Contiguous(usize),
    Chunks(Chunked),
    /// Never written.
    Empty,
}

impl<'a> Dataset<'a> {
    /// The data set whose header is at `at`; `None` if it does not hold numbers.
    pub(crate) fn at(file: &File<'a>, at: usize) -> Result<Option<Self>, ReadError> {
        let messages = file.messages(at)?;
        let find = |kind: u16| messages.iter().copied().find(|message| message.kind == kind);
        let missing = |what: &'static str| file.b.fault(at, format!("a data set without {what}"));
        let kind = find(0x03).ok_or_else(|| missing("type"))?;
        let (kind, _) = read_type(file, kind.at, 0)?;
        let Type::Number(sample, order) = kind.kind else { return Ok(None) };
        let shape = find(0x01).ok_or_else(|| missing("dataspace"))?;
        let shape = read_shape(file, shape.at)?;
        let mut attributes = Vec::new();
        for message in messages.iter().filter(|message| message.kind == 0x0c) {
            attributes.extend(read_attribute(file, message.at)?);
        }
        let filters = match find(0x0b) {
            Some(message) => chunks::filters(file, message.at)?,
            None => Vec::new(),
        };
        let layout = find(0x08).ok_or_else(|| missing("layout"))?;
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
        let points = self.shape.iter().try_fold(1u64, |n, &side| n.checked_mul(side));
        let points = usize::try_from(points.unwrap_or(u64::MAX)).unwrap_or(usize::MAX);
        self.file.b.check_points([points, 1])?;
        let b = Bytes { order: self.order, ..self.file.b };
        match &self.layout {
            Storage::Contiguous(at) => b.samples(*at, points, self.sample),
            Storage::Chunks(chunked) => {
                chunked.values(&self.file, &self.shape, self.sample, self.order)
            }
            Storage::Empty => Err(b.field("data", "the data set was never written")),
        }
    }
}

fn read_layout(
    file: &File<'_>,
    message: Message,
    rank: usize,
    filters: Vec<Filter>,
) -> Result<Storage, ReadError> {
    let (b, at) = (file.b, message.at);
    let unsupported = |feature: String| b.unsupported(feature);
    let (version, class) = (b.u8(at)?, b.u8(at + 1)?);
    if !matches!(version, 3 | 4) {
        return Err(unsupported(format!("a data layout of version {version} ({WAY_OUT})")));
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
            let sides: Result<Vec<u64>, ReadError> =
                (0..rank).map(|i| b.u32(sides + 4 * i).map(u64::from)).collect();
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
                let feature = format!("chunks with an index of a newer form ({WAY_OUT})");
                return Err(unsupported(feature));
            }
            let mut place = index + 1;
            let mut packed = None;
            if flags & 2 != 0 {
                packed = Some((file.length(place)?, b.u32(place + file.length_size)?));
                place += file.length_size + 4;
            }
            (sides, file.address(place)?.map(|only| Index::Only(only, packed)))
        }
        (class, _) => return Err(unsupported(format!("a data layout of class {class}"))),
    };
    match index {
        Some(index) => Ok(Storage::Chunks(Chunked::new(file, sides?, filters, index)?)),
        None => Ok(Storage::Empty),
    }
}
