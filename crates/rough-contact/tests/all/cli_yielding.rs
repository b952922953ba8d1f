//! Contact, studies and models of bodies that yield, as a user asks for them.

use crate::cli::{TestFolder, bumpy, close, folder, has, list, number, surface};
use serde_json::Value;
use std::f64::consts::PI;

const STUDY: &str = "compare a.x3p --modulus 110GPa --pressure 20MPa,100MPa,500MPa";

const MAP: &str = "--shape 64,80 --rolloff 32um --cutoff 8um";

/// Page, JSON, CSV and terminal say the same of the contact that yields.
#[test]
fn a_study_of_bodies_that_yield_agrees_with_itself() {
    let at = &surface(MAP);
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
    let at = &surface(MAP);
    let above = at.run(&format!("{STUDY} --hardness 1MPa --out report"));
    has(&above.err, &["is above the hardness"]);
    assert!(above.status == 2 && !above.out.contains("did not converge"), "{}", above.out);
    let trace: Vec<String> = (0..400).map(|i| format!("{i} {}\n", (i * 37) % 11)).collect();
    at.file("p.txt", &trace.concat());
    let said = at.run(
        "compare p.txt --lateral-unit um --height-unit nm --modulus 1GPa --hardness 1GPa --out q",
    );
    assert!(said.status != 0 && said.err.contains("for maps"), "{}", said.err);
}

/// Where hardly anything is elastic: p = K H A with K = 0.454 + 0.41 ν (Chang, Etsion & Bogy).
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
    let at = &surface(MAP);
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

const SOLVE: &str = "solve a.txt --pixel 1um --height-unit um --modulus 100GPa";

/// Waves of several lengths, one cell of 32 x 32, rms gradient about 0.06.
fn waves() -> TestFolder {
    let at = folder();
    at.matrix("a.txt", 32, 32, bumpy(1.0, 1.0, false));
    at
}

fn solved(at: &TestFolder, rest: &str) -> Value {
    at.answer(&format!("{SOLVE} {rest}"))
}

/// Under which key it stands: equilibrium, no pressure above H, at least the area of load over H; only the rest scatters.
#[test]
fn what_has_yielded_carries_the_hardness_on_every_map() {
    let at = &waves();
    let (hard, loads) = (1e9, "--pressure 20MPa,500MPa --tolerance 1e-6");
    let answer = solved(at, &format!("{loads} --hardness 1GPa"));
    for point in list(&answer["points"]) {
        let of = |key: &str| number(&point[key]);
        let (load, saturated) = (of("mean_pressure"), of("saturated_fraction"));
        close(of("plastic_load_fraction") * load, saturated * hard, 1e-9);
        close(saturated + of("elastic_area_fraction"), of("touching_fraction"), 1e-12);
        assert!(saturated > 0.0 && of("max_pressure") <= hard, "{point}");
        let wide = ["area_interval", "area_prediction_interval"].map(|key| {
            let ends = list(&point[key]);
            number(&ends[1]) - number(&ends[0])
        });
        let elastic = of("elastic_area_fraction") / of("touching_fraction");
        assert!(wide[0] < wide[1] && wide[1] < wide[0] + elastic * of("area_fraction"), "{wide:?}");
        assert!(number(&point["area_interval"][0]) >= load / hard * (1.0 - 1e-5), "{point}");
    }
    let ratio = number(&answer["hardness"]["modulus_gradient_over_hardness"]);
    assert!((1.0..20.0).contains(&ratio) && answer["hardness"]["warning"].is_null(), "{answer}");
    let elastic = solved(at, loads);
    assert!(elastic.get("hardness").is_none());
    assert!(list(&elastic["points"])[0].get("saturated_fraction").is_none());
}

#[test]
fn bad_hardness_is_refused_and_an_odd_one_is_doubted() {
    let at = &waves();
    at.refuses_each(
        &format!("{SOLVE} --pressure 1MPa --hardness"),
        &[("0GPa", &["above 0 Pa"]), ("-1GPa", &["above 0 Pa"]), ("NaN", &["NaN"])],
    );
    let unusual = solved(at, "--pressure 100Pa --hardness 2kPa");
    has(unusual["hardness"]["warning"].as_str().unwrap(), &["unit"]);
    // Of several loads, those that no contact can carry are refused, the others answered.
    let said = at.run(&format!("{SOLVE} --pressure 100MPa,2GPa --hardness 1GPa --json"));
    let answer = said.json();
    assert!(said.status != 0 && number(&answer["points"][0]["saturated_fraction"]) > 0.0);
    let point = &answer["points"][1];
    has(point["error"]["message"].as_str().unwrap(), &["above the hardness"]);
    assert!(point["saturated_fraction"].is_null() && point["area_fraction"].is_null());
}

/// Nothing without contact; in full contact there is no end of it, which JSON cannot write.
#[test]
fn a_contact_conducts_as_stiffly_as_it_stands() {
    let at = &waves();
    let rest = "--resistivity 22nohm.m,7uohm.cm --conductivity 50W/m/K";
    let point = |more: &str| solved(at, &format!("{rest} {more}"))["points"][0].clone();
    let full = point("--pressure 1TPa");
    assert_eq!(full["contact_set"], "everything");
    assert!(full["stiffness"].is_null(), "{full}");
    assert!(number(&full["electrical_resistance"]).abs() < 1e-300, "{full}");
    let apart = point("--gap 10um");
    assert_eq!(apart["contact_set"], "none");
    assert!(number(&apart["thermal_conductance"]).abs() < 1e-300, "{apart}");
    assert!(apart["electrical_resistance"].is_null(), "{apart}");
    let elastic = solved(at, "--pressure 20MPa");
    assert!(list(&elastic["points"])[0].get("electrical_conductance").is_none());
}

#[test]
fn numbers_that_conduct_nothing_sensible_are_refused() {
    let at = &waves();
    at.refuses_each(
        &format!("{SOLVE} --pressure 1MPa"),
        &[
            ("--resistivity -1nohm.m", &["negative"]),
            ("--resistivity 5", &["unit"]),
            ("--resistivity 1nohm.m,2nohm.m,3nohm.m", &["two"]),
            ("--conductivity 5W/K", &["W/m/K"]),
            ("--conductivity nanW/m/K", &["finite"]),
        ],
    );
}
