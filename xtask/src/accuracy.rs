//! The check of `--accuracy`: surfaces that took no part in its calibration; table, figure, page.

use crate::generated::{check_flag, keep, keep_section};
use crate::shell::{self, TaskResult, example, output, read, root};

const TABLE: &str = "fixtures/accuracy.csv";
const PAGE: &str = "docs/src/accuracy.md";

/// Runs what is left of the check and writes its table, figure and page; with `--check`, redoes
/// figure and page from the committed table and compares.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let check = check_flag(args)?;
    let rows = root().join("target/accuracy").display().to_string();
    if !check {
        let table = output(example("studies", "accuracy").arg(&rows))?;
        let origin = "# Requests against true errors of the area; made by 'cargo xtask accuracy' \
                      from its own seeds, columns in crates/studies/examples/accuracy/measure.rs";
        keep(TABLE, &format!("{origin}\n{table}"), false)?;
    }
    let folder = root().join("target/accuracy-page");
    let out = folder.display().to_string();
    shell::run(example("studies", "accuracy").args(["--page", TABLE, &out]))?;
    keep("docs/src/figures/accuracy.svg", &read(&folder.join("accuracy.svg"))?, check)?;
    keep_section(PAGE, "accuracy", &read(&folder.join("accuracy.md"))?, check)
}
