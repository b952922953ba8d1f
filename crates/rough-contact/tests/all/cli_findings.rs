//! A finding is the same in JSON, on the terminal and on the page.

use crate::cli::{TestFolder, UNITS, folder, has, list};
use serde_json::Value;

const INTERPOLATED: &str = "Result depends on interpolation between points";

/// White noise: waves of two points, which no grid error bar covers.
fn noise() -> TestFolder {
    let at = folder();
    at.matrix("noise.txt", 32, 32, |iy, ix| {
        let i = (32 * iy + ix) as u64;
        let mixed = (i + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        ((mixed ^ (mixed >> 29)).wrapping_mul(0xBF58_476D_1CE4_E5B9) >> 40) as f64 / 1e7
    });
    at
}

/// Claims and texts of an array of findings, those that passed left out.
fn open(findings: &Value) -> Vec<(String, String)> {
    let text = |f: &Value, key: &str| f[key].as_str().unwrap().to_owned();
    let subjects = ["material", "surface", "grid", "solution", "edges", "plan"];
    for f in list(findings) {
        assert!(["check", "note", "passed"].contains(&f["weight"].as_str().unwrap()));
        assert!(subjects.contains(&f["subject"].as_str().unwrap()));
        for key in ["claim", "text"] {
            assert!(!text(f, key).contains('<'), "plain text: {f}");
        }
    }
    let open = list(findings).iter().filter(|f| f["weight"] != "passed");
    open.map(|f| (text(f, "claim"), text(f, "text"))).collect()
}

#[test]
fn solve_says_on_the_terminal_what_its_json_says() {
    let at = &noise();
    let line = format!("solve noise.txt {UNITS} --modulus 1GPa --pressure 1MPa,9MPa");
    let json = at.answer(&line);
    let found = open(&json["findings"]);
    assert!(found.iter().any(|(claim, _)| claim.starts_with(INTERPOLATED)), "{found:?}");
    assert!(list(&json["findings"]).iter().any(|f| f["subject"] == "grid"), "{json}");
    let text = at.run(&line).out;
    for (claim, effect) in found.iter().take(3) {
        has(&text, &[claim, &effect.replace('\u{202F}', " ")]);
    }
    // A surface that is resolved has nothing to check.
    let at = &folder();
    at.matrix("waves.txt", 64, 64, |iy, ix| {
        let wave = |i: usize| (i as f64 * std::f64::consts::TAU / 32.0).cos();
        wave(iy) * wave(ix)
    });
    let line = "solve waves.txt --pixel 1um --height-unit nm --modulus 1GPa --pressure 9kPa";
    assert_eq!(at.answer(line)["findings"], Value::Array(vec![]));
}

#[test]
fn page_terminal_and_results_of_a_study_agree() {
    let at = &noise();
    let line = "compare noise.txt --modulus 1GPa --pressure 1MPa,9MPa --out out";
    let said = at.done(&format!("{line} {UNITS}")).out;
    let page = at.read("out/report.html");
    let surface = &at.results("out")["surfaces"][0];
    // The finer grid was solved unasked.
    assert!(!surface["finer"].is_null(), "{surface}");
    let found = open(&surface["findings"]);
    assert!(found.iter().any(|(claim, _)| claim.starts_with(INTERPOLATED)), "{found:?}");
    for (claim, text) in found.iter().take(3) {
        has(&said, &[&claim.replace('\u{202F}', " ")]);
        for part in [claim, text] {
            let escaped = part.replace('&', "&amp;").replace('\'', "&#39;");
            assert!(page.contains(&escaped), "{part} is not on the page");
        }
    }
    let more = found.len().saturating_sub(3);
    assert_eq!(said.contains(&format!("and {more} more")), more > 0, "{said}");
}
