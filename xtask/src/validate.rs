//! The solver against exact solutions, as the book prints it.

use crate::generated::{check_flag, keep_section};
use crate::shell::{TaskResult, output, rough_contact};

/// Writes the table of `rough-contact validate` into the book, or checks that it is current.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let check = check_flag(args)?;
    let table = output(rough_contact(false).args(["validate", "--quiet"]))?;
    let block = format!("```text\n{}\n```", table.trim_end());
    keep_section("docs/src/validation.md", "validate", &block, check)
}
