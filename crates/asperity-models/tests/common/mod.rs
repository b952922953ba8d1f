//! Reading the high-precision tables.
#![allow(dead_code, reason = "each test binary uses its part")]
#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "tests: a panic is the report")]

/// Rows of a table in `fixtures/reference`; the first line says where it came from, the second
/// names the columns.
pub(crate) fn rows(text: &str) -> Vec<Vec<&str>> {
    let mut lines = text.lines();
    assert!(lines.next().unwrap().starts_with("# "), "a table opens with its origin");
    lines.next();
    lines.map(|line| line.split(',').collect()).collect()
}

/// The number in a cell; more digits than a double holds are rounded, beyond its range it
/// becomes 0 or infinity.
pub(crate) fn number(cell: &str) -> f64 {
    cell.parse().unwrap()
}

/// |x / reference - 1|; 0 where the reference is 0, subnormal or infinite and no relative error
/// can be asked for.
pub(crate) fn relative_error(x: f64, reference: f64) -> f64 {
    if reference.is_normal() { (x / reference - 1.0).abs() } else { 0.0 }
}

/// The largest error seen, and where.
#[derive(Default)]
pub(crate) struct Worst {
    pub(crate) error: f64,
    pub(crate) at: String,
}

impl Worst {
    pub(crate) fn see(&mut self, error: f64, at: impl Fn() -> String) {
        if error > self.error || error.is_nan() {
            *self = Self { error, at: at() };
        }
    }

    pub(crate) fn check(&self, what: &str, limit: f64) {
        println!("{what}: worst error {:.1e} at {}", self.error, self.at);
        assert!(self.error <= limit, "{what}: error {:e} > {limit:e} at {}", self.error, self.at);
    }
}
