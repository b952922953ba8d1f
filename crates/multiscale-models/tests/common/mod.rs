//! Reading the reference tables.
#![allow(
    dead_code,
    clippy::float_cmp,
    clippy::print_stdout,
    reason = "each test program uses its part; a reference of exactly 0 is compared absolutely; \
              the worst errors are printed for the report"
)]

pub(crate) mod extremes;

use std::path::PathBuf;

/// A table: comma separated, first line an origin, second the names of the columns.
pub(crate) struct Table {
    columns: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// Reads `fixtures/reference/<name>`.
    pub(crate) fn read(name: &str) -> Self {
        let path =
            PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/reference").join(name);
        let text =
            std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        let mut lines = text.lines().filter(|l| !l.starts_with('#'));
        let split = |line: &str| line.split(',').map(str::to_owned).collect::<Vec<_>>();
        let columns = split(lines.next().expect("a reference table has a header"));
        let rows: Vec<_> = lines.map(split).collect();
        assert!(!rows.is_empty(), "{name} has no rows");
        Self { columns, rows }
    }

    /// Rows, each a look-up by column name.
    pub(crate) fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        self.rows.iter().map(|cells| Row { table: self, cells })
    }
}

/// One row of a [`Table`].
pub(crate) struct Row<'a> {
    table: &'a Table,
    cells: &'a [String],
}

impl Row<'_> {
    /// The cell as text.
    pub(crate) fn text(&self, column: &str) -> &str {
        let index = self.table.columns.iter().position(|c| c == column);
        &self.cells[index.unwrap_or_else(|| panic!("no column {column}"))]
    }

    /// The cell as the nearest double.
    pub(crate) fn number(&self, column: &str) -> f64 {
        self.text(column).parse().unwrap_or_else(|e| panic!("{column}: {e}"))
    }
}

/// The worst relative error met; prints itself, so that a report can quote it.
pub(crate) struct Worst {
    what: &'static str,
    error: f64,
    place: String,
}

impl Worst {
    /// Nothing met yet.
    pub(crate) fn of(what: &'static str) -> Self {
        Self { what, error: 0.0, place: String::new() }
    }

    /// Takes one comparison in.
    pub(crate) fn compare(&mut self, found: f64, expected: f64, place: impl FnOnce() -> String) {
        let error =
            if expected == 0.0 { found.abs() } else { ((found - expected) / expected).abs() };
        assert!(error.is_finite(), "{}: {found} instead of {expected} at {}", self.what, place());
        if error > self.error {
            self.error = error;
            self.place = place();
        }
    }

    /// Fails if the worst exceeds `limit`.
    pub(crate) fn at_most(self, limit: f64) {
        println!("worst {}: {:.2e} at {}", self.what, self.error, self.place);
        assert!(
            self.error <= limit,
            "{}: {:.2e} > {limit:.0e} at {}",
            self.what,
            self.error,
            self.place
        );
    }
}
