//! Joints as an engineer asks for them: from σ, slope and hardness, in vacuum and in gas, in Ω and K/W.

use crate::cli;

use cli::{folder, number, refused, rough_contact};
use serde_json::Value;
use std::f64::consts::PI;
use std::path::Path;

const CMY: &str = "model cmy --rms-height 0.6um --mean-slope 0.1 --hardness 1.2GPa \
                   --conductivity 180W/m/K,16W/m/K";

fn close(found: &Value, expected: f64, tolerance: f64) {
    let found = number(found);
    assert!((found / expected - 1.0).abs() < tolerance, "{found} instead of {expected}");
}

fn asked(line: &str) -> Value {
    rough_contact(Path::new("."), &format!("{line} --json")).answered()
}

/// The joint of the book: 7272.82 and 64819.1 W/m²/K, and what the page on joints says of it.
#[test]
fn a_joint_from_height_slope_and_hardness() {
    let found = asked(&format!("{CMY} --pressure 1MPa,10MPa --area 4cm2"));
    let points = found["points"].as_array().expect("points");
    for (point, expected) in points.iter().zip([7272.82, 64819.1]) {
        close(&point["thermal_conductance"], expected, 1e-6);
        let formula = 1.25 * 2.0 * 180.0 * 16.0 / 196.0 * 0.1 / 0.6e-6
            * (number(&point["mean_pressure"]) / 1.2e9).powf(0.95);
        close(&point["thermal_conductance"], formula, 1e-12);
        close(&point["thermal_resistance"], 1.0 / (formula * 4e-4), 1e-12);
        // Holm: one spot of the same load and hardness.
        let radius = (number(&point["mean_pressure"]) * 4e-4 / (PI * 1.2e9)).sqrt();
        let spot = (1.0 / 180.0 + 1.0 / 16.0) / (4.0 * radius);
        close(&point["thermal_resistance_one_spot"], spot, 1e-12);
        close(&point["thermal_conductance_exact"], formula, 0.015);
    }
    assert!(found["modulus"].is_null() && points[0].get("gas_conductance").is_none());
}

#[test]
fn two_surfaces_ra_and_current() {
    let one = asked(&format!("{CMY} --pressure 1MPa"));
    let two = CMY.replace("0.6um", "0.36um,0.48um").replace("0.1 ", "0.06,0.08 ");
    let two = asked(&format!("{two} --pressure 1MPa"));
    let first = |found: &Value| number(&found["points"][0]["thermal_conductance"]);
    assert!((first(&two) / first(&one) - 1.0).abs() < 1e-12);
    let ra = 0.6 * (2.0 / PI).sqrt();
    let ra = CMY.replace("--rms-height 0.6um", &format!("--ra {ra}um"));
    assert!((first(&asked(&format!("{ra} --pressure 1MPa"))) / first(&one) - 1.0).abs() < 1e-12);
    let current = CMY.replace("--conductivity 180W/m/K,16W/m/K", "--resistivity 20nohm.m,30nohm.m");
    let current = asked(&format!("{current} --load 5N --area 1mm2"));
    let formula = 1.25 * 2.0 / 50e-9 * 0.1 / 0.6e-6 * (5e6 / 1.2e9_f64).powf(0.95);
    close(&current["points"][0]["electrical_conductance"], formula, 1e-12);
    close(&current["points"][0]["electrical_resistance"], 1.0 / (formula * 1e-6), 1e-12);
    // Two materials know their conductivities, and what they are made of.
    let elastic = asked(
        "model mikic --rms-height 0.6um --mean-slope 0.1 --material copper,al-6061 --pressure 1MPa",
    );
    let point = &elastic["points"][0];
    let strength = 2f64.sqrt() * 1e6 / (number(&elastic["modulus"]) * 0.1);
    let ratio = number(&point["thermal_conductance"]) / strength.powf(0.94) * 0.6e-6 / 0.155;
    assert!((100.0..450.0).contains(&ratio), "a mean conductivity: {ratio}");
}

/// CMY's gap at P/H = 1e-3 and M = 0.28 σ: I = 0.333529222833.
#[test]
fn gas_beside_the_contact() {
    let vacuum = asked(&format!("{CMY} --pressure 1.2MPa --gas vacuum"));
    let found = asked(&format!("{CMY} --pressure 1.2MPa --gas Air --accommodation 0.9,0.8"));
    let (gas, point) = (&found["gas"], &found["points"][0]);
    let (a, b) = (1.1 / 0.9, 1.2 / 0.8);
    let prandtl = 1.85e-5 * 1004.5 / 0.0261;
    close(&gas["jump"], (a + b) * 2.8 / (2.4 * prandtl) * number(&gas["free_path"]), 1e-12);
    let sigma = number(&gas["jump"]) / 0.28;
    let scaled = CMY.replace("0.6um", &format!("{sigma}m"));
    let scaled = asked(&format!("{scaled} --pressure 1.2MPa --gas air --accommodation 0.9,0.8"));
    let integral =
        number(&scaled["points"][0]["gas_conductance"]) * sigma / number(&gas["conductivity"]);
    assert!((integral / 0.333_529_222_833 - 1.0).abs() < 1e-11, "{integral}");
    let contact = number(&vacuum["points"][0]["thermal_conductance"]);
    close(&point["joint_conductance"], contact + number(&point["gas_conductance"]), 1e-12);
    // Half the pressure, twice the path; hotter gas conducts better.
    let thin = asked(&format!(
        "{CMY} --pressure 1.2MPa --gas air --gas-pressure 50662.5Pa --temperature 298K"
    ));
    close(&thin["gas"]["free_path"], 2.0 * 61.11e-9, 1e-12);
    let hot = asked(&format!("{CMY} --pressure 1.2MPa --gas air --temperature 126.85degC"));
    close(&hot["gas"]["conductivity"], 0.0328, 1e-12);
    let text = rough_contact(Path::new("."), &format!("{CMY} --pressure 1MPa --gas helium")).out;
    assert!(
        text.contains("In the gap helium at 298 K and 101 kPa")
            && text.contains("Knudsen") | text.contains("free path over mean gap"),
        "{text}"
    );
}

/// A map: the contact, the gas and both, with intervals; the resistance of the map, or of the part.
#[test]
fn a_map_in_air_has_resistances_with_uncertainty() {
    let dir = folder();
    let at = dir.path();
    let synth = "synth --shape 128,128 --pixel 1um --hurst 0.8 --cutoff 8um --rms-height 0.6um \
                 --rms-gradient 0.12 --seed 3 --out a.x3p";
    let made = rough_contact(at, &format!("{synth} --json")).answered();
    assert!((8e-6..128e-6).contains(&number(&made["rolloff"])), "{made}");
    let bodies = "--modulus 100GPa --hardness 2GPa --conductivity 180W/m/K,16W/m/K --resistivity 20nohm.m --gas air";
    let found =
        rough_contact(at, &format!("solve a.x3p {bodies} --pressure 5MPa,20MPa --json")).answered();
    close(&found["nominal_area"], 16384e-12, 1e-12);
    for point in found["points"].as_array().expect("points") {
        let of = |key: &str| number(&point[key]);
        let both = of("thermal_conductance") + of("gas_conductance");
        assert!((of("joint_conductance") / both - 1.0).abs() < 1e-12);
        assert!((of("thermal_resistance") * both * 16384e-12 - 1.0).abs() < 1e-12);
        assert!(
            (of("electrical_resistance") * of("electrical_conductance") * 16384e-12 - 1.0).abs()
                < 1e-12
        );
        for key in
            ["gas_conductance", "joint_conductance", "thermal_resistance", "electrical_resistance"]
        {
            let [low, high] = [0, 1].map(|i| number(&point[format!("{key}_interval")][i]));
            assert!(low < of(key) && of(key) < high && high < 2.0 * low, "{key}: {low} {high}");
        }
        // Between plates at the mean gap and at no gap.
        let (k, jump) = (number(&found["gas"]["conductivity"]), number(&found["gas"]["jump"]));
        let plate = k / (of("mean_gap") + jump);
        assert!((plate..k / jump).contains(&of("gas_conductance")), "{point}");
    }
    let part =
        rough_contact(at, &format!("solve a.x3p {bodies} --pressure 5MPa --area 2mm2 --json"))
            .answered();
    let [whole, part] = [&found, &part].map(|f| number(&f["points"][0]["thermal_resistance"]));
    assert!((part / whole * 2e-6 / 16384e-12 - 1.0).abs() < 1e-12);
    let text = rough_contact(at, &format!("solve a.x3p {bodies} --pressure 5MPa")).out;
    let head = text.lines().find(|line| line.contains("mean pressure")).expect("a header");
    assert!(head.trim_start().starts_with("resistance"), "{head}");
    // The study says the same, with closed forms beside it.
    let line = format!("compare a.x3p {bodies} --pressure 5MPa,20MPa --headline 5MPa --out report");
    assert_eq!(rough_contact(at, &line).status, 0);
    let text = std::fs::read_to_string(at.join("report/results.json")).expect("results");
    let study: Value = serde_json::from_str(&text).expect("JSON");
    let study = &study["surfaces"][0]["conduction"];
    for key in
        ["gas_conductance", "joint_conductance", "thermal_resistance", "electrical_resistance"]
    {
        close(&study["points"][0][key], number(&found["points"][0][key]), 1e-3);
    }
    let cmy = study["theories"].as_array().expect("theories").iter().find(|t| t["model"] == "cmy");
    let gas = number(&cmy.expect("cmy")["points"][0]["gas_conductance"]);
    assert!((gas / number(&study["points"][0]["gas_conductance"]) - 1.0).abs() < 0.3, "{gas}");
    let page = std::fs::read_to_string(at.join("report/report.html")).expect("page");
    let [first, load] = ["Contact resistance", "Materials"].map(|t| page.find(t).expect(t));
    assert!(
        first < load && page.contains("Gas by CMY") && page.contains("Conductance of the joint")
    );
}

#[test]
fn what_has_no_meaning_is_refused() {
    let at = Path::new(".");
    let [air, cmy] = [format!("{CMY} --pressure 1MPa --gas air"), format!("{CMY} --pressure 1MPa")];
    refused(at, &format!("{air} --temperature 0K"), 2, &["absolute zero"]);
    refused(at, &format!("{air} --temperature 300"), 2, &["350K"]);
    refused(at, &format!("{air} --temperature 2000K"), 2, &["100", "1000"]);
    refused(at, &format!("{air} --gas-pressure 0Pa"), 2, &["gas pressure"]);
    refused(at, &format!("{air} --accommodation 1.1"), 2, &["above 0 and at most 1"]);
    refused(at, &format!("{air} --accommodation 0,1"), 2, &["above 0 and at most 1"]);
    refused(at, &format!("{cmy} --gas steam"), 2, &["helium"]);
    let flat = cmy.replace("0.6um", "0um");
    let full = format!("{CMY} --pressure 1.2GPa");
    for (line, why) in [(full, "everything touches"), (flat, "rms height")] {
        let said = rough_contact(at, &line);
        assert!(said.status != 0 && said.err.contains(why), "{}", said.err);
    }
    let ra = "model cmy --ra 0.8um --hardness 1.2GPa --conductivity 50W/m/K --pressure 1MPa";
    refused(at, ra, 2, &["--mean-slope", "measure"]);
    let silent = CMY.replace("--conductivity 180W/m/K,16W/m/K", "--pressure 1MPa");
    refused(at, &silent, 2, &["--conductivity", "--resistivity"]);
    refused(at, &cmy.replace("0.6um", "0.6um,0.1um,0.2um"), 2, &["two surfaces"]);
    let gas =
        "model gw --m0 1um^2 --m2 0.01 --m4 1e9m^-2 --modulus 100GPa --pressure 1MPa --gas air";
    refused(at, gas, 2, &["--conductivity"]);
    let synth = "synth --shape 64,64 --pixel 1um --hurst 0.8 --rolloff 32um --cutoff 8um --rms-height 1um \
                 --rms-gradient 0.1 --seed 1 --out never.npy";
    refused(at, synth, 2, &["--rolloff", "leave one out"]);
}

/// The commands of the page on joints, as a reader repeats them, and every number that stands below them.
#[test]
fn the_page_on_joints_says_what_the_commands_say() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/src/models/joint.md");
    let page = std::fs::read_to_string(page).expect("the page");
    let dir = folder();
    let (mut said, mut checked) = (String::new(), 0);
    for line in page.split("## Equations").next().expect("a part").lines() {
        if let Some(command) = line.strip_prefix("$ rough-contact ") {
            let answer = rough_contact(dir.path(), command);
            assert_eq!(answer.status, 0, "{}", answer.err);
            said = answer.out;
        } else if let Some(row) = line.strip_prefix("| 1") {
            for cell in row.split('|').skip(1).map(str::trim).filter(|cell| !cell.is_empty()) {
                assert!(said.contains(cell), "{cell}: {said}");
                checked += 1;
            }
        } else if line.contains("K/W ") && !line.starts_with('|') {
            assert!(said.contains(line.trim_end()), "{line}: {said}");
            checked += 1;
        }
    }
    assert_eq!(checked, 10);
}
