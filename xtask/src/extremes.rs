//! The table of "the ends of the inputs": the tests of models, statistics and solver print their cases, which are counted.

use crate::generated::{check_flag, keep_section};
use crate::shell::{TaskResult, cargo, output};

/// With what the lines of the tests begin, and what the table calls these.
const PARTS: [(&str, &str); 5] = [
    ("surface-stats: ", "statistics"),
    ("fft-bem-solver: ", "solver"),
    ("gw-closed-form: ", "Greenwood\u{2013}Williamson"),
    ("asperity-models: ", "summit models"),
    ("multiscale-models: ", "multiscale models"),
];

/// The tests that print them, in programs of these names.
const TESTS: &str =
    "test --locked --workspace --test=all --test=extremes at_the_extremes -- --nocapture";

/// The bounds of the error in the columns of the table.
const BOUNDS: [f64; 3] = [1e-14, 1e-12, 1e-9];

/// Writes the table, or checks that it is current.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let check = check_flag(args)?;
    let mut summary =
        "| | lines | error up to 1e\u{2212}14 | 1e\u{2212}12 | 1e\u{2212}9 | larger | \
                       refused, or beyond the doubles |\n|---|---|---|---|---|---|---|\n"
            .to_owned();
    let lines = output(cargo().args(TESTS.split(' ')))?;
    for (start, part) in PARTS {
        summary += &counts(part, lines.lines().filter_map(|line| line.strip_prefix(start)));
    }
    keep_section("docs/src/extremes.md", "summary", &summary, check)
}

/// How many cases have errors up to each bound: one line of the table. What is no number was refused.
fn counts<'a>(part: &str, cases: impl Iterator<Item = &'a str>) -> String {
    let mut counts = [0; BOUNDS.len() + 2];
    for case in cases {
        let error: Option<f64> = case.rsplit(": ").next().and_then(|error| error.parse().ok());
        let column = match error {
            None => BOUNDS.len() + 1,
            Some(error) => BOUNDS.iter().position(|bound| error <= *bound).unwrap_or(BOUNDS.len()),
        };
        counts[column] += 1;
    }
    let cells = counts.map(|n| n.to_string()).join(" | ");
    format!("| {part} | {} | {cells} |\n", counts.iter().sum::<usize>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_case_is_counted_once() {
        let cases = "a: 1e-15\nb: 2.0e-10\nc: 0.02\nd: 1e-3: refused\ne: 0\n";
        assert_eq!(counts("part", cases.lines()), "| part | 5 | 2 | 0 | 1 | 1 | 1 |\n");
    }
}
