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
