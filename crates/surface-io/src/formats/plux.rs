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

use super::prelude::*;

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let mut archive = Archive::open(b)?;
    let index = archive.unpack("index.xml")?;
    let mut fields = xml::fields(b.with(&index), "index.xml")?;
    let entries = Entries::new(b, &fields);
    let side = |key: &str| entries.parsed::<usize>(key, "size");
    let shape = [side("GENERAL/IMAGE_SIZE_Y")?, side("GENERAL/IMAGE_SIZE_X")?];
    b.check_points(shape)?;
    let micrometres = [entries.number("GENERAL/FOV_Y")?, entries.number("GENERAL/FOV_X")?];
    let pixel = Pixel::Metres(micrometres.map(|um| um * 1e-6));
    let mut contents = Contents::default();
    for layer in 0.. {
        let Some(member) = entries.get(&format!("LAYER_{layer}/FILENAME_Z")) else { break };
        b.check_items(layer)?;
        let raw = archive.unpack(member)?;
        if raw.len() != 4 * shape[0] * shape[1] {
            let what = format!("{} bytes for {} x {} points", raw.len(), shape[0], shape[1]);
            return Err(b.field(member.to_owned(), what));
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
