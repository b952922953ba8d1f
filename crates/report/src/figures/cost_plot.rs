//! Errors against times on logarithmic axes: points, lines, and labels that keep clear of them.

use crate::draw::axes::{PlotAxis, PlotFrame};
use crate::draw::labels::{place_near, push_apart};
use crate::draw::palette::{BAND, INK2, LINE, Stroke};
use crate::draw::svg::{COLUMN, Canvas, Rect, Text, text_width};
use crate::numbers::{percent, time_tick};
use crate::plot_styles::plot_style;

/// A figure of errors against times.
#[derive(Debug)]
pub struct CostFigure<'a> {
    /// Times (s) and errors at the ends of the axes; errors in per cent where there is a `floor`.
    pub limits: [[f64; 2]; 2],
    /// Titles of the axes.
    pub titles: [&'a str; 2],
    /// Uncertainty of the truth (a fraction): errors up to it are shaded.
    pub floor: Option<f64>,
    /// A time (s) with a dotted line, and its name.
    pub mark: Option<(f64, &'a str)>,
    /// In the order in which they are drawn.
    pub series: Vec<CostSeries>,
}

/// Costs of one kind: a line through them, a marker at each, a name at the last.
#[derive(Debug, Default)]
pub struct CostSeries {
    /// Name of a model, or of a method of the solver with its precision, by which it is drawn.
    pub style: String,
    /// Time (s) and error (a fraction) of each.
    pub costs: Vec<[f64; 2]>,
    /// Smallest and largest error: the bar of its one marker.
    pub range: Option<[f64; 2]>,
    /// A thin line without markers, not on the front.
    pub is_line: bool,
    /// Moved aside so that bars of equal times lie side by side.
    pub is_moved: bool,
    /// Its name, near the last place where there is room; may be empty.
    pub label: String,
    /// Bold.
    pub bold: bool,
    /// Small type below the name. With a note, and for a line, the name stands directly right of the last place.
    pub note: String,
}

impl CostFigure<'_> {
    /// The text of the figure as a file: `key` begins the ids inside, `title` says what it shows, `description` what it
    /// finds.
    pub fn svg(&self, key: &str, title: &str, description: String) -> String {
        let room = 66.0; // for labels right of the frame
        let frame = [44.0, 12.0, COLUMN - room, 250.0];
        let floor = self.floor.map(|floor| (floor, "truth’s"));
        let mut plot = CostPlot::framed(frame, self.limits, self.titles, floor);
        if let Some((seconds, name)) = self.mark {
            plot.mark(seconds, name, floor.is_some());
        }
        let scale = if floor.is_some() { 100.0 } else { 1.0 };
        let mut places: Vec<Vec<[f64; 2]>> = Vec::new();
        for series in &self.series {
            places.push(series.costs.iter().map(|[s, e]| plot.at([*s, scale * e])).collect());
        }
        let moved = self.series.iter().zip(&mut places).filter(|(series, _)| series.is_moved);
        let mut moved: Vec<&mut [f64; 2]> = moved.flat_map(|(_, places)| places).collect();
        let wanted: Vec<f64> = moved.iter().map(|place| place[0]).collect();
        for (place, x) in moved.iter_mut().zip(push_apart(&wanted, 7.0, plot.frame.x.units)) {
            place[0] = x;
        }
        let each = || self.series.iter().zip(&places);
        let marked = || each().filter(|(series, _)| !series.is_line);
        let costs: Vec<[f64; 2]> = marked().flat_map(|(s, _)| s.costs.iter().copied()).collect();
        let at: Vec<[f64; 2]> = marked().flat_map(|(_, places)| places.iter().copied()).collect();
        plot.front(&costs, &at, self.floor.unwrap_or(0.0), 1.6);
        for (series, places) in each() {
            plot.series(series, places, scale);
        }
        for (series, places) in each().filter(|(series, _)| !series.label.is_empty()) {
            if let Some(place) = places.last() {
                plot.label(series, *place);
            }
        }
        // Of medians with bars the front is named; of many points it is seen.
        if floor.is_some() {
            plot.name_front();
        }
        plot.canvas.figure(key, title, description, [COLUMN, 288.0]).standalone()
    }
}

/// A figure being drawn; places are in its own units.
pub(super) struct CostPlot {
    pub(super) frame: PlotFrame,
    pub(super) canvas: Canvas,
    /// What labels keep clear of.
    pub(super) taken: Vec<Rect>,
    /// The longest level part of the front.
    level: Option<[[f64; 2]; 2]>,
}

impl CostPlot {
    /// Axes in a plot box; the floor with whose uncertainty it is.
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
    fn at(&self, [seconds, error]: [f64; 2]) -> [f64; 2] {
        self.frame.at([seconds, error.max(self.frame.y.data[0])])
    }

    /// A dotted upright line at a time, with its name at the top or at the bottom.
    fn mark(&mut self, seconds: f64, name: &str, is_at_top: bool) {
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
    pub(super) fn front(
        &mut self,
        costs: &[[f64; 2]],
        places: &[[f64; 2]],
        floor: f64,
        width: f64,
    ) {
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
    fn name_front(&mut self) {
        let Some([a, b]) = self.level else { return };
        self.keep_clear_of(&[[a[0], a[1] - 2.0], [b[0], b[1] - 2.0]]);
        let middle = [f64::midpoint(a[0], b[0]), a[1]];
        self.place(Text::start(middle, "Pareto front", INK2).small());
    }

    /// A line through places, and a marker with its bar at each.
    fn series(&mut self, series: &CostSeries, places: &[[f64; 2]], scale: f64) {
        let style = plot_style(&series.style, 0);
        let stroke = style.stroke();
        let width = if series.is_line { 1.0 } else { stroke.width };
        self.canvas.polyline(places, Stroke { width, ..stroke });
        self.keep_clear_of(places);
        for &[x, y] in places.iter().filter(|_| !series.is_line) {
            if let Some(range) = series.range {
                let [low, high] = range.map(|error| self.at([1.0, scale * error])[1]);
                self.canvas.line([x, low], [x, high], Stroke::solid(style.colour, 0.9));
                self.taken.push([x - 1.0, high.min(low), x + 1.0, low.max(high)]);
            }
            self.canvas.marker([x, y], if series.range.is_some() { 3.4 } else { 3.2 }, style);
            self.taken.push([x - 4.0, y - 4.0, x + 4.0, y + 4.0]);
        }
    }

    /// The name of a series at the last of its places.
    fn label(&mut self, series: &CostSeries, [x, y]: [f64; 2]) {
        let colour = plot_style(&series.style, 0).colour;
        let text = Text { bold: series.bold, ..Text::start([x, y], &series.label, colour) };
        if !series.is_line && series.note.is_empty() {
            return self.place(text);
        }
        let at = [x + 7.0, y + 3.4];
        self.write(&Text { at, ..text });
        if !series.note.is_empty() {
            let at = [at[0], at[1] + 10.0];
            self.write(&Text { at, content: &series.note, ..text }.small());
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
        /// No other is at least as good in both and better in one; of equal points one is kept.
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
