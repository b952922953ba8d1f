//! The survey: many surfaces, every model against the deterministic area; table, figures, page.

use crate::generated::{check_flag, keep, keep_section};
use crate::shell::{self, TaskResult, example, output, read, root};

const TABLE: &str = "crates/compare/data/survey.csv";
const PAGE: &str = "docs/src/survey.md";

/// Runs what is left of the survey and writes its table, figures and page; with `--check`, redoes
/// figures and page from the committed table and compares.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let check = check_flag(args)?;
    let rows = root().join("target/survey").display().to_string();
    if !check {
        let table = output(example("studies", "survey").arg(&rows))?;
        let origin = "# Errors of closed-form models against the deterministic area; made by \
                      'cargo xtask survey' from its own seeds, columns in crates/compare/src/survey.rs";
        keep(TABLE, &format!("{origin}\n{table}"), false)?;
    }
    let folder = root().join("target/survey-page");
    let out = folder.display().to_string();
    shell::run(example("studies", "survey").args(["--page", TABLE, &out]))?;
    for name in ["survey-map.svg", "survey-slopes.svg"] {
        keep(&format!("docs/src/figures/{name}"), &read(&folder.join(name))?, check)?;
    }
    keep_section(PAGE, "survey", &read(&folder.join("survey.md"))?, check)
}
