//! Figures of the study of light load: the slope of area against load, over the breadth of the
//! spectrum and over the load, and the way to full contact.

use crate::light_load::{Kind, LIGHT, LogLaw, Row, log_law};
use compare::{Inputs, find};
use contact_types::{ContactModulus, SpectralMoments};
use report::draw::axes::{Axis, Frame};
use report::draw::labels::{EndLabel, draw_end_labels};
use report::draw::palette::{BAND, BGT, Colour, DETERMINISTIC, INK2, Look, Marker, PERSSON};
use report::draw::svg::{COLUMN, Canvas, Figure, Stroke, Text};
use std::f64::consts::{PI, TAU};
use std::io::{self, Write};

/// Values of kappa published by others for light load.
const PUBLISHED: [f64; 2] = [2.0, 2.3];
const LEFT: f64 = 48.0;
const RIGHT: f64 = COLUMN - 84.0;
const BOTTOM: f64 = 226.0;
const TOP: f64 = 14.0;
const PERSSON_LINE: Stroke = Stroke { colour: PERSSON, width: 1.35, dash: "8 2 1.5 2" };
const BGT_LINE: Stroke = Stroke { colour: BGT, width: 1.35, dash: "2 2" };

/// `A/x` of a closed form at load x for a spectrum of this bandwidth; `None` outside its domain.
pub fn model_slope(model: &str, bandwidth: f64, load: f64) -> Option<f64> {
    let (m0, m2, e_star) = (1e-12, 1e-3, 1e11);
    let moments = SpectralMoments { m0, m2, m4: bandwidth * m2 * m2 / m0 };
    let modulus = ContactModulus::from_pascals(e_star).ok()?;
    let inputs = Inputs { moments: Some(moments), ..Inputs::new(modulus) };
    let pressure = load * e_star * moments.rms_gradient();
    let state = find(model)?.build(&inputs).ok()?.at_pressure(pressure).ok()?;
    Some(state.area_fraction / load)
}

/// Its mean over the loads of kappa.
pub fn model_kappa(model: &str, bandwidth: f64) -> Option<f64> {
    let slopes: Option<Vec<f64>> =
        LIGHT.iter().map(|x| model_slope(model, bandwidth, *x)).collect();
    Some(slopes?.iter().sum::<f64>() / LIGHT.len() as f64)
}

/// Places from `a` to `b` at equal ratios.
fn sweep(a: f64, b: f64, n: usize) -> impl Iterator<Item = f64> {
    (0..=n).map(move |k| a * (b / a).powf(k as f64 / n as f64))
}

/// A name at the right end of a line.
fn end(frame: &Frame, y: f64, text: &str, colour: Colour) -> EndLabel {
    EndLabel { y: frame.y.at(y), text: text.into(), colour, bold: false, series: String::new() }
}

/// kappa of every kind of map against Nayak's parameter, with the limits of the theories.
///
/// # Errors
/// Whatever the writer reports.
pub fn write_kappa_bandwidth(kinds: &[Kind], out: &mut impl Write) -> io::Result<()> {
    let widest = kinds.iter().map(|k| k.bandwidth).fold(10.0, f64::max);
    let frame = Frame {
        x: Axis::log([1.5, 1.5 * widest], [LEFT, RIGHT]),
        y: Axis::linear([1.5, 2.6], [BOTTOM, TOP]),
        x_title: "Nayak’s parameter α = m₀m₄/m₂²".into(),
        y_title: "κ = A E* g / p".into(),
    };
    let mut canvas = Canvas::default();
    let band = [LEFT, frame.y.at(PUBLISHED[1]), RIGHT, frame.y.at(PUBLISHED[0])];
    canvas.rect(band, BAND, 1.0);
    frame.draw(&mut canvas);
    let persson = (8.0 / PI).sqrt();
    for (y, stroke) in [(persson, PERSSON_LINE), (TAU.sqrt(), BGT_LINE)] {
        canvas.line([LEFT, frame.y.at(y)], [RIGHT, frame.y.at(y)], stroke);
    }
    let bgt: Vec<[f64; 2]> = sweep(1.6, 1.5 * widest, 40)
        .filter_map(|a| Some([a, model_kappa("bgt", a)?]))
        .filter(|p| frame.y.holds(p[1]))
        .map(|p| frame.at(p))
        .collect();
    canvas.polyline(&bgt, Stroke { colour: BGT, width: 1.35, dash: "" });
    if let Some(lowest) = model_kappa("bgt", widest).filter(|v| !frame.y.holds(*v)) {
        let note = format!("▼ BGT off scale: {lowest:.2} at α = {widest:.0}");
        note_below(&mut canvas, 96.0, &note);
    }
    let law = log_law(kinds);
    let on_law = |a: f64| law.at_one - law.fall * a.ln();
    let ends = [1.8, 1.2 * widest].map(|a| frame.at([a, on_law(a)]));
    canvas.polyline(&ends, Stroke::solid(DETERMINISTIC, 0.8));
    for k in kinds {
        let [x, _] = frame.at([k.bandwidth, k.kappa.value]);
        let span = |half: f64| [-half, half].map(|d| [x, frame.y.at(k.kappa.value + d)]);
        let [a, b] = span(k.kappa.uncertainty());
        canvas.line(a, b, Stroke::solid(INK2, 0.6));
        let [a, b] = span(k.kappa.sampling);
        canvas.line(a, b, Stroke::solid(DETERMINISTIC, 1.6));
        canvas.marker(frame.at([k.bandwidth, k.kappa.value]), 2.8, look(k.hurst));
    }
    for (row, (hurst, name)) in
        [(0.3, "H = 0.3"), (0.5, "H = 0.5"), (0.8, "H = 0.8")].into_iter().enumerate()
    {
        let y = BOTTOM - 58.0 + 13.0 * row as f64;
        canvas.marker([LEFT + 10.0, y - 3.4], 2.8, look(hurst));
        canvas.text(&Text::new([LEFT + 18.0, y], name));
    }
    let labels = vec![
        end(&frame, persson, "Persson", PERSSON),
        end(&frame, TAU.sqrt(), "BGT, zero load", BGT),
        end(&frame, on_law(1.2 * widest), "log law", DETERMINISTIC),
        EndLabel {
            y: frame.y.at(f64::midpoint(PUBLISHED[0], PUBLISHED[1]) + 0.07),
            ..end(&frame, 2.1, "published", INK2)
        },
    ];
    if let Some(value) = model_kappa("bgt", 9.0) {
        let [x, y] = frame.at([9.0, value]);
        let text = "BGT, same loads";
        canvas.label(&Text { colour: BGT, halo: true, ..Text::new([x + 5.0, y - 2.0], text) });
    }
    draw_end_labels(&mut canvas, RIGHT, [TOP + 2.0, BOTTOM - 2.0], &labels);
    figure(
        "kappa-bandwidth",
        "Slope of area against load over the breadth of the spectrum",
        &describe(kinds, &law),
        canvas,
    )
    .write_standalone(out)
}

fn describe(kinds: &[Kind], law: &LogLaw) -> String {
    let (first, last) = (kinds.first(), kinds.last());
    let ends = first.zip(last).map_or(String::new(), |(a, b)| {
        format!(
            "from {:.2} at a parameter of {:.1} to {:.2} at {:.0}",
            a.kappa.value, a.bandwidth, b.kappa.value, b.bandwidth
        )
    });
    format!(
        "{} kinds of maps, {ends}; fall per unit of ln α {:.3}. Thick bars: 95 % of the sampling; \
         thin: with the grid.",
        kinds.len(),
        law.fall
    )
}

fn look(hurst: f64) -> Look {
    let marker = match hurst {
        h if h < 0.4 => Marker::Square,
        h if h < 0.65 => Marker::TriangleUp,
        _ => Marker::Dot,
    };
    Look::model(DETERMINISTIC, "", marker, 0)
}

/// `A/x` over the load for a narrow, a middle and a broad spectrum, with Persson's law and that
/// of Bush, Gibson & Thomas for the same parameters.
///
/// # Errors
/// Whatever the writer reports.
pub fn write_kappa_load(shown: &[&Kind], out: &mut impl Write) -> io::Result<()> {
    const DASHES: [&str; 3] = ["", "6 2.5", "1.5 2"];
    const MARKERS: [Marker; 3] = [Marker::Dot, Marker::Square, Marker::TriangleUp];
    let loads = || shown.iter().flat_map(|k| k.curve.iter().map(|s| s.load));
    let (low, high) = (loads().fold(f64::INFINITY, f64::min), 0.1);
    let frame = Frame {
        x: Axis::log([low / 1.15, high * 1.15], [LEFT, RIGHT]),
        y: Axis::linear([1.0, 2.6], [BOTTOM, TOP]),
        x_title: "p/(E* g)".into(),
        y_title: "A E* g / p".into(),
    };
    let mut canvas = Canvas::default();
    frame.draw(&mut canvas);
    let curve = |f: &dyn Fn(f64) -> Option<f64>| -> Vec<[f64; 2]> {
        sweep(low, high, 40).filter_map(|x| Some(frame.at([x, f(x)?]))).collect()
    };
    let persson = curve(&|x| model_slope("persson", 10.0, x));
    canvas.polyline(&persson, PERSSON_LINE);
    let last = persson.last().map_or(BOTTOM, |p| p[1]);
    let mut labels = vec![EndLabel {
        y: last,
        text: "Persson".into(),
        colour: PERSSON,
        bold: false,
        series: String::new(),
    }];
    let mut found = Vec::new();
    for (n, k) in shown.iter().enumerate() {
        let name = if k.bandwidth < 20.0 {
            format!("α = {:.1}", k.bandwidth)
        } else {
            format!("α = {:.0}", k.bandwidth)
        };
        let dash = DASHES[n % 3];
        let bgt = curve(&|x| model_slope("bgt", k.bandwidth, x).filter(|v| frame.y.holds(*v)));
        canvas.polyline(&bgt, Stroke { colour: BGT, width: 1.0, dash });
        let ends = [high, low].map(|x| model_slope("bgt", k.bandwidth, x).unwrap_or(f64::NAN));
        if bgt.is_empty() {
            let note = format!("▼ BGT, {name} off scale: {:.2} to {:.2}", ends[0], ends[1]);
            note_below(&mut canvas, 6.0, &note);
        }
        if let Some(p) = bgt.last() {
            let text = format!("BGT, {name}");
            labels.push(EndLabel {
                y: p[1],
                text,
                colour: BGT,
                bold: false,
                series: String::new(),
            });
        }
        let points: Vec<_> = k.curve.iter().filter(|s| s.load < 1.01 * high).collect();
        let upper = points.iter().map(|s| frame.at([s.load, s.value + s.uncertainty()]));
        let lower = points.iter().rev().map(|s| frame.at([s.load, s.value - s.uncertainty()]));
        let outline: Vec<[f64; 2]> = upper.chain(lower).collect();
        canvas.area(&outline, DETERMINISTIC, 0.12);
        let line: Vec<[f64; 2]> = points.iter().map(|s| frame.at([s.load, s.value])).collect();
        canvas.polyline(&line, Stroke { colour: DETERMINISTIC, width: 1.6, dash });
        for p in &line {
            canvas.marker(*p, 2.4, Look::model(DETERMINISTIC, "", MARKERS[n % 3], 0));
        }
        if let (Some(p), Some(a), Some(b)) = (line.last(), points.first(), points.last()) {
            let text = format!("here, {name}");
            labels.push(EndLabel {
                y: p[1],
                text,
                colour: DETERMINISTIC,
                bold: false,
                series: String::new(),
            });
            found.push(format!("{name}: {:.2} to {:.2}", a.value, b.value));
        }
    }
    draw_end_labels(&mut canvas, RIGHT, [TOP + 2.0, BOTTOM - 2.0], &labels);
    figure(
        "kappa-load",
        "Area over load against load for three breadths of spectrum",
        &format!("Deterministic, from the lightest load to the heaviest: {}.", found.join("; ")),
        canvas,
    )
    .write_standalone(out)
}

/// Open area over the load up to full contact, logarithmic, beside Persson's `erfc(√2 x)`.
///
/// # Errors
/// Whatever the writer reports.
pub fn write_kappa_full(rows: &[Row], out: &mut impl Write) -> io::Result<()> {
    let heavy: Vec<&Row> = rows
        .iter()
        .filter(|r| r.load >= 0.1 && r.area < 1.0 && r.load < 0.995 * r.closing)
        .collect();
    let right = rows.iter().filter(|r| r.load > r.closing).map(|r| r.closing).fold(2.0, f64::max);
    let frame = Frame {
        x: Axis::linear([0.0, 1.04 * right], [LEFT, RIGHT]),
        y: Axis::log([2e-5, 1.0], [BOTTOM, TOP]),
        x_title: "p/(E* g)".into(),
        y_title: "Open fraction 1 − A".into(),
    };
    let mut canvas = Canvas::default();
    frame.draw(&mut canvas);
    let persson: Vec<[f64; 2]> = (0..=80)
        .map(|k| f64::from(k) / 80.0 * right)
        .filter_map(|x| {
            let slope = model_slope("persson", 10.0, x.max(1e-6))?;
            let open = 1.0 - slope * x.max(1e-6);
            frame.y.holds(open).then(|| frame.at([x, open]))
        })
        .collect();
    canvas.polyline(&persson, PERSSON_LINE);
    for r in &heavy {
        let (open, x) = (1.0 - r.area, frame.x.at(r.load));
        let marker = if r.breadth == 8 { Marker::Dot } else { Marker::Square };
        let [lo, hi] = [open - r.grid, open + r.grid].map(|v| frame.y.at(v.clamp(2e-5, 1.0)));
        canvas.line([x, lo], [x, hi], Stroke::solid(INK2, 0.6));
        if frame.y.holds(open) {
            canvas.marker([x, frame.y.at(open)], 2.4, Look::model(DETERMINISTIC, "", marker, 0));
        }
    }
    let closings: Vec<[f64; 4]> = rows
        .iter()
        .filter(|r| r.load > r.closing)
        .map(|r| [frame.x.at(r.closing), BOTTOM, frame.x.at(r.closing), BOTTOM - 9.0])
        .collect();
    canvas.ticks(&closings, Stroke::solid(DETERMINISTIC, 1.2));
    let note = "last gap closes";
    canvas.text(&Text { colour: INK2, size: 9.0, ..Text::new([RIGHT + 3.0, BOTTOM - 3.0], note) });
    let label = persson.last().map_or([RIGHT, BOTTOM], |p| *p);
    canvas.text(&Text {
        colour: PERSSON,
        halo: true,
        ..Text::new([label[0] - 2.0, label[1] - 12.0], "Persson")
    });
    figure(
        "kappa-full",
        "Open area up to full contact",
        &format!(
            "Semi-logarithmic plot of {} solutions on {} maps beside Persson's erfc(√2 x); marks on \
             the axis: the exact load at which the last gap closes.",
            heavy.len(),
            closings.len()
        ),
        canvas,
    )
    .write_standalone(out)
}

/// What lies below the frame, said inside it.
fn note_below(canvas: &mut Canvas, x: f64, note: &str) {
    let at = [LEFT + x, BOTTOM - 5.0];
    canvas.label(&Text { colour: BGT, size: 9.0, halo: true, ..Text::new(at, note) });
}

fn figure(key: &str, title: &str, description: &str, canvas: Canvas) -> Figure {
    Figure {
        key: key.into(),
        title: title.into(),
        description: description.into(),
        size: [COLUMN, 262.0],
        canvas,
    }
}
