//! Cleaning is done when asked for, in a fixed order, and reported everywhere.

use crate::cli;

use cli::{folder, matrix, number, refused, rough_contact};
use serde_json::{Value, json};
use std::path::Path;

const READ: &str = "--pixel 1um --height-unit um";

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

fn stats(at: &Path, line: &str) -> Value {
    rough_contact(at, &format!("stats {line} {READ} --json")).answered()
}

#[test]
fn nothing_is_cleaned_unless_asked() {
    let dir = folder();
    let at = dir.path();
    matrix(at, "spiky.txt", 48, 64, spiky);
    let plain = stats(at, "spiky.txt");
    assert_eq!(plain["cleaning"], json!([]));
    assert!((number(&plain["peak_height"]) - 5e-6).abs() < 0.05e-6);
    let text = rough_contact(at, &format!("stats spiky.txt {READ}")).out;
    assert!(!text.contains("clean"), "{text}");
    let solve = format!("solve spiky.txt {READ} --modulus 70GPa --pressure 10MPa --quiet --json");
    assert_eq!(rough_contact(at, &solve).answered()["cleaning"], json!([]));
}

#[test]
fn a_spike_is_removed_and_reported() {
    let dir = folder();
    let at = dir.path();
    matrix(at, "spiky.txt", 48, 64, spiky);
    matrix(at, "rough.txt", 48, 64, rough);
    let options = "--outliers 8 --fill harmonic";
    let cleaned = stats(at, &format!("spiky.txt {options}"));
    let step = &cleaned["cleaning"][0];
    assert_eq!(cleaned["cleaning"].as_array().unwrap().len(), 1);
    assert_eq!((&step["step"], &step["count"]), (&json!("outliers"), &json!(1)));
    assert!((number(&step["largest"]) - 5e-6).abs() < 0.05e-6);
    assert_eq!(number(&step["threshold"]).to_bits(), 8f64.to_bits());
    assert_eq!(cleaned["missing"], 1);
    let without = stats(at, "rough.txt");
    let ratio = number(&cleaned["rms_height"]) / number(&without["rms_height"]);
    assert!((ratio - 1.0).abs() < 1e-3, "{ratio}");
    let text = rough_contact(at, &format!("stats spiky.txt {READ} {options}"));
    assert!(text.out.starts_with("cleaned: 1 spike removed: more than "), "{}", text.out);

    // The point has to be filled somehow, and nobody said how.
    let line = format!("stats spiky.txt {READ} --outliers 8");
    refused(at, &line, 2, &["1 spike", "--fill harmonic", "threshold"]);
    // Where there is no spike, none has to be.
    let none = stats(at, "rough.txt --outliers 8");
    assert_eq!(none["cleaning"][0]["count"], 0);
    assert_eq!(none["rms_height"], without["rms_height"]);
}

#[test]
fn a_sphere_is_removed_and_its_radius_reported() {
    let dir = folder();
    let at = dir.path();
    matrix(at, "ball.txt", 48, 64, ball);
    matrix(at, "rough.txt", 48, 64, rough);
    let cleaned = stats(at, "ball.txt --form sphere");
    let step = &cleaned["cleaning"][0];
    assert_eq!((&step["step"], &step["form"]), (&json!("form"), &json!("sphere")));
    assert!((number(&step["radius"]) / 2e-3 - 1.0).abs() < 0.05, "{step}");
    assert!((number(&step["apex"][0]) - 20e-6).abs() < 1e-6, "{step}");
    assert!((number(&step["apex"][1]) - 30e-6).abs() < 1e-6, "{step}");
    let flat = stats(at, "rough.txt");
    for key in ["rms_height", "m4"] {
        let ratio = number(&cleaned[key]) / number(&flat[key]);
        assert!((ratio - 1.0).abs() < 5e-3, "{key}: {ratio}"); // a fit takes a little relief
    }
    // The same for contact: the cleaned ball is nearly the rough flat.
    let load = "--modulus 70GPa --pressure 50MPa --quiet --json";
    let solve =
        |options: &str| rough_contact(at, &format!("solve {options} {READ} {load}")).answered();
    let of_ball = solve("ball.txt --form sphere");
    assert_eq!(of_ball["cleaning"][0]["form"], "sphere");
    let area = |solved: &Value| number(&solved["points"][0]["area_fraction"]);
    let ratio = area(&of_ball) / area(&solve("rough.txt"));
    assert!((ratio - 1.0).abs() < 0.1, "{ratio}");
}

/// A form that is removed and points that are filled do not take away the steps of the data.
#[test]
fn height_steps_are_still_seen_after_a_form_is_removed() {
    let dir = folder();
    let at = dir.path();
    // Smooth waves on the ball, in steps of 20 nm that make more than a quarter of m4.
    let stepped = |iy, ix| {
        let waves = 0.1 * (0.5 * ix as f64).sin() * (0.4 * iy as f64).cos();
        ((ball(iy, ix) - rough(iy, ix) + waves) / 0.02).round() * 0.02
    };
    matrix(at, "stepped.txt", 48, 64, stepped);
    let step = |options: &str| {
        let found = stats(at, &format!("stepped.txt {options}"));
        let warned = found["warnings"].to_string().contains("stepped");
        (found["height_step"].as_f64(), warned)
    };
    for options in ["", "--form sphere", "--form sphere --outliers 8 --fill harmonic"] {
        let (step, _) = step(options);
        assert!((step.unwrap() / 20e-9 - 1.0).abs() < 1e-6, "{options}: {step:?}");
    }
    assert!(step("--form sphere").1, "no warning");
    assert_eq!(step("--form sphere --s-filter 8um").0, None);
}

#[test]
fn an_s_filter_changes_m4_and_is_repeated_from_the_run_file() {
    let dir = folder();
    let at = dir.path();
    matrix(at, "spiky.txt", 48, 64, spiky);
    let options = "--outliers 8 --form plane --s-filter 6um --l-filter 40um --fill nearest";
    let raw = number(&stats(at, "spiky.txt --outliers 8 --fill nearest")["m4"]);
    let cleaned = stats(at, &format!("spiky.txt {options}"));
    assert!(number(&cleaned["m4"]) < 1e-2 * raw, "{} {raw}", cleaned["m4"]);
    let steps = |v: &Value| -> Vec<String> {
        v.as_array().unwrap().iter().map(|s| s["step"].as_str().unwrap().to_owned()).collect()
    };
    assert_eq!(steps(&cleaned["cleaning"]), ["outliers", "form", "s_filter", "l_filter"]);

    let study = format!("compare spiky.txt {READ} {options} --modulus 70GPa --pressure 10MPa");
    let first = rough_contact(at, &format!("{study} --out first --json --quiet")).answered();
    let again = "compare --from first/run.toml --out again --json --quiet";
    let again = rough_contact(at, again).answered();
    let surface = |v: &Value| v["surfaces"][0].clone();
    let (first, again) = (surface(&first), surface(&again));
    assert_eq!(first["cleaning"], cleaned["cleaning"]);
    assert_eq!(again["cleaning"], first["cleaning"]);
    assert_eq!(again["statistics"], first["statistics"]);
    assert_eq!(again["origin"], first["origin"]);
    assert_eq!(first["statistics"]["missing"], 1);

    let report = std::fs::read_to_string(at.join("first/report.html")).unwrap();
    for part in ["1 spike removed", "plane fitted to", "S-filter: waves shorter than 6.0000 µm"] {
        assert!(report.contains(part), "{part:?} is not in the report");
    }
    let other = "compare --from first/run.toml --s-filter 8um --out third";
    refused(at, other, 2, &["--s-filter"]);
}

#[test]
fn cleaning_that_makes_no_sense_is_refused() {
    let dir = folder();
    let at = dir.path();
    matrix(at, "rough.txt", 24, 24, rough);
    let stats = format!("stats rough.txt {READ}");
    for (options, parts) in [
        ("--outliers 0", &["greater than 0", "8 is usual"][..]),
        ("--outliers -8", &["greater than 0"]),
        ("--outliers 8um", &["pure number", "8"]),
        ("--outliers nan", &["not a finite number"]),
        ("--form ball", &["ball", "sphere", "polynomial:N"]),
        ("--form polynomial:13", &["polynomial:13", "12"]),
        ("--s-filter 5", &["has no unit", "5um"]),
        ("--l-filter 5e-6", &["has no unit"]),
        ("--s-filter 1um", &["1e-6 m", "2e-6 m", "leave it out"]),
        ("--s-filter -5um", &["2e-6 m"]),
        ("--s-filter 9um --l-filter 5um", &["9e-6 m", "5e-6 m", "shorter cut-off"]),
    ] {
        refused(at, &format!("{stats} {options}"), 2, parts);
    }
    let typed = "model gw --m0 1um^2 --m2 0.01 --m4 1e9m^-2 --modulus 1GPa --pressure 1MPa";
    refused(at, &format!("{typed} --s-filter 5um"), 2, &["FILE"]);
    refused(at, "compare --out r --s-filter 5um", 2, &["FILE"]);
}
