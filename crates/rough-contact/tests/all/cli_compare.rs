//! compare writes a complete report, repeats itself from run.toml, and overwrites nothing.

use crate::cli::{close, folder, has, list, number, timeless};
use serde_json::{Value, json};

const OUTPUTS: [&str; 6] =
    ["report.html", "results.json", "curves.csv", "area.svg", "pressure.svg", "run.toml"];

/// results.json without what differs between two runs of the same study.
fn same(value: &Value) -> Value {
    timeless(value, &["repeat", "speed", "explanation"])
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

/// Whatever a study was asked, its run file repeats it to the last digit.
#[test]
fn a_run_file_repeats_what_a_study_was_asked() {
    let at = &folder();
    for (name, seed) in [("a.x3p", 1), ("b.x3p", 2)] {
        let recipe = "--shape 48,48 --rolloff 24um --cutoff 8um --rms-gradient 0.1 --seed";
        at.synth(name, &format!("{recipe} {seed}"));
    }
    at.matrix("heights.txt", 24, 3, |iy, ix| ((7 * iy + 3 * ix) % 5) as f64);
    let trace = (0..4000).map(|i| format!("{i} {:.6}\n", (0.1 * f64::from(i * i % 997)).sin()));
    at.file("trace.txt", &format!("x [um] z [um]\n{}", trace.collect::<String>()));
    for options in [
        "a.x3p --outliers 8 --form plane --s-filter 6um --l-filter 40um --fill nearest",
        "a.x3p --align-rows --level quadratic --crop 3,5,40,36 --fractal-range 8um,24um",
        "a.x3p --edges mirrored --models persson,gw --gamma 1",
        "a.x3p --accuracy 20%",
        "a.x3p --method polonsky-keer --precision f32 --tolerance 1e-3",
        "a.x3p --material copper,steel-304 --conductivity table --gas air --work-of-adhesion 50mJ/m2",
        "a.x3p --hardness 3GPa --leak both --viscosity 1mPa.s --pressure-drop 1MPa --seal-length 1mm \
         --seal-width 10mm",
        "a.x3p --young 210GPa --poisson 0.3 --young 100GPa --poisson 0.34 --against b.x3p --flip rows --shift 3um,0um",
        "heights.txt --pixel 1um --height-unit nm --layout matrix --against heights.txt --flip rows",
        "a.x3p --load 0.1N,0.3N",
        "heights.txt --pixel 1um --height-unit nm --layout matrix",
        "trace.txt",
    ] {
        let or = |own: &[&str], usual| {
            if own.iter().any(|option| options.contains(option)) { "" } else { usual }
        };
        let modulus = or(&["--material", "--young"], "--modulus 110GPa");
        let loads = or(&["--load"], "--pressure 50MPa,200MPa");
        let first =
            at.run(&format!("compare {options} {modulus} {loads} --quiet --force --out one"));
        let again = at.run("compare --from one/run.toml --quiet --force --out two");
        // 1 where an accuracy is not met.
        assert!(first.status < 2 && again.status == first.status, "{options}: {}", first.err);
        assert_eq!(same(&at.results("two")), same(&at.results("one")), "{options}");
    }
}

/// Mirror images at the edges are the solver's alone: statistics and maps stay those of the file.
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
}

/// Only the models asked for are in the study, in text, JSON, CSV and page.
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
    at.done(&format!("{study} --out all --quiet"));
    let all = names("all").join(" ");
    let eight = "gw bgt greenwood-elliptical persson stacked multiscale majumdar-bhushan equation";
    assert!(eight.split(' ').all(|name| all.split(' ').any(|n| n == name)), "{all}");

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
            (
                &format!("{read} --modulus 1GPa --out r --pressure 10MPa --headline 10.04MPa"),
                &["headline"],
            ),
        ],
    );
    let study = format!("compare a.npy {read} --modulus 1GPa --pressure 1MPa --out plain/r");
    at.refuses_with(1, &study, &["cannot be written"]);
}

/// Two files of one name, two elastic bodies, a load named as it is printed.
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
    at.done(&line.replace("31.6MPa --out out", "31.62MPa --out four-digits"));
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
