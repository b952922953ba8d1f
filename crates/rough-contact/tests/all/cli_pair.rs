//! Two bodies pressed together, as a user presses them.

use crate::cli::{self, TestFolder, UNITS, bumpy, close, folder, has, list, number};
use serde_json::{Value, json};

const STEEL_AND_BRONZE: &str = "--young 210GPa --poisson 0.3 --young 100GPa --poisson 0.34";

fn bodies() -> TestFolder {
    let at = folder();
    at.matrix("a.txt", 32, 32, bumpy(0.3, 1.0, false));
    at.matrix("b.txt", 32, 32, bumpy(1.1, 1.0, false));
    at.matrix("flat.txt", 32, 32, |_, _| 0.0);
    at.matrix("negative.txt", 32, 32, bumpy(0.3, -1.0, true));
    at
}

fn solved(at: &TestFolder, rest: &str) -> Value {
    at.answer(&format!("solve {rest} {UNITS} {STEEL_AND_BRONZE}"))
}

/// What is a number of the surface and not of the clock.
fn numbers(answer: &Value) -> Vec<Value> {
    let keys =
        ["mean_pressure", "area_fraction", "mean_gap", "approach", "max_pressure", "residuals"];
    list(&answer["points"]).iter().flat_map(|p| keys.map(|key| p[key].clone())).collect()
}

/// What two bodies are to each other is tested in `surface-stats`; here what is said of it.
#[test]
fn a_pair_says_how_it_lies() {
    let at = &bodies();
    let alone = solved(at, "a.txt --pressure 1GPa");
    let flat = solved(at, "a.txt --against flat.txt --flip rows --pressure 1GPa");
    assert_eq!(numbers(&flat), numbers(&alone), "to the bit");
    let found = solved(at, "a.txt --against b.txt --pressure 1GPa --level none --shift 4.4um,0um");
    // E* is of the two together, by Johnson (4.20).
    let modulus = 1.0 / ((1.0 - 0.09) / 210e9 + (1.0 - 0.34 * 0.34) / 100e9);
    close(number(&found["modulus"]), modulus, 1e-14);
    for (body, name) in list(&found["bodies"]).iter().zip(["a.txt", "b.txt"]) {
        assert_eq!(body["name"], name);
    }
    close(number(&found["bodies"][1]["young"]), 100e9, 1e-12);
    let pair = &found["pair"];
    assert_eq!((&pair["flip"], &pair["is_rolled"]), (&json!("columns"), &json!(true)));
    // Whole points.
    close(number(&pair["shift"][1]), 4e-6, 1e-12);
    close(number(&pair["shift_asked"][1]), 4.4e-6, 1e-12);
    let mated = solved(at, "a.txt --against negative.txt --pressure 1Pa");
    close(number(&mated["points"][0]["area_fraction"]), 1.0, 1e-15);
    assert_eq!(mated["pair"]["moments"]["independent"], false);
    has(&mated["findings"].to_string(), &["a.txt and negative.txt fit into each other."]);
}

#[test]
fn both_bodies_are_named_wherever_the_answer_is() {
    let at = &bodies();
    let pair = format!("a.txt --against b.txt {UNITS}");
    has(
        &at.run(&format!("solve {pair} {STEEL_AND_BRONZE} --load 1N")).out,
        &[
            "pair: b.txt lies on a.txt, turned over as a book is closed",
            "bodies: a.txt E = 210 GPa, ν = 0.3; b.txt E = 100 GPa, ν = 0.34 (E* = 75.8",
            "moments: every model has those of the sum",
            "1.00 N",
        ],
    );
    let stats = at.answer(&format!("stats {pair}"));
    let moments = &stats["pair"]["moments"];
    for key in ["m0", "m2", "m4"] {
        let [a, b] = ["first", "second"].map(|body| number(&stats["pair"][body]["moments"][key]));
        close(number(&moments["sum"][key]), a + b, 1e-14);
        // The sum has the moments that the models get.
        close(number(&moments["composite"][key]), number(&stats[key]), 1e-12);
    }
    let model = at.answer(&format!("model GW {pair} {STEEL_AND_BRONZE} --pressure 1GPa"));
    let m2 = number(&model["inputs"]["moments"]["m2"]);
    close(m2, number(&moments["composite"]["m2"]), 1e-12);

    let how = "--models gw,persson --pressure 300MPa,1GPa --flip rows --shift 3um,0um --out one";
    let first = at.done(&format!("compare {pair} {STEEL_AND_BRONZE} {how}")).out;
    has(&first, &["a.txt against b.txt", "b.txt E = 100 GPa"]);
    let page = at.read("one/report.html");
    has(&page, &["a.txt against b.txt", "Composite surface", "a page of a wall calendar"]);
    has(&page, &["b.txt E = 100"]);
}

/// Maps of different size and spacing, missing points and options of their own.
#[test]
fn bodies_measured_differently() {
    let at = &bodies();
    // 60 points of 0.4 um: 24 um of the 32.
    let fine = bumpy(2.0, 1.0, false);
    at.matrix("fine.txt", 60, 60, |iy, ix| fine(iy, ix) / 8.0);
    let line = format!("solve a.txt --against fine.txt {UNITS} {STEEL_AND_BRONZE}");
    let line = line + " --pressure 1GPa --json --against-options";
    let run = |options: &str| {
        let words: Vec<&str> = line.split_whitespace().chain([options]).collect();
        cli::run(at.path(), &words).json()
    };
    let said = run("--pixel 0.4um --height-unit um");
    assert!((number(&said["pixel"][0]) - 0.4e-6).abs() < 1e-18, "{said}");
    assert_eq!(said["pair"]["first"]["interpolated"], true);
    assert_eq!(said["pair"]["second"]["interpolated"], false);
    let spacings = "different point spacings: 1.00\u{202F}µm and 400\u{202F}nm";
    has(&said["findings"].to_string(), &[spacings, "lie on each other"]);
    // A mistake among them is refused as one of --against-options.
    has(run("--pixl 1um")["error"]["message"].as_str().unwrap(), &["--against-options"]);

    // Missing points are the second body's.
    at.matrix("holes.txt", 32, 32, |iy, ix| {
        if iy == 7 && ix < 4 { f64::NAN } else { bumpy(1.1, 1.0, false)(iy, ix) }
    });
    let holes = format!("solve a.txt --against holes.txt {UNITS} --modulus 50GPa --pressure 1GPa");
    at.refuses(&holes, &["holes.txt", "--fill"]);
    let said = at.answer(&format!("{holes} --fill harmonic"));
    let found = said["findings"].to_string();
    has(&found, &["holes.txt: 0.39\u{202F}% of the points were missing"]);
    assert!(said["bodies"].is_null());
}

/// Several files on one second body: a row each, and what is kept knows of the second body.
#[test]
fn several_files_are_each_pressed_on_the_second_body() {
    let at = &bodies();
    let line = format!("solve a.txt flat.txt --against b.txt {UNITS} --modulus 50GPa --load 1N");
    let line = line + " --out out --resume";
    has(&at.done(&line).out, &["against", "b.txt", "load", "1.00 N"]);
    has(&at.read("out/table.csv"), &["load (N)", "load_area (m^2)"]);
    has(&at.run(&line).out, &["2 of 2 answers were there already"]);
    at.matrix("b.txt", 32, 32, bumpy(1.7, 1.0, false));
    let again = at.done(&line).out;
    assert!(!again.contains("there already"), "{again}");
}

#[test]
fn pairs_that_make_no_sense_are_refused() {
    let at = &bodies();
    at.matrix("slope.txt", 32, 32, |iy, ix| ((iy * iy + 3 * ix) as f64).sqrt());
    let row = |i: i32| format!("{i} {}\n", (f64::from(i) * 0.7).sin());
    let line = (0..64).map(row).collect::<String>();
    at.file("trace.txt", &format!("x [um] z [um]\n{line}"));
    at.refuses_each(
        &format!("solve {UNITS} --modulus 1GPa --pressure 1MPa"),
        &[
            ("a.txt --against nothing.txt", &["nothing.txt"]),
            (
                "a.txt --against slope.txt --shift 32um,0um",
                &["a.txt against slope.txt", "shift less"],
            ),
            ("a.txt --against slope.txt --shift 1m,0um", &["shift less"]),
            ("a.txt --against slope.txt --shift 31um,0um", &["1 rows or columns", "at least 2"]),
            ("a.txt --against b.txt --shift 5um", &["DX,DY"]),
            ("a.txt --against b.txt --shift 5,5", &["no unit"]),
            ("a.txt --against b.txt --flip over", &["columns", "rows", "none"]),
            ("a.txt --flip rows", &["--against"]),
            ("a.txt --shift 1um,1um", &["--against"]),
            ("a.txt --against trace.txt", &["trace.txt", "profile"]),
            ("trace.txt --against a.txt", &["trace.txt", "profile"]),
        ],
    );
    let typed = "model gw --m0 1um2 --m2 1e-3 --m4 1e9m-2 --modulus 1GPa --pressure 1MPa";
    at.refuses(&format!("{typed} --against b.txt"), &["--against", "add"]);
    at.refuses("compare --against b.txt --out x", &["--against", "FILE"]);
    let trace = format!("compare a.txt --against trace.txt {UNITS} --modulus 1GPa --out x");
    at.refuses(&trace, &["trace.txt", "profile"]);
}
