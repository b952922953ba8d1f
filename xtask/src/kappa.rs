//! The study of light load and full contact: table, figures, page.

use crate::generated::{check_flag, keep, keep_section};
use crate::shell::{self, TaskResult, example, output, read, root};

const TABLE: &str = "fixtures/kappa.csv";

/// Solves what is missing and writes table, figures and page; with `--check`, redoes figures and
/// page from the committed table and compares.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let check = check_flag(args)?;
    let rows = root().join("target/kappa").display().to_string();
    if !check {
        let table = output(example("studies", "kappa").arg(&rows))?;
        let origin = "# Area of random surfaces from light load to full contact; made by \
                      'cargo xtask kappa' from its own seeds, columns in \
                      crates/studies/src/light_load.rs";
        keep(TABLE, &format!("{origin}\n{table}"), false)?;
    }
    let folder = root().join("target/kappa-page");
    let out = folder.display().to_string();
    shell::run(example("studies", "kappa").args(["--page", TABLE, &out]))?;
    for name in ["kappa-bandwidth.svg", "kappa-load.svg", "kappa-full.svg"] {
        keep(&format!("docs/src/figures/{name}"), &read(&folder.join(name))?, check)?;
    }
    keep_section("docs/src/kappa.md", "kappa", &read(&folder.join("kappa.md"))?, check)
}
