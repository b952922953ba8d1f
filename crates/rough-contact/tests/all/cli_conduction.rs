//! What the contacts of a study conduct, as a user asks for it.

use crate::cli::{TestFolder, close, folder, has, list, number};
use serde_json::Value;

const LOADS: &str = "--modulus 110GPa --pressure 20MPa,100MPa,500MPa";
const BODIES: &str = "--resistivity 22nohm.m,7uohm.cm --conductivity 50W/m/K";

fn surface() -> TestFolder {
    let at = folder();
    at.synth("a.x3p", "--shape 128,128 --rolloff 64um --cutoff 6um --rms-gradient 0.1 --seed 4");
    at
}

fn study(at: &TestFolder, rest: &str) -> Value {
    at.done(&format!("compare a.x3p {LOADS} {rest} --out report --force"));
    at.results("report")["surfaces"][0].clone()
}

/// A study and `solve` conduct alike, elastic and yielding, and so do JSON, CSV and page.
#[test]
fn a_study_conducts_as_its_solutions_do() {
    let at = &surface();
    for more in ["", "--hardness 3GPa"] {
        let is_elastic = more.is_empty();
        let found = study(at, &format!("{BODIES} {more} --tolerance 1e-6"));
        let [points, theories, octaves] =
            ["points", "theories", "octaves"].map(|key| list(&found["conduction"][key]));
        let solved = at.answer(&format!("solve a.x3p {LOADS} {BODIES} {more} --tolerance 1e-6"));
        for i in 0..3 {
            let (here, there) = (&points[i], &solved["points"][i]);
            for key in ["stiffness", "electrical_conductance", "thermal_conductance"] {
                close(number(&here[key]), number(&there[key]), 1e-3);
                close(at.column("report/curves.csv", key)[i], number(&here[key]), 1e-12);
            }
            let k = number(&here["stiffness"]);
            close(number(&here["electrical_conductance"]), 2.0 * k / (110e9 * 92e-9), 1e-12);
            close(number(&here["thermal_conductance"]), 2.0 * k * 25.0 / 110e9, 1e-12);
            assert!(number(&there["conduction"]["residual"]) < 1e-7, "{there}");
            assert_eq!(there["contact_set"], "part");
            let resistance = number(&here["thermal_resistance"]);
            close(resistance * number(&here["thermal_conductance"]) * 16384e-12, 1.0, 1e-12);
            close(resistance, number(&there["thermal_resistance"]), 1e-3);
            for (theory, name) in theories.iter().zip(["gw", "bgt", "persson"]) {
                assert_eq!(theory["model"], name);
                let stiffness = number(&theory["points"][i]["stiffness"]);
                let h = number(&theory["points"][i]["electrical_conductance"]);
                close(h, 2.0 * stiffness / (110e9 * 92e-9), 1e-12);
                // Elastic theories of a random surface are within a factor of three of its solution, where
                // more than a few spots touch.
                let ratio = stiffness / k;
                assert!(i == 0 || !is_elastic || (0.3..3.0).contains(&ratio), "{name}: {ratio}");
            }
            // The correlations are tested in their crates; of bodies that do not yield that of plastic contact says nothing.
            let conducts = |name: &str| theories.iter().any(|theory| theory["model"] == name);
            assert!(conducts("mikic") && conducts("cmy") != is_elastic, "{theories:?}");
        }
        // The whole map comes first among the octaves, and the shortest waves are what the area lives of.
        assert!(octaves.len() >= 2, "{octaves:?}");
        let headline = number(&found["headline_pressure"]);
        let same = |p: &&Value| (number(&p["mean_pressure"]) / headline - 1.0).abs() < 1e-12;
        let at_headline = points.iter().find(same).expect("the headline");
        close(number(&octaves[0]["stiffness"]), number(&at_headline["stiffness"]), 1e-12);
        for pair in octaves.windows(2) {
            let wave = |o: &Value| number(&o["shortest_wavelength"]);
            close(wave(&pair[1]), 2.0 * wave(&pair[0]), 1e-12);
        }
        if is_elastic {
            let area = |o: &Value| number(&o["area_fraction"]);
            assert!(area(&octaves[1]) > 1.05 * area(&octaves[0]), "{octaves:?}");
        }
        let page = at.read("report/report.html");
        has(&page, &["thermal contact conductance", "Thermal conductance"]);
        assert_eq!(page.contains(">CMY<"), !is_elastic);
    }
}

#[test]
fn nothing_is_said_unasked_and_limits_are_allowed() {
    let at = &surface();
    let plain = study(at, "");
    assert!(plain["conduction"].is_null() && !at.read("report/report.html").contains("conduct"));
    // Superconductors have no end of it, an insulator lets nothing through; neither is a line.
    let short = study(at, "--resistivity 0ohm.m");
    assert!(short["conduction"]["points"][1]["electrical_conductance"].is_null());
    assert!(number(&short["conduction"]["points"][1]["stiffness"]) > 0.0);
    let none = study(at, "--conductivity 0W/m/K,50W/m/K");
    assert!(number(&none["conduction"]["points"][1]["thermal_conductance"]).abs() < 1e-300);
    at.refuses(&format!("compare a.x3p {LOADS} --resistivity 5 --out q"), &["unit"]);
}

/// A load that is refused, and one that is not solved to the tolerance, stand under the headings of the others.
#[test]
fn a_load_without_resistances_keeps_its_place_in_the_table() {
    let at = &surface();
    let line =
        format!("solve a.x3p --modulus 110GPa {BODIES} --hardness 3GPa --pressure 1e-25Pa,9MPa");
    for (more, row, cell, heading) in [
        ("", 1, "refused", "touching"),
        ("--precision f32 --tolerance 1e-10", 2, "9.00 MPa", "mean pressure"),
    ] {
        let out = at.run(&format!("{line} {more}")).out;
        let table: Vec<&str> = out.lines().skip_while(|l| !l.contains("mean pressure")).collect();
        let end =
            |row: &str, cell: &str| row[..row.find(cell).unwrap() + cell.len()].chars().count();
        assert_eq!(end(table[row], cell), end(table[0], heading), "{out}");
    }
}
