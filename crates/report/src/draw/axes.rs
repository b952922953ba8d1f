//! Axes: from data to figure units, ticks where a reader expects them, a frame on two sides.

use crate::draw::palette::{GRID, INK, INK2, LINE, Stroke};
use crate::draw::svg::{Canvas, Rect, Text, text_width};
use crate::numbers::{fixed, power_of_ten};

/// One axis: data `[lo, hi]` onto figure units `[start, end]`; of an axis alone onto 0 to 1.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PlotAxis {
    /// Whether equal ratios, not equal differences, are equally far apart.
    pub(crate) is_log: bool,
    pub(crate) data: [f64; 2],
    pub(crate) units: [f64; 2],
}

impl PlotAxis {
    pub(crate) fn log(data: [f64; 2]) -> Self {
        Self { is_log: true, data, units: [0.0, 1.0] }
    }

    pub(crate) fn linear(data: [f64; 2]) -> Self {
        Self { is_log: false, data, units: [0.0, 1.0] }
    }

    fn warp(&self, value: f64) -> f64 {
        if self.is_log { value.max(f64::MIN_POSITIVE).log10() } else { value }
    }

    pub(crate) fn at(&self, value: f64) -> f64 {
        let (lo, hi) = (self.warp(self.data[0]), self.warp(self.data[1]));
        self.units[0] + (self.warp(value) - lo) / (hi - lo) * (self.units[1] - self.units[0])
    }

    /// True if the value lies within the limits, rounding allowed for.
    pub(crate) fn holds(&self, value: f64) -> bool {
        let [a, b] = [self.at(self.data[0]), self.at(self.data[1])];
        let x = self.at(value);
        x.is_finite() && x >= a.min(b) - 1e-6 && x <= a.max(b) + 1e-6
    }

    /// Labelled ticks: decades over two decades or more, 1-2-5 or finer below, round steps when linear.
    pub(crate) fn major(&self) -> Vec<f64> {
        let [lo, hi] = self.ends();
        if !self.is_log {
            let step = round_step((hi - lo) / 5.0);
            let [first, last] = [(lo / step - 1e-9).ceil(), (hi / step + 1e-9).floor()];
            let all = (first as i64..=last as i64).map(|k| k as f64 * step);
            return all.filter(|&v| self.holds(v)).collect();
        }
        let decades = hi.log10() - lo.log10();
        let every = ((decades / 6.0).ceil() as i32).max(1);
        if decades >= 2.0 {
            return self.in_decades(every, &[1.0]);
        }
        // Below that the coarsest set with three that reaches both ends.
        let finer: [&[f64]; 4] = [
            &[1.0, 2.0, 5.0],
            &[1.0, 2.0, 3.0, 4.0, 6.0, 8.0],
            &[1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0],
            &[1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8, 1.9, 2.2, 2.4, 2.6, 2.8],
        ];
        // A third of the axis beyond the last tick is too much to guess.
        let reaches = |t: &[f64]| {
            let beyond = |tick: f64, end: f64| (end / tick).log10() <= decades / 3.0;
            beyond(lo, t[0]) && beyond(t[t.len() - 1], hi)
        };
        let sets =
            || finer.into_iter().map(|set| self.in_decades(every, set)).filter(|t| t.len() >= 3);
        // Less than a tenth: as on a linear axis.
        let linear = || Self { is_log: false, ..*self }.major();
        sets().find(|t| reaches(t)).or_else(|| sets().next()).unwrap_or_else(linear)
    }

    pub(crate) fn ticks(&self) -> Vec<(f64, String)> {
        self.ticks_as(|value| self.tick_text(value))
    }

    pub(crate) fn ticks_as(&self, text: impl Fn(f64) -> String) -> Vec<(f64, String)> {
        self.major().into_iter().map(|value| (value, text(value))).collect()
    }

    /// Unlabelled ticks of a logarithmic axis, 2 to 9 of every decade.
    pub(crate) fn minor(&self) -> Vec<f64> {
        if !self.is_log {
            return Vec::new();
        }
        self.in_decades(1, &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0])
    }

    /// These multiples of every n-th power of ten, as far as the axis has them.
    fn in_decades(&self, every: i32, mantissas: &[f64]) -> Vec<f64> {
        let [lo, hi] = self.ends().map(f64::log10);
        (lo.floor() as i32..=hi.ceil() as i32)
            .filter(|d| d.rem_euclid(every) == 0)
            .flat_map(|d| mantissas.iter().map(move |m| m * 10f64.powi(d)))
            .filter(|&v| self.holds(v))
            .collect()
    }

    fn ends(&self) -> [f64; 2] {
        let [a, b] = self.data;
        [a.min(b), a.max(b)]
    }

    /// How a tick is written: 0.01, 1, 100; a power only beyond 10³ or below 10⁻³.
    pub(crate) fn tick_text(&self, value: f64) -> String {
        if self.is_log {
            let e = value.log10().round() as i32;
            let is_decade = (value / 10f64.powi(e) - 1.0).abs() < 1e-9;
            if !(-3..=3).contains(&e) && is_decade {
                return power_of_ten(e);
            }
            if value < 1e-3 {
                let decade = value.log10().floor() as i32;
                let mantissa = format!("{:.2}", value / 10f64.powi(decade));
                let mantissa = mantissa.trim_end_matches(['0', '.']);
                return format!("{mantissa}\u{b7}{}", power_of_ten(decade));
            }
        }
        let decimals = (0..9)
            .find(|&d| {
                let scaled = value * 10f64.powi(d);
                (scaled - scaled.round()).abs() < 1e-6 * scaled.abs().max(1e-3)
            })
            .unwrap_or(9);
        fixed(value, decimals as usize)
    }
}

/// Room between a vertical axis and its title (units).
const TICK_ROOM: f64 = 26.0;

/// Type size at which the numbers of a vertical axis stay clear of its title.
fn tick_size<'a>(texts: impl Iterator<Item = &'a str>) -> f64 {
    let widest = texts.map(|text| text_width(text, 10.0, false)).fold(0.0, f64::max);
    if widest > TICK_ROOM { 10.0 * TICK_ROOM / widest } else { 10.0 }
}

/// 1, 2 or 5 times a power of ten, at least `about`.
pub(crate) fn round_step(about: f64) -> f64 {
    let decade = 10f64.powf(about.log10().floor());
    let mut steps = [1.0, 2.0, 5.0].into_iter().map(|m| m * decade);
    steps.find(|s| *s >= about * (1.0 - 1e-9)).unwrap_or(10.0 * decade)
}

pub(crate) struct PlotFrame {
    pub(crate) x: PlotAxis,
    /// Vertical axis; `units` run from bottom to top.
    pub(crate) y: PlotAxis,
    /// Title of the horizontal axis, "Quantity (unit)".
    pub(crate) x_title: String,
    pub(crate) y_title: String,
}

impl PlotFrame {
    /// Axes along the left and the lower side of a box, with their titles.
    pub(crate) fn new(
        [left, top, right, bottom]: Rect,
        [x, y]: [PlotAxis; 2],
        [x_title, y_title]: [&str; 2],
    ) -> Self {
        Self {
            x: PlotAxis { units: [left, right], ..x },
            y: PlotAxis { units: [bottom, top], ..y },
            x_title: x_title.into(),
            y_title: y_title.into(),
        }
    }

    pub(crate) fn at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.x.at(x), self.y.at(y)]
    }

    /// A canvas with these alone, as [`Self::draw`] draws them.
    pub(crate) fn canvas(&self) -> Canvas {
        let mut canvas = Canvas::default();
        self.draw(&mut canvas);
        canvas
    }

    /// Grid, ticks, axes, numbers and titles.
    pub(crate) fn draw(&self, canvas: &mut Canvas) {
        self.draw_with(canvas, &self.x.ticks(), &self.y.ticks());
    }

    /// The same with ticks chosen by the caller.
    pub(crate) fn draw_with(
        &self,
        canvas: &mut Canvas,
        x_ticks: &[(f64, String)],
        y_ticks: &[(f64, String)],
    ) {
        let [left, right] = self.x.units;
        let [bottom, top] = self.y.units;
        let xs: Vec<f64> = x_ticks.iter().map(|(v, _)| self.x.at(*v)).collect();
        let ys: Vec<f64> = y_ticks.iter().map(|(v, _)| self.y.at(*v)).collect();
        let down = |x: f64, from: f64, to: f64| [x, from, x, to];
        let across = |y: f64, from: f64, to: f64| [from, y, to, y];
        let mut grid: Vec<[f64; 4]> = ys.iter().map(|&y| across(y, left, right)).collect();
        grid.extend(xs.iter().map(|&x| down(x, top, bottom)));
        canvas.ticks(&grid, Stroke::solid(GRID, 0.6));

        let minor = self.x.minor().into_iter().map(|v| down(self.x.at(v), bottom, bottom + 2.0));
        let left_minor = self.y.minor().into_iter().map(|v| across(self.y.at(v), left - 2.0, left));
        let minor: Vec<[f64; 4]> = minor.chain(left_minor).collect();
        canvas.ticks(&minor, Stroke::solid(LINE, 0.4));
        let mut major: Vec<[f64; 4]> = xs.iter().map(|&x| down(x, bottom, bottom + 3.5)).collect();
        major.extend(ys.iter().map(|&y| across(y, left - 3.0, left)));
        canvas.ticks(&major, Stroke::solid(LINE, 0.6));
        let sides = [across(bottom, left, right), down(left, top, bottom)];
        canvas.ticks(&sides, Stroke::solid(LINE, 0.8));

        for (&x, (_, text)) in xs.iter().zip(x_ticks) {
            canvas.text(&Text::middle([x, bottom + 13.0], text, INK2));
        }
        let size = tick_size(y_ticks.iter().map(|(_, text)| text.as_str()));
        for (&y, (_, text)) in ys.iter().zip(y_ticks) {
            canvas.text(&Text { size, ..Text::end([left - 5.0, y + 3.4], text, INK2) });
        }
        let at = [f64::midpoint(left, right), bottom + 29.0];
        canvas.text(&Text::middle(at, &self.x_title, INK));
        let at = [left - 34.0, f64::midpoint(top, bottom)];
        canvas.upright(&Text::middle(at, &self.y_title, INK));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn log_ticks_are_decades_or_one_two_five() {
        let wide = PlotAxis::log([0.25, 250.0]);
        assert_eq!(wide.major(), [1.0, 10.0, 100.0]);
        let narrow = PlotAxis::log([0.08, 3.0]);
        assert_eq!(narrow.major().len(), 5); // 0.1 0.2 0.5 1 2
        assert_eq!(narrow.tick_text(0.2), "0.2");
        // Coarser sets would leave the part above 1 to be guessed.
        let last = PlotAxis::log([0.49, 1.93]).major().pop();
        assert_eq!(last, Some(1.5));
        assert_eq!(wide.tick_text(1e-6), "10⁻⁶");
        assert!((wide.at(25.0_f64.sqrt() * 0.5) - 1.0 / 3.0).abs() < 1e-11);
    }

    #[test]
    fn numbers_of_a_vertical_axis_stay_clear_of_its_title() {
        for (texts, fits) in [(&["0.1", "100"][..], true), (&["0.000 02", "500 000"], false)] {
            let size = tick_size(texts.iter().copied());
            assert_eq!(size >= 10.0, fits, "{texts:?}");
            for text in texts {
                assert!(text_width(text, size, false) <= TICK_ROOM + 1e-9, "{text} at {size}");
            }
        }
    }

    #[test]
    fn linear_ticks_are_round_and_inside() {
        let axis = PlotAxis::linear([-43.0, 22.0]);
        assert_eq!(axis.major(), [-40.0, -20.0, 0.0, 20.0]);
        assert_eq!(axis.tick_text(-20.0), "\u{2212}20");
    }
}
