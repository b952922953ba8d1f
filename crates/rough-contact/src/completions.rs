//! `rough-contact completions`: what a shell needs to complete this command.

use crate::outcome::{Failure, Reply};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, Command, ValueEnum};
use clap_complete::{Shell, generate};
use serde_json::json;

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
