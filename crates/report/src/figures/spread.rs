//! Figures over many maps: every curve at once, the errors of each model, distributions.

use crate::digest::Quantiles;
use crate::draw::axes::{PlotAxis, PlotFrame};
use crate::draw::palette::{BAND, DETERMINISTIC, INK, INK2, LINE, Stroke, Style};
use crate::draw::svg::{COLUMN, Canvas, Figure, Rect, Text};
use crate::lines::min_max;
use crate::numbers::{SPACE, Unit, signed_percent, significant, unit_for};

/// Area over load of many maps, `[load, area fraction]` each.
pub(crate) struct Curves {
    pub each: Vec<Vec<[f64; 2]>>,
    /// What the loads are that all maps share, and its units; `None` if they are `p / (E* g)`.
    pub shared: Option<(&'static str, &'static [Unit])>,
}

impl Curves {
    /// Quantiles of the area, `[load, 10 %, median, 90 %]`, where at least half of the curves reach.
    pub(crate) fn bands(&self) -> Vec<[f64; 4]> {
        let loads = || self.each.iter().flatten().map(|p| p[0]).filter(|x| *x > 0.0);
        let Some((low, high)) = min_max(loads()) else { return Vec::new() };
        let mut grid: Vec<f64> = if self.shared.is_some() {
            self.each.first().map_or_else(Vec::new, |c| c.iter().map(|p| p[0]).collect())
        } else {
            let count = 24;
            (0..=count).map(|i| low * (high / low).powf(f64::from(i) / f64::from(count))).collect()
        };
        grid.dedup();
        let band = |load: f64| -> Option<[f64; 4]> {
            let areas: Vec<f64> = self.each.iter().filter_map(|c| between(c, load)).collect();
            if 2 * areas.len() < self.each.len() {
                return None;
            }
            let spread = Quantiles::of(areas.into_iter())?;
            Some([load, spread.quantile(0.1), spread.median(), spread.quantile(0.9)])
        };
        grid.into_iter().filter_map(band).collect()
    }
}

/// The area at a load, straight between neighbours on logarithmic axes.
fn between(curve: &[[f64; 2]], load: f64) -> Option<f64> {
    let near = |x: f64| (x / load - 1.0).abs() < 1e-9;
    if let Some(point) = curve.iter().find(|p| near(p[0])) {
        return Some(point[1]);
    }
    let pair = curve.windows(2).find(|w| w[0][0] <= load && load <= w[1][0])?;
    let ([x0, y0], [x1, y1]) = (pair[0], pair[1]);
    let part = (load / x0).ln() / (x1 / x0).ln();
    (y0 > 0.0 && y1 > 0.0).then(|| y0 * (y1 / y0).powf(part))
}

pub(crate) fn curves(curves: &Curves) -> Figure {
    const FRAME: Rect = [44.0, 12.0, COLUMN - 14.0, 246.0];
    let points = || curves.each.iter().flatten().filter(|p| p[0] > 0.0 && p[1] > 0.0);
    let limits = |of: fn(&[f64; 2]) -> f64| {
        let (low, high) = min_max(points().map(of)).unwrap_or((f64::INFINITY, 0.0));
        if low < high { [low, high] } else { [0.5 * low.min(high), 2.0 * high.max(low)] }
    };
    let [low, high] = limits(|p| p[0]);
    let shared = curves.shared.map(|(name, units)| (name, unit_for((low * high).sqrt(), units)));
    let scale = shared.map_or(1.0, |(_, unit)| unit.scale);
    let x_title = shared.map_or_else(
        || "Load p / (E* h′rms)".to_owned(),
        |(name, unit)| format!("{name} ({})", unit.name),
    );
    let [x_low, x_high] = [low, high].map(|x| x / scale);
    let [y_low, y_high] = limits(|p| p[1]).map(|a| 100.0 * a);
    let data = [[x_low / 1.15, x_high * 1.15], [y_low / 1.3, (y_high * 1.3).min(110.0)]];
    let axes = data.map(PlotAxis::log);
    let frame = PlotFrame::new(FRAME, axes, [&x_title, "Real contact area (%)"]);
    let mut canvas = frame.canvas();
    let place = |p: &[f64; 2]| frame.at([p[0] / scale, 100.0 * p[1]]);
    let bands = curves.bands();
    let edge = |k: usize| bands.iter().map(move |b| [b[0], b[k]]);
    let outline: Vec<[f64; 2]> =
        edge(1).chain(edge(3).collect::<Vec<_>>().into_iter().rev()).map(|p| place(&p)).collect();
    canvas.area(&outline, LINE, 0.25);
    for curve in &curves.each {
        let line: Vec<[f64; 2]> =
            curve.iter().filter(|p| p[0] > 0.0 && p[1] > 0.0).map(place).collect();
        canvas.polyline(&line, Stroke::solid(LINE, 0.35));
    }
    let median: Vec<[f64; 2]> = edge(2).map(|p| place(&p)).collect();
    canvas.polyline(&median, Stroke::solid(DETERMINISTIC, 1.8));
    let said = bands.iter().step_by((bands.len() / 3).max(1)).map(|[load, low, mid, high]| {
        let load = shared.map_or_else(
            || significant(*load, 2),
            |(_, unit)| format!("{}{SPACE}{}", significant(load / scale, 3), unit.name),
        );
        let [low, mid, high] = [low, mid, high].map(|area| significant(100.0 * area, 3));
        format!("at {load} median {mid}{SPACE}%, 10th–90th percentile {low} to {high}{SPACE}%")
    });
    let description = format!("Log-log plot: {}.", said.collect::<Vec<_>>().join("; "));
    canvas.figure("Real contact area of every map over the load", description, [COLUMN, 282.0])
}

pub(crate) struct Strip {
    pub label: String,
    pub look: Style,
    /// Signed relative errors.
    pub errors: Quantiles,
}

/// For each model a line over the 10th–90th percentile, a bar over the interquartile range, a mark at the median.
pub(crate) fn strips(strips: &[Strip]) -> Figure {
    const LEFT: f64 = 84.0;
    const TOP: f64 = 14.0;
    const PITCH: f64 = 26.0;
    let bottom = TOP + PITCH * strips.len().max(1) as f64;
    let low = strips.iter().map(|s| s.errors.quantile(0.1)).fold(-0.2, f64::min);
    let high = strips.iter().map(|s| s.errors.quantile(0.9)).fold(0.2, f64::max);
    // Beyond this nobody asks by how much; what lies there is named at the edge.
    let (low, high) = (low.max(-1.0), high.min(2.0));
    let room = 0.06 * (high - low);
    let [x0, x1] = [100.0 * (low - room), 100.0 * (high + room)];
    let axes = [[x0, x1], [0.0, 1.0]].map(PlotAxis::linear);
    let titles = ["Error of the area at the headline (%)", ""];
    let frame = PlotFrame::new([LEFT, TOP, COLUMN - 10.0, bottom], axes, titles);
    let mut canvas = Canvas::default();
    let within = [frame.x.at((-10.0_f64).max(x0)), frame.x.at(10.0_f64.min(x1))];
    canvas.rect([within[0], TOP, within[1], bottom], BAND, 1.0);
    frame.draw_with(&mut canvas, &frame.x.ticks(), &[]);
    canvas.line([frame.x.at(0.0), TOP], [frame.x.at(0.0), bottom], Stroke::solid(LINE, 1.0));
    let mut said = Vec::new();
    for (row, strip) in strips.iter().enumerate() {
        let y = TOP + PITCH * (row as f64 + 0.5);
        let at = |part: f64| frame.x.at((100.0 * strip.errors.quantile(part)).clamp(x0, x1));
        let colour = strip.look.colour;
        canvas.line([at(0.1), y], [at(0.9), y], Stroke::solid(colour, 1.0));
        canvas.rect([at(0.25), y - 4.0, at(0.75), y + 4.0], colour, 0.35);
        let median = 100.0 * strip.errors.median();
        if (x0..=x1).contains(&median) {
            canvas.marker([at(0.5), y], 3.6, strip.look);
        } else {
            let text = format!("{} ▶", signed_percent(median / 100.0));
            let end = [COLUMN - 12.0, y - 6.0];
            canvas.label(&Text::end(end, &text, colour).small());
        }
        canvas.text(&Text::end([LEFT - 6.0, y + 3.4], &strip.label, colour));
        said.push(format!("{} {}", strip.label, strip.errors.words(signed_percent)));
    }
    let (title, size) = ("Error of each closed form over the maps", [COLUMN, bottom + 34.0]);
    canvas.figure(title, format!("{}.", said.join("; ")), size)
}

/// Distributions side by side, three in a row: of each "Quantity (unit)" its numbers, in that unit.
pub(crate) fn histograms(all: &[(String, Quantiles)]) -> Figure {
    const PER_ROW: usize = 3;
    const PANEL: [f64; 2] = [196.0, 92.0];
    const PITCH: [f64; 2] = [234.0, 140.0];
    const LEFT: f64 = 30.0;
    let rows = all.len().div_ceil(PER_ROW).max(1);
    let mut canvas = Canvas::default();
    let mut said = Vec::new();
    for (i, (title, values)) in all.iter().enumerate() {
        let left = LEFT + PITCH[0] * (i % PER_ROW) as f64;
        let top = 10.0 + PITCH[1] * (i / PER_ROW) as f64;
        histogram(title, values, [left, top, left + PANEL[0], top + PANEL[1]], &mut canvas);
        said.push(format!("{title}: {}", values.words(|v| significant(v, 3))));
    }
    let size = [LEFT + PITCH[0] * 3.0 - 24.0, PITCH[1] * rows as f64 + 4.0];
    canvas.figure("Distributions over the maps", format!("{}.", said.join("; ")), size)
}

/// Classes of equal width, on a logarithmic axis if the numbers are wide.
fn histogram(title: &str, values: &Quantiles, inside: Rect, canvas: &mut Canvas) {
    let [left, top, right, bottom] = inside;
    let [mut low, mut high] = values.ends();
    if high <= low {
        let room = if low == 0.0 { 1.0 } else { 0.1 * low.abs() };
        (low, high) = (low - room, high + room);
    }
    let axis = if values.is_wide() { PlotAxis::log } else { PlotAxis::linear };
    let x = PlotAxis { units: [left, right], ..axis([low, high]) };
    // Twice the cube root, after Rice; no class without a name.
    let classes = ((2.0 * (values.sorted.len() as f64).cbrt()).ceil() as usize).clamp(5, 24);
    let mut counts = vec![0_usize; classes];
    for &value in &values.sorted {
        let part = (x.at(value) - left) / (right - left);
        counts[((part * classes as f64) as usize).min(classes - 1)] += 1;
    }
    let most = counts.iter().copied().max().unwrap_or(1).max(1);
    let y = PlotAxis::linear([0.0, most as f64 * 1.08]);
    let frame = PlotFrame::new(inside, [x, y], [title, ""]);
    let crowded = frame.x.ticks();
    let keep = crowded.len().div_ceil(5).max(1);
    let x_ticks: Vec<_> = crowded.into_iter().step_by(keep).collect();
    let whole = |(v, _): &(f64, String)| (v - v.round()).abs() < 1e-9;
    let y_ticks: Vec<_> = frame.y.ticks().into_iter().filter(whole).collect();
    frame.draw_with(canvas, &x_ticks, &y_ticks);
    let step = (right - left) / classes as f64;
    for (i, &count) in counts.iter().enumerate().filter(|(_, count)| **count > 0) {
        let at = left + step * i as f64;
        canvas.rect([at + 0.5, frame.y.at(count as f64), at + step - 0.5, bottom], INK2, 0.55);
    }
    let median = frame.x.at(values.median());
    canvas.line([median, top], [median, bottom], Stroke { colour: INK, width: 1.2, dash: "3 2" });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bands_are_quantiles_of_the_areas_at_one_load() {
        let each: Vec<Vec<[f64; 2]>> =
            (0..=10).map(|i| vec![[1.0, f64::from(i)], [100.0, 100.0 * f64::from(i)]]).collect();
        let curves = Curves { each, shared: Some(("Load", &[])) };
        assert_eq!(curves.bands(), [[1.0, 1.0, 5.0, 9.0], [100.0, 100.0, 500.0, 900.0]]);
        let line = [[1.0, 2.0], [100.0, 200.0]];
        assert!((between(&line, 10.0).unwrap() - 20.0).abs() < 1e-12);
        assert_eq!((between(&line, 0.5), between(&line, 101.0)), (None, None));
    }
}
