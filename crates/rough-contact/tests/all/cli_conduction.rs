//! What the contacts of a study conduct, as a user asks for it.

use crate::cli;

use cli::{folder, number, refused, rough_contact};
use serde_json::Value;
use std::f64::consts::PI;
use std::path::Path;

const LOADS: &str = "--modulus 110GPa --pressure 20MPa,100MPa,500MPa";
const BODIES: &str = "--resistivity 22nohm.m,7uohm.cm --conductivity 50W/m/K";

fn surface(at: &Path) {
    let synth = "synth --shape 128,128 --pixel 1um --hurst 0.8 --rolloff 64um --cutoff 6um \
                 --rms-gradient 0.1 --seed 4 --out a.x3p";
    assert_eq!(rough_contact(at, synth).status, 0);
}

fn study(at: &Path, rest: &str) -> Value {
    let line = format!("compare a.x3p {LOADS} {rest} --out report --force");
    let said = rough_contact(at, &line);
    assert_eq!(said.status, 0, "{}", said.err);
    let text = std::fs::read_to_string(at.join("report/results.json")).expect("results");
    let found: Value = serde_json::from_str(&text).expect("JSON");
    found["surfaces"][0].clone()
}

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{found} instead of {expected}");
}

/// A study and `solve` conduct alike, elastic and yielding, and so do JSON, CSV and page.
#[test]
fn a_study_conducts_as_its_solutions_do() {
    let dir = folder();
    let at = dir.path();
    surface(at);
    for more in ["", "--hardness 3GPa"] {
        let found = study(at, &format!("{BODIES} {more} --tolerance 1e-6"));
        let line = format!("solve a.x3p {LOADS} {BODIES} {more} --tolerance 1e-6 --json");
        let solved = rough_contact(at, &line).answered();
        let csv = std::fs::read_to_string(at.join("report/curves.csv")).expect("csv");
        let head: Vec<&str> = csv.lines().next().expect("a header").split(',').collect();
        for i in 0..3 {
            let (here, there) = (&found["conduction"]["points"][i], &solved["points"][i]);
            for key in ["stiffness", "electrical_conductance", "thermal_conductance"] {
                close(number(&here[key]), number(&there[key]), 1e-3);
                let row: Vec<&str> = csv.lines().nth(i + 1).expect("a row").split(',').collect();
                let column = head.iter().position(|h| h.starts_with(key)).expect("a column");
                close(row[column].parse().expect("a number"), number(&here[key]), 1e-12);
            }
            let k = number(&here["stiffness"]);
            close(number(&here["electrical_conductance"]), 2.0 * k / (110e9 * 92e-9), 1e-12);
            let resistance = number(&here["thermal_resistance"]);
            close(resistance * number(&here["thermal_conductance"]) * 16384e-12, 1.0, 1e-12);
            close(resistance, number(&there["thermal_resistance"]), 1e-3);
            for (theory, name) in found["conduction"]["theories"]
                .as_array()
                .expect("theories")
                .iter()
                .zip(["gw", "bgt", "persson"])
            {
                assert_eq!(theory["model"], name);
                let k = number(&theory["points"][i]["stiffness"]);
                let h = number(&theory["points"][i]["electrical_conductance"]);
                close(h, 2.0 * k / (110e9 * 92e-9), 1e-12);
                // Elastic theories of a random surface are within a factor of three of its solution, where
                // more than a few spots touch.
                let ratio = k / number(&here["stiffness"]);
                assert!(
                    i == 0 || !more.is_empty() || (0.3..3.0).contains(&ratio),
                    "{name} {i}: {ratio}"
                );
            }
            // Mikic (1974): 1.55 k_s m_a/σ (√2 p/(E* m_a))^0.94, harmonic mean of like bodies.
            let slope = number(&found["statistics"]["rms_gradient"]) / PI.sqrt();
            let sigma = number(&found["statistics"]["rms_height"]);
            let load = number(&here["mean_pressure"]);
            let strength = 2f64.sqrt() * load / (110e9 * slope);
            let theories = found["conduction"]["theories"].as_array().expect("theories");
            let of = |name: &str| {
                let theory = theories.iter().find(|theory| theory["model"] == name);
                theory.map(|theory| number(&theory["points"][i]["thermal_conductance"]))
            };
            close(
                of("mikic").expect("an answer"),
                1.55 * 50.0 * slope / sigma * strength.powf(0.94),
                1e-9,
            );
            assert_eq!(of("cmy").is_none(), more.is_empty());
            if let Some(plastic) = of("cmy") {
                close(plastic, 1.25 * 50.0 * slope / sigma * (load / 3e9).powf(0.95), 1e-9);
            }
        }
        // The whole map comes first among the octaves, and the shortest waves are what the area lives of.
        let octaves = found["conduction"]["octaves"].as_array().expect("octaves");
        assert!(octaves.len() >= 2, "{octaves:?}");
        let headline = number(&found["headline_pressure"]);
        let points = found["conduction"]["points"].as_array().expect("points");
        let same = |p: &&Value| (number(&p["mean_pressure"]) / headline - 1.0).abs() < 1e-12;
        let at_headline = points.iter().find(same).expect("the headline");
        close(number(&octaves[0]["stiffness"]), number(&at_headline["stiffness"]), 1e-12);
        for pair in octaves.windows(2) {
            let wave = |o: &Value| number(&o["shortest_wavelength"]);
            close(wave(&pair[1]), 2.0 * wave(&pair[0]), 1e-12);
        }
        if more.is_empty() {
            let area = |o: &Value| number(&o["area_fraction"]);
            assert!(area(&octaves[1]) > 1.05 * area(&octaves[0]), "{octaves:?}");
        }
        let page = std::fs::read_to_string(at.join("report/report.html")).expect("page");
        assert!(
            page.contains("thermal contact conductance") && page.contains("Thermal conductance")
        );
        assert_eq!(page.contains(">CMY<"), !more.is_empty());
    }
}

#[test]
fn nothing_is_said_unasked_and_limits_are_allowed() {
    let dir = folder();
    surface(dir.path());
    let plain = study(dir.path(), "");
    let page = std::fs::read_to_string(dir.path().join("report/report.html")).expect("page");
    assert!(plain["conduction"].is_null() && !page.contains("conduct"));
    // Superconductors have no end of it, an insulator lets nothing through; neither is a line.
    let short = study(dir.path(), "--resistivity 0ohm.m");
    assert!(short["conduction"]["points"][1]["electrical_conductance"].is_null());
    assert!(number(&short["conduction"]["points"][1]["stiffness"]) > 0.0);
    let none = study(dir.path(), "--conductivity 0W/m/K,50W/m/K");
    assert!(number(&none["conduction"]["points"][1]["thermal_conductance"]).abs() < 1e-300);
    let line = format!("compare a.x3p {LOADS} --resistivity 5 --out q");
    refused(dir.path(), &line, 2, &["unit"]);
}
