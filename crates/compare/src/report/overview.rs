//! Several surfaces at once: does the ranking of the models hold on all of them?

use super::axes::{Axis, Frame};
use super::curves::Lines;
use super::html::Page;
use super::labels::{EndLabel, draw_end_labels};
use super::numbers::{
    METRES, PASCALS, SPACE, chosen, duration, quantity, signed_percent, significant,
};
use super::palette::{BAND, DETERMINISTIC, INK2};
use super::svg::{Anchor, Canvas, Figure, Stroke, Text, escape, num};
use super::words::{self, WANTED};
use crate::models::MODELS;
use crate::result::{ModelCurve, SurfaceComparison};

/// The opening of a report on several surfaces.
pub(super) fn section(page: &mut Page<'_>) -> String {
    let surfaces = &page.comparison.surfaces;
    let line = format!(
        "<p class=\"file\">rough-contact report · {} surfaces · <i>E</i>* = {} · {}</p>\n",
        surfaces.len(),
        chosen(page.comparison.settings.modulus, PASCALS),
        words::date(page.provenance.unix_time)
    );
    let table = table(surfaces);
    let n = page.next_figure();
    let svg = panels(surfaces, &format!("o-f{n}")).inline();
    format!(
        "<header>{line}<h1>{}</h1>\n<p>{}</p></header>\n{table}<figure class=\"wide scroll\">{svg}\
         <figcaption><b>Fig. {n}. Does the ranking hold?</b> Error of each closed form over the \
         load, on a scale that makes surfaces comparable. Grey: within 10{SPACE}%. What lies \
         beyond the axis is listed above each panel.</figcaption></figure>\n<div \
         class=\"page1\"></div>\n",
        headline(surfaces),
        ranking(surfaces)
    )
}

/// Mean size of the error of each model over all loads of a surface, by the order of the list.
fn mean_errors(surface: &SurfaceComparison) -> Vec<Option<f64>> {
    surface
        .models
        .iter()
        .map(|m| m.outcome.as_ref().ok().and_then(ModelCurve::worst_and_mean).map(|(_, mean)| mean))
        .collect()
}

/// Which closed form has the smallest largest mean error over the surfaces.
fn headline(surfaces: &[SurfaceComparison]) -> String {
    let all: Vec<Vec<Option<f64>>> = surfaces.iter().map(mean_errors).collect();
    let models = all.first().map_or(0, Vec::len);
    let worst = |k: usize| -> Option<f64> {
        all.iter().map(|errors| errors[k]).try_fold(0.0_f64, |w, e| Some(w.max(e?)))
    };
    let best = (0..models).filter_map(|k| Some((k, worst(k)?))).min_by(|a, b| a.1.total_cmp(&b.1));
    let count = surfaces.len();
    match best {
        Some((k, error)) => {
            let name = surfaces[0].models[k].entry.title;
            let percent = super::numbers::percent(error);
            if error <= WANTED {
                format!(
                    "On {count} surfaces {name} stays nearest: on average within <b>{percent}</b> of the deterministic area."
                )
            } else {
                format!(
                    "No closed form is within 10{SPACE}% on all {count} surfaces; the nearest, {name}, is off by up to <b>{percent}</b> on average over the loads."
                )
            }
        }
        None => format!("No closed form answers on all {count} surfaces."),
    }
}

/// Whether the order of the models is the same on every surface.
fn ranking(surfaces: &[SurfaceComparison]) -> String {
    let order = |s: &SurfaceComparison| -> Vec<&'static str> {
        let mut list: Vec<(f64, &'static str)> = mean_errors(s)
            .into_iter()
            .zip(&s.models)
            .filter_map(|(e, m)| Some((e?, m.entry.label)))
            .collect();
        list.sort_by(|a, b| a.0.total_cmp(&b.0));
        list.into_iter().map(|(_, label)| label).collect()
    };
    let orders: Vec<Vec<&str>> = surfaces.iter().map(order).collect();
    let Some(first) = orders.first() else { return String::new() };
    if orders.iter().all(|o| o == first) {
        return format!("The ranking by mean error holds on all of them: {}.", first.join(", "));
    }
    let each: Vec<String> = surfaces
        .iter()
        .zip(&orders)
        .map(|(s, o)| format!("{}: {}", escape(&s.name), o.join(", ")))
        .collect();
    format!("The ranking by mean error, nearest first, differs. {}.", each.join(". "))
}

fn table(surfaces: &[SurfaceComparison]) -> String {
    let rows: String = surfaces
        .iter()
        .enumerate()
        .map(|(i, s)| {
            let answer = s.headline_answer();
            let nearest = words::ranked(s).into_iter().next();
            format!(
                "<tr><th scope=\"row\"><a href=\"#s{i}-w\">{}</a></th><td class=\"n\">{}</td>\
                 <td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td>\
                 <td class=\"n\">{}</td><td>{}</td><td class=\"n\">{}</td></tr>\n",
                escape(&s.name),
                quantity(s.statistics.rms_height, METRES, 3),
                significant(s.inputs.rms_gradient(), 2),
                chosen(s.headline_pressure(), PASCALS),
                answer.map_or("–".into(), words::area),
                answer.map_or("–".into(), |a| words::real_pressure(s.headline_pressure(), a)),
                nearest.as_ref().map_or("–".into(), |r| format!(
                    "{} ({})",
                    r.model.entry.label,
                    signed_percent(r.error)
                )),
                answer.map_or("–".into(), |a| duration(a.seconds)),
            )
        })
        .collect();
    format!(
        "<table class=\"over\"><caption>Each surface at one load</caption><thead><tr><th \
         scope=\"col\">Surface</th><th scope=\"col\" class=\"n\"><i>Sq</i></th><th scope=\"col\" \
         class=\"n\"><i>Sdq</i></th><th scope=\"col\" class=\"n\">Load</th><th scope=\"col\" \
         class=\"n\">Area</th><th scope=\"col\" class=\"n\">Real pressure</th><th \
         scope=\"col\">Nearest closed form</th><th scope=\"col\" class=\"n\">Solver, per \
         load</th></tr></thead><tbody>\n{rows}</tbody></table>\n"
    )
}

/// Small multiples of the signed error over p / (E* g), three to a row, axes shared.
fn panels(surfaces: &[SurfaceComparison], key: &str) -> Figure {
    const WIDTH: f64 = 700.0;
    const PANEL: [f64; 2] = [180.0, 130.0];
    const LEFT: f64 = 44.0;
    const GAP: f64 = 23.0;
    let lines: Vec<Lines> = surfaces.iter().map(Lines::of).collect();
    let scale: Vec<f64> =
        surfaces.iter().map(|s| s.inputs.modulus.pascals() * s.inputs.rms_gradient()).collect();
    let percent = |l: &Lines, k: usize| -> Vec<Option<f64>> {
        l.errors(&l.models[k]).into_iter().map(|e| e.map(|e| 100.0 * e)).collect()
    };
    let (mut x_lo, mut x_hi) = (f64::INFINITY, 0.0_f64);
    let (mut y_lo, mut y_hi) = (-15.0_f64, 15.0_f64);
    for (l, s) in lines.iter().zip(&scale) {
        if *s > 0.0 {
            for p in &l.pressures {
                x_lo = x_lo.min(p / s);
                x_hi = x_hi.max(p / s);
            }
        }
        for k in 0..l.models.len() {
            for e in percent(l, k).into_iter().flatten().filter(|e| e.abs() <= 80.0) {
                y_lo = y_lo.min(e);
                y_hi = y_hi.max(e);
            }
        }
    }
    if x_hi <= x_lo {
        (x_lo, x_hi) = (1e-4, 1.0);
    }
    let mut canvas = Canvas::default();
    let per_row = 3;
    // Room for the name and up to three lines of what is off scale.
    let head = 60.0;
    let row_height = head + PANEL[1] + 42.0;
    for (i, (l, s)) in lines.iter().zip(surfaces).enumerate() {
        let left = LEFT + (i % per_row) as f64 * (PANEL[0] + GAP);
        let top = (i / per_row) as f64 * row_height + head;
        let frame = Frame {
            x: Axis::log([x_lo, x_hi], [left, left + PANEL[0]]),
            y: Axis::linear([1.05 * y_lo, 1.05 * y_hi], [top + PANEL[1], top]),
            x_title: String::new(),
            y_title: if i % per_row == 0 { "Error in area (%)".into() } else { String::new() },
        };
        canvas.rect([left, frame.y.at(10.0), left + PANEL[0], frame.y.at(-10.0)], BAND, 1.0);
        let x_ticks: Vec<_> =
            frame.x.major().into_iter().map(|v| (v, frame.x.tick_text(v))).collect();
        let y_ticks: Vec<_> = frame
            .y
            .major()
            .into_iter()
            .map(|v| {
                let text = if i % per_row > 0 {
                    String::new()
                } else if v > 0.0 {
                    format!("+{}", frame.y.tick_text(v))
                } else {
                    frame.y.tick_text(v)
                };
                (v, text)
            })
            .collect();
        frame.draw_with(&mut canvas, &x_ticks, &y_ticks);
        canvas.line(
            [left, frame.y.at(0.0)],
            [left + PANEL[0], frame.y.at(0.0)],
            Stroke::solid(DETERMINISTIC, 1.4),
        );
        let name = shortened(&s.name, 30);
        canvas.text(&Text { bold: true, ..Text::new([left, top - head + 12.0], &name) });
        let mut ends = Vec::new();
        let mut notes = Vec::new();
        canvas.raw(&format!(
            "<clipPath id=\"{key}-c{i}\"><rect x=\"{}\" y=\"{}\" width=\"{}\" \
             height=\"{}\"/></clipPath><g clip-path=\"url(#{key}-c{i})\">",
            num(left - 3.0),
            num(top),
            num(PANEL[0] + 6.0),
            num(PANEL[1])
        ));
        for (k, model) in l.models.iter().enumerate() {
            let errors = percent(l, k);
            let points: Vec<[f64; 2]> = errors
                .iter()
                .zip(&l.pressures)
                .filter_map(|(e, p)| Some(frame.at([p / scale[i], (*e)?])))
                .collect();
            let stroke = Stroke {
                colour: model.look.colour,
                width: model.look.width,
                dash: model.look.dash,
            };
            canvas.polyline(&points, stroke);
            for (j, point) in points.iter().enumerate() {
                if j % 4 == model.look.marker_offset {
                    canvas.marker(*point, 2.3, model.look);
                }
            }
            let present: Vec<f64> = errors.into_iter().flatten().collect();
            let lo = present.iter().copied().fold(f64::INFINITY, f64::min);
            let hi = present.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            if hi > 1.05 * y_hi || lo < 1.05 * y_lo {
                notes.push((model, lo, hi));
            }
            if let Some(last) = present.last().filter(|e| frame.y.holds(**e)) {
                ends.push(EndLabel {
                    y: frame.y.at(*last),
                    text: model.label.into(),
                    colour: model.look.colour,
                    bold: false,
                });
            }
        }
        canvas.raw("</g>");
        for (row, (model, lo, hi)) in notes.iter().take(3).enumerate() {
            let text = format!(
                "{} {} {}",
                if *hi > 1.05 * y_hi { '▲' } else { '▼' },
                model.label,
                super::numbers::signed_range(lo / 100.0, hi / 100.0)
            );
            canvas.label(&Text {
                colour: model.look.colour,
                size: 9.0,
                ..Text::new([left, top - head + 25.0 + 11.5 * row as f64], &text)
            });
        }
        if i % per_row == per_row - 1 || i + 1 == lines.len() {
            draw_end_labels(&mut canvas, left + PANEL[0], [top, top + PANEL[1]], &ends);
        }
    }
    let rows = lines.len().div_ceil(per_row).max(1);
    let height = rows as f64 * row_height;
    canvas.text(&Text {
        colour: INK2,
        anchor: Anchor::Middle,
        ..Text::new(
            [LEFT + 1.5 * PANEL[0] + GAP, height - 2.0],
            "Nominal pressure / (E* · rms gradient)",
        )
    });
    let drawn: Vec<&str> = MODELS
        .iter()
        .filter(|m| lines.iter().any(|l| l.models.iter().any(|k| k.name == m.name)))
        .map(|m| m.label)
        .collect();
    Figure {
        key: key.into(),
        title: "Error of the closed forms on each surface".into(),
        description: format!(
            "Small multiples of signed per cent error against load for {}: {}. {}",
            surfaces.iter().map(|s| s.name.as_str()).collect::<Vec<_>>().join(", "),
            drawn.join(", "),
            ranking(surfaces)
        ),
        size: [WIDTH, height + 4.0],
        canvas,
    }
}

/// The name, or its beginning with an ellipsis.
fn shortened(name: &str, most: usize) -> String {
    if name.chars().count() <= most {
        name.into()
    } else {
        name.chars().take(most - 1).chain(['…']).collect()
    }
}
