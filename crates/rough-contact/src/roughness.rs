//! What a model is made from: typed numbers, or the statistics of a surface file.

use crate::args::{self, List};
use crate::outcome::Failure;
use crate::quantity;
use crate::units::Dimension;
use clap::error::Error;
use clap::{Arg, ArgMatches, Args, Command, FromArgMatches};
use rough_contact::compare::{self, Card, INPUTS, Input, InputFact, InputUnit, Inputs, Level};
use rough_contact::contact_types::ContactModulus;
use rough_contact::front_end::typed;
use rough_contact::surface_stats::Edges;
use std::collections::BTreeMap;
use std::path::Path;

/// Roughness typed in, each number by an option of its name, and how a FILE is read instead.
#[derive(Clone)]
pub(crate) struct Source {
    typed: BTreeMap<Input, Vec<f64>>,
    pub(crate) file: OfFile,
}

const HEADING: &str = "Roughness, typed in instead of FILE";

#[derive(Args, Clone)]
#[command(next_help_heading = HEADING)]
pub(crate) struct OfFile {
    /// Form to remove from a FILE by least squares first [default: auto]
    #[arg(long, value_name = "FORM", value_parser = args::one_of::<Level>())]
    pub(crate) level: Option<Level>,
    /// What lies beyond the edges of a FILE [default: open]
    #[arg(long, value_parser = args::one_of::<Edges>())]
    pub(crate) boundary: Option<Edges>,
}

fn option(fact: &InputFact) -> Arg {
    let (dimension, value) = match fact.unit {
        InputUnit::Number => (Dimension::Number, "X"),
        InputUnit::Length => (Dimension::Length, "L"),
        InputUnit::Area => (Dimension::Area, "A"),
        InputUnit::PerArea => (Dimension::PerArea, "N"),
        InputUnit::Pressure => (Dimension::Pressure, "P"),
        InputUnit::Lengths => (Dimension::Length, "LIST"),
        InputUnit::PerAreas => (Dimension::PerArea, "LIST"),
        InputUnit::Numbers => (Dimension::Number, "LIST"),
    };
    let takes_many = value == "LIST";
    let parser = move |text: &str| {
        if takes_many {
            quantity::parse_list(text, dimension).map(List)
        } else {
            quantity::parse(text, dimension).map(|value| List(vec![value]))
        }
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
        let given = |fact: &InputFact| {
            let List(values) = matches.get_one::<List>(fact.name)?;
            Some((fact.input, values.clone()))
        };
        let typed = INPUTS.iter().filter_map(given).collect();
        Ok(Self { typed, file: OfFile::from_arg_matches(matches)? })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

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
        if area_has_use && !card.takes(Input::Area) {
            typed.remove(&Input::Area);
        }
        if let Some(hardness) = hardness.filter(|_| card.yields) {
            typed.entry(Input::Hardness).or_insert(vec![hardness]);
        }
        let inputs = typed::inputs(&typed, card, modulus, named, Some(&ways(card)))?;
        Ok(Inputs { nominal_area: self.one(Input::Area).or(inputs.nominal_area), ..inputs })
    }

    /// A number typed in.
    pub(crate) fn one(&self, input: Input) -> Option<f64> {
        self.typed.get(&input)?.first().copied()
    }

    /// With what no file says.
    pub(crate) fn beside_file(&self, inputs: Inputs) -> Inputs {
        Inputs {
            gamma: self.one(Input::Gamma),
            critical_area: self.one(Input::CriticalArea),
            ..inputs
        }
    }

    /// An option that the model does not use is a mistake, `elastic` too, but --area with a load or a conductance.
    pub(crate) fn refuse_unused(
        &self,
        card: &Card,
        elastic: Option<&str>,
        file: Option<&Path>,
        area_has_use: bool,
    ) -> Result<(), Failure> {
        if let Some(name) = elastic.filter(|_| card.is_rigid) {
            return Err(typed::unused(card, name, named));
        }
        let refused = |message: String| Err(Failure::refused("usage", message));
        let Some(path) = file else {
            let name = match self.file {
                OfFile { level: Some(_), .. } => "--level",
                OfFile { boundary: Some(_), .. } => "--boundary",
                _ => return Ok(()),
            };
            return refused(format!("{name} is for a surface FILE, and none is given"));
        };
        // What no file says.
        let beside = |input: Input| {
            let kind = matches!(input, Input::Gamma | Input::CriticalArea | Input::Hardness);
            (kind && card.takes(input)) || (area_has_use && input == Input::Area)
        };
        match self.typed.keys().copied().find(|input| !beside(*input)) {
            None => Ok(()),
            Some(input) if !card.takes(input) => Err(typed::unused(card, &named(input), named)),
            Some(input) => refused(format!(
                "{} and {} both say what the surface is; give one of them",
                named(input),
                path.display()
            )),
        }
    }
}
