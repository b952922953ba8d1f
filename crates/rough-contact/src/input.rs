//! A surface file and how to read it: the options every command with a FILE takes.

use crate::args;
use crate::cleaning::CleaningOptions;
use crate::needs;
use crate::outcome::{self, Failure};
use crate::profiles;
use crate::quantity;
use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use rough_contact::compare::{FileOrigin, Origin, ProfileSurface, Surface, sha256_hex};
use rough_contact::contact_types::Named;
use rough_contact::surface_io::{Cut, DecimalMark, Fill, Layout, Measurement, Need};
use rough_contact::{front_end, surface_io};
use std::path::Path;

/// How missing points can be filled: a rule by its name.
fn fills() -> impl TypedValueParser<Value = Fill> {
    let about = |fill| match fill {
        Fill::Refuse => "Missing points are an error",
        Fill::Harmonic => {
            "A smooth surface through the neighbours: the solution of Laplace's equation"
        }
        Fill::Nearest => "The height of the nearest point",
    };
    let shown = |fill: Fill| PossibleValue::new(fill.name()).help(about(fill));
    PossibleValuesParser::new(Fill::all().map(shown))
        .map(|name| Fill::of_name(&name).expect("clap accepts only these names"))
}

/// What the file does not say, and which part of it is wanted.
#[derive(Args, Clone, Debug)]
pub(crate) struct ReadingOptions {
    /// Channel to read: its name, a part of it, or #2 [default: the topography]
    #[arg(long, value_name = "NAME")]
    pub(crate) channel: Option<String>,
    /// Distance of neighbouring points, if the file does not say
    #[arg(long, value_name = "DX[,DY]", value_parser = args::pixel, allow_hyphen_values = true)]
    pub(crate) pixel: Option<[f64; 2]>,
    /// Unit of x and y in a list of coordinates, if the file does not say
    #[arg(long, value_name = "U", value_parser = quantity::parse_length_unit)]
    pub(crate) lateral_unit: Option<f64>,
    /// Unit of the heights, if the file does not say
    #[arg(long, value_name = "U", value_parser = quantity::parse_length_unit)]
    pub(crate) height_unit: Option<f64>,
    /// Unit of the heights, whatever the file says
    #[arg(long, value_name = "U", value_parser = quantity::parse_length_unit)]
    #[arg(conflicts_with = "height_unit")]
    pub(crate) override_height_unit: Option<f64>,
    /// What the columns of a text file are [default: what its header and numbers say]
    #[arg(long, value_name = "WHAT", value_parser = args::one_of::<Layout>())]
    pub(crate) layout: Option<Layout>,
    /// Decimal mark of a text file, where 1,855 can be below two or thousands
    #[arg(long, value_name = "MARK", value_parser = args::one_of::<DecimalMark>())]
    pub(crate) decimal: Option<DecimalMark>,
    /// What stands where a point is missing: a word of a text, or a number in the unit of the file; can be
    /// repeated [default: NaN, empty cells and the usual words]
    #[arg(long, value_name = "MARK", allow_hyphen_values = true)]
    pub(crate) missing: Vec<String>,
    /// What to do with missing points
    #[arg(long, value_parser = fills(), default_value = "refuse", value_name = "RULE")]
    pub(crate) fill: Fill,
    /// Cut out NY x NX points from row Y0, column X0; `complete`: the largest part without missing
    /// points; `middle`: the middle half of each side
    #[arg(long, value_name = "Y0,X0,NY,NX", value_parser = str::parse::<Cut>)]
    pub(crate) crop: Option<Cut>,
}

#[derive(Args, Clone, Debug)]
pub(crate) struct FileOptions {
    #[command(flatten)]
    pub(crate) reading: ReadingOptions,
    #[command(flatten)]
    pub(crate) cleaning: CleaningOptions,
}

pub(crate) enum One {
    Map(Box<Surface>),
    Profile(Box<ProfileSurface>),
}

impl One {
    pub(crate) fn named(&mut self) -> (&mut String, &Origin) {
        match self {
            Self::Map(map) => (&mut map.name, &map.origin),
            Self::Profile(profile) => (&mut profile.name, &profile.origin),
        }
    }
}

impl ReadingOptions {
    /// What the options say of a file, as a run that repeats it has it.
    fn origin(&self, path: &Path) -> FileOrigin {
        FileOrigin {
            path: path.display().to_string(),
            channel: self.channel.clone(),
            pixel: self.pixel,
            lateral_unit: self.lateral_unit,
            height_unit: self.height_unit,
            override_height_unit: self.override_height_unit,
            layout: self.layout.map(|layout| layout.name().to_owned()),
            decimal: self.decimal.map(|mark| mark.name().to_owned()),
            missing_marks: self.missing.clone(),
            fill: self.fill.name().to_owned(),
            ..FileOrigin::default()
        }
    }

    /// Numbers as they stand in a file that does not say their units, and what it does not say; `None` if something
    /// else is wrong with the file.
    pub(crate) fn raw(&self, path: &Path) -> Option<(Measurement, Vec<Need>)> {
        let (options, _) = front_end::reading(&self.origin(path)).ok()?;
        let found = front_end::raw(options, |options| surface_io::read(path, options)).ok()?;
        // A file that says all has another fault.
        Some(found).filter(|(_, missing)| !missing.is_empty())
    }

    /// Reads and crops; missing points stay missing. Of several traces the first.
    pub(crate) fn measurement(&self, path: &Path) -> Result<Measurement, Failure> {
        measurements(path, &self.origin(path), self.crop).map(|(mut all, _)| all.swap_remove(0))
    }
}

impl FileOptions {
    /// What is in a file; with its hash, for a run that is to be repeated.
    pub(crate) fn measured(&self, path: &Path, hashed: bool) -> Result<One, Failure> {
        let mut file = self.reading.origin(path);
        file.cleaning = self.cleaning.asked();
        from_file(path, file, self.reading.crop, hashed)
    }
}

/// A complete surface, or the traces of one: read, cropped, cleaned, filled.
pub(crate) fn from_file(
    path: &Path,
    mut file: FileOrigin,
    crop: Option<Cut>,
    hashed: bool,
) -> Result<One, Failure> {
    let (mut all, fill) = measurements(path, &file, crop)?;
    if hashed {
        let bytes = std::fs::read(path).map_err(|e| Failure::refused("io", e.to_string()))?;
        file.sha256 = sha256_hex(&bytes);
    }
    if let Some(reading) = all[0].ambiguity {
        tell_of(path, &needs::reading(reading));
    }
    let made = if all[0].is_profile() {
        profiles::refuse(path, file.cleaning)?;
        front_end::traces(all, file, fill).map(|traces| One::Profile(Box::new(traces)))
    } else {
        front_end::complete(all.swap_remove(0), file, fill).map(|map| One::Map(Box::new(map)))
    };
    made.map_err(|e| needs::unmade(path, &e))
}

/// Every trace of a file of several, one measurement of any other, cropped; and how missing points are filled.
fn measurements(
    path: &Path,
    file: &FileOrigin,
    crop: Option<Cut>,
) -> Result<(Vec<Measurement>, Fill), Failure> {
    let (options, fill) = front_end::reading(file)?;
    let all = surface_io::read_traces(path, &options).map_err(|e| needs::unread(path, &e))?;
    let Some(measurement) = all.first() else {
        return Err(outcome::unfit(path, "empty", "nothing is there"));
    };
    if let Some(unit) = measurement.metadata.get("height unit of the file, kept") {
        let kept = "which is kept; --override-height-unit U would overrule it";
        tell_of(path, &format!("the file gives its heights in {unit}, {kept}"));
    }
    if let Some(what) = measurement.metadata.get("left out") {
        tell_of(path, &format!("{what} are left out"));
    }
    let readable = |c: &&surface_io::ChannelInfo| c.is_height && c.fault.is_none() && !c.is_trace;
    let heights = measurement.channels.iter().filter(readable).count();
    if file.channel.is_none() && heights > 1 {
        let what = format!(
            "{:?} is read, one of {heights} channels in units of length; \
             `info` lists them, --channel NAME reads another",
            measurement.channel
        );
        tell_of(path, &what);
    }
    let Some(crop) = crop else { return Ok((all, fill)) };
    let cut = |m: Measurement| m.crop(crop).map_err(|e| needs::unread(path, &e));
    let all: Vec<Measurement> = all.into_iter().map(cut).collect::<Result<_, _>>()?;
    if let (Some(part), false) = (all[0].cropped, matches!(crop, Cut::Rectangle(_))) {
        tell_of(path, &format!("--crop {crop} is --crop {}", Cut::Rectangle(part)));
    }
    Ok((all, fill))
}

fn tell_of(path: &Path, what: &str) {
    outcome::tell(&format!("rough-contact: {}: {what}", path.display()));
}
