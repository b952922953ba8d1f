//! What a model is made from: typed numbers, or the statistics of a surface file.

use crate::args::{self, List};
use crate::input::Complete;
use crate::outcome::Failure;
use crate::units::Dimension;
use clap::builder::ValueParser;
use clap::error::Error;
use clap::{Arg, ArgMatches, Args, Command, FromArgMatches};
use rough_contact::compare::{Card, INPUTS, Input, InputFact, InputUnit, Inputs, Level};
use rough_contact::contact_types::ContactModulus;
use rough_contact::front_end::typed::{Typed, Untyped};
use rough_contact::surface_stats::Edges;
use rough_contact::{compare, front_end};
use std::path::Path;

/// Roughness typed in, each number by an option of its name, and how a FILE is read instead.
#[derive(Clone)]
pub(crate) struct Source {
    typed: Typed,
    file: OfFile,
}

const HEADING: &str = "Roughness, typed in instead of FILE";

/// What stands for the value of an option that takes several numbers.
const LIST: &str = "LIST";

#[derive(Args, Clone)]
#[command(next_help_heading = HEADING)]
struct OfFile {
    /// Form to remove from a FILE by least squares first [default: plane]
    #[arg(long, value_name = "FORM", value_parser = args::one_of::<Level>())]
    level: Option<Level>,
    /// What lies beyond the edges of a FILE [default: open]
    #[arg(long, value_parser = args::one_of::<Edges>())]
    boundary: Option<Edges>,
}

fn option(fact: &InputFact) -> Arg {
    let (dimension, value) = match fact.unit {
        InputUnit::Number => (Dimension::Number, "X"),
        InputUnit::Length => (Dimension::Length, "L"),
        InputUnit::Area => (Dimension::Area, "A"),
        InputUnit::PerArea => (Dimension::PerArea, "N"),
        InputUnit::Pressure => (Dimension::Pressure, "P"),
        InputUnit::Lengths => (Dimension::Length, LIST),
        InputUnit::PerAreas => (Dimension::PerArea, LIST),
        InputUnit::Numbers => (Dimension::Number, LIST),
    };
    let parser = match value {
        LIST => ValueParser::new(args::list(dimension)),
        _ => ValueParser::new(args::one(dimension)),
    };
    let arg = Arg::new(fact.name).long(fact.name).value_name(value).value_parser(parser);
    arg.allow_hyphen_values(true).help(fact.help).help_heading(HEADING)
}

impl Args for Source {
    fn augment_args(command: Command) -> Command {
        OfFile::augment_args(command.args(INPUTS.iter().map(option)))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for Source {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, Error> {
        let typed = INPUTS.iter().fold(Typed::default(), |typed, fact| match fact.unit {
            InputUnit::Lengths | InputUnit::PerAreas | InputUnit::Numbers => {
                let list = matches.get_one::<List>(fact.name);
                typed.with_list(fact.input, list.map(|l| l.0.clone()))
            }
            _ => typed.with(fact.input, matches.get_one(fact.name).copied()),
        });
        Ok(Self { typed, file: OfFile::from_arg_matches(matches)? })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

/// The option of an input.
fn named(input: Input) -> String {
    format!("--{}", input.name())
}

/// The sets of options a model can be made from, the first the usual one.
pub(crate) fn options_of(card: &Card) -> Vec<String> {
    let shown = |set: &compare::InputSet| set.shown(named, " ");
    card.inputs.iter().map(shown).collect()
}

/// How a model could be made: from a file, and from numbers.
pub(crate) fn ways(card: &Card) -> String {
    let file = match (card.from_map, card.yields) {
        (true, _) => "a surface FILE, or ",
        (false, true) => "a surface FILE and --hardness, or ",
        _ => "",
    };
    format!("{file}{}", options_of(card).join(", or "))
}

impl Source {
    /// The inputs of a model from the numbers typed in; `hardness` is that of the table of materials. With
    /// a load or a conductance, --area has a use beside that of an input.
    pub(crate) fn typed(
        &self,
        card: &Card,
        modulus: ContactModulus,
        hardness: Option<f64>,
        area_has_use: bool,
    ) -> Result<Inputs, Failure> {
        let mut typed = self.typed.clone();
        let area = typed.one(Input::Area);
        let carries = area_has_use && !card.takes(Input::Area);
        if carries {
            typed = typed.without(Input::Area);
        }
        if card.requires(Input::Hardness) && typed.one(Input::Hardness).is_none() {
            typed = typed.with(Input::Hardness, hardness);
        }
        let inputs = typed.inputs(card, modulus).map_err(|untyped| {
            let message = untyped.told(card, named);
            match &untyped {
                Untyped::Model(error) => Failure::from_error(error),
                Untyped::Incomplete { given, missing } if given.is_empty() => {
                    let needed: Vec<String> = missing.iter().copied().map(named).collect();
                    let message =
                        format!("{} needs {}; give {}", card.name, needed.join(" "), ways(card));
                    Failure::refused("missing_input", message)
                }
                Untyped::Incomplete { .. } => Failure::refused("missing_input", message),
                _ => Failure::refused("usage", message),
            }
        })?;
        Ok(Inputs { nominal_area: area.or(inputs.nominal_area), ..inputs })
    }

    /// The hardness given (Pa).
    pub(crate) fn hardness(&self) -> Option<f64> {
        self.typed.one(Input::Hardness)
    }

    /// The nominal area given (m²).
    pub(crate) fn area(&self) -> Option<f64> {
        self.typed.one(Input::Area)
    }

    /// The form taken off a FILE.
    pub(crate) fn level(&self) -> Level {
        self.file.level.unwrap_or_default()
    }

    /// With what no file says.
    pub(crate) fn beside_file(&self, inputs: Inputs) -> Inputs {
        Inputs {
            gamma: self.typed.one(Input::Gamma),
            critical_area: self.typed.one(Input::CriticalArea),
            ..inputs
        }
    }

    /// What the model needs of a measured surface without this form, and nothing else.
    pub(crate) fn measured(
        &self,
        card: &Card,
        given: Inputs,
        path: &Path,
        surface: Complete,
        form: Level,
    ) -> Result<Inputs, Failure> {
        let edges = self.file.boundary.unwrap_or_default();
        let Complete { map, missing, .. } = surface;
        front_end::model::measured(card, given, path, map, missing, (form, edges))
    }

    /// An option that the model does not use is a mistake, not a wish.
    /// With a load or a conductance, --area has a use beside that.
    pub(crate) fn refuse_unused(
        &self,
        card: &Card,
        file: Option<&Path>,
        area_has_use: bool,
    ) -> Result<(), Failure> {
        let refused = |message: String| Err(Failure::refused("usage", message));
        let Some(path) = file else {
            let of_file = [
                ("--level", self.file.level.is_some()),
                ("--boundary", self.file.boundary.is_some()),
            ];
            return match of_file.iter().find(|(_, is_given)| *is_given) {
                Some((name, _)) => {
                    refused(format!("{name} is for a surface FILE, and none is given"))
                }
                None => Ok(()),
            };
        };
        // What no file says.
        let beside = |input: Input| {
            let kind = matches!(input, Input::Gamma | Input::CriticalArea | Input::Hardness);
            (kind && card.takes(input)) || (area_has_use && input == Input::Area)
        };
        match self.typed.given().find(|input| !beside(*input)) {
            None => Ok(()),
            Some(input) if !card.takes(input) => {
                let sets = options_of(card).join(", or ");
                let (name, model) = (named(input), &card.name);
                refused(format!("{name} is no input of {model}, which takes {sets}"))
            }
            Some(input) => refused(format!(
                "{} and {} both say what the surface is; give one of them",
                named(input),
                path.display()
            )),
        }
    }
}
