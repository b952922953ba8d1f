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
//! All numbers little endian. A chain is followed for as many sectors as its stream can have, and
//! never for more than the file has, so that a chain that bites its tail ends.
//!
//! Source: Microsoft, *\[MS-CFB\]: Compound File Binary File Format*.

use crate::ReadError;
use crate::binary::Bytes;
use crate::encoding::utf16;

pub(crate) const MAGIC: &[u8] = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1";

/// Numbers from here on end a chain or mark a sector that is in none.
const END: u32 = 0xffff_fffa;
const ENTRY: usize = 128;

/// A stream of the directory.
struct StreamEntry {
    name: String,
    kind: u8,
    start: u32,
    length: u64,
}

/// A compound document.
pub(crate) struct Document<'a> {
    file: Bytes<'a>,
    sector: usize,
    small: usize,
    /// Sectors of the table of all sectors.
    table: Vec<u32>,
    entries: Vec<StreamEntry>,
}

impl<'a> Document<'a> {
    /// Reads table and directory.
    pub(crate) fn open(file: Bytes<'a>) -> Result<Self, ReadError> {
        let (sector, small) = (file.u16(30)?, file.u16(32)?);
        if !matches!(sector, 9 | 12) || small != 6 {
            return Err(file.fault(30, format!("sectors of 2^{sector} and 2^{small} bytes")));
        }
        let (sector, small) = (1 << sector, 1 << small);
        let mut found = Self { file, sector, small, table: Vec::new(), entries: Vec::new() };
        found.read_table()?;
        found.read_directory()?;
        Ok(found)
    }

    /// Names of all streams.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.entries.iter().filter(|entry| entry.kind == 2).map(|entry| entry.name.as_str())
    }

    /// The bytes of a stream.
    pub(crate) fn stream(&self, name: &str) -> Result<Vec<u8>, ReadError> {
        let entry = self.entries.iter().find(|entry| entry.kind == 2 && entry.name == name);
        let entry = entry.ok_or_else(|| self.file.field(name.to_owned(), "is missing"))?;
        if entry.length >= u64::from(self.file.u32(56)?) {
            return self.read(entry);
        }
        let root = self.entries.iter().find(|entry| entry.kind == 5);
        let root = root.ok_or_else(|| self.file.field("root entry", "is missing"))?;
        let pool = self.read(root)?;
        let pool = self.file.with(&pool);
        let table = self.small_table(entry)?;
        let piece = |at: u32, length| pool.slice((at as usize).saturating_mul(self.small), length);
        let next = |at: u32| table.get(at as usize).copied().ok_or_else(|| self.broken(entry));
        collect(entry, self.small, piece, next)
    }

    /// The next small sector of every one.
    fn small_table(&self, entry: &StreamEntry) -> Result<Vec<u32>, ReadError> {
        let mut table = Vec::new();
        let mut at = self.file.u32(60)?;
        for _ in 0..self.count() {
            if at >= END {
                return Ok(table);
            }
            table.extend(numbers(self.sector(at, self.sector)?));
            at = self.next(at)?;
        }
        Err(self.broken(entry))
    }

    /// A stream in sectors.
    fn read(&self, entry: &StreamEntry) -> Result<Vec<u8>, ReadError> {
        if entry.length > self.file.data.len() as u64 {
            let what = format!("{} bytes are more than the file has", entry.length);
            return Err(self.file.field(entry.name.clone(), what));
        }
        let next = |at| {
            let next = self.next(at)?;
            if next < END { Ok(next) } else { Err(self.broken(entry)) }
        };
        collect(entry, self.sector, |at, length| self.sector(at, length), next)
    }

    fn broken(&self, entry: &StreamEntry) -> ReadError {
        self.file.field(entry.name.clone(), "its sectors end early, or never")
    }

    /// Sectors that the file has room for.
    fn count(&self) -> usize {
        self.file.data.len() / self.sector
    }

    /// The first bytes of a sector.
    fn sector(&self, number: u32, length: usize) -> Result<&'a [u8], ReadError> {
        self.file.slice((number as usize).saturating_add(1).saturating_mul(self.sector), length)
    }

    /// The sector after this one.
    fn next(&self, number: u32) -> Result<u32, ReadError> {
        let per_sector = self.sector / 4;
        let held = self.table.get(number as usize / per_sector).ok_or_else(|| {
            self.file.field("sector table", format!("does not reach to sector {number}"))
        })?;
        let raw = self.sector(*held, self.sector)?;
        self.file.with(raw).u32(4 * (number as usize % per_sector))
    }

    fn read_table(&mut self) -> Result<(), ReadError> {
        let sectors: Vec<u32> = numbers(self.file.slice(76, 4 * 109)?).collect();
        let mut at = self.file.u32(68)?;
        self.table.extend(sectors.into_iter().take_while(|&number| number < END));
        // Each sector of the further list ends with the number of the next one.
        for _ in 0..=self.count() {
            if at >= END {
                return Ok(());
            }
            let list = self.sector(at, self.sector)?;
            let mut list: Vec<u32> = numbers(list).collect();
            at = list.pop().unwrap_or(END);
            self.table.extend(list.into_iter().take_while(|&number| number < END));
            if self.table.len() > self.count() {
                break;
            }
        }
        Err(self.file.field("sector table", "has more sectors than the file"))
    }

    fn read_directory(&mut self) -> Result<(), ReadError> {
        let mut at = self.file.u32(48)?;
        for _ in 0..self.count() {
            if at >= END {
                return Ok(());
            }
            for raw in self.sector(at, self.sector)?.chunks_exact(ENTRY) {
                let entry = self.file.with(raw);
                let kind = entry.u8(66)?;
                if !matches!(kind, 2 | 5) {
                    continue;
                }
                let bytes = usize::from(entry.u16(64)?).clamp(2, 64) - 2;
                let mut length = entry.u64(120)?;
                if self.sector == 512 {
                    length &= 0xffff_ffff;
                }
                let (name, start) = (utf16(&raw[..bytes], u16::from_le_bytes), entry.u32(116)?);
                self.entries.push(StreamEntry { name, kind, start, length });
            }
            at = self.next(at)?;
        }
        Err(self.file.field("directory", "its sectors never end"))
    }
}

/// The bytes of a stream, from pieces of `size` bytes, of which each has a next one.
fn collect<'a>(
    entry: &StreamEntry,
    size: usize,
    piece: impl Fn(u32, usize) -> Result<&'a [u8], ReadError>,
    next: impl Fn(u32) -> Result<u32, ReadError>,
) -> Result<Vec<u8>, ReadError> {
    let (mut at, length) = (entry.start, entry.length as usize);
    let mut stream = Vec::new(); // grows with what is there, whatever the directory claims
    while stream.len() < length {
        stream.extend_from_slice(piece(at, size.min(length - stream.len()))?);
        if stream.len() < length {
            at = next(at)?;
        }
    }
    Ok(stream)
}

fn numbers(raw: &[u8]) -> impl Iterator<Item = u32> + '_ {
    raw.chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]))
}
