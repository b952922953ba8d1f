//! Formats that are known by their first bytes and not read: their users learn what the file is
//! and what to do.
//!
//! | first bytes | what it is |
//! |---|---|
//! | `%PDF`, PNG, JPEG, BMP, GIF | documents and pictures |
//! | `Rar!`, `7z` | archives |
//! | `SIMPLE  =`, `MATLAB 5.0` | FITS, MATLAB before 7.3 |
//! | `ply`, `OFF`, `# .PCD`, `LASF` | PLY and OFF meshes, point clouds of PCL and LAS |
//! | `solid` and `facet` soon after; a count at byte 80 that fits the size | STL as text, binary STL |
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

const GRID: &str = "its points stand on no grid: interpolate them to one (Gwyddion: File, Open, as \
                    XYZ data; CloudCompare: Rasterize) and save the map, for example as text";

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
    Foreign { magic: b"ply\n", name: "a PLY mesh", way_out: GRID },
    Foreign { magic: b"ply\r", name: "a PLY mesh", way_out: GRID },
    Foreign { magic: b"OFF\n", name: "an OFF mesh", way_out: GRID },
    Foreign { magic: b"OFF\r", name: "an OFF mesh", way_out: GRID },
    Foreign { magic: b"# .PCD", name: "a point cloud (PCD)", way_out: GRID },
    Foreign { magic: b"LASF", name: "a point cloud (LAS)", way_out: GRID },
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
    if is_stl(bytes) {
        return Some(ReadError::NotRead { name: "an STL mesh", way_out: GRID });
    }
    let found = FOREIGN.iter().find(|foreign| bytes.starts_with(foreign.magic))?;
    Some(ReadError::NotRead { name: found.name, way_out: found.way_out })
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn meshes_are_named_with_the_way_out() {
        let text = b"solid part\n  facet normal 0 0 1\n    outer loop\n      vertex 0 0 0\n";
        let mut binary = vec![0; 84 + 2 * 50];
        binary[80] = 2;
        for mesh in [&text[..], b" SOLID\r\nFACET NORMAL 0 0 1\r\n", &binary] {
            let error = recognise(mesh).unwrap().to_string();
            assert!(error.contains("an STL mesh") && error.contains("grid"), "{error}");
        }
        assert!(recognise(b"solid steel, measured\n1 2 3 4\n5 6 7 8\n").is_none());
        binary.push(0);
        assert!(recognise(&binary).is_none());
    }
}
