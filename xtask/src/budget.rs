//! The study of the error bars: many surfaces against finer grids and against other realisations.

use crate::generated::{check_flag, keep, keep_section};
use crate::shell::{self, TaskResult, example, output, read, root};

const TABLE: &str = "fixtures/budget.csv";
const FRESH: &str = "fixtures/budget-fresh.csv";
const SAMPLE: &str = "fixtures/budget-realisations.csv";
const PAGE: &str = "docs/src/budget.md";

/// Runs what is left of the study and writes its tables, figure and page; with `--check`, redoes
/// figure and page from the committed tables and compares.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let check = check_flag(args)?;
    if !check {
        let folder = |name: &str| root().join("target").join(name).display().to_string();
        let table = output(example("studies", "budget").arg(folder("budget")))?;
        let origin = "# Area, gap and stiffness on three grids and at three tolerances; made by \
                      'cargo xtask budget' from its own seeds, columns in \
                      crates/studies/examples/budget/measure.rs";
        keep(TABLE, &format!("{origin}\n{table}"), false)?;
        let table =
            output(example("studies", "budget").args(["--fresh", &folder("budget-fresh")]))?;
        let origin = "# The same of maps that took no part in fixing any constant; made by 'cargo \
                      xtask budget' from its own seeds (crates/studies/examples/budget/fresh.rs)";
        keep(FRESH, &format!("{origin}\n{table}"), false)?;
        let table = output(
            example("studies", "budget").args(["--realisations", &folder("budget-realisations")]),
        )?;
        let origin = "# Realisations of families of surfaces; made by 'cargo xtask budget' from its \
                      own seeds, columns in crates/studies/examples/budget/realisations.rs";
        keep(SAMPLE, &format!("{origin}\n{table}"), false)?;
    }
    let folder = root().join("target/budget-page");
    let out = folder.display().to_string();
    shell::run(example("studies", "budget").args(["--page", TABLE, FRESH, SAMPLE, &out]))?;
    for name in ["budget.svg", "budget-fresh.svg"] {
        keep(&format!("docs/src/figures/{name}"), &read(&folder.join(name))?, check)?;
    }
    keep_section(PAGE, "budget", &read(&folder.join("budget.md"))?, check)
}
