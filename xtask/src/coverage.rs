//! How often the uncertainties hold: solves the families and puts the tables into the book.

use crate::generated::{check_flag, keep_section};
use crate::shell::{TaskResult, example, output, read, root};

const PAGE: &str = "docs/src/uncertainty.md";
/// The family that `--check` solves again.
const CHECKED: &str = "crop of a lay";

/// Solves all families and writes the tables (minutes); `--check` solves one and compares its row, times aside.
pub(crate) fn run(args: &[String]) -> TaskResult {
    if check_flag(args)?.is_none() {
        let tables = output(&mut example("contact-accuracy", "coverage"))?;
        return keep_section(PAGE, "coverage", &tables, None);
    }
    let rows = output(example("contact-accuracy", "coverage").arg(CHECKED))?;
    let row = rows.lines().next().unwrap_or_default(); // at pressures
    let page = read(&root().join(PAGE))?;
    if !row.is_empty() && page.contains(row) {
        return Ok(());
    }
    Err(format!("{PAGE} does not have this row; run the task without --check:\n{row}"))
}
