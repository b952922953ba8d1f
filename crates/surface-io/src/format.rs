//! The one table of formats.

use crate::formats;
use crate::limits::Limits;
use crate::measurement::Contents;
use crate::{Measurement, ReadError, ReadOptions};

macro_rules! formats {
    ($($(#[$cfg:meta])? $variant:ident, $module:ident, $name:literal, [$($extension:literal),*],
       $about:literal;)*) => {
        /// A file format.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum Format {
            $(#[doc = $name] $variant,)*
            /// ZIP archive or gzip file holding one of the others.
            Zip,
        }

        impl Format {
            /// Its name for people.
            pub fn name(self) -> &'static str {
                match self { $(Self::$variant => $name,)* Self::Zip => "ZIP or gzip" }
            }
        }

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

formats! {
    #[cfg(feature = "zip")]
    X3p, x3p, "X3P (ISO 25178-72)", ["x3p"],
        "binary and XML data, masks, layers; unit and pixel in the file";
    #[cfg(feature = "zip")]
    Npz, npz, "NPZ", ["npz"],
        "every array is a channel; needs --pixel and --height-unit";
    Npy, npy, "NPY", ["npy"],
        "real numbers of any type and order; needs --pixel and --height-unit";
    Sur, sur, "Digital Surf SUR", ["sur", "pro"],
        "surfaces and profiles, plain and compressed, several layers";
    Sdf, sdf, "SDF (ISO 25178-71)", ["sdf"],
        "text and binary, also BCR-1.0";
    Zygo, zygo, "Zygo MetroPro DAT", ["dat"],
        "phase data; intensity is listed";
    Opd, opd, "Wyko OPD", ["opd"],
        "all raw data blocks";
    Gwy, gwy, "Gwyddion GWY", ["gwy"],
        "all data fields with units; masks are missing points";
    Nanoscope, nanoscope, "Nanoscope", ["spm", "001", "di"],
        "all channels, 2 and 4 bytes per point";
    Al3d, al3d, "Alicona AL3D", ["al3d"],
        "depth image with missing points";
    Nms, nms, "NanoFocus NMS", ["nms"],
        "height; intensity is listed";
    Tmd, tmd, "TrueMap TMD", ["tmd"],
        "GelSight height maps";
    Bcrf, bcrf, "BCR-STM, BCRF", ["bcr", "bcrf"],
        "Latin-1 and UTF-16 headers, missing points";
    NetCdf, netcdf, "NetCDF classic", ["nc"],
        "CDF-1, 2 and 5: every variable of two dimensions";
    Ibw, ibw, "Igor binary wave", ["ibw"],
        "version 5: every layer is a channel";
    Opdx, opdx, "Dektak OPDx", ["opdx"],
        "maps and profiles of Vision64";
    Frt, frt, "FRT MicroProf", ["frt"],
        "height with missing points";
    Mi, mi, "Molecular Imaging MI", ["mi"],
        "all channels of images";
    Nid, nid, "Nanosurf NID", ["nid", "ezd"],
        "all channels of all groups";
    Wsxm, wsxm, "WSxM", ["stp", "top"],
        "images";
    Plu, plu, "Sensofar PLU", ["plu"],
        "topographies, all layers";
    Hdf5, hdf5, "HDF5", ["h5", "datx"],
        "recognised and refused with the way out; also NetCDF-4 and DATX";
    Mnt, mnt, "Digital Surf MNT", ["mnt"],
        "recognised and refused with the way out";
    Text, table, "text", ["csv", "asc", "tsv", "txt", "xyz"],
        "matrices, lists of x y z, profiles; any separator, decimal comma, missing cells";
}

impl std::fmt::Display for Format {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

pub(crate) type Parse = for<'a> fn(&'a [u8], &Limits) -> Result<Contents<'a>, ReadError>;

/// One row of [`FORMATS`].
#[derive(Debug, Clone, Copy)]
pub struct FormatSpec {
    /// Which format.
    pub format: Format,
    /// Usual file name extensions; information only, files are recognised by content.
    pub extensions: &'static [&'static str],
    /// What is read, in a few words.
    pub about: &'static str,
    pub(crate) sniff: fn(&[u8]) -> bool,
    pub(crate) parse: Parse,
}

impl FormatSpec {
    /// Reads `bytes` as this format, whatever they look like.
    ///
    /// # Errors
    /// As [`read_bytes`](crate::read_bytes).
    pub fn read(&self, bytes: &[u8], options: &ReadOptions) -> Result<Measurement, ReadError> {
        let limits = &options.limits;
        let contents = match options.layout {
            None => (self.parse)(bytes, limits)?,
            Some(layout) if self.format == Format::Text => {
                formats::table::parse_as(bytes, limits, Some(layout))?
            }
            Some(layout) => {
                let feature = format!(
                    "--layout {} (only the columns of a text can be more than one thing; leave it \
                     out)",
                    layout.name()
                );
                return Err(ReadError::Unsupported {
                    format: self.format,
                    feature: feature.into(),
                });
            }
        };
        crate::read::finish(self.format, contents, options)
    }
}

/// The format of `bytes`, by content.
pub(crate) fn sniff(bytes: &[u8]) -> Option<&'static FormatSpec> {
    FORMATS.iter().find(|spec| (spec.sniff)(bytes))
}
