//! LEXT of Olympus laser microscopes (OLS4000 and later): TIFF with XML in two tags.
//!
//! | what | content |
//! |---|---|
//! | first directory, tag 270 | XML `TiffTagDescData` |
//! | `HeightInfo/HeightDataPerPixelX`, `Y`, `Z` | pm per point along x, along y; pm per stored height |
//! | first directory, Exif directory (34665), tag 41995 | XML `ExifTagDescData` |
//! | `ImageCommonSettingsInfo/MakerCalibrationValueX`, `Y`, `Z` | factors on these three; 1 if missing |
//! | another directory, tag 270 `HEIGHT` | the heights: u16 |
//!
//! Pictures of other names are listed. A mask of missing points (`INVALID`, one bit a point) is not
//! read.
//!
//! Sources: SurfaceTopography, surfalize (both open readers). Not checked against a real file.

use super::prelude::*;
use crate::tiff::{self, IMAGE_DESCRIPTION, Page};

const EXIF: u16 = 34665;
const DEVICE: u16 = 41995;

pub(crate) fn sniff(bytes: &[u8]) -> bool {
    let is_ours = |text: String| text.contains("<TiffTagDescData");
    tiff::first_page_is(bytes, |page| page.text(IMAGE_DESCRIPTION).is_some_and(is_ours))
}

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let pages = tiff::pages(b, usize::MAX)?;
    let first = pages.first().ok_or_else(|| b.fault(4, "there is no directory"))?;
    let document = |page: &Page<'_>, tag| {
        let (_, raw) = page.raw(tag)?;
        xml::fields(b.with(text(raw).as_bytes()), "XML")
    };
    let fields = document(first, IMAGE_DESCRIPTION)?;
    // Calibration that is there and cannot be read is no reason to go without it.
    let exif = if first.has(EXIF) { Some(first.sub_page(EXIF)?) } else { None };
    let device = match exif {
        Some(exif) if exif.has(DEVICE) => document(&exif, DEVICE)?,
        _ => BTreeMap::new(),
    };
    let (fields, device) = (Entries::new(b, &fields), Entries::new(b, &device));
    let scale = |axis: &str| {
        let picometres = fields.number(&format!("HeightInfo/HeightDataPerPixel{axis}"))?;
        let key = format!("ImageCommonSettingsInfo/MakerCalibrationValue{axis}");
        Ok::<_, ReadError>(1e-12 * picometres * device.number_or(&key, 1.0)?)
    };
    let pixel = Pixel::Metres([scale("Y")?, scale("X")?]);
    let step = scale("Z")?;
    let mut contents = Contents::default();
    for (i, page) in pages.iter().enumerate() {
        let title = page.text(IMAGE_DESCRIPTION).filter(|text| !text.contains('<'));
        let name = title.unwrap_or_else(|| format!("Picture {}", i + 1));
        let is_height = name.eq_ignore_ascii_case("height");
        let (unit, factor) = if is_height { ("m", step) } else { ("counts", 1.0) };
        let channel = page.image().map(|image| {
            let shape = image.shape;
            Channel::new(name.as_str(), Some(unit), shape, pixel, move || image.decode())
                .converted(move |raw| raw * factor)
        });
        contents.add(&name, channel);
    }
    contents.note([("software", first.text(305)), ("date", first.text(306))]);
    Ok(contents)
}
