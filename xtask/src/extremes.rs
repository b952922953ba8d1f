//! The page "each model at the ends of its inputs": every model crate prints its own table.

use crate::TaskResult;
use crate::generated::{check_flag, keep_section};
use crate::shell::{cargo, output};

/// Crates with an example `extremes`; each has a section of its name in the page.
const CRATES: [&str; 2] = ["gw-closed-form", "multiscale-models"];

/// Writes the tables, or checks that they are current.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let check = check_flag(args)?;
    for package in CRATES {
        let mut example = cargo();
        example.args(["run", "--quiet", "--release", "--locked", "-p", package]);
        let table = output(example.args(["--example", "extremes"]))?;
        keep_section("docs/src/extremes.md", package, &table, check)?;
    }
    Ok(())
}
