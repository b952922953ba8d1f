//! The options as one: the sections of the help, and what `--from` excludes.

use clap::{Arg, Command};
use rough_contact::compare;
use rough_contact::compare::INPUTS;

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
