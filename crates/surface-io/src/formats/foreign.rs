//! Formats that are known by their first bytes and not read: their users learn what the file is
//! and what to do.
//!
//! | first bytes | what it is |
//! |---|---|
//! | `%PDF`, PNG, JPEG, BMP, GIF | documents and pictures |
//! | `Rar!`, `7z` | archives |
//! | `SIMPLE  =`, `MATLAB 5.0`, `solid `, `ply` | FITS, MATLAB before 7.3, STL, PLY |
//! | `ARDF`, `WIT_PR` | force maps of Asylum, projects of WITec |
//!
//! Formats that are read are in the catalogue, not here.

use crate::error::ReadError;

struct Foreign {
    magic: &'static [u8],
    name: &'static str,
    way_out: &'static str,
}

const PICTURE: &str = "a picture holds colours, not heights; export the data from the instrument's \
                       program, for example as X3P, SUR, SDF or text";

const FOREIGN: &[Foreign] = &[
    Foreign { magic: b"\x89PNG\r\n\x1a\n", name: "a PNG picture", way_out: PICTURE },
    Foreign { magic: b"\xff\xd8\xff", name: "a JPEG picture", way_out: PICTURE },
    Foreign { magic: b"GIF8", name: "a GIF picture", way_out: PICTURE },
    Foreign {
        magic: b"%PDF",
        name: "a PDF document",
        way_out: "export the data from the program that made it, for example as X3P or text",
    },
    Foreign { magic: b"SIMPLE  =", name: "a FITS file", way_out: "save its array as NPY" },
    Foreign {
        magic: b"MATLAB 5.0 MAT-file",
        name: "a MATLAB file of a version before 7.3",
        way_out: "save it in MATLAB with `-v7.3`, which is HDF5, or as text",
    },
    Foreign {
        magic: b"ply\n",
        name: "a PLY mesh",
        way_out: "put its points on a grid and save them as x y z text",
    },
    Foreign {
        magic: b"ARDF",
        name: "an Asylum ARDF file of force maps",
        way_out: "export the height channel as IBW",
    },
    Foreign {
        magic: b"WIT_PR",
        name: "a WITec project",
        way_out: "export the height image as text",
    },
    Foreign { magic: b"Rar!", name: "a RAR archive", way_out: "unpack it and name a file in it" },
    Foreign {
        magic: b"7z\xbc\xaf\x27\x1c",
        name: "a 7z archive",
        way_out: "unpack it and name a file in it",
    },
];

/// The refusal of a file that is none of ours, by its first bytes.
pub(crate) fn recognise(bytes: &[u8]) -> Option<ReadError> {
    let found = FOREIGN.iter().find(|foreign| bytes.starts_with(foreign.magic))?;
    Some(ReadError::NotRead { name: found.name, way_out: found.way_out })
}
