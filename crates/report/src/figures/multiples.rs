//! Small multiples: one panel per surface, axes shared, loads made comparable by p / (E* g).

use crate::draw::axes::{PlotAxis, PlotFrame};
use crate::draw::labels::{EndLabel, draw_end_labels};
use crate::draw::palette::{BAND, DETERMINISTIC, DETERMINISTIC_STYLE, INK, Stroke};
use crate::draw::svg::{Canvas, Figure, Text};
use crate::figures::curves::log_limits;
use crate::lines::{LoadLine, LoadLines, load_ends, min_max};
use crate::numbers::signed_range;
use contact_compare::SurfaceComparison;

const WIDTH: f64 = 700.0;
const PANEL: [f64; 2] = [176.0, 138.0];
const LEFT: f64 = 44.0;
const GAP: f64 = 22.0;
const PER_ROW: usize = 3;
/// Line height of the notes above a panel.
const NOTE: f64 = 11.5;

/// One panel's numbers, in per cent: areas, or their signed errors.
struct Panel<'a> {
    name: String,
    /// p / (E* g).
    load: Vec<f64>,
    reference: Vec<Option<f64>>,
    models: Vec<(&'a LoadLine, Vec<Option<f64>>)>,
}

impl<'a> Panel<'a> {
    fn new(surface: &'a SurfaceComparison, lines: &'a LoadLines, of_errors: bool) -> Self {
        let scale = surface.inputs.modulus.pascals() * surface.inputs.rms_gradient();
        let scale = if scale > 0.0 { scale } else { surface.inputs.modulus.pascals() };
        let percent =
            |values: &[Option<f64>]| values.iter().map(|v| v.map(|v| 100.0 * v)).collect();
        let of_model = |m: &'a LoadLine| {
            (m, if of_errors { percent(&lines.errors(m)) } else { percent(&m.values) })
        };
        let zero = || lines.area.iter().map(|a| a.map(|_| 0.0)).collect();
        Self {
            name: surface.name.clone() + &lines.whose(),
            load: lines.pressures.iter().map(|p| p / scale).collect(),
            reference: if of_errors { zero() } else { percent(&lines.area) },
            models: lines.models.iter().map(of_model).collect(),
        }
    }

    /// Models that leave the axis, with what to say about them.
    fn outside(&self, [lo, hi]: [f64; 2], of_errors: bool) -> Vec<(&LoadLine, String)> {
        let off = |v: &f64| *v < lo || *v > hi * (1.0 + 1e-9) && hi > 0.0;
        let note = |(model, values): &(&'a LoadLine, Vec<Option<f64>>)| {
            let present: Vec<f64> = values.iter().flatten().copied().collect();
            let sign = if *present.iter().find(|v| off(v))? > hi { '▲' } else { '▼' };
            let (low, high) = min_max(present.iter().copied())?;
            let part = if present.iter().all(off) { "" } else { "in part " };
            let said = if of_errors {
                signed_range(low / 100.0, high / 100.0)
            } else {
                format!("{part}off scale")
            };
            Some((*model, format!("{sign} {} {said}", model.label)))
        };
        self.models.iter().filter_map(note).collect()
    }
}

pub(crate) fn figure(
    surfaces: &[SurfaceComparison],
    of_errors: bool,
    title: &str,
    description: String,
) -> Figure {
    let with_lines = |s| LoadLines::panels(s).into_iter().map(move |l| (s, l));
    let lines: Vec<(&SurfaceComparison, LoadLines)> =
        surfaces.iter().flat_map(with_lines).collect();
    let panels: Vec<Panel<'_>> = lines.iter().map(|(s, l)| Panel::new(s, l, of_errors)).collect();
    let loads = panels.iter().flat_map(|p| p.load.iter().copied());
    let (first, last) = min_max(loads).unwrap_or((f64::INFINITY, 0.0));
    let x_data = load_ends(first, last);
    let limits = if of_errors { error_limits(&panels) } else { shared_log_limits(&panels) };
    let notes: Vec<_> = panels.iter().map(|p| p.outside(limits, of_errors)).collect();
    let most = notes.iter().map(Vec::len).max().unwrap_or(0);
    let head = 22.0 + NOTE * most as f64;
    let row_height = head + PANEL[1] + 22.0;
    let axis = if of_errors { PlotAxis::linear } else { PlotAxis::log };
    let y_title = if of_errors { "Error in area (%)" } else { "Real area (% of nominal)" };
    let mut canvas = Canvas::default();
    for (i, (panel, notes)) in panels.iter().zip(&notes).enumerate() {
        let is_first = i % PER_ROW == 0;
        let left = LEFT + (i % PER_ROW) as f64 * (PANEL[0] + GAP);
        let top = (i / PER_ROW) as f64 * row_height + head;
        let inside = [left, top, left + PANEL[0], top + PANEL[1]];
        let titles = ["", if is_first { y_title } else { "" }];
        let frame = PlotFrame::new(inside, [PlotAxis::log(x_data), axis(limits)], titles);
        let name = shortened(&panel.name);
        canvas.text(&Text::start([left, top - head + 11.0], &name, INK).bold());
        for (row, (model, text)) in notes.iter().enumerate() {
            let at = [left, top - head + 22.5 + NOTE * row as f64];
            let note = Text::start(at, text, model.look.colour).small();
            canvas.series(&model.name, |canvas| canvas.label(&note));
        }
        let clip = format!("c{i}");
        let ends = draw_panel(&mut canvas, panel, &frame, &clip);
        if i % PER_ROW == PER_ROW - 1 || i + 1 == panels.len() {
            draw_end_labels(&mut canvas, &frame, 0.0, &ends);
        }
    }
    let height = panels.len().div_ceil(PER_ROW).max(1) as f64 * row_height + 12.0;
    let across = panels.len().clamp(1, PER_ROW) as f64;
    let at = [LEFT + (across * (PANEL[0] + GAP) - GAP) / 2.0, height - 2.0];
    canvas.text(&Text::middle(at, "Nominal pressure / (E* · rms gradient)", INK));
    canvas.figure(title, description, [WIDTH, height])
}

/// Errors within ±80 % set the axis; the rest is named above its panel.
fn error_limits(panels: &[Panel<'_>]) -> [f64; 2] {
    let errors = panels.iter().flat_map(|p| &p.models).flat_map(|(_, v)| v.iter().flatten());
    let inside = errors.filter(|e| e.abs() <= 80.0);
    let [lo, hi] = inside.fold([-15.0_f64, 15.0_f64], |[lo, hi], e| [lo.min(*e), hi.max(*e)]);
    [1.05 * lo, 1.05 * hi]
}

fn shared_log_limits(panels: &[Panel<'_>]) -> [f64; 2] {
    let reference = panels.iter().flat_map(|p| p.reference.iter().flatten());
    let beside = |p| {
        let Panel { models, reference, .. }: &Panel<'_> = p;
        models.iter().flat_map(move |(_, values)| values.iter().zip(reference))
    };
    log_limits(reference, panels.iter().flat_map(beside), 100.0)
}

/// Its vertical axis has numbers if it has a title.
fn draw_panel(
    canvas: &mut Canvas,
    panel: &Panel<'_>,
    frame: &PlotFrame,
    clip: &str,
) -> Vec<EndLabel> {
    let (of_errors, numbered) = (!frame.y.is_log, !frame.y_title.is_empty());
    let ([left, right], [bottom, top]) = (frame.x.units, frame.y.units);
    if of_errors {
        canvas.rect([left, frame.y.at(10.0), right, frame.y.at(-10.0)], BAND, 1.0);
    }
    let y_text = |v: f64| {
        let sign = if of_errors && v > 0.0 { "+" } else { "" };
        if numbered { format!("{sign}{}", frame.y.tick_text(v)) } else { String::new() }
    };
    frame.draw_with(canvas, &frame.x.ticks(), &frame.y.ticks_as(y_text));
    let points = |values: &[Option<f64>]| -> Vec<[f64; 2]> {
        let drawn = |v: &Option<f64>| v.filter(|v| of_errors || *v > 0.0);
        let each = values.iter().zip(&panel.load);
        each.filter_map(|(v, x)| Some(frame.at([*x, drawn(v)?]))).collect()
    };
    let mut ends = Vec::new();
    let reference = points(&panel.reference);
    canvas.clipped(clip, [left - 3.0, top, right + 3.0, bottom + 3.0], |canvas| {
        for (model, values) in &panel.models {
            let (look, line) = (model.look, points(values));
            canvas.series(&model.name, |canvas| {
                canvas.polyline(&line, look.stroke());
                for point in line.iter().skip(look.marker_offset).step_by(4) {
                    canvas.marker(*point, 2.3, look);
                }
            });
            let last = values.iter().flatten().last().filter(|v| frame.y.holds(**v));
            ends.extend(last.map(|last| EndLabel::of(frame.y.at(*last), model)));
        }
        canvas.polyline(&reference, Stroke::solid(DETERMINISTIC, 1.6));
        for point in reference.iter().filter(|_| !of_errors) {
            canvas.marker(*point, 2.0, DETERMINISTIC_STYLE);
        }
    });
    ends.extend(reference.last().map(|[_, y]| EndLabel::deterministic(*y)));
    ends
}

fn shortened(name: &str) -> String {
    let is_long = name.chars().count() > 30;
    if is_long { name.chars().take(29).chain(['…']).collect() } else { name.into() }
}
