//! `rough-contact convert`: the heights of a file, cleaned and levelled as asked, in another format.

use crate::args::{self, CommonOptions};
use crate::input::{FileOptions, One};
use crate::outcome::{self, Failure, Reply, unfit};
use crate::text::{self, TwoColumns};
use clap::Args;
use rough_contact::compare::Level;
use rough_contact::contact_types::{HeightMap, Named};
use rough_contact::report;
use rough_contact::surface_io::write;
use serde_json::json;
use std::io::{Seek, Write};
use std::path::{Path, PathBuf};

#[derive(Args)]
pub(crate) struct Convert {
    /// Surface file; recognised by its content
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// Form to remove by least squares; without it the heights stay as they are
    #[arg(long, value_name = "FORM", value_parser = args::one_of::<Level>(), default_value = "none")]
    level: Level,
    /// File to write; its ending chooses the format: .x3p, .npy, .sdf, .txt, .vti or .h5
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    #[command(flatten)]
    how: FileOptions,
}

impl Convert {
    pub(crate) fn run(&self, common: &CommonOptions) -> Result<Reply, Failure> {
        let format = MapFormat::of(&self.out)?;
        outcome::check(&self.out, common.force)?;
        let shown = self.file.display().to_string();
        let One::Map(surface) = self.how.measured(&self.file, false)? else {
            let why = "a profile is no map, and maps are what is written";
            return Err(unfit(&self.file, "profile", why));
        };
        let (missing, cleaned) = (surface.origin.missing(), surface.origin.cleaned());
        let refused = |e| Failure::in_file(&self.file, &e);
        let (form, map) = self.level.taken_off(surface.heights).map_err(refused)?;
        let steps: Vec<String> = cleaned.iter().map(ToString::to_string).collect();
        let comment = format!(
            "rough-contact convert {shown}: {missing} points filled; level {}; cleaned: {}",
            form.name(),
            if steps.is_empty() { "nothing".to_owned() } else { steps.join("; ") }
        );
        outcome::write(&self.out, |writer| format.write(writer, &map, &comment))?;
        let [ny, nx] = map.grid().shape();
        let [dy, dx] = map.grid().pixel();
        let (low, high) = map.range();
        let mut table = TwoColumns::default();
        table.row("wrote", self.out.display().to_string());
        table.row("points", format!("{ny} rows × {nx} columns, {missing} filled in"));
        table.row("pixel", format!("{} × {} (dy × dx)", text::length(dy), text::length(dx)));
        table.row("level", form.name());
        table.row("heights", text::length_range(low, high));
        if format.0 == "npy" {
            table.row("note", "NPY has no place for the pixel size and the unit (metres)");
        }
        let json = json!({
            "path": self.out.to_string_lossy(),
            "shape": [ny, nx],
            "pixel": [dy, dx],
            "missing": missing,
            "level": form.name(),
            "height_min": low,
            "height_max": high,
            "cleaning": report::cleaning_json(cleaned),
        });
        Ok(Reply::new(text::cleaning(cleaned) + &table.to_string(), json))
    }
}

/// A format by its ending.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MapFormat(&'static str);

const ENDINGS: [&str; 8] = ["x3p", "npy", "sdf", "txt", "asc", "vti", "h5", "hdf5"];

impl MapFormat {
    pub(crate) fn of(path: &Path) -> Result<Self, Failure> {
        let ending = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        ENDINGS.into_iter().find(|known| *known == ending).map(Self).ok_or_else(|| {
            let why = format!("the ending '{ending}' is no format this command writes; use .");
            unfit(path, "unknown_format", why + &ENDINGS.join(", ."))
        })
    }

    /// Writes the heights; `comment` where the format has a place for it.
    pub(crate) fn write(
        self,
        out: &mut (impl Write + Seek),
        map: &HeightMap,
        comment: &str,
    ) -> std::io::Result<()> {
        match self.0 {
            "npy" => write::npy(out, map.grid().shape(), map.heights()),
            "x3p" => write::x3p(out, map, comment),
            "sdf" => write::sdf(out, map),
            "txt" | "asc" => write::text(out, map),
            "vti" => write::vti(out, map.grid(), &[("height", map.heights())]),
            _ => write::hdf5(out, map.grid(), &[("height", "m", map.heights())], comment),
        }
    }
}
