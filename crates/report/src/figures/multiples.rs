//! Small multiples: one panel per surface, axes shared, loads made comparable by p / (E* g).

use crate::draw::axes::{PlotAxis, PlotFrame};
use crate::draw::labels::{EndLabel, draw_end_labels};
use crate::draw::palette::{BAND, DETERMINISTIC, DETERMINISTIC_STYLE, INK, Stroke};
use crate::draw::svg::{Anchor, Canvas, Figure, Text};
use crate::figures::curves::log_limits;
use crate::lines::{LoadLines, ModelLine};
use crate::numbers::signed_range;
use contact_compare::SurfaceComparison;

const WIDTH: f64 = 700.0;
const PANEL: [f64; 2] = [176.0, 138.0];
const LEFT: f64 = 44.0;
const GAP: f64 = 22.0;
const PER_ROW: usize = 3;
/// Line height of the notes above a panel.
const NOTE: f64 = 11.5;

/// What the panels show.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PanelQuantity {
    /// Real area in per cent of nominal.
    Area,
    /// Signed error of the area in per cent.
    Error,
}

/// One panel's numbers.
struct Panel<'a> {
    name: String,
    /// p / (E* g).
    load: Vec<f64>,
    reference: Vec<Option<f64>>,
    models: Vec<(&'a ModelLine, Vec<Option<f64>>)>,
}

impl<'a> Panel<'a> {
    fn new(surface: &'a SurfaceComparison, lines: &'a LoadLines, quantity: PanelQuantity) -> Self {
        let scale = surface.inputs.modulus.pascals() * surface.inputs.rms_gradient();
        let scale = if scale > 0.0 { scale } else { surface.inputs.modulus.pascals() };
        let percent =
            |values: &[Option<f64>]| values.iter().map(|v| v.map(|v| 100.0 * v)).collect();
        let of_model = |m: &ModelLine| match quantity {
            PanelQuantity::Error => percent(&lines.errors(m)),
            PanelQuantity::Area => percent(&m.area),
        };
        let reference = match quantity {
            PanelQuantity::Error => lines.area.iter().map(|a| a.map(|_| 0.0)).collect(),
            PanelQuantity::Area => percent(&lines.area),
        };
        Self {
            name: lines.named(surface),
            load: lines.pressures.iter().map(|p| p / scale).collect(),
            reference,
            models: lines.models.iter().map(|m| (m, of_model(m))).collect(),
        }
    }

    /// Models that leave the axis, with what to say about them.
    fn outside(&self, [lo, hi]: [f64; 2], quantity: PanelQuantity) -> Vec<(&ModelLine, String)> {
        let off = |v: f64| v < lo || v > hi * (1.0 + 1e-9) && hi > 0.0;
        self.models
            .iter()
            .filter_map(|(model, values)| {
                let present: Vec<f64> = values.iter().flatten().copied().collect();
                let first = *present.iter().find(|v| off(**v))?;
                let sign = if first > hi { '▲' } else { '▼' };
                let text = if quantity == PanelQuantity::Error {
                    let low = present.iter().copied().fold(f64::INFINITY, f64::min);
                    let high = present.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                    format!("{sign} {} {}", model.label, signed_range(low / 100.0, high / 100.0))
                } else {
                    let inside = present.iter().any(|v| !off(*v));
                    format!(
                        "{sign} {} {}off scale",
                        model.label,
                        if inside { "in part " } else { "" }
                    )
                };
                Some((*model, text))
            })
            .collect()
    }
}

/// The panels of one quantity for every surface.
pub(crate) fn figure(
    surfaces: &[SurfaceComparison],
    quantity: PanelQuantity,
    title: &str,
    description: String,
    key: &str,
) -> Figure {
    let lines: Vec<(&SurfaceComparison, LoadLines)> = surfaces
        .iter()
        .flat_map(|s| LoadLines::panels(s).into_iter().map(move |l| (s, l)))
        .collect();
    let panels: Vec<Panel<'_>> = lines.iter().map(|(s, l)| Panel::new(s, l, quantity)).collect();
    let loads = || panels.iter().flat_map(|p| p.load.iter().copied());
    let (mut x_lo, mut x_hi) = (loads().fold(f64::INFINITY, f64::min), loads().fold(0.0, f64::max));
    if x_hi <= x_lo {
        (x_lo, x_hi) = (x_hi / 3.0, x_hi * 3.0);
    }
    let limits = if quantity == PanelQuantity::Error {
        error_limits(&panels)
    } else {
        shared_log_limits(&panels)
    };
    let notes: Vec<_> = panels.iter().map(|p| p.outside(limits, quantity)).collect();
    let most = notes.iter().map(Vec::len).max().unwrap_or(0);
    let head = 22.0 + NOTE * most as f64;
    let row_height = head + PANEL[1] + 22.0;
    let mut canvas = Canvas::default();
    for (i, (panel, notes)) in panels.iter().zip(&notes).enumerate() {
        let left = LEFT + (i % PER_ROW) as f64 * (PANEL[0] + GAP);
        let top = (i / PER_ROW) as f64 * row_height + head;
        let y_units = [top + PANEL[1], top];
        let frame = PlotFrame {
            x: PlotAxis::log([x_lo, x_hi], [left, left + PANEL[0]]),
            y: if quantity == PanelQuantity::Error {
                PlotAxis::linear(limits, y_units)
            } else {
                PlotAxis::log(limits, y_units)
            },
            x_title: String::new(),
            y_title: if i % PER_ROW == 0 { axis_title(quantity).into() } else { String::new() },
        };
        let name = shortened(&panel.name, 30);
        canvas.text(&Text { bold: true, ..Text::new([left, top - head + 11.0], &name) });
        for (row, (model, text)) in notes.iter().enumerate() {
            let at = [left, top - head + 22.5 + NOTE * row as f64];
            let note = Text { colour: model.look.colour, size: 9.0, ..Text::new(at, text) };
            canvas.series(&model.name, |canvas| canvas.label(&note));
        }
        let ends = draw_panel(
            &mut canvas,
            panel,
            &frame,
            quantity,
            &format!("{key}-c{i}"),
            i % PER_ROW == 0,
        );
        if i % PER_ROW == PER_ROW - 1 || i + 1 == panels.len() {
            draw_end_labels(&mut canvas, left + PANEL[0], [top, top + PANEL[1]], &ends);
        }
    }
    let height = panels.len().div_ceil(PER_ROW).max(1) as f64 * row_height + 12.0;
    let across = panels.len().clamp(1, PER_ROW) as f64;
    canvas.text(&Text {
        colour: INK,
        anchor: Anchor::Middle,
        ..Text::new(
            [LEFT + (across * (PANEL[0] + GAP) - GAP) / 2.0, height - 2.0],
            "Nominal pressure / (E* · rms gradient)",
        )
    });
    canvas.figure(key, title, description, [WIDTH, height])
}

fn axis_title(quantity: PanelQuantity) -> &'static str {
    match quantity {
        PanelQuantity::Area => "Real area (% of nominal)",
        PanelQuantity::Error => "Error in area (%)",
    }
}

/// Errors within ±80 % set the axis; the rest is named above its panel.
fn error_limits(panels: &[Panel<'_>]) -> [f64; 2] {
    let (mut lo, mut hi) = (-15.0_f64, 15.0_f64);
    let errors = panels.iter().flat_map(|p| &p.models).flat_map(|(_, v)| v.iter().flatten());
    for e in errors.filter(|e| e.abs() <= 80.0) {
        lo = lo.min(*e);
        hi = hi.max(*e);
    }
    [1.05 * lo, 1.05 * hi]
}

/// One logarithmic axis for all panels.
fn shared_log_limits(panels: &[Panel<'_>]) -> [f64; 2] {
    let reference: Vec<Option<f64>> =
        panels.iter().flat_map(|p| p.reference.iter().copied()).collect();
    let most = panels.iter().map(|p| p.models.len()).max().unwrap_or(0);
    let models: Vec<Vec<Option<f64>>> = (0..most)
        .map(|k| {
            let values = |p: &Panel<'_>| {
                p.models.get(k).map_or_else(|| vec![None; p.load.len()], |(_, v)| v.clone())
            };
            panels.iter().flat_map(values).collect()
        })
        .collect();
    log_limits(&reference, &models, 100.0)
}

fn draw_panel(
    canvas: &mut Canvas,
    panel: &Panel<'_>,
    frame: &PlotFrame,
    quantity: PanelQuantity,
    clip: &str,
    numbered: bool,
) -> Vec<EndLabel> {
    let ([left, right], [bottom, top]) = (frame.x.units, frame.y.units);
    if quantity == PanelQuantity::Error {
        canvas.rect([left, frame.y.at(10.0), right, frame.y.at(-10.0)], BAND, 1.0);
    }
    let y_text = |v: f64| {
        let sign = if quantity == PanelQuantity::Error && v > 0.0 { "+" } else { "" };
        if numbered { format!("{sign}{}", frame.y.tick_text(v)) } else { String::new() }
    };
    frame.draw_with(canvas, &frame.x.ticks(), &frame.y.ticks_as(y_text));
    let points = |values: &[Option<f64>]| -> Vec<[f64; 2]> {
        values
            .iter()
            .zip(&panel.load)
            .filter_map(|(v, x)| {
                Some(frame.at([*x, v.filter(|v| quantity == PanelQuantity::Error || *v > 0.0)?]))
            })
            .collect()
    };
    let mut ends = Vec::new();
    let reference = points(&panel.reference);
    canvas.clipped(clip, [left - 3.0, top, right + 3.0, bottom + 3.0], |canvas| {
        for (model, values) in &panel.models {
            let look = model.look;
            let line = points(values);
            canvas.series(&model.name, |canvas| {
                canvas.polyline(&line, look.stroke());
                for point in line.iter().skip(look.marker_offset).step_by(4) {
                    canvas.marker(*point, 2.3, look);
                }
            });
            let last = values.iter().flatten().last().filter(|v| frame.y.holds(**v));
            ends.extend(last.map(|last| EndLabel::of_model(frame.y.at(*last), model)));
        }
        canvas.polyline(&reference, Stroke::solid(DETERMINISTIC, 1.6));
        if quantity != PanelQuantity::Error {
            for point in &reference {
                canvas.marker(*point, 2.0, DETERMINISTIC_STYLE);
            }
        }
    });
    ends.extend(reference.last().map(|[_, y]| EndLabel::deterministic(*y)));
    ends
}

/// The name, or its beginning with an ellipsis.
fn shortened(name: &str, most: usize) -> String {
    if name.chars().count() <= most {
        name.into()
    } else {
        name.chars().take(most - 1).chain(['…']).collect()
    }
}
