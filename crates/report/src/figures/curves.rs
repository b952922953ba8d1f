//! The figures over the load: real area, real pressure, error of each closed form.

use crate::draw::axes::{Frame, PlotAxis};
use crate::draw::labels::{EndLabel, ROOM, draw_end_labels};
use crate::draw::palette::{BAND, DETERMINISTIC, DETERMINISTIC_STYLE, INK2};
use crate::draw::svg::{COLUMN, Canvas, Figure, Stroke, Text, num};
use crate::lines::{Lines, ModelLine, compared, min_max, range_words};
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
pub(crate) fn area(lines: &Lines, key: &str, usage: Use) -> Figure {
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
    Plot {
        lines,
        reference,
        band,
        models,
        ceiling: 100.0,
        cells: 'a',
        key,
        usage,
        title: "Real contact area over the load",
        y_title: "Real contact area (% of nominal)".into(),
        description,
    }
    .draw()
}

/// Fig. 2 of the source paper: mean real pressure over nominal pressure, both logarithmic.
pub(crate) fn pressure(lines: &Lines, key: &str, usage: Use) -> Figure {
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
    let band = lines
        .pressures
        .iter()
        .zip(&lines.interval)
        .map(|(&p, i)| {
            let [lo, hi] = (*i)?;
            (lo > 0.0).then(|| [p / hi / unit.scale, p / lo / unit.scale])
        })
        .collect();
    let reference = scaled(reference);
    let description = format!(
        "Log-log plot. Deterministic mean real pressure: {} while load rises {:.0} times.",
        range_words(&reference, &format!(" {}", unit.name)),
        lines.pressures[lines.pressures.len() - 1] / lines.pressures[0]
    );
    Plot {
        lines,
        reference,
        band,
        models: lines.models.iter().map(|m| scaled(over(&m.area))).collect(),
        ceiling: f64::INFINITY,
        cells: 'p',
        key,
        usage,
        title: "Mean real pressure over the load",
        y_title: format!("Mean real pressure ({})", unit.name),
        description,
    }
    .draw()
}

/// A log-log plot of one quantity of the reference and of every model.
struct Plot<'a> {
    lines: &'a Lines,
    reference: Vec<Option<f64>>,
    band: Vec<Option<[f64; 2]>>,
    models: Vec<Vec<Option<f64>>>,
    ceiling: f64,
    cells: char,
    key: &'a str,
    usage: Use,
    title: &'a str,
    y_title: String,
    description: String,
}

impl Plot<'_> {
    fn draw(self) -> Figure {
        let lines = self.lines;
        let (unit, x_title) = lines.load_axis();
        let mut reference = self.reference.clone();
        // The band belongs to the reference.
        reference.extend(self.band.iter().flatten().flatten().map(|v| Some(*v)));
        let [lo, hi] = log_limits(&reference, &self.models, self.ceiling);
        let off = |v: f64| v < lo || v > hi * (1.0 + 1e-9);
        let outside: Vec<usize> = (0..self.models.len())
            .filter(|&k| self.models[k].iter().flatten().any(|v| off(*v)))
            .collect();
        let top = TOP + if outside.is_empty() { 0.0 } else { NOTE * outside.len() as f64 - 2.0 };
        let bottom = HEIGHT - BOTTOM_MARGIN;
        let frame = Frame {
            x: x_axis(lines, unit),
            y: PlotAxis::log([lo, hi], [bottom, top]),
            x_title,
            y_title: self.y_title.clone(),
        };
        let mut canvas = Canvas::default();
        frame.draw(&mut canvas);
        self.off_scale_notes(&mut canvas, &outside, [lo, hi]);
        if self.usage == Use::Page {
            cursor(&mut canvas, lines, &frame, self.cells);
        }
        let clip = open_clip(&mut canvas, self.key, &frame);
        let x = |i: usize| lines.pressures[i] / unit.scale;
        let bands: Vec<_> =
            self.band.iter().map(|b| b.map(|b| b.map(|v| v.clamp(lo, hi)))).collect();
        draw_band(&mut canvas, &frame, &x, &bands, 0.16);
        let mut ends = Vec::new();
        for (model, values) in lines.models.iter().zip(&self.models) {
            if let Some(y) = draw_model(&mut canvas, &frame, &x, values, model) {
                ends.push(of_model(&frame, y, model));
            }
        }
        let last = draw_reference(&mut canvas, &frame, &x, &self.reference);
        canvas.raw(clip);
        if let Some(y) = last {
            ends.push(deterministic(&frame, y));
        }
        draw_end_labels(&mut canvas, RIGHT, [top + 2.0, bottom - 2.0], &ends);
        Figure {
            key: self.key.into(),
            title: self.title.into(),
            description: self.description,
            size: [COLUMN, HEIGHT],
            canvas,
        }
    }

    /// "▲ MB off scale from 400 MPa", one line per model, above the frame.
    fn off_scale_notes(&self, canvas: &mut Canvas, outside: &[usize], [lo, hi]: [f64; 2]) {
        let lines = self.lines;
        for (row, &k) in outside.iter().enumerate() {
            let off =
                |i: &usize| self.models[k][*i].is_some_and(|v| v < lo || v > hi * (1.0 + 1e-9));
            let loads: Vec<usize> = (0..lines.pressures.len()).filter(off).collect();
            let (Some(&first), Some(&last)) = (loads.first(), loads.last()) else { continue };
            let high = self.models[k][first].is_some_and(|v| v > hi);
            let at = |i: usize| load(lines.pressures[i], lines.load_area);
            let whole = loads.len() == lines.pressures.len();
            let range = match (first, last + 1 == lines.pressures.len()) {
                _ if whole => "at every load".into(),
                (0, _) => format!("up to {}", at(last)),
                (_, true) => format!("from {}", at(first)),
                _ => format!("between {} and {}", at(first), at(last)),
            };
            let sign = if high { '▲' } else { '▼' };
            let note = format!("{sign} {} off scale {range}", lines.models[k].label);
            note_above(canvas, row, &lines.models[k], &note);
        }
    }
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
pub(crate) fn error(lines: &Lines, key: &str) -> Figure {
    let (unit, x_title) = lines.load_axis();
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
    let outside: Vec<&ModelLine> = lines
        .models
        .iter()
        .zip(&errors)
        .filter(|(_, e)| e.iter().flatten().any(|e| *e < lo || *e > hi))
        .map(|(m, _)| m)
        .collect();

    let top = TOP + if outside.is_empty() { 0.0 } else { NOTE * outside.len() as f64 };
    let bottom = HEIGHT - BOTTOM_MARGIN;
    let frame = Frame {
        x: x_axis(lines, unit),
        y: PlotAxis::linear([lo, hi], [bottom, top]),
        x_title,
        y_title: "Error in area (%)".into(),
    };
    let mut canvas = Canvas::default();
    let tolerance = [LEFT, frame.y.at(10.0), RIGHT, frame.y.at(-10.0)];
    canvas.rect(tolerance, BAND, 1.0);
    let x_ticks: Vec<_> = frame.x.major().into_iter().map(|v| (v, frame.x.tick_text(v))).collect();
    let y_ticks: Vec<_> = frame
        .y
        .major()
        .into_iter()
        .map(|v| {
            (v, if v > 0.0 { format!("+{}", frame.y.tick_text(v)) } else { frame.y.tick_text(v) })
        })
        .collect();
    frame.draw_with(&mut canvas, &x_ticks, &y_ticks);
    off_scale_notes(&mut canvas, lines, &outside);
    cursor(&mut canvas, lines, &frame, 'e');
    let clip = open_clip(&mut canvas, key, &frame);
    let x = |i: usize| lines.pressures[i] / unit.scale;
    let band: Vec<_> = lines
        .interval
        .iter()
        .zip(&lines.area)
        .map(|(i, a)| Some((*i)?.map(|v| (100.0 * (v / a.unwrap_or(v) - 1.0)).clamp(lo, hi))))
        .collect();
    draw_band(&mut canvas, &frame, &x, &band, 0.28);
    canvas.line(
        [LEFT, frame.y.at(0.0)],
        [RIGHT, frame.y.at(0.0)],
        Stroke::solid(DETERMINISTIC, 1.6),
    );
    let mut ends = vec![deterministic(&frame, 0.0)];
    for (model, values) in lines.models.iter().zip(&errors) {
        if let Some(y) = draw_model(&mut canvas, &frame, &x, values, model)
            && (lo..=hi).contains(&y)
        {
            ends.push(of_model(&frame, y, model));
        }
    }
    canvas.raw(clip);
    // A band too narrow for its name is named in the caption alone.
    if tolerance[3] - tolerance[1] > 26.0 {
        canvas.text(&Text {
            colour: INK2,
            size: 9.0,
            halo: true,
            ..Text::new([LEFT + 4.0, tolerance[1] + 9.5], "within 10\u{202F}%")
        });
    }
    draw_end_labels(&mut canvas, RIGHT, [top + 2.0, bottom - 2.0], &ends);
    Figure {
        key: key.into(),
        title: "Signed error of each closed form against load".into(),
        description: format!(
            "Per cent error of the area relative to the deterministic solution of the same map. {}",
            compared(lines)
        ),
        size: [COLUMN, HEIGHT],
        canvas,
    }
}

fn of_model(frame: &Frame, y: f64, model: &ModelLine) -> EndLabel {
    let (text, series) = (model.label.clone(), model.name.clone());
    let colour = model.look.colour;
    EndLabel { y: within(frame, y), text, colour, bold: false, series }
}

fn deterministic(frame: &Frame, y: f64) -> EndLabel {
    let (text, series) = ("Deterministic".into(), String::new());
    EndLabel { y: within(frame, y), text, colour: DETERMINISTIC, bold: true, series }
}

fn within(frame: &Frame, y: f64) -> f64 {
    let [bottom, top] = frame.y.units;
    frame.y.at(y).clamp(top, bottom)
}

/// "▲ Stacked off scale: +141 to +434 %", one line per model, above the frame.
fn off_scale_notes(canvas: &mut Canvas, lines: &Lines, outside: &[&ModelLine]) {
    for (row, model) in outside.iter().enumerate() {
        let errors: Vec<f64> = lines.errors(model).into_iter().flatten().collect();
        let (lo, hi) = min_max(&errors).unwrap_or((0.0, 0.0));
        let sign = if hi + lo > 0.0 { '▲' } else { '▼' };
        let note = format!("{sign} {} off scale: {}", model.label, signed_range(lo, hi));
        note_above(canvas, row, model, &note);
    }
}

/// A line of notes above the frame, in the colour of a model.
fn note_above(canvas: &mut Canvas, row: usize, model: &ModelLine, note: &str) {
    let at = [LEFT + 4.0, 10.0 + NOTE * row as f64];
    let text = Text { colour: model.look.colour, size: 9.0, ..Text::new(at, note) };
    canvas.series(&model.name, |canvas| canvas.label(&text));
}

/// The dotted line at the load read off; the report's script moves it, and lists beside it what `cells` of
/// the slider's data begin with the letter of the figure.
fn cursor(canvas: &mut Canvas, lines: &Lines, frame: &Frame, cells: char) {
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

/// Opens a group clipped to the frame (a little wider, for markers on its edge) and returns its
/// closing tag.
fn open_clip(canvas: &mut Canvas, key: &str, frame: &Frame) -> &'static str {
    let [bottom, top] = frame.y.units;
    let [left, right] = frame.x.units;
    canvas.raw(&format!(
        "<clipPath id=\"{key}-c\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>\
         <g clip-path=\"url(#{key}-c)\">",
        num(left - 4.0),
        num(top - 4.0),
        num(right - left + 8.0),
        num(bottom - top + 4.0)
    ));
    "</g>"
}

/// Draws a band between low and high values, in pieces where values are missing.
fn draw_band(
    canvas: &mut Canvas,
    frame: &Frame,
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
    frame: &Frame,
    x: &impl Fn(usize) -> f64,
    values: &[Option<f64>],
    model: &ModelLine,
) -> Option<f64> {
    let look = model.look;
    let stroke = Stroke { colour: look.colour, width: look.width, dash: look.dash };
    let present: Vec<(usize, f64)> =
        values.iter().enumerate().filter_map(|(i, v)| Some((i, (*v)?))).collect();
    canvas.series(&model.name, |canvas| {
        for run in runs(values) {
            let points: Vec<[f64; 2]> = run.iter().map(|(i, v)| frame.at([x(*i), *v])).collect();
            canvas.polyline(&points, stroke);
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
    frame: &Frame,
    x: &impl Fn(usize) -> f64,
    values: &[Option<f64>],
) -> Option<f64> {
    let positive: Vec<Option<f64>> = values.iter().map(|v| v.filter(|v| *v > 0.0)).collect();
    for run in runs(&positive) {
        let points: Vec<[f64; 2]> = run.iter().map(|(i, v)| frame.at([x(*i), *v])).collect();
        canvas.polyline(&points, Stroke::solid(DETERMINISTIC, DETERMINISTIC_STYLE.width));
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
fn x_axis(lines: &Lines, unit: Unit) -> PlotAxis {
    let (first, last) = (lines.pressures[0], lines.pressures[lines.pressures.len() - 1]);
    let data = if last > first { [first, last] } else { [first / 3.0, last * 3.0] };
    PlotAxis::log(data.map(|p| p / unit.scale), [LEFT, RIGHT])
}
