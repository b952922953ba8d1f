//! The figure of the check of `--accuracy`: what was asked for against what came out.

use report::draw::axes::{Axis, Frame};
use report::draw::palette::{DETERMINISTIC, INK2, LINE, Look, Marker, WARN};
use report::draw::svg::{Anchor, COLUMN, Canvas, Figure, Stroke, Text};
use std::io::{self, Write};

/// Errors below this are drawn on the lower edge.
const LEAST: f64 = 1e-5;

/// True relative error of every answer that claims to meet its request, `[request, error]`, on
/// logarithmic axes with the diagonal: below it the request is met. Half of the errors of a
/// request lie below its bar.
///
/// # Errors
/// Whatever the writer reports.
pub fn write_accuracy(answers: &[[f64; 2]], out: &mut impl Write) -> io::Result<()> {
    let right = COLUMN - 70.0;
    let frame = Frame {
        x: Axis::log([0.3, 17.0], [44.0, right]),
        y: Axis::log([100.0 * LEAST / 1.3, 20.0], [231.0, 25.0]),
        x_title: "Accuracy asked for (%)".into(),
        y_title: "True error of the area (%)".into(),
    };
    let mut canvas = Canvas::default();
    frame.draw(&mut canvas);
    let (from, to) = (frame.at([0.3, 0.3]), frame.at([17.0, 17.0]));
    canvas.line(from, to, Stroke::solid(DETERMINISTIC, 0.8));
    let [x, y] = frame.at([0.33, 0.8]);
    canvas.text(&Text { colour: INK2, size: 9.0, ..Text::new([x, y], "as asked") });

    let mut requests: Vec<f64> = answers.iter().map(|a| a[0]).collect();
    requests.sort_by(f64::total_cmp);
    requests.dedup();
    let dot = Look::model(LINE, "", Marker::Dot, 0);
    let cross = Look::model(WARN, "", Marker::Cross, 0);
    let mut described = Vec::new();
    for request in requests {
        let mut errors: Vec<f64> =
            answers.iter().filter(|a| a[0].total_cmp(&request).is_eq()).map(|a| a[1]).collect();
        errors.sort_by(f64::total_cmp);
        let count = errors.len();
        for (k, error) in errors.iter().enumerate() {
            // Spread over the width of a column in a fixed order.
            let spread = ((k as f64 * 0.618_034).fract() - 0.5) * 0.36;
            let look = if *error > request { cross } else { dot };
            let place = [100.0 * request * spread.exp(), 100.0 * error.max(LEAST)];
            canvas.marker(frame.at(place), if *error > request { 2.6 } else { 1.2 }, look);
        }
        let median = errors[count / 2];
        let [x, y] = frame.at([100.0 * request, 100.0 * median.max(LEAST)]);
        canvas.line([x - 14.0, y], [x + 14.0, y], Stroke::solid(DETERMINISTIC, 2.0));
        let met = errors.iter().filter(|e| **e <= request).count();
        for (y, number) in [(10.0, met), (20.0, count)] {
            let text = number.to_string();
            canvas.text(&Text { anchor: Anchor::Middle, size: 9.0, ..Text::new([x, y], &text) });
        }
        described.push(format!("{} %: {met} of {count} met", 100.0 * request));
    }
    for (y, label) in [(10.0, "met of"), (20.0, "claimed")] {
        canvas.text(&Text { colour: INK2, size: 9.0, ..Text::new([right + 4.0, y], label) });
    }
    for (k, (look, label)) in [(dot, "met"), (cross, "missed")].into_iter().enumerate() {
        let y = 60.0 + 14.0 * k as f64;
        canvas.marker([right + 10.0, y - 3.0], 2.4, look);
        canvas.text(&Text { size: 9.0, ..Text::new([right + 17.0, y], label) });
    }
    canvas.line([right + 4.0, 85.0], [right + 16.0, 85.0], Stroke::solid(DETERMINISTIC, 2.0));
    canvas.text(&Text { size: 9.0, ..Text::new([right + 19.0, 88.0], "median") });
    Figure {
        key: "accuracy".into(),
        title: "What was asked for and what came out".into(),
        description: format!("Answers that claim to meet the request. {}.", described.join("; ")),
        size: [COLUMN, 267.0],
        canvas,
    }
    .write_standalone(out)
}
