//! Materials of the table and a work of adhesion, as a user asks for them.

use crate::cli;

use cli::{folder, number, refused, rough_contact};
use serde_json::Value;
use std::path::Path;

const FILE: &str = "a.x3p";

fn surface(at: &Path) {
    let synth = "synth --shape 128,128 --pixel 1um --hurst 0.8 --rolloff 32um --cutoff 6um \
                 --rms-gradient 0.1 --seed 4 --out a.x3p";
    assert_eq!(rough_contact(at, synth).status, 0);
}

fn answer(at: &Path, line: &str) -> Value {
    rough_contact(at, &format!("{line} --json")).answered()
}

fn close(found: &Value, expected: f64) {
    assert!((number(found) / expected - 1.0).abs() < 1e-9, "{found} instead of {expected}");
}

/// The table in text and JSON; a name in any case; near ones of a name that is not there.
#[test]
fn the_table_is_shown_and_names_are_looked_up() {
    let dir = folder();
    let at = dir.path();
    let all = answer(at, "materials");
    let listed = all["materials"].as_array().expect("a list");
    assert!(listed.len() >= 25 && listed.iter().all(|m| m["condition"].is_string()));
    let text = rough_contact(at, "materials");
    assert!(text.out.contains("steel-304") && text.out.contains("typical values"), "{}", text.out);
    let copper = rough_contact(at, "materials Copper");
    for word in ["117 GPa", "annealed", "makeitfrom.com", "condition uncertain"] {
        assert!(copper.out.contains(word), "{}", copper.out);
    }
    refused(at, "materials steel", 2, &["steel-304", "steel-1020"]);
    surface(at);
    refused(at, "solve a.x3p --material cooper --pressure 1MPa", 2, &["copper", "materials"]);
}

/// E*, hardness, resistivity and conductivity of two materials are those of their numbers, typed in; own numbers
/// override; condition and source are said.
#[test]
fn a_material_is_its_numbers() {
    let dir = folder();
    let at = dir.path();
    surface(at);
    let both = "--material copper --material steel-304 --resistivity table --conductivity table";
    let found = answer(at, &format!("solve {FILE} {both} --pressure 50MPa"));
    let softness = 369e6 / 68f64.to_radians().sin(); // HV in Pa, over the projected area
    let modulus = 1.0 / ((1.0 - 0.34f64.powi(2)) / 117e9 + (1.0 - 0.29f64.powi(2)) / 193e9);
    close(&found["modulus"], modulus);
    close(&found["hardness"]["pascals"], softness);
    let typed = format!(
        "--young 117GPa --poisson 0.34 --young 193GPa --poisson 0.29 --hardness {softness}Pa \
         --resistivity 17.24nohm.m,720nohm.m --conductivity 394W/m/K,16.2W/m/K"
    );
    let same = answer(at, &format!("solve {FILE} {typed} --pressure 50MPa"));
    for key in ["area_fraction", "mean_gap", "electrical_conductance", "thermal_conductance"] {
        close(&found["points"][0][key], number(&same["points"][0][key]));
    }
    let used = &found["materials"];
    assert_eq!(used[0]["condition"], "annealed");
    assert!(used[0]["numbers"]["hardness"]["sources"][0].is_string(), "{used}");
    assert!(used[1]["numbers"].get("hardness").is_none(), "the softer body yields: {used}");
    assert!(same.get("materials").is_none());
    let said = rough_contact(at, &format!("solve {FILE} {both} --pressure 50MPa")).out;
    assert!(
        said.contains("copper (copper, pure / Cu-ETP; annealed): E = 117 GPa (117 GPa to 130 GPa)"),
        "{said}"
    );
    assert!(said.contains("k = 16.2 W/m/K") && said.contains("makeitfrom.com"), "{said}");

    // Own numbers before those of the table; a modulus leaves the hardness; elastic leaves it out.
    let own = answer(
        at,
        &format!("solve {FILE} --material copper --young 130GPa --hardness 1GPa --pressure 50MPa"),
    );
    close(&own["modulus"], 130e9 / (1.0 - 0.34f64.powi(2)));
    close(&own["hardness"]["pascals"], 1e9);
    assert!(own["materials"][0]["numbers"].get("young").is_none(), "{own}");
    let rigid =
        answer(at, &format!("solve {FILE} --modulus 100GPa --material copper --pressure 50MPa"));
    close(&rigid["modulus"], 100e9);
    close(&rigid["hardness"]["pascals"], softness);
    let elastic =
        answer(at, &format!("solve {FILE} --material copper --hardness elastic --pressure 50MPa"));
    assert!(elastic.get("hardness").is_none());
}

#[test]
fn what_the_table_does_not_know_is_asked_for() {
    let dir = folder();
    let at = dir.path();
    surface(at);
    for (options, words) in [
        ("--material pmma", ["Poisson", "--poisson"]),
        ("--material copper --conductivity table", ["--material twice", "--conductivity"]),
        (
            "--material silicon --poisson 0.2 --material copper --poisson 0.34 --resistivity table",
            ["resistivity of silicon", "--resistivity"],
        ),
        ("--material copper --material gold --young 100GPa", ["--young given 1", "2 times"]),
        ("--material copper --material gold --material tin", ["3 times", "two bodies"]),
        ("--conductivity table --modulus 1GPa", ["--material twice", "--conductivity"]),
    ] {
        refused(at, &format!("solve {FILE} {options} --pressure 1MPa"), 2, &words);
    }
    let known = answer(at, &format!("solve {FILE} --material pmma --poisson 0.37 --pressure 1MPa"));
    close(&known["modulus"], 3e9 / (1.0 - 0.37f64.powi(2)));
}

/// A study says what its numbers are of, on the page, in its JSON and in run.toml, which repeats it.
#[test]
fn a_study_says_its_materials_and_whether_they_stick() {
    let dir = folder();
    let at = dir.path();
    surface(at);
    let line = format!(
        "compare {FILE} --material copper --material steel-304 --conductivity table --pressure 20MPa,100MPa \
         --work-of-adhesion 50mJ/m2 --models gw --out r"
    );
    let said = rough_contact(at, &line);
    assert_eq!(said.status, 0, "{}", said.err);
    assert!(said.out.contains("copper (copper, pure"), "{}", said.out);
    let read = |name: &str| std::fs::read_to_string(at.join(name)).expect("a file");
    let page = read("r/report.html");
    for word in [
        "copper (copper, pure",
        "makeitfrom.com",
        "Adhesion is negligible",
        "capillary",
        "Pastewka",
    ] {
        assert!(page.contains(word), "{word}");
    }
    let found: Value = serde_json::from_str(&read("r/results.json")).expect("JSON");
    assert_eq!(found["materials"][1]["name"], "steel-304");
    let adhesion = &found["surfaces"][0]["adhesion"];
    assert_eq!(adhesion["negligible"], true);
    assert!(number(&adhesion["fuller_tabor"]) > 10.0, "{adhesion}");
    assert_eq!(rough_contact(at, "compare --from r/run.toml --out again").status, 0);
    let again: Value = serde_json::from_str(&read("again/results.json")).expect("JSON");
    assert_eq!(again["materials"], found["materials"]);
    assert_eq!(again["surfaces"][0]["adhesion"], *adhesion);
}

/// The numbers of adhesion by their formulas from those of `stats`; steel does not stick, rubber does; solved
/// contacts have a share of their own; without the option nothing is said.
#[test]
fn whether_bodies_stick_is_said() {
    let dir = folder();
    let at = dir.path();
    surface(at);
    let steel = answer(at, &format!("stats {FILE} --modulus 115GPa --work-of-adhesion 0.05J/m^2"));
    let (a, s) = (&steel["adhesion"], &steel["asperities"]);
    assert_eq!(a["negligible"], true, "{a}");
    let (sigma, radius) = (number(&s["height_std"]), number(&s["radius"]));
    close(&a["fuller_tabor"], 115e9 * sigma.powf(1.5) / (0.05 * radius.sqrt()));
    let (g, m4) = (number(&steel["rms_gradient"]), number(&steel["m4"]));
    let d = 4.0 * g / (2.0 / 3.0 * m4).sqrt();
    let criterion = g * 0.3e-9 * 115e9 / (2.0 * 0.05) * (g * d / 1.2e-9).powf(2.0 / 3.0);
    close(&a["pastewka_robbins"], criterion);
    let energy = number(&a["full_contact_energy"]);
    close(&a["effective_work"], 0.05 - energy);
    let line = format!("stats {FILE} --modulus 115GPa --work-of-adhesion 50mN/m");
    assert!(rough_contact(at, &line).out.contains("Adhesion is negligible"));

    let rubber = format!("stats {FILE} --modulus 1MPa --work-of-adhesion 50mJ/m2");
    assert_eq!(answer(at, &rubber)["adhesion"]["negligible"], false);
    let said = rough_contact(at, &rubber).out;
    assert!(
        said.contains("check: Adhesion is not negligible: this program does not model it."),
        "{said}"
    );

    let line =
        format!("solve {FILE} --modulus 1MPa --pressure 1kPa,10kPa --work-of-adhesion 50mJ/m2");
    let solved = answer(at, &line);
    let share = number(&solved["adhesion"]["attraction"]);
    let rim = std::f64::consts::PI * (3.0 * 0.3e-9 * d.sqrt() / (4.0 * g)).powf(2.0 / 3.0) / d;
    let shares =
        solved["points"].as_array().expect("points").iter().map(|p| {
            0.05 / 0.3e-9 * rim * number(&p["area_fraction"]) / number(&p["mean_pressure"])
        });
    assert!((share / shares.fold(0.0, f64::max) - 1.0).abs() < 1e-6, "{share}");
    assert!(rough_contact(at, &line).out.contains("Adhesion is not negligible"));
    assert!(answer(at, &format!("stats {FILE} --modulus 1MPa")).get("adhesion").is_none());
    assert!(
        answer(at, &format!("solve {FILE} --modulus 1MPa --pressure 1kPa"))
            .get("adhesion")
            .is_none()
    );
    let none = answer(at, &format!("stats {FILE} --modulus 1MPa --work-of-adhesion 0J/m^2"));
    assert_eq!(none["adhesion"]["negligible"], true);
    for (option, word) in [
        ("--work-of-adhesion 0.05", "unit"),
        ("--work-of-adhesion -1mJ/m2", "0 or more"),
        ("--work-of-adhesion nanJ/m2", "finite"),
        ("--work-of-adhesion 5mJ", "unit"),
        ("--work-of-adhesion 5mJ/m2 --attraction-range 0nm", "above 0 m"),
        ("--attraction-range 1nm", "--work-of-adhesion"),
    ] {
        refused(at, &format!("stats {FILE} --modulus 1MPa {option}"), 2, &[word]);
    }
    refused(at, &format!("stats {FILE} --work-of-adhesion 5mJ/m2"), 2, &["modulus"]);
}

/// The ± of a conductance is that of the stiffness of its set: around the value, in JSON and in the table; with the
/// sampling variability for elastic bodies.
#[test]
fn a_conductance_has_its_bars() {
    let dir = folder();
    let at = dir.path();
    surface(at);
    for more in ["", "--hardness 2GPa"] {
        let line = format!(
            "solve {FILE} --modulus 110GPa --pressure 50MPa,500MPa --resistivity 22nohm.m {more}"
        );
        let found = answer(at, &line);
        for point in found["points"].as_array().expect("points") {
            let value = number(&point["electrical_conductance"]);
            let k = number(&point["stiffness"]);
            for kind in ["interval", "prediction_interval"] {
                let ends = |name: &str| {
                    let ends = &point[format!("{name}_{kind}")];
                    ends.is_array().then(|| [number(&ends[0]), number(&ends[1])])
                };
                let (Some([low, high]), Some(own)) =
                    (ends("electrical_conductance"), ends("stiffness"))
                else {
                    assert!(kind == "prediction_interval" && !more.is_empty(), "{point}");
                    continue;
                };
                assert!(low < value && value < high, "{point}");
                assert!(
                    (low / value - own[0] / k).abs() < 1e-12
                        && (high / value - own[1] / k).abs() < 1e-12
                );
            }
        }
        let said = rough_contact(at, &line).out;
        assert!(
            said.contains("± surface") && said.contains("S/m²") && said.contains("±"),
            "{said}"
        );
    }
}

/// The table of the book has the numbers of the program.
#[test]
fn the_page_has_the_table() {
    let dir = folder();
    let all = answer(dir.path(), "materials");
    let page = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/src/materials.md");
    let page = std::fs::read_to_string(page).expect("the page");
    let listed = all["materials"].as_array().expect("a list");
    assert_eq!(page.lines().filter(|line| line.starts_with("| `")).count(), listed.len());
    for material in listed {
        let name = material["name"].as_str().expect("a name");
        let row = page.lines().find(|line| line.starts_with(&format!("| `{name}` |")));
        let cells: Vec<&str> = row.unwrap_or_else(|| panic!("no {name}")).split('|').collect();
        for (cell, key) in
            cells[3..].iter().zip(["young", "poisson", "hardness", "resistivity", "conductivity"])
        {
            let value = &material["numbers"][key]["value"];
            let Some(exact) = value.as_f64() else {
                assert_eq!(cell.trim(), "–", "{name} {key}");
                continue;
            };
            let mut words = cell.split_whitespace();
            let shown: f64 =
                words.next().and_then(|w| w.trim_end_matches(',').parse().ok()).expect("a number");
            let scale = match words.next().map(|w| w.trim_end_matches(',')) {
                Some("GPa") => 1e9,
                Some("MPa") => 1e6,
                _ => 1.0,
            };
            assert!((shown * scale / exact - 1.0).abs() < 6e-3, "{name} {key}: {cell} and {exact}");
        }
    }
}

/// One material presses on a rigid flat, two on each other: half the area of the one. Every command says which.
#[test]
fn modulus_and_the_other_body_are_said() {
    let dir = folder();
    let at = dir.path();
    surface(at);
    let one = "--material steel-304 --hardness elastic --pressure 100MPa";
    let two = "--material steel-304,steel-304 --hardness elastic --pressure 100MPa";
    for (command, out) in [
        (format!("solve {FILE}"), ""),
        (format!("model gw {FILE}"), ""),
        (format!("compare {FILE} --models gw,persson"), " --out of"),
    ] {
        for (name, bodies, e_star, against) in [
            ("-one", one, 193e9 / (1.0 - 0.29f64.powi(2)), "ν = 0.29, against a rigid flat"),
            ("-two", two, 96.5e9 / (1.0 - 0.29f64.powi(2)), "ν = 0.29, against E = 193 GPa"),
        ] {
            let out = if out.is_empty() { String::new() } else { format!("{out}{name}") };
            let line = format!("{command} {bodies}{out} --quiet --force");
            // What is left out of the hardness is an option that `model` does not have.
            let line = if command.starts_with("model") {
                line.replace(" --hardness elastic", "")
            } else {
                line
            };
            let said = rough_contact(at, &line).out;
            let modulus = format!("E* = {:.1} GPa", e_star / 1e9);
            assert!(said.contains(&modulus) && said.contains(against), "{line}: {said}");
            let json = answer(at, &line);
            let surface = if command.starts_with("compare") { &json["surfaces"][0] } else { &json };
            assert_eq!(surface["bodies"][1]["rigid"], name == "-one", "{line}");
        }
    }
    let page = std::fs::read_to_string(at.join("of-one/report.html")).expect("a page");
    assert!(page.contains(", against a rigid flat</td>"), "on the first screen");
}
