//! The study of the error bars: many surfaces against finer grids and against other realisations.

use crate::TaskResult;
use crate::generated::{check_flag, keep, keep_section};
use crate::shell::{self, output, read, root};
use std::process::Command;

const TABLE: &str = "fixtures/budget.csv";
const SAMPLE: &str = "fixtures/budget-realisations.csv";
const PAGE: &str = "docs/src/budget.md";

/// Runs what is left of the study and writes its tables, figure and page; with `--check`, redoes
/// figure and page from the committed tables and compares.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let check = check_flag(args)?;
    if !check {
        let folder = |name: &str| root().join("target").join(name).display().to_string();
        let table = output(&mut budget(&[&folder("budget")]))?;
        let origin = "# Area, gap and stiffness on three grids and at three tolerances; made by \
                      'cargo xtask budget' from its own seeds, columns in \
                      crates/compare/examples/budget/measure.rs";
        keep(TABLE, &format!("{origin}\n{table}"), false)?;
        let table = output(&mut budget(&["--realisations", &folder("budget-realisations")]))?;
        let origin = "# Realisations of families of surfaces; made by 'cargo xtask budget' from its \
                      own seeds, columns in crates/compare/examples/budget/realisations.rs";
        keep(SAMPLE, &format!("{origin}\n{table}"), false)?;
    }
    let folder = root().join("target/budget-page");
    let out = folder.display().to_string();
    shell::run(&mut budget(&["--page", TABLE, SAMPLE, &out]))?;
    keep("docs/src/figures/budget.svg", &read(&folder.join("budget.svg"))?, check)?;
    keep_section(PAGE, "budget", &read(&folder.join("budget.md"))?, check)
}

/// The example that does the work, built in release.
fn budget(args: &[&str]) -> Command {
    let mut cargo = shell::cargo();
    cargo.args(["run", "--quiet", "--release", "--locked", "--package", "compare"]);
    cargo.args(["--example", "budget", "--"]).args(args);
    cargo
}
