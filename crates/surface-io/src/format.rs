//! The one table of formats.

use crate::ReadError;
use crate::formats;
use crate::limits::Limits;
use crate::measurement::Contents;

macro_rules! formats {
    ($($(#[$cfg:meta])? $variant:ident, $name:literal, $extensions:expr, $sniff:path, $parse:path;)*) => {
        /// A file format.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum Format {
            $(#[doc = $name] $variant,)*
            /// ZIP archive holding one of the others.
            Zip,
        }

        impl Format {
            /// Its name for people.
            pub fn name(self) -> &'static str {
                match self { $(Self::$variant => $name,)* Self::Zip => "ZIP" }
            }
        }

        /// Every format this build reads, in the order in which they are tried.
        pub const FORMATS: &[FormatSpec] = &[
            $($(#[$cfg])? FormatSpec {
                format: Format::$variant,
                extensions: $extensions,
                sniff: $sniff,
                parse: $parse,
            },)*
        ];
    };
}

formats! {
    #[cfg(feature = "zip")]
    X3p, "X3P (ISO 25178-72)", &["x3p"], formats::x3p::sniff, formats::x3p::parse;
    #[cfg(feature = "zip")]
    Npz, "NPZ", &["npz"], formats::npz::sniff, formats::npz::parse;
    Npy, "NPY", &["npy"], formats::npy::sniff, formats::npy::parse;
    Sur, "Digital Surf SUR", &["sur", "pro"], formats::sur::sniff, formats::sur::parse;
    Sdf, "SDF (ISO 25178-71)", &["sdf"], formats::sdf::sniff, formats::sdf::parse;
    Zygo, "Zygo MetroPro DAT", &["dat"], formats::zygo::sniff, formats::zygo::parse;
    Opd, "Wyko OPD", &["opd"], formats::opd::sniff, formats::opd::parse;
    Gwy, "Gwyddion GWY", &["gwy"], formats::gwy::sniff, formats::gwy::parse;
    Nanoscope, "Nanoscope", &["spm", "001", "di"], formats::nanoscope::sniff, formats::nanoscope::parse;
    Al3d, "Alicona AL3D", &["al3d"], formats::al3d::sniff, formats::al3d::parse;
    Nms, "NanoFocus NMS", &["nms"], formats::nms::sniff, formats::nms::parse;
    Tmd, "TrueMap TMD", &["tmd"], formats::tmd::sniff, formats::tmd::parse;
    Bcrf, "BCR-STM, BCRF", &["bcr", "bcrf"], formats::bcrf::sniff, formats::bcrf::parse;
    NetCdf, "NetCDF classic", &["nc"], formats::netcdf::sniff, formats::netcdf::parse;
    Ibw, "Igor binary wave", &["ibw"], formats::ibw::sniff, formats::ibw::parse;
    Opdx, "Dektak OPDx", &["opdx"], formats::opdx::sniff, formats::opdx::parse;
    Frt, "FRT MicroProf", &["frt"], formats::frt::sniff, formats::frt::parse;
    Mi, "Molecular Imaging MI", &["mi"], formats::mi::sniff, formats::mi::parse;
    Nid, "Nanosurf NID", &["nid", "ezd"], formats::nid::sniff, formats::nid::parse;
    Wsxm, "WSxM", &["stp", "top"], formats::wsxm::sniff, formats::wsxm::parse;
    Plu, "Sensofar PLU", &["plu"], formats::plu::sniff, formats::plu::parse;
    Text, "text", &["csv", "asc", "tsv", "txt", "xyz"], formats::table::sniff, formats::table::parse;
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
    pub(crate) sniff: fn(&[u8]) -> bool,
    pub(crate) parse: Parse,
}

/// The format of `bytes`, by content.
pub(crate) fn sniff(bytes: &[u8]) -> Option<&'static FormatSpec> {
    FORMATS.iter().find(|spec| (spec.sniff)(bytes))
}
