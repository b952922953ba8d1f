//! Bad input is refused with exit status 2 (1 for outputs), one message, and nothing else.

use crate::cli;

use cli::{file, folder, matrix, refused, rough_contact};

const SCALES: &str = "--pixel 1um --height-unit um";

fn wavy(iy: usize, ix: usize) -> f64 {
    (iy as f64).sin() * (ix as f64 * 1.3).cos()
}

#[test]
fn files_that_are_no_surface() {
    let dir = folder();
    let at = dir.path();
    file(at, "empty.txt", "");
    file(at, "noise.bin", "\u{1}\u{2}\u{3}ZZZZ");
    file(at, "nan.txt", "nan nan nan nan\nnan nan nan nan\nnan nan nan nan\n");
    file(at, "inf.txt", "1 2 3 4\n5 inf 7 8\n9 1 2 3\n");
    matrix(at, "row.txt", 1, 8, wavy);
    std::fs::create_dir(at.join("nothing")).expect("an empty folder");
    for command in ["info", "stats", "solve --modulus 1GPa --pressure 1MPa"] {
        refused(at, &format!("{command} missing.txt"), 2, &["missing.txt"]);
        refused(at, &format!("{command} nothing"), 2, &["nothing", "no surface file"]);
        refused(at, &format!("{command} empty.txt"), 2, &["empty.txt", "empty"]);
        refused(at, &format!("{command} noise.bin"), 2, &["noise.bin"]);
        refused(at, &format!("{command} inf.txt {SCALES}"), 2, &["inf"]);
    }
    for command in ["stats", "solve --modulus 1GPa --pressure 1MPa"] {
        refused(at, &format!("{command} nan.txt {SCALES}"), 2, &["missing"]);
        refused(at, &format!("{command} nan.txt {SCALES} --fill harmonic"), 2, &["missing"]);
        refused(at, &format!("{command} row.txt {SCALES}"), 2, &["row.txt", "profile", "32", "8"]);
    }
}

#[test]
fn a_refusal_by_a_theory_is_said_once() {
    let dir = folder();
    let line = "model majumdar-bhushan --dimension 1.6234567890123 --roughness 1nm --area 1mm^2 \
                --modulus 1GPa --pressure 1MPa";
    let said = rough_contact(dir.path(), line);
    assert_eq!(said.status, 2);
    assert!(said.err.contains("D = 1.62346 is outside") && !said.out.contains("outside"));
    let solve = "solve none.txt --young 1GPa --poisson 0.6 --pressure 1MPa";
    refused(dir.path(), solve, 2, &["Poisson's ratio = 0.6 is outside its domain, -1 to 0.5"]);
}

#[test]
fn what_the_file_does_not_say_is_asked_for() {
    let dir = folder();
    let at = dir.path();
    matrix(at, "bare.txt", 4, 5, wavy);
    for (line, needs) in [
        ("info bare.txt", &["--pixel", "--height-unit"][..]),
        ("info bare.txt --pixel 1um", &["--height-unit"]),
        ("info bare.txt --height-unit um", &["--pixel"]),
    ] {
        // What can be said without units is said.
        let said = rough_contact(at, line);
        assert_eq!(said.status, 2, "{line}: {}", said.err);
        assert!(said.out.contains("4 rows × 5 columns"), "{line}: {}", said.out);
        assert_eq!(said.out.contains("unit unknown"), needs.contains(&"--height-unit"));
        assert!(needs.iter().all(|need| said.err.contains(need)), "{line}: {}", said.err);
    }
    let raw = rough_contact(at, "info bare.txt --json").json();
    assert_eq!(raw["shape"], serde_json::json!([4, 5]));
    assert!(raw["raw_height_min"].is_f64() && raw["error"]["message"].is_string(), "{raw}");
    refused(at, "info bare.txt --height-unit MM --pixel 1um", 2, &["did you mean mm?"]);
    refused(at, "info bare.txt --height-unit um --pixel 0,5um", 2, &["decimal comma", "0.5um"]);
    refused(at, "info bare.txt --height-unit furlong --pixel 1um", 2, &["furlong", "um"]);
    refused(at, "info bare.txt --height-unit um --pixel 1", 2, &["1um"]);
    refused(at, "info bare.txt --height-unit um --pixel -1um", 2, &["greater than 0"]);
    refused(at, &format!("info bare.txt {SCALES} --channel phase"), 2, &["phase"]);
    refused(at, &format!("info bare.txt {SCALES} --crop 0,0,9,9"), 2, &["9", "4 x 5"]);
    refused(at, &format!("info bare.txt {SCALES} --crop 0,0"), 2, &["Y0,X0,NY,NX", "complete"]);
    file(at, "hole.txt", "1 2 4 3\n5 nan 7 8\n9 1 2 3\n");
    refused(at, &format!("stats hole.txt {SCALES}"), 2, &["1 of 12", "--fill harmonic"]);
    assert_eq!(rough_contact(at, &format!("stats hole.txt {SCALES} --fill nearest")).status, 0);
}

/// Three numbers to a row may be x y z or three heights: which they were taken for is said, the
/// other can be asked for, also by the run file.
#[test]
fn what_three_columns_are() {
    let dir = folder();
    let at = dir.path();
    matrix(at, "heights.txt", 20, 3, wavy);
    // A list is asked for the unit of its coordinates, not for a pixel; both can be given.
    file(at, "coordinates.txt", "x y z\n0 0 1\n1 0 2\n0 2 3\n1 2 4\n");
    let said = rough_contact(at, "info coordinates.txt --height-unit mm");
    assert_eq!(said.status, 2, "{}", said.err);
    assert!(said.err.contains("--lateral-unit") && said.out.contains("2 rows × 2 columns"));
    let read = "info coordinates.txt --height-unit mm --lateral-unit um --json";
    let pixel = rough_contact(at, read).answered()["pixel"].clone();
    assert!((pixel[0].as_f64().unwrap() / 2e-6 - 1.0).abs() < 1e-12, "{pixel}");
    // A unit in the file is kept unless it is overruled.
    file(at, "nm.txt", "# Width: 2 um\n# Height: 2 um\n# Value units: nm\n1 2\n3 4\n");
    let highest = |options: &str| {
        let said = rough_contact(at, &format!("info nm.txt {options} --json"));
        (said.answered()["height_max"].as_f64().unwrap(), said.err)
    };
    let (kept, said) = highest("--height-unit um");
    assert!((kept / 4e-9 - 1.0).abs() < 1e-12 && said.contains("--override-height-unit"), "{said}");
    let (overruled, said) = highest("--override-height-unit um");
    assert!((overruled / 4e-6 - 1.0).abs() < 1e-12 && said.is_empty(), "{said}");
    refused(at, &format!("stats heights.txt {SCALES}"), 2, &["list x y z", "--layout matrix"]);
    refused(at, &format!("stats heights.txt {SCALES} --layout rows"), 2, &["matrix", "list"]);
    let said = rough_contact(at, &format!("stats heights.txt {SCALES} --layout matrix --json"));
    assert_eq!(said.answered()["shape"], serde_json::json!([20, 3]));
    assert!(said.err.is_empty(), "{}", said.err);
    matrix(at, "wide.txt", 6, 9, wavy);
    refused(at, &format!("info wide.txt {SCALES} --layout list"), 2, &["not evenly spaced"]);

    // A list with a hole could be heights in steps.
    let list = "0 0 1\n0 1 5\n0 2 2\n1 0 4\n1 1 3\n1 2 1\n2 0 2\n2 1 2\n";
    file(at, "list.txt", list);
    let options = format!("{SCALES} --fill nearest");
    let said = rough_contact(at, &format!("stats list.txt {options} --json"));
    assert_eq!(said.answered()["shape"], serde_json::json!([3, 3]));
    assert!(said.err.contains("list.txt: three columns, read as a list"), "{}", said.err);
    let known = rough_contact(at, &format!("info list.txt {SCALES} --json")).answered();
    assert!(known["ambiguity"].as_str().unwrap().contains("--layout matrix"), "{known}");
    let said = rough_contact(at, &format!("stats list.txt {options} --layout list"));
    assert!(said.status == 0 && said.err.is_empty(), "{}", said.err);

    let study = "compare heights.txt --modulus 1GPa --layout matrix --quiet --out one";
    let study = format!("{study} {SCALES} --pressure 1MPa,2MPa");
    let said = rough_contact(at, &study);
    assert_eq!(said.status, 0, "{}", said.err);
    let said = rough_contact(at, "compare --from one/run.toml --quiet --out two");
    assert_eq!(said.status, 0, "{}", said.err);
    let run = std::fs::read_to_string(at.join("two/run.toml")).unwrap();
    assert!(run.contains("layout = \"matrix\""), "{run}");
}

#[test]
fn loads_and_moduli() {
    let dir = folder();
    let at = dir.path();
    matrix(at, "map.txt", 8, 8, wavy);
    let solve = format!("solve map.txt {SCALES}");
    for (options, parts) in [
        ("--modulus 1GPa", &["--pressure"][..]),
        ("--pressure 1MPa", &["--modulus", "--young"]),
        ("--modulus 110 --pressure 1MPa", &["110GPa"]),
        ("--modulus 1GPa --pressure 5", &["5MPa"]),
        ("--modulus 1GPa --pressure 0Pa", &["greater than 0"]),
        ("--modulus 1GPa --pressure -1MPa", &["greater than 0"]),
        ("--modulus 1GPa --pressure nanPa", &["not a finite number"]),
        ("--modulus 1GPa --pressure infPa", &["not a finite number"]),
        ("--modulus 1GPa --pressure 1MPa,-2MPa", &["greater than 0"]),
        ("--modulus 1GPa --pressure 1kPa..1MPa", &["FIRST..LAST:COUNT"]),
        ("--modulus 0Pa --pressure 1MPa", &["contact modulus"]),
        ("--modulus -1GPa --pressure 1MPa", &["contact modulus"]),
        ("--young 1GPa --pressure 1MPa", &["--poisson"]),
        ("--young 1GPa --poisson 0.7 --pressure 1MPa", &["Poisson", "0.5"]),
        ("--modulus 1GPa --pressure 1MPa --gap 1um", &["--gap"]),
        ("--modulus 1GPa --gap 0um", &["greater than 0"]),
        ("--modulus 1GPa --pressure 1MPa --tolerance 0", &["tolerance"]),
        ("--modulus 1GPa --pressure 1MPa --tolerance 1um", &["pure number"]),
        ("--modulus 1GPa --pressure 1MPa --method magic", &["polonsky-keer"]),
        ("--modulus 1GPa --pressure 1MPa --threads 0", &["threads"]),
    ] {
        refused(at, &format!("{solve} {options}"), 2, parts);
    }
}

#[test]
fn outputs_are_not_overwritten_and_must_be_writable() {
    let dir = folder();
    let at = dir.path();
    let synth = "synth --shape 16,16 --pixel 1um --hurst 0.8 --rolloff 16um --cutoff 4um \
                 --rms-height 1um --seed 1 --out";
    assert_eq!(rough_contact(at, &format!("{synth} a.npy")).status, 0);
    refused(at, &format!("{synth} a.npy"), 2, &["a.npy", "--force"]);
    assert_eq!(rough_contact(at, &format!("{synth} a.npy --force")).status, 0);
    refused(at, &format!("{synth} a.docx"), 2, &["docx", ".npy"]);
    refused(at, &format!("{synth} no/such/folder/a.npy"), 1, &["cannot be written"]);

    file(at, "plain", "not a folder");
    let solve = "solve a.npy --pixel 1um --height-unit m --modulus 1GPa --pressure 1MPa --quiet";
    refused(at, &format!("{solve} --maps plain/maps"), 1, &["cannot be written"]);
    assert_eq!(rough_contact(at, &format!("{solve} --maps maps")).status, 0);
    refused(at, &format!("{solve} --maps maps"), 2, &["pressure-000.npy", "--force"]);
    assert_eq!(rough_contact(at, &format!("{solve} --maps maps --force")).status, 0);
}

#[test]
fn unknown_commands_and_options() {
    let dir = folder();
    refused(dir.path(), "frobnicate", 2, &["frobnicate"]);
    refused(dir.path(), "info --frobnicate x", 2, &["--frobnicate"]);
}

#[test]
fn help_and_version_are_answers() {
    let dir = folder();
    for line in ["--help", "--version", "help solve", "solve --help"] {
        let said = rough_contact(dir.path(), line);
        assert_eq!(said.status, 0, "{line}");
        assert!(said.err.is_empty() && !said.out.is_empty(), "{line}");
    }
}

/// `-h` has what most people need, `model NAME -h` what that model is made from and nothing of others.
#[test]
fn short_help_is_short() {
    let dir = folder();
    let help = |command: &str| rough_contact(dir.path(), &format!("{command} -h")).out;
    let words = |text: &str| text.split_whitespace().count();
    for command in ["solve", "compare", "model", "stats", "synth", "convert"] {
        let help = help(command);
        let long = rough_contact(dir.path(), &format!("{command} --help")).out;
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
