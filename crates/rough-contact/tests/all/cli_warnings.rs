//! What is said before harm, alike in JSON, terminal and page: yield, slopes, units, loads.

use crate::cli::{TestFolder, UNITS, close, folder, has, list, number};
use serde_json::Value;
use std::f64::consts::TAU;

/// A cosine of this period, in points.
fn wave(i: usize, period: f64) -> f64 {
    (i as f64 * TAU / period).cos()
}

/// `map.txt` of 64² heights.
fn map(height: impl Fn(usize, usize) -> f64) -> TestFolder {
    let at = folder();
    at.matrix("map.txt", 64, 64, height);
    at
}

/// Crossed waves of 32 points, 1 by height unit.
fn waves() -> TestFolder {
    map(|iy, ix| wave(iy, 32.0) * wave(ix, 32.0))
}

const FILE: &str = "map.txt --pixel 1um --height-unit um";
const STEEL: &str = "--modulus 110GPa --pressure";

/// The claims of the findings of an answer; of a study those of its surface.
fn claims(answer: &Value) -> Vec<&str> {
    let surface = answer.get("surfaces").map_or(answer, |all| &all[0]);
    list(&surface["findings"]).iter().map(|f| f["claim"].as_str().unwrap()).collect()
}

/// Yield; a tilt left in a map that does not repeat; 0.1 µm on 1e9 m, which is rounding.
#[test]
fn a_solve_says_what_its_map_and_load_give_cause_to() {
    let tilted = &map(|iy, ix| (0.2 * iy as f64).sin() + 0.05 * ix as f64);
    let rounded = &map(|iy, ix| 1e9 + 1e-7 * wave(iy, 16.0) * wave(ix, 16.0));
    let (plane, rounding) = ("A plane explains", "is rounding");
    for (at, unit, load, claim, is_said) in [
        (tilted, "um", "1GPa --level none", plane, true),
        (tilted, "um", "1GPa --level mean", plane, true),
        (tilted, "um", "1GPa", plane, false),
        (&waves(), "um", "1GPa --level none", plane, false),
        (rounded, "m", "1MPa", rounding, true),
        (rounded, "m", "1MPa --level none", rounding, true),
    ] {
        let line = format!("solve map.txt --pixel 1um --height-unit {unit} {STEEL} {load} --json");
        let json = at.run(&line).json();
        assert_eq!(claims(&json).iter().any(|c| c.contains(claim)), is_said, "{line}");
    }
    let at = &waves();
    let line = format!("solve {FILE} {STEEL} 1GPa");
    let first = at.answer(&line)["findings"][0].clone();
    assert_eq!(first["subject"], "material");
    has(first["text"].as_str().unwrap(), &["for H ≥ 15\u{202F}GPa"]);
    let said = at.run(&line).out;
    let numbers = said.find("convolutions").unwrap();
    assert!(said.find("for H ≥").is_some_and(|at| at < numbers), "before them: {said}");
}

/// A file in mm read as m: the unit is asked for first, and nothing passes beside it.
#[test]
fn a_mistyped_unit_is_asked_for_first_by_every_command() {
    let at = &waves();
    let file = format!("map.txt --pixel 1um --height-unit mm {STEEL} 1GPa");
    for command in ["solve", "model gw"] {
        let line = format!("{command} {file}");
        assert_eq!(claims(&at.answer(&line))[0], "Is the unit right?", "{line}");
        let said = at.run(&line).out;
        assert!(said.starts_with("check: Is the unit right?"), "{said}");
    }
    let study = at.answer(&format!("compare {file} --out out"));
    assert_eq!(claims(&study)[0], "Is the unit right?");
    let surface = &study["surfaces"][0];
    let all = list(&surface["findings"]);
    assert!(all.iter().all(|f| f["weight"] != "passed"), "{all:?}");
    for model in list(&surface["models"]) {
        assert_ne!(model["verdict"], "yes", "{model}");
    }
    assert!(!at.read("out/report.html").contains(">Passed<"));
}

/// No command leaves the tilt of a map in unless it is told to. A sine repeats, though a plane explains three fifths of it: left
/// off, the plane leaves edges that match; taken off, a step as high as the wave. Each says which form it took.
#[test]
fn every_command_takes_the_same_form_off_and_says_so() {
    let sine = |i: usize| (i as f64 * TAU / 64.0).sin();
    let tilted = &map(|iy, ix| 0.02 * wave(iy, 16.0) * wave(ix, 16.0) + 0.004 * ix as f64);
    let repeating = &map(|iy, ix| 0.01 * (sine(iy) + sine(ix)));
    let area = |answer: &Value| number(&answer["points"][0]["area_fraction"]);
    let [solve, persson] =
        ["solve", "model persson"].map(|command| format!("{command} {FILE} {STEEL} 10MPa"));
    let stats = format!("stats {FILE}");
    for (at, form) in [(tilted, "plane"), (repeating, "mean")] {
        let [solved, model, statistics] = [&solve, &persson, &stats].map(|line| at.answer(line));
        let study = at.answer(&format!("compare {FILE} {STEEL} 10MPa --models persson --out out"));
        let surface = &study["surfaces"][0];
        for answer in [&solved, &model, &statistics, &surface["statistics"]] {
            assert_eq!(answer["level"], form, "{answer}");
        }
        assert_eq!(study["settings"]["level"], "auto");
        for line in [&solve, &persson, &stats] {
            has(&at.run(line).out, &["level", form]);
        }
        // One set of moments, named in both, and so one answer.
        for of in [&model, surface] {
            assert_eq!(of["inputs"]["source"], "finite-differences");
        }
        for key in ["m0", "m2", "m4"] {
            let [a, b] = [&model, surface].map(|of| number(&of["inputs"]["moments"][key]));
            close(a, b, 1e-9);
        }
        close(area(&model), area(&surface["models"][0]), 1e-9);
        assert!(model["points"][0]["mean_gap"].is_number(), "{model}");
        close(area(&solved), area(&surface["deterministic"]), 1e-3);
    }
    let at = repeating;
    let solved = area(&at.answer(&solve));
    close(solved, area(&at.answer(&format!("{solve} --level none"))), 1e-3);
    // Taken off on demand it changes the answer by much.
    assert!(area(&at.answer(&format!("{solve} --level plane"))) < 0.9 * solved);
    for line in [&solve, &stats] {
        let said = at.run(line).out;
        assert!(!said.contains("plane explains") && !said.contains("Edges do not"), "{said}");
    }
    has(&at.run(&solve).out, &["opposite edges meet as they are"]);
}

/// Rows that jump are no lay: every command says so, and names a step that takes it away.
#[test]
fn rows_that_jump_are_said_to_jump_and_put_in_line() {
    let at = &map(|iy, ix| {
        let mixed = (iy as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 40;
        0.01 * wave(iy, 16.0) * wave(ix, 16.0) + 0.02 * (mixed as f64 / 16_777_216.0)
    });
    for align in ["", " --align-rows"] {
        for command in ["solve", "model gw", "compare --out out --force"] {
            let answer = at.answer(&format!("{command} {FILE} {STEEL} 1MPa{align}"));
            let said = claims(&answer).join(" ");
            assert_eq!(said.contains("Rows of the map jump"), align.is_empty(), "{said}");
            assert!(!said.contains("a lay"), "{said}");
        }
    }
}

/// In table, findings, reason and error; nothing says that the iteration did not converge.
#[test]
fn a_load_that_stopped_at_rounding_is_called_that_everywhere() {
    let at = &waves();
    let line = format!("solve map.txt --pixel 1um --height-unit nm {STEEL} 1MPa");
    let line = line + " --precision f32 --tolerance 1e-10";
    let run = at.run(&format!("{line} --json"));
    let json = run.json();
    let point = &json["points"][0];
    assert_eq!(run.status, 1);
    assert_eq!(point["stopped_at_rounding"], true);
    assert_eq!(point["error"]["kind"], "rounding");
    assert_eq!(claims(&json)[0], "1 of 1 load stopped at rounding.");
    has(point["area_interval_reason"].as_str().unwrap(), &["rounding"]);
    let said = at.run(&line);
    for text in [&run.out, &run.err, &said.out, &said.err] {
        assert!(!text.contains("did not converge") && !text.contains("not converged"), "{text}");
    }
}

/// The statistics of a map carry what the map itself gives cause to: in the words of the others.
#[test]
fn statistics_carry_the_findings_of_their_map() {
    let at = &map(|iy, ix| {
        let spike = if [iy, ix] == [20, 41] { 90.0 } else { 0.0 };
        2.0 * wave(iy, 16.0) * wave(ix, 16.0) + 0.5 * iy as f64 + spike
    });
    let line = format!("stats {FILE} --level none");
    let json = at.answer(&line);
    let claims_of_stats = claims(&json);
    let said = at.run(&line).out;
    for begins in ["Slopes are too steep", "A plane explains", "1 point stands far"] {
        let claim = claims_of_stats.iter().find(|c| c.starts_with(begins));
        let claim = claim.unwrap_or_else(|| panic!("{begins}: {claims_of_stats:?}"));
        has(&said, &[&claim.replace('\u{202F}', " ")]);
    }
    let mistyped = at.answer("stats map.txt --pixel 1um --height-unit mm");
    assert_eq!(claims(&mistyped)[0], "Is the unit right?");
}

/// One point far above a smooth map carries the load: named with its share and its remedy.
#[test]
fn a_spike_that_carries_the_load_is_named() {
    let at = &map(|iy, ix| {
        let spike = if [iy, ix] == [20, 41] { 0.5 } else { 0.0 };
        0.02 * wave(iy, 16.0) * wave(ix, 16.0) + spike
    });
    let file = format!("{FILE} {STEEL} 100kPa");
    let spike = |of: &Value| {
        let is = |f: &&Value| f["claim"].as_str().unwrap().starts_with("1 point stands far");
        list(&of["findings"]).iter().find(is).cloned()
    };
    let found = spike(&at.answer(&format!("solve {file}"))).unwrap();
    assert_eq!(found["weight"], "check");
    let text = found["text"].as_str().unwrap();
    has(text, &["100\u{202F}% of the load", "outliers 8, fill harmonic"]);
    assert!(spike(&at.answer(&format!("model gw {file}"))).is_some());
    let study = at.answer(&format!("compare {file} --out out"));
    let surface = &study["surfaces"][0];
    assert_eq!(spike(surface).unwrap()["weight"], "check");
    let mut choices = list(&surface["choices"]).iter();
    let without = choices.find(|c| c["choice"] == "without_spikes").unwrap();
    assert!(number(&without["area_effect"]) > 0.5, "{without}");
    let clean = format!("solve {file} --outliers 8 --fill harmonic");
    assert!(spike(&at.answer(&clean)).is_none());
}

/// What was taken out is not advised again, though some of a wide spike is left.
#[test]
fn what_cleaning_leaves_of_a_wide_spike_is_not_to_be_cleaned_again() {
    let at = &map(|iy, ix| {
        let is_spike = (20..24).contains(&iy) && (40..44).contains(&ix);
        0.02 * wave(iy, 16.0) * wave(ix, 16.0) + if is_spike { 0.5 } else { 0.0 }
    });
    let load = format!("{STEEL} 100kPa");
    for (command, rest) in
        [("stats", ""), ("solve", &*load), ("compare", &format!("{load} --out out"))]
    {
        let json = at.answer(&format!("{command} {FILE} --outliers 8 --fill harmonic {rest}"));
        let surface = json.get("surfaces").map_or(&json, |all| &all[0]);
        let mut found = list(&surface["findings"]).iter();
        let left = found.find(|f| f["claim"].as_str().unwrap().contains("still stand"));
        let left = left.unwrap_or_else(|| panic!("{command}: {surface}"));
        assert!(!left["text"].as_str().unwrap().contains("fill harmonic"), "{command}: {left}");
    }
}

/// Nine orders lie between MPa and mPa: the hint says so, and what the smaller one gives is no contact of a surface.
#[test]
fn a_load_below_a_point_is_said() {
    let at = &waves();
    let line = |command: &str, load: &str| format!("{command} {FILE} {STEEL} {load} --quiet");
    at.refuses(&line("solve", "10mpa"), &["MPa (1e6 Pa) or mPa (1e-3 Pa)"]);
    let claim = "the contact is smaller than a point of the map";
    let solve = at.run(&line("solve", "10mPa,100MPa")).out;
    has(&solve, &[&format!("At 1 of 2 loads {claim}")]);
    let study = at.run(&line("compare --models gw,persson --out out --json", "10mPa")).json();
    assert!(claims(&study).contains(&format!("At 1 of 1 load {claim}.").as_str()), "{study}");
    has(&at.read("out/report.html"), &[claim]);
}

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
    let line = "solve map.txt --pixel 1um --height-unit nm --modulus 1GPa --pressure 9kPa";
    assert_eq!(waves().answer(line)["findings"], Value::Array(vec![]));
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
