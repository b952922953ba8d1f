//! The formats: what people call them, which file of `formats` reads them, their extensions, and what is read.

/// Hands every format to a macro, in the order in which they are tried.
#[rustfmt::skip]
macro_rules! every_format {
    ($take:ident) => { $take! {
        #[cfg(feature = "zip")]
        X3p, x3p, formats::x3p::sniff, "X3P (ISO 25178-72)", ["x3p"], "binary and XML data, masks, layers; unit and pixel in the file";
        #[cfg(feature = "zip")]
        Npz, npz, formats::npz::sniff, "NPZ", ["npz"], "every array is a channel; pixel size and unit are to be given";
        Npy, npy, |b| b.starts_with(formats::npy::MAGIC), "NPY", ["npy"], "real numbers of any type and order; pixel size and unit are to be given";
        Sur, sur, formats::sur::sniff, "Digital Surf SUR", ["sur", "pro"], "surfaces and profiles, plain and compressed, several layers";
        Sdf, sdf, formats::sdf::sniff, "SDF (ISO 25178-71)", ["sdf"], "text and binary, also BCR-1.0";
        Zygo, zygo, formats::zygo::sniff, "Zygo MetroPro DAT", ["dat", "xyz", "asc"], "phase data; intensity is listed; also exports as text";
        Opd, opd, formats::opd::sniff, "Wyko OPD", ["opd", "asc"], "all raw data blocks; also exports as text";
        Gwy, gwy, |b| b.starts_with(b"GWYP"), "Gwyddion GWY", ["gwy"], "all data fields with units; masks are missing points";
        Nanoscope, nanoscope, formats::nanoscope::sniff, "Nanoscope", ["spm", "001", "di"], "all channels, 2 and 4 bytes per point, parts of a scan";
        Al3d, al3d, |b| b.starts_with(formats::al3d::MAGIC), "Alicona AL3D", ["al3d"], "depth image with missing points";
        Nms, nms, |b| b.get(32..38) == Some(b"OM_MS_"), "NanoFocus NMS", ["nms"], "height; intensity is listed";
        Tmd, tmd, |b| b.starts_with(b"Binary TrueMap Data File v"), "TrueMap TMD", ["tmd"], "GelSight height maps";
        Bcrf, bcrf, formats::bcrf::sniff, "BCR-STM, BCRF", ["bcr", "bcrf"], "Latin-1 and UTF-16 headers, missing points";
        NetCdf, netcdf, |b| matches!(b, [b'C', b'D', b'F', 1 | 2 | 5, ..]), "NetCDF classic", ["nc"], "CDF-1, 2 and 5: every variable of two dimensions, or else of one";
        Ibw, ibw, formats::ibw::sniff, "Igor binary wave", ["ibw"], "version 5: every layer is a channel";
        Opdx, opdx, |b| b.starts_with(formats::opdx::MAGIC), "Dektak OPDx", ["opdx"], "maps and profiles of Vision64";
        Frt, frt, |b| b.starts_with(b"FRTM_GLIDERV"), "FRT MicroProf", ["frt"], "height with missing points";
        Mi, mi, |b| b.starts_with(b"fileType      "), "Molecular Imaging MI", ["mi"], "all channels of images";
        Nid, nid, |b| b.starts_with(b"[DataSet]"), "Nanosurf NID", ["nid", "ezd"], "all channels of images; spectra are left out";
        Wsxm, wsxm, |b| b.starts_with(b"WSxM file copyright"), "WSxM", ["stp", "top"], "images";
        Plu, plu, formats::plu::sniff, "Sensofar PLU", ["plu"], "topographies, all layers";
        Vk, vk, |b| matches!(b, [b'V', b'K', b'3' | b'4', b'_', ..] | [b'V', b'K', b'6' | b'7', ..]), "Keyence VK", ["vk4", "vk6", "vk7"], "height images of laser microscopes; VK3, VK4, VK6, VK7";
        #[cfg(feature = "zip")]
        Zon, zon, |b| b.starts_with(b"KPK0") || b.starts_with(b"KPK1"), "Keyence ZON", ["zon"], "height with missing points";
        #[cfg(feature = "zip")]
        Plux, plux, formats::plux::sniff, "Sensofar PLUX", ["plux"], "all layers; not checked against a real file";
        #[cfg(feature = "zip")]
        Lext, lext, formats::lext::sniff, "Olympus LEXT", ["lext"], "height image, others are listed; not checked against a real file";
        #[cfg(feature = "zip")]
        Oir, oir, formats::oir::sniff, "Olympus OIR", ["oir", "poir"], "height images, also packed (POIR); not checked against a real file";
        Park, park, |b| tiff::first_page(b).is_some_and(|page| page.has(formats::park::MAGIC)), "Park Systems TIFF", ["tiff"], "maps and profiles of XEI and SmartScan";
        Jpk, jpk, |b| tiff::first_page(b).is_some_and(|page| page.has(formats::jpk::GRID_WIDTH)), "JPK image", ["jpk", "jpk-qi-image"], "all channels";
        Tiff, tiff_plain, tiff::is_tiff, "TIFF", ["tif", "tiff"], "plain pictures of one number a point; pixel size and unit are to be given";
        Mdt, mdt, |b| b.starts_with(b"\x01\xb0\x93\xff"), "NT-MDT MDT", ["mdt"], "general maps; scans, not checked against a real file";
        Sxm, sxm, |b| b.starts_with(b":NANONIS_VERSION:"), "Nanonis SXM", ["sxm"], "all channels, both ways";
        Zmg, zmg, |b| b.starts_with(b"Zeta-Instruments"), "Zeta ZMG", ["zmg"], "height; not checked against a real file";
        Os3d, os3d, |b| b.starts_with(formats::os3d::MAGIC), "OmniSurf3D OS3D", ["os3d"], "height with missing points; not checked against a real file";
        #[cfg(feature = "zip")]
        Mitutoyo, mitutoyo, formats::mitutoyo::sniff, "Mitutoyo workbook", ["xlsx"], "the profile of a SurfTest tester; checked against made workbooks only";
        Datx, hdf5, formats::hdf5::is_datx, "Zygo DATX", ["datx"], "all maps; not checked against a real file";
        Hdf5, hdf5, formats::hdf5::sniff, "HDF5", ["h5", "hdf5"], "every data set of two axes, or else of one, also of NetCDF-4 and MATLAB 7.3; unit from its attribute";
        #[cfg(feature = "zip")]
        Mnt, mnt, |b| b.starts_with(ole::MAGIC), "Digital Surf MNT", ["mnt"], "surfaces as they were loaded, with missing points; results of the document are not read";
        #[cfg(feature = "zip")]
        Softgauge, softgauge, formats::softgauge::sniff, "NIST softgauge", ["xml"], "profiles of NIST's algorithm testing system";
        Text, table, text::is_text, "text", ["csv", "asc", "tsv", "txt", "xyz"], "matrices, lists of x y z, profiles, several traces beside each other; any separator, decimal comma, missing cells";
    } };
}
pub(crate) use every_format;

macro_rules! names {
    ($($(#[$cfg:meta])? $variant:ident, $module:ident, $sniff:expr, $name:literal, [$($extension:literal),*], $about:literal;)*) => {
        /// A file format.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum Format {
            $(#[doc = $name] $variant,)*
            /// A container of others.
            Zip,
        }

        impl Format {
            /// Its name for people.
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name,)*
                    Self::Zip => "ZIP or gzip",
                }
            }
        }
    };
}

every_format!(names);

impl std::fmt::Display for Format {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}
