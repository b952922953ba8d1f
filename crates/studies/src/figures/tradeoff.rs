//! Figures of what accuracy costs: the error of the real area against time, from closed forms to
//! the solver; and the error of the pressure against time, method by method.

use crate::tradeoff::{AreaOf, PAIR, STATISTICS, Table, TradeoffRow, Way, ways};
use contact_accuracy::median;
use contact_compare::find;
use contact_report::draw::axes::{Frame, PlotAxis};
use contact_report::draw::labels::{place_near, push_apart};
use contact_report::draw::palette::{
    BAND, Colour, DETERMINISTIC, DETERMINISTIC_STYLE, INK2, LINE, Marker, Style, WARN,
};
use contact_report::draw::svg::{Anchor, COLUMN, Canvas, Figure, Rect, Stroke, Text, text_width};
use contact_report::figures::front::front;
use contact_report::numbers::{SPACE, duration, percent, power_of_ten, time_tick};
use contact_report::plot_styles::plot_style;
use std::io::{self, Write};

/// Tolerance at which the grids are compared: the solver's own default.
const TOLERANCE: f64 = 1e-4;

/// Room for labels right of the frame.
const RIGHT: f64 = 66.0;

/// The front, wide enough to be seen behind what lies on it.
const FRONT: Stroke = Stroke { colour: LINE, width: 1.6, dash: "3 2" };

/// Smallest and largest of some values.
fn span(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, 0.0], |[lo, hi], v| [lo.min(v), hi.max(v)])
}

/// What is on the page already, so that labels keep clear of it.
#[derive(Default)]
struct Taken(Vec<Rect>);

impl Taken {
    fn point(&mut self, [x, y]: [f64; 2]) {
        self.0.push([x - 4.0, y - 4.0, x + 4.0, y + 4.0]);
    }

    /// A line, as small boxes along it.
    fn line(&mut self, points: &[[f64; 2]]) {
        for w in points.windows(2) {
            let [[x1, y1], [x2, y2]] = [w[0], w[1]];
            let steps = ((x2 - x1).hypot(y2 - y1) / 3.0).ceil().max(1.0);
            for k in 0..=(steps as usize) {
                let t = k as f64 / steps;
                let (x, y) = (x1 + t * (x2 - x1), y1 + t * (y2 - y1));
                self.0.push([x - 1.0, y - 1.0, x + 1.0, y + 1.0]);
            }
        }
    }

    /// Writes a label near a point within `inside`; where it is crowded, further off and with a
    /// hairline to its point.
    fn label(&mut self, canvas: &mut Canvas, at: [f64; 2], text: &Text<'_>, inside: Rect) {
        let size = [text_width(text.content, text.size, text.bold), text.size];
        let far = (0..6).flat_map(|ring| {
            let [dx, dy] = [10.0 * f64::from(ring), 9.0 * f64::from(ring)];
            [[0.0, dy], [dx, dy], [-dx, dy], [0.0, -dy], [dx, -dy], [-dx, -dy]]
        });
        for [dx, dy] in far {
            let near = [at[0] + dx, at[1] + dy];
            let Some(r) = place_near(near, size, &self.0, inside) else { continue };
            self.0.push(r);
            if dx.abs() + dy.abs() > 0.0 {
                let end = [at[0].clamp(r[0], r[2]), at[1].clamp(r[1], r[3])];
                canvas.line(at, end, Stroke::solid(text.colour, 0.5));
            }
            let at = [r[0], r[1] + 0.78 * text.size];
            canvas.label(&Text { at, halo: true, ..text.clone() });
            return;
        }
    }
}

/// How the fast method is drawn where its counted area is meant.
const COUNTED: Style = Style { colour: INK2, width: 1.35, dash: "4 2", ..ring(DETERMINISTIC) };

const fn ring(colour: Colour) -> Style {
    Style { colour, width: 2.0, dash: "", marker: Marker::Ring, marker_offset: 0 }
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
///
/// # Errors
/// Whatever the writer reports.
pub fn write_tradeoff_area(table: &Table, out: &mut impl Write) -> io::Result<()> {
    const FRAME: Rect = [44.0, 12.0, COLUMN - RIGHT, 250.0];
    let all = ways(table.rows.iter());
    let shown: Vec<&Way<'_>> = all.iter().filter(|w| is_shown(w)).collect();
    let floor = median(table.rows.iter().filter_map(|r| Some(r.bar? / r.truth?))).unwrap_or(0.0);
    let times = span(shown.iter().map(|w| w.seconds));
    let errors = span(shown.iter().map(|w| w.error[1]).chain([floor]));
    let highest = shown.iter().map(|w| w.error[2]).fold(0.0, f64::max);
    let frame = Frame {
        x: PlotAxis::log([times[0] / 2.5, times[1] * 1.8], [FRAME[0], FRAME[2]]),
        y: PlotAxis::log([100.0 * errors[0] / 2.0, 150.0 * highest], [FRAME[3], FRAME[1]]),
        x_title: "Time per load".into(),
        y_title: "|Error| of the real area (%)".into(),
    };
    let mut canvas = Canvas::default();
    let mut taken = Taken::default();
    canvas.rect([FRAME[0], frame.y.at(100.0 * floor), FRAME[2], FRAME[3]], BAND, 1.0);
    draw_frame(&frame, &mut canvas);
    let inside = [FRAME[0] + 2.0, FRAME[1] - 6.0, COLUMN - 1.0, FRAME[3]];

    let note = format!("within the truth’s own ±{}: not ranked", percent(floor));
    let text =
        Text { colour: INK2, size: 9.0, ..Text::new([FRAME[0] + 4.0, FRAME[3] - 5.0], &note) };
    taken.0.push(text.bounds());
    canvas.label(&text);
    let setup = table.rows.iter().filter(|r| r.method == STATISTICS).map(|r| r.seconds);
    if let Some(seconds) = median(setup) {
        upright_mark(&mut canvas, &mut taken, &frame, seconds, "statistics of a map, once");
    }

    let height = |error: f64| frame.y.at((100.0 * error).max(frame.y.data[0]));
    // Bars of models with equal times side by side.
    let mut xs: Vec<f64> = shown.iter().map(|w| frame.x.at(w.seconds)).collect();
    let models: Vec<usize> = (0..shown.len()).filter(|&i| shown[i].area == AreaOf::Model).collect();
    let wanted: Vec<f64> = models.iter().map(|&i| xs[i]).collect();
    for (&i, x) in models.iter().zip(push_apart(&wanted, 7.0, [FRAME[0], FRAME[2]])) {
        xs[i] = x;
    }
    let place = |i: usize| [xs[i], height(shown[i].error[1])];

    let costs: Vec<[f64; 2]> = shown.iter().map(|w| [w.seconds, w.error[1]]).collect();
    let steps: Vec<[f64; 2]> = front(&costs, floor)
        .windows(2)
        .flat_map(|w| {
            let (a, b) = (place(w[0]), place(w[1]));
            [a, [b[0], a[1]], b]
        })
        .collect();
    canvas.polyline(&steps, FRONT);
    for kind in [AreaOf::Count, AreaOf::Corrected] {
        let line: Vec<[f64; 2]> =
            (0..shown.len()).filter(|&i| shown[i].area == kind).map(place).collect();
        let look = style_of(kind, "");
        canvas.polyline(&line, Stroke { colour: look.colour, width: 1.0, dash: look.dash });
        taken.line(&line);
    }
    for (i, way) in shown.iter().enumerate() {
        let look = style_of(way.area, &way.row.method);
        let [low, _, high] = way.error.map(height);
        canvas.line([xs[i], low], [xs[i], high], Stroke::solid(look.colour, 0.9));
        taken.0.push([xs[i] - 1.0, high.min(low), xs[i] + 1.0, low.max(high)]);
        canvas.marker(place(i), 3.4, look);
        taken.point(place(i));
    }
    for (kind, name, bold) in
        [(AreaOf::Count, "pixel count", false), (AreaOf::Corrected, "corrected", true)]
    {
        let Some(i) = (0..shown.len()).rev().find(|&i| shown[i].area == kind) else { continue };
        let [x, y] = place(i);
        let colour = style_of(kind, "").colour;
        let text = Text { colour, bold, ..Text::new([x + 7.0, y + 3.4], name) };
        taken.0.push(text.bounds());
        canvas.label(&text);
    }
    for (i, way) in shown.iter().enumerate() {
        let name = match way.area {
            AreaOf::Model => find(&way.row.method).map_or("", |m| m.card().label.as_ref()),
            AreaOf::Corrected => grid_name(way.row.scale.unwrap_or(1.0)),
            AreaOf::Count => continue,
        };
        let colour = style_of(way.area, &way.row.method).colour;
        let text = Text { colour, ..Text::new([0.0, 0.0], name) };
        taken.label(&mut canvas, place(i), &text, inside);
    }
    // The front is named where it runs level for longest.
    let level = |w: &&[[f64; 2]]| (w[1][0] - w[0][0]).abs();
    if let Some(w) = steps.windows(2).max_by(|a, b| level(a).total_cmp(&level(b))) {
        let middle = [f64::midpoint(w[0][0], w[1][0]), w[0][1]];
        let text = Text { colour: INK2, size: 9.0, ..Text::new([0.0, 0.0], "Pareto front") };
        taken.line(&[[w[0][0], w[0][1] - 2.0], [w[1][0], w[1][1] - 2.0]]);
        taken.label(&mut canvas, middle, &text, inside);
    }

    Figure {
        key: "tradeoff-area".into(),
        title: "Error of the real area against time".into(),
        description: format!(
            "Log-log plot of the median error of the area over {} cases against time per load: {}. \
             The truth's own half width is {}.",
            shown.iter().map(|w| w.cases).max().unwrap_or(0),
            listed(&shown),
            percent(floor)
        ),
        size: [COLUMN, 288.0],
        canvas,
    }
    .write_standalone(out)
}

/// Models, and the fast method in double precision at the default tolerance.
fn is_shown(way: &Way<'_>) -> bool {
    let TradeoffRow { method, precision, tolerance, .. } = way.row;
    let is_default = tolerance.is_some_and(|t| (t / TOLERANCE - 1.0).abs() < 1e-6);
    way.area == AreaOf::Model
        || (method == "chord" && precision.as_deref() == Some("f64") && is_default)
}

fn style_of(area: AreaOf, method: &str) -> Style {
    match area {
        AreaOf::Model => {
            find(method).map_or(DETERMINISTIC_STYLE, |m| plot_style(&m.card().name, 0))
        }
        AreaOf::Count => COUNTED,
        AreaOf::Corrected => DETERMINISTIC_STYLE,
    }
}

fn listed(shown: &[&Way<'_>]) -> String {
    let one = |w: &&Way<'_>| {
        let name = match (w.area, w.row.scale) {
            (AreaOf::Model, _) => {
                find(&w.row.method).map_or("", |m| m.card().label.as_ref()).to_owned()
            }
            (AreaOf::Count, s) => format!("{} counted", grid_name(s.unwrap_or(1.0))),
            (AreaOf::Corrected, s) => format!("{} corrected", grid_name(s.unwrap_or(1.0))),
        };
        format!("{name} {} in {}", percent(w.error[1]), duration(w.seconds))
    };
    shown.iter().map(one).collect::<Vec<_>>().join("; ")
}

fn draw_frame(frame: &Frame, canvas: &mut Canvas) {
    let xs: Vec<_> = frame.x.major().into_iter().map(|s| (s, time_tick(s))).collect();
    let ys: Vec<_> = frame.y.major().into_iter().map(|v| (v, frame.y.tick_text(v))).collect();
    frame.draw_with(canvas, &xs, &ys);
}

/// A dotted upright line at a time, with its name along it at the top.
fn upright_mark(canvas: &mut Canvas, taken: &mut Taken, frame: &Frame, seconds: f64, name: &str) {
    let (x, [bottom, top]) = (frame.x.at(seconds), frame.y.units);
    canvas.line([x, bottom], [x, top], Stroke { colour: LINE, width: 0.8, dash: "1 2" });
    let text = Text {
        colour: INK2,
        size: 9.0,
        anchor: Anchor::End,
        halo: true,
        ..Text::new([x - 3.0, top + 4.0], name)
    };
    taken.0.push(text.bounds());
    taken.0.push([x - 1.0, top, x + 1.0, bottom]);
    canvas.label(&text);
}

/// A method of the solver in a precision: how it is drawn, what it is called.
const SERIES: [(&str, &str, &str, Style); 6] = [
    ("chord", "f64", "chord", DETERMINISTIC_STYLE),
    ("chord", "f32", "chord f32", Style { dash: "3 2", width: 1.2, ..ring(DETERMINISTIC) }),
    ("polonsky-keer", "f64", "Polonsky–Keer", Style::model(INK2, "", Marker::Square, 0)),
    ("polonsky-keer", "f32", "f32", Style::model(INK2, "3 2", Marker::Diamond, 0)),
    ("stanley-kato", "f64", "Stanley–Kato", Style::model(WARN, "", Marker::TriangleUp, 0)),
    ("stanley-kato", "f32", "f32", Style::model(WARN, "3 2", Marker::TriangleDown, 0)),
];

/// The true relative rms error of the pressure against time, over the tolerance: each method of
/// the solver in each precision on the given grid, for one surface at one load.
///
/// # Errors
/// Whatever the writer reports.
pub fn write_tradeoff_pressure(table: &Table, out: &mut impl Write) -> io::Result<()> {
    const FRAME: Rect = [44.0, 12.0, COLUMN - RIGHT, 250.0];
    let full = |r: &&TradeoffRow| r.scale.is_some_and(|s| (s - 1.0).abs() < 1e-6);
    let rows: Vec<&TradeoffRow> =
        table.rows.iter().filter(full).filter(|r| r.pressure_error.is_some()).collect();
    let point = |r: &TradeoffRow| [r.seconds, r.pressure_error.unwrap_or(1.0).max(1e-13)];
    let pair = table.rows.iter().filter(full).find(|r| r.method == PAIR).map(|r| r.seconds);
    let times = span(rows.iter().map(|r| r.seconds).chain(pair));
    let errors = span(rows.iter().map(|r| point(r)[1]));
    let frame = Frame {
        x: PlotAxis::log([times[0] / 1.6, times[1] * 1.4], [FRAME[0], FRAME[2]]),
        y: PlotAxis::log([errors[0] / 5.0, 1.0], [FRAME[3], FRAME[1]]),
        x_title: "Time to the answer".into(),
        y_title: "Relative rms error of the pressure".into(),
    };
    let mut canvas = Canvas::default();
    let mut taken = Taken::default();
    draw_frame(&frame, &mut canvas);
    if let Some(seconds) = pair {
        let x = frame.x.at(seconds);
        canvas.line([x, FRAME[3]], [x, FRAME[1]], Stroke { colour: LINE, width: 0.8, dash: "1 2" });
        let text = Text {
            colour: INK2,
            size: 9.0,
            ..Text::new([x + 3.0, FRAME[3] - 5.0], "one FFT pair")
        };
        taken.0.push(text.bounds());
        canvas.label(&text);
    }
    let costs: Vec<[f64; 2]> = rows.iter().map(|r| point(r)).collect();
    let steps: Vec<[f64; 2]> = front(&costs, 0.0)
        .windows(2)
        .flat_map(|w| {
            let (a, b) = (frame.at(costs[w[0]]), frame.at(costs[w[1]]));
            [a, [b[0], a[1]], b]
        })
        .collect();
    canvas.polyline(&steps, FRONT);

    let mut drawn = Vec::new();
    for (method, precision, label, look) in SERIES {
        let series: Vec<&TradeoffRow> = rows
            .iter()
            .filter(|r| r.method == method && r.precision.as_deref() == Some(precision))
            .copied()
            .collect();
        let line: Vec<[f64; 2]> = series.iter().map(|r| frame.at(point(r))).collect();
        canvas.polyline(&line, Stroke { colour: look.colour, width: look.width, dash: look.dash });
        taken.line(&line);
        for &at in &line {
            canvas.marker(at, 3.2, look);
            taken.point(at);
        }
        drawn.push((series, line, label, look));
    }
    let inside = [FRAME[0] + 2.0, FRAME[1] - 6.0, COLUMN - 1.0, FRAME[3]];
    for (series, line, label, look) in &drawn {
        let (Some(row), Some(&at)) = (series.last(), line.last()) else { continue };
        let bold = *look == DETERMINISTIC_STYLE;
        let text = Text { colour: look.colour, bold, ..Text::new([0.0, 0.0], label) };
        let (true, Some(pairs)) = (row.is_capped, row.pairs) else {
            taken.label(&mut canvas, at, &text, inside);
            continue;
        };
        // Two lines right of where it was stopped.
        let note = format!("stopped at {pairs:.0}");
        for (content, size, down) in [(*label, 10.0, 3.4), (note.as_str(), 9.0, 13.4)] {
            let text = Text { at: [at[0] + 7.0, at[1] + down], content, size, ..text.clone() };
            taken.0.push(text.bounds());
            canvas.label(&text);
        }
    }
    Figure {
        key: "tradeoff-pressure".into(),
        title: "Error of the pressure against time".into(),
        description: drawn
            .iter()
            .filter_map(|(series, ..)| words(series))
            .collect::<Vec<_>>()
            .join("; ")
            + ".",
        size: [COLUMN, 288.0],
        canvas,
    }
    .write_standalone(out)
}

/// A series in words: its most accurate point.
fn words(series: &[&TradeoffRow]) -> Option<String> {
    let row = series.last()?;
    let exponent = row.pressure_error?.log10().ceil() as i32;
    Some(format!(
        "{} {} is below {} after {:.0} FFT pairs in {}",
        row.method,
        row.precision.as_deref()?,
        power_of_ten(exponent),
        row.pairs?,
        duration(row.seconds).replace(SPACE, " ")
    ))
}
