//! The formats and what people call them. How each is recognised and read is in the catalogue.

macro_rules! formats {
    ($($variant:ident, $name:literal;)*) => {
        /// A file format.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum Format {
            $(#[doc = $name] $variant,)*
        }

        impl Format {
            /// Its name for people.
            pub fn name(self) -> &'static str {
                match self { $(Self::$variant => $name,)* }
            }
        }
    };
}

formats! {
    X3p, "X3P (ISO 25178-72)";
    Npz, "NPZ";
    Npy, "NPY";
    Sur, "Digital Surf SUR";
    Sdf, "SDF (ISO 25178-71)";
    Zygo, "Zygo MetroPro DAT";
    Opd, "Wyko OPD";
    Gwy, "Gwyddion GWY";
    Nanoscope, "Nanoscope";
    Al3d, "Alicona AL3D";
    Nms, "NanoFocus NMS";
    Tmd, "TrueMap TMD";
    Bcrf, "BCR-STM, BCRF";
    NetCdf, "NetCDF classic";
    Ibw, "Igor binary wave";
    Opdx, "Dektak OPDx";
    Frt, "FRT MicroProf";
    Mi, "Molecular Imaging MI";
    Nid, "Nanosurf NID";
    Wsxm, "WSxM";
    Plu, "Sensofar PLU";
    Vk, "Keyence VK";
    Zon, "Keyence ZON";
    Plux, "Sensofar PLUX";
    Lext, "Olympus LEXT";
    Oir, "Olympus OIR";
    Park, "Park Systems TIFF";
    Jpk, "JPK image";
    Tiff, "TIFF";
    Mdt, "NT-MDT MDT";
    Sxm, "Nanonis SXM";
    Zmg, "Zeta ZMG";
    Os3d, "OmniSurf3D OS3D";
    Mitutoyo, "Mitutoyo workbook";
    Datx, "Zygo DATX";
    Hdf5, "HDF5";
    Mnt, "Digital Surf MNT";
    Softgauge, "NIST softgauge";
    Text, "text";
    Zip, "ZIP or gzip";
}

impl std::fmt::Display for Format {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}
