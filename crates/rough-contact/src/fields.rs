//! What `solve` writes for each load: fields on the grid, and the table of spots.

use crate::outcome::Failure;
use crate::output::Folder;
use clap::{Args, ValueEnum};
use rough_contact::compare::spot_list;
use rough_contact::contact_types::{Grid, HeightMap};
use rough_contact::fft_bem_solver::Solution;
use rough_contact::report;
use rough_contact::surface_io::write;
use std::borrow::Cow;
use std::path::PathBuf;

/// What can be written of a solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Field {
    /// Pressure (Pa)
    Pressure,
    /// Gap (m); its zero is the pressure-weighted mean in contact
    Gap,
    /// Displacement of the surface into the body (m); its mean over a periodic map is zero
    Displacement,
    /// Levelled heights before contact (m)
    Heights,
    /// Table of the contact spots: area, load, centroid, pressure
    Spots,
}

/// Of what kind the files of fields are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Kind {
    /// One file for each field, f64, [ny, nx]
    Npy,
    /// One file for all fields of a load: VTK image data, for `ParaView`
    Vti,
    /// One file for all fields of a load: HDF5 with units and pixel size
    Hdf5,
}

/// What to write, and where.
#[derive(Args, Clone, Debug)]
pub(crate) struct Fields {
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
    map_format: Kind,
}

impl Fields {
    /// The same into another folder.
    pub(crate) fn to(&self, maps: Option<PathBuf>) -> Self {
        Self { maps, ..self.clone() }
    }

    /// The files for so many loads.
    pub(crate) fn names(&self, loads: usize) -> Vec<String> {
        let mut all = Vec::new();
        for load in 0..loads {
            let drawn: Vec<_> = self.asked.iter().filter(|f| **f != Field::Spots).collect();
            match self.map_format {
                Kind::Npy => all.extend(drawn.iter().map(|f| file(f.name(), load, "npy"))),
                _ if drawn.is_empty() => {}
                Kind::Vti => all.push(file("contact", load, "vti")),
                Kind::Hdf5 => all.push(file("contact", load, "h5")),
            }
            if self.asked.contains(&Field::Spots) {
                all.push(file("spots", load, "csv"));
            }
        }
        all
    }

    /// True if the gap has to be kept.
    pub(crate) fn needs_gap(&self) -> bool {
        let needs = |f: &Field| matches!(f, Field::Gap | Field::Displacement);
        self.maps.is_some() && self.asked.iter().any(needs)
    }

    /// True if the heights are needed, which a chosen grid does not have.
    pub(crate) fn needs_heights(&self) -> bool {
        let needs = |f: &Field| matches!(f, Field::Heights | Field::Displacement);
        self.maps.is_some() && self.asked.iter().any(needs)
    }
}

fn file(name: &str, load: usize, ending: &str) -> String {
    format!("{name}-{load:03}.{ending}")
}

impl Field {
    fn name(self) -> &'static str {
        match self {
            Self::Pressure => "pressure",
            Self::Gap => "gap",
            Self::Displacement => "displacement",
            Self::Heights => "heights",
            Self::Spots => "spots",
        }
    }

    /// Unit of its numbers; the columns of the table have their own.
    fn unit(self) -> &'static str {
        match self {
            Self::Pressure => "Pa",
            Self::Gap | Self::Displacement | Self::Heights => "m",
            Self::Spots => "",
        }
    }
}

/// A folder, and what goes there.
pub(crate) struct Sink {
    folder: Folder,
    fields: Fields,
    /// The levelled heights, where they are needed.
    pub(crate) surface: Option<HeightMap>,
    /// True if a spot at one edge goes on at the other.
    repeats: bool,
}

impl Sink {
    /// Nothing without `--maps`. Looks for what is in the way, before any work is done.
    pub(crate) fn prepare(
        fields: &Fields,
        loads: usize,
        repeats: bool,
        force: bool,
    ) -> Result<Option<Self>, Failure> {
        let Some(path) = &fields.maps else { return Ok(None) };
        let folder = Folder::prepare(path, &fields.names(loads), force)?;
        Ok(Some(Self { folder, fields: fields.clone(), surface: None, repeats }))
    }

    /// Writes what was asked for of one load.
    pub(crate) fn write(
        &self,
        load: usize,
        grid: Grid,
        solution: &Solution,
    ) -> Result<(), Failure> {
        let drawn: Vec<Field> =
            self.fields.asked.iter().copied().filter(|f| *f != Field::Spots).collect();
        let values = |field| self.values(field, solution);
        match self.fields.map_format {
            Kind::Npy => {
                for field in drawn {
                    let (name, values) = (file(field.name(), load, "npy"), values(field));
                    self.folder.write(&name, |out| write::npy_array(out, grid.shape(), &values))?;
                }
            }
            _ if drawn.is_empty() => {}
            Kind::Vti => {
                let all: Vec<_> = drawn.iter().map(|&f| (f.name(), values(f))).collect();
                let all: Vec<(&str, &[f64])> = all.iter().map(|(n, v)| (*n, v.as_ref())).collect();
                self.folder
                    .write(&file("contact", load, "vti"), |out| write::vti(out, grid, &all))?;
            }
            Kind::Hdf5 => {
                let all: Vec<_> = drawn.iter().map(|&f| (f.name(), f.unit(), values(f))).collect();
                let all: Vec<(&str, &str, &[f64])> =
                    all.iter().map(|(n, u, v)| (*n, *u, v.as_ref())).collect();
                self.folder
                    .write(&file("contact", load, "h5"), |out| write::hdf5(out, grid, &all, ""))?;
            }
        }
        if self.fields.asked.contains(&Field::Spots) {
            let spots = spot_list(&solution.pressure, grid, self.repeats);
            let name = file("spots", load, "csv");
            self.folder.write(&name, |out| report::write_spots_csv(&spots, out))?;
        }
        Ok(())
    }

    fn values<'a>(&'a self, field: Field, solution: &'a Solution) -> Cow<'a, [f64]> {
        let heights = self.surface.as_ref().map_or(&[][..], HeightMap::heights);
        match field {
            Field::Pressure | Field::Spots => Cow::Borrowed(&solution.pressure),
            Field::Gap => Cow::Borrowed(&solution.gap),
            Field::Heights => Cow::Borrowed(heights),
            Field::Displacement => {
                // The flat stands where it first touched, less the approach; what is left of a point under it
                // is its gap.
                let highest = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                let flat = highest - solution.approach;
                heights.iter().zip(&solution.gap).map(|(z, g)| z + g - flat).collect()
            }
        }
    }
}
