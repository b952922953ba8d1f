//! The page "the ends of the inputs": models, statistics and solver each print their own table.

use crate::generated::{check_flag, keep_section};
use crate::shell::{TaskResult, example, output};

/// Crates with an example of the ends of their inputs, each with a section of its name in the page;
/// that example; what the summary calls it; and how many of the last columns are errors.
const CRATES: [(&str, &str, &str, usize); 5] = [
    ("surface-stats", "statistics_extremes", "[statistics](#statistics)", 1),
    ("fft-bem-solver", "solver_extremes", "[solver](#solver)", 3),
    (
        "gw-closed-form",
        "gw_extremes",
        "[Greenwood\u{2013}Williamson](#greenwoodwilliamson-closed-form)",
        1,
    ),
    ("asperity-models", "summit_extremes", "[summit models](#summit-models)", 1),
    ("multiscale-models", "multiscale_extremes", "[multiscale models](#multiscale-models)", 1),
];

/// The bounds of the error in the columns of the summary.
const BOUNDS: [f64; 3] = [1e-14, 1e-12, 1e-9];

/// Writes the tables, or checks that they are current.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let check = check_flag(args)?;
    let mut summary =
        "| | lines | error up to 1e\u{2212}14 | 1e\u{2212}12 | 1e\u{2212}9 | larger | \
                       refused, or beyond the doubles |\n|---|---|---|---|---|---|---|\n"
            .to_owned();
    for (package, name, part, errors) in CRATES {
        let table = output(&mut example(package, name))?;
        summary += &counts(part, &table, errors);
        let table: String = table.lines().map(|row| banded(row, errors)).collect();
        keep_section("docs/src/extremes.md", package, &table, check)?;
    }
    keep_section("docs/src/extremes.md", "summary", &summary, check)
}

/// How many lines of a table have errors up to each bound: one line of the summary.
fn counts(part: &str, table: &str, errors: usize) -> String {
    let mut counts = [0; BOUNDS.len() + 2];
    let rows = table.lines().skip(2); // below the head
    for row in rows.clone() {
        let cells = row.trim().trim_end_matches('|').rsplit('|').take(errors);
        let worst = cells.map(|cell| match number(cell) {
            None if cell.trim() == "none" => 0.0,
            found => found.unwrap_or(f64::INFINITY),
        });
        let worst = worst.fold(0.0, f64::max);
        let column = match BOUNDS.iter().position(|bound| worst <= *bound) {
            Some(column) => column,
            None => BOUNDS.len() + usize::from(worst.is_infinite()),
        };
        counts[column] += 1;
    }
    let cells = counts.map(|n| n.to_string()).join(" | ");
    format!("| {part} | {} | {cells} |\n", rows.count())
}

/// The number in a cell, if it is one.
fn number(cell: &str) -> Option<f64> {
    cell.trim().replace('\u{2212}', "-").parse().ok()
}

/// A row whose last cells, `errors` of them, are relative errors, as [`band`] writes them.
fn banded(row: &str, errors: usize) -> String {
    let cells: Vec<&str> = row.trim().trim_matches('|').split('|').collect();
    let first = cells.len().saturating_sub(errors);
    let cell = |(i, cell): (usize, &&str)| match number(cell) {
        Some(error) if i >= first => format!(" {} ", band(error)),
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
    fn each_line_is_counted_once_by_its_worst_error() {
        let table = "| a | b | c |\n|---|---|---|\n| x | 1e-15 | none |\n| x | 2e-10 | 1e-13 |\n\
                     | x | 0.02 | 1e-9 |\n| 7 | refused | refused |\n";
        assert_eq!(counts("part", table, 2), "| part | 4 | 1 | 0 | 1 | 1 | 1 |\n");
    }

    #[test]
    fn only_errors_are_rounded() {
        let row = "| 3e-15 | 1.8e-2 | 6.4e-4 | 7.9e-12 | 1.1e-16 | 0.0e0 | none |";
        let expected =
            "| 3e-15 | 0.02 | 6e\u{2212}4 | < 1e\u{2212}11 | rounding | rounding | none |\n";
        assert_eq!(banded(row, 6), expected);
        assert_eq!(banded("|---|---|", 1), "|---|---|\n");
    }
}
