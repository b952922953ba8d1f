//! Figures of the survey: how wrong each model is by bandwidth and load, and how its error
//! follows the slope of the highest points.

use compare::find;
use compare::survey::{Family, Row, Survey};
use contact_accuracy::median;
use report::draw::axes::{Axis, Frame};
use report::draw::palette::{DETERMINISTIC, INK, INK2, LINE, Look, Marker};
use report::draw::svg::{Anchor, COLUMN, Canvas, Figure, Stroke, Text};
use report::numbers::signed;
use std::io::{self, Write};

/// Lower ends of the bins of bandwidth; the last is open.
const BANDWIDTHS: [f64; 5] = [1.5, 4.0, 8.0, 16.0, 32.0];
/// Models drawn, in columns of two.
const MODELS: [&str; 4] = ["gw", "bgt", "greenwood-elliptical", "persson"];
/// Load of the scatter figure.
const LIGHT: f64 = 0.01;

/// Loads of the survey, rising.
fn loads(survey: &Survey) -> Vec<f64> {
    let mut loads: Vec<f64> = survey.rows().iter().map(|r| r.load).collect();
    loads.sort_by(f64::total_cmp);
    loads.dedup();
    loads
}

/// Median signed error of each summit model and of Persson over bandwidth and load, on isotropic
/// Gaussian surfaces: numbers in per cent on a ground that darkens with their size.
///
/// # Errors
/// Whatever the writer reports.
pub fn write_survey_map(survey: &Survey, out: &mut impl Write) -> io::Result<()> {
    const CELL: [f64; 2] = [17.0, 15.0];
    const PANEL: [f64; 2] = [164.0, 118.0];
    let loads = loads(survey);
    let mut canvas = Canvas::default();
    let mut described = Vec::new();
    for (k, name) in MODELS.iter().enumerate() {
        let Some(column) = survey.models().iter().position(|m| m == name) else { continue };
        let title = find(name).map_or(*name, |m| m.card().label.as_ref());
        let [x0, y0] = [(k % 2) as f64 * PANEL[0] + 52.0, (k / 2) as f64 * PANEL[1] + 24.0];
        canvas.text(&Text { bold: true, ..Text::new([x0, y0 - 8.0], title) });
        let mut range = [f64::INFINITY, f64::NEG_INFINITY];
        for (b, &low) in BANDWIDTHS.iter().enumerate() {
            let high = BANDWIDTHS.get(b + 1).copied().unwrap_or(f64::INFINITY);
            let y = y0 + (BANDWIDTHS.len() - 1 - b) as f64 * CELL[1];
            let text =
                if high.is_finite() { format!("{low}\u{2013}{high}") } else { format!("> {low}") };
            canvas.text(&Text {
                colour: INK2,
                anchor: Anchor::End,
                size: 9.0,
                ..Text::new([x0 - 3.0, y + 10.5], &text)
            });
            for (i, &load) in loads.iter().enumerate() {
                let inside = |r: &&Row| {
                    r.family == Family::Gaussian
                        && same(r.load, load)
                        && (low..high).contains(&r.bandwidth)
                };
                let errors = survey.rows().iter().filter(inside);
                let errors = errors.filter_map(|r| r.errors[column]);
                let Some(error) = median(errors) else { continue };
                range = [range[0].min(error), range[1].max(error)];
                let x = x0 + i as f64 * CELL[0];
                let cell = [x + 0.5, y + 0.5, x + CELL[0] - 0.5, y + CELL[1] - 0.5];
                canvas.rect(cell, LINE, (error.abs() / 0.6).min(1.0) * 0.7);
                canvas.text(&Text {
                    anchor: Anchor::Middle,
                    size: 9.0,
                    ..Text::new([x + CELL[0] / 2.0, y + 10.8], &whole(error))
                });
            }
        }
        let foot = y0 + BANDWIDTHS.len() as f64 * CELL[1];
        for (i, load) in loads.iter().enumerate() {
            let thousandths = format!("{:.0}", 1e3 * load);
            canvas.text(&Text {
                colour: INK2,
                anchor: Anchor::Middle,
                size: 8.0,
                ..Text::new([x0 + (i as f64 + 0.5) * CELL[0], foot + 9.5], &thousandths)
            });
        }
        described.push(format!(
            "{title}: {} to {} %",
            signed(100.0 * range[0]),
            signed(100.0 * range[1])
        ));
    }
    let rows = MODELS.len().div_ceil(2) as f64;
    canvas.text(&Text {
        anchor: Anchor::Middle,
        ..Text::new([COLUMN / 2.0, rows * PANEL[1] + 12.0], "1000 × nominal pressure / (E* h′rms)")
    });
    canvas.upright(&Text::new([9.0, rows * PANEL[1] / 2.0], "Nayak bandwidth α"));
    Figure {
        key: "survey-map".into(),
        title: "Median error of the area by bandwidth and load (%)".into(),
        description: format!("Signed medians on Gaussian surfaces. {}.", described.join("; ")),
        size: [COLUMN, rows * PANEL[1] + 18.0],
        canvas,
    }
    .write_standalone(out)
}

/// Persson's area over the deterministic one at a light load, with the bar of the latter, against
/// the relative slope of the highest points: all families.
///
/// # Errors
/// Whatever the writer reports.
pub fn write_survey_slopes(survey: &Survey, out: &mut impl Write) -> io::Result<()> {
    let families = [
        (Family::Gaussian, Marker::Dot, "Gaussian"),
        (Family::Skewed, Marker::TriangleUp, "skewed"),
        (Family::Anisotropic, Marker::Square, "with a lay"),
        (Family::Stepped, Marker::Cross, "stepped"),
    ];
    let column = survey.models().iter().position(|m| m == "persson");
    let rows: Vec<&Row> = survey.rows().iter().filter(|r| same(r.load, LIGHT)).collect();
    let ratio = |r: &Row| column.and_then(|c| r.errors[c]).map(|e| 1.0 + e);
    let span = |values: Vec<f64>| -> [f64; 2] {
        let low = values.iter().copied().fold(f64::INFINITY, f64::min);
        let high = values.iter().copied().fold(0.0, f64::max);
        [low / 1.08, high * 1.08]
    };
    let frame = Frame {
        x: Axis::log(span(rows.iter().map(|r| r.peak_slope).collect()), [44.0, COLUMN - 78.0]),
        y: Axis::log(span(rows.iter().filter_map(|r| ratio(r)).collect()), [200.0, 14.0]),
        x_title: "Rms slope of the highest points / of all".into(),
        y_title: "Persson / deterministic area".into(),
    };
    let mut canvas = Canvas::default();
    frame.draw(&mut canvas);
    if frame.y.holds(1.0) {
        let y = frame.y.at(1.0);
        canvas.line([44.0, y], [COLUMN - 78.0, y], Stroke::solid(DETERMINISTIC, 0.8));
    }
    let mut logs = Vec::new();
    for (family, marker, label) in families {
        let look = Look::model(if family == Family::Gaussian { INK2 } else { INK }, "", marker, 0);
        let place = families.iter().position(|f| f.0 == family).unwrap_or(0) as f64;
        let y = 24.0 + 14.0 * place;
        canvas.marker([COLUMN - 68.0, y - 3.4], 2.4, look);
        canvas.text(&Text::new([COLUMN - 62.0, y], label));
        for row in rows.iter().filter(|r| r.family == family) {
            let Some(y) = ratio(row) else { continue };
            let [low, high] =
                [1.0 - row.bar, 1.0 + row.bar].map(|f| frame.at([row.peak_slope, y * f]));
            canvas.line(low, high, Stroke::solid(LINE, 0.6));
            canvas.marker(frame.at([row.peak_slope, y]), 2.0, look);
            logs.push([row.peak_slope.ln(), y.ln()]);
        }
    }
    Figure {
        key: "survey-slopes".into(),
        title: "Where the top of a surface is smoother, contact is larger".into(),
        description: format!(
            "Persson's area over the deterministic one at p = {LIGHT} E* h′rms on {} surfaces; \
             correlation of the logarithms {:.2}.",
            logs.len(),
            correlation(&logs)
        ),
        size: [COLUMN, 236.0],
        canvas,
    }
    .write_standalone(out)
}

fn correlation(points: &[[f64; 2]]) -> f64 {
    let n = points.len() as f64;
    let mean = [0, 1].map(|k| points.iter().map(|p| p[k]).sum::<f64>() / n);
    let moment = |i: usize, j: usize| -> f64 {
        points.iter().map(|p| (p[i] - mean[i]) * (p[j] - mean[j])).sum()
    };
    moment(0, 1) / (moment(0, 0) * moment(1, 1)).sqrt()
}

/// Per cent without a decimal, sign shown: the map has no room for more.
fn whole(error: f64) -> String {
    let percent = (100.0 * error).round();
    match percent {
        p if p > 0.0 => format!("+{p}"),
        p if p < 0.0 => format!("\u{2212}{}", -p),
        _ => "0".into(),
    }
}

fn same(a: f64, b: f64) -> bool {
    (a / b - 1.0).abs() < 1e-6
}
