//! Joints as an engineer asks for them: from σ, slope and hardness, in vacuum and in gas, in Ω and
//! K/W; and what the contacts of a study conduct.

use crate::cli::{TestFolder, book, close, ends, folder, has, list, number, surface};
use serde_json::Value;
use std::f64::consts::PI;

const CMY: &str = "model cmy --rms-height 0.6um --mean-slope 0.1 --hardness 1.2GPa \
                   --conductivity 180W/m/K,16W/m/K";
const BODIES: &str = "--conductivity 180W/m/K,16W/m/K";

fn asked(line: &str) -> Value {
    folder().answer(line)
}

/// Conductance of the first load.
fn conductance(line: &str) -> f64 {
    number(&asked(line)["points"][0]["thermal_conductance"])
}

/// The joint of the book: 7272.82 and 64819.1 W/m²/K, and what the page on joints says of it.
#[test]
fn a_joint_from_height_slope_and_hardness() {
    let found = asked(&format!("{CMY} --pressure 1MPa,10MPa --area 4cm2"));
    let points = list(&found["points"]);
    for (point, expected) in points.iter().zip([7272.82, 64819.1]) {
        let of = |key: &str| number(&point[key]);
        close(of("thermal_conductance"), expected, 1e-6);
        let formula = 1.25 * 2.0 * 180.0 * 16.0 / 196.0 * 0.1 / 0.6e-6
            * (of("mean_pressure") / 1.2e9).powf(0.95);
        close(of("thermal_conductance"), formula, 1e-12);
        close(of("thermal_resistance"), 1.0 / (formula * 4e-4), 1e-12);
        // Holm: one spot of the same load and hardness.
        let radius = (of("mean_pressure") * 4e-4 / (PI * 1.2e9)).sqrt();
        let spot = (1.0 / 180.0 + 1.0 / 16.0) / (4.0 * radius);
        close(of("thermal_resistance_one_spot"), spot, 1e-12);
        close(of("thermal_conductance_exact"), formula, 0.015);
    }
    assert!(found["modulus"].is_null() && points[0].get("gas_conductance").is_none());
}

#[test]
fn two_surfaces_ra_and_current() {
    let one = conductance(&format!("{CMY} --pressure 1MPa"));
    for [heights, slopes] in [["0.36um,0.48um", "0.06,0.08 "], ["0.6um,0um", "0.1,0 "]] {
        let two = CMY.replace("0.6um", heights).replace("0.1 ", slopes);
        close(conductance(&format!("{two} --pressure 1MPa")), one, 1e-12);
    }
    let ra = format!("--ra {}um", 0.6 * (2.0 / PI).sqrt());
    let ra = CMY.replace("--rms-height 0.6um", &ra);
    close(conductance(&format!("{ra} --pressure 1MPa")), one, 1e-12);
    let current = CMY.replace(BODIES, "--resistivity 20nohm.m,30nohm.m");
    let current = asked(&format!("{current} --load 5N --area 1mm2"))["points"][0].clone();
    let formula = 1.25 * 2.0 / 50e-9 * 0.1 / 0.6e-6 * (5e6 / 1.2e9_f64).powf(0.95);
    close(number(&current["electrical_conductance"]), formula, 1e-12);
    close(number(&current["electrical_resistance"]), 1.0 / (formula * 1e-6), 1e-12);
    // Two materials know their conductivities, and what they are made of.
    let elastic = asked(
        "model mikic --rms-height 0.6um --mean-slope 0.1 --material copper,al-6061 --pressure 1MPa",
    );
    let strength = 2f64.sqrt() * 1e6 / (number(&elastic["modulus"]) * 0.1);
    let h = number(&elastic["points"][0]["thermal_conductance"]);
    let ratio = h / strength.powf(0.94) * 0.6e-6 / 0.155;
    assert!((100.0..450.0).contains(&ratio), "a mean conductivity: {ratio}");
}

/// CMY's gap at P/H = 1e-3 and M = 0.28 σ: I = 0.333529222833.
#[test]
fn gas_beside_the_contact() {
    let in_air =
        |joint: &str, more: &str| asked(&format!("{joint} --pressure 1.2MPa --gas {more}"));
    let found = in_air(CMY, "Air --accommodation 0.9,0.8");
    let (gas, point) = (&found["gas"], &found["points"][0]);
    let (a, b) = (1.1 / 0.9, 1.2 / 0.8);
    let prandtl = 1.85e-5 * 1004.5 / 0.0261;
    let jump = (a + b) * 2.8 / (2.4 * prandtl) * number(&gas["free_path"]);
    close(number(&gas["jump"]), jump, 1e-12);
    let sigma = number(&gas["jump"]) / 0.28;
    let scaled = CMY.replace("0.6um", &format!("{sigma}m"));
    let scaled = in_air(&scaled, "air --accommodation 0.9,0.8");
    let conducted = number(&scaled["points"][0]["gas_conductance"]);
    close(conducted * sigma / number(&gas["conductivity"]), 0.333_529_222_833, 1e-11);
    let contact = conductance(&format!("{CMY} --pressure 1.2MPa --gas vacuum"));
    let both = contact + number(&point["gas_conductance"]);
    close(number(&point["joint_conductance"]), both, 1e-12);
    // Half the pressure, twice the path; hotter gas conducts better.
    let thin = in_air(CMY, "air --gas-pressure 50662.5Pa");
    close(number(&thin["gas"]["free_path"]), 2.0 * number(&gas["free_path"]), 1e-12);
    let hot = in_air(CMY, "air --temperature 126.85degC");
    close(number(&hot["gas"]["conductivity"]), 0.0328, 1e-12);
    let text = folder().run(&format!("{CMY} --pressure 1MPa --gas helium")).out;
    has(&text, &["In the gap helium at 298 K and 101 kPa"]);
    assert!(text.contains("Knudsen") || text.contains("free path over mean gap"), "{text}");
}

/// A map: the contact, the gas and both, with intervals; the resistance of the map, or of the part.
#[test]
fn a_map_in_air_has_resistances_with_uncertainty() {
    let at = &folder();
    let made = at.answer(
        "synth --shape 128,128 --pixel 1um --hurst 0.8 --cutoff 8um --rms-height 0.6um \
         --rms-gradient 0.12 --seed 3 --out a.x3p",
    );
    assert!((8e-6..128e-6).contains(&number(&made["rolloff"])), "{made}");
    let bodies =
        format!("--modulus 100GPa --hardness 2GPa {BODIES} --resistivity 20nohm.m --gas air");
    let found = at.answer(&format!("solve a.x3p {bodies} --pressure 5MPa,20MPa"));
    close(number(&found["nominal_area"]), 16384e-12, 1e-12);
    let keys =
        ["gas_conductance", "joint_conductance", "thermal_resistance", "electrical_resistance"];
    for point in list(&found["points"]) {
        let of = |key: &str| number(&point[key]);
        let both = of("thermal_conductance") + of("gas_conductance");
        close(of("joint_conductance"), both, 1e-12);
        close(of("thermal_resistance") * both * 16384e-12, 1.0, 1e-12);
        close(of("electrical_resistance") * of("electrical_conductance") * 16384e-12, 1.0, 1e-12);
        for key in keys {
            let [low, high] = ends(&point[format!("{key}_interval")]);
            assert!(low < of(key) && of(key) < high && high < 2.0 * low, "{key}: {low} {high}");
        }
        // The ± of a conductance is that of the stiffness of its set.
        let share = |key: &str| ends(&point[format!("{key}_interval")]).map(|end| end / of(key));
        for (own, of_set) in share("electrical_conductance").iter().zip(share("stiffness")) {
            assert!((own - of_set).abs() < 1e-12, "{point}");
        }
        // Between plates at the mean gap and at no gap.
        let (k, jump) = (number(&found["gas"]["conductivity"]), number(&found["gas"]["jump"]));
        let plate = k / (of("mean_gap") + jump);
        assert!((plate..k / jump).contains(&of("gas_conductance")), "{point}");
    }
    let part = at.answer(&format!("solve a.x3p {bodies} --pressure 5MPa --area 2mm2"));
    let [whole, part] = [&found, &part].map(|f| number(&f["points"][0]["thermal_resistance"]));
    close(part / whole * 2e-6 / 16384e-12, 1.0, 1e-12);
    let text = at.run(&format!("solve a.x3p {bodies} --pressure 5MPa")).out;
    let head = text.lines().find(|line| line.contains("mean pressure")).expect("a header");
    assert!(head.trim_start().starts_with("resistance"), "{head}");
    // The study says the same, with closed forms beside it.
    at.done(&format!("compare a.x3p {bodies} --pressure 5MPa,20MPa --headline 5MPa --out report"));
    let study = at.results("report")["surfaces"][0]["conduction"].clone();
    for key in keys {
        close(number(&study["points"][0][key]), number(&found["points"][0][key]), 1e-3);
    }
    let cmy = list(&study["theories"]).iter().find(|t| t["model"] == "cmy").expect("cmy");
    let gas = number(&cmy["points"][0]["gas_conductance"]);
    close(gas, number(&study["points"][0]["gas_conductance"]), 0.3);
    let page = at.read("report/report.html");
    let [first, load] = ["Contact resistance", "Materials"].map(|t| page.find(t).expect(t));
    assert!(first < load);
    has(&page, &["Gas by CMY", "Conductance of the joint"]);
}

#[test]
fn what_has_no_meaning_is_refused() {
    let at = &folder();
    let cmy = format!("{CMY} --pressure 1MPa");
    at.refuses_each(
        &cmy,
        &[
            ("--gas air --temperature 0K", &["absolute zero"]),
            ("--gas air --temperature 300", &["350K"]),
            ("--gas air --temperature 2000K", &["100", "1000"]),
            ("--gas air --gas-pressure 0Pa", &["gas pressure"]),
            ("--gas air --accommodation 1.1", &["above 0 and at most 1"]),
            ("--gas air --accommodation 0,1", &["above 0 and at most 1"]),
            ("--gas steam", &["helium"]),
            ("--modulus 1GPa", &["--modulus is no input of cmy", "--mean-slope"]),
            ("--young 1GPa --poisson 0.3", &["--young is no input of cmy"]),
        ],
    );
    let full = format!("{CMY} --pressure 1.2GPa");
    for (line, why) in [(full, "everything touches"), (cmy.replace("0.6um", "0um"), "rms height")] {
        let said = at.run(&line);
        assert!(said.status != 0 && said.err.contains(why), "{}", said.err);
    }
    let ra = "model cmy --ra 0.8um --hardness 1.2GPa --conductivity 50W/m/K --pressure 1MPa";
    at.refuses(ra, &["--mean-slope", "measure"]);
    let silent = CMY.replace(BODIES, "--pressure 1MPa");
    at.refuses(&silent, &["--conductivity", "--resistivity"]);
    at.refuses(&cmy.replace("16W", "0W"), &["conductivity = 0", "greater than 0"]);
    at.refuses(&cmy.replace("0.6um", "0.6um,0.4um"), &["--mean-slope: 1", "two surfaces"]);
    let gas =
        "model gw --m0 1um^2 --m2 0.01 --m4 1e9m^-2 --modulus 100GPa --pressure 1MPa --gas air";
    at.refuses(gas, &["--conductivity"]);
    let synth = "synth --shape 64,64 --pixel 1um --hurst 0.8 --rolloff 32um --cutoff 8um --rms-height 1um \
                 --rms-gradient 0.1 --seed 1 --out never.npy";
    at.refuses(synth, &["--rolloff", "leave one out"]);
}

/// The commands of the page on joints, as a reader repeats them, and every number that stands below them.
#[test]
fn the_page_on_joints_says_what_the_commands_say() {
    let at = &folder();
    let (mut said, mut checked) = (String::new(), 0);
    for line in book("models/joint.md").split("## Equations").next().expect("a part").lines() {
        if let Some(command) = line.strip_prefix("$ rough-contact ") {
            said = at.done(command).out;
        } else if let Some(row) = line.strip_prefix("| 1") {
            let cells = row.split('|').skip(1).map(str::trim).filter(|cell| !cell.is_empty());
            let cells: Vec<&str> = cells.collect();
            has(&said, &cells);
            checked += cells.len();
        } else if line.contains("K/W ") && !line.starts_with('|') {
            has(&said, &[line.trim_end()]);
            checked += 1;
        }
    }
    assert_eq!(checked, 10);
}

const LOADS: &str = "--modulus 110GPa --pressure 20MPa,100MPa,500MPa";
const MAP: &str = "--shape 128,128 --rolloff 64um --cutoff 6um";
const CONDUCTORS: &str = "--resistivity 22nohm.m,7uohm.cm --conductivity 50W/m/K";

fn study(at: &TestFolder, rest: &str) -> Value {
    at.done(&format!("compare a.x3p {LOADS} {rest} --out report --force"));
    at.results("report")["surfaces"][0].clone()
}

/// A study and `solve` conduct alike, elastic and yielding, and so do JSON, CSV and page.
#[test]
fn a_study_conducts_as_its_solutions_do() {
    let at = &surface(MAP);
    for more in ["", "--hardness 3GPa"] {
        let is_elastic = more.is_empty();
        let found = study(at, &format!("{CONDUCTORS} {more} --tolerance 1e-6"));
        let [points, theories, octaves] =
            ["points", "theories", "octaves"].map(|key| list(&found["conduction"][key]));
        let solved =
            at.answer(&format!("solve a.x3p {LOADS} {CONDUCTORS} {more} --tolerance 1e-6"));
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
    let at = &surface(MAP);
    let plain = study(at, "");
    assert!(plain["conduction"].is_null() && !at.read("report/report.html").contains("conduct"));
    // A superconductor may be on one side; what conducts nothing is refused.
    let one = study(at, "--resistivity 0ohm.m,92nohm.m")["conduction"]["points"][1].clone();
    let k = number(&one["stiffness"]);
    close(number(&one["electrical_conductance"]), 2.0 * k / (110e9 * 92e-9), 1e-12);
    for line in
        ["solve a.x3p --resistivity 0ohm.m", "compare a.x3p --out q --conductivity 0W/m/K,50W/m/K"]
    {
        at.refuses(&format!("{line} {LOADS}"), &["= 0", "greater than 0"]);
    }
    at.refuses(&format!("compare a.x3p {LOADS} --resistivity 5 --out q"), &["unit"]);
}

/// A load that is refused, and one that is not solved to the tolerance, stand under the headings of the others.
#[test]
fn a_load_without_resistances_keeps_its_place_in_the_table() {
    let at = &surface(MAP);
    let line = format!(
        "solve a.x3p --modulus 110GPa {CONDUCTORS} --hardness 3GPa --pressure 1e-25Pa,9MPa"
    );
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
