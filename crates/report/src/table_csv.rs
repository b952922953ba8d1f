//! A table of JSON objects as CSV: one row each, one column for every number, word or truth that one of
//! them has, with its unit in the header.

use crate::csv::{cell, quoted};
use serde_json::Value;
use std::io::{self, Write};
use surface_stats::STATISTICS;

/// Keys whose values are lists of text for people, or too long for a row.
const LEFT_OUT: [&str; 6] =
    ["metadata", "channels", "cleaning", "error", "checks", "distributions"];

/// Units of the keys of results beside those of the statistics; what is not here has none, what has one of [`ENDINGS`] that
/// of what is before it. SI throughout.
const UNITS: &[(&str, &str)] = &[
    (
        "m",
        "pixel height height_min height_max height_mean radius height_std mean_offset fractal_range mean_gap approach \
         spacing length s_filter l_filter fractal_roughness shift shift_asked seal_length seal_width free_path jump",
    ),
    ("N", "load"),
    ("m²", "median_spot_area largest_spot_area load_area nominal_area"),
    ("m³", "permeability"),
    ("m³/s", "rate"),
    ("m⁻²", "density"),
    ("m⁻¹", "curvature_mean"),
    ("Pa", "modulus mean_pressure max_pressure real_pressure hardness"),
    ("Pa", "pascals pressure pressure_drop"),
    ("Pa s", "viscosity"),
    ("Pa/m", "stiffness"),
    ("J/m²", "duality_gap energy_bound"),
    ("S/m²", "electrical_conductance"),
    ("W/m²/K", "thermal_conductance gas_conductance joint_conductance"),
    ("ohm", "electrical_resistance"),
    ("K/W", "thermal_resistance"),
    ("W/m/K", "conductivity"),
    ("K", "temperature"),
    ("s", "seconds"),
];

const ENDINGS: [&str; 3] = ["_one_spot", "_interval", "_prediction"];

/// Writes the table. The first column is `file`, the last is `why`, empty where nothing is wrong.
///
/// # Errors
/// Whatever the writer reports.
pub fn write<'a>(
    rows: impl Iterator<Item = (String, Option<&'a Value>, Option<String>)> + Clone,
    out: &mut impl Write,
) -> io::Result<()> {
    let mut heads: Vec<String> = Vec::new();
    for (_, object, _) in rows.clone() {
        for (head, _) in object.map(flat).unwrap_or_default() {
            if !heads.contains(&head) {
                heads.push(head);
            }
        }
    }
    let with_units: Vec<String> = heads.iter().map(|head| quoted(&with_unit(head))).collect();
    let comma = if heads.is_empty() { "" } else { "," };
    writeln!(out, "file{comma}{},why", with_units.join(","))?;
    for (file, object, why) in rows {
        let cells = object.map(flat).unwrap_or_default();
        let value = |head: &String| {
            let found = cells.iter().find(|(name, _)| name == head);
            found.map_or(String::new(), |(_, value)| value.clone())
        };
        let values: Vec<String> = heads.iter().map(value).collect();
        let why = quoted(&why.unwrap_or_default().replace('\n', "; "));
        writeln!(out, "{}{comma}{},{why}", quoted(&file), values.join(","))?;
    }
    Ok(())
}

/// `mean_gap_interval.0 (m)`.
fn with_unit(head: &str) -> String {
    let words = head.split(['.', '[', ']']).filter(|w| w.parse::<usize>().is_err());
    let words: Vec<&str> = words.filter(|w| !w.is_empty()).collect();
    let name = match words[..] {
        ["budget", of, _] => of,
        ["leak", _, "interval" | "coarser"] => "permeability",
        _ => words.last().copied().unwrap_or_default(),
    };
    let name = ENDINGS.iter().fold(name, |name, end| name.strip_suffix(end).unwrap_or(name));
    let of_result = UNITS.iter().find(|(_, names)| names.split_whitespace().any(|n| n == name));
    let unit = of_result.map(|(unit, _)| *unit).or_else(|| {
        STATISTICS.iter().find(|field| field.key == name && !field.unit.is_empty()).map(|f| f.unit)
    });
    // `m^-2` of `m⁻²`: a header of CSV is read by programs.
    let ascii = |unit: &str| {
        unit.replace('²', "^2").replace('³', "^3").replace("⁻^2", "^-2").replace("⁻¹", "^-1")
    };
    unit.map_or_else(|| head.to_owned(), |unit| format!("{head} ({})", ascii(unit)))
}

/// The numbers, words and truths of an object, with the way to them as their name.
fn flat(object: &Value) -> Vec<(String, String)> {
    let mut cells = Vec::new();
    if let Value::Object(fields) = object {
        for (key, value) in fields.iter().filter(|(key, _)| !LEFT_OUT.contains(&key.as_str())) {
            push(key.clone(), value, &mut cells);
        }
    }
    cells
}

fn push(name: String, value: &Value, cells: &mut Vec<(String, String)>) {
    match value {
        // A column of its own only where another row has something there.
        Value::Null => {}
        Value::Bool(truth) => cells.push((name, truth.to_string())),
        Value::Number(number) => cells.push((name, cell(number.as_f64()))),
        Value::String(text) => cells.push((name, quoted(text))),
        Value::Object(_) => {
            cells
                .extend(flat(value).into_iter().map(|(key, cell)| (format!("{name}.{key}"), cell)));
        }
        Value::Array(items) if name == "findings" || name == "warnings" => {
            // Not what was only looked at and found well.
            let is_open = |finding: &&Value| finding["weight"] != "passed";
            cells.push((name, items.iter().filter(is_open).count().to_string()));
        }
        // The loads of a solution, numbered where there are several.
        Value::Array(items) if name == "points" => {
            for (i, item) in items.iter().enumerate() {
                let number = if items.len() > 1 { format!("[{}]", i + 1) } else { String::new() };
                cells.extend(flat(item).into_iter().map(|(key, cell)| (key + &number, cell)));
            }
        }
        Value::Array(items) => {
            let scalar = |v: &Value| v.is_number() || v.is_string() || v.is_null();
            if items.len() <= 4 && items.iter().all(scalar) {
                for (i, item) in items.iter().enumerate() {
                    push(format!("{name}.{i}"), item, cells);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn one_row_each_with_units_and_reasons() {
        let map = json!({
            "shape": [4, 5], "rms_height": 1e-7, "method": "chord", "findings": [{ "weight": "check" }, { "weight": "passed" }],
            "asperities": { "radius": 2e-6 },
            "points": [{ "mean_gap": 1e-8, "residuals": { "x": 0.5 }, "budget": { "mean_gap": { "finer": 1e-9 } },
                "leak": { "x": { "interval": [0.0, 1e-20], "rate_interval": [0.0, 1e-9] } } }, { "mean_gap": null }],
        });
        let other = json!({ "rms_height": 0.25, "points": [{ "converged": true }] });
        let rows = [
            ("a, b".to_owned(), Some(&map), None),
            ("c".to_owned(), None, Some("no\n\"file\"".to_owned())),
            ("d".to_owned(), Some(&other), None),
        ];
        let mut out = Vec::new();
        write(rows.into_iter(), &mut out).unwrap();
        let text = String::from_utf8(out).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        let head: Vec<&str> = lines[0].split(',').collect();
        assert_eq!(head.first().zip(head.last()), Some((&"file", &"why")));
        let names = "shape.0,rms_height (m),asperities.radius (m),mean_gap[1] (m),residuals.x[1],\
                     budget.mean_gap.finer[1] (m),leak.x.interval.1[1] (m^3),leak.x.rate_interval.0[1] (m^3/s)";
        for name in names.split(',') {
            assert!(head.contains(&name), "{name} in {head:?}");
        }
        let at = |name: &str| head.iter().position(|h| *h == name).unwrap();
        let last: Vec<&str> = lines[3].split(',').collect();
        let found = ["rms_height (m)", "converged", "shape.0"].map(|name| last[at(name)]);
        assert_eq!(found, ["0.25", "true", ""]);
        assert!(lines[1].starts_with("\"a, b\",") && lines[1].contains(",1,"), "{}", lines[1]);
        assert!(lines[2].ends_with("\"no; \"\"file\"\"\""), "{}", lines[2]);
        assert!(lines.iter().skip(2).all(|l| l.matches(',').count() == head.len() - 1), "{text}");
    }
    #[test]
    fn every_number_of_the_statistics_is_in_their_table() {
        let heights = (0..64).map(|i| f64::from(i * i % 17)).collect();
        let grid = contact_types::Grid::new([8, 8], [1.0, 1.0]).unwrap();
        let map = contact_types::HeightMap::new(grid, heights).unwrap();
        let s = surface_stats::SurfaceStatistics::of(&map, &surface_stats::StatsOptions::default())
            .unwrap();
        let Value::Object(shown) = crate::json::statistics(&s) else { panic!() };
        let numbers = shown.iter().filter(|(_, value)| value.is_f64());
        let listed = STATISTICS.iter().filter_map(|field| Some((field.key, field.of(&s)?)));
        let sorted = |mut all: Vec<(String, f64)>| {
            all.sort_by(|a, b| a.0.cmp(&b.0));
            all
        };
        let shown = numbers.map(|(key, value)| (key.clone(), value.as_f64().unwrap())).collect();
        assert_eq!(sorted(shown), sorted(listed.map(|(k, v)| (k.to_owned(), v)).collect()));
    }
}
