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

/// What yields is tested in `fft-bem-solver`; here under which key it stands: equilibrium, no pressure above H, at least the
/// area of load over hardness.
#[test]
fn what_has_yielded_carries_the_hardness_and_has_no_sample() {
    let at = &surface();
    let (hard, loads) = (1e9, "--pressure 20MPa,500MPa --tolerance 1e-6");
    let answer = solved(at, &format!("{loads} --hardness 1GPa"));
    for point in points(&answer) {
        let of = |key: &str| number(&point[key]);
        let (load, saturated) = (of("mean_pressure"), of("saturated_fraction"));
        close(of("plastic_load_fraction") * load, saturated * hard, 1e-9);
        close(saturated + of("elastic_area_fraction"), of("touching_fraction"), 1e-12);
        assert!(saturated > 0.0 && of("max_pressure") <= hard, "{point}");
        // How it scatters from map to map was not studied.
        assert!(point["area_prediction_interval"].is_null(), "{point}");
        assert!(number(&point["area_interval"][0]) >= load / hard * (1.0 - 1e-5), "{point}");
    }
    let ratio = number(&answer["hardness"]["modulus_gradient_over_hardness"]);
    assert!((1.0..20.0).contains(&ratio) && answer["hardness"]["warning"].is_null(), "{answer}");
    let elastic = solved(at, loads);
    assert!(elastic.get("hardness").is_none());
    assert!(points(&elastic)[0].get("saturated_fraction").is_none());
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

/// Nothing conducts without contact, and there is no end of it in full contact, which JSON cannot write. What is between is
/// in `cli_conduction.rs`.
#[test]
fn a_contact_conducts_as_stiffly_as_it_stands() {
    let at = &surface();
    let rest = "--resistivity 22nohm.m,7uohm.cm --conductivity 50W/m/K";
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
}
