//! Figures of what accuracy costs: the error of the real area against time, from closed forms to
//! the solver; and the error of the pressure against time, method by method.

use crate::tradeoff::{AreaOf, TradeoffRow, TradeoffTable, Way, is, ways};
use contact_accuracy::median;
use contact_compare::find;
use contact_report::numbers::{SPACE, duration, percent, power_of_ten};
use contact_report::{CostFigure, CostSeries};

/// Smallest and largest of some values.
fn span(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, 0.0], |[lo, hi], v| [lo.min(v), hi.max(v)])
}

/// Words for a grid by its points per side over those of the map.
fn grid_name(scale: f64) -> &'static str {
    match scale {
        s if s > 1.5 => "2×",
        s if s > 0.7 => "as given",
        s if s > 0.35 => "½",
        s if s > 0.18 => "¼",
        _ => "⅛ grid",
    }
}

/// The error of the real area against time per load: every closed form, and the solver on coarser
/// and finer grids, with the counted and the corrected area. A marker is the median over all
/// surfaces and loads, a bar the range.
pub fn tradeoff_area(table: &TradeoffTable) -> String {
    let mut shown = ways(table.rows.iter());
    shown.retain(|way| way.area == AreaOf::Model || way.row.is_default());
    let floor = median(table.rows.iter().filter_map(|r| Some(r.bar? / r.truth?))).unwrap_or(0.0);
    let times = span(shown.iter().map(|w| w.seconds));
    let errors = span(shown.iter().map(|w| w.error[1]).chain([floor]));
    let cost = |way: &Way<'_>| [way.seconds, way.error[1]];
    let highest = shown.iter().map(|w| w.error[2]).fold(0.0, f64::max);
    let limits = [[times[0] / 2.5, times[1] * 1.8], [100.0 * errors[0] / 2.0, 150.0 * highest]];
    let line = |(kind, label, bold): (AreaOf, &str, bool)| CostSeries {
        style: style_of(kind, "").into(),
        costs: shown.iter().filter(|w| w.area == kind).map(cost).collect(),
        is_line: true,
        label: label.into(),
        bold,
        ..CostSeries::default()
    };
    let one = |way: &Way<'_>| CostSeries {
        style: style_of(way.area, &way.row.method).into(),
        costs: vec![cost(way)],
        range: Some([way.error[0], way.error[2]]),
        is_moved: way.area == AreaOf::Model,
        label: if way.area == AreaOf::Count { String::new() } else { name_of(way) },
        ..CostSeries::default()
    };
    let lines = [(AreaOf::Count, "pixel count", false), (AreaOf::Corrected, "corrected", true)];
    let figure = CostFigure {
        limits,
        titles: ["Time per load", "|Error| of the real area (%)"],
        floor: Some(floor),
        mark: table.statistics().map(|seconds| (seconds, "statistics of a map, once")),
        series: lines.into_iter().map(line).chain(shown.iter().map(one)).collect(),
    };
    let description = format!(
        "Log-log plot of the median error of the area over {} cases against time per load: {}. \
         The truth's own half width is {}.",
        shown.iter().map(|w| w.cases).max().unwrap_or(0),
        listed(&shown),
        percent(floor)
    );
    figure.svg("tradeoff-area", "Error of the real area against time", description)
}

fn style_of(area: AreaOf, method: &str) -> &str {
    match area {
        AreaOf::Model => method,
        AreaOf::Count => "chord counted",
        AreaOf::Corrected => "chord f64",
    }
}

fn name_of(way: &Way<'_>) -> String {
    match way.row.scale {
        None => find(&way.row.method).map_or("", |m| m.card().label.as_ref()).to_owned(),
        Some(scale) => grid_name(scale).to_owned(),
    }
}

fn listed(shown: &[Way<'_>]) -> String {
    let one = |w: &Way<'_>| {
        let kind = match w.area {
            AreaOf::Model => "",
            AreaOf::Count => " counted",
            AreaOf::Corrected => " corrected",
        };
        format!("{}{kind} {} in {}", name_of(w), percent(w.error[1]), duration(w.seconds))
    };
    shown.iter().map(one).collect::<Vec<_>>().join("; ")
}

/// Methods of the solver in a precision, and what they are called.
const SERIES: [(&str, &str, &str); 6] = [
    ("chord", "f64", "chord"),
    ("chord", "f32", "chord f32"),
    ("polonsky-keer", "f64", "Polonsky–Keer"),
    ("polonsky-keer", "f32", "f32"),
    ("stanley-kato", "f64", "Stanley–Kato"),
    ("stanley-kato", "f32", "f32"),
];

/// The true relative rms error of the pressure against time, over the tolerance: each method of
/// the solver in each precision on the given grid, for one surface at one load.
pub fn tradeoff_pressure(table: &TradeoffTable) -> String {
    let full = |r: &&TradeoffRow| is(r.scale, 1.0);
    let rows: Vec<&TradeoffRow> =
        table.rows.iter().filter(full).filter(|r| r.pressure_error.is_some()).collect();
    let point = |r: &TradeoffRow| [r.seconds, r.pressure_error.unwrap_or(1.0).max(1e-13)];
    let pair = table.pair();
    let times = span(rows.iter().map(|r| r.seconds).chain(pair));
    let errors = span(rows.iter().map(|r| point(r)[1]));
    let of = |(method, precision, _): &(&str, &str, &str)| -> Vec<&TradeoffRow> {
        let is_it =
            |r: &&TradeoffRow| r.method == *method && r.precision.as_deref() == Some(precision);
        rows.iter().copied().filter(is_it).collect()
    };
    let series = |named: &(&str, &str, &str)| {
        let (rows, (method, precision, label)) = (of(named), *named);
        // Where it was stopped.
        let stopped = rows.last().filter(|row| row.is_capped).and_then(|row| row.pairs);
        CostSeries {
            style: format!("{method} {precision}"),
            costs: rows.iter().map(|r| point(r)).collect(),
            label: label.into(),
            bold: label == "chord",
            note: stopped.map_or_else(String::new, |pairs| format!("stopped at {pairs:.0}")),
            ..CostSeries::default()
        }
    };
    let figure = CostFigure {
        limits: [[times[0] / 1.6, times[1] * 1.4], [errors[0] / 5.0, 1.0]],
        titles: ["Time to the answer", "Relative rms error of the pressure"],
        floor: None,
        mark: pair.map(|seconds| (seconds, "one FFT convolution")),
        series: SERIES.iter().map(series).collect(),
    };
    let found: Vec<String> = SERIES.iter().filter_map(|named| words(&of(named))).collect();
    let description = found.join("; ") + ".";
    figure.svg("tradeoff-pressure", "Error of the pressure against time", description)
}

/// A series in words: its most accurate point.
fn words(series: &[&TradeoffRow]) -> Option<String> {
    let row = series.last()?;
    let exponent = row.pressure_error?.log10().ceil() as i32;
    Some(format!(
        "{} {} is below {} after {:.0} FFT convolutions in {}",
        row.method,
        row.precision.as_deref()?,
        power_of_ten(exponent),
        row.pairs?,
        duration(row.seconds).replace(SPACE, " ")
    ))
}
