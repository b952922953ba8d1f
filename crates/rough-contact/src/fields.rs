//! What `solve` writes for each load: fields on the grid, and the table of spots.

use crate::outcome::{Failure, Folder};
use clap::{Args, ValueEnum};
use rough_contact::compare::{Spot, contact_spots};
use rough_contact::contact_types::{Grid, HeightMap};
use rough_contact::fft_bem_solver::Solution;
use rough_contact::surface_io::write;
use std::borrow::Cow;
use std::io::{self, Write};
use std::path::PathBuf;

/// What can be written of a solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Field {
    /// Pressure (Pa)
    Pressure,
    /// Gap (m), 0 where it touches
    Gap,
    /// Displacement of the surface into the body (m); its mean over a periodic map is zero
    Displacement,
    /// Levelled heights before contact (m)
    Heights,
    /// Table of the contact spots: area, load, centroid, pressure
    Spots,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum FieldFormat {
    /// One file for each field, f64, [ny, nx]
    Npy,
    /// One file for all fields of a load: VTK image data, for `ParaView`
    Vti,
    /// One file for all fields of a load: HDF5 with units and pixel size
    Hdf5,
}

#[derive(Args, Clone, Debug)]
pub(crate) struct FieldOptions {
    /// Folder for what --fields names, of each load: pressure-000.npy, gap-000.npy, …
    #[arg(long, value_name = "DIR")]
    pub(crate) maps: Option<PathBuf>,
    /// What to write to --maps
    #[arg(
        long = "fields",
        value_name = "LIST",
        value_enum,
        value_delimiter = ',',
        requires = "maps"
    )]
    #[arg(default_value = "pressure,gap")]
    asked: Vec<Field>,
    /// How to write fields to --maps
    #[arg(long, value_name = "KIND", value_enum, default_value = "npy", requires = "maps")]
    map_format: FieldFormat,
}

impl FieldOptions {
    /// The same into another folder.
    pub(crate) fn to(&self, maps: Option<PathBuf>) -> Self {
        Self { maps, ..self.clone() }
    }

    pub(crate) fn names(&self, loads: usize) -> Vec<String> {
        (0..loads).flat_map(|load| self.files(load)).map(|(name, _)| name).collect()
    }

    /// The files of a load, and which fields go into each.
    fn files(&self, load: usize) -> Vec<(String, Vec<Field>)> {
        let file = |name: &str, ending: &str| format!("{name}-{load:03}.{ending}");
        let drawn: Vec<Field> = self.asked.iter().copied().filter(|f| *f != Field::Spots).collect();
        let mut files = match self.map_format {
            FieldFormat::Npy => {
                drawn.into_iter().map(|f| (file(f.named().0, "npy"), vec![f])).collect()
            }
            _ if drawn.is_empty() => Vec::new(),
            FieldFormat::Vti => vec![(file("contact", "vti"), drawn)],
            FieldFormat::Hdf5 => vec![(file("contact", "h5"), drawn)],
        };
        if self.asked.contains(&Field::Spots) {
            files.push((file("spots", "csv"), vec![Field::Spots]));
        }
        files
    }

    /// True if this field is needed: itself, or for the displacement.
    pub(crate) fn needs(&self, field: Field) -> bool {
        let needs = |f: &Field| *f == field || *f == Field::Displacement;
        self.maps.is_some() && self.asked.iter().any(needs)
    }
}

impl Field {
    /// Its name, and the unit of its numbers; the columns of the table have their own.
    fn named(self) -> (&'static str, &'static str) {
        match self {
            Self::Pressure => ("pressure", "Pa"),
            Self::Gap => ("gap", "m"),
            Self::Displacement => ("displacement", "m"),
            Self::Heights => ("heights", "m"),
            Self::Spots => ("spots", ""),
        }
    }
}

/// Contact spots as a table (CSV), one row each; of ridges per length.
fn table(spots: &[Spot], grid: Grid, out: &mut impl Write) -> io::Result<()> {
    let is_line = grid.shape()[0] == 1;
    let sizes =
        if is_line { "length (m),load (N/m),x (m)" } else { "area (m^2),load (N),x (m),y (m)" };
    writeln!(out, "{sizes},mean_pressure (Pa),max_pressure (Pa),points")?;
    for Spot { area, load, centroid: [y, x], mean_pressure, max_pressure, points, .. } in spots {
        let y = if is_line { String::new() } else { format!(",{y:e}") };
        writeln!(out, "{area:e},{load:e},{x:e}{y},{mean_pressure:e},{max_pressure:e},{points}")?;
    }
    Ok(())
}

pub(crate) struct FieldFolder {
    folder: Folder,
    fields: FieldOptions,
    /// The levelled heights, where they are needed.
    pub(crate) surface: Option<HeightMap>,
    /// True if a spot at one edge goes on at the other.
    repeats: bool,
}

impl FieldFolder {
    /// Nothing without `--maps`. Looks for what is in the way, before any work is done.
    pub(crate) fn prepare(
        fields: FieldOptions,
        loads: usize,
        repeats: bool,
        force: bool,
    ) -> Result<Option<Self>, Failure> {
        let Some(path) = &fields.maps else { return Ok(None) };
        let folder = Folder::numbered(path, |loads| fields.names(loads), loads, force)?;
        Ok(Some(Self { folder, fields, surface: None, repeats }))
    }

    /// Writes what was asked for of one load.
    pub(crate) fn write(
        &self,
        load: usize,
        grid: Grid,
        solution: &Solution,
    ) -> Result<(), Failure> {
        for (name, fields) in self.fields.files(load) {
            if fields == [Field::Spots] {
                let (spots, _) = contact_spots(&solution.pressure, grid, self.repeats);
                self.folder.write(&name, |out| table(&spots, grid, out))?;
                continue;
            }
            let values: Vec<_> = fields.iter().map(|&f| self.values(f, solution)).collect();
            let all = || fields.iter().zip(&values).map(|(f, v)| (f.named(), v.as_ref()));
            self.folder.write(&name, |out| match self.fields.map_format {
                FieldFormat::Npy => write::npy(out, grid.shape(), &values[0]),
                FieldFormat::Vti => {
                    write::vti(out, grid, &all().map(|((n, _), v)| (n, v)).collect::<Vec<_>>())
                }
                FieldFormat::Hdf5 => {
                    let all: Vec<_> = all().map(|((n, unit), v)| (n, unit, v)).collect();
                    write::hdf5(out, grid, &all, "")
                }
            })?;
        }
        Ok(())
    }

    fn values<'a>(&'a self, field: Field, solution: &'a Solution) -> Cow<'a, [f64]> {
        let heights = self.surface.as_ref().map_or(&[][..], HeightMap::heights);
        match field {
            Field::Pressure | Field::Spots => Cow::Borrowed(&solution.pressure),
            Field::Gap => Cow::Owned(solution.open_gap()),
            Field::Heights => Cow::Borrowed(heights),
            Field::Displacement => {
                // The flat stands where it first touched, less the approach; a point lies under it by its gap.
                let highest = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                let flat = highest - solution.approach;
                heights.iter().zip(&solution.gap).map(|(z, g)| z + g - flat).collect()
            }
        }
    }
}
