//! What the book says of the measurements, from their table: figures, what to use for a given
//! error, and the numbers.

use contact_compare::find;
use contact_report::numbers::percent;
use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use studies::figures::{tradeoff_area, tradeoff_pressure};
use studies::tradeoff::{AreaOf, TradeoffRow, TradeoffTable, Way, is, ways};

/// Errors a reader may want to stay below.
const WANTED: [f64; 6] = [0.5, 0.3, 0.15, 0.05, 0.025, 0.015];

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
    let everywhere = everywhere(&found);
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
    choice(&mut page, &found);
    spread(&mut page, &everywhere, one_pair);
    close_up(&mut page, table, one_pair);
    page
}

/// Ways that were measured in all cases.
fn everywhere<'a>(found: &'a [Way<'a>]) -> Vec<&'a Way<'a>> {
    let cases = found.iter().map(|w| w.cases).max().unwrap_or(0);
    found.iter().filter(|w| w.cases == cases).collect()
}

/// The cheapest way that stayed below each error in every case, the truth's own half width added.
/// Grids are compared at one tolerance and precision, so that their times are far apart and the
/// choice does not hang on the last per cent of a clock.
fn cheapest<'a>(found: &'a [Way<'a>]) -> Vec<(f64, Option<&'a Way<'a>>)> {
    let mut fits = everywhere(found);
    fits.retain(|w| w.area == AreaOf::Model || w.row.is_default());
    let best = |wanted: f64| {
        let good = fits.iter().copied().filter(|w| w.worst <= wanted);
        good.min_by(|a, b| a.seconds.total_cmp(&b.seconds))
    };
    WANTED.into_iter().map(|wanted| (wanted, best(wanted))).collect()
}

fn row(page: &mut String, cells: &[String]) {
    let _ = writeln!(page, "| {} |", cells.join(" | "));
}

fn choice(page: &mut String, found: &[Way<'_>]) {
    let cases = found.iter().map(|w| w.cases).max().unwrap_or(0);
    let _ = writeln!(
        page,
        "| real area within | cheapest way that stayed there in all {cases} cases | its largest \
         error | time per load |\n|---|---|---|---|"
    );
    for (wanted, best) in cheapest(found) {
        let [name, error, time] = best
            .map_or(["none of these", "–", "–"].map(str::to_owned), |best| {
                [name(best), percent(best.worst), duration(best.seconds)]
            });
        row(page, &[percent(wanted), name, error, time]);
    }
}

fn name(way: &Way<'_>) -> String {
    let grid = || grid_name(way.row);
    match way.area {
        AreaOf::Model => model_name(way.row),
        AreaOf::Count => format!("solver, {}, pixel count", grid()),
        AreaOf::Corrected => format!("solver, {}, corrected area", grid()),
    }
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
        "\nSize of the error over all surfaces and loads, median (smallest to largest), the solver at its \
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

/// Every method at one load: what was asked for, what came out.
fn close_up(page: &mut String, table: &TradeoffTable, one_pair: f64) {
    let rows: Vec<&TradeoffRow> =
        table.rows.iter().filter(|r| r.pressure_error.is_some()).collect();
    let Some(first) = rows.first() else { return };
    let _ = writeln!(
        page,
        "\nEvery method on *{}* at p = {} E\\* h′rms; convolutions are of the row's own grid:\n\n\
         | method | grid | tolerance | pixel count | corrected | true pressure error | \
         FFT convolutions | time | the same in full-size convolutions |\n\
         |---|---|---|---:|---:|---:|---:|---:|---:|",
        first.surface,
        first.load.unwrap_or(0.0)
    );
    // Each method in double precision: on every grid at the default tolerance, on the given one at every second decade.
    let decade = |r: &TradeoffRow| r.tolerance.is_some_and(|t| (t.log10().round() as i32) % 2 == 0);
    let is_told = |r: &&&TradeoffRow| {
        r.precision.as_deref() == Some("f64")
            && (r.is_at_default() || is(r.scale, 1.0) && decade(r))
    };
    for r in rows.iter().filter(is_told) {
        let signed = |area| r.error_of(area).map_or("–".into(), signed_percent);
        let stopped = if r.is_capped { " (stopped)" } else { "" };
        let cells = [
            r.method.clone(),
            format!("{}²", r.points.unwrap_or(0)),
            tolerance(r),
            signed(r.area),
            signed(r.corrected),
            r.pressure_error.map_or("–".into(), power),
            r.pairs.map_or("–".into(), digits) + stopped,
            duration(r.seconds),
            digits(r.seconds / one_pair),
        ];
        row(page, &cells);
    }
}

fn tolerance(row: &TradeoffRow) -> String {
    row.tolerance.map_or("–".into(), |t| format!("{t:e}").replace("1e-", "1e\u{2212}"))
}

fn power(value: f64) -> String {
    format!("{value:.1e}").replace("e-", "e\u{2212}")
}

/// Two significant digits, three from 100.
fn digits(value: f64) -> String {
    if value < 1e-3 {
        return power(value);
    }
    let places = (1 - value.abs().max(1e-9).log10().floor() as i32).clamp(0, 6);
    format!("{value:.*}", places as usize)
}

fn signed_percent(error: f64) -> String {
    let sign = if error < 0.0 { '\u{2212}' } else { '+' };
    format!("{sign}{}", percent(error.abs()))
}

fn duration(seconds: f64) -> String {
    let units = [(1.0, "s"), (1e-3, "ms"), (1e-6, "µs"), (1e-9, "ns")];
    let (scale, unit) =
        units.into_iter().find(|(scale, _)| seconds >= 0.995 * scale).unwrap_or(units[3]);
    format!("{}\u{202F}{unit}", digits(seconds / scale))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::{Plan, run};

    #[test]
    fn numbers_read_well() {
        assert_eq!(percent(0.0123), "1.2\u{202F}%");
        assert_eq!(signed_percent(-5.35), "\u{2212}535\u{202F}%");
        assert_eq!(digits(13.37), "13");
        assert_eq!(digits(3.3e-7), "3.3e\u{2212}7");
        assert_eq!(
            [duration(2e-8), duration(0.126), duration(23.7)],
            ["20\u{202F}ns", "126\u{202F}ms", "24\u{202F}s"]
        );
    }

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
        for word in ["Persson", "½ of the points", "2 × finer", "stanley-kato", "(stopped)"] {
            assert!(page.contains(word), "{word} is not in\n{page}");
        }
        assert!(!page.contains("NaN") && !page.contains("inf"), "{page}");
        for svg in [tradeoff_area(&table), tradeoff_pressure(&table)] {
            assert!(svg.contains("<svg") && !svg.contains("NaN"), "{svg}");
        }
    }
}
