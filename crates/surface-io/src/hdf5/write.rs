//! Fields on a grid as HDF5: one contiguous data set for each, in the root group.
//!
//! The smallest form that every HDF5 library since 1.8 reads: superblock of version 2, headers of version 2 with
//! links and attributes in them, numbers as f64 in little endian.
//!
//! Source: The HDF Group, *HDF5 File Format Specification Version 3.0*, sections II.A, IV.A.1.b, IV.A.2.

use super::file::MAGIC;
use contact_types::Grid;
use std::io::{self, Write};

/// Bytes of the superblock, behind which the root group is.
const SUPERBLOCK: u64 = 48;
const NOWHERE: u64 = u64::MAX;

/// Writes HDF5: each field as a data set `[ny, nx]` of f64, by its name, with the attributes `unit`, `pixel` ([dy, dx])
/// and `pixel_unit` (m); `comment` becomes an attribute of the file, unless it is empty. A field is a name, its unit
/// and its values. No date is written, so equal fields give equal files.
///
/// [`read`](crate::read) takes a length written so to the same bits, pixel size included.
///
/// # Errors
/// Whatever `out` reports; `InvalidInput` if a field has not `ny nx` values, a name is empty, not of ASCII, has a
/// slash or is longer than 255 characters, or the comment has more than 60 000 bytes.
pub fn hdf5(
    out: &mut impl Write,
    grid: Grid,
    fields: &[(&str, &str, &[f64])],
    comment: &str,
) -> io::Result<()> {
    check(grid, fields, comment)?;
    let header = |(_, unit, _): &(&str, &str, &[f64]), data| dataset(grid, unit, data);
    let root_length = root(fields, &vec![NOWHERE; fields.len()], comment).len() as u64;
    let mut at = SUPERBLOCK + root_length;
    let mut headers = Vec::new();
    for field in fields {
        headers.push(at);
        at += header(field, NOWHERE).len() as u64;
    }
    let first = at.next_multiple_of(8);
    let bytes = 8 * grid.len() as u64;
    let end = first + bytes * fields.len() as u64;

    let mut superblock = MAGIC.to_vec();
    superblock.extend([2, 8, 8, 0]); // version, bytes of an offset, of a length, no flags
    for address in [0, NOWHERE, end, SUPERBLOCK] {
        superblock.extend(address.to_le_bytes()); // base, no extension, end of file, root group
    }
    out.write_all(&sealed(superblock))?;
    out.write_all(&root(fields, &headers, comment))?;
    for (i, field) in fields.iter().enumerate() {
        out.write_all(&header(field, first + bytes * i as u64))?;
    }
    out.write_all(&vec![0; (first - at) as usize])?;
    for (_, _, values) in fields {
        crate::write::numbers(out, values)?;
    }
    Ok(())
}

fn check(grid: Grid, fields: &[(&str, &str, &[f64])], comment: &str) -> io::Result<()> {
    let refused = |what: String| Err(crate::write::invalid(what));
    let [ny, nx] = grid.shape();
    for (name, unit, values) in fields {
        if values.len() != grid.len() {
            return refused(format!("{name}: {} values for {ny} x {nx} points", values.len()));
        }
        let is_name = (1..=255).contains(&name.len()) && name.is_ascii() && !name.contains('/');
        if !is_name || unit.len() > 255 {
            return refused(format!("{name:?} in {unit:?} is no name and unit of a data set"));
        }
    }
    match comment.len() {
        0..=60_000 => Ok(()),
        n => refused(format!("a comment of {n} bytes, at most 60000 fit")),
    }
}

/// The header of the root group: links to the data sets.
fn root(fields: &[(&str, &str, &[f64])], headers: &[u64], comment: &str) -> Vec<u8> {
    let mut messages = HeaderMessages::default();
    let nowhere = NOWHERE.to_le_bytes();
    messages.add(0x02, &[&[0, 0], &nowhere[..], &nowhere]); // link info: no heap, no tree
    messages.add(0x0a, &[&[0, 0]]); // group info
    for ((name, ..), address) in fields.iter().zip(headers) {
        let length = name.len() as u8; // at most 255, see `check`
        messages.add(0x06, &[&[1, 0, length], name.as_bytes(), &address.to_le_bytes()]);
    }
    messages.text("comment", comment);
    messages.header()
}

/// The header of a data set whose numbers are at `data`.
fn dataset(grid: Grid, unit: &str, data: u64) -> Vec<u8> {
    let shape = grid.shape().map(|n| (n as u64).to_le_bytes());
    let bytes = 8 * grid.len() as u64;
    let mut messages = HeaderMessages::default();
    messages.add(0x01, &[&[2, 2, 0, 1], &shape[0], &shape[1]]); // dataspace: two axes, fixed
    messages.add(0x03, &[&F64]);
    messages.add(0x05, &[&[3, 0x0a]]); // fill value: not defined
    messages.add(0x08, &[&[3, 1], &data.to_le_bytes(), &bytes.to_le_bytes()]); // contiguous
    messages.text("unit", unit);
    let [dy, dx] = grid.pixel().map(f64::to_le_bytes);
    messages.attribute(
        "pixel",
        &F64,
        &[&[2, 1, 0, 1], &2u64.to_le_bytes()[..]].concat(),
        &[dy, dx].concat(),
    );
    messages.text("pixel_unit", "m");
    messages.header()
}

/// The type of IEEE f64, little endian: class 1; sign at bit 63; size; offset and precision; place and size of
/// exponent and mantissa; bias.
const F64: [u8; 20] = [0x11, 0x20, 63, 0, 8, 0, 0, 0, 0, 0, 64, 0, 52, 11, 0, 52, 0xff, 0x03, 0, 0];

/// Messages of an object header of version 2.
#[derive(Default)]
struct HeaderMessages(Vec<u8>);

impl HeaderMessages {
    fn add(&mut self, kind: u8, parts: &[&[u8]]) {
        let body = parts.concat();
        self.0.push(kind);
        self.0.extend((body.len() as u16).to_le_bytes()); // below 64 kB, see `check`
        self.0.push(0);
        self.0.extend(body);
    }

    fn attribute(&mut self, name: &str, kind: &[u8], space: &[u8], value: &[u8]) {
        let mut head = vec![3, 0]; // version, no flags
        for length in [name.len() + 1, kind.len(), space.len()] {
            head.extend((length as u16).to_le_bytes());
        }
        head.push(0); // ASCII
        self.add(0x0c, &[&head, name.as_bytes(), &[0], kind, space, value]);
    }

    /// An attribute of UTF-8, of the length it needs; none for no text.
    fn text(&mut self, name: &str, text: &str) {
        if !text.is_empty() {
            let length = (text.len() as u32).to_le_bytes();
            let kind = [&[0x13, 0x11, 0, 0], &length[..]].concat(); // padded with zeros, UTF-8
            self.attribute(name, &kind, &[2, 0, 0, 0], text.as_bytes());
        }
    }

    fn header(self) -> Vec<u8> {
        let mut header = b"OHDR\x02\x02".to_vec(); // version; four bytes for the size
        header.extend((self.0.len() as u32).to_le_bytes());
        header.extend(self.0);
        sealed(header)
    }
}

/// With its checksum behind it.
fn sealed(mut block: Vec<u8>) -> Vec<u8> {
    let sum = lookup3(&block);
    block.extend(sum.to_le_bytes());
    block
}

/// Jenkins's hash lookup3 (`hashlittle` with 0 to start from), the checksum of HDF5's metadata.
/// Source: B. Jenkins, *lookup3.c*, 2006, public domain, <http://burtleburtle.net/bob/c/lookup3.c>.
fn lookup3(bytes: &[u8]) -> u32 {
    let mut s = [0xdead_beef_u32.wrapping_add(bytes.len() as u32); 3];
    if bytes.is_empty() {
        return s[2];
    }
    let last = (bytes.len() - 1) / 12; // the last block, also a full one, is mixed in another way
    for (i, block) in bytes.chunks(12).enumerate() {
        for (word, part) in s.iter_mut().zip(block.chunks(4)) {
            let mut four = [0; 4];
            four[..part.len()].copy_from_slice(part);
            *word = word.wrapping_add(u32::from_le_bytes(four));
        }
        if i < last {
            // a -= c, a ^= c rotated, c += b, and around
            for (k, turn) in [4, 6, 8, 16, 19, 4].into_iter().enumerate() {
                let [a, b, c] = [k % 3, (k + 1) % 3, (k + 2) % 3];
                s[a] = s[a].wrapping_sub(s[c]) ^ s[c].rotate_left(turn);
                s[c] = s[c].wrapping_add(s[b]);
            }
        } else {
            // c ^= b, c -= b rotated, and around
            for (k, turn) in [14, 11, 25, 16, 4, 14, 24].into_iter().enumerate() {
                let [c, b] = [(k + 2) % 3, (k + 1) % 3];
                s[c] = (s[c] ^ s[b]).wrapping_sub(s[b].rotate_left(turn));
            }
        }
    }
    s[2]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ReadOptions, read_bytes};

    /// What the driver of lookup3.c prints.
    #[test]
    fn lookup3_of_its_author() {
        assert_eq!(lookup3(b""), 0xdead_beef);
        assert_eq!(lookup3(b"Four score and seven years ago"), 0x1777_0551);
    }

    /// h5py 3.16 (HDF5 1.14) read the same numbers and attributes from a file of `solve --maps`.
    #[test]
    fn comes_back_to_the_bit() {
        let grid = Grid::new([2, 3], [2e-6, 1e-6]).unwrap();
        let heights = [1e-9, 2e-9, -3e-9, 4e-9, 1.0 / 3.0, 6e-9];
        let mut file = Vec::new();
        hdf5(&mut file, grid, &[("height", "m", &heights), ("pressure", "Pa", &[0.5; 6])], "a µ")
            .unwrap();
        let found = read_bytes(&file, &ReadOptions::default()).unwrap();
        assert_eq!((found.grid(), found.heights()), (grid, &heights[..]));
        assert_eq!(found.channels.len(), 2);
        assert_eq!(found.channels[1].unit.as_deref(), Some("Pa"));
    }

    #[test]
    fn what_cannot_be_written_is_refused() {
        let grid = Grid::new([2, 2], [1e-6; 2]).unwrap();
        let try_it = |name: &str, n: usize, comment: &str| {
            hdf5(&mut Vec::new(), grid, &[(name, "m", &vec![0.0; n])], comment).is_err()
        };
        assert!(!try_it("a", 4, ""));
        assert!(try_it("a", 3, "") && try_it("", 4, "") && try_it("a/b", 4, ""));
        assert!(try_it("a", 4, &"x".repeat(60_001)));
    }
}
