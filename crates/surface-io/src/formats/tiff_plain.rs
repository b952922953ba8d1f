//! Plain TIFF: every picture of one number a point is a channel, without unit and pixel size. The
//! resolution in a TIFF file is that of print, so it is not taken for a pixel size.
//!
//! Source: see the reader of the container.

use super::prelude::*;
use crate::tiff;

/// The number of a missing point, as text: a tag of GDAL.
const GDAL_NODATA: u16 = 42113;

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let mut contents = Contents::default();
    for (number, page) in tiff::pages(b, usize::MAX)?.iter().enumerate() {
        let name = format!("Picture {}", number + 1);
        let missing = page.text(GDAL_NODATA).and_then(|text| text.trim().parse().ok());
        let channel = page.image().map(|image| {
            Channel::new(&*name, None, image.shape, Pixel::Unknown, move || image.decode())
                .without(missing)
        });
        contents.add(&name, channel);
        let about = page.text(tiff::IMAGE_DESCRIPTION).filter(|text| text.len() < 4096);
        contents.note([(&format!("description {}", number + 1), about)]);
    }
    Ok(contents)
}
