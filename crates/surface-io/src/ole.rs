//! OLE compound documents (MS-CFB): a small file system of streams in sectors. One stream is looked
//! for and read; no crate is needed for that, and what is read can never be more than the file.
//!
//! | byte | type | content |
//! |---|---|---|
//! | 0 | 8 | [`MAGIC`] |
//! | 30, 32 | u16 | log2 of the bytes of a sector (9 or 12), of a small one (6) |
//! | 48 | u32 | first sector of the directory |
//! | 56 | u32 | shortest stream that is in sectors; shorter ones are in small sectors |
//! | 60 | u32 | first sector of the table of small sectors |
//! | 68 | u32 | first sector of the further list of the table's sectors |
//! | 76 | 109 u32 | sectors of the table, which holds the next sector of every sector |
//!
//! Sector k begins at (k + 1) times the size of a sector. An entry of the directory has 128 bytes:
//!
//! | byte | type | content |
//! |---|---|---|
//! | 0 | 64 | name, UTF-16 |
//! | 64 | u16 | bytes of the name with its final zero |
//! | 66 | u8 | 2 a stream, 5 the root, whose stream holds the small sectors |
//! | 116 | u32 | first sector |
//! | 120 | u64 | bytes of the stream; the upper half counts with sectors of 4096 bytes only |
//!
//! All numbers little endian. No chain is followed for more bytes than the file has, so that one that
//! bites its tail ends.
//!
//! Source: Microsoft, *\[MS-CFB\]: Compound File Binary File Format*.

use crate::ReadError;
use crate::binary::Bytes;
use crate::encoding::utf16;

pub(crate) const MAGIC: &[u8] = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1";

/// Numbers from here on end a chain or mark a sector that is in none.
const END: u32 = 0xffff_fffa;
const ENTRY: usize = 128;

struct StreamEntry {
    name: String,
    kind: u8,
    start: u32,
    length: u64,
}

/// Where sectors lie: in these bytes from a first one on, of this size, and which sector follows on each.
struct Sectors<'s> {
    bytes: Bytes<'s>,
    first: usize,
    size: usize,
    next: Vec<u32>,
}

impl Sectors<'_> {
    /// The bytes of the chain of sectors that begins with `start`: `length` of them, or all.
    fn chain(&self, name: &str, start: u32, length: Option<u64>) -> Result<Vec<u8>, ReadError> {
        let b = self.bytes;
        let fault = |what: String| Err(b.field(name.to_owned(), what));
        let most = b.data.len() as u64;
        if let Some(length) = length.filter(|&length| length > most) {
            return fault(format!("{length} bytes are more than the {most} there are"));
        }
        let wanted = length.unwrap_or(most) as usize;
        let (mut at, mut chain) = (start, Vec::new()); // grows with what is there
        while chain.len() < wanted && (at < END || length.is_some()) {
            if at >= END {
                return fault("its sectors end early".into());
            }
            let place = (at as usize).saturating_mul(self.size).saturating_add(self.first);
            chain.extend_from_slice(b.slice(place, self.size.min(wanted - chain.len()))?);
            let Some(&next) = self.next.get(at as usize) else {
                return fault(format!("the sector table does not reach to sector {at}"));
            };
            at = next;
        }
        if length.is_none() && at < END {
            return fault("its sectors never end".into());
        }
        Ok(chain)
    }
}

pub(crate) struct Document<'a> {
    sectors: Sectors<'a>,
    entries: Vec<StreamEntry>,
}

impl<'a> Document<'a> {
    pub(crate) fn open(file: Bytes<'a>) -> Result<Self, ReadError> {
        let (sector, small) = (file.u16(30)?, file.u16(32)?);
        if !matches!(sector, 9 | 12) || small != 6 {
            return Err(file.fault(30, format!("sectors of 2^{sector} and 2^{small} bytes")));
        }
        let size = 1 << sector;
        let next = table(file, size)?;
        let sectors = Sectors { bytes: file, first: size, size, next };
        let mut entries = Vec::new();
        for raw in sectors.chain("directory", file.u32(48)?, None)?.chunks_exact(ENTRY) {
            let entry = file.with(raw);
            let kind = entry.u8(66)?;
            if !matches!(kind, 2 | 5) {
                continue;
            }
            let bytes = usize::from(entry.u16(64)?).clamp(2, 64) - 2;
            let mut length = entry.u64(120)?;
            if size == 512 {
                length &= 0xffff_ffff;
            }
            let (name, start) = (utf16(&raw[..bytes], u16::from_le_bytes), entry.u32(116)?);
            entries.push(StreamEntry { name, kind, start, length });
        }
        Ok(Self { sectors, entries })
    }

    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.entries.iter().filter(|entry| entry.kind == 2).map(|entry| entry.name.as_str())
    }

    pub(crate) fn stream(&self, name: &str) -> Result<Vec<u8>, ReadError> {
        let file = self.sectors.bytes;
        let entry = self.entries.iter().find(|entry| entry.kind == 2 && entry.name == name);
        let entry = entry.ok_or_else(|| file.field(name.to_owned(), "is missing"))?;
        let (start, length) = (entry.start, Some(entry.length));
        if entry.length >= u64::from(file.u32(56)?) {
            return self.sectors.chain(name, start, length);
        }
        let root = self.entries.iter().find(|entry| entry.kind == 5);
        let root = root.ok_or_else(|| file.field("root entry", "is missing"))?;
        let pool = self.sectors.chain("root entry", root.start, Some(root.length))?;
        let next = numbers(&self.sectors.chain("table of small sectors", file.u32(60)?, None)?);
        Sectors { bytes: file.with(&pool), first: 0, size: 64, next }.chain(name, start, length)
    }
}

/// The sector after each one. The first 109 sectors of this table are listed in the header, further ones in
/// sectors of which each ends with the number of the next one.
fn table(file: Bytes<'_>, size: usize) -> Result<Vec<u32>, ReadError> {
    let sector = |number: u32| file.slice((number as usize + 1).saturating_mul(size), size);
    let count = file.data.len() / size;
    let (mut list, mut at) = (numbers(file.slice(76, 4 * 109)?), file.u32(68)?);
    let mut next = Vec::new();
    for _ in 0..=count {
        for &number in list.iter().take_while(|&&number| number < END) {
            next.extend(numbers(sector(number)?));
        }
        if at >= END {
            return Ok(next);
        }
        if next.len() > count.saturating_mul(size / 4) {
            break;
        }
        list = numbers(sector(at)?);
        at = list.pop().unwrap_or(END);
    }
    Err(file.field("sector table", "has more sectors than the file"))
}

fn numbers(raw: &[u8]) -> Vec<u32> {
    raw.chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect()
}
