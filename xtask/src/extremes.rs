//! The table of "the ends of the inputs": models, statistics and solver each print their cases, which are counted.

use crate::generated::{check_flag, keep_section};
use crate::shell::{TaskResult, example, output};

/// Crates with an example of the ends of their inputs, that example, and what the table calls it.
const CRATES: [(&str, &str, &str); 5] = [
    ("surface-stats", "statistics_extremes", "statistics"),
    ("fft-bem-solver", "solver_extremes", "solver"),
    ("gw-closed-form", "gw_extremes", "Greenwood\u{2013}Williamson"),
    ("asperity-models", "summit_extremes", "summit models"),
    ("multiscale-models", "multiscale_extremes", "multiscale models"),
];

/// The bounds of the error in the columns of the table.
const BOUNDS: [f64; 3] = [1e-14, 1e-12, 1e-9];

/// Writes the table, or checks that it is current.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let check = check_flag(args)?;
    let mut summary =
        "| | lines | error up to 1e\u{2212}14 | 1e\u{2212}12 | 1e\u{2212}9 | larger | \
                       refused, or beyond the doubles |\n|---|---|---|---|---|---|---|\n"
            .to_owned();
    for (package, name, part) in CRATES {
        summary += &counts(part, &output(&mut example(package, name))?);
    }
    keep_section("docs/src/extremes.md", "summary", &summary, check)
}

/// How many cases have errors up to each bound: one line of the table. What is no number was refused.
fn counts(part: &str, cases: &str) -> String {
    let mut counts = [0; BOUNDS.len() + 2];
    for case in cases.lines() {
        let error: Option<f64> = case.rsplit(": ").next().and_then(|error| error.parse().ok());
        let column = match error {
            None => BOUNDS.len() + 1,
            Some(error) => BOUNDS.iter().position(|bound| error <= *bound).unwrap_or(BOUNDS.len()),
        };
        counts[column] += 1;
    }
    let cells = counts.map(|n| n.to_string()).join(" | ");
    format!("| {part} | {} | {cells} |\n", cases.lines().count())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_case_is_counted_once() {
        let cases = "a: 1e-15\nb: 2.0e-10\nc: 0.02\nd: 1e-3: refused\ne: 0\n";
        assert_eq!(counts("part", cases), "| part | 5 | 2 | 0 | 1 | 1 | 1 |\n");
    }
}
