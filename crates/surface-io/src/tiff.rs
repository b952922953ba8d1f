//! TIFF 6.0: the directories and images that Park, JPK, Olympus and plain TIFF files are made of.
//!
//! | byte | content |
//! |---|---|
//! | 0 | `II` little endian or `MM` big endian, then 42 as u16 (43, BigTIFF, is refused) |
//! | 4 | u32 offset of the first directory |
//! | directory | u16 number of entries; entries of 12 bytes: u16 tag, u16 type, u32 count, u32 value or its offset; u32 offset of the next directory, 0 at the end |
//! | 256, 257 | width, length |
//! | 258, 339 | bits per sample; 1 unsigned, 2 signed, 3 floating |
//! | 259 | compression: 1 none, 5 LZW, 8 and 32946 deflate, 32773 PackBits |
//! | 262 | 1 black is 0; 0 white is 0 and 3 a palette of colours are refused |
//! | 277 | samples per pixel: 1 is read |
//! | 273, 278, 279 | strips: offsets, rows per strip, bytes |
//! | 322, 323, 324, 325 | tiles: width, length, offsets, bytes |
//! | 317 | predictor: 1 none, 2 differences along a row |
//!
//! Source: Adobe, *TIFF Revision 6.0* (1992), with its technical notes.

use crate::binary::{ByteOrder, Bytes, Sample};
use crate::error::ReadError;
use crate::options::{Limits, ReadOptions};
use crate::unpack::{lzw, packbits, zlib};
use std::borrow::Cow;
use std::collections::BTreeMap;

pub(crate) const IMAGE_DESCRIPTION: u16 = 270;

pub(crate) fn is_tiff(bytes: &[u8]) -> bool {
    matches!(bytes, [b'I', b'I', 42 | 43, 0, ..] | [b'M', b'M', 0, 42 | 43, ..])
}

/// Whether these bytes are a TIFF file, with such a first directory.
pub(crate) fn first_page_is(bytes: &[u8], such: impl FnOnce(&Page<'_>) -> bool) -> bool {
    let limits = Limits { items: 1 << 12, ..Limits::default() };
    let few = ReadOptions { limits, ..ReadOptions::default() };
    let first = || pages(Bytes::little(bytes, "TIFF", &few), 1).ok()?.pop();
    is_tiff(bytes) && first().is_some_and(|page| such(&page))
}

pub(crate) struct Page<'a> {
    bytes: Bytes<'a>,
    entries: BTreeMap<u16, Entry>,
}

#[derive(Debug, Clone, Copy)]
struct Entry {
    kind: u16,
    count: usize,
    at: usize,
}

/// The directories of a file, at most `most` of them.
pub(crate) fn pages(mut b: Bytes<'_>, most: usize) -> Result<Vec<Page<'_>>, ReadError> {
    if b.data.starts_with(b"MM") {
        b.order = ByteOrder::Big;
    }
    if b.u16(2)? != 42 {
        return Err(b.unsupported("BigTIFF (save it as TIFF)"));
    }
    let (mut pages, mut at) = (Vec::new(), b.u32(4)? as usize);
    let mut entries_read = 0;
    while at != 0 && pages.len() < most {
        let count = b.u16(at)?;
        // Directories that point at each other end at this limit.
        entries_read += u64::from(count) + 1;
        b.check_items(entries_read)?;
        pages.push(Page::at(b, at)?);
        at = b.u32(at + 2 + 12 * usize::from(count))? as usize;
    }
    Ok(pages)
}

/// How a type stores numbers, unless it stores texts or fractions.
fn sample(kind: u16) -> Option<Sample> {
    Sample::of_number(kind.into(), "- u1 - u2 u4 - i1 u1 i2 i4 - f4 f8 u4")
}

fn size(kind: u16) -> usize {
    sample(kind).map_or(if matches!(kind, 5 | 10) { 8 } else { 1 }, Sample::size)
}

impl<'a> Page<'a> {
    fn at(b: Bytes<'a>, at: usize) -> Result<Self, ReadError> {
        let mut entries = BTreeMap::new();
        for i in 0..usize::from(b.u16(at)?) {
            let place = at + 2 + 12 * i;
            let (kind, count) = (b.u16(place + 2)?, b.u32(place + 4)? as usize);
            let fits = size(kind).saturating_mul(count) <= 4;
            let value = if fits { place + 8 } else { b.u32(place + 8)? as usize };
            entries.insert(b.u16(place)?, Entry { kind, count, at: value });
        }
        Ok(Self { bytes: b, entries })
    }

    pub(crate) fn has(&self, tag: u16) -> bool {
        self.entries.contains_key(&tag)
    }

    /// The bytes of an entry and where they are.
    pub(crate) fn raw(&self, tag: u16) -> Result<(usize, &'a [u8]), ReadError> {
        let entry = self.entry(tag)?;
        let length = size(entry.kind).saturating_mul(entry.count);
        Ok((entry.at, self.bytes.slice(entry.at, length)?))
    }

    fn entry(&self, tag: u16) -> Result<Entry, ReadError> {
        let entry = self.entries.get(&tag).copied();
        entry.ok_or_else(|| self.bytes.field(format!("tag {tag}"), "is missing"))
    }

    pub(crate) fn numbers(&self, tag: u16) -> Result<Vec<f64>, ReadError> {
        let entry = self.entry(tag)?;
        let sample = sample(entry.kind).ok_or_else(|| {
            let what = format!("is of type {}, no plain number", entry.kind);
            self.bytes.field(format!("tag {tag}"), what)
        })?;
        self.bytes.samples(entry.at, entry.count, sample)
    }

    pub(crate) fn number(&self, tag: u16) -> Result<f64, ReadError> {
        let first = self.numbers(tag)?.first().copied();
        first.ok_or_else(|| self.bytes.field(format!("tag {tag}"), "is empty"))
    }

    fn number_or(&self, tag: u16, default: f64) -> Result<f64, ReadError> {
        if self.has(tag) { self.number(tag) } else { Ok(default) }
    }

    /// The text of an entry; none if it is not there.
    pub(crate) fn text(&self, tag: u16) -> Option<String> {
        self.raw(tag).ok().map(|(_, raw)| crate::binary::text(raw))
    }

    #[cfg(feature = "zip")] // of LEXT only
    pub(crate) fn sub_page(&self, tag: u16) -> Result<Self, ReadError> {
        Self::at(self.bytes, self.number(tag)? as usize)
    }

    pub(crate) fn image(&self) -> Result<Image<'a>, ReadError> {
        let b = self.bytes;
        let unsupported = |feature: String| Err(b.unsupported(feature));
        let shape = [self.number(257)? as usize, self.number(256)? as usize];
        b.check_points(shape)?;
        let [ny, nx] = shape;
        if ny == 0 || nx == 0 {
            return Err(b.field("tags 256, 257", format!("{ny} x {nx} points")));
        }
        let per_pixel = self.number_or(277, 1.0)?;
        if per_pixel > 1.0 {
            return unsupported(format!(
                "a picture of {per_pixel} colours (heights are one number a point)"
            ));
        }
        match self.number_or(262, 1.0)? as u32 {
            0 => return unsupported("a picture whose 0 is white (save it with 0 as black)".into()),
            3 => return unsupported("a picture of colours from a palette".into()),
            _ => {}
        }
        let (bits, kind) = (self.number_or(258, 1.0)?, self.number_or(339, 1.0)?);
        let sample = match (bits as usize, kind as u32) {
            (bits, 1 | 2 | 4) => Sample::of_bits(bits, kind as u32 == 2),
            (32, 3) => Some(Sample::F32),
            (64, 3) => Some(Sample::F64),
            _ => None,
        };
        let Some(sample) = sample else {
            return unsupported(format!("{bits} bits a point in sample format {kind}"));
        };
        let compression = self.number_or(259, 1.0)? as u32;
        if !matches!(compression, 1 | 5 | 8 | 32946 | 32773) {
            return unsupported(format!("compression {compression}"));
        }
        let predictor = self.number_or(317, 1.0)? as u32;
        let is_float = matches!(sample, Sample::F32 | Sample::F64);
        if !(predictor == 1 || predictor == 2 && !is_float) {
            return unsupported(format!("predictor {predictor}"));
        }
        let is_tiled = self.has(322);
        let block = if is_tiled {
            [self.number(323)? as usize, self.number(322)? as usize]
        } else {
            [(self.number_or(278, ny as f64)? as usize).min(ny), nx]
        };
        let [rows, columns] = block;
        if !(1..=2 * ny.max(4096)).contains(&rows) || !(1..=2 * nx.max(4096)).contains(&columns) {
            return Err(b.field("strips or tiles", format!("of {rows} x {columns} points")));
        }
        let [offsets, lengths] = if is_tiled { [324, 325] } else { [273, 279] };
        let offsets = self.numbers(offsets)?;
        let block_bytes = rows * columns * sample.size();
        let lengths = if self.has(lengths) || compression != 1 {
            self.numbers(lengths)?
        } else {
            // Only a single strip may leave its length out.
            vec![block_bytes as f64; offsets.len()]
        };
        let blocks: Vec<(usize, usize)> =
            offsets.iter().zip(&lengths).map(|(&at, &n)| (at as usize, n as usize)).collect();
        let needed = ny.div_ceil(rows) * nx.div_ceil(columns);
        if blocks.len() < needed {
            let what = format!("{} for a picture that needs {needed}", blocks.len());
            return Err(b.field("strips or tiles", what));
        }
        for &(at, length) in &blocks[..needed] {
            b.slice(at, length)?;
        }
        // No method packs tighter than 1 : 4096; a picture that claims more is none.
        if needed.saturating_mul(block_bytes) / 4096 > b.data.len() {
            return Err(b.field("picture", format!("{ny} x {nx} points are not in the file")));
        }
        let is_differences = predictor == 2;
        Ok(Image { bytes: b, shape, sample, compression, is_differences, block, blocks })
    }
}

/// A picture of one number a point.
pub(crate) struct Image<'a> {
    bytes: Bytes<'a>,
    pub(crate) shape: [usize; 2],
    sample: Sample,
    compression: u32,
    is_differences: bool,
    /// Rows and columns of a strip or tile.
    block: [usize; 2],
    /// Offset and length.
    blocks: Vec<(usize, usize)>,
}

impl Image<'_> {
    pub(crate) fn decode(&self) -> Result<Vec<f64>, ReadError> {
        let [ny, nx] = self.shape;
        let [rows, columns] = self.block;
        let mut values = vec![f64::NAN; ny * nx];
        let across = nx.div_ceil(columns);
        for (i, &(at, length)) in self.blocks.iter().enumerate().take(across * ny.div_ceil(rows)) {
            let (y0, x0) = (i / across * rows, i % across * columns);
            // The last strip is cut at the edge of the picture, a tile is not.
            let height = if columns == nx { rows.min(ny - y0) } else { rows };
            let unpacked = self.unpack(at, length, height * columns * self.sample.size())?;
            let mut block = self.sample.decode(&unpacked, self.bytes.order);
            if block.len() < (ny - y0).min(height) * columns {
                return Err(self.bytes.fault(at, format!("{} points in strip {i}", block.len())));
            }
            if self.is_differences {
                self.add_up(&mut block, columns);
            }
            for (iy, row) in block.chunks_exact(columns).enumerate().take(ny - y0) {
                let width = columns.min(nx - x0);
                let start = (y0 + iy) * nx + x0;
                values[start..start + width].copy_from_slice(&row[..width]);
            }
        }
        Ok(values)
    }

    /// Undoes predictor 2: every number is the difference to the one before, modulo its type.
    fn add_up(&self, block: &mut [f64], columns: usize) {
        let modulus = (1u64 << (8 * self.sample.size())) as f64;
        let is_signed = matches!(self.sample, Sample::I8 | Sample::I16 | Sample::I32);
        for row in block.chunks_exact_mut(columns) {
            let mut sum = 0.0;
            for value in row {
                sum = (sum + *value).rem_euclid(modulus);
                *value = if is_signed && sum >= modulus / 2.0 { sum - modulus } else { sum };
            }
        }
    }

    fn unpack(&self, at: usize, length: usize, most: usize) -> Result<Cow<'_, [u8]>, ReadError> {
        let packed = self.bytes.slice(at, length)?;
        let unpacked = match self.compression {
            5 => lzw(packed, most).ok_or_else(|| "bad LZW data".into()),
            32773 => packbits(packed, most).ok_or_else(|| "bad PackBits".into()),
            8 | 32946 => zlib(packed, most),
            _ => return Ok(Cow::Borrowed(&packed[..packed.len().min(most)])),
        };
        unpacked.map(Cow::Owned).map_err(|what| self.bytes.fault(at, what))
    }
}
