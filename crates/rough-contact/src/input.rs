//! A surface file and how to read it: the options every command with a FILE takes.

use crate::outcome::{self, Failure, unfit};
use crate::units::Dimension::{self, Length};
use crate::{args, quantity};
use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use rough_contact::compare::{Cleaning, FileOrigin, Origin, ProfileSurface, Surface, sha256_hex};
use rough_contact::contact_types::Named;
use rough_contact::front_end::Incomplete;
use rough_contact::surface_io::{
    Ambiguity, Cut, DecimalMark, Fill, FillError, Layout, Measurement, Need, ReadError,
};
use rough_contact::surface_stats::clean::Form;
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
        measurements(path, &mut self.origin(path), self.crop, false)
            .map(|(mut all, _)| all.swap_remove(0))
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
    let (mut all, fill) = measurements(path, &mut file, crop, hashed)?;
    if let Some(ambiguity) = all[0].ambiguity {
        tell_of(path, &reading(ambiguity));
    }
    let made = if all[0].is_profile() {
        front_end::traces(all, file, fill).map(|traces| One::Profile(Box::new(traces)))
    } else {
        front_end::complete(all.swap_remove(0), file, fill).map(|map| One::Map(Box::new(map)))
    };
    made.map_err(|e| unmade(path, &e))
}

/// Every trace of a file of several, one measurement of any other, cropped; and how missing points are filled.
fn measurements(
    path: &Path,
    file: &mut FileOrigin,
    crop: Option<Cut>,
    hashed: bool,
) -> Result<(Vec<Measurement>, Fill), Failure> {
    let (options, fill) = front_end::reading(file)?;
    let bytes = surface_io::load(path, &options.limits).map_err(|e| unread(path, &e))?;
    if hashed {
        file.sha256 = sha256_hex(&bytes);
    }
    let all = surface_io::read_traces_bytes(&bytes, &options).map_err(|e| unread(path, &e))?;
    let Some(measurement) = all.first() else {
        return Err(outcome::unfit(path, "empty", "nothing is there"));
    };
    if let Some(unit) = measurement.metadata.get("height unit of the file, kept") {
        let kept = "which is kept; --override-height-unit U would overrule it";
        tell_of(path, &format!("the file gives its heights in {unit}, {kept}"));
    }
    if let Some(pixel) = measurement.metadata.get("overridden pixel") {
        tell_of(path, &format!("the file gives a pixel of {pixel}, which --pixel overrules"));
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
    let cut = |m: Measurement| m.crop(crop).map_err(|e| unread(path, &e));
    let all: Vec<Measurement> = all.into_iter().map(cut).collect::<Result<_, _>>()?;
    if let (Some(part), false) = (all[0].cropped, matches!(crop, Cut::Rectangle(_))) {
        tell_of(path, &format!("--crop {crop} is --crop {}", Cut::Rectangle(part)));
    }
    Ok((all, fill))
}

fn tell_of(path: &Path, what: &str) {
    outcome::tell(&format!("rough-contact: {}: {what}", path.display()));
}

/// Done in this order on the valid points, before missing points are filled.
#[derive(Args, Clone, Copy, Debug, Default)]
pub(crate) struct CleaningOptions {
    /// Put rows in line that stand at heights of their own, by the median of their differences
    #[arg(long)]
    align_rows: bool,
    /// Make spikes missing points: those more than so many robust standard deviations from their
    /// neighbours; 8 is usual
    #[arg(long, value_name = "THRESHOLD", value_parser = threshold, allow_hyphen_values = true)]
    outliers: Option<f64>,
    /// Take a form off by least squares: plane, quadratic, polynomial:N, sphere or cylinder
    #[arg(long, value_name = "FORM", value_parser = str::parse::<Form>)]
    form: Option<Form>,
    /// Take waves shorter than this off (Gaussian, ISO 16610-61)
    #[arg(long, value_name = "CUTOFF", value_parser = args::one(Length), allow_hyphen_values = true)]
    s_filter: Option<f64>,
    /// Take waves longer than this off (Gaussian, ISO 16610-61)
    #[arg(long, value_name = "CUTOFF", value_parser = args::one(Length), allow_hyphen_values = true)]
    l_filter: Option<f64>,
}

fn threshold(text: &str) -> Result<f64, String> {
    match quantity::parse(text, Dimension::Number) {
        Ok(value) if value > 0.0 => Ok(value),
        Ok(value) => Err(format!("the threshold {value} must be greater than 0; 8 is usual")),
        Err(error) => Err(error.to_string()),
    }
}

impl CleaningOptions {
    pub(crate) fn asked(self) -> Cleaning {
        let Self { align_rows, outliers, form, s_filter, l_filter } = self;
        Cleaning { align_rows, outliers, form, s_filter, l_filter }
    }

    /// Refuses cleaning where there is no file to be cleaned.
    pub(crate) fn refuse_without_file(self) -> Result<(), Failure> {
        if self.asked() == Cleaning::default() {
            return Ok(());
        }
        let message = "--align-rows, --outliers, --form, --s-filter and --l-filter clean a surface FILE, and \
                       none is given; name a FILE or leave them out";
        Err(Failure::refused("usage", message))
    }
}

/// The refusal of a file, with the options that would let it be read.
fn unread(path: &Path, error: &ReadError) -> Failure {
    let way_out = match error {
        ReadError::UnknownFormat { .. } => "`rough-contact info --list` lists them".to_owned(),
        ReadError::PixelContradicts { .. } => "give --pixel DX,DY in that ratio".to_owned(),
        ReadError::BadLayout { .. } => "leave out --layout, or give the other one".to_owned(),
        ReadError::Limit { .. } => return Failure::in_file(path, error), // no option raises it
        _ => options(&error.needs()),
    };
    Failure::in_file(path, error).adding(&way_out)
}

/// The refusal of a measurement, with the options that would let it be answered.
fn unmade(path: &Path, error: &Incomplete) -> Failure {
    match error {
        Incomplete::Line(_) => {
            let row = "and no profile, which is one row (`rough-contact info` still reads it)";
            unfit(path, "profile", format!("{error}, {row}"))
        }
        Incomplete::Spikes(spikes) => {
            let ending = if *spikes == 1 { "" } else { "s" };
            let why = format!(
                "--outliers made {spikes} spike{ending} missing points, and --fill refuse keeps none; add --fill \
                 harmonic or --fill nearest, or raise the threshold"
            );
            unfit(path, "missing", why)
        }
        Incomplete::Rows => unfit(path, "profile", error).adding("leave --align-rows out"),
        Incomplete::Form => {
            unfit(path, "profile", error).adding("give --form polynomial:2, or another degree")
        }
        Incomplete::Cleaning(e) => Failure::in_file(path, e),
        Incomplete::Clean(e) => Failure::in_file(path, e),
        Incomplete::Short(e) => Failure::in_file(path, e).adding("measure a longer trace"),
        Incomplete::Fill(e @ FillError::NotConverged { .. }) => {
            Failure::in_file(path, e).adding("use --fill nearest")
        }
        Incomplete::Fill(e) => Failure::in_file(path, e).adding(&options(&e.needs())),
    }
}

/// How a text was read that could mean something else, and the option that settles it.
pub(crate) fn reading(ambiguity: Ambiguity) -> String {
    format!("{}; {}", ambiguity.what, options(ambiguity.needs))
}

fn options(needs: &[Need]) -> String {
    let is_scale =
        |need: &&Need| matches!(need, Need::PixelSize | Need::LateralUnit | Need::HeightUnit);
    let scales: Vec<&str> = needs.iter().filter(is_scale).map(|need| option(*need)).collect();
    if scales.is_empty() {
        return needs.iter().map(|need| option(*need)).collect::<Vec<_>>().join("; ");
    }
    format!("add {}", scales.join(" and "))
}

fn option(need: Need) -> &'static str {
    match need {
        Need::PixelSize => "--pixel DX[,DY]",
        Need::LateralUnit => "--lateral-unit U",
        Need::HeightUnit => "--height-unit U",
        Need::Channel => "choose one with --channel NAME",
        Need::Layout(Layout::Matrix) => "if they are heights, give --layout matrix",
        Need::Layout(Layout::List) => "if they are coordinates, give --layout list",
        Need::Layout(Layout::Traces) => "if they are traces of a stylus, give --layout traces",
        Need::DecimalMark => "give --decimal point or --decimal comma",
        Need::MissingMark => "if it marks missing points, give --missing MARK",
        Need::OtherHeightUnit => {
            "if they are heights in another unit, give --override-height-unit U"
        }
        Need::Fill => {
            "fill them with --fill harmonic or --fill nearest, or cut out the largest complete \
             part with --crop complete"
        }
        _ => "",
    }
}
