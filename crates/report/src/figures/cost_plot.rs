//! Errors against times on logarithmic axes: points, lines, and labels that keep clear of them.

use crate::draw::axes::{PlotAxis, PlotFrame};
use crate::draw::labels::{place_near, push_apart};
use crate::draw::palette::{BAND, INK2, LINE, Stroke, Style};
use crate::draw::svg::{COLUMN, Canvas, Rect, Text, text_width};
use crate::numbers::{percent, time_tick};

/// A figure of errors against times. Places are in units of the figure.
#[derive(Debug)]
pub struct CostPlot {
    pub(super) frame: PlotFrame,
    pub(super) canvas: Canvas,
    /// What labels keep clear of.
    pub(super) taken: Vec<Rect>,
    /// The longest level part of the front.
    level: Option<[[f64; 2]; 2]>,
}

/// The name of something in the figure.
#[derive(Debug, Clone, Copy)]
pub struct CostLabel<'a> {
    /// The name.
    pub text: &'a str,
    /// Style of what it names.
    pub style: Style,
    /// Bold.
    pub bold: bool,
    /// In the smaller type of notes.
    pub small: bool,
    /// How far below its line it stands right of its place; `None`: near its place, where there is room.
    pub beside: Option<f64>,
}

impl CostPlot {
    /// Axes over these seconds and errors, with titles; errors up to `floor`, the uncertainty of the truth (a fraction),
    /// are shaded. The axis of errors is in per cent where there is a floor.
    pub fn new(limits: [[f64; 2]; 2], titles: [&str; 2], floor: Option<f64>) -> Self {
        let room = 66.0; // for labels right of the frame
        let frame = [44.0, 12.0, COLUMN - room, 250.0];
        Self::framed(frame, limits, titles, floor.map(|floor| (floor, "truth’s")))
    }

    /// The same in a plot box; the floor with whose uncertainty it is.
    pub(super) fn framed(
        [left, top, right, bottom]: Rect,
        [seconds, errors]: [[f64; 2]; 2],
        [x_title, y_title]: [&str; 2],
        floor: Option<(f64, &str)>,
    ) -> Self {
        let frame = PlotFrame {
            x: PlotAxis::log(seconds, [left, right]),
            y: PlotAxis::log(errors, [bottom, top]),
            x_title: x_title.into(),
            y_title: y_title.into(),
        };
        let mut canvas = Canvas::default();
        if let Some((floor, _)) = floor {
            canvas.rect([left, frame.y.at(100.0 * floor), right, bottom], BAND, 1.0);
        }
        frame.draw_with(&mut canvas, &frame.x.ticks_as(time_tick), &frame.y.ticks());
        let mut plot = Self { frame, canvas, taken: Vec::new(), level: None };
        if let Some((floor, whose)) = floor {
            let text = format!("within the {whose} own ±{}: not ranked", percent(floor));
            plot.write(&Text::start([left + 4.0, bottom - 5.0], &text, INK2).small());
        }
        plot
    }

    /// Place of a time and an error; errors below the axis on its end.
    pub fn at(&self, [seconds, error]: [f64; 2]) -> [f64; 2] {
        self.frame.at([seconds, error.max(self.frame.y.data[0])])
    }

    /// Horizontal places moved apart so that bars of equal times lie side by side.
    pub fn apart(&self, wanted: &[f64]) -> Vec<f64> {
        push_apart(wanted, 7.0, self.frame.x.units)
    }

    /// A dotted upright line at a time, with its name at the top or at the bottom.
    pub fn mark(&mut self, seconds: f64, name: &str, is_at_top: bool) {
        let (x, [bottom, top]) = (self.frame.x.at(seconds), self.frame.y.units);
        let stroke = Stroke { colour: LINE, width: 0.8, dash: "1 2" };
        self.canvas.line([x, bottom], [x, top], stroke);
        if is_at_top {
            self.taken.push([x - 1.0, top, x + 1.0, bottom]);
            self.write(&Text::end([x - 3.0, top + 4.0], name, INK2).small().halo());
        } else {
            self.write(&Text::start([x + 3.0, bottom - 5.0], name, INK2).small());
        }
    }

    /// Joins in steps of this width, at their places, the costs `[seconds, error]` that no other beats in both, down to
    /// an error of `floor`.
    pub fn front(&mut self, costs: &[[f64; 2]], places: &[[f64; 2]], floor: f64, width: f64) {
        let front = front(costs, floor);
        let step = |w: &[usize]| {
            let (a, b) = (places[w[0]], places[w[1]]);
            [a, [b[0], a[1]], b]
        };
        let steps: Vec<[f64; 2]> = front.windows(2).flat_map(step).collect();
        self.canvas.polyline(&steps, Stroke { colour: LINE, width, dash: "3 2" });
        let length = |w: &[[f64; 2]; 2]| (w[1][0] - w[0][0]).abs();
        let pairs = steps.windows(2).map(|w| [w[0], w[1]]);
        self.level = pairs.max_by(|a, b| length(a).total_cmp(&length(b)));
    }

    /// Names the front where it runs level for longest.
    pub fn name_front(&mut self) {
        let Some([a, b]) = self.level else { return };
        self.keep_clear_of(&[[a[0], a[1] - 2.0], [b[0], b[1] - 2.0]]);
        let middle = [f64::midpoint(a[0], b[0]), a[1]];
        self.place(Text::start(middle, "Pareto front", INK2).small());
    }

    /// A line through places, as wide as its style says or as `width`.
    pub fn line(&mut self, places: &[[f64; 2]], style: Style, width: Option<f64>) {
        let stroke = style.stroke();
        self.canvas.polyline(places, Stroke { width: width.unwrap_or(stroke.width), ..stroke });
        self.keep_clear_of(places);
    }

    /// A marker at a place, with a bar over the vertical places of a range.
    pub fn point(&mut self, [x, y]: [f64; 2], range: Option<[f64; 2]>, style: Style) {
        if let Some([low, high]) = range {
            self.canvas.line([x, low], [x, high], Stroke::solid(style.colour, 0.9));
            self.taken.push([x - 1.0, high.min(low), x + 1.0, low.max(high)]);
        }
        self.canvas.marker([x, y], if range.is_some() { 3.4 } else { 3.2 }, style);
        self.taken.push([x - 4.0, y - 4.0, x + 4.0, y + 4.0]);
    }

    /// A label at a place.
    pub fn label(&mut self, [x, y]: [f64; 2], label: CostLabel<'_>) {
        let CostLabel { text, style, bold, small, beside } = label;
        let size = if small { 9.0 } else { 10.0 };
        let text = Text { size, bold, ..Text::start([x, y], text, style.colour) };
        match beside {
            Some(down) => self.write(&Text { at: [x + 7.0, y + 3.4 + down], ..text }),
            None => self.place(text),
        }
    }

    /// A label near its place; where it is crowded further off, with a hairline to its place, or nowhere.
    fn place(&mut self, text: Text<'_>) {
        let at = text.at;
        let ([left, _], [bottom, top]) = (self.frame.x.units, self.frame.y.units);
        let inside = [left + 2.0, top - 6.0, COLUMN - 1.0, bottom];
        let size = [text_width(text.content, text.size, text.bold), text.size];
        let far = (0..6).flat_map(|ring| {
            let [dx, dy] = [10.0 * f64::from(ring), 9.0 * f64::from(ring)];
            [[0.0, dy], [dx, dy], [-dx, dy], [0.0, -dy], [dx, -dy], [-dx, -dy]]
        });
        for [dx, dy] in far {
            let near = [at[0] + dx, at[1] + dy];
            let Some(r) = place_near(near, size, &self.taken, inside) else { continue };
            self.taken.push(r);
            if dx.abs() + dy.abs() > 0.0 {
                let end = [at[0].clamp(r[0], r[2]), at[1].clamp(r[1], r[3])];
                self.canvas.line(at, end, Stroke::solid(text.colour, 0.5));
            }
            let at = [r[0], r[1] + 0.78 * text.size];
            self.canvas.label(&Text { at, ..text }.halo());
            return;
        }
    }

    fn write(&mut self, text: &Text<'_>) {
        self.taken.push(text.bounds());
        self.canvas.label(text);
    }

    /// Keeps labels off a line, as small boxes along it.
    fn keep_clear_of(&mut self, line: &[[f64; 2]]) {
        for w in line.windows(2) {
            let [[x1, y1], [x2, y2]] = [w[0], w[1]];
            let steps = ((x2 - x1).hypot(y2 - y1) / 3.0).ceil().max(1.0);
            for k in 0..=(steps as usize) {
                let t = k as f64 / steps;
                let (x, y) = (x1 + t * (x2 - x1), y1 + t * (y2 - y1));
                self.taken.push([x - 1.0, y - 1.0, x + 1.0, y + 1.0]);
            }
        }
    }

    /// The text of the figure as a file: `key` begins the ids inside, `title` says what it shows, `description` what it finds.
    pub fn svg(self, key: &str, title: &str, description: String) -> String {
        self.canvas.figure(key, title, description, [COLUMN, 288.0]).standalone()
    }
}

/// Indices of the points `[cost, error]` that no other beats in both, from cheap to accurate. The list stops
/// at the first point within `floor`, the uncertainty of the errors themselves: below it they
/// cannot be ranked.
fn front(points: &[[f64; 2]], floor: f64) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&a, &b| {
        let ([cost_a, error_a], [cost_b, error_b]) = (points[a], points[b]);
        cost_a.total_cmp(&cost_b).then(error_a.total_cmp(&error_b))
    });
    let mut front: Vec<usize> = Vec::new();
    for i in order {
        if front.last().is_none_or(|&last| points[i][1] < points[last][1]) {
            front.push(i);
            if points[i][1] <= floor {
                break;
            }
        }
    }
    front
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn front_is_not_beaten_and_stops_at_the_floor() {
        let points = [[1e-8, 3.0], [1e-6, 0.2], [1e-5, 0.3], [1e-3, 0.008], [1.0, 0.001]];
        assert_eq!((front(&points, 0.0), front(&points, 0.01)), (vec![0, 1, 3, 4], vec![0, 1, 3]));
    }

    proptest! {
        /// A point is on the front if and only if no other is at least as good in both and better
        /// in one; of equal points one is kept.
        #[test]
        fn front_is_pareto(points in prop::collection::vec((1u8..9, 1u8..9), 1..30)) {
            let points: Vec<[f64; 2]> =
                points.iter().map(|&(t, e)| [f64::from(t), f64::from(e)]).collect();
            let front = front(&points, 0.0);
            let beaten = |[t, e]: [f64; 2]| {
                points.iter().any(|&[u, f]| u <= t && f <= e && (u < t || f < e))
            };
            for &i in &front {
                prop_assert!(!beaten(points[i]));
            }
            for &p in points.iter().filter(|&&p| !beaten(p)) {
                // Small whole numbers.
                let equal = |q: [f64; 2]| (q[0] - p[0]).abs() + (q[1] - p[1]).abs() < 0.5;
                prop_assert_eq!(front.iter().filter(|&&i| equal(points[i])).count(), 1);
            }
        }
    }
}
