//! OIR of Olympus laser microscopes (OLS5000 and later), and POIR, a ZIP archive of such files.
//!
//! | byte | type | content |
//! |---|---|---|
//! | 0 | 16 | `OLYMPUSRAWFORMAT` |
//! | 72 | 8 | `UNKNOWN`, where microscopes of another family write `FLUOVIEW` |
//! | 96 | | chunks, until one of size −1 |
//!
//! | chunk | content |
//! |---|---|
//! | i32, i32 | bytes behind these two numbers; kind |
//! | kind 0 | blocks, one behind the other: u32 kind, 32 bytes, then texts as `BLOCKS` lists them |
//! | kind 3 | u32 0, u32 length of the data, text: name of the data; *behind* the chunk u32 the length again, u32 4, the data |
//! | others | passed over: blocks of a single frame, pictures, nothing |
//!
//! A text is its length, u32, and as many bytes. Block 2 is XML: of each `channel`, whose attribute is its id, in
//! `imageInfo/phase/group`
//!
//! | element | content |
//! |---|---|
//! | `imageDefinition/imageType`, `bitCounts` | `HEIGHT`; 16 |
//! | `length/x`, `y`, `z` | size of a pixel, height of a step |
//! | `pixelUnit/x`, `y`, `z` | their units |
//! | `imageInfo/width`, `height` | points along x, along y |
//! | `acquisition/microscopeConfiguration/pixelCalibration/x`, `y` | factors on the size of a pixel; 1 if missing |
//!
//! The only name in block 6, the id and the number of a piece, with `_` between them, name the
//! data: u16, little endian, in rows. A calibration of the heights (`pixelCalibration/z`) is listed
//! with the metadata and not applied, as the reader this is known from does.
//!
//! Source: SurfaceTopography (an open reader). Not checked against a real file.

use super::archive::ends;
use super::prelude::*;

pub(crate) const MAGIC: &[u8] = b"OLYMPUSRAWFORMAT";
const FIRST_CHUNK: usize = 96;

/// What the blocks of a kind hold, in their order: `t` a text, `w` four bytes; a `*` in front: a count u32 of such entries.
const BLOCKS: [&str; 15] =
    ["", "t", "t", "t", "t", "*tt", "*tw", "*tw", "*tw", "*wtt", "*twtt", "*tt", "*tw", "*tw", "t"];
const PROPERTIES: usize = 2;
const PREFIX: usize = 6;

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let mut contents = Contents::default();
    if b.data.starts_with(MAGIC) {
        add(b, &mut contents, "")?;
        return Ok(contents);
    }
    let mut archive = Archive::open(b)?;
    for name in archive.names.clone().into_iter().filter(|name| ends(name, ".oir")) {
        let member = archive.unpack(&name)?;
        // A member that cannot be read must not cost the others.
        if let Err(fault) = add(b.with(&member), &mut contents, &name) {
            contents.add(&name, Err(fault));
        }
    }
    Ok(contents)
}

/// Adds the channels of one file; `member` is its name in an archive.
fn add(b: Bytes<'_>, contents: &mut Contents<'_>, member: &str) -> Result<(), ReadError> {
    let parts = FileParts::of(b)?;
    let (channels, fields) = properties(b.with(parts.properties))?;
    let image = Entries::new(b, &fields);
    let side = |key: &str| image.parsed::<usize>(key, "size");
    let shape = [side("imageInfo/height")?, side("imageInfo/width")?];
    b.check_points(shape)?;
    for (id, fields) in channels {
        let own = Entries::new(b, &fields);
        let kind = own.get("imageDefinition/imageType").unwrap_or("Picture");
        let name = format!("{member}{}{kind}", if member.is_empty() { "" } else { ": " });
        let channel = (|| {
            let [y, x, z] = ["y", "x", "z"].map(|axis| scale(b, own, image, axis));
            let (pixel, step) = (Pixel::Metres([y?, x?]), z?);
            let bits = own.get("imageDefinition/bitCounts").unwrap_or("an unknown number of");
            if bits != "16" {
                return Err(b.unsupported(format!("data of {bits} bits")));
            }
            let raw = parts.data_of(b, &id, 2 * shape[0] * shape[1])?;
            let (unit, factor) = if kind == "HEIGHT" { ("m", step) } else { ("counts", 1.0) };
            let decode = move || Ok(Sample::U16.decode(&raw, ByteOrder::Little));
            let channel = Channel::new(name.as_str(), Some(unit), shape, pixel, decode);
            Ok(channel.converted(move |raw| raw * factor))
        })();
        contents.add(&name, channel);
    }
    let calibration = "acquisition/microscopeConfiguration/pixelCalibration/z";
    for (key, path) in [
        ("date", "general/creationDateTime"),
        ("instrument", "microscope/name"),
        ("height calibration, not applied", calibration),
    ] {
        if let Some(text) = image.get(path) {
            contents.metadata.entry(key.into()).or_insert_with(|| text.to_owned());
        }
    }
    Ok(())
}

/// Metres per pixel along an axis, or per step of height.
fn scale(
    b: Bytes<'_>,
    channel: Entries<'_>,
    image: Entries<'_>,
    axis: &str,
) -> Result<f64, ReadError> {
    let length = channel.number(&format!("length/{axis}"))?;
    let key = format!("pixelUnit/{axis}");
    let name = channel.text(&key)?;
    let unit = metres_per(&name.replace('_', "")); // MICRO_METER
    let unit = unit.ok_or_else(|| b.field(key, format!("{name:?} is no length")))?;
    let key = format!("acquisition/microscopeConfiguration/pixelCalibration/{axis}");
    let calibration = if axis == "z" { 1.0 } else { image.number_or(&key, 1.0)? };
    Ok(length * unit * calibration)
}

struct FileParts<'f> {
    properties: &'f [u8],
    prefix: String,
    data: BTreeMap<String, &'f [u8]>,
}

impl<'f> FileParts<'f> {
    fn of(b: Bytes<'f>) -> Result<Self, ReadError> {
        if b.slice(72, 8)?.starts_with(b"FLUOVIEW") {
            let feature = "an image of a fluorescence microscope, which has no heights,";
            return Err(b.unsupported(feature));
        }
        let (mut properties, mut prefix, mut data) = (None, None, BTreeMap::new());
        let (mut at, mut chunks) = (FIRST_CHUNK, 0);
        while b.u32(at)? != u32::MAX {
            chunks += 1;
            b.check_items(chunks)?;
            let (size, kind) = (b.u32(at)? as usize, b.u32(at + 4)?);
            let start = at + 8;
            b.slice(start, size)?;
            at = start + size;
            let chunk = |at| Cursor { b: b.with(&b.data[..start + size]), at };
            match kind {
                0 => {
                    for (kind, raw) in blocks(chunk(start))? {
                        match kind {
                            PROPERTIES => properties = Some(raw),
                            PREFIX => prefix = Some(text(raw)),
                            _ => {}
                        }
                    }
                }
                3 => {
                    let name = chunk(start + 8).text()?;
                    let length = b.u32(at)? as usize;
                    data.insert(name, b.slice(at + 8, length)?);
                    at += 8 + length;
                }
                _ => {}
            }
        }
        let missing = |what: &'static str| b.field(what, "the file has none");
        Ok(Self {
            properties: properties.ok_or_else(|| missing("image properties"))?,
            prefix: prefix.ok_or_else(|| missing("name of the data"))?,
            data,
        })
    }

    /// The pieces of a channel's data, which have to make `length` bytes.
    fn data_of(&self, b: Bytes<'_>, id: &str, length: usize) -> Result<Vec<u8>, ReadError> {
        let piece = |i: usize| self.data.get(&format!("{}_{id}_{i}", self.prefix)).copied();
        let pieces: Vec<&[u8]> = (0..).map_while(piece).collect();
        let found: usize = pieces.iter().map(|piece| piece.len()).sum();
        if found == length && pieces.iter().all(|piece| piece.len() % 2 == 0) {
            return Ok(pieces.concat());
        }
        let what = format!("{found} bytes in {} pieces, {length} are needed", pieces.len());
        Err(b.field(format!("data {}_{id}", self.prefix), what))
    }
}

/// The first text of every block in a chunk, with the kind of the block.
fn blocks(mut chunk: Cursor<'_>) -> Result<Vec<(usize, &[u8])>, ReadError> {
    let b = chunk.b;
    let mut found = Vec::new();
    while chunk.at < b.data.len() {
        let (at, kind) = (chunk.at, chunk.word()?);
        let Some(parts) = BLOCKS.get(kind).filter(|parts| !parts.is_empty()) else {
            return Err(b.fault(at, format!("a block of the unknown kind {kind}")));
        };
        chunk.take(32)?;
        let (count, entry) = match parts.strip_prefix('*') {
            Some(entry) => (chunk.word()?, entry),
            None => (1, *parts),
        };
        b.check_items(count as u64)?;
        let mut first = None;
        for part in (0..count).flat_map(|_| entry.chars()) {
            let length = if part == 'w' { 4 } else { chunk.word()? };
            let raw = chunk.take(length)?;
            if part == 't' {
                first.get_or_insert(raw);
            }
        }
        found.extend(first.map(|text| (kind, text)));
        b.check_items(found.len() as u64)?;
    }
    Ok(found)
}

type Fields = BTreeMap<String, String>;

/// The XML of an image: id and fields below it of every channel, and the fields outside the channels.
fn properties(b: Bytes<'_>) -> Result<(Vec<(String, Fields)>, Fields), ReadError> {
    const CHANNEL: [&str; 4] = ["imageInfo", "phase", "group", "channel"];
    let (mut channels, mut fields) = (Vec::new(), BTreeMap::new());
    let mut open = BTreeMap::new();
    let end = b.data.iter().rposition(|&byte| byte != 0).map_or(0, |last| last + 1);
    xml::walk(b.with(&b.data[..end]), "image properties", |element| {
        let [_root, path @ ..] = element.path else { return Ok(()) };
        if path == CHANNEL {
            let id = element.attribute("id").unwrap_or_default().to_owned();
            channels.push((id, std::mem::take(&mut open)));
            return b.check_items(channels.len() as u64);
        }
        let text = element.text.trim();
        if !text.is_empty() {
            let inside = path.len() > CHANNEL.len() && path[..CHANNEL.len()] == CHANNEL;
            let (map, above) = if inside { (&mut open, CHANNEL.len()) } else { (&mut fields, 0) };
            b.check_items(map.len() as u64 + 1)?;
            map.entry(path[above..].join("/")).or_insert_with(|| text.to_owned());
        }
        Ok(())
    })?;
    Ok((channels, fields))
}
