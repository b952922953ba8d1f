//! MNT of Digital Surf: documents of Mountains, an OLE compound document whose stream
//! `ScopedContents` holds records in records: u16 tag, u64 length, content. The form is not
//! published; what is read is its plain part: surfaces as they were loaded, heights in 32 bits.
//!
//! Below, `02bd.0002` is the record 0002 in the record 02bd. An *object* is 0001.0001 (u32, its
//! class) and 0002, its content.
//!
//! | record | content |
//! |---|---|
//! | stream, behind 8 bytes of length: 0001.02bd.0002.0001 | for each part of the document u64 length, then 0001, an object: 9012 holds data, 9013 is a result, computed anew by the program |
//! | 9012: 0001 | an object: 9062 is a surface; profiles, series and others are not read |
//! | 9062: ffff.ffff.ffff.ffff.0001 | name |
//! | ffff.ffff.0001.ffff, ffff.ffff.0002.ffff | along x, along y: ffff an axis, 0001 number of points, 0002 and 0003 first and last of them |
//! | ffff.ffff.0003 | an object: class 0 if all points are there, 9056 a mask |
//! | ffff.0001 | an object, 9049: 0001 number of points, 0002 a blob of i32, in rows |
//! | ffff.0002 | along z: ffff an axis, 0001 and 0002 lowest and highest number |
//! | an axis | 0001 step (f64), 0002 its unit, 0003 unit shown, 0004 the latter in the former, 0005 offset in the unit shown, 0006 is 1 |
//! | 9056: 0001, 0002, 0005 | points along x, along y, an object 9048: 0001 number of points, 0002 a blob of u8 with a border one point wide; 9 is measured, 22 is missing |
//! | a text | u8 4, then UTF-16; 21 marks a packed one |
//! | a blob | u64 bytes; then in any order blocks: u64 offset in points, u32 points, u32 bytes, a zlib stream |
//!
//! All numbers little endian. Height = number × step + offset. As the form is not published,
//! everything that can be checked is: units against their stored ratio, blocks against the number
//! of points, and the lowest and highest number against the stored ones; what differs is refused.
//!
//! Sources: SurfaceTopography (open) for the container, the records and the blocks; two documents of
//! MountainsMap 9 and 10 for the rest. That reader takes 0001.0006 for the scale of the heights, which in
//! both files is 10 beside the size of a sheet of paper, and stored 0 for a missing point.

use super::prelude::*;
use crate::encoding::utf16;
use crate::ole::Document;

pub(crate) const FORMAT: &str = "Digital Surf MNT";
const STREAM: &str = "ScopedContents";
const DATA: u32 = 9012;
const SURFACE: u32 = 9062;
const BASE: u16 = 0xffff;

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    contents(b).map_err(with_way_out)
}

/// Whatever is not as expected: the program that wrote the file knows better.
fn with_way_out(error: ReadError) -> ReadError {
    match error {
        ReadError::Malformed { format, place, what } => {
            let what = format!("{what}; save the surface as SUR in the program that wrote it");
            ReadError::at(format, place, what)
        }
        other => other,
    }
}

fn unsupported(feature: &str) -> ReadError {
    let feature = format!("{feature} (save the surface as SUR in Mountains)");
    ReadError::unsupported(FORMAT, feature)
}

fn contents(file: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let document = Document::open(file)?;
    if !document.names().any(|name| name == STREAM) {
        let feature = if document.names().any(|name| matches!(name, "Workbook" | "Book")) {
            "a spreadsheet in the form of xls (save its sheet as CSV)".to_owned()
        } else {
            let names: Vec<&str> = document.names().take(8).collect();
            format!(
                "an OLE compound document that is none of Mountains (it has {}; save a surface as \
                 SUR, a table as CSV)",
                names.join(", ")
            )
        };
        return Err(file.unsupported(feature));
    }
    let stream = document.stream(STREAM)?;
    let b = file.with(&stream);
    let whole = Part { bytes: b.from(8)?, at: 8 };
    let parts = whole.get(&[1, 0x02bd, 2, 1])?;
    let mut contents = Contents::default();
    let (mut at, mut count, mut classes) = (0, 0, Vec::new());
    while at < parts.bytes.data.len() {
        count += 1;
        b.check_items(count)?;
        let length = usize::try_from(parts.bytes.u64(at)?).unwrap_or(usize::MAX);
        at += 8;
        let part = Part { bytes: b.with(parts.bytes.slice(at, length)?), at: parts.at + at };
        at += length;
        let (class, part) = part.get(&[1])?.object()?;
        let Some(part) = part.filter(|_| class == DATA) else { continue };
        let (class, surface) = part.get(&[1])?.object()?;
        let Some(surface) = surface.filter(|_| class == SURFACE) else {
            classes.push(class.to_string());
            continue;
        };
        let name = surface.get(&[BASE, BASE, BASE, BASE, 1]).and_then(Part::text);
        let name = name.unwrap_or_else(|_| format!("Surface {}", contents.channels.len() + 1));
        let channel = StoredSurface::new(surface).map(|found| {
            let unit = found.z.shown.clone();
            let pixel = Pixel::Metres(found.pixel);
            Channel::new(name.as_str(), Some(&unit), found.shape, pixel, move || {
                found.heights().map_err(with_way_out)
            })
        });
        contents.add(&name, channel.map_err(with_way_out));
    }
    if contents.channels.is_empty() {
        let what = if classes.is_empty() { "no data".into() } else { classes.join(", ") };
        return Err(unsupported(&format!("a document without a surface (it holds {what})")));
    }
    Ok(contents)
}

/// The content of a record, and where in the stream it is.
#[derive(Clone, Copy)]
struct Part<'a> {
    bytes: Bytes<'a>,
    at: usize,
}

impl Part<'_> {
    fn get(self, path: &[u16]) -> Result<Self, ReadError> {
        path.iter().try_fold(self, |part, &tag| part.record(tag))
    }

    fn record(self, tag: u16) -> Result<Self, ReadError> {
        let mut at = 0;
        while at < self.bytes.data.len() {
            let length = usize::try_from(self.bytes.u64(at + 2)?).unwrap_or(usize::MAX);
            let data = self.bytes.slice(at + 10, length)?;
            if self.bytes.u16(at)? == tag {
                return Ok(Self { bytes: self.bytes.with(data), at: self.at + at + 10 });
            }
            at += 10 + length;
        }
        let what = format!("has no record {tag:04x} at byte {}", self.at);
        Err(self.bytes.field(STREAM, what))
    }

    fn object(self) -> Result<(u32, Option<Self>), ReadError> {
        Ok((self.get(&[1, 1])?.bytes.u32(0)?, self.record(2).ok()))
    }

    fn object_of(self, class: u32, what: &str) -> Result<Self, ReadError> {
        match self.object()? {
            (found, Some(part)) if found == class => Ok(part),
            (found, _) => Err(unsupported(&format!("{what} of class {found} ({class} is)"))),
        }
    }

    fn u32(self, tag: u16) -> Result<u32, ReadError> {
        self.record(tag)?.bytes.u32(0)
    }

    fn f64(self, tag: u16) -> Result<f64, ReadError> {
        let value = self.record(tag)?.bytes.f64(0)?;
        if !value.is_finite() {
            return Err(self.bytes.field(STREAM, format!("{value} at byte {}", self.at)));
        }
        Ok(value)
    }

    fn text(self) -> Result<String, ReadError> {
        match self.bytes.data.split_first() {
            Some((4, text)) if !text.is_empty() => Ok(utf16(text, u16::from_le_bytes)),
            _ => Err(self.bytes.field(STREAM, format!("no plain text at byte {}", self.at))),
        }
    }
}

/// How numbers along an axis become lengths.
struct StoredAxis {
    /// In the unit shown.
    step: f64,
    offset: f64,
    shown: String,
    /// Metres per unit shown, if it is a length.
    metres: Option<f64>,
}

impl StoredAxis {
    fn new(part: Part<'_>) -> Result<Self, ReadError> {
        let (step, ratio, offset) = (part.f64(1)?, part.f64(4)?, part.f64(5)?);
        let (unit, shown) = (part.record(2)?.text()?, part.record(3)?.text()?);
        let (own, metres) = (metres_per(&unit), metres_per(&shown));
        let expected = metres.zip(own).map_or(ratio, |(shown, own)| shown / own);
        let is_plain = own.is_some() == metres.is_some()
            && step > 0.0
            && ratio > 0.0
            && (ratio / expected - 1.0).abs() < 1e-9
            && part.u32(6)? == 1;
        if !is_plain {
            let what = format!("an axis with steps of {step} {unit}, shown in {ratio} {shown}");
            return Err(unsupported(&what));
        }
        Ok(Self { step: step / ratio, offset, shown, metres })
    }

    /// Points and spacing in metres along x or y.
    fn lateral(part: Part<'_>) -> Result<(usize, f64), ReadError> {
        let part = part.record(BASE)?;
        let axis = Self::new(part.record(BASE)?)?;
        let (points, first, last) = (part.u32(1)?, part.u32(2)?, part.u32(3)?);
        if first != 0 || last != points.wrapping_sub(1) {
            return Err(unsupported(&format!("points {first} to {last} of {points}")));
        }
        let Some(metres) = axis.metres else {
            return Err(unsupported(&format!("a map over an axis in {:?}", axis.shown)));
        };
        Ok((points as usize, axis.step * metres))
    }
}

/// What is known of a surface before its heights are unpacked.
struct StoredSurface {
    shape: [usize; 2],
    pixel: [f64; 2],
    z: StoredAxis,
    /// Lowest and highest number.
    range: [i32; 2],
    numbers: Blob,
    mask: Option<Blob>,
}

impl StoredSurface {
    fn new(part: Part<'_>) -> Result<Self, ReadError> {
        let part = part.record(BASE)?;
        let base = part.record(BASE)?;
        let ((nx, dx), (ny, dy)) =
            (StoredAxis::lateral(base.record(1)?)?, StoredAxis::lateral(base.record(2)?)?);
        part.bytes.check_points([ny, nx])?;
        let z = part.record(2)?;
        let range = [z.u32(1)?.cast_signed(), z.u32(2)?.cast_signed()];
        let numbers = part.record(1)?.object_of(9049, "heights")?;
        let numbers = Blob::new(numbers.record(2)?, ny * nx, Sample::I32)?;
        let mask = base.record(3)?;
        let mask = if mask.object()?.0 == 0 {
            None
        } else {
            let mask = mask.object_of(9056, "a mask")?;
            if [mask.u32(2)? as usize, mask.u32(1)? as usize] != [ny, nx] {
                return Err(unsupported("a mask of another size than its map"));
            }
            let blob = mask.record(5)?.object_of(9048, "a mask")?;
            Some(Blob::new(blob.record(2)?, (ny + 2) * (nx + 2), Sample::U8)?)
        };
        let z = StoredAxis::new(z.record(BASE)?)?;
        Ok(Self { shape: [ny, nx], pixel: [dy, dx], z, range, numbers, mask })
    }

    /// In the unit shown.
    fn heights(&self) -> Result<Vec<f64>, ReadError> {
        let [_, nx] = self.shape;
        let mut numbers = self.numbers.unpack()?;
        if let Some(mask) = &self.mask {
            let mask = mask.unpack()?;
            let marks = mask.chunks(nx + 2).skip(1).flat_map(|row| &row[1..=nx]);
            for (number, &mark) in numbers.iter_mut().zip(marks) {
                match mark as u8 {
                    9 => {}
                    22 => *number = f64::NAN,
                    mark => return Err(unsupported(&format!("a mask with the mark {mark}"))),
                }
            }
        }
        let valid = || numbers.iter().copied().filter(|number| !number.is_nan());
        let (low, high) = (valid().fold(f64::MAX, f64::min), valid().fold(f64::MIN, f64::max));
        let [lowest, highest] = self.range;
        if low <= high && [low as i32, high as i32] != self.range {
            let what = format!("numbers from {low} to {high}, the file says {lowest} to {highest}");
            return Err(ReadError::at(FORMAT, "heights", what));
        }
        for number in &mut numbers {
            *number = *number * self.z.step + self.z.offset;
        }
        Ok(numbers)
    }
}

/// Numbers in packed blocks, in the order of their points.
struct Blob {
    points: usize,
    sample: Sample,
    blocks: Vec<Block>,
}

struct Block {
    /// First point, and points.
    first: usize,
    count: usize,
    /// Place in the stream.
    at: usize,
    packed: Vec<u8>,
}

impl Blob {
    fn new(part: Part<'_>, points: usize, sample: Sample) -> Result<Self, ReadError> {
        let b = part.bytes;
        let fault = |what: String| b.field(STREAM, format!("{what} at byte {}", part.at));
        let total = b.u64(0)?;
        b.options.limits.check_unpacked(b.format, total)?;
        if total != (points as u64).saturating_mul(sample.size() as u64) {
            return Err(fault(format!("{total} bytes for {points} points")));
        }
        let (mut at, mut blocks) = (8, Vec::new());
        while at < b.data.len() {
            b.check_items(blocks.len() as u64 + 1)?;
            let first = usize::try_from(b.u64(at)?).unwrap_or(usize::MAX);
            let (count, packed) = (b.u32(at + 8)? as usize, b.u32(at + 12)? as usize);
            let bytes = b.slice(at + 16, packed)?.to_vec();
            blocks.push(Block { first, count, at: part.at + at + 16, packed: bytes });
            at += 16 + packed;
        }
        blocks.sort_unstable_by_key(|block| (block.first, block.count, block.at)); // empty ones first
        let mut next = 0usize;
        for &Block { first, count, .. } in &blocks {
            if first != next {
                return Err(fault(format!("point {next} is in no block, or in two,")));
            }
            next = next.saturating_add(count);
        }
        if next != points {
            return Err(fault(format!("blocks of {next} points for {points}")));
        }
        Ok(Self { points, sample, blocks })
    }

    fn unpack(&self) -> Result<Vec<f64>, ReadError> {
        let mut values = Vec::with_capacity(self.points);
        for Block { count, at, packed, .. } in &self.blocks {
            let length = count * self.sample.size();
            let fault = |what| ReadError::at(FORMAT, STREAM, format!("block at byte {at}: {what}"));
            let block = crate::unpack::zlib(packed, length + 1).map_err(fault)?;
            if block.len() != length {
                return Err(fault(format!("it does not hold {length} bytes")));
            }
            values.extend(self.sample.decode(&block, ByteOrder::Little));
        }
        Ok(values)
    }
}
