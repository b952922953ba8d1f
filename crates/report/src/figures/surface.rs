//! Figures of the surface itself: distribution of heights, power spectrum.

use crate::draw::axes::{PlotAxis, PlotFrame};
use crate::draw::palette::{BAND, DETERMINISTIC, GW, INK, INK2, LINE, Stroke};
use crate::draw::svg::{COLUMN, Canvas, Figure, Rect, Text};
use crate::numbers::{METRES, SPACE, chosen, quantity, significant, unit_for};
use std::f64::consts::TAU;

const FRAME: Rect = [44.0, 12.0, COLUMN - 12.0, 194.0];
const HEIGHT: f64 = 230.0;
/// Width of a bin of heights, in rms heights.
const STEP: f64 = 0.2;

/// Heights counted in bins: all of them, and those that touch.
pub(crate) struct Histogram {
    /// Lower edge of the first bin, in rms heights above the mean.
    pub start: f64,
    /// Probability density of all heights, per rms height.
    pub all: Vec<f64>,
    pub touching: Vec<f64>,
}

impl Histogram {
    /// Lower edge, in rms heights, of the lowest bin in which something touches.
    pub(crate) fn lowest_touching(&self) -> Option<f64> {
        let lowest = self.touching.iter().position(|v| *v > 0.0)?;
        Some(self.start + STEP * lowest as f64)
    }
}

pub(crate) fn histogram(heights: &[f64], pressure: &[f64]) -> Option<Histogram> {
    let n = heights.len() as f64;
    let mean = heights[0] + heights.iter().map(|h| h - heights[0]).sum::<f64>() / n;
    let rms = (heights.iter().map(|h| (h - mean).powi(2)).sum::<f64>() / n).sqrt();
    if rms <= 0.0 {
        return None;
    }
    let bin = |h: f64| ((h - mean) / rms / STEP).floor().clamp(-60.0, 59.0) as i64;
    let (lo, hi) =
        heights.iter().fold((i64::MAX, i64::MIN), |(lo, hi), &h| (lo.min(bin(h)), hi.max(bin(h))));
    let mut all = vec![0.0; (hi - lo + 1) as usize];
    let mut touching = all.clone();
    for (i, &h) in heights.iter().enumerate() {
        let k = (bin(h) - lo) as usize;
        all[k] += 1.0 / (n * STEP);
        if pressure.get(i).is_some_and(|p| *p > 0.0) {
            touching[k] += 1.0 / (n * STEP);
        }
    }
    Some(Histogram { start: lo as f64 * STEP, all, touching })
}

/// Distribution of heights, logarithmic, with the normal curve and the part that touches.
pub(crate) fn heights(histogram: &Histogram, at: &str) -> Figure {
    const FLOOR: f64 = 1e-4;
    let Histogram { start, all, touching } = histogram;
    let end = start + STEP * all.len() as f64;
    let (left, right) = (start.clamp(-8.0, -4.0), end.clamp(4.0, 8.0));
    let top = 1.0_f64.max(1.2 * all.iter().copied().fold(0.0, f64::max));
    let axes = [PlotAxis::linear([left - 0.2, right + 0.2]), PlotAxis::log([FLOOR, top])];
    let frame = PlotFrame::new(FRAME, axes, ["Height / Sq", "Probability density"]);
    let mut canvas = frame.canvas();
    let steps = |values: &[f64]| -> Vec<[f64; 2]> {
        let bins = values.iter().enumerate().map(|(k, &v)| {
            ([start + STEP * k as f64, start + STEP * (k + 1) as f64], v.max(FLOOR))
        });
        let seen = bins.filter(|([a, b], _)| *a >= left - 0.2 && *b <= right + 0.2);
        let mut points: Vec<[f64; 2]> =
            seen.flat_map(|(ends, y)| ends.map(|x| frame.at([x, y]))).collect();
        if let (Some(first), Some(last)) = (points.first().copied(), points.last().copied()) {
            points.insert(0, [first[0], FRAME[3]]);
            points.push([last[0], FRAME[3]]);
        }
        points
    };
    canvas.area(&steps(all), LINE, 0.35);
    if histogram.lowest_touching().is_some() {
        canvas.area(&steps(touching), GW, 0.75);
    }
    // phi(x) falls below the floor at |x| = sqrt(-2 ln(floor sqrt(2 pi))).
    let reach = (-2.0 * (FLOOR * TAU.sqrt()).ln()).sqrt();
    let places = (0..=80).map(|i| reach * (f64::from(i) / 40.0 - 1.0));
    let normal = places.map(|x| frame.at([x, (-x * x / 2.0).exp() / TAU.sqrt()]));
    let normal: Vec<[f64; 2]> = normal.collect();
    canvas.polyline(&normal, Stroke::solid(DETERMINISTIC, 1.2));
    canvas.label(&Text::end(frame.at([-2.35, 0.045]), "normal", INK).halo());
    canvas.label(&Text::middle(frame.at([-0.35, 0.012]), "measured", INK2));
    let [from, to] = [*start, end].map(|edge| significant(edge, 2));
    let mut description = format!(
        "Semi-log histogram of heights from {from} to {to} rms heights with the normal curve."
    );
    if let Some(lowest) = histogram.lowest_touching() {
        let place = [FRAME[2] - 2.0, frame.y.at(0.35)];
        canvas.label(&Text::end(place, &format!("touching at {at}"), GW).halo());
        let lowest = significant(lowest, 2);
        description += &format!(" Only heights above {lowest} rms heights touch at {at}.");
    }
    canvas.figure("Height distribution", description, [COLUMN, HEIGHT])
}

/// A power spectrum, as drawn and as listed.
pub(crate) struct Spectrum {
    /// `[wavelength (m), PSD]`, long to short.
    pub points: Vec<[f64; 2]>,
    /// Hurst exponent and the wavelengths between which it was fitted (m).
    pub fit: Option<(f64, [f64; 2])>,
    /// True for the one-sided PSD of a profile (m³), which falls as f^-(1 + 2H); false for the radial
    /// one (m⁴), as q^-(2 + 2H).
    pub is_profile: bool,
}

/// Power spectral density over wavelength, long to short.
pub(crate) fn spectrum(spectrum: &Spectrum) -> Option<Figure> {
    let points: Vec<[f64; 2]> =
        spectrum.points.iter().copied().filter(|[l, c]| *l > 0.0 && *c > 0.0).collect();
    let (first, last) = (points.first()?, points.last()?);
    let highest = points.iter().map(|p| p[1]).fold(0.0, f64::max);
    // Twelve decades hold any rough surface; below that there is rounding.
    let lowest = points.iter().map(|p| p[1]).fold(f64::INFINITY, f64::min).max(1e-12 * highest);
    let unit = unit_for((first[0] * last[0]).sqrt(), METRES);
    let (power, name, symbol) = if spectrum.is_profile {
        (3, "Profile PSD", format!("Profile PSD S ({}³)", unit.name))
    } else {
        (4, "Radial power spectral density", format!("Radial PSD C ({}⁴)", unit.name))
    };
    let psd = unit.scale.powi(power); // unit of the density
    let waves = [first[0] / unit.scale, last[0] / unit.scale];
    let axes = [waves, [lowest / psd / 2.0, highest / psd * 4.0]].map(PlotAxis::log);
    let frame = PlotFrame::new(FRAME, axes, [&format!("Wavelength ({})", unit.name), &symbol]);
    let mut canvas = Canvas::default();
    if let Some((_, [short, long])) = spectrum.fit {
        let at = |l: f64| frame.x.at(l / unit.scale).clamp(FRAME[0], FRAME[2]);
        canvas.rect([at(long), FRAME[1], at(short), FRAME[3]], BAND, 0.9);
    }
    frame.draw(&mut canvas);
    let place = |[l, c]: &[f64; 2]| frame.at([l / unit.scale, c / psd]);
    let line: Vec<_> = points.iter().filter(|p| p[1] >= lowest).map(place).collect();
    canvas.polyline(&line, Stroke::solid(DETERMINISTIC, 1.4));
    let [from, to] = [first, last].map(|p| chosen(p[0], METRES));
    let what = name.to_lowercase().replace("psd", "PSD");
    let mut description = format!("Log-log {what} over wavelengths from {from} to {to}.");
    if let Some((hurst, [short, long])) = spectrum.fit {
        let slope = f64::from(2 - power) - 2.0 * hurst;
        let inside: Vec<&[f64; 2]> =
            points.iter().filter(|[l, _]| (short..=long).contains(l)).collect();
        if !inside.is_empty() {
            // The line passes above the points by a factor of 2.2, to stay visible.
            let level: f64 = inside.iter().map(|[l, c]| c.ln() + slope * l.ln()).sum::<f64>()
                / inside.len() as f64;
            let fit = |l: f64| 2.2 * (level - slope * l.ln()).exp() / psd;
            let ends = [long, short].map(|l| frame.at([l / unit.scale, fit(l)]));
            canvas.polyline(&ends, Stroke { colour: GW, width: 1.4, dash: "5 3" });
            let middle = (short * long).sqrt();
            let [x, y] = frame.at([middle / unit.scale, fit(middle)]);
            let text = format!("H = {}", significant(hurst, 2));
            canvas.label(&Text::start([x + 6.0, y - 4.0], &text, GW).halo());
        }
        let text =
            format!("fitted {}–{}", significant(long / unit.scale, 2), quantity(short, METRES, 2));
        let at = [FRAME[0] + 4.0, FRAME[3] - 5.0];
        canvas.label(&Text::start(at, &text, INK2).small().halo());
        let [long, short] = [long, short].map(|wave| quantity(wave, METRES, 2));
        let hurst = significant(hurst, 2);
        description +=
            &format!(" Between {long} and {short} it falls as a Hurst exponent of {hurst}.");
    }
    let (at, text) = ([FRAME[2] - 2.0, FRAME[1] + 8.0], format!("long{SPACE}→{SPACE}short"));
    canvas.text(&Text::end(at, &text, INK).small().halo());
    Some(canvas.figure(name, description, [COLUMN, HEIGHT]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn histogram_integrates_to_one_and_touching_to_the_area() {
        let heights: Vec<f64> = (0..1000).map(|i| f64::from(i % 100)).collect();
        let pressure: Vec<f64> = heights.iter().map(|h| (h - 89.5).max(0.0)).collect();
        let h = histogram(&heights, &pressure).unwrap();
        let sum = |v: &[f64]| v.iter().sum::<f64>() * STEP;
        assert!((sum(&h.all) - 1.0).abs() < 1e-12);
        assert!((sum(&h.touching) - 0.1).abs() < 1e-12);
        assert!(histogram(&[1.0; 9], &[0.0; 9]).is_none());
    }
}
