//! Numbers and tables as people read them on a terminal.

use rough_contact::compare::{Fact, Finding, Level, MaterialUse, Weight};
use rough_contact::contact_types::{AsperityStatistics, Named};
pub(crate) use rough_contact::front_end::shown::*;
use rough_contact::report;
pub(crate) use rough_contact::report::numbers::plain;
use rough_contact::report::numbers::{AREAS, NEWTONS, relative_interval};
use rough_contact::surface_stats::clean::Record;
use std::fmt;

#[derive(Default)]
pub(crate) struct TwoColumns {
    rows: Vec<(String, String)>,
}

impl TwoColumns {
    pub(crate) fn row(&mut self, name: impl Into<String>, value: impl Into<String>) {
        self.rows.push((name.into(), value.into()));
    }

    /// What the asperities of a surface are, where they are known.
    pub(crate) fn asperities(&mut self, found: Option<AsperityStatistics>) {
        let Some(a) = found else { return };
        self.row("asperity density", format!("{:.4e} m⁻²", a.density));
        self.row("asperity radius", length(a.radius));
        self.row("asperity height std", length(a.height_std));
    }
}

impl fmt::Display for TwoColumns {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let width = self.rows.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
        for (name, value) in &self.rows {
            writeln!(f, "{name:<width$}  {value}")?;
        }
        Ok(())
    }
}

/// One line for each step of cleaning; nothing if there was none.
pub(crate) fn cleaning(records: &[Record]) -> String {
    records.iter().map(|record| format!("cleaned: {record}\n")).collect::<Vec<_>>().concat()
}

pub(crate) const MOMENTS: &str = "moments of the models: finite differences\n";

/// What was taken off a map first, and why if nobody asked for it.
pub(crate) fn level(asked: Level, used: Level) -> String {
    match (asked, used) {
        (_, Level::None) => "level: none, the heights as they are\n".to_owned(),
        (Level::Auto, Level::Mean) => {
            "level: mean taken off; opposite edges meet as they are (--level)\n".to_owned()
        }
        (_, form) => format!("level: {} taken off (--level)\n", form.name()),
    }
}

const MOST: usize = 3;

/// The worst findings, one line each, and how many more there are.
pub(crate) fn findings(found: &[Finding]) -> String {
    let open: Vec<&Finding> = found.iter().filter(|f| f.weight != Weight::Passed).collect();
    // A verdict that was asked for is given, however long the list is.
    let asked = |f: &&&Finding| matches!(f.fact, Fact::Adhesion(_));
    let shown: Vec<&&Finding> =
        open.iter().take(MOST).chain(open.iter().skip(MOST).filter(asked)).collect();
    let text: String = shown.iter().map(|f| finding_line(f)).collect();
    match open.len() - shown.len() {
        0 => text,
        more => format!("{text}and {more} more: --json has all findings\n"),
    }
}

/// The materials whose numbers were taken from the table, with condition and source.
pub(crate) fn materials(used: &[MaterialUse]) -> String {
    let line = |used: &MaterialUse| plain(&report::material_line(used)) + "\n";
    used.iter().map(line).collect()
}

pub(crate) fn finding_line(finding: &Finding) -> String {
    let [claim, text] = report::finding(finding);
    let line = format!("{}: {claim} {text}", finding.weight.name());
    format!("{}\n", plain(&line).trim_end())
}

/// An area in square metres, such as `2.000 mm²`.
pub(crate) fn area(square_metres: f64) -> String {
    plain(&report::numbers::quantity(square_metres, AREAS, 4))
}

/// A force in newtons, such as `10.0 N`.
pub(crate) fn force(newtons: f64) -> String {
    plain(&report::numbers::quantity(newtons, NEWTONS, 3))
}

/// Seconds, such as `1.2 ms`.
pub(crate) fn seconds(seconds: f64) -> String {
    plain(&report::numbers::duration(seconds))
}

/// The highest pressure of a point. The mean over the contact cannot exceed it: where it seems to,
/// the contacts are smaller than the points.
pub(crate) fn highest(highest: f64, mean: Option<f64>) -> String {
    match mean {
        Some(mean) if mean > highest => format!("above {}", pressure(mean)),
        _ => pressure(highest),
    }
}

/// How a value is written; a dash where there is none.
pub(crate) fn or_dash<T>(value: Option<T>, write: impl FnOnce(T) -> String) -> String {
    value.map_or_else(|| "–".to_owned(), write)
}

/// The ends between which a number lies, as a share of it where they are even, such as `±2.1 %`; a dash where there
/// are none, and what is known where one of them is not.
pub(crate) fn relative(
    value: f64,
    ends: Option<[f64; 2]>,
    shown: impl Fn(f64) -> String,
) -> String {
    let Some([low, high]) = ends.filter(|_| value > 0.0) else { return "–".to_owned() };
    match (low > 0.0, high.is_finite()) {
        (false, false) => "–".to_owned(),
        (false, true) => format!("at most {}", shown(high)),
        (true, false) => format!("at least {}", shown(low)),
        (true, true) => plain(&relative_interval(value, [low, high])),
    }
}

pub(crate) fn digits(value: f64) -> String {
    significant(value, 3)
}

pub(crate) fn number(value: f64) -> String {
    significant(value, 4)
}

/// Columns of equal width under a header; the first is left-aligned, the others are not.
#[derive(Default)]
pub(crate) struct Columns {
    rows: Vec<Vec<String>>,
}

impl Columns {
    pub(crate) fn new(header: &[&str]) -> Self {
        Self { rows: vec![header.iter().map(|&h| h.to_owned()).collect()] }
    }

    pub(crate) fn row(&mut self, cells: impl IntoIterator<Item = String>) {
        self.rows.push(cells.into_iter().collect());
    }

    /// A column of `cells`, one in each row, right of those that are there.
    pub(crate) fn column(&mut self, heading: &str, cells: impl IntoIterator<Item = String>) {
        let column = [heading.to_owned()].into_iter().chain(cells);
        for (row, cell) in column.enumerate() {
            self.rows.resize_with(self.rows.len().max(row + 1), Vec::new);
            self.rows[row].push(cell);
        }
    }

    /// A line across all columns.
    pub(crate) fn heading(&mut self, text: &str) {
        self.rows.push(vec![text.to_owned()]);
    }
}

impl fmt::Display for Columns {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let length = |cell: &String| cell.chars().count();
        let width = |column: usize| {
            let rows = self.rows.iter().filter(|row| row.len() > 1);
            rows.filter_map(|row| row.get(column)).map(length).max().unwrap_or(0)
        };
        for row in &self.rows {
            let mut line = String::new();
            for (column, cell) in row.iter().enumerate() {
                let pad = " ".repeat(width(column).saturating_sub(length(cell)));
                let aligned =
                    if column == 0 { format!("{cell}{pad}") } else { format!("  {pad}{cell}") };
                line.push_str(&aligned);
            }
            writeln!(f, "{}", line.trim_end())?;
        }
        Ok(())
    }
}

/// Where the iteration on `what` stands; the residual is infinite while there is no estimate.
pub(crate) fn iterating(what: &str, number: usize, residual: f64) -> String {
    if residual.is_finite() {
        format!("{what}: iteration {number}, error {residual:.0e}")
    } else {
        format!("{what}: iteration {number}")
    }
}

/// A line of a hardness that may have the wrong unit, if there is something to say.
pub(crate) fn hardness_check(warning: Option<&str>) -> String {
    warning.map_or_else(String::new, |warning| format!("check the hardness: {warning}\n"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_highest_pressure_is_never_below_the_mean() {
        assert_eq!(highest(100e6, Some(190e6)), "above 190 MPa");
        assert_eq!(highest(300e6, Some(190e6)), "300 MPa");
        assert_eq!(highest(300e6, None), "300 MPa");
    }

    #[test]
    fn a_bar_that_reaches_zero_is_one_sided() {
        assert_eq!(relative(0.012, Some([0.0, 0.028]), percent), "at most 2.80 %");
        assert_eq!(relative(0.01, Some([0.009, 0.011]), percent), "±10 %");
        assert_eq!(relative(0.01, None, percent), "–");
        assert_eq!(relative(35e9, Some([20e9, 166e9]), pressure), "−43 to +374 %");
        assert_eq!(relative(35e9, Some([20e9, f64::INFINITY]), pressure), "at least 20.0 GPa");
    }
}
