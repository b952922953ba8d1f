//! What is said before harm: yield, slopes, units, loads beyond a theory.

use crate::cli;

use cli::{folder, matrix, rough_contact};
use serde_json::Value;
use std::path::Path;

/// Crossed waves of 32 points, 1 by height unit.
fn waves(folder: &Path) {
    matrix(folder, "waves.txt", 64, 64, |iy, ix| {
        let wave = |i: usize| (i as f64 * std::f64::consts::TAU / 32.0).cos();
        wave(iy) * wave(ix)
    });
}

fn claim(findings: &Value, index: usize) -> &str {
    findings[index]["claim"].as_str().unwrap()
}

#[test]
fn yield_is_said_before_the_numbers_of_a_solve() {
    let folder = folder();
    waves(folder.path());
    let line = "solve waves.txt --pixel 1um --height-unit um --modulus 110GPa --pressure 1GPa";
    let json = rough_contact(folder.path(), &format!("{line} --json")).answered();
    let first = &json["findings"][0];
    assert_eq!(first["subject"], "material");
    let text = first["text"].as_str().unwrap();
    assert!(text.contains("for a hardness H of at least 15\u{202F}GPa"), "{text}");
    let said = rough_contact(folder.path(), line).out;
    let numbers = said.find("FFT pairs").unwrap();
    assert!(said.find("hardness H").is_some_and(|at| at < numbers), "{said}");
}

/// A tilt left in moves the area: said where the map does not repeat, and not where it does.
#[test]
fn a_tilt_left_in_is_said() {
    let folder = folder();
    waves(folder.path());
    matrix(folder.path(), "tilted.txt", 64, 64, |iy, ix| {
        (0.2 * iy as f64).sin() + 0.05 * ix as f64
    });
    for (asked, is_said) in [
        ("tilted.txt --level none", true),
        ("tilted.txt --level mean", true),
        ("tilted.txt", false),
        ("waves.txt --level none", false),
    ] {
        let load = "--pixel 1um --height-unit um --modulus 110GPa --pressure 1GPa --json";
        let json = rough_contact(folder.path(), &format!("solve {asked} {load}")).answered();
        let found = json["findings"].as_array().unwrap();
        let tilted = |f: &Value| f["claim"].as_str().unwrap().starts_with("A plane explains");
        assert_eq!(found.iter().any(tilted), is_said, "{asked}");
    }
}

/// A file in mm read as m: the unit is asked for first, and nothing passes beside it.
#[test]
fn a_mistyped_unit_is_asked_for_first_by_every_command() {
    let folder = folder();
    waves(folder.path());
    let file = "waves.txt --pixel 1um --height-unit mm --modulus 110GPa --pressure 1GPa";
    for line in [format!("solve {file}"), format!("model gw {file}")] {
        let json = rough_contact(folder.path(), &format!("{line} --json")).answered();
        assert_eq!(claim(&json["findings"], 0), "Is the unit right?", "{line}");
        let said = rough_contact(folder.path(), &line).out;
        assert!(said.starts_with("check: Is the unit right?"), "{said}");
    }
    let said = rough_contact(folder.path(), &format!("compare {file} --out out --json"));
    let surface = &said.answered()["surfaces"][0];
    assert_eq!(claim(&surface["findings"], 0), "Is the unit right?");
    let all = surface["findings"].as_array().unwrap();
    assert!(all.iter().all(|f| f["weight"] != "passed"), "{all:?}");
    for model in surface["models"].as_array().unwrap() {
        assert_ne!(model["verdict"], "yes", "{model}");
    }
    let page = std::fs::read_to_string(folder.path().join("out/report.html")).unwrap();
    assert!(!page.contains(">Passed<"));
}

#[test]
fn more_than_the_whole_surface_is_no_answer() {
    let folder = folder();
    let moments = "--m0 0.01um^2 --m2 0.01 --m4 1e11m^-2 --modulus 110GPa";
    for model in ["gw", "bgt", "greenwood-elliptical"] {
        let line = format!("model {model} {moments} --pressure 1MPa,100GPa --json");
        let said = rough_contact(folder.path(), &line);
        assert_eq!(said.status, 2, "{model}: {}", said.err);
        let points = said.json()["points"].clone();
        assert!(points[0]["error"].is_null(), "{points}");
        assert!(points[1]["area_fraction"].is_null(), "{points}");
        assert_eq!(points[1]["error"]["quantity"], "area fraction", "{points}");
        assert!(points[1]["error"]["value"].as_f64().unwrap() > 1.0);
    }
}

/// A tilted map: no command leaves the tilt in unless it is told to, and each says so.
#[test]
fn every_command_takes_the_same_form_off_and_says_so() {
    let folder = folder();
    matrix(folder.path(), "tilted.txt", 64, 64, |iy, ix| {
        let wave = |i: usize| (i as f64 * std::f64::consts::TAU / 16.0).cos();
        0.02 * wave(iy) * wave(ix) + 0.004 * ix as f64
    });
    let file = "tilted.txt --pixel 1um --height-unit um";
    let load = "--modulus 110GPa --pressure 10MPa";
    let asked = |line: &str| rough_contact(folder.path(), &format!("{line} --json")).answered();
    let solved = asked(&format!("solve {file} {load}"));
    let model = asked(&format!("model persson {file} {load}"));
    let study = asked(&format!("compare {file} {load} --models persson --out out"));
    let stats = asked(&format!("stats {file}"));
    for answer in [&solved, &model, &stats, &study["surfaces"][0]["statistics"]] {
        assert_eq!(answer["level"], "plane", "{answer}");
    }
    assert_eq!(study["settings"]["level"], "auto");
    let surface = &study["surfaces"][0];
    let near = |a: &Value, b: &Value| {
        let (a, b) = (a.as_f64().unwrap(), b.as_f64().unwrap());
        assert!((a / b - 1.0).abs() < 1e-9, "{a} {b}");
    };
    // One set of moments, named in both, and so one answer.
    assert_eq!(model["inputs"]["source"], "finite-differences");
    assert_eq!(surface["inputs"]["source"], "finite-differences");
    for key in ["m0", "m2", "m4"] {
        near(&model["inputs"]["moments"][key], &surface["inputs"]["moments"][key]);
    }
    let of_study = &surface["models"][0]["points"][0]["area_fraction"];
    near(&model["points"][0]["area_fraction"], of_study);
    assert!(model["points"][0]["mean_gap"].is_number(), "{model}");
    for line in [
        format!("solve {file} {load}"),
        format!("model persson {file} {load}"),
        format!("stats {file}"),
    ] {
        let said = rough_contact(folder.path(), &line).out;
        assert!(said.contains("level") && said.contains("plane"), "{said}");
    }
}

/// A sine repeats, though a plane explains three fifths of it. Left off, the plane leaves edges that match; taken off, a
/// step as high as the wave. Every command leaves it, says so, and warns of neither.
#[test]
fn a_map_that_repeats_keeps_its_plane() {
    let folder = folder();
    matrix(folder.path(), "sine.txt", 64, 64, |iy, ix| {
        let wave = |i: usize| (i as f64 * std::f64::consts::TAU / 64.0).sin();
        0.01 * (wave(iy) + wave(ix))
    });
    let file = "sine.txt --pixel 1um --height-unit um";
    let load = "--modulus 110GPa --pressure 10MPa";
    let run = |line: &str| rough_contact(folder.path(), line);
    let asked = |line: &str| run(&format!("{line} --json")).answered();
    let study = asked(&format!("compare {file} {load} --models persson --out out"));
    let of_study = &study["surfaces"][0];
    let solved = asked(&format!("solve {file} {load}"));
    for answer in [
        &solved,
        &asked(&format!("model persson {file} {load}")),
        &asked(&format!("stats {file}")),
        &of_study["statistics"],
    ] {
        assert_eq!(answer["level"], "mean", "{answer}");
    }
    let as_given = asked(&format!("solve {file} {load} --level none"));
    let area = |answer: &Value| answer["area_fraction"].as_f64().unwrap();
    let expected = area(&as_given["points"][0]);
    assert!((area(&solved["points"][0]) / expected - 1.0).abs() < 1e-3);
    assert!((area(&of_study["deterministic"]["points"][0]) / expected - 1.0).abs() < 1e-3);
    // Taken off on demand it changes the answer by much.
    let without = asked(&format!("solve {file} {load} --level plane"));
    assert!(area(&without["points"][0]) < 0.9 * expected, "{without}");
    for line in [format!("solve {file} {load}"), format!("stats {file}")] {
        let said = run(&line).out;
        assert!(!said.contains("plane explains") && !said.contains("Edges do not"), "{said}");
    }
    assert!(run(&format!("solve {file} {load}")).out.contains("the map repeats as it is"));
}

/// Rows that jump are no lay: every command says so, and names a step that takes it away.
#[test]
fn rows_that_jump_are_said_to_jump_and_put_in_line() {
    let folder = folder();
    matrix(folder.path(), "rows.txt", 64, 64, |iy, ix| {
        let wave = |i: usize, n: f64| (i as f64 * std::f64::consts::TAU / n).cos();
        let mixed = (iy as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 40;
        0.01 * wave(iy, 16.0) * wave(ix, 16.0) + 0.02 * (mixed as f64 / 16_777_216.0)
    });
    let file = "rows.txt --pixel 1um --height-unit um --modulus 110GPa --pressure 1MPa --json";
    let claims = |line: &str, of: &dyn Fn(&Value) -> Value| -> String {
        let json = rough_contact(folder.path(), line).answered();
        let found = of(&json);
        let list = found.as_array().unwrap().iter();
        list.map(|f| f["claim"].as_str().unwrap().to_owned()).collect::<Vec<_>>().join(" ")
    };
    let own = |json: &Value| json["findings"].clone();
    let first = |json: &Value| json["surfaces"][0]["findings"].clone();
    for align in ["", " --align-rows"] {
        let of = |command: &str| format!("{command} {file}{align}");
        for said in [
            claims(&of("solve"), &own),
            claims(&of("model gw"), &own),
            claims(&format!("{} --out out --force", of("compare")), &first),
        ] {
            assert_eq!(said.contains("Rows of the map jump"), align.is_empty(), "{said}");
            assert!(!said.contains("a lay"), "{said}");
        }
    }
    let again = rough_contact(folder.path(), "compare --from out/run.toml --out again --json");
    let step = again.answered()["surfaces"][0]["cleaning"][0]["step"].clone();
    assert_eq!(step, "rows");
}

/// A tolerance that single precision does not reach: table, findings, reason and error name the same
/// cause, and nothing says that the iteration did not converge.
#[test]
fn a_load_that_stopped_at_rounding_is_called_that_everywhere() {
    let folder = folder();
    waves(folder.path());
    let line = "solve waves.txt --pixel 1um --height-unit nm --modulus 110GPa --pressure 1MPa \
                --precision f32 --tolerance 1e-10";
    let run = rough_contact(folder.path(), &format!("{line} --json"));
    let json: Value = serde_json::from_str(&run.out).unwrap();
    let point = &json["points"][0];
    assert_eq!(run.status, 1);
    assert_eq!(point["stopped_at_rounding"], true);
    assert_eq!(point["error"]["kind"], "rounding");
    assert_eq!(claim(&json["findings"], 0), "1 of 1 load stopped at rounding.");
    assert!(point["area_interval_reason"].as_str().unwrap().contains("rounding"), "{point}");
    let said = rough_contact(folder.path(), line);
    for text in [&run.out, &run.err, &said.out, &said.err] {
        assert!(!text.contains("did not converge") && !text.contains("not converged"), "{text}");
    }
}

/// Heights of 0.1 µm on an offset of 1e9 m are what doubles leave of them: said first.
#[test]
fn heights_that_are_rounding_are_said_to_be() {
    let folder = folder();
    matrix(folder.path(), "far.txt", 64, 64, |iy, ix| {
        let wave = |i: usize| (i as f64 * std::f64::consts::TAU / 16.0).cos();
        1e9 + 1e-7 * wave(iy) * wave(ix)
    });
    let line = "solve far.txt --pixel 1um --height-unit m --modulus 110GPa --pressure 1MPa --json";
    for level in ["", " --level none"] {
        let json = rough_contact(folder.path(), &format!("{line}{level}")).json();
        assert!(claim(&json["findings"], 0).contains("is rounding"), "{}", json["findings"]);
    }
}

/// The statistics of a map carry what the map itself gives cause to: in the words of the others.
#[test]
fn statistics_carry_the_findings_of_their_map() {
    let folder = folder();
    matrix(folder.path(), "steep.txt", 64, 64, |iy, ix| {
        let wave = |i: usize| (i as f64 * std::f64::consts::TAU / 16.0).cos();
        let spike = if [iy, ix] == [20, 41] { 90.0 } else { 0.0 };
        2.0 * wave(iy) * wave(ix) + 0.5 * iy as f64 + spike
    });
    let line = "stats steep.txt --pixel 1um --height-unit um --level none";
    let json = rough_contact(folder.path(), &format!("{line} --json")).answered();
    let claims: Vec<&str> =
        json["findings"].as_array().unwrap().iter().map(|f| f["claim"].as_str().unwrap()).collect();
    let said = rough_contact(folder.path(), line).out;
    for begins in ["Slopes are too steep", "A plane explains", "1 point is a spike"] {
        let claim = claims.iter().find(|c| c.starts_with(begins));
        let claim = claim.unwrap_or_else(|| panic!("{begins}: {claims:?}"));
        assert!(said.contains(&claim.replace('\u{202F}', " ")), "{said}");
    }
    let mistyped = "stats steep.txt --pixel 1um --height-unit mm --json";
    let json = rough_contact(folder.path(), mistyped).answered();
    assert_eq!(claim(&json["findings"], 0), "Is the unit right?");
}

/// One point far above a smooth map carries the load: named with its share and its remedy.
#[test]
fn a_spike_that_carries_the_load_is_named() {
    let folder = folder();
    matrix(folder.path(), "spike.txt", 64, 64, |iy, ix| {
        let wave = |i: usize| (i as f64 * std::f64::consts::TAU / 16.0).cos();
        let spike = if [iy, ix] == [20, 41] { 0.5 } else { 0.0 };
        0.02 * wave(iy) * wave(ix) + spike
    });
    let file = "spike.txt --pixel 1um --height-unit um --modulus 110GPa --pressure 100kPa";
    let spikes = |found: &Value| {
        let list = found.as_array().unwrap();
        let is = |f: &&Value| f["claim"].as_str().unwrap().starts_with("1 point is a spike");
        list.iter().find(is).cloned()
    };
    let json = rough_contact(folder.path(), &format!("solve {file} --json")).answered();
    let found = spikes(&json["findings"]).unwrap();
    assert_eq!(found["weight"], "check");
    let text = found["text"].as_str().unwrap();
    assert!(text.contains("100\u{202F}% of the load"), "{text}");
    assert!(text.contains("outliers 8, fill harmonic"), "{text}");
    let model = rough_contact(folder.path(), &format!("model gw {file} --json")).answered();
    assert!(spikes(&model["findings"]).is_some(), "{model}");
    let line = format!("compare {file} --out out --json");
    let surface = rough_contact(folder.path(), &line).answered()["surfaces"][0].clone();
    assert_eq!(spikes(&surface["findings"]).unwrap()["weight"], "check");
    let choices = surface["choices"].as_array().unwrap();
    let without = choices.iter().find(|c| c["choice"] == "without_spikes").unwrap();
    assert!(without["area_effect"].as_f64().unwrap() > 0.5, "{without}");
    let clean = format!("solve {file} --outliers 8 --fill harmonic --json");
    assert!(spikes(&rough_contact(folder.path(), &clean).answered()["findings"]).is_none());
}

/// What was taken out is not advised again, though some of a wide spike is left.
#[test]
fn what_cleaning_leaves_of_a_wide_spike_is_not_to_be_cleaned_again() {
    let folder = folder();
    matrix(folder.path(), "wide.txt", 64, 64, |iy, ix| {
        let wave = |i: usize| (i as f64 * std::f64::consts::TAU / 16.0).cos();
        let is_spike = (20..24).contains(&iy) && (40..44).contains(&ix);
        0.02 * wave(iy) * wave(ix) + if is_spike { 0.5 } else { 0.0 }
    });
    let file = "wide.txt --pixel 1um --height-unit um --outliers 8 --fill harmonic --json";
    let load = "--modulus 110GPa --pressure 100kPa";
    let lines = [
        format!("stats {file}"),
        format!("solve {file} {load}"),
        format!("model gw {file} {load}"),
        format!("compare {file} {load} --out out"),
    ];
    let mut claims = Vec::new();
    for line in lines {
        let json = rough_contact(folder.path(), &line).answered();
        let found = json.get("findings").unwrap_or_else(|| &json["surfaces"][0]["findings"]);
        let list = found.as_array().unwrap();
        let left = list.iter().find(|f| f["claim"].as_str().unwrap().contains("still stand"));
        let left = left.unwrap_or_else(|| panic!("{line}: {found}"));
        assert!(!left["text"].as_str().unwrap().contains("fill harmonic"), "{line}: {left}");
        claims.push(left["claim"].clone());
    }
    claims.dedup();
    assert_eq!(claims.len(), 1, "{claims:?}");
}

/// Nine orders lie between MPa and mPa: the hint says so, and what the smaller one gives is no contact of a surface.
#[test]
fn a_load_below_a_point_is_said() {
    let folder = folder();
    waves(folder.path());
    let file = "waves.txt --pixel 1um --height-unit um --modulus 110GPa --quiet";
    let refused = rough_contact(folder.path(), &format!("solve {file} --pressure 10mpa"));
    assert_eq!(refused.status, 2);
    assert!(refused.err.contains("MPa (1e6 Pa) or mPa (1e-3 Pa)"), "{}", refused.err);
    let claim = "the contact is smaller than a point of the map";
    let solve = rough_contact(folder.path(), &format!("solve {file} --pressure 10mPa,100MPa"));
    assert!(solve.out.contains(&format!("At 1 of 2 loads {claim}")), "{}", solve.out);
    let compare = format!("compare {file} --models gw,persson --pressure 10mPa --out out --json");
    let found = rough_contact(folder.path(), &compare).json();
    let all = found["surfaces"][0]["findings"].as_array().unwrap();
    let is_said = |f: &Value| f["claim"] == format!("At 1 of 1 load {claim}.");
    assert!(all.iter().any(is_said), "{all:?}");
    let page = std::fs::read_to_string(folder.path().join("out/report.html")).unwrap();
    assert!(page.contains(claim));
}
