//! Studies and models of bodies that yield, as a user asks for them.

use crate::cli;

use cli::{folder, number, refused, rough_contact};
use serde_json::Value;
use std::path::Path;

const STUDY: &str = "compare a.x3p --modulus 110GPa --pressure 20MPa,100MPa,500MPa --hardness 3GPa";

fn surface(at: &Path) {
    let synth = "synth --shape 64,80 --pixel 1um --hurst 0.8 --rolloff 32um --cutoff 8um \
                 --rms-gradient 0.1 --seed 4 --out a.x3p";
    assert_eq!(rough_contact(at, synth).status, 0);
}

fn results(at: &Path, folder: &str) -> Value {
    let text = std::fs::read_to_string(at.join(folder).join("results.json")).expect("results");
    serde_json::from_str(&text).expect("JSON")
}

/// Page, JSON, CSV and terminal say the same of the contact that yields; a run file repeats it.
#[test]
fn a_study_of_bodies_that_yield_agrees_with_itself() {
    let dir = folder();
    let at = dir.path();
    surface(at);
    let said = rough_contact(at, &format!("{STUDY} --out report"));
    assert_eq!(said.status, 0, "{}", said.err);
    let found = results(at, "report");
    let surface = &found["surfaces"][0];
    assert!((number(&surface["deterministic"]["hardness"]) / 3e9 - 1.0).abs() < 1e-15);
    let (yielding, elastic) = (&surface["deterministic"]["points"], &surface["elastic"]["points"]);
    let csv = std::fs::read_to_string(at.join("report/curves.csv")).expect("csv");
    let mut rows = csv.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let head = rows.next().expect("a header");
    let column = |name: &str| head.iter().position(|h| h.starts_with(name)).expect("a column");
    let page = std::fs::read_to_string(at.join("report/report.html")).expect("page");
    for (i, row) in rows.enumerate() {
        let cell = |name: &str| row[column(name)].parse::<f64>().expect("a number");
        for (name, value) in [
            ("area_fraction_deterministic", &yielding[i]["area_fraction"]),
            ("area_fraction_at_hardness", &yielding[i]["saturated_fraction"]),
            ("load_share_at_hardness", &yielding[i]["plastic_load_fraction"]),
            ("area_fraction_elastic", &elastic[i]["area_fraction"]),
        ] {
            assert!((cell(name) / number(value) - 1.0).abs() < 1e-12, "{name}: {row:?}");
        }
        assert!(cell("area_fraction_elastic") < cell("area_fraction_deterministic"));
        assert!(
            yielding[i]["saturated_fraction"].is_number()
                && elastic[i].get("saturated_fraction").is_none()
        );
    }
    let models = surface["models"].as_array().expect("models");
    let names: Vec<&str> = models.iter().filter_map(|m| m["model"].as_str()).collect();
    assert!(names.contains(&"ceb") && names.contains(&"persson-yield"), "{names:?}");
    for model in models {
        let is_elastic = !matches!(model["model"].as_str(), Some("ceb" | "persson-yield"));
        if model["applicable"] == true {
            let by = if is_elastic { "elastic" } else { "deterministic" };
            assert_eq!(model["area_error"]["against"], by, "{model}");
            let error = number(&model["area_error"]["signed"][2]);
            let area = |points: &Value| number(&points["points"][2]["area_fraction"]);
            let off = number(&model["points"][2]["area_fraction"]) / area(&surface[by]) - 1.0;
            assert!((error - off).abs() < 1e-12, "{error} {off} {}", model["model"]);
        }
    }
    let claim = surface["findings"].as_array().expect("findings").iter().find_map(|f| {
        f["fact"].get("yielding").and_then(|_| f["claim"].as_str().map(str::to_owned))
    });
    let claim = claim.expect("what has yielded");
    assert!(page.contains(&claim) && said.out.contains(&claim.replace('\u{202f}', " ")), "{claim}");
    assert!(said.out.contains("at the hardness") && page.contains("height map, elastic contact"));
    // Each kind of theories has its panel and its part of the table.
    for of in ["elastic–plastic contact", "elastic contact"] {
        assert!(page.contains(&format!("Error of each closed form, {of}")), "{of}");
        assert!(said.out.contains(&format!("against the solution of {of}:")), "{}", said.out);
    }

    let again = rough_contact(at, "compare --from report/run.toml --out again");
    assert_eq!(again.status, 0, "{}", again.err);
    let repeated = results(at, "again");
    assert_eq!(repeated["settings"]["hardness"], found["settings"]["hardness"]);
    for i in 0..3 {
        let area = |results: &Value| {
            results["surfaces"][0]["deterministic"]["points"][i]["area_fraction"].clone()
        };
        assert_eq!(area(&found), area(&repeated));
    }
}

/// Without the option nothing of it is computed or said.
#[test]
fn an_elastic_study_does_not_know_of_it() {
    let dir = folder();
    surface(dir.path());
    let line = STUDY.replace(" --hardness 3GPa", " --out report");
    assert_eq!(rough_contact(dir.path(), &line).status, 0);
    let found = results(dir.path(), "report");
    let surface = &found["surfaces"][0];
    assert!(surface["elastic"].is_null() && surface["deterministic"]["hardness"].is_null());
    let names: Vec<&str> = surface["models"]
        .as_array()
        .expect("models")
        .iter()
        .filter_map(|m| m["model"].as_str())
        .collect();
    assert!(!names.contains(&"ceb") && !names.contains(&"persson-yield"), "{names:?}");
    let csv = std::fs::read_to_string(dir.path().join("report/curves.csv")).expect("csv");
    assert!(!csv.contains("hardness") && !csv.contains("elastic"));
}

#[test]
fn what_a_study_cannot_do_with_a_hardness_is_refused() {
    let dir = folder();
    surface(dir.path());
    let line = format!("{} --out report", STUDY.replace("3GPa", "0Pa"));
    refused(dir.path(), &line, 2, &["above 0 Pa"]);
    let trace: Vec<String> = (0..400).map(|i| format!("{i} {}\n", (i * 37) % 11)).collect();
    cli::file(dir.path(), "p.txt", &trace.concat());
    let line =
        "compare p.txt --lateral-unit um --height-unit nm --modulus 1GPa --hardness 1GPa --out q";
    let said = rough_contact(dir.path(), line);
    assert!(said.status != 0 && said.err.contains("for maps"), "{}", said.err);
}

/// Persson with yield: 0.0811 at E* g/H = 2 and p/(E* g) = 0.04 (ENDUSE table; Persson 2001). Chang, Etsion and
/// Bogy where hardly anything is elastic: p = K H A with K = 0.454 + 0.41 ν.
#[test]
fn theories_of_yield_answer_typed_in_numbers() {
    let dir = folder();
    let area = |line: &str| -> f64 {
        let answer = rough_contact(dir.path(), &format!("model {line} --json")).answered();
        number(&answer["points"][0]["area_fraction"])
    };
    let moments = "--m0 1um^2 --m2 0.00125 --m4 1e7m^-2";
    let persson = area(&format!(
        "persson-yield {moments} --modulus 100GPa --hardness 2.5GPa --pressure 200MPa"
    ));
    assert!((persson - 0.0811).abs() < 5e-5, "{persson}");
    for (poisson, factor) in [(0.3, 0.577), (0.4, 0.618)] {
        let soft = format!(
            "ceb {moments} --young 100GPa --poisson {poisson} --hardness 10kPa --pressure 1Pa"
        );
        let ceb = area(&soft);
        assert!((ceb * factor * 1e4 - 1.0).abs() < 1e-3, "{poisson}: {ceb}");
    }
    let line = "model ceb --m0 1um^2 --m2 0.00125 --m4 1e7m^-2 --modulus 1GPa --pressure 1MPa";
    refused(dir.path(), line, 2, &["hardness"]);
    let line = format!("model gw {moments} --modulus 1GPa --pressure 1MPa --hardness 1GPa");
    refused(dir.path(), &line, 2, &["--hardness is no input of gw"]);
}

/// `stats` says before any solution whether a contact will yield: E* g/H, (E*/H) √(σs/R), E* g/(√π H).
#[test]
fn statistics_with_a_hardness_say_go_or_no_go() {
    let dir = folder();
    surface(dir.path());
    let of = |rest: &str| rough_contact(dir.path(), &format!("stats a.x3p {rest}"));
    for (hardness, said) in [(3e9, "the contact yields"), (60e9, "right to 2 %")] {
        let line = format!("--modulus 110GPa --hardness {hardness}Pa");
        let out = of(&line).out;
        assert!(out.contains(said) && out.contains("summits elastic below 0.6"), "{out}");
        let found = of(&format!("{line} --json")).answered();
        let (indices, asperities) = (&found["plasticity"], &found["asperities"]);
        let strength = 110e9 / hardness;
        let gradient = number(&found["rms_gradient"]);
        let steep = (number(&asperities["height_std"]) / number(&asperities["radius"])).sqrt();
        for (key, exact) in [
            ("modulus_gradient_over_hardness", strength * gradient),
            ("mikic", strength * gradient / std::f64::consts::PI.sqrt()),
            ("greenwood_williamson", strength * steep),
        ] {
            assert!((number(&indices[key]) / exact - 1.0).abs() < 1e-12, "{key}: {indices}");
        }
    }
    let limit = of("--modulus 110GPa --json").answered();
    let exact = 110e9 * number(&limit["rms_gradient"]);
    assert!((number(&limit["plasticity"]["elastic_limit"]) / exact - 1.0).abs() < 1e-12);
    assert!(of("--modulus 2MPa").out.contains("do not yield"));
    assert!(of("--json").answered().get("plasticity").is_none());
    refused(dir.path(), "stats a.x3p --hardness 3GPa", 2, &["modulus"]);
}
