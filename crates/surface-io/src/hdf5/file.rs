//! Superblock, addresses, and the messages of an object's header.

use crate::binary::Bytes;
use crate::error::ReadError;

/// What to do about a file of a newer form.
pub(super) const WAY_OUT: &str = "`h5repack -f NONE -l CONTI IN OUT` writes the form that is";

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
    pub(crate) size: usize,
}

impl<'a> File<'a> {
    pub(crate) fn open(whole: Bytes<'a>) -> Result<Self, ReadError> {
        let start = superblock(whole.data);
        let b = whole.from(start.ok_or_else(|| whole.fault(0, "there is no superblock"))?)?;
        let version = b.u8(8)?;
        let (sizes, root_at): (usize, fn(usize, usize) -> usize) = match version {
            0 => (13, |address, _| 24 + 5 * address),
            1 => (13, |address, _| 28 + 5 * address),
            2 | 3 => (9, |address, _| 12 + 3 * address),
            _ => {
                return Err(b.unsupported(format!("a superblock of version {version} ({WAY_OUT})")));
            }
        };
        let (address_size, length_size) = (b.u8(sizes)?.into(), b.u8(sizes + 1)?.into());
        if !matches!((address_size, length_size), (2 | 4 | 8, 2 | 4 | 8)) {
            return Err(b.fault(sizes, format!("sizes {address_size} and {length_size}")));
        }
        let mut file = Self { b, address_size, length_size, root: 0 };
        file.root = file.address(root_at(address_size, length_size))?.unwrap_or(usize::MAX);
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
            let head = match (is_new, flags & 4 != 0) {
                (false, _) => 8,
                (true, false) => 4,
                (true, true) => 6,
            };
            while at.saturating_add(head) <= end {
                read += 1;
                self.b.check_items(read)?;
                let (kind, size, shared) = if is_new {
                    (u16::from(self.b.u8(at)?), self.b.u16(at + 1)?, self.b.u8(at + 3)?)
                } else {
                    (self.b.u16(at)?, self.b.u16(at + 2)?, self.b.u8(at + 4)?)
                };
                let message = Message { kind, at: at + head, size: size.into() };
                self.b.slice(message.at, message.size)?;
                at = message.at + message.size;
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
                return Ok(Some(Message { kind, at: at + 8, size }));
            }
            at += 8 + size;
        }
        Ok(None)
    }
}
