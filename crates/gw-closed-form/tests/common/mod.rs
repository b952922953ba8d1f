//! Reading the tables of `fixtures/reference`, and the worst error met.
#![allow(
    dead_code,
    clippy::float_cmp,
    clippy::print_stdout,
    reason = "each test program uses its part; a reference of exactly 0 is compared absolutely; \
              the worst errors are printed for the report"
)]

use std::path::PathBuf;

/// A table: comma separated, first line an origin, second the names of the columns.
pub(crate) struct ReferenceTable {
    columns: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl ReferenceTable {
    /// Reads `fixtures/reference/<name>`.
    pub(crate) fn read(name: &str) -> Self {
        let path =
            PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/reference").join(name);
        let text =
            std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        assert!(text.starts_with("# "), "{name} opens with its origin");
        let mut lines = text.lines().filter(|l| !l.starts_with('#'));
        let split = |line: &str| line.split(',').map(str::to_owned).collect::<Vec<_>>();
        let columns = split(lines.next().expect("a reference table has a header"));
        let rows: Vec<_> = lines.map(split).collect();
        assert!(!rows.is_empty(), "{name} has no rows");
        Self { columns, rows }
    }

    /// Rows, each a look-up by column name.
    pub(crate) fn rows(&self) -> impl Iterator<Item = ReferenceRow<'_>> {
        self.rows.iter().map(|cells| ReferenceRow { table: self, cells })
    }
}

/// One row of a [`ReferenceTable`].
pub(crate) struct ReferenceRow<'a> {
    table: &'a ReferenceTable,
    cells: &'a [String],
}

impl ReferenceRow<'_> {
    /// The cell as text.
    pub(crate) fn text(&self, column: &str) -> &str {
        let index = self.table.columns.iter().position(|c| c == column);
        &self.cells[index.unwrap_or_else(|| panic!("no column {column}"))]
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
