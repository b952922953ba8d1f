//! The slider over the loads: its element, and the numbers that it shows.

use crate::draw::palette::DETERMINISTIC;
use crate::lines::{ELASTIC, Reference, references};
use crate::messages;
use crate::numbers::{NEWTONS, quantity, signed_percent};
use crate::page::{contact_map, shared, tables};
use crate::plot_styles::plot_style;
use contact_compare::{DeterministicAnswer, DeterministicPoint, SurfaceComparison};
use serde_json::json;

fn read_out(surface: &SurfaceComparison) -> Vec<String> {
    let one = |point: &DeterministicPoint| {
        let load = messages::load(point.mean_pressure, surface.load_area);
        let force = quantity(point.mean_pressure * surface.surface.grid().area(), NEWTONS, 3);
        let is_force = surface.load_area.is_some();
        let on_map = if is_force { String::new() } else { format!(" ({force} on this map)") };
        let said = point.answer.as_ref().map_or("no answer".to_owned(), |a| {
            format!("area {}, real pressure {}", messages::area(a), messages::real_pressure(a))
        });
        format!("{load}{on_map}: {said}")
    };
    surface.deterministic.iter().map(one).collect()
}

pub(crate) fn dial(surface: &SurfaceComparison, id: &str) -> String {
    let n = surface.deterministic.len();
    if n < 2 {
        return String::new();
    }
    let (read, at, last) = (read_out(surface), surface.headline, n - 1);
    let (said, load) = (&read[at], messages::headline_load(surface));
    format!(
        "<div class=\"dial\"><label for=\"{id}-load\">Read off at</label><input type=\"range\" \
         id=\"{id}-load\" min=\"0\" max=\"{last}\" step=\"1\" value=\"{at}\"><button type=\"button\" class=\"play\">Play</button><output \
         for=\"{id}-load\" aria-live=\"off\">{said}</output><button type=\"button\" class=\"back\">back to {load}</button></div>\n"
    )
}

/// The numbers the slider shows, written here so that script and page agree to the last digit.
pub(crate) fn data(surface: &SurfaceComparison) -> String {
    if surface.deterministic.len() < 2 {
        return String::new();
    }
    let mut cells = serde_json::Map::new();
    let load = |p: &DeterministicPoint| messages::load(p.mean_pressure, surface.load_area);
    let loads: Vec<String> = surface.deterministic.iter().map(load).collect();
    cells.insert("load".into(), json!(loads));
    let mut listed = Vec::new();
    for Reference { of, points, models } in references(surface) {
        let name = if of == ELASTIC { "elastic" } else { "det" };
        let each = |words: fn(&DeterministicAnswer) -> String| -> Vec<String> {
            points.iter().map(|p| p.answer.as_ref().map_or("–".into(), words)).collect()
        };
        cells.insert(format!("a-{name}"), json!(each(messages::area)));
        cells.insert(format!("p-{name}"), json!(each(messages::real_pressure)));
        let mut list = |name: &str, label: &str, class: &str| {
            listed.push(json!({ "name": name, "label": label, "class": class, "of": of }));
        };
        list(name, "Deterministic", DETERMINISTIC.class);
        for (place, m) in models {
            let Ok(curve) = &m.outcome else { continue };
            let card = &m.card;
            list(&card.name, &card.label, plot_style(&card.name, place).colour.class);
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
    let touching = shared::touching(surface);
    if !touching.is_empty() {
        cells.insert("cut".into(), json!(touching));
    }
    for (key, words) in contact_map::cells(surface) {
        cells.insert(key.into(), json!(words));
    }
    let data = json!({ "read": read_out(surface), "cells": cells, "models": listed }).to_string();
    // "</script>" cannot end the element early.
    format!("<script type=\"application/json\">{}</script>\n", data.replace('<', "\\u003c"))
}
