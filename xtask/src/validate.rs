//! The solver against exact solutions, as the book prints it.

use crate::generated::{check_flag, keep_section};
use crate::shell::{TaskResult, output, rough_contact};

/// Writes the table of `rough-contact validate` into the book, or checks that it is current.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let check = check_flag(args)?;
    let found = output(rough_contact(false).args(["validate", "--quiet"]))?;
    // What rounding leaves differs with the transforms of the machine.
    let exponent = |word: &str| word.rsplit_once("e−")?.1.parse::<u32>().ok();
    let rounded = found.split_whitespace().filter(|word| exponent(word).is_some_and(|e| e > 12));
    let table = rounded.fold(found.clone(), |table, word| table.replace(word, "rounding"));
    let block = format!("```text\n{}\n```", table.trim_end());
    keep_section("docs/src/validation.md", "validate", &block, check)
}
