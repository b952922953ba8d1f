//! Two bodies pressed together, as a user presses them.

use crate::cli;

use cli::{folder, matrix, number, refused, rough_contact};
use serde_json::Value;
use std::f64::consts::TAU;
use std::path::Path;

const FILE: &str = "--pixel 1um --height-unit um";
const STEEL_AND_BRONZE: &str = "--young 210GPa --poisson 0.3 --young 100GPa --poisson 0.34";

/// Waves of several lengths, one cell of 32 x 32; `mirrored` as seen after a turn about the y axis.
fn bumpy(seed: f64, sign: f64, mirrored: bool) -> impl Fn(usize, usize) -> f64 {
    move |iy, ix| {
        let ix = if mirrored { 31 - ix } else { ix };
        let wave = |a: f64, ky: f64, kx: f64| {
            a * (TAU * (ky * iy as f64 + kx * ix as f64) / 32.0 + seed * (ky + 2.0 * kx)).cos()
        };
        // Rounded, so that text keeps every bit and sums of two are exact.
        let height = wave(0.1, 1.0, 2.0) + wave(0.06, 3.0, -1.0) + wave(0.04, 2.0, 4.0);
        sign * (height * 1024.0).round() / 1024.0
    }
}

fn bodies(folder: &Path) {
    matrix(folder, "a.txt", 32, 32, bumpy(0.3, 1.0, false));
    matrix(folder, "b.txt", 32, 32, bumpy(1.1, 1.0, false));
    matrix(folder, "flat.txt", 32, 32, |_, _| 0.0);
    matrix(folder, "negative.txt", 32, 32, bumpy(0.3, -1.0, true));
}

fn solved(folder: &Path, rest: &str) -> Value {
    rough_contact(folder, &format!("solve {rest} {FILE} {STEEL_AND_BRONZE} --json")).answered()
}

/// What is a number of the surface and not of the clock.
fn numbers(answer: &Value) -> Vec<Value> {
    let keys =
        ["mean_pressure", "area_fraction", "mean_gap", "approach", "max_pressure", "residuals"];
    let points = answer["points"].as_array().into_iter().flatten();
    points.flat_map(|p| keys.map(|key| p[key].clone())).collect()
}

#[test]
fn a_flat_body_changes_no_bit_of_the_answer() {
    let folder = folder();
    bodies(folder.path());
    let alone = solved(folder.path(), "a.txt --pressure 100MPa,1GPa");
    for how in ["", "--flip rows", "--flip none --shift 5um,3um"] {
        let pair = solved(
            folder.path(),
            &format!("a.txt --against flat.txt {how} --pressure 100MPa,1GPa"),
        );
        assert_eq!(numbers(&pair), numbers(&alone), "{how}");
        assert_eq!(pair["findings"], alone["findings"]);
    }
}

#[test]
fn the_bodies_may_change_places() {
    let folder = folder();
    bodies(folder.path());
    let one = solved(folder.path(), "a.txt --against b.txt --pressure 500MPa");
    let other = solved(folder.path(), "b.txt --against a.txt --pressure 500MPa");
    for key in ["area_fraction", "mean_gap", "max_pressure"] {
        let (a, b) = (number(&one["points"][0][key]), number(&other["points"][0][key]));
        // The mirror image is iterated in another order: as well as the tolerance of 1e-4.
        assert!((a / b - 1.0).abs() < 1e-3, "{key}: {a} {b}");
    }
    // E* is of the two together, by Johnson (4.20).
    let modulus = 1.0 / ((1.0 - 0.09) / 210e9 + (1.0 - 0.34 * 0.34) / 100e9);
    assert!((number(&one["modulus"]) / modulus - 1.0).abs() < 1e-14);
    assert_eq!(one["bodies"][0]["name"], "a.txt");
    assert_eq!(one["bodies"][1]["name"], "b.txt");
    assert!((number(&one["bodies"][1]["young"]) - 100e9).abs() < 1.0);
    assert_eq!(one["pair"]["flip"], "columns");
}

#[test]
fn a_body_on_its_own_negative_closes_at_any_load() {
    let folder = folder();
    bodies(folder.path());
    let pair = "a.txt --against negative.txt";
    let said = solved(folder.path(), &format!("{pair} --pressure 1Pa,1GPa"));
    for point in said["points"].as_array().unwrap() {
        assert!((number(&point["area_fraction"]) - 1.0).abs() < 1e-15, "{point}");
    }
    assert_eq!(said["pair"]["moments"]["independent"], false);
    let claims = said["findings"].to_string();
    assert!(claims.contains("a.txt and negative.txt fit into each other."), "{claims}");
}

#[test]
fn a_shift_by_the_period_is_none_and_another_is_made_in_whole_points() {
    let folder = folder();
    bodies(folder.path());
    let by = |shift: &str| {
        solved(
            folder.path(),
            &format!("a.txt --against b.txt --pressure 1GPa --level none --shift {shift}"),
        )
    };
    let unmoved = numbers(&by("0um,0um"));
    assert_eq!(numbers(&by("32um,-64um")), unmoved);
    let moved = by("4.4um,0um");
    assert_ne!(numbers(&moved), unmoved);
    assert!((number(&moved["pair"]["shift"][1]) - 4e-6).abs() < 1e-18);
    assert!((number(&moved["pair"]["shift_asked"][1]) - 4.4e-6).abs() < 1e-18);
    assert_eq!(moved["pair"]["is_rolled"], true);
}

#[test]
fn both_bodies_are_named_wherever_the_answer_is() {
    let folder = folder();
    bodies(folder.path());
    let solve = format!("solve a.txt --against b.txt {FILE} {STEEL_AND_BRONZE} --load 1N");
    let text = rough_contact(folder.path(), &solve).out;
    for part in [
        "pair: b.txt lies on a.txt, turned over as a book is closed",
        "bodies: a.txt E = 210 GPa, ν = 0.3; b.txt E = 100 GPa, ν = 0.34 (E* = 75.8",
        "moments: every model has those of the sum",
        "1.00 N",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let stats = format!("stats a.txt --against b.txt {FILE}");
    let said = rough_contact(folder.path(), &format!("{stats} --json")).answered();
    let moments = &said["pair"]["moments"];
    for key in ["m0", "m2", "m4"] {
        let [a, b] = ["first", "second"].map(|body| number(&said["pair"][body]["moments"][key]));
        assert!((number(&moments["sum"][key]) / (a + b) - 1.0).abs() < 1e-14);
        // The sum has the moments that the models get.
        assert!(
            (number(&moments["composite"][key]) / number(&said[key]) - 1.0).abs() < 1e-12,
            "{key}"
        );
    }
    let model =
        format!("model GW a.txt --against b.txt {FILE} {STEEL_AND_BRONZE} --pressure 1GPa --json");
    let said_by_model = rough_contact(folder.path(), &model).answered();
    let m2 = number(&said_by_model["inputs"]["moments"]["m2"]);
    assert!((m2 / number(&moments["composite"]["m2"]) - 1.0).abs() < 1e-12);

    let line = format!(
        "compare a.txt --against b.txt {FILE} {STEEL_AND_BRONZE} --models gw,persson \
                        --pressure 300MPa,1GPa --flip rows --shift 3um,0um --out one"
    );
    let first = rough_contact(folder.path(), &line);
    assert_eq!(first.status, 0, "{}", first.err);
    assert!(first.out.contains("a.txt against b.txt") && first.out.contains("b.txt E = 100 GPa"));
    let page = std::fs::read_to_string(folder.path().join("one/report.html")).unwrap();
    for part in
        ["a.txt against b.txt", "Composite surface", "a page of a wall calendar", "b.txt E = 100"]
    {
        assert!(page.contains(part), "{part}");
    }
    let run = std::fs::read_to_string(folder.path().join("one/run.toml")).unwrap();
    assert!(run.contains("flip = \"rows\"") && run.contains("young = 100000000000.0"), "{run}");
    // The run repeats itself: everything but times.
    let again =
        rough_contact(folder.path(), "compare --from one/run.toml --out two --json").answered();
    let before = std::fs::read_to_string(folder.path().join("one/results.json")).unwrap();
    let before: Value = serde_json::from_str(&before).unwrap();
    for key in ["name", "origin", "pair", "bodies", "statistics", "inputs"] {
        assert_eq!(again["surfaces"][0][key], before["surfaces"][0][key], "{key}");
    }
    let points = |v: &Value| numbers(&v["surfaces"][0]["deterministic"]);
    assert_eq!(points(&again), points(&before));
}

/// Maps of different size and spacing, missing points and options of their own.
#[test]
fn bodies_measured_differently() {
    let folder = folder();
    bodies(folder.path());
    // 60 points of 0.4 um: 24 um of the 32.
    let fine = bumpy(2.0, 1.0, false);
    matrix(folder.path(), "fine.txt", 60, 60, |iy, ix| fine(iy, ix) / 8.0);
    let line =
        format!("solve a.txt --against fine.txt {FILE} {STEEL_AND_BRONZE} --pressure 1GPa --json");
    let own = format!("{line} --against-options");
    let run = |options: &str| {
        let words: Vec<&str> = own.split_whitespace().chain([options]).collect();
        let said = std::process::Command::new(env!("CARGO_BIN_EXE_rough-contact"))
            .current_dir(folder.path())
            .args(words)
            .output()
            .unwrap();
        serde_json::from_slice::<Value>(&said.stdout).unwrap()
    };
    let said = run("--pixel 0.4um --height-unit um");
    assert!((number(&said["pixel"][0]) - 0.4e-6).abs() < 1e-18, "{said}");
    assert_eq!(said["pair"]["first"]["interpolated"], true);
    assert_eq!(said["pair"]["second"]["interpolated"], false);
    let found = said["findings"].to_string();
    assert!(
        found.contains("different point spacings: 1.00\u{202F}µm and 400\u{202F}nm"),
        "{found}"
    );
    assert!(found.contains("lie on each other"), "{found}");
    // A mistake among them is refused as one of --against-options.
    assert!(run("--pixl 1um")["error"]["message"].as_str().unwrap().contains("--against-options"));

    // Missing points are the second body's.
    matrix(folder.path(), "holes.txt", 32, 32, |iy, ix| {
        if iy == 7 && ix < 4 { f64::NAN } else { bumpy(1.1, 1.0, false)(iy, ix) }
    });
    let holes = format!("solve a.txt --against holes.txt {FILE} --modulus 50GPa --pressure 1GPa");
    refused(folder.path(), &holes, 2, &["holes.txt", "--fill"]);
    let said = rough_contact(folder.path(), &format!("{holes} --fill harmonic --json")).answered();
    let found = said["findings"].to_string();
    assert!(found.contains("holes.txt: 0.39\u{202F}% of the points were missing"), "{found}");
    assert!(said["bodies"].is_null());
}

/// Several files on one second body: a row each, and what is kept knows of the second body.
#[test]
fn several_files_are_each_pressed_on_the_second_body() {
    let folder = folder();
    bodies(folder.path());
    let line = format!(
        "solve a.txt flat.txt --against b.txt {FILE} --modulus 50GPa --load 1N --out out --resume"
    );
    let said = rough_contact(folder.path(), &line);
    assert_eq!(said.status, 0, "{}", said.err);
    for part in ["against", "b.txt", "load", "1.00 N"] {
        assert!(said.out.contains(part), "{part}: {}", said.out);
    }
    let csv = std::fs::read_to_string(folder.path().join("out/table.csv")).unwrap();
    assert!(csv.contains("load (N)") && csv.contains("load_area (m^2)"), "{csv}");
    assert!(rough_contact(folder.path(), &line).out.contains("2 of 2 answers were there already"));
    matrix(folder.path(), "b.txt", 32, 32, bumpy(1.7, 1.0, false));
    let again = rough_contact(folder.path(), &line);
    assert!(again.status == 0 && !again.out.contains("there already"), "{}", again.out);
}

#[test]
fn pairs_that_make_no_sense_are_refused() {
    let folder = folder();
    bodies(folder.path());
    matrix(folder.path(), "slope.txt", 32, 32, |iy, ix| ((iy * iy + 3 * ix) as f64).sqrt());
    let row = |i: i32| format!("{i} {}\n", (f64::from(i) * 0.7).sin());
    let line = (0..64).map(row).collect::<Vec<_>>().concat();
    cli::file(folder.path(), "trace.txt", &format!("x [um] z [um]\n{line}"));
    let solve = |rest: &str, parts: &[&str]| {
        let all = format!("solve {rest} {FILE} --modulus 1GPa --pressure 1MPa");
        refused(folder.path(), &all, 2, parts);
    };
    solve("a.txt --against nothing.txt", &["nothing.txt"]);
    solve("a.txt --against slope.txt --shift 32um,0um", &["a.txt against slope.txt", "shift less"]);
    solve("a.txt --against slope.txt --shift 1m,0um", &["shift less"]);
    solve("a.txt --against slope.txt --shift 31um,0um", &["1 rows or columns", "at least 2"]);
    solve("a.txt --against b.txt --shift 5um", &["DX,DY"]);
    solve("a.txt --against b.txt --shift 5,5", &["no unit"]);
    solve("a.txt --against b.txt --flip over", &["columns", "rows", "none"]);
    solve("a.txt --flip rows", &["--against"]);
    solve("a.txt --shift 1um,1um", &["--against"]);
    solve("a.txt --against trace.txt", &["trace.txt", "profile"]);
    solve("trace.txt --against a.txt", &["trace.txt", "profile"]);
    let numbers = "model gw --m0 1um2 --m2 1e-3 --m4 1e9m-2 --modulus 1GPa --pressure 1MPa";
    refused(folder.path(), &format!("{numbers} --against b.txt"), 2, &["--against", "add"]);
    refused(folder.path(), "compare --against b.txt --out x", 2, &["--against", "FILE"]);
    refused(
        folder.path(),
        &format!("compare a.txt --against trace.txt {FILE} --modulus 1GPa --out x"),
        2,
        &["trace.txt", "profile"],
    );
}
