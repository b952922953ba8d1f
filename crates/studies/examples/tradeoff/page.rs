//! What the book says of the measurements, from their table: figures, and the error and time of each way.

use contact_compare::find;
use contact_report::numbers::{duration, percent};
use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use studies::figures::{tradeoff_area, tradeoff_pressure};
use studies::tradeoff::{AreaOf, TradeoffRow, TradeoffTable, Way, ways};

/// Writes `tradeoff-area.svg`, `tradeoff-pressure.svg` and `tradeoff.md` into `folder`.
pub(crate) fn write(table: &Path, folder: &Path) -> Result<(), Box<dyn Error>> {
    let table = TradeoffTable::parse(&fs::read_to_string(table)?)?;
    fs::create_dir_all(folder)?;
    fs::write(folder.join("tradeoff-area.svg"), tradeoff_area(&table))?;
    fs::write(folder.join("tradeoff-pressure.svg"), tradeoff_pressure(&table))?;
    fs::write(folder.join("tradeoff.md"), page(&table))?;
    Ok(())
}

fn page(table: &TradeoffTable) -> String {
    let found = ways(table.rows.iter());
    let mut page = String::new();
    for line in &table.origin {
        let _ = writeln!(page, "{line}  ");
    }
    let one_pair = table.pair().unwrap_or(f64::NAN);
    let bars = table.rows.iter().filter_map(|r| Some(r.bar? / r.truth?));
    let [low, high] = bars.fold([f64::INFINITY, 0.0_f64], |[l, h], b| [l.min(b), h.max(b)]);
    let _ = writeln!(
        page,
        "One FFT convolution on the given grid, f64: {}. Statistics of a map: {}. The truth is known to \
         ±{} to ±{} of itself.\n",
        duration(one_pair),
        duration(table.statistics().unwrap_or(f64::NAN)),
        percent(low),
        percent(high)
    );
    spread(&mut page, &everywhere(&found), one_pair);
    page
}

/// Ways that were measured in all cases.
fn everywhere<'a>(found: &'a [Way<'a>]) -> Vec<&'a Way<'a>> {
    let cases = found.iter().map(|w| w.cases).max().unwrap_or(0);
    found.iter().filter(|w| w.cases == cases).collect()
}

fn row(page: &mut String, cells: &[String]) {
    let _ = writeln!(page, "| {} |", cells.join(" | "));
}

fn model_name(row: &TradeoffRow) -> String {
    find(&row.method).map_or(&*row.method, |m| m.card().title.as_ref()).to_owned()
}

fn grid_name(row: &TradeoffRow) -> String {
    let points = row.points.map_or(String::new(), |n| format!(" ({n}²)"));
    let words = match row.scale.unwrap_or(1.0) {
        s if s > 1.5 => "2 × finer grid",
        s if s > 0.7 => "given grid",
        s if s > 0.35 => "½ of the points per side",
        s if s > 0.18 => "¼ of the points per side",
        _ => "⅛ of the points per side",
    };
    format!("{words}{points}")
}

/// Every way at the default tolerance in every case: median and range.
fn spread(page: &mut String, found: &[&Way<'_>], one_pair: f64) {
    page.push_str(
        "Size of the error over all surfaces and loads, median (smallest to largest), the solver at its \
         default tolerance of 1e\u{2212}4:\n\n\
         | way | precision | pixel count | corrected | FFT convolutions | time per load | \
         the same in full-size convolutions |\n|---|---|---:|---:|---:|---:|---:|\n",
    );
    let range = |w: &Way<'_>| {
        let [low, middle, high] = w.error.map(percent);
        format!("{middle} ({low} to {high})")
    };
    let dash = || "–".to_owned();
    let times = |w: &Way<'_>| [duration(w.seconds), digits(w.seconds / one_pair)];
    for way in found.iter().filter(|w| w.area == AreaOf::Model) {
        let [time, pairs] = times(way);
        row(page, &[model_name(way.row), dash(), range(way), dash(), dash(), time, pairs]);
    }
    let solved = found.iter().filter(|w| w.area == AreaOf::Corrected && w.row.is_at_default());
    for way in solved {
        let mut same = found.iter().filter(|w| std::ptr::eq(w.row, way.row));
        let count = same.find(|w| w.area == AreaOf::Count).map_or_else(dash, |w| range(w));
        let precision = way.row.precision.clone().unwrap_or_else(dash);
        let (spent, [time, pairs]) = (way.pairs.map_or_else(dash, digits), times(way));
        row(page, &[grid_name(way.row), precision, count, range(way), spent, time, pairs]);
    }
}

/// Two significant digits, three from 100.
fn digits(value: f64) -> String {
    if value < 1e-3 {
        return format!("{value:.1e}").replace("e-", "e\u{2212}");
    }
    let places = (1 - value.abs().max(1e-9).log10().floor() as i32).clamp(0, 6);
    format!("{value:.*}", places as usize)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::{Plan, run};

    /// From measurement to page on a tiny grid: the table can be read back, every way is in the
    /// page, the solver is nearer the truth than its pixel count, and the pressure is as accurate
    /// as was asked for.
    #[test]
    fn a_tiny_run_fills_figures_and_page() {
        let mut text = format!("# a test\n{}\n", studies::tradeoff::HEADER);
        run(&Plan::TINY, &mut |row| {
            assert!(row.pressure_error.is_none_or(f64::is_finite), "{row:?}");
            text += &(row.line() + "\n");
        })
        .unwrap();
        let table = TradeoffTable::parse(&text).unwrap();
        let found = ways(table.rows.iter());
        let at = |area| found.iter().find(|w| w.area == area && w.row.is_default()).unwrap();
        assert!(at(AreaOf::Corrected).error[1] < 0.5 * at(AreaOf::Count).error[1]);
        let close: Vec<&TradeoffRow> =
            table.rows.iter().filter(|r| r.pressure_error.is_some()).collect();
        assert!(close.iter().any(|r| r.method == "stanley-kato" && r.is_capped));
        for row in close.iter().filter(|r| !r.is_capped) {
            let [error, asked] = [row.pressure_error.unwrap(), row.tolerance.unwrap()];
            assert!(error < 3.0 * asked, "{row:?}");
        }
        let page = page(&table);
        for word in ["Persson", "½ of the points", "2 × finer"] {
            assert!(page.contains(word), "{word} is not in\n{page}");
        }
        assert!(!page.contains("NaN") && !page.contains("inf"), "{page}");
        for svg in [tradeoff_area(&table), tradeoff_pressure(&table)] {
            assert!(svg.contains("<svg") && !svg.contains("NaN"), "{svg}");
        }
    }
}
