//! The one table of formats: how each is recognised and which reader takes it.

use crate::binary::Bytes;
use crate::error::ReadError;
use crate::finish::{finish, finish_traces};
use crate::format::Format;
use crate::formats;
use crate::limits::Limits;
use crate::measurement::{Contents, Measurement};
use crate::options::ReadOptions;
use std::borrow::Cow;

macro_rules! rows {
    ($($(#[$cfg:meta])? $variant:ident, $module:ident, [$($extension:literal),*], $about:literal;)*) => {
        /// Every format this build knows, in the order in which they are tried.
        pub const FORMATS: &[FormatSpec] = &[
            $($(#[$cfg])? FormatSpec {
                format: Format::$variant,
                extensions: &[$($extension),*],
                about: $about,
                sniff: formats::$module::sniff,
                parse: formats::$module::parse,
            },)*
        ];
    };
}

rows! {
    #[cfg(feature = "zip")]
    X3p, x3p, ["x3p"], "binary and XML data, masks, layers; unit and pixel in the file";
    #[cfg(feature = "zip")]
    Npz, npz, ["npz"], "every array is a channel; pixel size and unit are to be given";
    Npy, npy, ["npy"], "real numbers of any type and order; pixel size and unit are to be given";
    Sur, sur, ["sur", "pro"], "surfaces and profiles, plain and compressed, several layers";
    Sdf, sdf, ["sdf"], "text and binary, also BCR-1.0";
    Zygo, zygo, ["dat", "xyz", "asc"], "phase data; intensity is listed; also exports as text";
    Opd, opd, ["opd", "asc"], "all raw data blocks; also exports as text";
    Gwy, gwy, ["gwy"], "all data fields with units; masks are missing points";
    Nanoscope, nanoscope, ["spm", "001", "di"], "all channels, 2 and 4 bytes per point, parts of a scan";
    Al3d, al3d, ["al3d"], "depth image with missing points";
    Nms, nms, ["nms"], "height; intensity is listed";
    Tmd, tmd, ["tmd"], "GelSight height maps";
    Bcrf, bcrf, ["bcr", "bcrf"], "Latin-1 and UTF-16 headers, missing points";
    NetCdf, netcdf, ["nc"], "CDF-1, 2 and 5: every variable of two dimensions, or else of one";
    Ibw, ibw, ["ibw"], "version 5: every layer is a channel";
    Opdx, opdx, ["opdx"], "maps and profiles of Vision64";
    Frt, frt, ["frt"], "height with missing points";
    Mi, mi, ["mi"], "all channels of images";
    Nid, nid, ["nid", "ezd"], "all channels of images; spectra are left out";
    Wsxm, wsxm, ["stp", "top"], "images";
    Plu, plu, ["plu"], "topographies, all layers";
    Vk, vk, ["vk4", "vk6", "vk7"], "height images of laser microscopes; VK3, VK4, VK6, VK7";
    #[cfg(feature = "zip")]
    Zon, zon, ["zon"], "height with missing points";
    #[cfg(feature = "zip")]
    Plux, plux, ["plux"], "all layers; not checked against a real file";
    #[cfg(feature = "zip")]
    Lext, lext, ["lext"], "height image, others are listed; not checked against a real file";
    #[cfg(feature = "zip")]
    Oir, oir, ["oir", "poir"], "height images, also packed (POIR); not checked against a real file";
    Park, park, ["tiff"], "maps and profiles of XEI and SmartScan";
    Jpk, jpk, ["jpk", "jpk-qi-image"], "all channels";
    Tiff, tiff_plain, ["tif", "tiff"],
        "plain pictures of one number a point; pixel size and unit are to be given";
    Mdt, mdt, ["mdt"], "general maps; scans, not checked against a real file";
    Sxm, sxm, ["sxm"], "all channels, both ways";
    Zmg, zmg, ["zmg"], "height; not checked against a real file";
    Os3d, os3d, ["os3d"], "height with missing points; not checked against a real file";
    #[cfg(feature = "zip")]
    Mitutoyo, mitutoyo, ["xlsx"],
        "the profile of a SurfTest tester; checked against made workbooks only";
    Datx, datx, ["datx"], "all maps; not checked against a real file";
    Hdf5, hdf5, ["h5", "hdf5"],
        "every data set of two axes, or else of one, also of NetCDF-4 and MATLAB 7.3; unit from its attribute";
    #[cfg(feature = "zip")]
    Mnt, mnt, ["mnt"], "surfaces as they were loaded, with missing points; results of the document are not read";
    #[cfg(feature = "zip")]
    Softgauge, softgauge, ["xml"], "profiles of NIST's algorithm testing system";
    Text, table, ["csv", "asc", "tsv", "txt", "xyz"],
        "matrices, lists of x y z, profiles, several traces beside each other; any separator, decimal comma, missing cells";
}

type Parse = for<'a> fn(&'a [u8], &Limits) -> Result<Contents<'a>, ReadError>;

/// One row of [`FORMATS`].
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub struct FormatSpec {
    /// Which format.
    pub format: Format,
    /// Usual file name extensions; information only, files are recognised by content.
    pub extensions: &'static [&'static str],
    /// What is read, in a few words.
    pub about: &'static str,
    sniff: fn(&[u8]) -> bool,
    parse: Parse,
}

impl FormatSpec {
    /// Reads `bytes` as this format, whatever they look like.
    ///
    /// # Errors
    /// As [`read_bytes`](crate::read_bytes).
    pub fn read(&self, bytes: &[u8], options: &ReadOptions) -> Result<Measurement, ReadError> {
        finish(self.format, self.laid_out(bytes, options)?, options)
    }

    /// Every trace in `bytes`, see [`read_traces`](crate::read_traces).
    pub(crate) fn read_traces(
        &self,
        bytes: &[u8],
        options: &ReadOptions,
    ) -> Result<Vec<Measurement>, ReadError> {
        finish_traces(self.format, self.laid_out(bytes, options)?, options)
    }

    /// What is in `bytes` in the layout asked for.
    fn laid_out<'a>(
        &self,
        bytes: &'a [u8],
        options: &ReadOptions,
    ) -> Result<Contents<'a>, ReadError> {
        match options.layout {
            _ if self.format == Format::Text => formats::table::parse_as(bytes, options),
            None => self.contents(bytes, &options.limits),
            Some(layout) => Err(ReadError::BadLayout {
                format: self.format,
                layout,
                reason: Cow::Borrowed("only the columns of a text can be more than one thing"),
            }),
        }
    }

    /// What is in `bytes`, with nothing decoded yet.
    pub(crate) fn contents<'a>(
        &self,
        bytes: &'a [u8],
        limits: &Limits,
    ) -> Result<Contents<'a>, ReadError> {
        (self.parse)(bytes, limits)
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
            return Bytes::little(bytes, Format::Zip).field("archive", what);
        }
        let start = bytes[..bytes.len().min(16)].escape_ascii().to_string();
        ReadError::UnknownFormat { start }
    })
}
