//! The figure of the study of error bars: where the truth lay, in half widths, by class of surface.

use report::draw::axes::Axis;
use report::draw::palette::{BAND, DETERMINISTIC, INK2, LINE, Look, Marker};
use report::draw::svg::{Anchor, COLUMN, Canvas, Figure, Stroke, Text};
use std::io::{self, Write};

/// Signed errors over half widths of one class of surfaces.
#[derive(Debug, Clone)]
pub struct BarErrors {
    /// Name of the class.
    pub class: String,
    /// (answer − truth) / half width.
    pub ratios: Vec<f64>,
}

/// Fewest half widths drawn to either side; more where a case lies beyond.
const REACH: f64 = 1.8;
/// Height of a row.
const ROW: f64 = 13.0;

/// Draws each class as a line from the 2.5th to the 97.5th percentile with its median, and every
/// case beyond its bar as a cross. The band holds what the bars promise.
///
/// # Errors
/// Whatever the writer reports.
pub fn write_budget(groups: &[(&str, Vec<BarErrors>)], out: &mut impl Write) -> io::Result<()> {
    let ratios = || groups.iter().flat_map(|(_, classes)| classes).flat_map(|c| &c.ratios);
    let reach = ratios().fold(REACH, |far, r| far.max(1.05 * r.abs()));
    let x = Axis::linear([-reach, reach], [96.0, COLUMN - 34.0]);
    let mut canvas = Canvas::default();
    let mut y = 6.0;
    let (mut inside, mut all) = (0, 0);
    let mark = Look::model(DETERMINISTIC, "", Marker::Dot, 0);
    let cross = Look::model(DETERMINISTIC, "", Marker::Cross, 0);
    for (title, classes) in groups {
        y += 12.0;
        canvas.text(&Text { bold: true, ..Text::new([4.0, y], title) });
        let top = y + 4.0;
        let bottom = top + ROW * classes.len() as f64;
        canvas.rect([x.at(-1.0), top, x.at(1.0), bottom], BAND, 1.0);
        canvas.line([x.at(0.0), top], [x.at(0.0), bottom], Stroke::solid(LINE, 0.6));
        for class in classes {
            y += ROW;
            let middle = y - 2.6;
            let mut sorted = class.ratios.clone();
            sorted.sort_by(f64::total_cmp);
            let n = sorted.len();
            canvas.text(&Text {
                colour: INK2,
                anchor: Anchor::End,
                size: 9.0,
                ..Text::new([90.0, y], &class.class)
            });
            let held = sorted.iter().filter(|r| r.abs() <= 1.0).count();
            (inside, all) = (inside + held, all + n);
            let count = format!("{held}/{n}");
            canvas.text(&Text { colour: INK2, size: 9.0, ..Text::new([COLUMN - 32.0, y], &count) });
            if n == 0 {
                continue;
            }
            let at = |part: f64| sorted[(part * (n - 1) as f64).round() as usize];
            let ends = [x.at(at(0.025)), x.at(at(0.975))];
            canvas.line([ends[0], middle], [ends[1], middle], Stroke::solid(DETERMINISTIC, 1.6));
            canvas.marker([x.at(at(0.5)), middle], 2.4, mark);
            for r in sorted.iter().filter(|r| r.abs() > 1.0) {
                canvas.marker([x.at(*r), middle], 2.2, cross);
            }
        }
        y = bottom;
    }
    let axis = y + 4.0;
    canvas.line([x.at(-reach), axis], [x.at(reach), axis], Stroke::solid(LINE, 0.8));
    let far = reach.floor() as i32;
    for tick in (-far..=far).map(f64::from) {
        canvas.line([x.at(tick), axis], [x.at(tick), axis + 3.0], Stroke::solid(LINE, 0.8));
        canvas.text(&Text {
            colour: INK2,
            anchor: Anchor::Middle,
            ..Text::new([x.at(tick), axis + 14.0], &x.tick_text(tick))
        });
    }
    canvas.text(&Text {
        anchor: Anchor::Middle,
        ..Text::new([x.at(0.0), axis + 28.0], "(Answer − truth) / stated half width")
    });
    Figure {
        key: "budget".into(),
        title: "Where the truth lay within the stated intervals".into(),
        description: format!(
            "Signed errors of area, gap and stiffness over their stated half widths by class of \
             surface; {inside} of {all} lie within."
        ),
        size: [COLUMN, axis + 34.0],
        canvas,
    }
    .write_standalone(out)
}
