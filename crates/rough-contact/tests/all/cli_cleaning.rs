//! Cleaning is done when asked for, in a fixed order, and reported everywhere.

use crate::cli::{TestFolder, UNITS, close, folder, has, list, number};
use serde_json::{Value, json};

/// Relief without pattern, ±0.02 µm: an integer hash of the position.
fn rough(iy: usize, ix: usize) -> f64 {
    let mut n = (iy as u64 * 1000 + ix as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    n = (n ^ (n >> 29)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    ((n >> 40) as f64 / 16_777_216.0 - 0.5) * 0.04
}

/// A spike of 5 µm at row 20, column 30.
fn spiky(iy: usize, ix: usize) -> f64 {
    rough(iy, ix) + if (iy, ix) == (20, 30) { 5.0 } else { 0.0 }
}

/// A ball of radius 2 mm with its highest point at row 20, column 30.
fn ball(iy: usize, ix: usize) -> f64 {
    let (y, x) = (iy as f64 - 20.0, ix as f64 - 30.0);
    rough(iy, ix) + (2000f64.powi(2) - y * y - x * x).sqrt() - 2000.0
}

/// A folder with the three.
fn maps() -> TestFolder {
    let at = folder();
    at.matrix("rough.txt", 48, 64, rough);
    at.matrix("spiky.txt", 48, 64, spiky);
    at.matrix("ball.txt", 48, 64, ball);
    at
}

fn stats(at: &TestFolder, line: &str) -> Value {
    at.answer(&format!("stats {line} {UNITS}"))
}

#[test]
fn a_spike_is_removed_and_reported() {
    let at = &maps();
    let plain = stats(at, "spiky.txt");
    assert_eq!(plain["cleaning"], json!([]), "nothing is cleaned unless asked");
    assert!((number(&plain["peak_height"]) - 5e-6).abs() < 0.05e-6);
    let cleaned = stats(at, "spiky.txt --outliers 8 --fill harmonic");
    let step = &cleaned["cleaning"][0];
    assert_eq!(list(&cleaned["cleaning"]).len(), 1);
    assert_eq!((&step["step"], &step["count"]), (&json!("outliers"), &json!(1)));
    assert!((number(&step["largest"]) - 5e-6).abs() < 0.05e-6);
    assert_eq!(number(&step["threshold"]).to_bits(), 8f64.to_bits());
    assert_eq!(cleaned["missing"], 1);
    let without = stats(at, "rough.txt");
    close(number(&cleaned["rms_height"]), number(&without["rms_height"]), 1e-3);
    let line = format!("stats spiky.txt {UNITS} --outliers 8");
    let text = at.run(&format!("{line} --fill harmonic")).out;
    assert!(text.starts_with("cleaned: 1 spike removed: more than "), "{text}");

    // The point has to be filled somehow, and nobody said how.
    at.refuses(&line, &["1 spike", "--fill harmonic", "threshold"]);
    // Where there is no spike, none has to be.
    let none = stats(at, "rough.txt --outliers 8");
    assert_eq!(none["cleaning"][0]["count"], 0);
    assert_eq!(none["rms_height"], without["rms_height"]);
}

#[test]
fn a_sphere_is_removed_and_its_radius_reported() {
    let at = &maps();
    let cleaned = stats(at, "ball.txt --form sphere");
    let step = &cleaned["cleaning"][0];
    assert_eq!((&step["step"], &step["form"]), (&json!("form"), &json!("sphere")));
    close(number(&step["radius"]), 2e-3, 0.05);
    for (found, expected) in list(&step["apex"]).iter().zip([20e-6, 30e-6]) {
        assert!((number(found) - expected).abs() < 1e-6, "{step}");
    }
}

/// A form that is removed and points that are filled do not take away the steps of the data.
#[test]
fn height_steps_are_still_seen_after_a_form_is_removed() {
    let at = &folder();
    // Smooth waves on the ball, in steps of 20 nm that make more than a quarter of m4.
    at.matrix("stepped.txt", 48, 64, |iy, ix| {
        let waves = 0.1 * (0.5 * ix as f64).sin() * (0.4 * iy as f64).cos();
        ((ball(iy, ix) - rough(iy, ix) + waves) / 0.02).round() * 0.02
    });
    let step = |options: &str| {
        let found = stats(at, &format!("stepped.txt {options}"));
        let warned = found["warnings"].to_string().contains("stepped");
        (found["height_step"].as_f64(), warned)
    };
    for options in ["", "--form sphere", "--form sphere --outliers 8 --fill harmonic"] {
        close(step(options).0.unwrap(), 20e-9, 1e-6);
    }
    assert!(step("--form sphere").1, "no warning");
    assert_eq!(step("--form sphere --s-filter 8um").0, None);
}

#[test]
fn an_s_filter_changes_m4_and_is_said() {
    let at = &maps();
    let options = "--outliers 8 --form plane --s-filter 6um --l-filter 40um --fill nearest";
    let raw = number(&stats(at, "spiky.txt --outliers 8 --fill nearest")["m4"]);
    let cleaned = stats(at, &format!("spiky.txt {options}"));
    assert!(number(&cleaned["m4"]) < 1e-2 * raw, "{} {raw}", cleaned["m4"]);
    let steps: Vec<_> = list(&cleaned["cleaning"]).iter().map(|step| &step["step"]).collect();
    assert_eq!(steps, ["outliers", "form", "s_filter", "l_filter"]);

    let study = format!("compare spiky.txt {UNITS} {options} --modulus 70GPa --pressure 10MPa");
    let first = at.answer(&format!("{study} --out first --quiet"))["surfaces"][0].clone();
    assert_eq!(first["cleaning"], cleaned["cleaning"]);
    assert_eq!(first["statistics"]["missing"], 1);
    let page = at.read("first/report.html");
    has(&page, &["1 spike removed", "plane fitted to", "S-filter: waves shorter than 6.000 µm"]);
    at.refuses("compare --from first/run.toml --s-filter 8um --out third", &["--s-filter"]);
}

#[test]
fn cleaning_that_makes_no_sense_is_refused() {
    let at = &folder();
    at.matrix("rough.txt", 24, 24, rough);
    at.refuses_each(
        &format!("stats rough.txt {UNITS}"),
        &[
            ("--outliers 0", &["greater than 0", "8 is usual"]),
            ("--outliers 8um", &["pure number", "8"]),
            ("--form ball", &["ball", "sphere", "polynomial:N"]),
            ("--form polynomial:13", &["polynomial:13", "12"]),
            ("--l-filter 5", &["has no unit", "5um"]),
            ("--s-filter 1um", &["1e-6 m", "2e-6 m", "leave it out"]),
            ("--s-filter 9um --l-filter 5um", &["9e-6 m", "5e-6 m", "shorter cut-off"]),
            ("--s-filter 5um --l-filter 5um", &["5e-6 m", "shorter cut-off"]),
        ],
    );
    // Two points are enough, along the longer side of a pixel.
    at.done(&format!("stats rough.txt {UNITS} --s-filter 2um"));
    let oblong = "stats rough.txt --pixel 2um,1um --height-unit um";
    at.done(&format!("{oblong} --s-filter 4um"));
    at.refuses(&format!("{oblong} --s-filter 3.9um"), &["3.9e-6 m", "4e-6 m"]);
    let typed = "model gw --m0 1um^2 --m2 0.01 --m4 1e9m^-2 --modulus 1GPa --pressure 1MPa";
    at.refuses(&format!("{typed} --s-filter 5um"), &["FILE"]);
    at.refuses("compare --out r --s-filter 5um", &["FILE"]);
}
