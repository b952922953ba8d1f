//! compare writes a complete report, repeats itself from run.toml, and overwrites nothing.

use crate::cli;

use cli::{folder, number, refused, rough_contact};
use serde_json::{Value, json};

const OUTPUTS: [&str; 6] =
    ["report.html", "results.json", "curves.csv", "area.svg", "pressure.svg", "run.toml"];

/// results.json without what differs between two runs of the same study.
fn without_times(value: &Value) -> Value {
    match value {
        Value::Object(map) => {
            let is_time = |key: &str| key.contains("second") || key.contains("time");
            let kept = map.iter().filter(|(key, _)| !is_time(key) && *key != "repeat");
            kept.map(|(key, value)| (key.clone(), without_times(value))).collect()
        }
        Value::Array(items) => items.iter().map(without_times).collect(),
        other => other.clone(),
    }
}

#[test]
fn a_report_from_files_and_its_repetition() {
    let dir = folder();
    let at = dir.path();
    for (name, seed) in [("a.x3p", 1), ("b.x3p", 2)] {
        let synth = format!(
            "synth --shape 64,80 --pixel 1um --hurst 0.8 --rolloff 32um --cutoff 6um \
             --rms-height 0.3um --seed {seed} --out {name}"
        );
        assert_eq!(rough_contact(at, &synth).status, 0);
    }
    let line = "compare a.x3p b.x3p --modulus 110GPa --pressure 20MPa..500MPa:3 --out report";
    let said = rough_contact(at, line);
    assert_eq!(said.status, 0, "{}", said.err);
    assert!(said.out.contains("Persson") && said.out.contains("report.html"), "{}", said.out);
    assert!(!said.err.is_empty(), "no progress");
    for name in OUTPUTS {
        assert!(std::fs::metadata(at.join("report").join(name)).unwrap().len() > 100, "{name}");
    }
    let read = |folder: &str| -> Value {
        let text = std::fs::read_to_string(at.join(folder).join("results.json")).unwrap();
        serde_json::from_str(&text).unwrap()
    };
    let results = read("report");
    let surfaces = results["surfaces"].as_array().unwrap();
    assert_eq!(surfaces.len(), 2);
    assert!(results.get("settings").is_some() && results.get("versions").is_some());
    for surface in surfaces {
        let points = surface["deterministic"]["points"].as_array().unwrap();
        assert_eq!(points.len(), 3);
        for model in surface["models"].as_array().unwrap() {
            for key in ["model", "points", "seconds", "area_error", "applicable", "reason"] {
                assert!(model.get(key).is_some(), "{key} is missing in {model}");
            }
        }
        assert!(number(&surface["statistics"]["rms_height"]) > 0.0);
    }

    // Nothing is overwritten; the run file repeats the study to the last digit.
    refused(at, line, 2, &["report.html", "--force"]);
    let again = "compare --from report/run.toml --out again --quiet --json";
    let said = rough_contact(at, again);
    let printed = said.answered();
    assert!(said.err.is_empty(), "{}", said.err);
    assert_eq!(without_times(&read("again")), without_times(&results));
    assert_eq!(without_times(&printed)["surfaces"], without_times(&results)["surfaces"]);

    // A surface that has changed since is not the same study.
    std::fs::copy(at.join("a.x3p"), at.join("b.x3p")).unwrap();
    refused(at, "compare --from report/run.toml --out third", 2, &["b.x3p", "changed"]);
    refused(at, "compare --from nothing.toml --out third", 2, &["nothing.toml"]);
    refused(at, "compare --from report/run.toml --pressure 1MPa --out third", 2, &["--pressure"]);
}

/// Mirror images at the edges are the solver's alone: statistics and maps stay those of the file, and
/// the run file repeats the choice.
#[test]
fn mirror_images_at_the_edges() {
    let dir = folder();
    let at = dir.path();
    let synth = "synth --shape 96,96 --pixel 1um --hurst 0.8 --rolloff 64um --cutoff 6um \
                 --rms-height 0.3um --seed 4 --out map.x3p";
    assert_eq!(rough_contact(at, synth).status, 0);
    let file = "map.x3p --crop 3,5,48,60 --modulus 110GPa --quiet";
    let solve = |more: &str| {
        let line = format!("solve {file} --level plane --pressure 1GPa {more} --json");
        rough_contact(at, &line).answered()
    };
    let [plain, mirrored] = ["", "--edges mirrored --stiffness --maps maps"].map(solve);
    assert_eq!((&plain["edges"], &mirrored["edges"]), (&json!("periodic"), &json!("mirrored")));
    assert_eq!(mirrored["shape"], json!([48, 60]));
    let area = |answer: &Value| number(&answer["points"][0]["area_fraction"]);
    assert!((area(&mirrored) / area(&plain) - 1.0).abs() < 0.3);
    assert_ne!(area(&mirrored).to_bits(), area(&plain).to_bits());
    let map = "info maps/pressure-000.npy --pixel 1um --height-unit m --json";
    let map = rough_contact(at, map).answered();
    assert_eq!(map["shape"], json!([48, 60]));
    let mean = number(&map["height_mean"]);
    assert!((mean / 1e9 - 1.0).abs() < 1e-3, "mean pressure {mean} on the map");

    let solve = format!("solve {file} --pressure 1MPa --edges mirrored");
    refused(at, &format!("{solve} --boundary free"), 2, &["--edges mirrored", "--boundary free"]);

    let study = |more: &str, out: &str| {
        let line = format!("compare {file} --pressure 1GPa {more} --out {out}");
        assert_eq!(rough_contact(at, &line).status, 0);
        let text = std::fs::read_to_string(at.join(out).join("results.json")).unwrap();
        serde_json::from_str::<Value>(&text).unwrap()
    };
    let [periodic, with] = [study("", "one"), study("--edges mirrored", "two")];
    let [a, b] = [&periodic, &with].map(|results| &results["surfaces"][0]);
    assert_eq!(a["statistics"], b["statistics"]);
    assert_eq!(with["settings"]["edges"], json!("mirrored"));
    let found = &b["deterministic"]["points"][0]["area_fraction"];
    assert!((number(found) / area(&mirrored) - 1.0).abs() < 1e-3);
    let page = std::fs::read_to_string(at.join("two/report.html")).unwrap();
    assert!(page.contains("mirror images") && !page.contains("Repeated periodically"));
    let again = rough_contact(at, "compare --from two/run.toml --out three --quiet --json");
    assert_eq!(without_times(&again.answered()["surfaces"]), without_times(&with["surfaces"]));
}

/// Only the models asked for are in the study, in text, JSON, CSV, page and repetition.
#[test]
fn a_study_of_chosen_models() {
    let dir = folder();
    let at = dir.path();
    let synth = "synth --shape 48,48 --pixel 1um --hurst 0.8 --rolloff 24um --cutoff 6um \
                 --rms-height 0.2um --seed 1 --out a.x3p";
    assert_eq!(rough_contact(at, synth).status, 0);
    let study = "compare a.x3p --modulus 110GPa --pressure 200MPa";
    let names = |folder: &str| -> Vec<String> {
        let text = std::fs::read_to_string(at.join(folder).join("results.json")).unwrap();
        let results: Value = serde_json::from_str(&text).unwrap();
        let models = results["surfaces"][0]["models"].as_array().unwrap().clone();
        models.iter().map(|m| m["model"].as_str().unwrap().to_owned()).collect()
    };
    let said = rough_contact(at, &format!("{study} --models persson,gw --out two"));
    assert_eq!(said.status, 0, "{}", said.err);
    assert!(said.out.contains("Persson") && !said.out.contains("Bush"), "{}", said.out);
    assert_eq!(names("two"), ["gw", "persson"]);
    let csv = std::fs::read_to_string(at.join("two/curves.csv")).unwrap();
    let header = csv.lines().next().unwrap();
    assert!(header.contains("area_fraction_gw") && !header.contains("bgt"), "{header}");
    assert_eq!(header.split(',').count(), csv.lines().nth(1).unwrap().split(',').count());
    let page = std::fs::read_to_string(at.join("two/report.html")).unwrap();
    assert!(page.contains("Persson") && !page.contains("Majumdar"));
    assert_eq!(rough_contact(at, "compare --from two/run.toml --out again --quiet").status, 0);
    assert_eq!(names("again"), ["gw", "persson"]);

    assert_eq!(rough_contact(at, &format!("{study} --out all --quiet")).status, 0);
    assert_eq!(names("all").len(), 8);

    refused(at, &format!("{study} --models gw,archard --out r"), 2, &["archard", "persson"]);
    refused(at, "compare --from two/run.toml --models gw --out r", 2, &["--models"]);
    let run = std::fs::read_to_string(at.join("two/run.toml")).unwrap();
    for (list, part) in [("[\"green\"]", "no model 'green'"), ("[]", "empty")] {
        let changed = run.replace("[\"persson\", \"gw\"]", list);
        assert_ne!(changed, run);
        std::fs::write(at.join("two/changed.toml"), changed).unwrap();
        refused(at, "compare --from two/changed.toml --out r", 2, &[part, "persson"]);
    }
}

#[test]
fn what_a_study_refuses() {
    let dir = folder();
    let at = dir.path();
    let synth = "synth --shape 16,16 --pixel 1um --hurst 0.8 --rolloff 16um --cutoff 4um \
                 --rms-height 1um --seed 1 --out a.npy";
    assert_eq!(rough_contact(at, synth).status, 0);
    let read = "--pixel 1um --height-unit m";
    refused(at, "compare a.npy --modulus 1GPa --out r", 2, &["--pixel"]);
    refused(at, &format!("compare a.npy {read} --out r"), 2, &["--modulus"]);
    refused(at, &format!("compare a.npy {read} --modulus 1GPa"), 2, &["--out"]);
    let study = format!("compare a.npy {read} --modulus 1GPa --out r");
    refused(at, &format!("{study} --pressure 0Pa"), 2, &["greater than 0"]);
    refused(at, &format!("{study} --pressure 1MPa --headline 2MPa"), 2, &["headline"]);
    std::fs::write(at.join("plain"), "not a folder").unwrap();
    let unwritable = format!("compare a.npy {read} --modulus 1GPa --pressure 1MPa --out plain/r");
    refused(at, &unwritable, 1, &["cannot be written"]);
}

/// Two files of one name, two elastic bodies, a load named as it is printed; and the command on the
/// page repeats the run.
#[test]
fn a_study_can_be_told_apart_and_repeated_as_its_page_says() {
    let dir = folder();
    let at = dir.path();
    for (place, seed) in [("one", 1), ("two", 2)] {
        std::fs::create_dir(at.join(place)).unwrap();
        let synth = format!(
            "synth --shape 32,32 --pixel 1um --hurst 0.8 --rolloff 32um --cutoff 8um \
             --rms-height 0.2um --seed {seed} --out {place}/s.x3p"
        );
        assert_eq!(rough_contact(at, &synth).status, 0);
    }
    let line = "compare one/s.x3p two/s.x3p --young 210GPa --poisson 0.3 --young 70GPa \
                --poisson 0.35 --pressure 10MPa..100MPa:3 --headline 31.6MPa --out out";
    let said = rough_contact(at, line);
    assert_eq!(said.status, 0, "{}", said.err);
    for text in ["one/s.x3p, ", "two/s.x3p, ", "± "] {
        assert!(said.out.contains(text), "{text}: {}", said.out);
    }
    let read = |name: &str| std::fs::read_to_string(at.join("out").join(name)).unwrap();
    let csv = read("curves.csv");
    assert_eq!(csv.lines().filter(|l| l.starts_with("two/s.x3p,")).count(), 3, "{csv}");
    let settings = serde_json::from_str::<Value>(&read("results.json")).unwrap();
    assert_eq!(settings["settings"]["bodies"][1], json!({ "young": 70e9, "poisson": 0.35 }));
    let page = read("report.html");
    assert!(page.contains("two elastic half spaces") && !page.contains("rigid flat"));
    let command = page.split("<pre>").nth(1).unwrap().split("</pre>").next().unwrap();
    let again = rough_contact(at, command.strip_prefix("rough-contact ").unwrap());
    assert_eq!(again.status, 0, "{command}: {}", again.err);
    assert!(at.join("out-again/report.html").exists());
    // A run file names its files from where it lies, so it is repeated from anywhere; a report has their names.
    assert!(read("run.toml").contains("path = \"../one/s.x3p\""), "{}", read("run.toml"));
    assert_eq!(settings["surfaces"][1]["origin"]["file"]["path"], "s.x3p");
    let line = "compare --from ../out/run.toml --out third --quiet";
    let elsewhere = rough_contact(&at.join("one"), line);
    assert_eq!(elsewhere.status, 0, "{}", elsewhere.err);
}
