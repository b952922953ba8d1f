//! A table read by the names of its columns.

use std::error::Error;
use std::fs;
use std::path::Path;

pub(crate) struct Table {
    names: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    pub(crate) fn read(path: &Path) -> Result<Self, Box<dyn Error>> {
        let text = fs::read_to_string(path)?;
        let mut lines = text.lines().filter(|line| !line.starts_with('#'));
        let cells = |line: &str| line.split(',').map(str::to_owned).collect::<Vec<String>>();
        let names = cells(lines.next().ok_or("an empty table")?);
        Ok(Self { names, rows: lines.map(cells).collect() })
    }

    /// How many rows it has.
    pub(crate) fn len(&self) -> usize {
        self.rows.len()
    }

    /// A number by row and column; NaN where there is none.
    pub(crate) fn get(&self, row: usize, column: &str) -> f64 {
        let place = self.names.iter().position(|n| n == column);
        place.and_then(|k| self.rows[row].get(k)?.parse().ok()).unwrap_or(f64::NAN)
    }
}
