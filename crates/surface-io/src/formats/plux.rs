//! PLUX of Sensofar: a ZIP archive.
//!
//! | member or element | content |
//! |---|---|
//! | `index.xml`, `GENERAL/IMAGE_SIZE_X`, `IMAGE_SIZE_Y` | points along x, along y |
//! | `GENERAL/FOV_X`, `FOV_Y` | µm per point along x, along y |
//! | `GENERAL/DATE` | date |
//! | `INFO/ITEM_n/NAME`, `VALUE` | device, objective, technique |
//! | `LAYER_n/FILENAME_Z` | member with the heights: f32 in µm, little endian, in rows; NaN is a missing point |
//!
//! Sources: SurfaceTopography, surfalize (both open readers). Not checked against a real file.

use super::archive::{Archive, MAGIC};
use crate::binary::{ByteOrder, Sample, find};
use crate::entries::Entries;
use crate::measurement::{Channel, Contents, Pixel};
use crate::{Format, Limits, ReadError, xml};

const FORMAT: Format = Format::Plux;

pub(crate) fn sniff(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC)
        && find(bytes, b"index.xml").is_some()
        && find(bytes, b"LAYER_0").is_some()
}

pub(crate) fn parse<'a>(bytes: &'a [u8], limits: &Limits) -> Result<Contents<'a>, ReadError> {
    let mut archive = Archive::open(bytes, FORMAT, limits)?;
    let index = archive.unpack("index.xml", limits)?;
    let mut fields = xml::fields(&index, FORMAT, "index.xml", limits)?;
    let entries = Entries::new(FORMAT, &fields, crate::xml::ABSENT);
    let side = |key: &str| entries.parsed::<usize>(key, "size");
    let shape = [side("GENERAL/IMAGE_SIZE_Y")?, side("GENERAL/IMAGE_SIZE_X")?];
    limits.check_points(FORMAT, shape)?;
    let micrometres = [entries.number("GENERAL/FOV_Y")?, entries.number("GENERAL/FOV_X")?];
    let pixel = Pixel::Metres(micrometres.map(|um| um * 1e-6));
    let mut contents = Contents::default();
    let mut total = 0;
    for layer in 0.. {
        let Some(member) = entries.get(&format!("LAYER_{layer}/FILENAME_Z")) else { break };
        limits.check_items(FORMAT, layer)?;
        let raw = archive.unpack(member, limits)?;
        total += raw.len() as u64;
        limits.check_unpacked(FORMAT, total)?;
        if raw.len() != 4 * shape[0] * shape[1] {
            let what = format!("{} bytes for {} x {} points", raw.len(), shape[0], shape[1]);
            return Err(FORMAT.field(member.to_owned(), what));
        }
        let name = format!("Layer {}", layer + 1);
        contents.channels.push(Channel::new(name, Some("\u{b5}m"), shape, pixel, move || {
            Ok(Sample::F32.decode(&raw, ByteOrder::Little))
        }));
    }
    fields.retain(|key, _| key == "GENERAL/DATE" || key == "GENERAL/AUTHOR");
    contents.metadata = fields;
    Ok(contents)
}
