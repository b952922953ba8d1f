//! Reading the tables of `fixtures/reference`, and the errors against them.
#![allow(
    dead_code,
    clippy::float_cmp,
    clippy::print_stdout,
    reason = "each test program uses its part; a reference of exactly 0 is compared absolutely; \
              the worst errors are printed for the report"
)]

use std::collections::HashMap;

/// One row of a table: its cells by the names of their columns.
pub(crate) struct ReferenceRow(HashMap<String, String>);

/// The rows of `fixtures/reference/<name>`: comma separated, first line an origin, second the names of the columns.
pub(crate) fn reference_rows(name: &str) -> Vec<ReferenceRow> {
    let path = format!("{}/../../fixtures/reference/{name}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"));
    assert!(text.starts_with("# "), "{name} opens with its origin");
    let cells = |line: &str| line.split(',').map(str::to_owned).collect::<Vec<_>>();
    let mut lines = text.lines().filter(|line| !line.starts_with('#')).map(cells);
    let columns = lines.next().expect("a reference table has a header");
    let row = |cells| ReferenceRow(columns.iter().cloned().zip(cells).collect());
    let rows: Vec<_> = lines.map(row).collect();
    assert!(!rows.is_empty(), "{name} has no rows");
    rows
}

impl ReferenceRow {
    /// The cell as text.
    pub(crate) fn text(&self, column: &str) -> &str {
        self.0.get(column).unwrap_or_else(|| panic!("no column {column}"))
    }

    /// The cell as the nearest double; beyond their range 0 or infinity.
    pub(crate) fn number(&self, column: &str) -> f64 {
        self.text(column).parse().unwrap_or_else(|e| panic!("{column}: {e}"))
    }

    /// Several cells.
    pub(crate) fn numbers<const N: usize>(&self, columns: [&str; N]) -> [f64; N] {
        columns.map(|column| self.number(column))
    }
}

/// One input at the end of its range.
pub(crate) struct Case {
    pub(crate) place: String,
    /// `None` if it was refused.
    pub(crate) answer: Option<f64>,
    /// `None` if it must be.
    pub(crate) reference: Option<f64>,
    /// Errors of answers below this are in units of it.
    pub(crate) least: f64,
}

impl Case {
    /// Relative error; `None` where there is no answer, or no double can hold the reference.
    pub(crate) fn error(&self) -> Option<f64> {
        let (answer, reference) = (self.answer?, self.reference?);
        let representable = reference.is_normal() || answer == reference;
        let unit = reference.abs().max(self.least).max(f64::MIN_POSITIVE);
        representable.then(|| ((answer - reference) / unit).abs())
    }
}

/// Prints each case of a crate with its error, for the table of the book.
#[allow(clippy::print_stdout, reason = "the lines are the purpose")]
pub(crate) fn print(of: &str, cases: &[Case]) {
    for case in cases {
        let error = case.error().map_or("none".to_owned(), |error| format!("{error:.1e}"));
        println!("{of}: {}: {error}", case.place);
    }
}

/// Asserts that all answers are within their limits, at the end of the doubles where none can be.
pub(crate) fn assert_answered(of: &str, cases: Vec<Case>, limit: impl Fn(&str) -> f64) {
    print(of, &cases);
    assert!(cases.len() > 60);
    for case in cases {
        let (place, answer) = (&case.place, case.answer.expect("never refused"));
        assert!(answer.is_finite(), "{place}");
        match (case.error(), case.reference) {
            (Some(error), _) => assert!(error < limit(place), "{place}: {error:e}"),
            (None, Some(huge)) if huge.abs() > 1.0 => assert!(answer.abs() >= f64::MAX, "{place}"),
            (None, _) => assert!(answer.abs() < f64::MIN_POSITIVE, "{place}: {answer}"),
        }
    }
}

/// |x / reference - 1|; 0 where the reference is 0, subnormal or infinite and no relative error
/// can be asked for.
pub(crate) fn relative_error(x: f64, reference: f64) -> f64 {
    if reference.is_normal() { (x / reference - 1.0).abs() } else { 0.0 }
}

/// The largest error met, and where; prints itself, so that a report can quote it.
pub(crate) struct Worst {
    what: String,
    pub(crate) error: f64,
    place: String,
}

impl Worst {
    /// Nothing met yet.
    pub(crate) fn of(what: impl Into<String>) -> Self {
        Self { what: what.into(), error: 0.0, place: String::new() }
    }

    /// Takes an error in.
    pub(crate) fn see(&mut self, error: f64, place: impl FnOnce() -> String) {
        if error > self.error || error.is_nan() {
            (self.error, self.place) = (error, place());
        }
    }

    /// Takes a relative error in; an absolute one where 0 is expected.
    pub(crate) fn compare(&mut self, found: f64, expected: f64, place: impl FnOnce() -> String) {
        let error =
            if expected == 0.0 { found.abs() } else { ((found - expected) / expected).abs() };
        assert!(error.is_finite(), "{}: {found} instead of {expected} at {}", self.what, place());
        self.see(error, place);
    }

    /// Fails if the worst exceeds `limit`.
    pub(crate) fn at_most(&self, limit: f64) {
        let Self { what, error, place } = self;
        println!("worst {what}: {error:.2e} at {place}");
        assert!(*error <= limit, "{what}: {error:.2e} > {limit:.0e} at {place}");
    }
}
