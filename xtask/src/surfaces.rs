//! Files of real instruments against their expected values.

use crate::TaskResult;
use crate::shell::{root, run as start};
use std::process::Command;

/// Checks every file of `--dir DIR` against `--expected FILE`, one line each. The work is done
/// by an example of `surface-io`, built in release; relative paths are the caller's.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.args(["run", "--quiet", "--release", "--locked", "--manifest-path"]);
    cargo.arg(root().join("crates/surface-io/Cargo.toml"));
    cargo.args(["--example", "check_surfaces", "--"]).args(args);
    start(&mut cargo)
}
