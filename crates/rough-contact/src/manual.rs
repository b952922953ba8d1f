//! `rough-contact man` and `completions`: what a reader and a shell need, from the same table as `--help`.

use crate::args::CommonOptions;
use crate::outcome::{Failure, Folder, Reply};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Arg, Args, Command, ValueEnum};
use clap_complete::{Shell, generate};
use serde_json::json;
use std::path::PathBuf;

#[derive(Args)]
pub(crate) struct Man {
    /// A command, such as solve; without one the page that lists them
    #[arg(value_name = "COMMAND", conflicts_with = "out")]
    page: Option<String>,
    /// Folder for the pages of all commands, as rough-contact-solve.1
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

impl Man {
    pub(crate) fn run(&self, command: Command, common: &CommonOptions) -> Result<Reply, Failure> {
        let pages = pages(command)?;
        if let Some(out) = &self.out {
            let names: Vec<String> = pages.iter().map(|(name, _)| name.clone()).collect();
            let folder = Folder::prepare(out, &names, common.force)?;
            folder.write_all(pages)?;
            let text = format!("{} pages: {}\n", names.len(), out.display());
            return Ok(Reply::new(text, json!({ "pages": names })));
        }
        let wanted = match &self.page {
            None => "rough-contact.1".to_owned(),
            Some(command) => format!("rough-contact-{command}.1"),
        };
        let page = pages.into_iter().find(|(name, _)| *name == wanted);
        let (name, text) = page.ok_or_else(|| {
            let message = format!(
                "there is no manual page {wanted}; `rough-contact --help` lists the commands"
            );
            Failure::refused("usage", message)
        })?;
        let object = json!({ "page": name, "text": text });
        Ok(Reply::new(text, object))
    }
}

/// One page for the command and one for each below it: the name of its file and what is in it.
fn pages(command: Command) -> Result<Vec<(String, String)>, Failure> {
    let in_full = |arg: Arg| arg.hide_short_help(false); // what `-h` leaves to `--help` too
    let command = command.disable_help_subcommand(true).mut_args(in_full);
    let mut command = command.mut_subcommands(|below| below.mut_args(in_full));
    command.build(); // gives the commands below their full names and the common options
    let below = command.get_subcommands().cloned().collect::<Vec<_>>();
    std::iter::once(command).chain(below).map(page).collect()
}

fn page(command: Command) -> Result<(String, String), Failure> {
    let internal = |e: String| Failure::refused("internal", e);
    // A page belongs to a version; where others have their date, it stands between the feet of the page.
    let version = concat!("rough-contact ", env!("CARGO_PKG_VERSION"));
    let manual = clap_mangen::Man::new(command).date(version).source("");
    let mut text = Vec::new();
    manual.render(&mut text).map_err(|e| internal(e.to_string()))?;
    let text = String::from_utf8(text).map_err(|e| internal(e.to_string()))?;
    Ok((manual.get_filename(), text))
}

#[derive(Args)]
pub(crate) struct Completions {
    /// The shell that the script is for
    #[arg(value_name = "SHELL", value_parser = shells())]
    shell: Shell,
}

/// The shells of the systems that the command is built for.
fn shells() -> impl TypedValueParser<Value = Shell> {
    PossibleValuesParser::new(["bash", "zsh", "fish", "powershell"])
        .try_map(|name| Shell::from_str(&name, false))
}

impl Completions {
    /// The script for `command`, whose options it lists.
    pub(crate) fn run(&self, mut command: Command) -> Result<Reply, Failure> {
        let name = command.get_name().to_owned();
        let mut script = Vec::new();
        generate(self.shell, &mut command, &name, &mut script);
        let script =
            String::from_utf8(script).map_err(|e| Failure::refused("internal", e.to_string()))?;
        // clap_complete 4.6 writes the hyphen of our name in two ways, so that bash would complete nothing behind
        // a command (github.com/clap-rs/clap/issues/6421); where it is mended, this changes nothing.
        let script = script.replace(&name.replace('-', "__subcmd__"), &name.replace('-', "__"));
        let object = json!({ "shell": self.shell.to_string(), "script": script });
        Ok(Reply::new(script, object))
    }
}
