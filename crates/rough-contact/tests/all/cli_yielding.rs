//! Studies and models of bodies that yield, as a user asks for them.

use crate::cli::{TestFolder, close, folder, has, list, number};
use serde_json::Value;
use std::f64::consts::PI;

const STUDY: &str = "compare a.x3p --modulus 110GPa --pressure 20MPa,100MPa,500MPa";

fn surface() -> TestFolder {
    let at = folder();
    at.synth("a.x3p", "--shape 64,80 --rolloff 32um --cutoff 8um --rms-gradient 0.1 --seed 4");
    at
}

/// Page, JSON, CSV and terminal say the same of the contact that yields.
#[test]
fn a_study_of_bodies_that_yield_agrees_with_itself() {
    let at = &surface();
    let said = at.done(&format!("{STUDY} --hardness 3GPa --out report")).out;
    let found = at.results("report");
    let surface = &found["surfaces"][0];
    close(number(&surface["deterministic"]["hardness"]), 3e9, 1e-15);
    let (yielding, elastic) = (&surface["deterministic"]["points"], &surface["elastic"]["points"]);
    let page = at.read("report/report.html");
    let column = |heading: &str| at.column("report/curves.csv", heading);
    for i in 0..3 {
        for (heading, value) in [
            ("area_fraction_deterministic", &yielding[i]["area_fraction"]),
            ("area_fraction_at_hardness", &yielding[i]["saturated_fraction"]),
            ("load_share_at_hardness", &yielding[i]["plastic_load_fraction"]),
            ("area_fraction_elastic", &elastic[i]["area_fraction"]),
        ] {
            close(column(heading)[i], number(value), 1e-12);
        }
        assert!(column("area_fraction_elastic")[i] < column("area_fraction_deterministic")[i]);
        assert!(yielding[i]["saturated_fraction"].is_number());
        assert!(elastic[i].get("saturated_fraction").is_none());
    }
    for model in list(&surface["models"]).iter().filter(|model| model["applicable"] == true) {
        let is_elastic = !matches!(model["model"].as_str(), Some("ceb" | "persson-yield"));
        let by = if is_elastic { "elastic" } else { "deterministic" };
        assert_eq!(model["area_error"]["against"], by, "{model}");
    }
    let yielded = |f: &&Value| f["fact"].get("yielding").is_some() && f["claim"].is_string();
    let claim = list(&surface["findings"]).iter().find(yielded).expect("what has yielded");
    let claim = claim["claim"].as_str().unwrap();
    has(&page, &[claim, "height map, elastic contact"]);
    has(&said, &[&claim.replace('\u{202f}', " "), "at the hardness"]);
    // Each kind of theories has its panel and its part of the table.
    for of in ["elastic–plastic contact", "elastic contact"] {
        has(&page, &[&format!("Error of each closed form, {of}")]);
        has(&said, &[&format!("against the solution of {of}:")]);
    }
    // Without the option nothing of it is computed or said.
    at.done(&format!("{STUDY} --out plain"));
    let plain = at.results("plain")["surfaces"][0].clone();
    assert!(plain["elastic"].is_null() && plain["deterministic"]["hardness"].is_null());
    let csv = at.read("plain/curves.csv");
    assert!(!csv.contains("hardness") && !csv.contains("elastic"));
}

#[test]
fn what_a_study_cannot_do_with_a_hardness_is_refused() {
    let at = &surface();
    at.refuses(&format!("{STUDY} --hardness 0Pa --out report"), &["above 0 Pa"]);
    let trace: Vec<String> = (0..400).map(|i| format!("{i} {}\n", (i * 37) % 11)).collect();
    at.file("p.txt", &trace.concat());
    let said = at.run(
        "compare p.txt --lateral-unit um --height-unit nm --modulus 1GPa --hardness 1GPa --out q",
    );
    assert!(said.status != 0 && said.err.contains("for maps"), "{}", said.err);
}

/// Chang, Etsion and Bogy where hardly anything is elastic: p = K H A with K = 0.454 + 0.41 ν. Persson with yield is tested in
/// its crate.
#[test]
fn theories_of_yield_answer_typed_in_numbers() {
    let at = &folder();
    let moments = "--m0 1um^2 --m2 0.00125 --m4 1e7m^-2";
    let soft = "--young 100GPa --poisson 0.3 --hardness 10kPa --pressure 1Pa";
    let found = at.answer(&format!("model ceb {soft} {moments}"));
    close(number(&found["points"][0]["area_fraction"]) * 0.577 * 1e4, 1.0, 1e-3);
    at.refuses_each(
        &format!("model {moments} --modulus 1GPa --pressure 1MPa"),
        &[("ceb", &["hardness"]), ("gw --hardness 1GPa", &["--hardness is no input of gw"])],
    );
}

/// `stats` says before any solution whether a contact will yield: E* g/H, (E*/H) √(σs/R), E* g/(√π H).
#[test]
fn statistics_with_a_hardness_say_go_or_no_go() {
    let at = &surface();
    for (hardness, said) in [(3e9, "the contact yields"), (60e9, "right to 2 %")] {
        let line = format!("stats a.x3p --modulus 110GPa --hardness {hardness}Pa");
        has(&at.run(&line).out, &[said, "summits elastic below 0.6"]);
        let found = at.answer(&line);
        let (indices, asperities) = (&found["plasticity"], &found["asperities"]);
        let strength = 110e9 / hardness;
        let gradient = number(&found["rms_gradient"]);
        let steep = (number(&asperities["height_std"]) / number(&asperities["radius"])).sqrt();
        for (key, exact) in [
            ("modulus_gradient_over_hardness", strength * gradient),
            ("mikic", strength * gradient / PI.sqrt()),
            ("greenwood_williamson", strength * steep),
        ] {
            close(number(&indices[key]), exact, 1e-12);
        }
    }
    let limit = at.answer("stats a.x3p --modulus 110GPa");
    let exact = 110e9 * number(&limit["rms_gradient"]);
    close(number(&limit["plasticity"]["elastic_limit"]), exact, 1e-12);
    has(&at.run("stats a.x3p --modulus 2MPa").out, &["do not yield"]);
    assert!(at.answer("stats a.x3p").get("plasticity").is_none());
    at.refuses("stats a.x3p --hardness 3GPa", &["modulus"]);
}
