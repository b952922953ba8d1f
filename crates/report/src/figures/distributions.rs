//! How pressure, gap and contact spots are distributed at the headline.

use crate::draw::axes::{Axis, Frame};
use crate::draw::palette::{DETERMINISTIC, INK2, PERSSON};
use crate::draw::svg::{Anchor, COLUMN, Canvas, Figure, Stroke, Text};
use crate::numbers::{AREAS, METRES, SPACE, percent, quantity, significant, unit_for};
use compare::{GapDistribution, PressureDistribution, SpotDistribution};
use std::f64::consts::{FRAC_PI_2, PI};

const FRAME: [f64; 4] = [44.0, 12.0, COLUMN - 14.0, 196.0];
const HEIGHT: f64 = 232.0;

/// Density of the pressure over the contact, in units of its mean; dashed: Persson's at a light load,
/// `(π/2) x exp(−π x²/4)`, which has no parameter there.
pub(crate) fn pressure(found: &PressureDistribution, key: &str) -> Figure {
    let touching = 1.0 - found.apart;
    let scale = found.mean / touching;
    let edges: Vec<f64> = found.edges.iter().map(|p| p / found.mean).collect();
    let density: Vec<f64> = found.density.iter().map(|d| d * scale).collect();
    // Beyond this less than 1/1000 of the contact lies.
    let last = found.above.iter().position(|a| *a < 1e-3 * touching);
    let right = edges[last.unwrap_or(edges.len() - 1).max(1)].max(2.5);
    let highest = density.iter().copied().fold(0.8, f64::max);
    let frame = Frame {
        x: Axis::linear([0.0, right], [FRAME[0], FRAME[2]]),
        y: Axis::linear([0.0, 1.1 * highest], [FRAME[3], FRAME[1]]),
        x_title: "Pressure over its mean in contact".into(),
        y_title: "Density in contact".into(),
    };
    let mut canvas = Canvas::default();
    frame.draw(&mut canvas);
    for (pair, value) in edges.windows(2).zip(&density) {
        let [left, top] = frame.at([pair[0], *value]);
        if *value > 0.0 && pair[0] < right {
            let end = frame.x.at(pair[1].min(right));
            canvas.rect([left + 0.4, top, end - 0.4, FRAME[3]], INK2, 0.5);
        }
    }
    let persson = |x: f64| FRAC_PI_2 * x * (-0.25 * PI * x * x).exp();
    let line: Vec<[f64; 2]> = (0..=120)
        .map(|i| right * f64::from(i) / 120.0)
        .map(|x| frame.at([x, persson(x)]))
        .collect();
    let at = frame.at([2.0, persson(2.0)]);
    let label =
        Text { colour: PERSSON, halo: true, ..Text::new([at[0] + 6.0, at[1] - 8.0], "Persson") };
    canvas.series("persson", |canvas| {
        canvas.polyline(&line, Stroke { colour: PERSSON, width: 1.5, dash: "6 3" });
        canvas.label(&label);
    });
    Figure {
        key: key.into(),
        title: "Distribution of the pressure".into(),
        description: format!(
            "Density of the pressure over the contact; {} of the nominal area has none. Highest class at {} of \
             the mean pressure in contact.",
            percent(found.apart),
            significant(edges[edges.len() - 1], 2)
        ),
        size: [COLUMN, HEIGHT],
        canvas,
    }
}

/// Share of the nominal area that stands less than a gap apart; from below, what touches.
pub(crate) fn gap(found: &GapDistribution, touching: f64, key: &str) -> Figure {
    let widest = found.gaps[found.gaps.len() - 1];
    let unit = unit_for(found.mean, METRES);
    let frame = Frame {
        x: Axis::log([found.gaps[0] / unit.scale, 1.1 * widest / unit.scale], [FRAME[0], FRAME[2]]),
        y: Axis::linear([0.0, 105.0], [FRAME[3], FRAME[1]]),
        x_title: format!("Gap ({})", unit.name),
        y_title: "Nominal area with less gap (%)".into(),
    };
    let mut canvas = Canvas::default();
    frame.draw(&mut canvas);
    let [left, level] = frame.at([found.gaps[0] / unit.scale, 100.0 * touching]);
    canvas.rect([left, level, FRAME[2], FRAME[3]], INK2, 0.5);
    let line: Vec<[f64; 2]> = found
        .gaps
        .iter()
        .zip(&found.below)
        .map(|(gap, share)| frame.at([gap / unit.scale, 100.0 * share]))
        .collect();
    canvas.polyline(&line, Stroke::solid(DETERMINISTIC, 1.8));
    canvas.label(&Text {
        colour: INK2,
        halo: true,
        anchor: Anchor::End,
        ..Text::new([FRAME[2] - 4.0, level - 5.0], "touches")
    });
    Figure {
        key: key.into(),
        title: "Distribution of the gap".into(),
        description: format!(
            "{} of the nominal area touches. Elsewhere the bodies stand {} apart in the mean, {} at most.",
            percent(touching),
            quantity(found.mean, METRES, 2),
            quantity(widest, METRES, 2)
        ),
        size: [COLUMN, HEIGHT],
        canvas,
    }
}

/// Share of the contact area, and of the number of spots, in spots of at least an area.
pub(crate) fn spots(found: &SpotDistribution, key: &str) -> Figure {
    let unit = unit_for(found.areas[found.areas.len() / 2], AREAS);
    let areas: Vec<f64> = found.areas.iter().map(|a| a / unit.scale).collect();
    let [low, high] = [areas[0], areas[areas.len() - 1].max(2.0 * areas[0])];
    let frame = Frame {
        x: Axis::log([low / 1.1, high * 1.1], [FRAME[0], FRAME[2]]),
        y: Axis::linear([0.0, 105.0], [FRAME[3], FRAME[1]]),
        x_title: format!("Spot area ({})", unit.name),
        y_title: "In spots at least as large (%)".into(),
    };
    let mut canvas = Canvas::default();
    frame.draw(&mut canvas);
    let numbers: Vec<f64> =
        found.count_at_least.iter().map(|&n| n as f64 / found.count.max(1) as f64).collect();
    let line = |shares: &[f64]| -> Vec<[f64; 2]> {
        areas.iter().zip(shares).map(|(a, s)| frame.at([*a, 100.0 * s])).collect()
    };
    let (by_number, by_area) = (line(&numbers), line(&found.area_share));
    canvas.polyline(&by_number, Stroke { colour: INK2, width: 1.4, dash: "5 3" });
    canvas.polyline(&by_area, Stroke::solid(DETERMINISTIC, 1.8));
    let place = |shares: &[f64]| shares.iter().position(|s| *s < 0.55).unwrap_or(shares.len() - 1);
    let (of_area, of_number) = (place(&found.area_share), place(&numbers));
    canvas.label(&Text {
        colour: DETERMINISTIC,
        halo: true,
        bold: true,
        anchor: Anchor::End,
        ..Text::new([FRAME[2], (by_area[of_area][1] - 24.0).max(FRAME[1] + 8.0)], "of the area")
    });
    canvas.label(&Text {
        colour: INK2,
        halo: true,
        anchor: Anchor::End,
        ..Text::new(
            [by_number[of_number][0] - 5.0, by_number[of_number][1] + 12.0],
            "of the number",
        )
    });
    let half = found.area_share.iter().rposition(|s| *s >= 0.5).unwrap_or(0);
    Figure {
        key: key.into(),
        title: "Contact spots by their area".into(),
        description: format!(
            "{} spots; at least half of the contact area is in spots of {}{SPACE}{} and more.",
            found.count,
            significant(areas[half], 2),
            unit.name
        ),
        size: [COLUMN, HEIGHT],
        canvas,
    }
}

#[cfg(test)]
mod tests {
    /// Persson's density at a light load has integral 1 and mean 1.
    #[test]
    fn the_line_beside_the_bars_is_a_density_of_mean_one() {
        let persson = |x: f64| super::FRAC_PI_2 * x * (-0.25 * super::PI * x * x).exp();
        let step = 1e-3;
        let (mut whole, mut mean) = (0.0, 0.0);
        for i in 0..20_000 {
            let x = (f64::from(i) + 0.5) * step;
            whole += persson(x) * step;
            mean += x * persson(x) * step;
        }
        assert!((whole - 1.0_f64).abs() < 1e-6 && (mean - 1.0_f64).abs() < 1e-6);
    }
}
