//! Figures of what accuracy costs: the error of the real area against time, from closed forms to
//! the solver; and the error of the pressure against time, method by method.

use crate::tradeoff::{AreaOf, TradeoffRow, TradeoffTable, Way, is, ways};
use contact_accuracy::median;
use contact_compare::find;
use contact_report::numbers::{SPACE, duration, percent, power_of_ten};
use contact_report::{CostLabel, CostPlot, Style, plot_style};

/// Smallest and largest of some values.
fn span(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, 0.0], |[lo, hi], v| [lo.min(v), hi.max(v)])
}

fn label(text: &str, style: Style) -> CostLabel<'_> {
    CostLabel { text, style, bold: false, small: false, beside: None }
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
    let highest = shown.iter().map(|w| w.error[2]).fold(0.0, f64::max);
    let limits = [[times[0] / 2.5, times[1] * 1.8], [100.0 * errors[0] / 2.0, 150.0 * highest]];
    let titles = ["Time per load", "|Error| of the real area (%)"];
    let mut plot = CostPlot::new(limits, titles, Some(floor));
    if let Some(seconds) = table.statistics() {
        plot.mark(seconds, "statistics of a map, once", true);
    }

    let of_kind = |kind| {
        let is_it = |i: &usize| shown[*i].area == kind;
        (0..shown.len()).filter(is_it).collect::<Vec<_>>()
    };
    let mut places: Vec<[f64; 2]> =
        shown.iter().map(|w| plot.at([w.seconds, 100.0 * w.error[1]])).collect();
    let models = of_kind(AreaOf::Model);
    let wanted: Vec<f64> = models.iter().map(|i| places[*i][0]).collect();
    for (i, x) in models.into_iter().zip(plot.apart(&wanted)) {
        places[i][0] = x;
    }
    let costs: Vec<[f64; 2]> = shown.iter().map(|w| [w.seconds, w.error[1]]).collect();
    plot.front(&costs, &places, floor, 1.6);
    let solver = [(AreaOf::Count, "pixel count", false), (AreaOf::Corrected, "corrected", true)];
    for (kind, ..) in solver {
        let line: Vec<[f64; 2]> = of_kind(kind).into_iter().map(|i| places[i]).collect();
        plot.line(&line, style_of(kind, ""), Some(1.0));
    }
    for (way, place) in shown.iter().zip(&places) {
        let [low, _, high] = way.error.map(|error| plot.at([way.seconds, 100.0 * error])[1]);
        plot.point(*place, Some([low, high]), style_of(way.area, &way.row.method));
    }
    for (kind, name, bold) in solver {
        if let Some(&i) = of_kind(kind).last() {
            let name = label(name, style_of(kind, ""));
            plot.label(places[i], CostLabel { bold, beside: Some(0.0), ..name });
        }
    }
    for (way, place) in shown.iter().zip(&places).filter(|(way, _)| way.area != AreaOf::Count) {
        plot.label(*place, label(&name_of(way), style_of(way.area, &way.row.method)));
    }
    plot.name_front();
    let description = format!(
        "Log-log plot of the median error of the area over {} cases against time per load: {}. \
         The truth's own half width is {}.",
        shown.iter().map(|w| w.cases).max().unwrap_or(0),
        listed(&shown),
        percent(floor)
    );
    plot.svg("tradeoff-area", "Error of the real area against time", description)
}

fn style_of(area: AreaOf, method: &str) -> Style {
    let name = match area {
        AreaOf::Model => method,
        AreaOf::Count => "chord counted",
        AreaOf::Corrected => "chord f64",
    };
    plot_style(name, 0)
}

/// A model, or a grid.
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
    let limits = [[times[0] / 1.6, times[1] * 1.4], [errors[0] / 5.0, 1.0]];
    let titles = ["Time to the answer", "Relative rms error of the pressure"];
    let mut plot = CostPlot::new(limits, titles, None);
    if let Some(seconds) = pair {
        plot.mark(seconds, "one FFT convolution", false);
    }
    let costs: Vec<[f64; 2]> = rows.iter().map(|r| point(r)).collect();
    let places: Vec<[f64; 2]> = costs.iter().map(|cost| plot.at(*cost)).collect();
    plot.front(&costs, &places, 0.0, 1.6);

    let mut drawn = Vec::new();
    for (method, precision, name) in SERIES {
        let is_it =
            |r: &&TradeoffRow| r.method == method && r.precision.as_deref() == Some(precision);
        let series: Vec<&TradeoffRow> = rows.iter().copied().filter(is_it).collect();
        let style = plot_style(&format!("{method} {precision}"), 0);
        let line: Vec<[f64; 2]> = series.iter().map(|r| plot.at(point(r))).collect();
        plot.line(&line, style, None);
        for place in line {
            plot.point(place, None, style);
        }
        let bold = name == "chord";
        drawn.push((series, CostLabel { bold, ..label(name, style) }));
    }
    for (series, name) in &drawn {
        let Some(row) = series.last() else { continue };
        let place = plot.at(point(row));
        let (true, Some(pairs)) = (row.is_capped, row.pairs) else {
            plot.label(place, *name);
            continue;
        };
        // Two lines right of where it was stopped.
        plot.label(place, CostLabel { beside: Some(0.0), ..*name });
        let text = &format!("stopped at {pairs:.0}");
        plot.label(place, CostLabel { text, small: true, beside: Some(10.0), ..*name });
    }
    let found: Vec<String> = drawn.iter().filter_map(|(series, _)| words(series)).collect();
    let description = found.join("; ") + ".";
    plot.svg("tradeoff-pressure", "Error of the pressure against time", description)
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
