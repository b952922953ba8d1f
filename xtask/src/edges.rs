//! The study of maps that do not repeat: tables into the book, rows for the report.

use crate::generated::{check_flag, keep, keep_section};
use crate::shell::{self, TaskResult, example, read, root};

/// Runs the study and writes its rows and tables, or checks that they are current.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let check = check_flag(args)?;
    let folder = root().join("target/edges");
    shell::run(example("studies", "edges").arg(&folder))?;
    let origin = "# Area of crops treated as periodic against the area in natural surroundings; \
                  made by 'cargo xtask edges' from its own seeds, columns in \
                  crates/contact-accuracy/src/edge_study.rs";
    let rows = read(&folder.join("edges.csv"))?;
    keep("crates/contact-accuracy/data/edges.csv", &format!("{origin}\n{rows}"), check)?;
    keep_section("docs/src/edges.md", "edges", &read(&folder.join("edges.md"))?, check)
}
