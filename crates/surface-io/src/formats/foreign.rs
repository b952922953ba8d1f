//! Formats that are known by their first bytes and not read: their users learn what the file is
//! and what to do.
//!
//! Formats that are read are in the catalogue, not here.

use crate::error::ReadError;

const PICTURE: &str = "a picture holds colours, not heights; export the data from the instrument's \
                       program, for example as X3P, SUR, SDF or text";

const GRID: &str = "its points stand on no grid: interpolate them to one (Gwyddion: File, Open, as \
                    XYZ data; CloudCompare: Rasterize) and save the map, for example as text";

const EXPORT: &str = "export the data from the program that made it, for example as X3P or text";
const MATLAB: &str = "save it in MATLAB with `-v7.3`, which is HDF5, or as text";
const UNPACK: &str = "unpack it and name a file in it";

const FOREIGN: &[(&[u8], &str, &str)] = &[
    (b"\x89PNG\r\n\x1a\n", "a PNG picture", PICTURE),
    (b"\xff\xd8\xff", "a JPEG picture", PICTURE),
    (b"GIF8", "a GIF picture", PICTURE),
    (b"%PDF", "a PDF document", EXPORT),
    (b"SIMPLE  =", "a FITS file", "save its array as NPY"),
    (b"MATLAB 5.0 MAT-file", "a MATLAB file of a version before 7.3", MATLAB),
    (b"ply\n", "a PLY mesh", GRID),
    (b"ply\r", "a PLY mesh", GRID),
    (b"OFF\n", "an OFF mesh", GRID),
    (b"OFF\r", "an OFF mesh", GRID),
    (b"# .PCD", "a point cloud (PCD)", GRID),
    (b"LASF", "a point cloud (LAS)", GRID),
    (b"ARDF", "an Asylum ARDF file of force maps", "export the height channel as IBW"),
    (b"WIT_PR", "a WITec project", "export the height image as text"),
    (b"Rar!", "a RAR archive", UNPACK),
    (b"7z\xbc\xaf\x27\x1c", "a 7z archive", UNPACK),
];

/// The refusal of a file that is none of ours, by its first bytes.
pub(crate) fn recognise(bytes: &[u8]) -> Option<ReadError> {
    if is_stl(bytes) {
        return Some(ReadError::NotRead { name: "an STL mesh", way_out: GRID });
    }
    let &(_, name, way_out) = FOREIGN.iter().find(|(magic, ..)| bytes.starts_with(magic))?;
    Some(ReadError::NotRead { name, way_out })
}

/// Triangles as text, or 50 bytes for each behind a header of 80 bytes and their number.
fn is_stl(bytes: &[u8]) -> bool {
    let start = bytes[..bytes.len().min(1024)].to_ascii_lowercase();
    let is_text = start.trim_ascii_start().starts_with(b"solid")
        && crate::binary::find(&start, b"facet").is_some();
    let count = bytes.get(80..84).and_then(|raw| raw.try_into().ok()).map(u32::from_le_bytes);
    let fits = |n: u32| n > 0 && bytes.len() as u64 == 84 + 50 * u64::from(n);
    is_text || count.is_some_and(fits)
}
