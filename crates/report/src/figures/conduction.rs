//! What the contact conducts: over the load, and without the shortest waves.

use crate::draw::axes::{PlotAxis, PlotFrame};
use crate::draw::labels::{EndLabel, ROOM, draw_end_labels};
use crate::draw::palette::{DETERMINISTIC_STYLE, INK2, Marker, PERSSON, Stroke, Style};
use crate::draw::svg::{COLUMN, Canvas, Figure};
use crate::figures::curves::log_limits;
use crate::lines::load_axis;
use crate::numbers::{METRES, significant, times, unit_for};
use contact_compare::Octave;

const LEFT: f64 = 52.0;
const RIGHT: f64 = COLUMN - ROOM;
const TOP: f64 = 12.0;
const BOTTOM: f64 = 226.0;
const HEIGHT: f64 = 262.0;

/// One line over the loads.
pub(crate) struct LoadLine {
    pub(crate) label: String,
    /// The series it is, see [`Canvas::series`]; may be empty.
    pub(crate) series: String,
    pub(crate) look: Style,
    pub(crate) values: Vec<Option<f64>>,
}

/// A quantity over the load: the deterministic one, and what closed forms make of it.
pub(crate) fn over_load(
    (pressures, area): (&[f64], Option<f64>),
    deterministic: &[Option<f64>],
    lines: &[LoadLine],
    (title, unit_name): (&str, &str),
    key: &str,
) -> Figure {
    let (unit, x_title) = load_axis(pressures, area);
    let drawn = |v: &Option<f64>| v.filter(|v| *v > 0.0 && v.is_finite());
    let reference: Vec<Option<f64>> = deterministic.iter().map(drawn).collect();
    let others: Vec<Vec<Option<f64>>> =
        lines.iter().map(|line| line.values.iter().map(drawn).collect()).collect();
    // The names stand where the lines end.
    let is_drawn = |i: &usize| reference[*i].is_some() || others.iter().any(|o| o[*i].is_some());
    let last = (0..pressures.len()).rfind(is_drawn).unwrap_or(pressures.len() - 1);
    let (first, last) = (pressures[0], pressures[last]);
    let ends = if last > first { [first, last] } else { [first / 3.0, last * 3.0] };
    let frame = PlotFrame {
        x: PlotAxis::log(ends.map(|p| p / unit.scale), [LEFT, RIGHT]),
        y: PlotAxis::log(log_limits(&reference, &others, f64::INFINITY), [BOTTOM, TOP]),
        x_title,
        y_title: format!("{title} ({unit_name})"),
    };
    let mut canvas = Canvas::default();
    frame.draw(&mut canvas);
    let mut labels = Vec::new();
    let loads = (pressures, unit.scale);
    for (line, values) in lines.iter().zip(&others) {
        let end =
            canvas.series(&line.series, |canvas| draw(canvas, &frame, loads, values, line.look));
        labels.extend(end.filter(|_| !line.label.is_empty()).map(|y| EndLabel {
            y,
            text: line.label.clone(),
            colour: line.look.colour,
            bold: false,
            series: line.series.clone(),
        }));
    }
    let end = draw(&mut canvas, &frame, loads, &reference, DETERMINISTIC_STYLE);
    labels.extend(end.map(EndLabel::deterministic));
    draw_end_labels(&mut canvas, RIGHT, [TOP + 2.0, BOTTOM - 2.0], &labels);
    let range = crate::lines::range_words(&reference, &format!(" {unit_name}"));
    let description = format!("Log-log plot. Deterministic: {range}.");
    canvas.figure(key, format!("{title} over the load"), description, [COLUMN, HEIGHT])
}

/// Area and conductance over those of the whole map, by the shortest wave left.
pub(crate) fn octaves(octaves: &[Octave], key: &str) -> Figure {
    let [longest, shortest] = [octaves[octaves.len() - 1].shortest, octaves[0].shortest];
    let unit = unit_for((longest * shortest).sqrt(), METRES);
    let first = octaves[0];
    let area: Vec<f64> = octaves.iter().map(|o| o.area / first.area).collect();
    let conductance: Vec<f64> = octaves.iter().map(|o| o.stiffness / first.stiffness).collect();
    let all = || area.iter().chain(&conductance).copied();
    let (lo, hi) = (all().fold(1.0, f64::min), all().fold(1.0, f64::max));
    let frame = PlotFrame {
        x: PlotAxis::log([shortest / 1.1 / unit.scale, longest * 1.1 / unit.scale], [LEFT, RIGHT]),
        y: PlotAxis::log([(lo / 1.1).min(0.8), (hi * 1.1).max(1.25)], [BOTTOM, TOP]),
        x_title: format!("Shortest wave of the map ({})", unit.name),
        y_title: "Over that of the whole map".into(),
    };
    let mut canvas = Canvas::default();
    frame.draw(&mut canvas);
    canvas.line([LEFT, frame.y.at(1.0)], [RIGHT, frame.y.at(1.0)], Stroke::solid(INK2, 0.6));
    let waves: Vec<f64> = octaves.iter().map(|o| o.shortest).collect();
    let mut labels = Vec::new();
    for (label, values, look) in [
        ("Area", &area, Style::model(PERSSON, "6 2.5", Marker::Square, 0)),
        ("Conductance", &conductance, DETERMINISTIC_STYLE),
    ] {
        let values: Vec<Option<f64>> = values.iter().map(|v| Some(*v)).collect();
        let end = draw(&mut canvas, &frame, (&waves, unit.scale), &values, look);
        let (text, colour, bold) = (label.into(), look.colour, label == "Conductance");
        labels.extend(end.map(|y| EndLabel { y, text, colour, bold, series: String::new() }));
    }
    draw_end_labels(&mut canvas, RIGHT, [TOP + 2.0, BOTTOM - 2.0], &labels);
    let last = octaves.len() - 1;
    let description = format!(
        "From the whole map to waves of at least {} {}: area times {}, conductance times {}.",
        significant(longest / unit.scale, 2),
        unit.name,
        times(area[last]),
        significant(conductance[last], 3)
    );
    canvas.figure(
        key,
        "Area and conductance without the shortest waves",
        description,
        [COLUMN, HEIGHT],
    )
}

/// A line with a marker at every value; answers with the height of its end.
fn draw(
    canvas: &mut Canvas,
    frame: &PlotFrame,
    (x, scale): (&[f64], f64),
    values: &[Option<f64>],
    look: Style,
) -> Option<f64> {
    let points: Vec<[f64; 2]> = x
        .iter()
        .zip(values)
        .filter_map(|(x, v)| Some(frame.at([x / scale, (*v)?])))
        .filter(|[_, y]| (TOP..=BOTTOM).contains(y))
        .collect();
    canvas.polyline(&points, look.stroke());
    for point in points {
        canvas.marker(point, 2.4, look);
    }
    values.iter().flatten().last().map(|last| frame.y.at(*last).clamp(TOP, BOTTOM))
}
