//! The study behind the fitted equation: tables and page.

use crate::generated::{check_flag, keep, keep_section};
use crate::shell::{self, TaskResult, example, output, read, root};

const FITTED: &str = "fixtures/equation-fit.csv";
const JUDGED: &str = "fixtures/equation-judge.csv";
const CHANCE: &str = "fixtures/equation-chance.csv";
const PAGE: &str = "docs/src/models/equation.md";

/// Solves what is missing and writes both tables and the page; with `--check`, redoes the page from the
/// committed tables and compares. Either way the constants of the crate must be those of the fit.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let check = check_flag(args)?;
    let folder = |name: &str| root().join("target/equation").join(name).display().to_string();
    if !check {
        let fitted = output(example("studies", "equation").arg(folder("fit")))?;
        let judged = output(example("studies", "equation").args(["--judge", &folder("judge")]))?;
        let chance = output(example("studies", "equation").args(["--chance", "-"]))?;
        let origin = "# Areas of maps that differ by chance alone; made by 'cargo xtask equation', columns in \
                      crates/studies/examples/equation/chance.rs";
        keep(CHANCE, &format!("{origin}\n{chance}"), false)?;
        for (table, what, rows) in [(FITTED, "fitted", fitted), (JUDGED, "judged", judged)] {
            let origin = format!(
                "# Surfaces the equation is {what} on, and their deterministic solutions; made by \
                 'cargo xtask equation', columns in crates/studies/examples/equation/measure.rs"
            );
            keep(table, &format!("{origin}\n{rows}"), false)?;
        }
    }
    let out = folder("page");
    shell::run(example("studies", "equation").args(["--page", FITTED, JUDGED, CHANCE, &out]))?;
    keep_section(PAGE, "equation", &read(&root().join(&out).join("equation.md"))?, check)
}
