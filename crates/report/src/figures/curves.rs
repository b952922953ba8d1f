//! The figures over the load: real area, real pressure, error of each closed form.

use crate::draw::axes::{AxisScale, PlotAxis, PlotFrame};
use crate::draw::labels::{EndLabel, ROOM, draw_end_labels};
use crate::draw::palette::{BAND, DETERMINISTIC, DETERMINISTIC_STYLE, INK2, Stroke};
use crate::draw::svg::{COLUMN, Canvas, Figure, Text, num};
use crate::lines::{LoadLines, ModelLine, compared, min_max, range_words};
use crate::messages::load;
use crate::numbers::{PASCALS, Unit, counted, signed_range, unit_for};

/// Plot box: left and right edge in units.
const LEFT: f64 = 44.0;
const RIGHT: f64 = COLUMN - ROOM;
const TOP: f64 = 12.0;
/// Height of a figure, whatever notes it carries, so that neighbours stay level.
const HEIGHT: f64 = 262.0;
const BOTTOM_MARGIN: f64 = 36.0;
/// Height of one line of notes above the frame.
const NOTE: f64 = 12.0;

/// Whether a figure carries the movable load line of the report.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Use {
    /// In the report.
    Page,
    /// As a file of its own.
    File,
}

/// Fig. 1 of the source paper: real contact area over nominal pressure, both logarithmic.
pub(crate) fn area(lines: &LoadLines, key: &str, usage: Use) -> Figure {
    let percent = |a: f64| 100.0 * a;
    let reference: Vec<_> = lines.area.iter().map(|a| a.map(percent)).collect();
    let band: Vec<_> = lines.interval.iter().map(|i| i.map(|i| i.map(percent))).collect();
    let models: Vec<_> =
        lines.models.iter().map(|m| m.area.iter().map(|a| a.map(percent)).collect()).collect();
    let description = format!(
        "Log-log plot over {}. Deterministic area: {}. {}",
        counted(lines.pressures.len(), "load"),
        range_words(&reference, " %"),
        compared(lines)
    );
    let title = "Real contact area over the load";
    let y_title = "Real contact area (% of nominal)".into();
    let y = log_axis(&reference, &band, &models, 100.0);
    let notes = load_notes(lines, &models, y.data);
    Plot { lines, reference, band, models, y, notes, cells: 'a', title, y_title, description }
        .draw(key, usage)
}

/// Fig. 2 of the source paper: mean real pressure over nominal pressure, both logarithmic.
pub(crate) fn pressure(lines: &LoadLines, key: &str, usage: Use) -> Figure {
    let real = |p: f64, a: f64| (a > 0.0).then(|| p / a);
    let over = |areas: &[Option<f64>]| -> Vec<Option<f64>> {
        lines.pressures.iter().zip(areas).map(|(&p, a)| real(p, (*a)?)).collect()
    };
    let reference = over(&lines.area);
    let typical = middle(&reference).unwrap_or(lines.pressures[0]);
    let unit = unit_for(typical, PASCALS);
    let scaled = |values: Vec<Option<f64>>| -> Vec<Option<f64>> {
        values.into_iter().map(|v| v.map(|v| v / unit.scale)).collect()
    };
    let between = |(&p, i): (&f64, &Option<[f64; 2]>)| {
        let [lo, hi] = (*i)?;
        (lo > 0.0).then(|| [p / hi / unit.scale, p / lo / unit.scale])
    };
    let band: Vec<_> = lines.pressures.iter().zip(&lines.interval).map(between).collect();
    let reference = scaled(reference);
    let description = format!(
        "Log-log plot. Deterministic mean real pressure: {} while load rises {:.0} times.",
        range_words(&reference, &format!(" {}", unit.name)),
        lines.pressures[lines.pressures.len() - 1] / lines.pressures[0]
    );
    let models: Vec<_> = lines.models.iter().map(|m| scaled(over(&m.area))).collect();
    let title = "Mean real pressure over the load";
    let y_title = format!("Mean real pressure ({})", unit.name);
    let y = log_axis(&reference, &band, &models, f64::INFINITY);
    let notes = load_notes(lines, &models, y.data);
    Plot { lines, reference, band, models, y, notes, cells: 'p', title, y_title, description }
        .draw(key, usage)
}

/// A plot over the loads of one quantity of the reference and of every model; of errors, on a linear axis, the
/// reference is the line at 0.
struct Plot<'a> {
    lines: &'a LoadLines,
    /// Empty of errors.
    reference: Vec<Option<f64>>,
    band: Vec<Option<[f64; 2]>>,
    models: Vec<Vec<Option<f64>>>,
    /// Its data alone.
    y: PlotAxis,
    /// Models that leave the axis, with what is said of them above the frame.
    notes: Vec<(&'a ModelLine, String)>,
    /// Letter of what the slider lists.
    cells: char,
    title: &'a str,
    y_title: String,
    description: String,
}

impl Plot<'_> {
    fn draw(self, key: &str, usage: Use) -> Figure {
        let lines = self.lines;
        let is_error = self.y.spacing == AxisScale::Linear;
        let (unit, x_title) = lines.load_axis();
        let [lo, hi] = self.y.data;
        let notes = NOTE * self.notes.len() as f64;
        let top = TOP + if is_error || self.notes.is_empty() { notes } else { notes - 2.0 };
        let bottom = HEIGHT - BOTTOM_MARGIN;
        let frame = PlotFrame {
            x: x_axis(lines, unit),
            y: PlotAxis { units: [bottom, top], ..self.y },
            x_title,
            y_title: self.y_title,
        };
        let mut canvas = Canvas::default();
        let tolerance = [LEFT, frame.y.at(10.0), RIGHT, frame.y.at(-10.0)];
        if is_error {
            canvas.rect(tolerance, BAND, 1.0);
        }
        let sign = |v: f64| if is_error && v > 0.0 { "+" } else { "" };
        let y_ticks = frame.y.ticks_as(|v| format!("{}{}", sign(v), frame.y.tick_text(v)));
        frame.draw_with(&mut canvas, &frame.x.ticks(), &y_ticks);
        for (row, (model, note)) in self.notes.iter().enumerate() {
            let at = [LEFT + 4.0, 10.0 + NOTE * row as f64];
            let text = Text { colour: model.look.colour, size: 9.0, ..Text::new(at, note) };
            canvas.series(&model.name, |canvas| canvas.label(&text));
        }
        if usage == Use::Page {
            cursor(&mut canvas, lines, &frame, self.cells);
        }
        let x = |i: usize| lines.pressures[i] / unit.scale;
        let mut ends = Vec::new();
        // A little wider than the frame, for markers on its edge.
        let clip = [LEFT - 4.0, top - 4.0, RIGHT + 4.0, bottom];
        canvas.clipped(&format!("{key}-c"), clip, |canvas| {
            let band: Vec<_> =
                self.band.iter().map(|b| b.map(|b| b.map(|v| v.clamp(lo, hi)))).collect();
            draw_band(canvas, &frame, &x, &band, if is_error { 0.28 } else { 0.16 });
            if is_error {
                let zero = [LEFT, RIGHT].map(|x| [x, frame.y.at(0.0)]);
                canvas.line(zero[0], zero[1], Stroke::solid(DETERMINISTIC, 1.6));
                ends.push(EndLabel::deterministic(frame.y.at(0.0)));
            }
            for (model, values) in lines.models.iter().zip(&self.models) {
                let end = draw_model(canvas, &frame, &x, values, model);
                if let Some(y) = end.filter(|y| !is_error || (lo..=hi).contains(y)) {
                    ends.push(EndLabel::of_model(frame.y.at(y).clamp(top, bottom), model));
                }
            }
            let end = draw_reference(canvas, &frame, &x, &self.reference);
            let end = end.map(|y| EndLabel::deterministic(frame.y.at(y).clamp(top, bottom)));
            ends.extend(end);
        });
        // A band too narrow for its name is named in the caption alone.
        if is_error && tolerance[3] - tolerance[1] > 26.0 {
            canvas.text(&Text {
                colour: INK2,
                size: 9.0,
                halo: true,
                ..Text::new([LEFT + 4.0, tolerance[1] + 9.5], "within 10\u{202F}%")
            });
        }
        draw_end_labels(&mut canvas, RIGHT, [top + 2.0, bottom - 2.0], &ends);
        canvas.figure(key, self.title, self.description, [COLUMN, HEIGHT])
    }
}

/// A logarithmic axis for the reference with its band, and models.
fn log_axis(
    reference: &[Option<f64>],
    band: &[Option<[f64; 2]>],
    models: &[Vec<Option<f64>>],
    ceiling: f64,
) -> PlotAxis {
    let band = band.iter().flatten().flatten().map(|v| Some(*v));
    let reference: Vec<Option<f64>> = reference.iter().copied().chain(band).collect();
    PlotAxis::log(log_limits(&reference, models, ceiling), [0.0, 1.0])
}

/// "▲ MB off scale from 400 MPa" of each model that leaves the axis.
fn load_notes<'a>(
    lines: &'a LoadLines,
    models: &[Vec<Option<f64>>],
    [lo, hi]: [f64; 2],
) -> Vec<(&'a ModelLine, String)> {
    let note = |(model, values): (&'a ModelLine, &Vec<Option<f64>>)| {
        let off = |i: &usize| values[*i].is_some_and(|v| v < lo || v > hi * (1.0 + 1e-9));
        let loads: Vec<usize> = (0..lines.pressures.len()).filter(off).collect();
        let (&first, &last) = (loads.first()?, loads.last()?);
        let at = |i: usize| load(lines.pressures[i], lines.load_area);
        let whole = loads.len() == lines.pressures.len();
        let range = match (first, last + 1 == lines.pressures.len()) {
            _ if whole => "at every load".into(),
            (0, _) => format!("up to {}", at(last)),
            (_, true) => format!("from {}", at(first)),
            _ => format!("between {} and {}", at(first), at(last)),
        };
        let sign = if values[first].is_some_and(|v| v > hi) { '▲' } else { '▼' };
        Some((model, format!("{sign} {} off scale {range}", model.label)))
    };
    lines.models.iter().zip(models).filter_map(note).collect()
}

/// Limits of a logarithmic axis: all of the reference, and every model value within a factor of
/// 12 of it; one bad model does not flatten the rest. `models` align with `reference`.
pub(crate) fn log_limits(
    reference: &[Option<f64>],
    models: &[Vec<Option<f64>>],
    ceiling: f64,
) -> [f64; 2] {
    let mut lo = f64::INFINITY;
    let mut hi = 0.0_f64;
    let mut take = |v: f64| {
        if v > 0.0 && v.is_finite() {
            lo = lo.min(v);
            hi = hi.max(v);
        }
    };
    reference.iter().flatten().for_each(|v| take(*v));
    let has_reference = reference.iter().flatten().any(|v| *v > 0.0);
    for (v, r) in models.iter().flat_map(|values| values.iter().zip(reference)) {
        match (v, r) {
            (Some(v), Some(r)) if *r > 0.0 && (1.0 / 12.0..12.0).contains(&(v / r)) => take(*v),
            (Some(v), _) if !has_reference => take(*v),
            _ => {}
        }
    }
    if hi <= 0.0 {
        return [0.1, 1.0];
    }
    let room = (hi / lo).powf(0.04).max(1.1);
    [lo / room, (hi * room).min(ceiling).max(1.01 * lo)]
}

/// Error (%) that the axis of errors never exceeds: what lies beyond is named above the frame.
const MOST_ERROR: f64 = 150.0;

/// Fig. 3: signed error of the area of each closed form against the deterministic solution.
pub(crate) fn error(lines: &LoadLines, key: &str) -> Figure {
    let errors: Vec<Vec<Option<f64>>> = lines
        .models
        .iter()
        .map(|m| lines.errors(m).into_iter().map(|e| e.map(|e| 100.0 * e)).collect())
        .collect();
    let worst = |e: &[Option<f64>]| e.iter().flatten().fold(0.0_f64, |w, e| w.max(e.abs()));
    // The axis holds every model that stays within 60 %; if none does, the best of them and
    // those that are little worse.
    let mut worsts: Vec<f64> = errors.iter().map(|e| worst(e)).filter(|w| *w > 0.0).collect();
    worsts.sort_by(f64::total_cmp);
    let limit = worsts
        .iter()
        .rfind(|w| **w <= 60.0)
        .copied()
        .or(worsts.first().map(|best| 1.3 * best))
        .unwrap_or(15.0)
        .max(15.0);
    let held = |e: &&Vec<Option<f64>>| worst(e) <= limit;
    let extent = |sign: f64| {
        errors
            .iter()
            .filter(held)
            .flat_map(|e| e.iter().flatten())
            .fold(12.0_f64, |w, e| w.max((sign * e).min(MOST_ERROR)))
    };
    let (lo, hi) = (-1.06 * extent(-1.0), 1.06 * extent(1.0));
    // "▲ Stacked off scale: +141 to +434 %".
    let note = |(model, errors): (&'_ ModelLine, &Vec<Option<f64>>)| {
        errors.iter().flatten().find(|e| **e < lo || **e > hi)?;
        let errors: Vec<f64> = lines.errors(model).into_iter().flatten().collect();
        let (low, high) = min_max(&errors)?;
        let sign = if high + low > 0.0 { '▲' } else { '▼' };
        Some(format!("{sign} {} off scale: {}", model.label, signed_range(low, high)))
    };
    let each = lines.models.iter().zip(&errors);
    let notes = each.filter_map(|of| Some((of.0, note(of)?))).collect();
    let between = |(i, a): (&Option<[f64; 2]>, &Option<f64>)| {
        Some((*i)?.map(|v| 100.0 * (v / a.unwrap_or(v) - 1.0)))
    };
    let band = lines.interval.iter().zip(&lines.area).map(between).collect();
    Plot {
        lines,
        reference: Vec::new(),
        band,
        models: errors,
        y: PlotAxis::linear([lo, hi], [0.0, 1.0]),
        notes,
        cells: 'e',
        title: "Signed error of each closed form against load",
        y_title: "Error in area (%)".into(),
        description: format!(
            "Per cent error of the area relative to the deterministic solution of the same map. {}",
            compared(lines)
        ),
    }
    .draw(key, Use::Page)
}

/// The dotted line at the load read off; the report's script moves it, and lists beside it what `cells` of
/// the slider's data begin with the letter of the figure.
fn cursor(canvas: &mut Canvas, lines: &LoadLines, frame: &PlotFrame, cells: char) {
    let (unit, _) = lines.load_axis();
    let places: Vec<String> =
        lines.pressures.iter().map(|p| num(frame.x.at(p / unit.scale))).collect();
    canvas.raw(&format!(
        "<g class=\"cur\" data-v=\"{cells}\" data-of=\"{}\" data-x=\"{}\" transform=\"translate({} 0)\">",
        lines.of,
        places.join(" "),
        places[lines.headline]
    ));
    let [bottom, top] = frame.y.units;
    let stroke = Stroke { colour: INK2, width: 0.8, dash: "1.5 1.5" };
    canvas.line([0.0, top], [0.0, bottom], stroke);
    canvas.raw("</g>");
}

/// Draws a band between low and high values, in pieces where values are missing.
fn draw_band(
    canvas: &mut Canvas,
    frame: &PlotFrame,
    x: &impl Fn(usize) -> f64,
    band: &[Option<[f64; 2]>],
    opacity: f64,
) {
    for run in runs(band) {
        let edge = |side: usize| {
            run.iter().map(move |(i, b)| (i, b[side])).map(|(i, v)| frame.at([x(*i), v]))
        };
        let outline: Vec<[f64; 2]> = edge(0).chain(edge(1).rev()).collect();
        canvas.area(&outline, DETERMINISTIC, opacity);
    }
}

/// Draws a model's line and markers; answers with its value at the last load it has.
fn draw_model(
    canvas: &mut Canvas,
    frame: &PlotFrame,
    x: &impl Fn(usize) -> f64,
    values: &[Option<f64>],
    model: &ModelLine,
) -> Option<f64> {
    let look = model.look;
    let present: Vec<(usize, f64)> =
        values.iter().enumerate().filter_map(|(i, v)| Some((i, (*v)?))).collect();
    canvas.series(&model.name, |canvas| {
        for run in runs(values) {
            let points: Vec<[f64; 2]> = run.iter().map(|(i, v)| frame.at([x(*i), *v])).collect();
            canvas.polyline(&points, look.stroke());
        }
        for &(i, v) in &present {
            if (i % 4 == look.marker_offset || present.len() < 3) && frame.y.holds(v) {
                canvas.marker(frame.at([x(i), v]), 2.6, look);
            }
        }
    });
    present.last().map(|(_, v)| *v)
}

/// Draws the deterministic line with a dot at every load; answers with its last value.
fn draw_reference(
    canvas: &mut Canvas,
    frame: &PlotFrame,
    x: &impl Fn(usize) -> f64,
    values: &[Option<f64>],
) -> Option<f64> {
    let positive: Vec<Option<f64>> = values.iter().map(|v| v.filter(|v| *v > 0.0)).collect();
    for run in runs(&positive) {
        let points: Vec<[f64; 2]> = run.iter().map(|(i, v)| frame.at([x(*i), *v])).collect();
        canvas.polyline(&points, DETERMINISTIC_STYLE.stroke());
        for point in points {
            canvas.marker(point, 2.6, DETERMINISTIC_STYLE);
        }
    }
    positive.iter().flatten().last().copied()
}

/// Maximal runs of present values with their indices.
fn runs<T: Copy>(values: &[Option<T>]) -> Vec<Vec<(usize, T)>> {
    let mut runs: Vec<Vec<(usize, T)>> = vec![Vec::new()];
    for (i, value) in values.iter().enumerate() {
        match (value, runs.last_mut()) {
            (Some(v), Some(run)) => run.push((i, *v)),
            _ => runs.push(Vec::new()),
        }
    }
    runs.retain(|run| !run.is_empty());
    runs
}

fn middle(values: &[Option<f64>]) -> Option<f64> {
    let mut present: Vec<f64> = values.iter().flatten().copied().collect();
    present.sort_by(f64::total_cmp);
    present.get(present.len() / 2).copied()
}

/// The horizontal axis: from the lightest load to the heaviest.
fn x_axis(lines: &LoadLines, unit: Unit) -> PlotAxis {
    let (first, last) = (lines.pressures[0], lines.pressures[lines.pressures.len() - 1]);
    let data = if last > first { [first, last] } else { [first / 3.0, last * 3.0] };
    PlotAxis::log(data.map(|p| p / unit.scale), [LEFT, RIGHT])
}
