//! The slider over the loads: its element, and the numbers that it shows.

use crate::draw::palette::DETERMINISTIC;
use crate::lines::{ELASTIC, Reference, references};
use crate::messages;
use crate::numbers::{NEWTONS, PASCALS, chosen, quantity, signed_percent};
use crate::page::{distributions, phrases, tables};
use crate::plot_styles::plot_style;
use contact_compare::{DeterministicAnswer, SurfaceComparison};
use serde_json::json;

/// What the read-out says at each load.
fn read_out(surface: &SurfaceComparison) -> Vec<String> {
    surface
        .deterministic
        .iter()
        .map(|point| {
            let on_map = point.mean_pressure * surface.surface.grid().area();
            let p = match surface.load_area {
                Some(_) => messages::load(point.mean_pressure, surface.load_area),
                None => format!(
                    "{} ({} on this map)",
                    chosen(point.mean_pressure, PASCALS),
                    quantity(on_map, NEWTONS, 3)
                ),
            };
            point.answer.as_ref().map_or_else(
                || format!("{p}: no answer"),
                |a| {
                    let (area, pressure) = (messages::area(a), messages::real_pressure(a));
                    format!("{p}: area {area}, real pressure {pressure}")
                },
            )
        })
        .collect()
}

/// The slider over the loads, with its read-out.
pub(crate) fn dial(surface: &SurfaceComparison, id: &str) -> String {
    let n = surface.deterministic.len();
    if n < 2 {
        return String::new();
    }
    let read = read_out(surface);
    format!(
        "<div class=\"dial\"><label for=\"{id}-load\">Read off at</label><input type=\"range\" \
         id=\"{id}-load\" min=\"0\" max=\"{}\" step=\"1\" value=\"{}\"><button type=\"button\" class=\"play\">Play</button><output \
         for=\"{id}-load\" aria-live=\"off\">{}</output><button type=\"button\" class=\"back\">back to {}</button></div>\n",
        n - 1,
        surface.headline,
        read[surface.headline],
        messages::headline_load(surface)
    )
}

/// The numbers the slider shows, written here so that script and page agree to the last digit.
pub(crate) fn data(surface: &SurfaceComparison) -> String {
    if surface.deterministic.len() < 2 {
        return String::new();
    }
    let mut cells = serde_json::Map::new();
    let loads: Vec<String> = surface
        .deterministic
        .iter()
        .map(|p| messages::load(p.mean_pressure, surface.load_area))
        .collect();
    cells.insert("load".into(), json!(loads));
    let mut listed = Vec::new();
    for Reference { of, points, models } in references(surface) {
        let name = if of == ELASTIC { "elastic" } else { "det" };
        let each = |words: fn(&DeterministicAnswer) -> String| -> Vec<String> {
            points.iter().map(|p| p.answer.as_ref().map_or("–".into(), words)).collect()
        };
        cells.insert(format!("a-{name}"), json!(each(messages::area)));
        cells.insert(format!("p-{name}"), json!(each(messages::real_pressure)));
        let class = DETERMINISTIC.class;
        listed.push(json!({ "name": name, "label": "Deterministic", "class": class, "of": of }));
        for (place, m) in models {
            let Ok(curve) = &m.outcome else { continue };
            let (card, class) = (&m.card, plot_style(&m.card.name, place).colour.class);
            listed
                .push(json!({ "name": card.name, "label": card.label, "class": class, "of": of }));
            let errors: Vec<String> =
                curve.errors.iter().map(|e| e.map_or("–".into(), signed_percent)).collect();
            let points = || curve.points.iter();
            let area: Vec<String> = points().map(tables::model_area).collect();
            let real: Vec<String> = points().map(tables::model_pressure).collect();
            for (letter, words) in [('a', area), ('e', errors), ('p', real)] {
                cells.insert(format!("{letter}-{}", card.name), json!(words));
            }
        }
    }
    let touching = phrases::touching(surface);
    if !touching.is_empty() {
        cells.insert("cut".into(), json!(touching));
    }
    for (key, words) in distributions::cells(surface) {
        cells.insert(key.into(), json!(words));
    }
    let data = json!({ "read": read_out(surface), "cells": cells, "models": listed }).to_string();
    // "</script>" cannot end the element early.
    format!("<script type=\"application/json\">{}</script>\n", data.replace('<', "\\u003c"))
}
