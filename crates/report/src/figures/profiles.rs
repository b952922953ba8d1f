//! Figures of a study of profiles: the trace as measured, and the models over the load.

use crate::draw::axes::{PlotAxis, PlotFrame};
use crate::draw::palette::{BAND, DETERMINISTIC, INK2, Stroke};
use crate::draw::svg::{Canvas, Figure, Rect, Text};
use crate::figures::curves;
use crate::lines::{LoadLine, LoadLines};
use crate::messages::profile::profile_headline;
use crate::numbers::{METRES, chosen, quantity, unit_for};
use contact_compare::ProfileComparison;

const SIZE: [f64; 2] = [704.0, 190.0];
const FRAME: Rect = [44.0, 12.0, 692.0, 154.0];
/// Most columns that are drawn: each as the line from its lowest to its highest point.
const COLUMNS: usize = 648;

/// Area over load by every model, and as a band what those made of moments span together.
pub(crate) fn area(study: &ProfileComparison) -> Figure {
    let models = study.models.iter().enumerate();
    let answers = models.filter_map(|(place, m)| Some((place, &m.card, m.outcome.as_ref().ok()?)));
    let n = study.pressures.len();
    let lines = LoadLines {
        pressures: study.pressures.clone(),
        area: vec![None; n],
        interval: (0..n).map(|i| study.span(i).map(|(span, _)| span)).collect(),
        models: answers.map(|(place, card, curve)| LoadLine::of(card, place, curve)).collect(),
        load_area: None,
        headline: study.headline,
        of: "",
    };
    let figure = curves::area(&lines, false);
    Figure { description: profile_headline(study), ..figure }
}

/// The first trace, height over position, with its evaluation length and section lengths shaded; `None` of a flat one.
pub(crate) fn first_trace(study: &ProfileComparison) -> Option<Figure> {
    let (trace, s) = (&study.surface.traces[0], &study.statistics);
    let heights = trace.heights();
    let (low, high) = trace.range();
    let length = trace.length();
    if high <= low {
        return None;
    }
    let x_unit = unit_for(length, METRES);
    let y_unit = unit_for(high.abs().max(low.abs()), METRES);
    let room = 0.06 * (high - low);
    let data = [low - room, high + room].map(|z| z / y_unit.scale);
    let axes = [[0.0, length / x_unit.scale], data].map(PlotAxis::linear);
    let titles = [format!("Position ({})", x_unit.name), format!("Height ({})", y_unit.name)];
    let frame = PlotFrame::new(FRAME, axes, titles.each_ref().map(String::as_str));
    let mut canvas = Canvas::default();
    let x = |metres: f64| frame.x.at(metres / x_unit.scale);
    if let Ok(found) = &s.roughness {
        // With a filter that was asked for the ends are off, and the evaluation length with them.
        let cut = 0.5 * s.options.cutoff.unwrap_or(0.0);
        let ([start, end], sections) = (found.evaluated.map(|end| end - cut), found.sections);
        for k in (0..sections).step_by(2) {
            let at = |k: usize| x(start + (end - start) * k as f64 / sections as f64);
            canvas.rect([at(k), FRAME[1], at(k + 1), FRAME[3]], BAND, 1.0);
        }
        let ends = [start, end].map(|p| [x(p), FRAME[1], x(p), FRAME[3]]);
        canvas.ticks(&ends, Stroke { colour: INK2, width: 0.6, dash: "3 2" });
        let at = [x(start) + 3.0, FRAME[3] - 4.0];
        canvas.text(&Text::start(at, "evaluated for roughness", INK2).small().halo());
    }
    frame.draw(&mut canvas);
    let y = |metres: f64| frame.y.at(metres / y_unit.scale);
    let n = heights.len();
    let points: Vec<[f64; 2]> = if n <= 2 * COLUMNS {
        let step = trace.spacing();
        heights.iter().enumerate().map(|(i, z)| [x(i as f64 * step), y(*z)]).collect()
    } else {
        let column = |k: usize| {
            let part = &heights[k * n / COLUMNS..(k + 1) * n / COLUMNS];
            let fold = |[a, b]: [f64; 2], z: &f64| [a.min(*z), b.max(*z)];
            let mut ends = part.iter().fold([f64::INFINITY, f64::NEG_INFINITY], fold);
            // Down and up in turn, so that neighbouring columns are joined by short lines.
            if k % 2 == 1 {
                ends.reverse();
            }
            let at = x((k as f64 + 0.5) / COLUMNS as f64 * length);
            ends.map(|z| [at, y(z)])
        };
        (0..COLUMNS).flat_map(column).collect()
    };
    canvas.polyline(&points, Stroke::solid(DETERMINISTIC, 0.6));
    let (long, [low, high]) = (chosen(length, METRES), [low, high].map(|z| quantity(z, METRES, 3)));
    let description =
        format!("{n} points over {long}, heights from {low} to {high} about the form taken off.");
    Some(canvas.figure("Height along the trace", description, SIZE))
}
