//! Maps out, in the format that a file name asks for.

use crate::outcome::{Failure, unfit};
use rough_contact::contact_types::HeightMap;
use rough_contact::surface_io::write;
use std::io::{Seek, Write};
use std::path::Path;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MapFormat {
    Npy,
    X3p,
    Sdf,
    Text,
    Vti,
    Hdf5,
}

const ENDINGS: [(MapFormat, &[&str]); 6] = [
    (MapFormat::X3p, &["x3p"]),
    (MapFormat::Npy, &["npy"]),
    (MapFormat::Sdf, &["sdf"]),
    (MapFormat::Text, &["txt", "asc"]),
    (MapFormat::Vti, &["vti"]),
    (MapFormat::Hdf5, &["h5", "hdf5"]),
];

impl MapFormat {
    pub(crate) fn of(path: &Path) -> Result<Self, Failure> {
        let ending = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        let found = ENDINGS.iter().find(|(_, endings)| endings.contains(&ending.as_str()));
        found.map(|(format, _)| *format).ok_or_else(|| {
            let all: Vec<&str> = ENDINGS.iter().flat_map(|(_, e)| *e).copied().collect();
            let why = format!("the ending '{ending}' is no format this command writes; use .");
            unfit(path, "unknown_format", why + &all.join(", ."))
        })
    }

    /// Writes the heights; `comment` where the format has a place for it.
    pub(crate) fn write(
        self,
        out: &mut (impl Write + Seek),
        map: &HeightMap,
        comment: &str,
    ) -> std::io::Result<()> {
        match self {
            Self::Npy => write::npy(out, map.grid().shape(), map.heights()),
            Self::X3p => write::x3p(out, map, comment),
            Self::Sdf => write::sdf(out, map),
            Self::Text => write::text(out, map),
            Self::Vti => write::vti(out, map.grid(), &[("height", map.heights())]),
            Self::Hdf5 => write::hdf5(out, map.grid(), &[("height", "m", map.heights())], comment),
        }
    }
}
