//! The tree of groups: every data set with its path.

use super::file::{File, Message, WAY_OUT};
use crate::error::ReadError;

const LINK_INFO: u16 = 0x02;
const LAYOUT: u16 = 0x08;
const LINK: u16 = 0x06;
const SYMBOL_TABLE: u16 = 0x11;

/// Groups within groups beyond this are refused.
const DEEPEST: usize = 32;

/// Path and address of every data set, in the order of the file, and the first reason why a group
/// could not be listed.
#[derive(Debug, Default)]
pub(crate) struct Listing {
    pub(crate) datasets: Vec<(String, usize)>,
    pub(crate) fault: Option<ReadError>,
}

pub(crate) fn datasets(file: &File<'_>) -> Result<Listing, ReadError> {
    let mut listing = Listing::default();
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
            listing.datasets.push((path, at));
            continue;
        }
        let mut links = Vec::new();
        for message in &messages {
            match message.kind {
                SYMBOL_TABLE => symbol_table(file, message.at, &mut links)?,
                LINK => links.extend(link(file, *message)?),
                LINK_INFO if is_dense(file, *message)? => {
                    listing.fault.get_or_insert_with(|| {
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
    Ok(listing)
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
fn symbol_table(
    file: &File<'_>,
    at: usize,
    links: &mut Vec<(String, usize)>,
) -> Result<(), ReadError> {
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
