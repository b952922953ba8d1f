//! Options that several commands share, and the options as one: the sections of the help, and what `--from` excludes.

use crate::outcome::Failure;
use crate::quantity;
use crate::units::Dimension::{self, Length, Pressure};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Arg, Args, Command};
use rough_contact::compare::{self, INPUTS, built_in};
use rough_contact::contact_types::Named;

#[derive(Args, Clone, Copy)]
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

/// Of each section the options that both helps show, and those that only `--help` does. Others stand first.
const SECTIONS: [(&str, &str, &str); 6] = [
    ("Materials", "modulus young poisson material hardness", "work-of-adhesion attraction-range"),
    ("Loads", "pressure load", "gap area headline separation"),
    (
        "Surface",
        "pixel height-unit fill crop level edges against",
        "channel lateral-unit override-height-unit layout decimal missing boundary plane-strain flip shift \
         against-options align-rows outliers form s-filter l-filter fractal-range",
    ),
    (
        "Joint and leak",
        "resistivity conductivity gas leak",
        "gas-pressure temperature accommodation viscosity pressure-drop seal-length seal-width stiffness",
    ),
    ("Accuracy", "accuracy fast", "tolerance precision method certify"),
    (
        "Output",
        "out maps json",
        "fields map-format distributions models gamma summary resume from quiet threads force",
    ),
];

/// The command with its options in sections. `words` are those of the command line: the help of a model that is
/// named there shows what it is made from, and not what others are.
pub(crate) fn grouped(command: Command, words: &[String]) -> Command {
    let model = words.iter().find_map(|word| compare::find(word));
    let placed = |arg: Arg, is_model: bool| {
        let name = arg.get_long().unwrap_or_default().to_owned();
        let among = |list: &str| list.split_whitespace().any(|option| option == name);
        if let Some((heading, _, rare)) =
            SECTIONS.iter().find(|(_, usual, rare)| among(usual) || among(rare))
        {
            return arg.help_heading(*heading).hide_short_help(among(rare));
        }
        match (INPUTS.iter().find(|fact| is_model && fact.name == name), model) {
            (Some(fact), Some(theory)) => arg.hide(!theory.card().takes(fact.input)),
            (Some(_), None) => arg.hide_short_help(true),
            (None, _) => arg,
        }
    };
    let names: Vec<String> = command.get_subcommands().map(|c| c.get_name().to_owned()).collect();
    let command = command.mut_args(|arg| placed(arg, false));
    let command = names.into_iter().fold(command, |command, name| {
        let is_model = name == "model";
        command.mut_subcommand(name, |sub| {
            let sub = sub.mut_args(|arg| placed(arg, is_model));
            if is_model && model.is_none() {
                sub.after_help("`rough-contact model NAME -h` shows what a model is made from, --list all of them.")
            } else {
                sub
            }
        })
    });
    command.mut_subcommand("compare", alone)
}

/// The study, whose `--from` excludes all but `--out`: a run file has every setting of its run.
fn alone(compare: Command) -> Command {
    let ids = compare.get_arguments().map(Arg::get_id);
    let others: Vec<_> =
        ids.filter(|id| !["from", "out"].contains(&id.as_str())).cloned().collect();
    compare.mut_arg("from", |arg| arg.conflicts_with_all(others))
}
