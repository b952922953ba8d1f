//! A trace as measured: height over position.

use crate::draw::axes::{PlotAxis, PlotFrame};
use crate::draw::palette::{BAND, DETERMINISTIC, INK2, Stroke};
use crate::draw::svg::{Anchor, Canvas, Figure, Text};
use crate::numbers::{METRES, chosen, quantity, unit_for};
use surface_stats::profile::Trace;

/// Width and height of the figure, and its plot box.
const SIZE: [f64; 2] = [704.0, 190.0];
const FRAME: [f64; 4] = [44.0, 12.0, 692.0, 154.0];
/// Most columns that are drawn: each as the line from its lowest to its highest point.
const COLUMNS: usize = 648;

/// The first trace, with its evaluation length and section lengths shaded.
pub(crate) fn trace(
    trace: &Trace,
    evaluated: Option<([f64; 2], usize)>,
    key: &str,
) -> Option<Figure> {
    let heights = trace.heights();
    let (low, high) = trace.range();
    let length = trace.length();
    if high <= low {
        return None;
    }
    let x_unit = unit_for(length, METRES);
    let y_unit = unit_for(high.abs().max(low.abs()), METRES);
    let room = 0.06 * (high - low);
    let frame = PlotFrame {
        x: PlotAxis::linear([0.0, length / x_unit.scale], [FRAME[0], FRAME[2]]),
        y: PlotAxis::linear(
            [(low - room) / y_unit.scale, (high + room) / y_unit.scale],
            [FRAME[3], FRAME[1]],
        ),
        x_title: format!("Position ({})", x_unit.name),
        y_title: format!("Height ({})", y_unit.name),
    };
    let mut canvas = Canvas::default();
    let x = |metres: f64| frame.x.at(metres / x_unit.scale);
    if let Some(([start, end], sections)) = evaluated {
        for k in (0..sections).step_by(2) {
            let at = |k: usize| x(start + (end - start) * k as f64 / sections as f64);
            canvas.rect([at(k), FRAME[1], at(k + 1), FRAME[3]], BAND, 1.0);
        }
        let ends = [start, end].map(|p| [x(p), FRAME[1], x(p), FRAME[3]]);
        canvas.ticks(&ends, Stroke { colour: INK2, width: 0.6, dash: "3 2" });
        canvas.text(&Text {
            colour: INK2,
            size: 9.0,
            anchor: Anchor::Start,
            halo: true,
            ..Text::new([x(start) + 3.0, FRAME[3] - 4.0], "evaluated for roughness")
        });
    }
    frame.draw(&mut canvas);
    let y = |metres: f64| frame.y.at(metres / y_unit.scale);
    let step = trace.spacing();
    let points: Vec<[f64; 2]> = if heights.len() <= 2 * COLUMNS {
        heights.iter().enumerate().map(|(i, z)| [x(i as f64 * step), y(*z)]).collect()
    } else {
        let n = heights.len();
        (0..COLUMNS)
            .flat_map(|k| {
                let part = &heights[k * n / COLUMNS..(k + 1) * n / COLUMNS];
                let fold = |(a, b): (f64, f64), z: &f64| (a.min(*z), b.max(*z));
                let (low, high) = part.iter().fold((f64::INFINITY, f64::NEG_INFINITY), fold);
                let at = x((k as f64 + 0.5) / COLUMNS as f64 * length);
                // Down and up in turn, so that neighbouring columns are joined by short lines.
                if k.is_multiple_of(2) {
                    [[at, y(low)], [at, y(high)]]
                } else {
                    [[at, y(high)], [at, y(low)]]
                }
            })
            .collect()
    };
    canvas.polyline(&points, Stroke::solid(DETERMINISTIC, 0.6));
    let description = format!(
        "{} points over {}, heights from {} to {} about the form taken off.",
        heights.len(),
        chosen(length, METRES),
        quantity(low, METRES, 3),
        quantity(high, METRES, 3)
    );
    Some(canvas.figure(key, "Height along the trace", description, SIZE))
}
