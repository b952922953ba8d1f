//! The table of "the ends of the inputs": models, statistics and solver each print their lines, which are counted.

use crate::generated::{check_flag, keep_section};
use crate::shell::{TaskResult, example, output};

/// Crates with an example of the ends of their inputs; that example; what the table calls it; and how many of the
/// last columns are errors.
const CRATES: [(&str, &str, &str, usize); 5] = [
    ("surface-stats", "statistics_extremes", "statistics", 1),
    ("fft-bem-solver", "solver_extremes", "solver", 3),
    ("gw-closed-form", "gw_extremes", "Greenwood\u{2013}Williamson", 1),
    ("asperity-models", "summit_extremes", "summit models", 1),
    ("multiscale-models", "multiscale_extremes", "multiscale models", 1),
];

/// The bounds of the error in the columns of the summary.
const BOUNDS: [f64; 3] = [1e-14, 1e-12, 1e-9];

/// Writes the table, or checks that it is current.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let check = check_flag(args)?;
    let mut summary =
        "| | lines | error up to 1e\u{2212}14 | 1e\u{2212}12 | 1e\u{2212}9 | larger | \
                       refused, or beyond the doubles |\n|---|---|---|---|---|---|---|\n"
            .to_owned();
    for (package, name, part, errors) in CRATES {
        let table = output(&mut example(package, name))?;
        summary += &counts(part, &table, errors);
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_line_is_counted_once_by_its_worst_error() {
        let table = "| a | b | c |\n|---|---|---|\n| x | 1e-15 | none |\n| x | 2e-10 | 1e-13 |\n\
                     | x | 0.02 | 1e-9 |\n| 7 | refused | refused |\n";
        assert_eq!(counts("part", table, 2), "| part | 4 | 1 | 0 | 1 | 1 | 1 |\n");
    }
}
