//! Materials of the table and a work of adhesion, as a user asks for them.

use crate::cli::{book, close, folder, has, list, number, surface};
use std::f64::consts::PI;

const MAP: &str = "--shape 128,128 --rolloff 32um --cutoff 6um";

/// The table in text and JSON; a name in any case; near ones of a name that is not there.
#[test]
fn the_table_is_shown_and_names_are_looked_up() {
    let at = &surface(MAP);
    let all = at.answer("materials");
    let listed = list(&all["materials"]);
    assert!(listed.len() >= 25 && listed.iter().all(|m| m["condition"].is_string()));
    has(&at.run("materials").out, &["steel-304", "typical values"]);
    let copper = at.run("materials Copper").out;
    has(&copper, &["117 GPa", "annealed", "makeitfrom.com", "condition uncertain"]);
    at.refuses("materials steel", &["steel-304", "steel-1020"]);
    at.refuses("solve a.x3p --material cooper --pressure 1MPa", &["copper", "materials"]);
}

/// As if they were typed in; own numbers override; condition and source are said.
#[test]
fn a_material_is_its_numbers() {
    let at = &surface(MAP);
    let solve = |bodies: &str| format!("solve a.x3p {bodies} --pressure 50MPa");
    let both = "--material copper --material steel-304 --resistivity table --conductivity table";
    let found = at.answer(&solve(both));
    let softness = 369e6 / 68f64.to_radians().sin(); // HV in Pa, over the projected area
    let modulus = 1.0 / ((1.0 - 0.34f64.powi(2)) / 117e9 + (1.0 - 0.29f64.powi(2)) / 193e9);
    close(number(&found["modulus"]), modulus, 1e-9);
    close(number(&found["hardness"]["pascals"]), softness, 1e-9);
    let same = at.answer(&solve(&format!(
        "--young 117GPa --poisson 0.34 --young 193GPa --poisson 0.29 --hardness {softness}Pa \
         --resistivity 17.24nohm.m,720nohm.m --conductivity 394W/m/K,16.2W/m/K"
    )));
    for key in ["area_fraction", "mean_gap", "electrical_conductance", "thermal_conductance"] {
        close(number(&found["points"][0][key]), number(&same["points"][0][key]), 1e-9);
    }
    let used = &found["materials"];
    assert_eq!(used[0]["condition"], "annealed");
    assert!(used[0]["numbers"]["hardness"]["sources"][0].is_string(), "{used}");
    assert!(used[1]["numbers"].get("hardness").is_none(), "the softer body yields: {used}");
    assert!(same.get("materials").is_none());
    let copper = "copper (copper, pure / Cu-ETP; annealed): E = 117 GPa (117 GPa to 130 GPa)";
    has(&at.run(&solve(both)).out, &[copper, "k = 16.2 W/m/K", "makeitfrom.com"]);

    // Own numbers before those of the table; a modulus leaves the hardness; elastic leaves it out.
    let own = at.answer(&solve("--material copper --young 130GPa --hardness 1GPa"));
    close(number(&own["modulus"]), 130e9 / (1.0 - 0.34f64.powi(2)), 1e-9);
    close(number(&own["hardness"]["pascals"]), 1e9, 1e-9);
    assert!(own["materials"][0]["numbers"].get("young").is_none(), "{own}");
    let rigid = at.answer(&solve("--modulus 100GPa --material copper"));
    close(number(&rigid["modulus"]), 100e9, 1e-9);
    close(number(&rigid["hardness"]["pascals"]), softness, 1e-9);
    let elastic = at.answer(&solve("--material copper --hardness elastic"));
    assert!(elastic.get("hardness").is_none());
}

#[test]
fn what_the_table_does_not_know_is_asked_for() {
    let at = &surface(MAP);
    let line = "solve a.x3p --pressure 1MPa";
    at.refuses_each(
        line,
        &[
            ("--material pmma", &["Poisson", "--poisson"]),
            ("--material copper --conductivity table", &["give two", "--conductivity"]),
            (
                "--material silicon --poisson 0.2 --material copper --poisson 0.34 --resistivity table",
                &["resistivity of silicon", "--resistivity"],
            ),
            ("--material copper,gold --young 100GPa", &["--young given 1", "2 times"]),
            ("--material copper --material gold --material tin", &["3 times", "two bodies"]),
            ("--conductivity table --modulus 1GPa", &["give two", "--conductivity"]),
        ],
    );
    let known = at.answer(&format!("{line} --material pmma --poisson 0.37"));
    close(number(&known["modulus"]), 3e9 / (1.0 - 0.37f64.powi(2)), 1e-9);
}

/// A study says what its numbers are of, on the page and in its JSON.
#[test]
fn a_study_says_its_materials_and_whether_they_stick() {
    let at = &surface(MAP);
    let line = "compare a.x3p --material copper --material steel-304 --conductivity table --pressure 20MPa,100MPa \
                --work-of-adhesion 50mJ/m2 --models gw --out r";
    let copper = "copper (copper, pure";
    has(&at.done(line).out, &[copper]);
    let page = at.read("r/report.html");
    has(&page, &[copper, "makeitfrom.com", "Adhesion is negligible", "capillary", "Pastewka"]);
    let found = at.results("r");
    assert_eq!(found["materials"][1]["name"], "steel-304");
    let adhesion = &found["surfaces"][0]["adhesion"];
    assert_eq!(adhesion["negligible"], true);
    assert!(number(&adhesion["fuller_tabor"]) > 10.0, "{adhesion}");
}

/// By the formulas from the numbers of `stats`; solved contacts have a share of their own.
#[test]
fn whether_bodies_stick_is_said() {
    let at = &surface(MAP);
    let line = "stats a.x3p --modulus 115GPa --work-of-adhesion";
    let steel = at.answer(&format!("{line} 0.05J/m^2"));
    let (a, s) = (&steel["adhesion"], &steel["asperities"]);
    assert_eq!(a["negligible"], true, "{a}");
    let (sigma, radius) = (number(&s["height_std"]), number(&s["radius"]));
    close(number(&a["fuller_tabor"]), 115e9 * sigma.powf(1.5) / (0.05 * radius.sqrt()), 1e-9);
    let (g, m4) = (number(&steel["rms_gradient"]), number(&steel["m4"]));
    let d = 4.0 * g / (2.0 / 3.0 * m4).sqrt();
    let criterion = g * 0.3e-9 * 115e9 / (2.0 * 0.05) * (g * d / 1.2e-9).powf(2.0 / 3.0);
    close(number(&a["pastewka_robbins"]), criterion, 1e-9);
    close(number(&a["effective_work"]), 0.05 - number(&a["full_contact_energy"]), 1e-9);
    has(&at.run(&format!("{line} 50mN/m")).out, &["Adhesion is negligible"]);

    let rubber = "a.x3p --modulus 1MPa";
    let sticky = format!("stats {rubber} --work-of-adhesion 50mJ/m2");
    assert_eq!(at.answer(&sticky)["adhesion"]["negligible"], false);
    let check = "check: Adhesion is not negligible: this program does not model it.";
    has(&at.run(&sticky).out, &[check]);

    let line = format!("solve {rubber} --pressure 1kPa,10kPa --work-of-adhesion 50mJ/m2");
    let solved = at.answer(&line);
    let rim = PI * (3.0 * 0.3e-9 * d.sqrt() / (4.0 * g)).powf(2.0 / 3.0) / d;
    let shares = list(&solved["points"])
        .iter()
        .map(|p| 0.05 / 0.3e-9 * rim * number(&p["area_fraction"]) / number(&p["mean_pressure"]));
    close(number(&solved["adhesion"]["attraction"]), shares.fold(0.0, f64::max), 1e-6);
    has(&at.run(&line).out, &["Adhesion is not negligible"]);
    for line in [format!("stats {rubber}"), format!("solve {rubber} --pressure 1kPa")] {
        assert!(at.answer(&line).get("adhesion").is_none(), "{line}");
    }
    let none = at.answer(&format!("stats {rubber} --work-of-adhesion 0J/m^2"));
    assert_eq!(none["adhesion"]["negligible"], true);
    at.refuses_each(
        &format!("stats {rubber}"),
        &[
            ("--work-of-adhesion 0.05", &["unit"]),
            ("--work-of-adhesion -1mJ/m2", &["0 or more"]),
            ("--work-of-adhesion nanJ/m2", &["finite"]),
            ("--work-of-adhesion 5mJ", &["unit"]),
            ("--work-of-adhesion 5mJ/m2 --attraction-range 0nm", &["above 0 m"]),
            ("--attraction-range 1nm", &["--work-of-adhesion"]),
        ],
    );
    at.refuses("stats a.x3p --work-of-adhesion 5mJ/m2", &["modulus"]);
}

/// The table of the book has the numbers of the program.
#[test]
fn the_page_has_the_table() {
    let all = folder().answer("materials");
    let page = book("materials.md");
    let listed = list(&all["materials"]);
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
            let mut words = cell.split_whitespace().map(|word| word.trim_end_matches(','));
            let shown: f64 = words.next().and_then(|w| w.parse().ok()).expect("a number");
            let scale = match words.next() {
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
    let at = &surface(MAP);
    // What is left out of the hardness is an option that `model` does not have.
    for (command, rest) in [
        ("solve a.x3p", "--hardness elastic"),
        ("model gw a.x3p", ""),
        ("compare a.x3p --models gw,persson", "--hardness elastic --force --out of"),
    ] {
        for (name, bodies, e_star, against) in [
            ("-one", "steel-304", 193e9, "ν = 0.29, against a rigid flat"),
            ("-two", "steel-304,steel-304", 96.5e9, "ν = 0.29, against E = 193 GPa"),
        ] {
            let line = format!("{command} --material {bodies} --pressure 100MPa --quiet {rest}");
            let line = if rest.ends_with("of") { line + name } else { line };
            let modulus = format!("E* = {:.1} GPa", e_star / (1.0 - 0.29f64.powi(2)) / 1e9);
            has(&at.run(&line).out, &[&modulus, against]);
            let json = at.answer(&line);
            let surface = json.get("surfaces").map_or(&json, |all| &all[0]);
            assert_eq!(surface["bodies"][1]["rigid"], name == "-one", "{line}");
        }
    }
    // On the first screen.
    has(&at.read("of-one/report.html"), &[", against a rigid flat</td>"]);
}
