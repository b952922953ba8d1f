//! JPK images (`.jpk`, `.jpk-qi-image`; JPK Instruments, now Bruker): TIFF with tags of its own.
//!
//! | tag | content |
//! |---|---|
//! | 0x8003, 0x8001 | date, version of the program |
//! | 0x8042, 0x8043 | size of the grid along x, along y in metres: N pixels |
//! | 0x8045 | not 0: the first row is the top one |
//! | 0x8050, 0x8052 | channel, and its name for people |
//! | 0x8051 | 1 if it is the way back |
//! | 0x8080, 0x8081 | number of slots, name of the default one |
//! | 0x8090 + 0x30 n | name of slot n |
//! | 0x80A2, 0x80A3 + 0x30 n | its unit, its kind: `LinearScaling`, `NullScaling` |
//! | 0x80A4, 0x80A5 + 0x30 n | factor and offset |
//!
//! Every directory but the first, a thumbnail, is a channel. Value = stored number × factor +
//! offset of the default slot, which goes back to the stored number in one step. The first row is
//! the bottom one, unless it is reflected.
//!
//! Sources: JPK, *Image file format*, as read by SurfaceTopography and AFMReader (both open); a
//! `.jpk` of version 6 and a `.jpk-qi-image` of version 8.

use super::prelude::*;
use crate::tiff::{self, Page};

pub(crate) const GRID_WIDTH: u16 = 0x8042;
const GRID_HEIGHT: u16 = 0x8043;
const REFLECTED: u16 = 0x8045;
const CHANNEL: u16 = 0x8050;
const RETRACE: u16 = 0x8051;
const TITLE: u16 = 0x8052;
const SLOTS: u16 = 0x8080;
const DEFAULT_SLOT: u16 = 0x8081;

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let pages = tiff::pages(b, usize::MAX)?;
    let Some((global, pages)) = pages.split_first() else {
        return Ok(Contents::default());
    };
    let size = [global.number(GRID_HEIGHT)?, global.number(GRID_WIDTH)?];
    let mut contents = Contents::default();
    for (number, page) in pages.iter().enumerate() {
        let title = page.text(TITLE).or_else(|| page.text(CHANNEL));
        let title = title.unwrap_or_else(|| format!("Image {}", number + 1));
        let is_retrace = page.number(RETRACE).is_ok_and(|flag| flag > 0.0);
        let name = format!("{title} ({})", if is_retrace { "retrace" } else { "trace" });
        contents.add(&name, channel(b, &name, page, size));
    }
    let said = |tag| global.text(tag).filter(|text| text != "<empty>");
    contents.note([("date", said(0x8003)), ("name", said(0x8004)), ("comment", said(0x8005))]);
    Ok(contents)
}

fn channel<'a>(
    b: Bytes<'_>,
    name: &str,
    page: &Page<'a>,
    size: [f64; 2],
) -> Result<Channel<'a>, ReadError> {
    let image = page.image()?;
    let [ny, nx] = image.shape;
    let pixel = Pixel::Metres([size[0] / ny as f64, size[1] / nx as f64]);
    let wanted = page.text(DEFAULT_SLOT);
    let wanted = wanted.ok_or_else(|| b.field("slots", "none is the default"))?;
    let count = page.number(SLOTS)?;
    let first = (0..64u16)
        .take_while(|slot| f64::from(*slot) < count)
        .map(|slot| 0x30 * slot)
        .find(|shift| page.text(0x8090 + shift).is_some_and(|slot| slot == wanted))
        .ok_or_else(|| b.field("slots", format!("none is called {wanted:?}, the default")))?;
    let kind = page.text(0x80A3 + first).unwrap_or_default();
    let [factor, offset] = match kind.as_str() {
        "LinearScaling" => [page.number(0x80A4 + first)?, page.number(0x80A5 + first)?],
        "NullScaling" => [1.0, 0.0],
        _ => return Err(b.unsupported(format!("scaling of kind {kind:?}"))),
    };
    // Numbers without a unit are those of the converter, no heights.
    let unit = page.text(0x80A2 + first).unwrap_or_else(|| "counts".into());
    let channel = Channel::new(name, Some(&unit), image.shape, pixel, move || image.decode());
    let channel = channel.converted(move |raw| raw * factor + offset);
    let is_reflected = page.has(REFLECTED) && page.number(REFLECTED)? != 0.0;
    Ok(if is_reflected { channel } else { channel.flipped() })
}
