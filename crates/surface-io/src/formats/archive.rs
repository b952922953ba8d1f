//! ZIP containers: X3P, NPZ, PLUX and workbooks are archives, and users zip (and gzip) single files.
//!
//! Nothing is unpacked beyond [`Limits::unpacked_bytes`](crate::Limits::unpacked_bytes), whatever the archive claims.

use crate::binary::{Bytes, find};
use crate::error::ZIP;
use crate::{ReadError, ReadOptions};
use std::borrow::Cow;
use std::io::{Cursor, Read};
use zip::ZipArchive;

const MAGIC: &[u8] = b"PK\x03\x04";

/// True for an archive with a name like this, which stands uncompressed in it, also in a damaged one.
pub(crate) fn holds(bytes: &[u8], name: &[u8]) -> bool {
    bytes.starts_with(MAGIC) && find(bytes, name).is_some()
}

pub(crate) struct Archive<'a> {
    pub(crate) b: Bytes<'a>,
    zip: ZipArchive<Cursor<&'a [u8]>>,
    /// Bytes unpacked so far.
    total: u64,
    /// Names of all members that are files, in the order of the directory.
    pub(crate) names: Vec<String>,
}

impl<'a> Archive<'a> {
    pub(crate) fn open(b: Bytes<'a>) -> Result<Self, ReadError> {
        let zip =
            ZipArchive::new(Cursor::new(b.data)).map_err(|e| b.field("archive", e.to_string()))?;
        b.check_items(zip.len() as u64)?;
        let names = zip.file_names().filter_map(Result::ok).map(Cow::into_owned);
        let names = names.filter(|n| !n.ends_with('/') && !is_by_the_way(n)).collect();
        Ok(Self { b, zip, total: 0, names })
    }

    /// Unpacks a member; all together may not have more bytes than the limit.
    pub(crate) fn unpack(&mut self, name: &str) -> Result<Vec<u8>, ReadError> {
        let Bytes { data, format, options: &ReadOptions { limits, .. }, .. } = self.b;
        let member = self.zip.by_name(name);
        let member = member.map_err(|e| ReadError::at(format, "archive", e.to_string()))?;
        limits.check_unpacked(format, self.total.saturating_add(member.size()))?;
        // The size in the directory is a claim: read no more than the limit, and reserve no more
        // than deflate can make of the packed bytes (1032 : 1).
        let likely = member.size().min(member.compressed_size().saturating_mul(1032));
        let mut unpacked = Vec::with_capacity(likely.min(data.len() as u64 * 1032) as usize);
        member
            .take((limits.unpacked_bytes - self.total).saturating_add(1))
            .read_to_end(&mut unpacked)
            .map_err(|e| ReadError::at(format, name.to_owned(), e.to_string()))?;
        self.total += unpacked.len() as u64;
        limits.check_unpacked(format, self.total)?;
        Ok(unpacked)
    }
}

/// The single file in a ZIP archive that is no format of its own, or in a gzip file; any other
/// bytes as they are. Of a packed VK6 or VK7 the VK4 in it.
pub(crate) fn unwrap_single<'a>(
    bytes: &'a [u8],
    options: &ReadOptions,
) -> Result<Cow<'a, [u8]>, ReadError> {
    let inner = unwrap_one(bytes, options)?;
    if !super::vk::is_packed(&inner) {
        return Ok(inner);
    }
    let packed = Bytes::little(&inner, "Keyence VK", options);
    Archive::open(packed)?.unpack("Vk4File").map(Cow::Owned)
}

fn unwrap_one<'a>(bytes: &'a [u8], options: &ReadOptions) -> Result<Cow<'a, [u8]>, ReadError> {
    if bytes.starts_with(b"\x1f\x8b") {
        let gzip = flate2::read::MultiGzDecoder::new(bytes);
        let unpacked =
            crate::unpack::read("", gzip, options.limits.unpacked_bytes.saturating_add(1))
                .map_err(|what| ReadError::at(ZIP, "gzip data", what))?;
        options.limits.check_unpacked(ZIP, unpacked.len() as u64)?;
        return Ok(Cow::Owned(unpacked));
    }
    if !bytes.starts_with(MAGIC) {
        return Ok(Cow::Borrowed(bytes));
    }
    let Ok(mut archive) = Archive::open(Bytes::little(bytes, ZIP, options)) else {
        return Ok(Cow::Borrowed(bytes)); // the reader of the inner format names the fault
    };
    let is_ours = |name: &String| {
        ends(name, ".npy")
            || ends(name, ".oir")
            || is_main_xml(name)
            || matches!(&name[..], "xl/workbook.xml" | "index.xml")
    };
    if archive.names.iter().any(is_ours) {
        return Ok(Cow::Borrowed(bytes));
    }
    match &archive.names[..] {
        [name] => archive.unpack(&name.clone()).map(Cow::Owned),
        names => {
            let shown: Vec<&str> = names.iter().take(4).map(String::as_str).collect();
            let feature = format!(
                "an archive of {} files ({}{}); unpack it and name one of them",
                names.len(),
                shown.join(", "),
                if names.len() > 4 { ", ..." } else { "" }
            );
            Err(ReadError::unsupported(ZIP, feature))
        }
    }
}

/// What operating systems leave in archives.
fn is_by_the_way(name: &str) -> bool {
    name.split('/').any(|part| part == "__MACOSX" || part.starts_with('.'))
}

/// True if a name ends so, in small or capital letters.
pub(crate) fn ends(name: &str, with: &str) -> bool {
    name.to_ascii_lowercase().ends_with(with)
}

pub(crate) fn is_main_xml(name: &str) -> bool {
    name.rsplit('/').next().is_some_and(|file| file.eq_ignore_ascii_case("main.xml"))
}
