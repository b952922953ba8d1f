//! Superblock, addresses, the messages of an object's header, and the tree of groups.

use crate::binary::Bytes;
use crate::error::ReadError;

const LINK_INFO: u16 = 0x02;
pub(super) const LAYOUT: u16 = 0x08;
const LINK: u16 = 0x06;
const SYMBOL_TABLE: u16 = 0x11;

type Paths = Vec<(String, usize)>;

/// Groups within groups beyond this are refused.
const DEEPEST: usize = 32;

/// What to do about a file of a newer form.
pub(super) const WAY_OUT: &str = "`h5repack -f NONE -l CONTI IN OUT` writes the form that is";

/// Points of these sides; the largest number where there are more.
pub(super) fn points(sides: &[usize]) -> usize {
    sides.iter().copied().fold(1, usize::saturating_mul)
}

pub(super) const MAGIC: &[u8] = b"\x89HDF\r\n\x1a\n";

pub(crate) fn superblock(bytes: &[u8]) -> Option<usize> {
    let starts = |&at: &usize| bytes.get(at..).is_some_and(|rest| rest.starts_with(MAGIC));
    [0, 512, 1024, 2048].into_iter().find(starts)
}

#[derive(Debug, Clone, Copy)]
pub(crate) struct File<'a> {
    /// From the superblock on, which addresses count from.
    pub(crate) b: Bytes<'a>,
    /// Bytes of an address and of a length.
    pub(crate) address_size: usize,
    pub(crate) length_size: usize,
    /// Address of the header of the root group.
    pub(crate) root: usize,
}

#[derive(Debug, Clone, Copy)]
pub(crate) struct Message {
    pub(crate) kind: u16,
    pub(crate) at: usize,
}

impl<'a> File<'a> {
    pub(crate) fn open(whole: Bytes<'a>) -> Result<Self, ReadError> {
        let start = superblock(whole.data);
        let b = whole.from(start.ok_or_else(|| whole.fault(0, "there is no superblock"))?)?;
        let version = b.u8(8)?;
        // Where the sizes are; the root group stands behind so many bytes and addresses.
        let (sizes, bytes, addresses) = match version {
            0 => (13, 24, 5),
            1 => (13, 28, 5),
            2 | 3 => (9, 12, 3),
            _ => {
                return Err(b.unsupported(format!("a superblock of version {version} ({WAY_OUT})")));
            }
        };
        let (address_size, length_size) = (b.u8(sizes)?.into(), b.u8(sizes + 1)?.into());
        if !matches!((address_size, length_size), (2 | 4 | 8, 2 | 4 | 8)) {
            return Err(b.fault(sizes, format!("sizes {address_size} and {length_size}")));
        }
        let mut file = Self { b, address_size, length_size, root: 0 };
        file.root = file.address(bytes + addresses * address_size)?.unwrap_or(usize::MAX);
        Ok(file)
    }

    /// A number of at most 8 bytes; one that no place in memory has becomes the largest that one has.
    pub(crate) fn unsigned(&self, at: usize, size: usize) -> Result<usize, ReadError> {
        let raw = self.b.slice(at, size)?;
        let value = raw.iter().rev().fold(0u64, |value, &byte| value << 8 | u64::from(byte));
        Ok(usize::try_from(value).unwrap_or(usize::MAX))
    }

    /// An address; `None` if it is the mark for none.
    pub(crate) fn address(&self, at: usize) -> Result<Option<usize>, ReadError> {
        let is_none = self.b.slice(at, self.address_size)?.iter().all(|&byte| byte == 0xff);
        self.unsigned(at, self.address_size).map(|place| Some(place).filter(|_| !is_none))
    }

    pub(crate) fn length(&self, at: usize) -> Result<usize, ReadError> {
        self.unsigned(at, self.length_size)
    }

    /// All messages of the object whose header is at `at`.
    pub(crate) fn messages(&self, at: usize) -> Result<Vec<Message>, ReadError> {
        let is_new = self.b.slice(at, 4)? == b"OHDR";
        let (mut blocks, flags) = if is_new {
            let flags = self.b.u8(at + 5)?;
            let times = if flags & 0x20 != 0 { 16 } else { 0 };
            let phase = if flags & 0x10 != 0 { 4 } else { 0 };
            let size_at = at + 6 + times + phase;
            let width = 1 << (flags & 3);
            (vec![(size_at + width, self.unsigned(size_at, width)?)], flags)
        } else {
            if self.b.u8(at)? != 1 {
                return Err(self.b.fault(at, "an object header is expected here"));
            }
            (vec![(at + 16, self.b.u32(at + 8)? as usize)], 0)
        };
        let mut messages = Vec::new();
        let mut read = 0;
        while let Some((mut at, size)) = blocks.pop() {
            let end = at.checked_add(size);
            let end = end.ok_or_else(|| self.b.fault(at, "a header without end"))?;
            let head = if !is_new {
                8
            } else if flags & 4 != 0 {
                6
            } else {
                4
            };
            while at.saturating_add(head) <= end {
                read += 1;
                self.b.check_items(read)?;
                let (kind, size, shared) = if is_new {
                    (u16::from(self.b.u8(at)?), self.b.u16(at + 1)?, self.b.u8(at + 3)?)
                } else {
                    (self.b.u16(at)?, self.b.u16(at + 2)?, self.b.u8(at + 4)?)
                };
                let message = Message { kind, at: at + head };
                self.b.slice(message.at, size.into())?;
                at = message.at + usize::from(size);
                match kind {
                    0 => {}
                    // The header goes on elsewhere; new blocks have a name and a checksum.
                    0x10 => {
                        let Some(next) = self.address(message.at)? else { continue };
                        let length = self.length(message.at + self.address_size)?;
                        let (skip, end) = if is_new { (4, 8) } else { (0, 0) };
                        blocks.push((next.saturating_add(skip), length.saturating_sub(end)));
                    }
                    _ if shared & 2 != 0 => messages.extend(self.shared(message)?),
                    _ => messages.push(message),
                }
            }
        }
        Ok(messages)
    }

    /// A message that stands in the header of another object: a committed data type.
    fn shared(&self, message: Message) -> Result<Option<Message>, ReadError> {
        let place = match self.b.u8(message.at)? {
            1 => 8,
            _ => 2,
        };
        let Some(at) = self.address(message.at + place)? else { return Ok(None) };
        // Only the first level: shared messages do not point at shared messages.
        if self.b.slice(at, 4)? == b"OHDR" {
            let feature = format!("a shared message in a header of version 2 ({WAY_OUT})");
            return Err(self.b.unsupported(feature));
        }
        let mut at = at + 16;
        for _ in 0..16 {
            let (kind, size) = (self.b.u16(at)?, usize::from(self.b.u16(at + 2)?));
            if kind == message.kind {
                self.b.slice(at + 8, size)?;
                return Ok(Some(Message { kind, at: at + 8 }));
            }
            at += 8 + size;
        }
        Ok(None)
    }
}

/// Path and address of every data set, in the order of the file, and the first reason why a group
/// could not be listed.
pub(crate) fn datasets(file: &File<'_>) -> Result<(Paths, Option<ReadError>), ReadError> {
    let (mut datasets, mut fault) = (Paths::new(), None);
    let mut seen = std::collections::HashSet::new();
    // Depth first, children in order: the last one is put on the pile first.
    let mut pile = vec![(String::new(), file.root, 0)];
    while let Some((path, at, depth)) = pile.pop() {
        if !seen.insert(at) {
            continue; // a second name, or a circle
        }
        file.b.check_items(seen.len() as u64)?;
        if depth > DEEPEST {
            return Err(file.b.fault(at, format!("groups nested deeper than {DEEPEST}")));
        }
        let messages = file.messages(at)?;
        if messages.iter().any(|message| message.kind == LAYOUT) {
            datasets.push((path, at));
            continue;
        }
        let mut links = Vec::new();
        for message in &messages {
            match message.kind {
                SYMBOL_TABLE => symbol_table(file, message.at, &mut links)?,
                LINK => links.extend(link(file, *message)?),
                LINK_INFO if is_dense(file, *message)? => {
                    fault.get_or_insert_with(|| {
                        file.b.unsupported(format!(
                            "group {path:?}, whose links stand in a fractal heap ({WAY_OUT})"
                        ))
                    });
                }
                _ => {}
            }
        }
        for (name, address) in links.into_iter().rev() {
            let separator = if path.is_empty() { "" } else { "/" };
            pile.push((format!("{path}{separator}{name}"), address, depth + 1));
        }
        file.b.check_items(pile.len() as u64)?;
    }
    Ok((datasets, fault))
}

fn is_dense(file: &File<'_>, message: Message) -> Result<bool, ReadError> {
    let indices = if file.b.u8(message.at + 1)? & 1 != 0 { 8 } else { 0 };
    Ok(file.address(message.at + 2 + indices)?.is_some())
}

/// Name and address of a link in the header; soft and external links are left out.
fn link(file: &File<'_>, message: Message) -> Result<Option<(String, usize)>, ReadError> {
    let flags = file.b.u8(message.at + 1)?;
    let mut at = message.at + 2;
    let kind = if flags & 8 != 0 { file.b.u8(at)? } else { 0 };
    at += usize::from(flags & 8 != 0) + 8 * usize::from(flags & 4 != 0);
    at += usize::from(flags & 0x10 != 0);
    let width = 1 << (flags & 3);
    let length = file.unsigned(at, width)?;
    let name = file.b.text(at + width, length)?;
    if kind != 0 {
        return Ok(None);
    }
    Ok(file.address((at + width).saturating_add(length))?.map(|address| (name, address)))
}

/// Links of a group of the older form: a B-tree of nodes of symbols, names in a local heap.
fn symbol_table(file: &File<'_>, at: usize, links: &mut Paths) -> Result<(), ReadError> {
    let (Some(tree), Some(heap)) = (file.address(at)?, file.address(at + file.address_size)?)
    else {
        return Ok(());
    };
    if file.b.slice(heap, 4)? != b"HEAP" {
        return Err(file.b.fault(heap, "a local heap is expected here"));
    }
    let names = file.address(heap + 8 + 2 * file.length_size)?.unwrap_or(usize::MAX);
    let mut nodes = vec![tree];
    let mut read = 0;
    while let Some(node) = nodes.pop() {
        read += 1;
        file.b.check_items(read)?;
        if file.b.slice(node, 4)? == b"TREE" {
            let count = usize::from(file.b.u16(node + 6)?);
            let first = node + 8 + 2 * file.address_size;
            let step = file.length_size + file.address_size;
            for i in (0..count).rev() {
                nodes.extend(file.address(first + i * step + file.length_size)?);
            }
            file.b.check_items(nodes.len() as u64)?;
            continue;
        }
        if file.b.slice(node, 4)? != b"SNOD" {
            return Err(file.b.fault(node, "a node of symbols is expected here"));
        }
        for i in 0..usize::from(file.b.u16(node + 6)?) {
            let entry = node + 8 + i * (2 * file.address_size + 24);
            let name = names.saturating_add(file.unsigned(entry, file.address_size)?);
            // Names end with a zero; longer ones than this are none.
            let rest = file.b.from(name)?.data;
            let name = crate::binary::text(&rest[..rest.len().min(1024)]);
            file.b.check_items(links.len() as u64 + 1)?;
            if let Some(address) = file.address(entry + file.address_size)? {
                links.push((name, address));
            }
        }
    }
    Ok(())
}
