//! Contact that yields, as a user asks for it.

use crate::cli::{TestFolder, close, folder, has, list, number};
use serde_json::Value;
use std::f64::consts::TAU;

const SOLVE: &str = "solve a.txt --pixel 1um --height-unit um --modulus 100GPa";

/// Waves of several lengths, one cell of 32 x 32, rms gradient about 0.06.
fn surface() -> TestFolder {
    let at = folder();
    let wave = |iy: usize, ix: usize, a: f64, ky: f64, kx: f64| {
        a * (TAU * (ky * iy as f64 + kx * ix as f64) / 32.0 + ky + 2.0 * kx).cos()
    };
    at.matrix("a.txt", 32, 32, |iy, ix| {
        wave(iy, ix, 0.1, 1.0, 2.0) + wave(iy, ix, 0.06, 3.0, -1.0) + wave(iy, ix, 0.04, 2.0, 4.0)
    });
    at
}

fn solved(at: &TestFolder, rest: &str) -> Value {
    at.answer(&format!("{SOLVE} {rest}"))
}

fn points(answer: &Value) -> &[Value] {
    list(&answer["points"])
}

#[test]
fn what_has_yielded_carries_the_hardness_and_has_no_sample() {
    let at = &surface();
    let loads = "--pressure 20MPa,100MPa,500MPa --tolerance 1e-6";
    let (hard, elastic) = (1e9, solved(at, loads));
    let answer = solved(at, &format!("{loads} --hardness 1GPa"));
    assert_eq!(points(&answer).len(), 3);
    for (point, elastic) in points(&answer).iter().zip(points(&elastic)) {
        let [load, area, saturated, share, rest] = [
            "mean_pressure",
            "touching_fraction",
            "saturated_fraction",
            "plastic_load_fraction",
            "elastic_area_fraction",
        ]
        .map(|key| number(&point[key]));
        assert!(saturated > 0.0 && rest > 0.0 && share < 1.0, "{point}");
        // Equilibrium, and no pressure above H.
        close(share * load, saturated * hard, 1e-9);
        assert!((saturated + rest - area).abs() < 1e-12, "{point}");
        assert!(area >= load / hard && number(&point["max_pressure"]) <= hard);
        assert!(area >= number(&elastic["touching_fraction"]), "{point}");
        // How it scatters from map to map was not studied. The area is at least load over hardness.
        assert!(point["area_prediction_interval"].is_null(), "{point}");
        let low = number(&point["area_interval"][0]);
        assert!(low >= load / hard * (1.0 - 1e-5), "{point}");
        assert!(elastic.get("saturated_fraction").is_none());
    }
    let ratio = number(&answer["hardness"]["modulus_gradient_over_hardness"]);
    assert!((1.0..20.0).contains(&ratio) && answer["hardness"]["warning"].is_null(), "{answer}");
    assert!(elastic.get("hardness").is_none());
}

#[test]
fn a_hardness_above_every_pressure_leaves_the_elastic_answer_and_its_bar() {
    let at = &surface();
    // What the iteration leaves is a part of the bar: little, so that where it happens to end does not matter.
    let [elastic, hard] = ["", "--hardness 80GPa"]
        .map(|rest| solved(at, &format!("--pressure 20MPa,100MPa --tolerance 1e-7 {rest}")));
    for (elastic, hard) in points(&elastic).iter().zip(points(&hard)) {
        // What is in contact and why a bar is missing to the bit; the rest to the tolerance, for a finite
        // hardness rounds otherwise.
        for key in ["area_fraction", "contact_pixels", "area_interval_reason"] {
            assert_eq!(elastic[key], hard[key], "{key}");
        }
        close(number(&elastic["area_interval"][1]), number(&hard["area_interval"][1]), 1e-4);
        close(number(&elastic["mean_gap"]), number(&hard["mean_gap"]), 1e-6);
        assert!(number(&hard["saturated_fraction"]) <= 0.0);
    }
}

#[test]
fn bad_hardness_is_refused_and_an_odd_one_is_doubted() {
    let at = &surface();
    at.refuses_each(
        &format!("{SOLVE} --pressure 1MPa --hardness"),
        &[("0GPa", &["above 0 Pa"]), ("-1GPa", &["above 0 Pa"]), ("NaN", &["NaN"])],
    );
    let unusual = solved(at, "--pressure 100Pa --hardness 2kPa");
    has(unusual["hardness"]["warning"].as_str().unwrap(), &["unit"]);
    // Of several loads, those that no contact can carry are refused, the others answered.
    let said = at.run(&format!("{SOLVE} --pressure 100MPa,2GPa --hardness 1GPa --json"));
    let answer = said.json();
    assert!(said.status != 0 && number(&answer["points"][0]["saturated_fraction"]) > 0.0);
    let point = &answer["points"][1];
    has(point["error"]["message"].as_str().unwrap(), &["above the hardness"]);
    assert!(point["saturated_fraction"].is_null() && point["area_fraction"].is_null());
}

/// h = 2 k/(E* (ρ1 + ρ2)), thermal and electrical alike, elastic and yielding; nothing without contact, and no
/// end in full contact, which JSON cannot write.
#[test]
fn a_contact_conducts_as_stiffly_as_it_stands() {
    let at = &surface();
    let rest = "--resistivity 22nohm.m,7uohm.cm --conductivity 50W/m/K";
    for more in ["--pressure 20MPa,100MPa", "--pressure 20MPa,100MPa --hardness 1GPa"] {
        for point in points(&solved(at, &format!("{rest} {more}"))) {
            let spots = 2.0 * number(&point["stiffness"]) / 100e9;
            let electrical = number(&point["electrical_conductance"]);
            close(electrical, spots / 92e-9, 1e-12);
            close(number(&point["thermal_conductance"]), spots * 25.0, 1e-12);
            let resistance = number(&point["electrical_resistance"]);
            close(resistance * electrical * 1024e-12, 1.0, 1e-12);
            assert!(number(&point["conduction"]["residual"]) < 1e-7, "{point}");
            assert_eq!(point["contact_set"], "part");
            let bare = |key: &str| point[format!("{key}_interval")].is_null();
            assert_eq!(bare("electrical_conductance"), bare("stiffness"), "{point}");
        }
    }
    let point = |more: &str| points(&solved(at, &format!("{rest} {more}")))[0].clone();
    let full = point("--pressure 1TPa");
    assert_eq!(full["contact_set"], "everything");
    assert!(full["stiffness"].is_null(), "{full}");
    assert!(number(&full["electrical_resistance"]).abs() < 1e-300, "{full}");
    let apart = point("--gap 10um");
    assert_eq!(apart["contact_set"], "none");
    assert!(number(&apart["thermal_conductance"]).abs() < 1e-300, "{apart}");
    assert!(apart["electrical_resistance"].is_null(), "{apart}");
    let elastic = solved(at, "--pressure 20MPa");
    assert!(points(&elastic)[0].get("electrical_conductance").is_none());
}

/// The load secant of an elastic contact is the stiffness of its contact set.
#[test]
fn stiffness_of_the_set_is_the_load_secant() {
    let loads = "--pressure 99.9MPa,100MPa,100.1MPa --tolerance 1e-10";
    let answer = solved(&surface(), &format!("{loads} --resistivity 22nohm.m"));
    let [below, at, above] = points(&answer) else { panic!("{answer}") };
    let gap = |point: &Value| number(&point["mean_gap"]);
    close(number(&at["stiffness"]), 0.2e6 / (gap(below) - gap(above)), 0.01);
}

#[test]
fn numbers_that_conduct_nothing_sensible_are_refused() {
    let at = &surface();
    at.refuses_each(
        &format!("{SOLVE} --pressure 1MPa"),
        &[
            ("--resistivity -1nohm.m", &["negative"]),
            ("--resistivity 5", &["unit"]),
            ("--resistivity 1nohm.m,2nohm.m,3nohm.m", &["two"]),
            ("--conductivity 5W/K", &["W/m/K"]),
            ("--conductivity nanW/m/K", &["finite"]),
        ],
    );
    // The limits are allowed: a superconductor and an insulator.
    let point = |option: &str| points(&solved(at, option))[0].clone();
    let short = point("--pressure 20MPa --resistivity 0ohm.m");
    assert!(short["electrical_conductance"].is_null() && short["contact_set"] == "part", "{short}");
    let none = point("--pressure 20MPa --conductivity 0W/m/K,50W/m/K");
    assert!(number(&none["thermal_conductance"]).abs() < 1e-300, "{none}");
}
