//! Bad input is refused with exit status 2 (1 for outputs), one message, and nothing else.

use crate::cli::{UNITS, close, folder, has, number};
use serde_json::json;

fn wavy(iy: usize, ix: usize) -> f64 {
    (iy as f64).sin() * (ix as f64 * 1.3).cos()
}

#[test]
fn files_that_are_no_surface() {
    let at = &folder();
    at.file("empty.txt", "");
    at.file("noise.bin", "\u{1}\u{2}\u{3}ZZZZ");
    at.file("nan.txt", "nan nan nan nan\nnan nan nan nan\nnan nan nan nan\n");
    at.file("inf.txt", "1 2 3 4\n5 inf 7 8\n9 1 2 3\n");
    at.matrix("row.txt", 1, 8, wavy);
    std::fs::create_dir(at.join("nothing")).expect("an empty folder");
    for command in ["info", "stats", "solve --modulus 1GPa --pressure 1MPa"] {
        at.refuses_each(
            command,
            &[
                ("missing.txt", &["missing.txt"]),
                ("nothing", &["nothing", "no surface file"]),
                ("empty.txt", &["empty.txt", "empty"]),
                ("noise.bin", &["noise.bin"]),
                (&format!("inf.txt {UNITS}"), &["inf"]),
            ],
        );
    }
    for command in ["stats", "solve --modulus 1GPa --pressure 1MPa"] {
        at.refuses_each(
            &format!("{command} {UNITS}"),
            &[
                ("nan.txt", &["missing"]),
                ("nan.txt --fill harmonic", &["missing"]),
                ("row.txt", &["row.txt", "profile", "32", "8"]),
            ],
        );
    }
}

#[test]
fn a_refusal_by_a_theory_is_said_once() {
    let at = &folder();
    let said = at.run(
        "model majumdar-bhushan --dimension 1.6234567890123 --roughness 1nm --area 1mm^2 \
         --modulus 1GPa --pressure 1MPa",
    );
    assert_eq!(said.status, 2);
    assert!(said.err.contains("D = 1.62346 is outside") && !said.out.contains("outside"));
    let solve = "solve none.txt --young 1GPa --poisson 0.6 --pressure 1MPa";
    at.refuses(solve, &["Poisson's ratio = 0.6 must be above -1 and at most 0.5"]);
}

#[test]
fn what_the_file_does_not_say_is_asked_for() {
    let at = &folder();
    at.matrix("bare.txt", 4, 5, wavy);
    for (line, needs) in [
        ("info bare.txt", &["--pixel", "--height-unit"][..]),
        ("info bare.txt --pixel 1um", &["--height-unit"]),
        ("info bare.txt --height-unit um", &["--pixel"]),
    ] {
        // What can be said without units is said.
        let said = at.run(line);
        assert_eq!(said.status, 2, "{line}: {}", said.err);
        has(&said.out, &["4 rows × 5 columns"]);
        assert_eq!(said.out.contains("unit unknown"), needs.contains(&"--height-unit"));
        has(&said.err, needs);
    }
    let raw = at.run("info bare.txt --json").json();
    assert_eq!(raw["shape"], json!([4, 5]));
    assert!(raw["raw_height_min"].is_f64() && raw["error"]["message"].is_string(), "{raw}");
    at.refuses_each(
        "info bare.txt",
        &[
            ("--height-unit MM --pixel 1um", &["did you mean mm?"]),
            ("--height-unit um --pixel 0,5um", &["decimal comma", "0.5um"]),
            ("--height-unit um --pixel -1um", &["greater than 0"]),
        ],
    );
    at.refuses_each(
        &format!("info bare.txt {UNITS}"),
        &[
            ("--channel phase", &["phase"]),
            ("--crop 0,0,9,9", &["9", "4 x 5"]),
            ("--crop 0,0", &["Y0,X0,NY,NX", "complete"]),
        ],
    );
    at.file("hole.txt", "1 2 4 3\n5 nan 7 8\n9 1 2 3\n");
    at.refuses(&format!("stats hole.txt {UNITS}"), &["1 of 12", "--fill harmonic"]);
    at.done(&format!("stats hole.txt {UNITS} --fill nearest"));
}

/// What x y z or three heights were taken for is said, and the other can be asked for.
#[test]
fn what_three_columns_are() {
    let at = &folder();
    at.matrix("heights.txt", 20, 3, wavy);
    // A list is asked for the unit of its coordinates, not for a pixel; both can be given.
    at.file("coordinates.txt", "x y z\n0 0 1\n1 0 2\n0 2 3\n1 2 4\n");
    let said = at.run("info coordinates.txt --height-unit mm");
    assert_eq!(said.status, 2, "{}", said.err);
    assert!(said.err.contains("--lateral-unit") && said.out.contains("2 rows × 2 columns"));
    let read = at.answer("info coordinates.txt --height-unit mm --lateral-unit um");
    close(number(&read["pixel"][0]), 2e-6, 1e-12);
    // A unit in the file is kept unless it is overruled.
    at.file("nm.txt", "# Width: 2 um\n# Height: 2 um\n# Value units: nm\n1 2\n3 4\n");
    for (option, highest, is_kept) in
        [("--height-unit", 4e-9, true), ("--override-height-unit", 4e-6, false)]
    {
        let said = at.done(&format!("info nm.txt {option} um --json"));
        close(number(&said.json()["height_max"]), highest, 1e-12);
        assert_eq!(said.err.contains("--override-height-unit"), is_kept, "{}", said.err);
        assert_eq!(said.err.is_empty(), !is_kept, "{}", said.err);
    }
    // A pixel in the file is overruled, which is said.
    has(&at.done("info nm.txt --pixel 5um").err, &["a pixel of 1e-6 m along x", "--pixel"]);
    assert!(at.done("info nm.txt --pixel 1um").err.is_empty());
    let stats = format!("stats heights.txt {UNITS}");
    at.refuses(&stats, &["list x y z", "--layout matrix"]);
    at.refuses(&format!("{stats} --layout rows"), &["matrix", "list"]);
    let said = at.done(&format!("{stats} --layout matrix --json"));
    assert_eq!(said.json()["shape"], json!([20, 3]));
    assert!(said.err.is_empty(), "{}", said.err);
    at.matrix("wide.txt", 6, 9, wavy);
    at.refuses(&format!("info wide.txt {UNITS} --layout list"), &["not evenly spaced"]);

    // A list with a hole could be heights in steps.
    at.file("list.txt", "0 0 1\n0 1 5\n0 2 2\n1 0 4\n1 1 3\n1 2 1\n2 0 2\n2 1 2\n");
    let stats = format!("stats list.txt {UNITS} --fill nearest");
    let said = at.done(&format!("{stats} --json"));
    assert_eq!(said.json()["shape"], json!([3, 3]));
    has(&said.err, &["list.txt: three columns, read as a list"]);
    let known = at.answer(&format!("info list.txt {UNITS}"));
    has(known["ambiguity"].as_str().unwrap(), &["--layout matrix"]);
    let said = at.done(&format!("{stats} --layout list"));
    assert!(said.err.is_empty(), "{}", said.err);
}

#[test]
fn loads_and_moduli() {
    let at = &folder();
    at.matrix("map.txt", 8, 8, wavy);
    at.refuses_each(
        &format!("solve map.txt {UNITS}"),
        &[
            ("--modulus 1GPa", &["--pressure"]),
            ("--pressure 1MPa", &["--modulus", "--young"]),
            ("--modulus 110 --pressure 1MPa", &["110GPa"]),
            ("--modulus 1GPa --pressure nanPa", &["not a finite number"]),
            ("--modulus 1GPa --pressure 0Pa", &["greater than 0"]),
            ("--modulus 1GPa --pressure 1MPa,-2MPa", &["greater than 0"]),
            ("--modulus 1GPa --pressure 1kPa..1MPa", &["FIRST..LAST:COUNT"]),
            ("--modulus -1GPa --pressure 1MPa", &["contact modulus"]),
            ("--young 1GPa --pressure 1MPa", &["--poisson"]),
            ("--modulus 1GPa --pressure 1MPa --gap 1um", &["--gap"]),
            ("--modulus 1GPa --gap 0um", &["greater than 0"]),
            ("--modulus 1GPa --pressure 1MPa --tolerance 0", &["tolerance"]),
            ("--modulus 1GPa --pressure 1MPa --method magic", &["polonsky-keer"]),
            ("--modulus 1GPa --pressure 1MPa --threads 0", &["threads"]),
        ],
    );
}

#[test]
fn outputs_are_not_overwritten_and_must_be_writable() {
    let at = &folder();
    let synth = "synth --shape 16,16 --pixel 1um --hurst 0.8 --rolloff 16um --cutoff 4um \
                 --rms-height 1um --seed 1 --out";
    at.done(&format!("{synth} a.npy"));
    at.refuses(&format!("{synth} a.npy"), &["a.npy", "--force"]);
    at.done(&format!("{synth} a.npy --force"));
    at.refuses(&format!("{synth} a.docx"), &["docx", ".npy"]);
    let cannot = &["cannot be written"];
    at.refuses_with(1, &format!("{synth} no/such/folder/a.npy"), cannot);

    at.file("plain", "not a folder");
    let solve =
        "solve a.npy --pixel 1um --height-unit m --modulus 1GPa --pressure 1MPa --quiet --maps";
    at.refuses_with(1, &format!("{solve} plain/maps"), cannot);
    at.done(&format!("{solve} maps"));
    at.refuses(&format!("{solve} maps"), &["pressure-000.npy", "--force"]);
    at.done(&format!("{solve} maps --force"));
}

#[test]
fn unknown_commands_and_options() {
    let at = &folder();
    at.refuses("frobnicate", &["frobnicate"]);
    at.refuses("info --frobnicate x", &["--frobnicate"]);
}

#[test]
fn help_and_version_are_answers() {
    for line in ["--help", "--version", "help solve", "solve --help"] {
        let said = folder().done(line);
        assert!(said.err.is_empty() && !said.out.is_empty(), "{line}");
    }
}

/// `-h` has what most people need, `model NAME -h` what that model is made from and nothing of others.
#[test]
fn short_help_is_short() {
    let at = &folder();
    let help = |command: &str| at.run(&format!("{command} -h")).out;
    let words = |text: &str| text.split_whitespace().count();
    for command in ["solve", "compare", "model", "stats", "synth", "convert"] {
        let help = help(command);
        let long = at.run(&format!("{command} --help")).out;
        assert!(words(&help) <= 480 && words(&long) <= 1200, "{command}");
        let options = help.lines().filter(|line| line.trim_start().starts_with("--")).count();
        let mut lines = help.lines().filter(|line| !line.starts_with("Usage:"));
        assert!(options <= 25 && lines.all(|line| line.chars().count() <= 100), "{help}");
    }
    assert!(help("synth").contains("--hurst"));
    let gw = help("model gw");
    assert!(gw.contains("--asperity-radius") && !gw.contains("--critical-area"), "{gw}");
    let fractal = help("model majumdar-bhushan");
    assert!(fractal.contains("--critical-area") || fractal.contains("--dimension"), "{fractal}");
}
