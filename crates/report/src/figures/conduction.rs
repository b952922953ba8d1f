//! What the contact conducts: over the load, and without the shortest waves.

use crate::draw::axes::{PlotAxis, PlotFrame};
use crate::draw::labels::{EndLabel, ROOM, draw_end_labels};
use crate::draw::palette::{DETERMINISTIC_STYLE, INK2, Marker, PERSSON, Stroke, Style};
use crate::draw::svg::{COLUMN, Canvas, Figure, Rect};
use crate::figures::curves::log_limits;
use crate::lines::{LoadLine, load_axis, load_ends, range_words};
use crate::numbers::{METRES, significant, times, unit_for};
use contact_compare::{Octave, SurfaceComparison};

const FRAME: Rect = [52.0, 12.0, COLUMN - ROOM, 226.0];
const SIZE: [f64; 2] = [COLUMN, 262.0];

/// A quantity over the loads of a surface: the deterministic one, and what closed forms make of it.
pub(crate) fn over_load(
    surface: &SurfaceComparison,
    deterministic: &[Option<f64>],
    lines: &[LoadLine],
    (title, unit_name): (&str, &str),
) -> Figure {
    let pressures: Vec<f64> = surface.deterministic.iter().map(|p| p.mean_pressure).collect();
    let (unit, x_title) = load_axis(&pressures, surface.load_area);
    let x: Vec<f64> = pressures.iter().map(|p| p / unit.scale).collect();
    let drawn = |v: &Option<f64>| v.filter(|v| *v > 0.0 && v.is_finite());
    let reference: Vec<Option<f64>> = deterministic.iter().map(drawn).collect();
    let others: Vec<Vec<Option<f64>>> =
        lines.iter().map(|line| line.values.iter().map(drawn).collect()).collect();
    // The names stand where the lines end.
    let is_drawn = |i: &usize| reference[*i].is_some() || others.iter().any(|o| o[*i].is_some());
    let last = (0..x.len()).rfind(is_drawn).unwrap_or(x.len() - 1);
    let beside = others.iter().flat_map(|values| values.iter().zip(&reference));
    let limits = log_limits(reference.iter().flatten(), beside, f64::INFINITY);
    let axes = [load_ends(x[0], x[last]), limits].map(PlotAxis::log);
    let frame = PlotFrame::new(FRAME, axes, [&x_title, &format!("{title} ({unit_name})")]);
    let mut canvas = frame.canvas();
    let mut labels = Vec::new();
    for (line, values) in lines.iter().zip(&others) {
        let end = canvas.series(&line.name, |canvas| draw(canvas, &frame, &x, values, line.look));
        let named = end.filter(|_| !line.label.is_empty());
        labels.extend(named.map(|y| EndLabel::of(y, line)));
    }
    let end = draw(&mut canvas, &frame, &x, &reference, DETERMINISTIC_STYLE);
    labels.extend(end.map(EndLabel::deterministic));
    draw_end_labels(&mut canvas, &frame, 2.0, &labels);
    let range = range_words(&reference, &format!(" {unit_name}"));
    let description = format!("Log-log plot. Deterministic: {range}.");
    canvas.figure(format!("{title} over the load"), description, SIZE)
}

/// Area and conductance over those of the whole map, by the shortest wave left.
pub(crate) fn octaves(octaves: &[Octave]) -> Figure {
    let (first, last) = (octaves[0], octaves[octaves.len() - 1]);
    let (longest, shortest) = (last.shortest, first.shortest);
    let unit = unit_for((longest * shortest).sqrt(), METRES);
    let area: Vec<_> = octaves.iter().map(|o| Some(o.area / first.area)).collect();
    let conductance: Vec<_> = octaves.iter().map(|o| Some(o.stiffness / first.stiffness)).collect();
    let all = || area.iter().chain(&conductance).copied().flatten();
    let (lo, hi) = (all().fold(1.0, f64::min), all().fold(1.0, f64::max));
    let x = [shortest / 1.1 / unit.scale, longest * 1.1 / unit.scale];
    let axes = [x, [(lo / 1.1).min(0.8), (hi * 1.1).max(1.25)]].map(PlotAxis::log);
    let x_title = format!("Shortest wave of the map ({})", unit.name);
    let frame = PlotFrame::new(FRAME, axes, [&x_title, "Over that of the whole map"]);
    let mut canvas = frame.canvas();
    let [from, to] = [FRAME[0], FRAME[2]].map(|x| [x, frame.y.at(1.0)]);
    canvas.line(from, to, Stroke::solid(INK2, 0.6));
    let waves: Vec<f64> = octaves.iter().map(|o| o.shortest / unit.scale).collect();
    let mut labels = Vec::new();
    for (text, values, look, bold) in [
        ("Area", &area, Style::model(PERSSON, "6 2.5", Marker::Square, 0), false),
        ("Conductance", &conductance, DETERMINISTIC_STYLE, true),
    ] {
        let end = draw(&mut canvas, &frame, &waves, values, look);
        let (text, colour, series) = (text.into(), look.colour, String::new());
        labels.extend(end.map(|y| EndLabel { y, text, colour, bold, series }));
    }
    draw_end_labels(&mut canvas, &frame, 2.0, &labels);
    let (wave, unit) = (significant(longest / unit.scale, 2), unit.name);
    let area = times(last.area / first.area);
    let conductance = significant(last.stiffness / first.stiffness, 3);
    let description = format!(
        "From the whole map to waves of at least {wave} {unit}: area times {area}, conductance times {conductance}."
    );
    let title = "Area and conductance without the shortest waves";
    canvas.figure(title, description, SIZE)
}

/// A line with a marker at every value; answers with the height of its end.
fn draw(
    canvas: &mut Canvas,
    frame: &PlotFrame,
    x: &[f64],
    values: &[Option<f64>],
    look: Style,
) -> Option<f64> {
    let placed = x.iter().zip(values).filter_map(|(x, v)| Some(frame.at([*x, (*v)?])));
    let [_, top, _, bottom] = FRAME;
    let points: Vec<[f64; 2]> = placed.filter(|[_, y]| (top..=bottom).contains(y)).collect();
    canvas.polyline(&points, look.stroke());
    for point in points {
        canvas.marker(point, 2.4, look);
    }
    values.iter().flatten().last().map(|last| frame.y.at(*last).clamp(top, bottom))
}
