//! `--accuracy`: a request that is met, and requests that the data cannot support.
#![allow(clippy::unwrap_used, reason = "a check that cannot be made has failed")]

mod cli;

use cli::{folder, refused, rough_contact};
use serde_json::Value;
use std::path::Path;

/// A surface of 192² points of 1 um with these shortest waves (um), and how to read it.
fn surface(folder: &Path, cutoff: f64, more: &str) -> &'static str {
    let made = rough_contact(
        folder,
        &format!(
            "synth --shape 192,192 --pixel 1um --hurst 0.8 --rolloff 48um --cutoff {cutoff}um \
             --rms-gradient 0.1 --seed 11 --out map.npy --force --quiet {more}"
        ),
    );
    assert_eq!(made.status, 0, "{}", made.err);
    "solve map.npy --pixel 1um --height-unit m --modulus 1GPa --quiet --json --threads 1"
}

fn areas(answer: &Value) -> Vec<f64> {
    let points = answer["points"].as_array().unwrap();
    points.iter().map(|p| p["area_fraction_corrected"].as_f64().unwrap()).collect()
}

/// An oversampled map is coarsened for a loose request and refined for a tight one. The areas lie
/// within the request of those on a grid four times as fine as the given one, and every point
/// comes with its interval.
#[test]
fn the_grid_follows_the_request() {
    let folder = folder();
    let solve = surface(folder.path(), 12.0, "");
    let loads = "--pressure 8MPa,2MPa,30MPa";
    let reference = rough_contact(folder.path(), &format!("{solve} {loads} --accuracy 0.7%"));
    let truth = areas(&reference.json());
    let mut sides = Vec::new();
    for (percent, met) in [(20.0, true), (5.0, true), (2.0, true)] {
        let line = format!("{solve} {loads} --accuracy {percent}%");
        let answer = rough_contact(folder.path(), &line).answered();
        let plan = &answer["accuracy"];
        assert_eq!(plan["met"], met, "{plan}");
        assert!(plan["half_width"].as_f64().unwrap() <= percent / 100.0);
        assert_eq!(plan["grid"], answer["shape"]);
        assert_eq!(plan["precision"], answer["precision"]);
        assert_eq!(plan["tolerance"], answer["tolerance"]);
        for (found, truth) in areas(&answer).iter().zip(&truth) {
            assert!((found / truth - 1.0).abs() < percent / 100.0, "{percent} %: {found} {truth}");
        }
        for point in answer["points"].as_array().unwrap() {
            let [low, high] = [0, 1].map(|i| point["area_interval"][i].as_f64().unwrap());
            let area = point["area_fraction_corrected"].as_f64().unwrap();
            assert!((0.5 * (high - low) / area) <= percent / 100.0 && low < area && area < high);
        }
        sides.push(plan["grid"][0].as_u64().unwrap());
    }
    assert!(sides[0] < 192 && sides[0] < sides[1] && sides[1] < sides[2], "{sides:?}");
    // The same choice again, on other threads, and without JSON one line of it.
    let line = format!("{solve} {loads} --accuracy 5%");
    let again = rough_contact(folder.path(), &line.replace("--threads 1", "--threads 3"));
    assert_eq!(again.answered()["accuracy"]["grid"][0].as_u64(), Some(sides[1]));
    let text = rough_contact(folder.path(), &line.replace("--json", "")).out;
    let last = text.trim_end().lines().last().unwrap().to_owned();
    assert!(last.contains("f32, tolerance 1e−3: ±") && last.contains("next better: "), "{last}");
}

/// Stepped heights, waves of two points, contacts of a few points: what was computed is printed,
/// marked, with exit status 1 and the reason; nothing finer than the given grid is computed.
#[test]
fn what_the_data_cannot_support_is_said() {
    for (cutoff, more, load, why) in [
        (8.0, "--quantise 200nm", "5MPa", "height step is"),
        (2.0, "", "5MPa", "shortest waves are not resolved"),
        (4.0, "", "0.1MPa", "even 768² points would"),
    ] {
        let folder = folder();
        let solve = surface(folder.path(), cutoff, more);
        let said =
            rough_contact(folder.path(), &format!("{solve} --pressure {load} --accuracy 1%"));
        let answer = said.json();
        assert_eq!(said.status, 1, "{why}: {answer}");
        let plan = &answer["accuracy"];
        assert_eq!(plan["met"], false);
        let reason = plan["reason"].as_str().unwrap();
        assert!(reason.contains(why), "{reason}");
        assert!(said.err.contains(reason), "{}", said.err);
        assert_eq!(answer["error"]["kind"], "accuracy_not_met");
        assert_eq!(plan["grid"], serde_json::json!([192, 192]));
        assert!(answer["points"][0]["area_fraction"].as_f64().unwrap() > 0.0);
    }
}

/// A single point in contact is solved exactly and says nothing about the area of the surface;
/// contact everywhere has no line and no error of the grid.
#[test]
fn one_point_of_contact_is_no_accuracy_and_full_contact_is() {
    let folder = folder();
    let solve = surface(folder.path(), 12.0, "");
    let said = rough_contact(folder.path(), &format!("{solve} --pressure 1mPa --accuracy 5%"));
    let answer = said.json();
    assert_eq!((said.status, &answer["accuracy"]["met"]), (1, &Value::Bool(false)), "{answer}");
    assert_eq!(answer["accuracy"]["half_width"], Value::Null);
    let full = format!("{solve} --pressure 10GPa --accuracy 0.1%");
    let answer = rough_contact(folder.path(), &full).answered();
    assert_eq!(answer["points"][0]["area_fraction"], 1.0);
    assert_eq!(answer["accuracy"]["met"], true);
}

#[test]
fn what_cannot_be_planned_is_refused() {
    let folder = folder();
    let solve = surface(folder.path(), 8.0, "").replace("--json ", "");
    let line = |more: &str| format!("{solve} --pressure 1MPa {more}");
    refused(folder.path(), &line("--accuracy 2"), 2, &["'2'", "write a percentage", "2%"]);
    refused(folder.path(), &line("--accuracy 0%"), 2, &["0 %", "greater than 0"]);
    refused(folder.path(), &line("--accuracy 2% --tolerance 1e-3"), 2, &["--tolerance"]);
    refused(folder.path(), &line("--accuracy 2% --precision f32"), 2, &["--precision"]);
    let free = line("--accuracy 2% --boundary free");
    refused(folder.path(), &free, 2, &["--boundary free", "--tolerance"]);
    let gap = format!("{solve} --gap 10nm --accuracy 2%");
    refused(folder.path(), &gap, 2, &["--gap"]);
}

/// A study: its deterministic side on the grid that was chosen, models on the map as it is, the
/// line in the text, in the report and in the results; `run.toml` repeats the request.
#[test]
fn a_study_takes_a_request_and_repeats_it() {
    let folder = folder();
    surface(folder.path(), 12.0, "");
    let line = "compare map.npy --pixel 1um --height-unit m --modulus 1GPa --pressure 3MPa,10MPa \
                --accuracy 15% --json --quiet --threads 2";
    let first = rough_contact(folder.path(), &format!("{line} --out one")).answered();
    let study = &first["surfaces"][0]["deterministic"];
    let plan = &study["accuracy"];
    assert_eq!(plan["met"], true, "{plan}");
    assert_eq!(plan["given"], serde_json::json!([192, 192]));
    assert_eq!(plan["grid"], study["shape"]);
    assert!(plan["factor"].as_f64().unwrap() < 1.0, "{plan}");
    for point in study["points"].as_array().unwrap() {
        let [low, high] = [0, 1].map(|i| point["area_interval"][i].as_f64().unwrap());
        let area = point["area_fraction_corrected"].as_f64().unwrap();
        assert!((high - low) / area <= 0.3 && low < area && area < high);
    }
    // The models were given the map itself: the same inputs as in a study without a request.
    let plain = line.replace("--accuracy 15% ", "");
    let plain = rough_contact(folder.path(), &format!("{plain} --out plain")).answered();
    assert_eq!(first["surfaces"][0]["inputs"], plain["surfaces"][0]["inputs"]);
    assert_eq!(plain["surfaces"][0]["deterministic"]["accuracy"], Value::Null);

    let read = |name: &str| std::fs::read_to_string(folder.path().join(name)).unwrap();
    assert!(read("one/run.toml").contains("accuracy = 0.15"));
    let explanation = plan["explanation"].as_str().unwrap();
    assert!(read("one/report.html").contains(explanation), "{explanation}");

    let repeat = "compare --from one/run.toml --out two --json --quiet --threads 1";
    let second = rough_contact(folder.path(), repeat).answered();
    let again = &second["surfaces"][0]["deterministic"];
    assert_eq!(again["accuracy"]["grid"], plan["grid"]);
    for (a, b) in areas(study).iter().zip(areas(again)) {
        assert!((a / b - 1.0).abs() < 1e-9, "{a} {b}");
    }
    // The lightest load of a tight request is beyond the data: exit status 1, all of it written.
    let tight = line.replace("15%", "0.1%");
    let said = rough_contact(folder.path(), &format!("{tight} --out tight"));
    assert_eq!(said.status, 1, "{}", said.err);
    assert_eq!(said.json()["error"]["kind"], "accuracy_not_met");
    assert!(read("tight/report.html").contains("not met"));
}
