//! A section through a map: the surface as it is, and pressed against the flat.

use crate::draw::axes::{PlotAxis, PlotFrame};
use crate::draw::palette::{
    BAND, DETERMINISTIC, GRID, INK, INK2, LINE, PRESSURE_RAMP, Stroke, ramp_table,
};
use crate::draw::svg::{Canvas, Figure, Rect, Text, num};
use crate::numbers::{METRES, Unit, unit_for};

const SIZE: [f64; 2] = [704.0, 200.0];
const FRAME: Rect = [44.0, 8.0, 692.0, 164.0];

/// What lies along one row, heights (m) from the mean plane of the surface.
pub(crate) struct SectionCut {
    pub(crate) length: f64,
    /// Heights of the undeformed surface (m), at the middles of equal parts of the length.
    pub(crate) heights: Vec<f64>,
    /// The same at each load.
    pub(crate) loads: Vec<PressedRow>,
}

pub(crate) struct PressedRow {
    /// Height of the flat (m): the mean gap.
    pub(crate) flat: f64,
    /// Gap of each part (m), at least 0: 0 where it touches.
    pub(crate) gap: Vec<f64>,
    /// Pressure of each part as a share of the end of the ramp, at most 1; 0 where nothing touches.
    pub(crate) pressure: Vec<f64>,
}

impl SectionCut {
    fn range(&self) -> [f64; 2] {
        let all = self.heights.iter().copied().chain(self.loads.iter().map(|l| l.flat));
        all.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], z| [a.min(z), b.max(z)])
    }

    /// How many times taller than wide it is drawn.
    pub(crate) fn exaggeration(&self) -> f64 {
        let frame = self.frame();
        let wide = (FRAME[2] - FRAME[0]) / self.length;
        let [low, high] = frame.y.data;
        let tall = (FRAME[3] - FRAME[1]) / ((high - low) * self.units()[1].scale);
        tall / wide
    }

    fn units(&self) -> [Unit; 2] {
        let [low, high] = self.range();
        [self.length, high.abs().max(low.abs())].map(|metres| unit_for(metres, METRES))
    }

    fn frame(&self) -> PlotFrame {
        let ([low, high], [x_unit, y_unit]) = (self.range(), self.units());
        let room = 0.05 * (high - low).max(1e-3 * y_unit.scale);
        let y = [low - room, high + room].map(|z| z / y_unit.scale);
        let axes = [[0.0, self.length / x_unit.scale], y].map(PlotAxis::linear);
        let along = format!("Along the dashed line of the map ({})", x_unit.name);
        PlotFrame::new(FRAME, axes, [&along, &format!("Height ({})", y_unit.name)])
    }

    /// What the script needs to draw another load or a part of the length: edges of the plot box, heights (m)
    /// that they stand for, and the unit of length.
    pub(crate) fn scales(&self) -> serde_json::Value {
        let (frame, [x_unit, y_unit]) = (self.frame(), self.units());
        serde_json::json!({
            "box": FRAME,
            "heights": frame.y.data.map(|z| z * y_unit.scale),
            "length": frame.x.data[1],
            "unit": x_unit.name,
        })
    }
}

/// The section at the load of index `load`. What the script moves stands in groups that have a class.
pub(crate) fn section(cut: &SectionCut, load: usize, description: String) -> Figure {
    let (frame, [_, y_unit]) = (cut.frame(), cut.units());
    let pressed = &cut.loads[load];
    let n = cut.heights.len();
    let [left, top, right, bottom] = FRAME;
    let x = |part: f64| left + part / n as f64 * (right - left);
    let y = |metres: f64| frame.y.at(metres / y_unit.scale);
    let line = |heights: &[f64]| -> Vec<[f64; 2]> {
        heights.iter().enumerate().map(|(i, z)| [x(i as f64 + 0.5), y(*z)]).collect()
    };
    let flat = y(pressed.flat);
    let body = line(&pressed.gap.iter().map(|gap| pressed.flat - gap).collect::<Vec<_>>());
    let mut filled = body.clone();
    filled.extend([[x(n as f64 - 0.5), bottom], [x(0.5), bottom]]);
    let mut canvas = Canvas::default();
    canvas.group(r#"class="across""#, |canvas| across(canvas, &frame));
    frame.draw_with(&mut canvas, &[], &frame.y.ticks());
    canvas.clipped("c", FRAME, |canvas| {
        let above = [left, top, right, flat];
        canvas.group(r#"class="above""#, |canvas| canvas.rect(above, GRID, 1.0));
        canvas.group(r#"class="body""#, |canvas| canvas.area(&filled, BAND, 1.0));
        let dotted = Stroke { colour: INK2, width: 0.8, dash: "1.5 1.5" };
        let before = line(&cut.heights);
        canvas.group(r#"class="before""#, |canvas| canvas.polyline(&before, dotted));
        let (thick, thin) = (Stroke::solid(DETERMINISTIC, 1.2), Stroke::solid(INK, 0.8));
        canvas.group(r#"class="pressed""#, |canvas| canvas.polyline(&body, thick));
        canvas.group(r#"class="flat""#, |canvas| canvas.line([left, flat], [right, flat], thin));
        canvas.group(r#"class="touching px""#, |canvas| {
            for (first, last, colour) in runs(&pressed.pressure) {
                let [from, y, to] = [x(first as f64), flat, x(last as f64 + 1.0)].map(num);
                canvas.raw(&format!(
                    r##"<path d="M{from} {y}H{to}" stroke="#{colour}" stroke-width="5"/>"##
                ));
            }
        });
    });
    canvas.group(r#"class="name""#, |canvas| {
        canvas.text(&Text::end([right - 4.0, (flat - 6.0).max(top + 9.0)], "flat", INK));
    });
    canvas.text(&Text::start([left + 5.0, bottom - 5.0], "rough body", INK).halo());
    canvas.figure("Section through the contact", description, SIZE)
}

/// Grid, ticks and numbers of the horizontal axis, which the script draws anew for a part of the length.
fn across(canvas: &mut Canvas, frame: &PlotFrame) {
    let [_, top, _, bottom] = FRAME;
    let ticks = frame.x.major();
    let lines = |to: f64, from: f64| -> Vec<[f64; 4]> {
        ticks.iter().map(|v| [frame.x.at(*v), from, frame.x.at(*v), to]).collect()
    };
    canvas.ticks(&lines(bottom, top), Stroke::solid(GRID, 0.6));
    canvas.ticks(&lines(bottom + 3.5, bottom), Stroke::solid(LINE, 0.6));
    for tick in ticks {
        let (at, text) = ([frame.x.at(tick), bottom + 13.0], frame.x.tick_text(tick));
        canvas.text(&Text::middle(at, &text, INK2));
    }
}

fn runs(pressure: &[f64]) -> Vec<(usize, usize, String)> {
    let ramp = ramp_table::<31>(&PRESSURE_RAMP);
    let mut found: Vec<(usize, usize, String)> = Vec::new();
    for (i, p) in pressure.iter().enumerate().filter(|(_, p)| **p > 0.0) {
        let colour = ramp[(30.0 * p.min(1.0)).round() as usize].hex();
        match found.last_mut() {
            Some((_, last, same)) if *last + 1 == i && *same == colour => *last = i,
            _ => found.push((i, i, colour)),
        }
    }
    found
}
