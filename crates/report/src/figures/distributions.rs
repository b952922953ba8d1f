//! How pressure, gap and contact spots are distributed, at one load or at every load on the same axes.

use crate::draw::axes::{PlotAxis, PlotFrame};
use crate::draw::palette::{DETERMINISTIC, INK2, PERSSON, Stroke};
use crate::draw::svg::{COLUMN, Canvas, Figure, Rect, Text};
use crate::numbers::{AREAS, METRES, SPACE, Unit, percent, quantity, significant, unit_for};
use contact_compare::{Distributions, GapDistribution, PressureHistogram, SpotDistribution};
use serde_json::{Value, json};
use std::f64::consts::{FRAC_PI_2, PI};

const FRAME: Rect = [44.0, 12.0, COLUMN - 14.0, 196.0];
const HEIGHT: f64 = 232.0;
/// Room for the longer label of the spots.
const ROOM: f64 = 66.0;

pub(crate) struct DistributionFigure {
    title: &'static str,
    /// Axes that hold all of them; `None` without any.
    axes: fn(&[&Distributions]) -> Option<Axes>,
    marks: fn(&mut Canvas, &Axes, &Distributions),
    /// What is the same at every load, above the marks.
    over: fn(&mut Canvas, &Axes),
    description: fn(&Distributions) -> Option<String>,
}

pub(crate) const PRESSURE: DistributionFigure = DistributionFigure {
    title: "Distribution of the pressure",
    axes: pressure_axes,
    marks: pressure,
    over: persson,
    description: |found| Some(of_pressure(&found.pressure)),
};

pub(crate) const SPOTS: DistributionFigure = DistributionFigure {
    title: "Contact spots by their area",
    axes: spot_axes,
    marks: spots,
    over: |_, _| (),
    description: |found| Some(of_spots(&found.spots)),
};

/// Share of the nominal area with less gap.
pub(crate) const GAP: DistributionFigure = DistributionFigure {
    title: "Distribution of the gap",
    axes: gap_axes,
    marks: gap,
    over: |_, _| (),
    description: |found| Some(of_gap(found.gap.as_ref()?, 1.0 - found.pressure.apart)),
};

impl DistributionFigure {
    pub(crate) fn is_in(&self, found: &Distributions) -> bool {
        (self.description)(found).is_some()
    }

    /// Of one load; `None` if it has no such distribution.
    pub(crate) fn figure(&self, found: &Distributions) -> Option<Figure> {
        let axes = (self.axes)(&[found])?;
        let mut canvas = axes.frame.canvas();
        (self.marks)(&mut canvas, &axes, found);
        (self.over)(&mut canvas, &axes);
        let description = (self.description)(found)?;
        Some(canvas.figure(self.title, description, [COLUMN, HEIGHT]))
    }

    /// What the script draws at each load, on axes wide enough for all of them; at a load without a distribution `why`.
    pub(crate) fn moving(&self, loads: &[Option<&Distributions>], why: &str) -> Option<Value> {
        let there: Vec<&Distributions> =
            loads.iter().flatten().copied().filter(|d| self.is_in(d)).collect();
        let axes = (self.axes)(&there)?;
        let drawn = |draw: &dyn Fn(&mut Canvas)| {
            let mut canvas = Canvas::default();
            draw(&mut canvas);
            canvas.body
        };
        let middle = [f64::midpoint(FRAME[0], FRAME[2]), f64::midpoint(FRAME[1], FRAME[3])];
        let none = Text::middle(middle, why, INK2);
        let of = |load: Option<&Distributions>| {
            let found = load.filter(|d| self.is_in(d));
            let marks = drawn(&|canvas| match found {
                Some(found) => (self.marks)(canvas, &axes, found),
                None => canvas.text(&none),
            });
            let title = found.and_then(self.description);
            json!({ "marks": marks, "title": title.unwrap_or_else(|| why.to_owned()) })
        };
        Some(json!({
            "under": drawn(&|canvas| axes.frame.draw(canvas)),
            "over": drawn(&|canvas| (self.over)(canvas, &axes)),
            "loads": loads.iter().copied().map(of).collect::<Vec<_>>(),
        }))
    }
}

/// The plot box, and the unit of its horizontal axis.
struct Axes {
    frame: PlotFrame,
    unit: Unit,
}

impl Axes {
    /// Shares (%) over a quantity.
    fn shares(data: [f64; 2], [x, y]: [&str; 2], unit: Unit) -> Self {
        let axes = [PlotAxis::log(data), PlotAxis::linear([0.0, 105.0])];
        Self { frame: PlotFrame::new(FRAME, axes, [&format!("{x} ({})", unit.name), y]), unit }
    }
}

fn highest(values: impl Iterator<Item = f64>) -> Option<f64> {
    values.reduce(f64::max)
}

/// Edges of the classes and densities, both in units of the mean pressure in contact.
fn over_the_mean(found: &PressureHistogram) -> (Vec<f64>, Vec<f64>) {
    let scale = found.mean / (1.0 - found.apart);
    let edges = found.edges.iter().map(|p| p / found.mean).collect();
    (edges, found.density.iter().map(|d| d * scale).collect())
}

fn pressure_axes(all: &[&Distributions]) -> Option<Axes> {
    let right = |found: &PressureHistogram| {
        let (edges, _) = over_the_mean(found);
        // Beyond this less than 1/1000 of the contact lies.
        let last = found.above.iter().position(|a| *a < 1e-3 * (1.0 - found.apart));
        edges[last.unwrap_or(edges.len() - 1).max(1)]
    };
    let right = highest(all.iter().map(|d| right(&d.pressure)))?.max(2.5);
    let top = highest(all.iter().flat_map(|d| over_the_mean(&d.pressure).1))?.max(0.8);
    let axes = [[0.0, right], [0.0, 1.1 * top]].map(PlotAxis::linear);
    let titles = ["Pressure over its mean in contact", "Density in contact"];
    let frame = PlotFrame::new(FRAME, axes, titles);
    Some(Axes { frame, unit: Unit { name: "", scale: 1.0 } })
}

fn pressure(canvas: &mut Canvas, Axes { frame, .. }: &Axes, found: &Distributions) {
    let (edges, density) = over_the_mean(&found.pressure);
    let right = frame.x.data[1];
    let seen = edges.windows(2).zip(&density).filter(|(edge, d)| **d > 0.0 && edge[0] < right);
    let bars = seen.map(|(edge, density)| {
        let [left, top] = frame.at([edge[0], *density]);
        [left + 0.4, top, frame.x.at(edge[1].min(right)) - 0.4, FRAME[3]]
    });
    canvas.bars(&bars.collect::<Vec<_>>(), INK2, 0.5);
}

/// Persson's density at a light load, `(π/2) x exp(−π x²/4)`, which has no parameter there.
fn density(x: f64) -> f64 {
    FRAC_PI_2 * x * (-0.25 * PI * x * x).exp()
}

fn persson(canvas: &mut Canvas, Axes { frame, .. }: &Axes) {
    let right = frame.x.data[1];
    let places = (0..=120).map(|i| right * f64::from(i) / 120.0);
    let line: Vec<[f64; 2]> = places.map(|x| frame.at([x, density(x)])).collect();
    let at = frame.at([2.0, density(2.0)]);
    let label = Text::start([at[0] + 6.0, at[1] - 8.0], "Persson", PERSSON).halo();
    canvas.series("persson", |canvas| {
        canvas.polyline(&line, Stroke { colour: PERSSON, width: 1.5, dash: "6 3" });
        canvas.label(&label);
    });
}

fn of_pressure(found: &PressureHistogram) -> String {
    let (edges, _) = over_the_mean(found);
    format!(
        "Density of the pressure over the contact; {} of the nominal area has none. Highest class at {} of \
         the mean pressure in contact.",
        percent(found.apart),
        significant(edges[edges.len() - 1], 2)
    )
}

fn gap_axes(all: &[&Distributions]) -> Option<Axes> {
    let each = || all.iter().filter_map(|d| d.gap.as_ref());
    let widest = highest(each().map(|g| g.gaps[g.gaps.len() - 1]))?;
    let least = each().map(|g| g.gaps[0]).reduce(f64::min)?;
    let unit = unit_for(highest(each().map(|g| g.mean))?, METRES);
    let gaps = [least / unit.scale, 1.1 * widest / unit.scale];
    Some(Axes::shares(gaps, ["Gap", "Nominal area with less gap (%)"], unit))
}

/// Share of the nominal area that stands less than a gap apart; from below, what touches.
fn gap(canvas: &mut Canvas, Axes { frame, unit }: &Axes, found: &Distributions) {
    let touching = 1.0 - found.pressure.apart;
    let Some(found) = &found.gap else { return };
    let level = frame.y.at(100.0 * touching);
    canvas.rect([FRAME[0], level, FRAME[2], FRAME[3]], INK2, 0.5);
    let of = |(gap, share): (&f64, &f64)| frame.at([gap / unit.scale, 100.0 * share]);
    let line: Vec<[f64; 2]> = found.gaps.iter().zip(&found.below).map(of).collect();
    canvas.polyline(&line, Stroke::solid(DETERMINISTIC, 1.8));
    canvas.label(&Text::end([FRAME[2] - 4.0, level - 5.0], "touches", INK2).halo());
}

fn of_gap(found: &GapDistribution, touching: f64) -> String {
    let gaps = [found.mean, found.gaps[found.gaps.len() - 1]];
    let ([mean, most], touches) = (gaps.map(|gap| quantity(gap, METRES, 2)), percent(touching));
    format!(
        "{touches} of the nominal area touches. Elsewhere the bodies stand {mean} apart in the mean, {most} at most."
    )
}

fn spot_axes(all: &[&Distributions]) -> Option<Axes> {
    let longest = all.iter().map(|d| &d.spots.areas).max_by_key(|areas| areas.len())?;
    let unit = unit_for(longest[longest.len() / 2], AREAS);
    let [low, high] = [longest[0], longest[longest.len() - 1]].map(|a| a / unit.scale);
    let areas = [low / 1.1, high.max(2.0 * low) * 1.1];
    Some(Axes::shares(areas, ["Spot area", "In spots at least as large (%)"], unit))
}

/// Share of the contact area, and of the number of spots, in spots of at least an area.
fn spots(canvas: &mut Canvas, Axes { frame, unit }: &Axes, found: &Distributions) {
    let found = &found.spots;
    let numbers: Vec<f64> =
        found.count_at_least.iter().map(|&n| n as f64 / found.count.max(1) as f64).collect();
    let line = |shares: &[f64]| -> Vec<[f64; 2]> {
        let of = |(a, s): (&f64, &f64)| frame.at([a / unit.scale, 100.0 * s]);
        found.areas.iter().zip(shares).map(of).collect()
    };
    let (by_number, by_area) = (line(&numbers), line(&found.area_share));
    canvas.polyline(&by_number, Stroke { colour: INK2, width: 1.4, dash: "5 3" });
    canvas.polyline(&by_area, Stroke::solid(DETERMINISTIC, 1.8));
    let place = |shares: &[f64]| shares.iter().position(|s| *s < 0.55).unwrap_or(shares.len() - 1);
    let (of_area, of_number) = (place(&found.area_share), place(&numbers));
    // On axes for all loads the line of a light one ends early: the label stands right of it.
    let (at, text) = (by_area[of_area], "of the area");
    let right = by_area[by_area.len() - 1][0] + ROOM < FRAME[2];
    let label = if right {
        Text::start([at[0] + 6.0, at[1]], text, DETERMINISTIC)
    } else {
        Text::end([FRAME[2], (at[1] - 24.0).max(FRAME[1] + 8.0)], text, DETERMINISTIC)
    };
    canvas.label(&label.bold().halo());
    let [x, y] = by_number[of_number];
    let at = [(x - 5.0).max(FRAME[0] + ROOM), y + 12.0];
    canvas.label(&Text::end(at, "of the number", INK2).halo());
}

fn of_spots(found: &SpotDistribution) -> String {
    let unit = unit_for(found.areas[found.areas.len() / 2], AREAS);
    let half = found.area_share.iter().rposition(|s| *s >= 0.5).unwrap_or(0);
    format!(
        "{} spots; at least half of the contact area is in spots of {}{SPACE}{} and more.",
        found.count,
        significant(found.areas[half] / unit.scale, 2),
        unit.name
    )
}

#[cfg(test)]
mod tests {
    /// Persson's density at a light load has integral 1 and mean 1.
    #[test]
    fn the_line_beside_the_bars_is_a_density_of_mean_one() {
        let step = 1e-3;
        let places = || (0..20_000).map(|i| (f64::from(i) + 0.5) * step);
        let whole: f64 = places().map(|x| super::density(x) * step).sum();
        let mean: f64 = places().map(|x| x * super::density(x) * step).sum();
        assert!((whole - 1.0).abs() < 1e-6 && (mean - 1.0).abs() < 1e-6);
    }
}
