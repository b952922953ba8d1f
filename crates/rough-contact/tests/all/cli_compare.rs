//! compare writes a complete report, repeats itself from run.toml, and overwrites nothing.

use crate::cli::{close, folder, has, list, number, timeless};
use serde_json::{Value, json};

const OUTPUTS: [&str; 6] =
    ["report.html", "results.json", "curves.csv", "area.svg", "pressure.svg", "run.toml"];

/// results.json without what differs between two runs of the same study.
fn same(value: &Value) -> Value {
    timeless(value, &["repeat"])
}

#[test]
fn a_report_from_files_and_its_repetition() {
    let at = &folder();
    for (name, seed) in [("a.x3p", 1), ("b.x3p", 2)] {
        let recipe = "--shape 64,80 --rolloff 32um --cutoff 6um --rms-height 0.3um --seed";
        at.synth(name, &format!("{recipe} {seed}"));
    }
    let line = "compare a.x3p b.x3p --modulus 110GPa --pressure 20MPa..500MPa:3 --out report";
    let said = at.done(line);
    has(&said.out, &["Persson", "report.html"]);
    assert!(!said.err.is_empty(), "no progress");
    for name in OUTPUTS {
        assert!(at.read(&format!("report/{name}")).len() > 100, "{name}");
    }
    let results = at.results("report");
    assert_eq!(list(&results["surfaces"]).len(), 2);
    assert!(results.get("settings").is_some() && results.get("versions").is_some());
    for surface in list(&results["surfaces"]) {
        assert_eq!(list(&surface["deterministic"]["points"]).len(), 3);
        for model in list(&surface["models"]) {
            for key in ["model", "points", "seconds", "area_error", "applicable", "reason"] {
                assert!(model.get(key).is_some(), "{key} is missing in {model}");
            }
        }
        assert!(number(&surface["statistics"]["rms_height"]) > 0.0);
    }

    // Nothing is overwritten; the run file repeats the study to the last digit.
    at.refuses(line, &["report.html", "--force"]);
    let said = at.done("compare --from report/run.toml --out again --quiet --json");
    assert!(said.err.is_empty(), "{}", said.err);
    assert_eq!(same(&at.results("again")), same(&results));
    assert_eq!(same(&said.json())["surfaces"], same(&results)["surfaces"]);

    // A surface that has changed since is not the same study.
    std::fs::copy(at.join("a.x3p"), at.join("b.x3p")).unwrap();
    at.refuses_each(
        "compare --out third --from",
        &[
            ("report/run.toml", &["b.x3p", "changed"]),
            ("nothing.toml", &["nothing.toml"]),
            ("report/run.toml --pressure 1MPa", &["--pressure"]),
        ],
    );
}

/// Mirror images at the edges are the solver's alone: statistics and maps stay those of the file, and
/// the run file repeats the choice.
#[test]
fn mirror_images_at_the_edges() {
    let at = &folder();
    at.synth("map.x3p", "--shape 96,96 --rolloff 64um --cutoff 6um --rms-height 0.3um --seed 4");
    let file = "map.x3p --crop 3,5,48,60 --modulus 110GPa --quiet";
    let [plain, mirrored] = ["", "--edges mirrored --stiffness --maps maps"]
        .map(|more| at.answer(&format!("solve {file} --level plane --pressure 1GPa {more}")));
    assert_eq!((&plain["edges"], &mirrored["edges"]), (&json!("periodic"), &json!("mirrored")));
    assert_eq!(mirrored["shape"], json!([48, 60]));
    let area = |answer: &Value| number(&answer["points"][0]["area_fraction"]);
    close(area(&mirrored), area(&plain), 0.3);
    assert_ne!(area(&mirrored).to_bits(), area(&plain).to_bits());
    let map = at.answer("info maps/pressure-000.npy --pixel 1um --height-unit m");
    assert_eq!(map["shape"], json!([48, 60]));
    close(number(&map["height_mean"]), 1e9, 1e-3); // the mean pressure
    let free = format!("solve {file} --pressure 1MPa --edges mirrored --boundary free");
    at.refuses(&free, &["--edges mirrored", "--boundary free"]);

    let study = |more: &str, out: &str| {
        at.done(&format!("compare {file} --pressure 1GPa {more} --out {out}"));
        at.results(out)
    };
    let [periodic, with] = [study("", "one"), study("--edges mirrored", "two")];
    let [a, b] = [&periodic, &with].map(|results| &results["surfaces"][0]);
    assert_eq!(a["statistics"], b["statistics"]);
    assert_eq!(with["settings"]["edges"], json!("mirrored"));
    close(area(&b["deterministic"]), area(&mirrored), 1e-3);
    let page = at.read("two/report.html");
    assert!(page.contains("mirror images") && !page.contains("Repeated periodically"));
    let again = at.answer("compare --from two/run.toml --out three --quiet");
    assert_eq!(same(&again["surfaces"]), same(&with["surfaces"]));
}

/// Only the models asked for are in the study, in text, JSON, CSV, page and repetition.
#[test]
fn a_study_of_chosen_models() {
    let at = &folder();
    at.synth("a.x3p", "--shape 48,48 --rolloff 24um --cutoff 6um --rms-height 0.2um --seed 1");
    let study = "compare a.x3p --modulus 110GPa --pressure 200MPa";
    let names = |folder: &str| -> Vec<String> {
        let models = at.results(folder)["surfaces"][0]["models"].clone();
        list(&models).iter().map(|m| m["model"].as_str().unwrap().to_owned()).collect()
    };
    let said = at.done(&format!("{study} --models persson,gw --out two"));
    assert!(said.out.contains("Persson") && !said.out.contains("Bush"), "{}", said.out);
    assert_eq!(names("two"), ["gw", "persson"]);
    let csv = at.read("two/curves.csv");
    let header = csv.lines().next().unwrap();
    assert!(header.contains("area_fraction_gw") && !header.contains("bgt"), "{header}");
    assert_eq!(header.split(',').count(), csv.lines().nth(1).unwrap().split(',').count());
    let page = at.read("two/report.html");
    assert!(page.contains("Persson") && !page.contains("Majumdar"));
    at.done("compare --from two/run.toml --out again --quiet");
    assert_eq!(names("again"), ["gw", "persson"]);
    at.done(&format!("{study} --out all --quiet"));
    assert_eq!(names("all").len(), 8);

    at.refuses(&format!("{study} --models gw,archard --out r"), &["archard", "persson"]);
    at.refuses("compare --from two/run.toml --models gw --out r", &["--models"]);
    let run = at.read("two/run.toml");
    for (list, part) in [("[\"green\"]", "no model 'green'"), ("[]", "empty")] {
        let changed = run.replace("[\"persson\", \"gw\"]", list);
        assert_ne!(changed, run);
        at.file("two/changed.toml", &changed);
        at.refuses("compare --from two/changed.toml --out r", &[part, "persson"]);
    }
}

#[test]
fn what_a_study_refuses() {
    let at = &folder();
    at.synth("a.npy", "--shape 16,16 --rolloff 16um --cutoff 4um --rms-height 1um --seed 1");
    at.file("plain", "not a folder");
    let read = "--pixel 1um --height-unit m";
    at.refuses_each(
        "compare a.npy",
        &[
            ("--modulus 1GPa --out r", &["--pixel"]),
            (&format!("{read} --out r"), &["--modulus"]),
            (&format!("{read} --modulus 1GPa"), &["--out"]),
            (&format!("{read} --modulus 1GPa --out r --pressure 0Pa"), &["greater than 0"]),
            (
                &format!("{read} --modulus 1GPa --out r --pressure 1MPa --headline 2MPa"),
                &["headline"],
            ),
        ],
    );
    let study = format!("compare a.npy {read} --modulus 1GPa --pressure 1MPa --out plain/r");
    at.refuses_with(1, &study, &["cannot be written"]);
}

/// Two files of one name, two elastic bodies, a load named as it is printed; and the command on the
/// page repeats the run.
#[test]
fn a_study_can_be_told_apart_and_repeated_as_its_page_says() {
    let at = &folder();
    for (place, seed) in [("one", 1), ("two", 2)] {
        std::fs::create_dir(at.join(place)).unwrap();
        let recipe = "--shape 32,32 --rolloff 32um --cutoff 8um --rms-height 0.2um --seed";
        at.synth(&format!("{place}/s.x3p"), &format!("{recipe} {seed}"));
    }
    let line = "compare one/s.x3p two/s.x3p --young 210GPa --poisson 0.3 --young 70GPa \
                --poisson 0.35 --pressure 10MPa..100MPa:3 --headline 31.6MPa --out out";
    has(&at.done(line).out, &["one/s.x3p, ", "two/s.x3p, ", "± "]);
    let csv = at.read("out/curves.csv");
    assert_eq!(csv.lines().filter(|l| l.starts_with("two/s.x3p,")).count(), 3, "{csv}");
    let results = at.results("out");
    assert_eq!(results["settings"]["bodies"][1], json!({ "young": 70e9, "poisson": 0.35 }));
    let page = at.read("out/report.html");
    assert!(page.contains("two elastic half spaces") && !page.contains("rigid flat"));
    let command = page.split("<pre>").nth(1).unwrap().split("</pre>").next().unwrap();
    at.done(command.strip_prefix("rough-contact ").unwrap());
    assert!(at.join("out-again/report.html").exists());
    // A run file names its files from where it lies, so it is repeated from anywhere; a report has their names.
    has(&at.read("out/run.toml"), &["path = \"../one/s.x3p\""]);
    assert_eq!(results["surfaces"][1]["origin"]["file"]["path"], "s.x3p");
    let words = ["compare", "--from", "../out/run.toml", "--out", "third", "--quiet"];
    let elsewhere = crate::cli::run(&at.join("one"), &words);
    assert_eq!(elsewhere.status, 0, "{}", elsewhere.err);
    // Whatever is set beside a run file is refused, not ignored.
    for option in
        ["--temperature 300K", "--attraction-range 1nm", "--pressure 1MPa", "--poisson 0.3"]
    {
        let line = format!("compare --from out/run.toml {option} --out fourth");
        at.refuses_with(2, &line, &["--from"]);
    }
}
