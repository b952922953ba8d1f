//! What accuracy costs: ways to an answer with their time and true error, as `cargo xtask
//! tradeoff` measured them, and the ways that no other beats.
//!
//! The table is a CSV whose lines beginning with `#` say where it comes from.

use contact_accuracy::{median, round_to_digits};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

/// One way to an answer, in one case: a surface at a load.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct TradeoffRow {
    /// Name of the surface.
    pub surface: String,
    /// Mean pressure over E* h'_rms; `None` for what does not depend on a load.
    pub load: Option<f64>,
    /// Name of a model or of a method of the solver; or [`PAIR`] or [`STATISTICS`].
    pub method: String,
    /// Points per side over those of the given map; `None` for a model.
    pub scale: Option<f64>,
    /// Points per side.
    pub points: Option<usize>,
    /// `f64` or `f32`; `None` for a model.
    pub precision: Option<String>,
    /// Relative rms pressure error asked for.
    pub tolerance: Option<f64>,
    /// Area fraction: of a model, or the pixels that carry pressure.
    pub area: Option<f64>,
    /// That corrected for the contact line.
    pub corrected: Option<f64>,
    /// True area fraction, from a refined grid.
    pub truth: Option<f64>,
    /// Half width of the truth's own interval.
    pub bar: Option<f64>,
    /// Relative rms error of the pressure against the exact solution on the same grid.
    pub pressure_error: Option<f64>,
    /// FFT convolutions spent, of its own grid.
    pub pairs: Option<f64>,
    /// Shortest wall-clock time (s).
    pub seconds: f64,
    /// True if the limit of FFT convolutions ended it.
    #[serde(rename = "capped")]
    pub is_capped: bool,
}

/// Method of a row that holds the time of one FFT convolution.
pub const PAIR: &str = "fft-pair";
/// Method of a row that holds the time of the statistics that models are made from.
pub const STATISTICS: &str = "statistics";

/// First line of the table that is no comment.
pub const HEADER: &str = "surface,load,method,scale,points,precision,tolerance,area,corrected,\
                          truth,bar,pressure_error,pairs,seconds,capped";

impl TradeoffRow {
    /// The row as a line of the table, six digits each; empty cells where there is nothing.
    pub fn line(&self) -> String {
        let row = json!(self);
        let cell = |name| match &row[name] {
            Value::String(text) => text.clone(),
            Value::Bool(truth) => if *truth { "yes" } else { "no" }.to_owned(),
            Value::Number(number) if number.is_u64() => number.to_string(),
            number => number.as_f64().map_or(String::new(), six),
        };
        HEADER.split(',').map(cell).collect::<Vec<_>>().join(",")
    }

    fn parse(line: &str) -> Option<Self> {
        if line.split(',').count() != HEADER.split(',').count() {
            return None;
        }
        let value = |cell: &str| match cell {
            "" => Value::Null,
            "yes" | "no" => json!(cell == "yes"),
            text => serde_json::from_str(text).unwrap_or(json!(text)),
        };
        let names = HEADER.split(',').map(str::to_owned);
        let row = names.zip(line.split(',').map(value)).collect();
        serde_json::from_value(Value::Object(row)).ok()
    }

    /// Whether the tolerance is the solver's default, at which grids are compared.
    pub fn is_at_default(&self) -> bool {
        is(self.tolerance, 1e-4)
    }

    /// Whether the fast method in double precision made it at that tolerance.
    pub fn is_default(&self) -> bool {
        self.method == "chord" && self.precision.as_deref() == Some("f64") && self.is_at_default()
    }

    /// Signed relative error of an area of this row.
    pub fn error_of(&self, area: Option<f64>) -> Option<f64> {
        Some(area? / self.truth? - 1.0)
    }
}

/// Six significant digits, with an exponent where it is shorter.
fn six(value: f64) -> String {
    let rounded = round_to_digits(value, 6);
    let (plain, power) = (format!("{rounded}"), format!("{rounded:e}"));
    if plain.len() <= power.len() { plain } else { power }
}

/// The whole table.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TradeoffTable {
    /// The lines that say where it comes from, without `#`.
    pub origin: Vec<String>,
    /// The rows.
    pub rows: Vec<TradeoffRow>,
}

impl TradeoffTable {
    /// Reads a table.
    ///
    /// # Errors
    /// The first line that is not one of a table.
    pub fn parse(text: &str) -> Result<Self, String> {
        let mut table = Self::default();
        let mut is_headed = false;
        for line in text.lines().filter(|line| !line.trim().is_empty()) {
            if let Some(words) = line.strip_prefix('#') {
                table.origin.push(words.trim().to_owned());
            } else if line == HEADER {
                is_headed = true;
            } else {
                let row = TradeoffRow::parse(line).filter(|_| is_headed);
                table.rows.push(row.ok_or_else(|| format!("this is no row of costs: {line:?}"))?);
            }
        }
        Ok(table)
    }

    /// Seconds of one FFT convolution on the given grid in double precision, which is the first.
    pub fn pair(&self) -> Option<f64> {
        self.rows.iter().find(|r| r.method == PAIR && is(r.scale, 1.0)).map(|r| r.seconds)
    }

    /// Median seconds of the statistics that models are made from.
    pub fn statistics(&self) -> Option<f64> {
        median(self.rows.iter().filter(|r| r.method == STATISTICS).map(|r| r.seconds))
    }
}

/// Which area of an answer is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AreaOf {
    /// A closed form.
    Model,
    /// The pixels that carry pressure.
    Count,
    /// That corrected for the contact line.
    Corrected,
}

/// One way to an area over all cases it was measured in.
#[derive(Debug, Clone)]
pub struct Way<'a> {
    /// Its first row: method, grid, precision, tolerance.
    pub row: &'a TradeoffRow,
    /// Which area.
    pub area: AreaOf,
    /// Size of the relative error: smallest, median, largest.
    pub error: [f64; 3],
    /// Median time (s).
    pub seconds: f64,
    /// Median FFT convolutions; `None` for a model.
    pub pairs: Option<f64>,
    /// Cases.
    pub cases: usize,
}

/// Ways to an area in the rows given: equal settings on different surfaces and loads are one way.
pub fn ways<'a>(rows: impl Iterator<Item = &'a TradeoffRow>) -> Vec<Way<'a>> {
    let mut groups: Vec<Vec<&TradeoffRow>> = Vec::new();
    let is_same = |a: &TradeoffRow, b: &TradeoffRow| {
        let key = |r: &TradeoffRow| (r.method.clone(), r.precision.clone());
        key(a) == key(b) && same(a.scale, b.scale) && same(a.tolerance, b.tolerance)
    };
    for row in rows.filter(|r| r.area.is_some() && r.truth.is_some()) {
        match groups.iter_mut().find(|g| is_same(g[0], row)) {
            Some(group) => group.push(row),
            None => groups.push(vec![row]),
        }
    }
    groups
        .iter()
        .flat_map(|group| {
            let kinds: &[AreaOf] = if group[0].scale.is_some() {
                &[AreaOf::Count, AreaOf::Corrected]
            } else {
                &[AreaOf::Model]
            };
            kinds.iter().filter_map(|&kind| way(group, kind))
        })
        .collect()
}

fn way<'a>(group: &[&'a TradeoffRow], area: AreaOf) -> Option<Way<'a>> {
    let error = |r: &&TradeoffRow| {
        let value = if area == AreaOf::Corrected { r.corrected } else { r.area };
        Some(r.error_of(value)?.abs())
    };
    let sizes = || group.iter().filter_map(error);
    Some(Way {
        row: group.first()?,
        area,
        error: [sizes().reduce(f64::min)?, median(sizes())?, sizes().reduce(f64::max)?],
        seconds: median(group.iter().map(|r| r.seconds))?,
        pairs: median(group.iter().filter_map(|r| r.pairs)),
        cases: sizes().count(),
    })
}

/// Whether a number is there and this one.
pub fn is(value: Option<f64>, wanted: f64) -> bool {
    value.is_some_and(|v| (v / wanted - 1.0).abs() < 1e-6)
}

fn same(a: Option<f64>, b: Option<f64>) -> bool {
    b.map_or(a.is_none(), |b| is(a, b))
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROW: &str =
        "ground,0.05,chord,0.5,500,f32,1e-4,0.0912,0.0845,0.084,5e-4,7.5e-5,6.5,0.0213,no";

    fn row() -> TradeoffRow {
        TradeoffRow::parse(ROW).unwrap()
    }

    #[test]
    fn a_row_is_read_as_written() {
        let full = row();
        assert_eq!(full.line(), ROW);
        assert_eq!((&*full.surface, full.points, full.area), ("ground", Some(500), Some(0.0912)));
        let model =
            TradeoffRow { scale: None, points: None, precision: None, tolerance: None, ..row() };
        let pair = TradeoffRow { load: None, area: None, truth: None, is_capped: true, ..row() };
        let rows = vec![full, model, pair];
        let text: String = rows.iter().map(|row| row.line() + "\n").collect();
        let table = TradeoffTable::parse(&format!("# made here\n{HEADER}\n{text}")).unwrap();
        assert_eq!(table.origin, ["made here"]);
        assert_eq!(table.rows, rows);
        let error = row().error_of(row().corrected).unwrap();
        assert!((error - 5e-4 / 0.084).abs() < 1e-12);
    }

    #[test]
    fn a_damaged_table_is_refused_with_its_line() {
        for bad in [ROW.replace("0.0912", "x"), format!("{ROW},"), ROW.replace(",no", ",maybe")] {
            let error = TradeoffTable::parse(&format!("{HEADER}\n{bad}")).unwrap_err();
            assert!(error.contains("ground"), "{error}");
        }
        assert!(TradeoffTable::parse(ROW).is_err()); // no header
    }

    #[test]
    fn equal_settings_are_one_way_with_its_range() {
        let at = |surface: &str, corrected: f64, seconds: f64| TradeoffRow {
            surface: surface.into(),
            corrected: Some(0.1 * (1.0 + corrected)),
            area: Some(0.11),
            truth: Some(0.1),
            bar: Some(0.001),
            seconds,
            ..row()
        };
        let model = TradeoffRow { scale: None, method: "persson".into(), ..at("a", 0.0, 1e-8) };
        let finer = TradeoffRow { tolerance: Some(1e-5), ..at("a", 0.0, 3.0) };
        let rows = [at("a", -0.04, 1.0), model, at("b", 0.02, 2.0), finer, at("c", 0.01, 9.0)];
        let ways = ways(rows.iter());
        assert_eq!(ways.len(), 5); // count and corrected of two tolerances, one model
        let way = &ways[1];
        assert_eq!((way.area, way.cases), (AreaOf::Corrected, 3));
        for (found, expected) in way.error.into_iter().zip([0.01, 0.02, 0.04]) {
            assert!((found - expected).abs() < 1e-12);
        }
        assert!((way.seconds - 2.0).abs() < 1e-12);
        assert_eq!(ways[2].area, AreaOf::Model);
    }
}
