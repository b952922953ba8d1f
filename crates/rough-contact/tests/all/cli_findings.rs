//! A finding is the same in JSON, on the terminal and on the page.

use crate::cli;

use cli::{folder, matrix, rough_contact};
use serde_json::Value;
use std::path::Path;

/// White noise: waves of two points, which no grid error bar covers.
fn noise(folder: &Path) {
    matrix(folder, "noise.txt", 32, 32, |iy, ix| {
        let i = (32 * iy + ix) as u64;
        let mixed = (i + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        ((mixed ^ (mixed >> 29)).wrapping_mul(0xBF58_476D_1CE4_E5B9) >> 40) as f64 / 1e7
    });
}

/// Claims and texts of an array of findings, those that passed left out.
fn open(findings: &Value) -> Vec<(String, String)> {
    let text = |f: &Value, key: &str| f[key].as_str().unwrap().to_owned();
    let list = findings.as_array().unwrap();
    for f in list {
        assert!(["check", "note", "passed"].contains(&f["weight"].as_str().unwrap()));
        assert!(
            ["material", "surface", "grid", "solution", "edges", "plan"]
                .contains(&f["subject"].as_str().unwrap())
        );
        for key in ["claim", "text"] {
            assert!(!text(f, key).contains('<'), "plain text: {f}");
        }
    }
    let open = list.iter().filter(|f| f["weight"] != "passed");
    open.map(|f| (text(f, "claim"), text(f, "text"))).collect()
}

#[test]
fn solve_says_on_the_terminal_what_its_json_says() {
    let folder = folder();
    noise(folder.path());
    let line = "solve noise.txt --pixel 1um --height-unit um --modulus 1GPa --pressure 1MPa,9MPa";
    let json = rough_contact(folder.path(), &format!("{line} --json")).answered();
    let found = open(&json["findings"]);
    assert!(
        found.iter().any(|(claim, _)| claim.starts_with("Result depends on interpolation")),
        "{found:?}"
    );
    let found_of = |subject: &str| {
        json["findings"].as_array().unwrap().iter().any(|f| f["subject"] == subject)
    };
    assert!(found_of("grid"), "{json}");
    let text = rough_contact(folder.path(), line).out;
    for (claim, effect) in found.iter().take(3) {
        assert!(text.contains(claim), "{claim}: {text}");
        assert!(text.contains(&effect.replace('\u{202F}', " ")), "{effect}: {text}");
    }
}

#[test]
fn a_surface_that_is_resolved_has_nothing_to_check_in_a_solve() {
    let folder = folder();
    matrix(folder.path(), "waves.txt", 64, 64, |iy, ix| {
        let wave = |i: usize| (i as f64 * std::f64::consts::TAU / 32.0).cos();
        wave(iy) * wave(ix)
    });
    let line = "solve waves.txt --pixel 1um --height-unit nm --modulus 1GPa --pressure 9kPa --json";
    assert_eq!(rough_contact(folder.path(), line).answered()["findings"], Value::Array(vec![]));
}

#[test]
fn page_terminal_and_results_of_a_study_agree() {
    let folder = folder();
    noise(folder.path());
    let line = "compare noise.txt --pixel 1um --height-unit um --modulus 1GPa \
                --pressure 1MPa,9MPa --out out";
    let said = rough_contact(folder.path(), line);
    assert_eq!(said.status, 0, "{}", said.err);
    let read = |name: &str| std::fs::read_to_string(folder.path().join("out").join(name)).unwrap();
    let results: Value = serde_json::from_str(&read("results.json")).unwrap();
    let page = read("report.html");
    let found = open(&results["surfaces"][0]["findings"]);
    assert!(found.len() > 1, "{found:?}");
    for (claim, text) in found.iter().take(3) {
        assert!(said.out.contains(&claim.replace('\u{202F}', " ")), "{claim}: {}", said.out);
        for part in [claim, text] {
            let escaped = part.replace('&', "&amp;").replace('\'', "&#39;");
            assert!(page.contains(&escaped), "{part} is not on the page");
        }
    }
    let more = found.len().saturating_sub(3);
    assert_eq!(said.out.contains(&format!("and {more} more")), more > 0, "{}", said.out);
}
