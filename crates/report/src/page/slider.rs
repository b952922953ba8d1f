//! The slider over the loads: its element, and the numbers that it shows.

use crate::draw::palette::DETERMINISTIC;
use crate::looks::look;
use crate::numbers::{PASCALS, chosen, signed_percent};
use crate::page::{phrases, spread, tables};
use crate::words;
use compare::SurfaceComparison;
use serde_json::json;

/// What the read-out says at each load.
fn read_out(surface: &SurfaceComparison) -> Vec<String> {
    surface
        .deterministic
        .iter()
        .map(|point| {
            let p = chosen(point.mean_pressure, PASCALS);
            point.answer.as_ref().map_or_else(
                || format!("{p}: no answer"),
                |a| {
                    let area = words::area(a);
                    let pressure = words::real_pressure(point.mean_pressure, a);
                    let covers = a.interval().map(|_| format!(" ({})", words::COMPARISON));
                    let covers = covers.unwrap_or_default();
                    format!("{p}: area {area}, real pressure {pressure}{covers}")
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
        chosen(surface.headline_pressure(), PASCALS)
    )
}

/// The numbers the slider shows, written here so that script and page agree to the last digit.
pub(crate) fn data(surface: &SurfaceComparison) -> String {
    if surface.deterministic.len() < 2 {
        return String::new();
    }
    let mut cells = serde_json::Map::new();
    let loads: Vec<String> =
        surface.deterministic.iter().map(|p| chosen(p.mean_pressure, PASCALS)).collect();
    cells.insert("load".into(), json!(loads));
    let area: Vec<String> = surface
        .deterministic
        .iter()
        .map(|p| p.answer.as_ref().map_or("–".into(), words::area))
        .collect();
    cells.insert("a-det".into(), json!(area));
    let real: Vec<String> = surface
        .deterministic
        .iter()
        .map(|p| {
            p.answer.as_ref().map_or("–".into(), |a| words::real_pressure(p.mean_pressure, a))
        })
        .collect();
    cells.insert("p-det".into(), json!(real));
    let touching = phrases::touching(surface);
    if !touching.is_empty() {
        cells.insert("cut".into(), json!(touching));
    }
    for (key, words) in spread::cells(surface) {
        cells.insert(key.into(), json!(words));
    }
    for model in &surface.models {
        let Ok(curve) = &model.outcome else { continue };
        let area: Vec<String> = curve.points.iter().map(tables::model_area).collect();
        let error: Vec<String> =
            curve.errors.iter().map(|e| e.map_or("–".into(), signed_percent)).collect();
        if !curve.elastic_errors.is_empty() {
            let elastic: Vec<String> =
                curve.elastic_errors.iter().map(|e| tables::elastic_error(*e)).collect();
            cells.insert(format!("x-{}", model.card.name), json!(elastic));
        }
        cells.insert(format!("a-{}", model.card.name), json!(area));
        cells.insert(format!("e-{}", model.card.name), json!(error));
        let real: Vec<String> = curve.points.iter().map(tables::model_pressure).collect();
        cells.insert(format!("p-{}", model.card.name), json!(real));
    }
    let mut listed =
        vec![json!({ "name": "det", "label": "Deterministic", "class": DETERMINISTIC.class })];
    let models = surface.models.iter().enumerate().filter(|(_, m)| m.outcome.is_ok());
    listed.extend(models.map(|(place, m)| {
        let class = look(&m.card.name, place).colour.class;
        json!({ "name": m.card.name, "label": m.card.label, "class": class })
    }));
    let data = json!({ "read": read_out(surface), "cells": cells, "models": listed }).to_string();
    // "</script>" cannot end the element early.
    format!("<script type=\"application/json\">{}</script>\n", data.replace('<', "\\u003c"))
}
