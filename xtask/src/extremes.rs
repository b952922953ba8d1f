//! The page "the ends of the inputs": models, statistics and solver each print their own table.

use crate::TaskResult;
use crate::generated::{check_flag, keep_section};
use crate::shell::{cargo, output};

/// Crates with an example `extremes`, each with a section of its name in the page, and how many of
/// the last columns are errors.
const CRATES: [(&str, usize); 5] = [
    ("gw-closed-form", 1),
    ("asperity-models", 1),
    ("multiscale-models", 1),
    ("surface-stats", 1),
    ("fft-bem-solver", 3),
];

/// Writes the tables, or checks that they are current.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let check = check_flag(args)?;
    for (package, errors) in CRATES {
        let mut example = cargo();
        example.args(["run", "--quiet", "--release", "--locked", "-p", package]);
        let table = output(example.args(["--example", "extremes"]))?;
        let table: String = table.lines().map(|row| banded(row, errors)).collect();
        keep_section("docs/src/extremes.md", package, &table, check)?;
    }
    Ok(())
}

/// A row whose last cells, `errors` of them, are relative errors, as [`band`] writes them.
fn banded(row: &str, errors: usize) -> String {
    let cells: Vec<&str> = row.trim().trim_matches('|').split('|').collect();
    let first = cells.len().saturating_sub(errors);
    let cell = |(i, cell): (usize, &&str)| match cell.trim().replace('\u{2212}', "-").parse() {
        Ok(error) if i >= first => format!(" {} ", band(error)),
        _ => (*cell).to_owned(),
    };
    let cells: Vec<String> = cells.iter().enumerate().map(cell).collect();
    format!("|{}|\n", cells.join("|"))
}

/// Small errors rounded up to a power of ten, for the digits of an error of a few roundings differ
/// between platforms; those that the grid makes, to one digit.
fn band(error: f64) -> String {
    match error {
        e if e <= 2.3e-16 => "rounding".to_owned(),
        e if e < 1e-6 => format!("< 1e\u{2212}{}", -e.log10().floor() - 1.0),
        e if e < 1e-3 => format!("{e:.0e}").replace('-', "\u{2212}"),
        e => {
            let digits = (-e.log10().floor()).max(0.0) as usize;
            format!("{e:.digits$}")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_errors_are_rounded() {
        let row = "| 3e-15 | 1.8e-2 | 6.4e-4 | 7.9e-12 | 1.1e-16 | 0.0e0 | none |";
        let expected =
            "| 3e-15 | 0.02 | 6e\u{2212}4 | < 1e\u{2212}11 | rounding | rounding | none |\n";
        assert_eq!(banded(row, 6), expected);
        assert_eq!(banded("|---|---|", 1), "|---|---|\n");
    }
}
