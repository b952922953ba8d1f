//! The formats: how each is called, recognised and read.

use crate::binary::{Bytes, find};
use crate::error::{ReadError, TEXT, ZIP};
use crate::finish::{finish, finish_traces};
use crate::measurement::{Contents, Measurement};
#[cfg(feature = "zip")]
use crate::ole;
use crate::options::ReadOptions;
use crate::{formats, hdf5, text, tiff};

/// Every format this build knows, in the order in which they are tried.
#[rustfmt::skip]
pub const FORMATS: &[FormatSpec] = &[
    #[cfg(feature = "zip")]
    row("X3P (ISO 25178-72)", |b| formats::archive::holds(b, b"main.xml"), formats::x3p::parse, &["x3p"], "binary and XML data, masks, layers; unit and pixel in the file"),
    #[cfg(feature = "zip")]
    row("NPZ", |b| formats::archive::holds(b, b".npy"), formats::npz::parse, &["npz"], "every array is a channel; pixel size and unit are to be given"),
    row("NPY", |b| b.starts_with(formats::npy::MAGIC), formats::npy::parse, &["npy"], "real numbers of any type and order; pixel size and unit are to be given"),
    row("Digital Surf SUR", formats::sur::sniff, formats::sur::parse, &["sur", "pro"], "surfaces and profiles, plain and compressed, several layers"),
    row("SDF (ISO 25178-71)", |b| matches!(b, [b'a' | b'b', b'I', b'S', b'O', b'-', ..] | [b'a' | b'b', b'B', b'C', b'R', b'-', ..]), formats::sdf::parse, &["sdf"], "text and binary, also BCR-1.0"),
    row("Zygo MetroPro DAT", |b| matches!(b, [0x88, 0x1b, 0x03, 0x6f..=0x71, ..]) || formats::zygo::is_text(b), formats::zygo::parse, &["dat", "xyz", "asc"], "phase data; intensity is listed; also exports as text"),
    row("Wyko OPD", |b| b.get(2..12) == Some(b"Directory\0") || b.starts_with(formats::opd::TEXT), formats::opd::parse, &["opd", "asc"], "all raw data blocks; also exports as text"),
    row("Gwyddion GWY", |b| b.starts_with(b"GWYP"), formats::gwy::parse, &["gwy"], "all data fields with units; masks are missing points"),
    row("Nanoscope", formats::nanoscope::sniff, formats::nanoscope::parse, &["spm", "001", "di"], "all channels, 2 and 4 bytes per point, parts of a scan"),
    row("Alicona AL3D", |b| b.starts_with(formats::al3d::MAGIC), formats::al3d::parse, &["al3d"], "depth image with missing points"),
    row("NanoFocus NMS", |b| b.get(32..38) == Some(b"OM_MS_"), formats::nms::parse, &["nms"], "height; intensity is listed"),
    row("TrueMap TMD", |b| b.starts_with(b"Binary TrueMap Data File v"), formats::tmd::parse, &["tmd"], "GelSight height maps"),
    row("BCR-STM, BCRF", formats::bcrf::sniff, formats::bcrf::parse, &["bcr", "bcrf"], "Latin-1 and UTF-16 headers, missing points"),
    row("NetCDF classic", |b| matches!(b, [b'C', b'D', b'F', 1 | 2 | 5, ..]), formats::netcdf::parse, &["nc"], "CDF-1, 2 and 5: every variable of two dimensions, or else of one"),
    row("Igor binary wave", formats::ibw::sniff, formats::ibw::parse, &["ibw"], "version 5: every layer is a channel"),
    row("Dektak OPDx", |b| b.starts_with(formats::opdx::MAGIC), formats::opdx::parse, &["opdx"], "maps and profiles of Vision64"),
    row("FRT MicroProf", |b| b.starts_with(b"FRTM_GLIDERV"), formats::frt::parse, &["frt"], "height with missing points"),
    row("Molecular Imaging MI", |b| b.starts_with(b"fileType      "), formats::mi::parse, &["mi"], "all channels of images"),
    row("Nanosurf NID", |b| b.starts_with(b"[DataSet]"), formats::nid::parse, &["nid", "ezd"], "all channels of images; spectra are left out"),
    row("WSxM", |b| b.starts_with(b"WSxM file copyright") && find(&b[..b.len().min(128)], b"WSxM ASCII").is_none(), formats::wsxm::parse, &["stp", "top"], "images"),
    row("Sensofar PLU", formats::plu::sniff, formats::plu::parse, &["plu"], "topographies, all layers"),
    row("Keyence VK", |b| matches!(b, [b'V', b'K', b'3' | b'4', b'_', ..]) || formats::vk::is_packed(b), formats::vk::parse, &["vk4", "vk6", "vk7"], "height images of laser microscopes; VK3, VK4, VK6, VK7"),
    #[cfg(feature = "zip")]
    row("Keyence ZON", |b| b.starts_with(b"KPK0") || b.starts_with(b"KPK1"), formats::zon::parse, &["zon"], "height with missing points"),
    #[cfg(feature = "zip")]
    row("Sensofar PLUX", |b| formats::archive::holds(b, b"index.xml") && formats::archive::holds(b, b"LAYER_0"), formats::plux::parse, &["plux"], "all layers; not checked against a real file"),
    #[cfg(feature = "zip")]
    row("Olympus LEXT", formats::lext::sniff, formats::lext::parse, &["lext"], "height image, others are listed; not checked against a real file"),
    #[cfg(feature = "zip")]
    row("Olympus OIR", |b| b.starts_with(formats::oir::MAGIC) || formats::archive::holds(b, b".oir"), formats::oir::parse, &["oir", "poir"], "height images, also packed (POIR); not checked against a real file"),
    row("Park Systems TIFF", |b| tiff::first_page_is(b, |page| page.has(formats::park::MAGIC)), formats::park::parse, &["tiff"], "maps and profiles of XEI and SmartScan"),
    row("JPK image", |b| tiff::first_page_is(b, |page| page.has(formats::jpk::GRID_WIDTH)), formats::jpk::parse, &["jpk", "jpk-qi-image"], "all channels"),
    row("TIFF", tiff::is_tiff, formats::tiff_plain::parse, &["tif", "tiff"], "plain pictures of one number a point; pixel size and unit are to be given"),
    row("NT-MDT MDT", |b| b.starts_with(b"\x01\xb0\x93\xff"), formats::mdt::parse, &["mdt"], "general maps; scans, not checked against a real file"),
    row("Nanonis SXM", |b| b.starts_with(b":NANONIS_VERSION:"), formats::sxm::parse, &["sxm"], "all channels, both ways"),
    row("Zeta ZMG", |b| b.starts_with(b"Zeta-Instruments"), formats::zmg::parse, &["zmg"], "height; not checked against a real file"),
    row("OmniSurf3D OS3D", |b| b.starts_with(formats::os3d::MAGIC), formats::os3d::parse, &["os3d"], "height with missing points; not checked against a real file"),
    #[cfg(feature = "zip")]
    row("Mitutoyo workbook", |b| formats::archive::holds(b, b"xl/workbook.xml"), formats::mitutoyo::parse, &["xlsx"], "the profile of a SurfTest tester; checked against made workbooks only"),
    row("Zygo DATX", |b| hdf5::superblock(b).is_some() && find(b, b"X Converter").is_some(), formats::hdf5::parse, &["datx"], "all maps; not checked against a real file"),
    row("HDF5", |b| hdf5::superblock(b).is_some(), formats::hdf5::parse, &["h5", "hdf5"], "every data set of two axes, or else of one, also of NetCDF-4 and MATLAB 7.3; unit from its attribute"),
    #[cfg(feature = "zip")]
    row(formats::mnt::FORMAT, |b| b.starts_with(ole::MAGIC), formats::mnt::parse, &["mnt"], "surfaces as they were loaded, with missing points; results of the document are not read"),
    #[cfg(feature = "zip")]
    row("NIST softgauge", formats::softgauge::sniff, formats::softgauge::parse, &["xml"], "profiles of NIST's algorithm testing system"),
    row(TEXT, text::is_text, formats::table::parse, &["csv", "asc", "tsv", "txt", "xyz"], "matrices, lists of x y z, profiles, several traces beside each other; any separator, decimal comma, missing cells"),
];

type Parse = for<'a> fn(Bytes<'a>) -> Result<Contents<'a>, ReadError>;

/// One row of [`FORMATS`].
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub struct FormatSpec {
    /// Its name for people.
    pub name: &'static str,
    /// Usual file name extensions, the first of which no other format has first; information only, files are recognised
    /// by content.
    pub extensions: &'static [&'static str],
    /// What is read, in a few words.
    pub about: &'static str,
    sniff: fn(&[u8]) -> bool,
    parse: Parse,
}

const fn row(
    name: &'static str,
    sniff: fn(&[u8]) -> bool,
    parse: Parse,
    extensions: &'static [&'static str],
    about: &'static str,
) -> FormatSpec {
    FormatSpec { name, extensions, about, sniff, parse }
}

impl FormatSpec {
    /// Reads `bytes` as this format, whatever they look like.
    ///
    /// # Errors
    /// As [`read_bytes`](crate::read_bytes).
    pub fn read(&self, bytes: &[u8], options: &ReadOptions) -> Result<Measurement, ReadError> {
        finish(self.name, self.contents(bytes, options)?, options)
    }

    /// Every trace in `bytes`, see [`read_traces_bytes`](crate::read_traces_bytes).
    pub(crate) fn read_traces(
        &self,
        bytes: &[u8],
        options: &ReadOptions,
    ) -> Result<Vec<Measurement>, ReadError> {
        finish_traces(self.name, self.contents(bytes, options)?, options)
    }

    /// What is in `bytes`, with nothing decoded yet.
    fn contents<'a>(
        &self,
        bytes: &'a [u8],
        options: &'a ReadOptions,
    ) -> Result<Contents<'a>, ReadError> {
        match options.layout {
            Some(layout) if self.name != TEXT => Err(ReadError::BadLayout {
                format: self.name,
                layout,
                reason: "only the columns of a text can be more than one thing",
            }),
            _ => (self.parse)(Bytes::little(bytes, self.name, options)),
        }
    }
}

/// The format of `bytes`, by content.
pub(crate) fn recognise(bytes: &[u8]) -> Result<&'static FormatSpec, ReadError> {
    if bytes.is_empty() {
        return Err(ReadError::Empty);
    }
    if let Some(error) = formats::foreign::recognise(bytes) {
        return Err(error);
    }
    FORMATS.iter().find(|spec| (spec.sniff)(bytes)).ok_or_else(|| {
        if bytes.starts_with(b"PK\x03\x04") {
            let what = "the list of files at its end cannot be read: it was cut off, or is damaged";
            return ReadError::at(ZIP, "archive", what);
        }
        let start = bytes[..bytes.len().min(16)].escape_ascii().to_string();
        ReadError::UnknownFormat(start)
    })
}
