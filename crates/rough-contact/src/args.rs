//! Options that several commands share.

use crate::outcome::Failure;
use crate::quantity;
use crate::units::Dimension::{self, Length, Pressure};
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use rough_contact::compare::built_in;
use rough_contact::contact_types::Named;

#[derive(Args)]
pub(crate) struct CommonOptions {
    /// One JSON object on standard output, nothing else there
    #[arg(long, global = true)]
    pub(crate) json: bool,
    /// No progress on standard error
    #[arg(long, global = true)]
    pub(crate) quiet: bool,
    /// Threads to use; results do not depend on it [default: all]
    #[arg(long, global = true, value_name = "N", value_parser = threads)]
    pub(crate) threads: Option<usize>,
    /// Overwrite outputs that exist
    #[arg(long, global = true)]
    pub(crate) force: bool,
}

impl CommonOptions {
    /// Threads asked for, or as many as the machine has.
    pub(crate) fn threads(&self) -> usize {
        let all = || std::thread::available_parallelism().map_or(1, usize::from);
        self.threads.unwrap_or_else(all)
    }
}

fn threads(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(n) if (1..=1024).contains(&n) => Ok(n),
        _ => Err(format!("'{text}' is not a number of threads from 1 to 1024")),
    }
}

/// A list of quantities as one argument, so that clap shows it as one value.
#[derive(Clone, Debug)]
pub(crate) struct List(pub(crate) Vec<f64>);

pub(crate) fn one(
    dimension: Dimension,
) -> impl Fn(&str) -> Result<f64, Failure> + Clone + Send + Sync + 'static {
    move |text| quantity::parse(text, dimension)
}

pub(crate) fn list(
    dimension: Dimension,
) -> impl Fn(&str) -> Result<List, Failure> + Clone + Send + Sync + 'static {
    move |text| quantity::parse_list(text, dimension).map(List)
}

/// A hardness, or `elastic` for bodies that do not yield, as infinity.
pub(crate) fn hardness(text: &str) -> Result<f64, Failure> {
    let is_elastic = text.trim().eq_ignore_ascii_case("elastic");
    if is_elastic { Ok(f64::INFINITY) } else { quantity::parse(text, Pressure) }
}

/// Lengths in metres, in the order in which they were typed.
pub(crate) fn lengths(text: &str) -> Result<Vec<f64>, String> {
    quantity::parse_list(text, Length).map_err(|e| e.to_string())
}

/// `DX` or `DX,DY` as `[dy, dx]` in metres.
pub(crate) fn pixel(text: &str) -> Result<[f64; 2], String> {
    match lengths(text)?[..] {
        [d] => Ok([d, d]),
        [dx, dy] => Ok([dy, dx]),
        _ => Err(format!("'{text}' is not DX or DX,DY; write for example 1um or 1um,2um")),
    }
}

/// `SHORT,LONG`: two wavelengths in metres.
pub(crate) fn range(text: &str) -> Result<[f64; 2], String> {
    let two = <[f64; 2]>::try_from(lengths(text)?);
    two.map_err(|_| format!("'{text}' is not two wavelengths; write for example 4um,100um"))
}

/// `NY,NX`: two counts.
pub(crate) fn shape(text: &str) -> Result<[usize; 2], String> {
    let counts: Result<Vec<usize>, _> = text.split(',').map(|n| n.trim().parse()).collect();
    let two = counts.ok().and_then(|counts| counts.try_into().ok());
    two.ok_or_else(|| format!("'{text}' is not NY,NX; write for example 512,512"))
}

/// One of a list of names that the library knows.
pub(crate) fn one_of<T: Named + Send + Sync>() -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(T::all().map(T::name)).map(move |text| {
        T::of_name(&text.to_ascii_lowercase()).expect("clap accepts only these names")
    })
}

/// The form taken off where nothing is said, by every command: the tilt of a mounting, unless the map repeats.
pub(crate) const LEVEL: &str = "auto";

/// Takes `--refine`, which is gone, and names what does its work.
pub(crate) fn refine_is_gone(_: &str) -> Result<bool, String> {
    Err("twice the points are solved where the answer depends on them, unasked; --accuracy A% climbs \
         until the area is known as well"
        .to_owned())
}

pub(crate) fn study_models() -> impl TypedValueParser<Value = String> {
    lower_case(built_in().of_studies().map(|t| t.card().name.as_ref()))
}

pub(crate) fn models() -> impl TypedValueParser<Value = String> {
    lower_case(built_in().iter().map(|t| t.card().name.as_ref()))
}

/// One of these names, which are in lower case, typed in any case where its option ignores case.
fn lower_case(names: impl Iterator<Item = &'static str>) -> impl TypedValueParser<Value = String> {
    PossibleValuesParser::new(names).map(|name| name.to_ascii_lowercase())
}
