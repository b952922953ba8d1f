//! Every model by name, with numbers typed in, against high-precision values.

use crate::cli::{ROUGH, close, ends, folder, has, list, number};
use serde_json::Value;
use std::f64::consts::{PI, SQRT_2};

/// The points of `model LINE --json`.
fn points(line: &str) -> Vec<Value> {
    let object = folder().answer(&format!("model {line}"));
    assert!(object["citation"]["year"].as_u64().unwrap_or(0) > 1900);
    list(&object["points"]).to_vec()
}

const GW: &str = "gw --asperity-density 49867200m^-2 --asperity-radius 0.5mm \
                  --asperity-height-std 0.634125750251345949577869um \
                  --mean-offset 1.84265708194896327817124um --modulus 1Pa";
const BGT: &str = "--m0 1um^2 --m2 0.01 --m4 5e8m^-2 --modulus 10Pa"; // bandwidth 5
const SPECTRUM: &str = "--hurst 0.8 --rolloff 100um --cutoff 2um --m0 0.2um^2";
const PERSSON: &str = "persson --hurst 0.8 --rolloff 6.283185307179586m --cutoff 0.06283185307179586m \
                       --m0 1m^2 --modulus 1GPa --pressure 46.09956908378556555884MPa";

/// By mpmath with 20 digits and more, or by hand. The crates of the models have tables of them.
#[test]
fn every_model_gives_its_high_precision_value() {
    let spheres = 1e6 * PI * (0.75f64 * 1e-3 * (1e6 / 1e6) / 100e9).powf(2.0 / 3.0); // Hertz
    let [gw, loaded_gw] =
        ["--separation 3um", "--pressure 8.06908960732518799e-6Pa"].map(|at| format!("{GW} {at}"));
    let [bgt, elliptical] =
        ["bgt", "greenwood-elliptical"].map(|name| format!("{name} {BGT} --separation 1um"));
    let whole_weight = format!("{PERSSON} --gamma 1");
    // With a plateau from wavenumber 1 to 4: longest, roll-off, cut-off wavelength.
    let plateau = "persson --hurst 0.8 --longest 6.283185307179586m --rolloff 1.5707963267948966m \
                   --cutoff 0.02454369260617026m --m0 1m^2 --modulus 1Pa --gamma 1 \
                   --pressure 0.1265758890927133379836Pa";
    let stacked = "stacked --max-amplitude-ratio 0.01 --modulus 1GPa --pressure 1MPa";
    let archard =
        "archard --sphere-radius 1mm --sphere-density 1mm^-2 --modulus 100GPa --pressure 1MPa";
    let fractal = "majumdar-bhushan --dimension 1.2 --roughness 1e-9m --area 1m^2 --modulus 1Pa \
                   --critical-area 1e-14m^2 --pressure 0.000001640898872640677148778Pa";
    for (line, key, expected, tolerance) in [
        (&*gw, "mean_pressure", 8.069_089_607_325_188e-6, 1e-14),
        (&gw, "area_fraction", 6.655_147_577_828_109e-4, 1e-14),
        (&loaded_gw, "separation", 3e-6, 1e-14),
        (&bgt, "mean_pressure", 0.043_102_358_985_660_981, 1e-12),
        (&elliptical, "area_fraction", 0.056_979_231_437_398_718, 1e-12),
        (PERSSON, "area_fraction", 0.015_956_627_433_803_93, 1e-13),
        (PERSSON, "mean_gap", 1.585_714_286_02, 1e-10),
        (&whole_weight, "mean_gap", 2.111_701_497_55, 1e-10),
        (plateau, "mean_gap", 2.086_273_388_100_949, 1e-10),
        (stacked, "real_pressure", SQRT_2 * PI * 1e7, 1e-14),
        (archard, "area_fraction", spheres, 1e-13),
        (fractal, "area_fraction", 1e-5, 1e-13),
    ] {
        close(number(&points(line)[0][key]), expected, tolerance);
    }
}

#[test]
fn what_a_model_says_beside_its_numbers() {
    // γ stands beside the mean gap; of moments alone there is none.
    let at = &folder();
    has(&at.run(&format!("model {PERSSON}")).out, &["γ = 0.4500 (Yang & Persson 2008)"]);
    let shown = at.answer(&format!("model {PERSSON} --gamma 1"));
    close(number(&shown["inputs"]["gamma"]), 1.0, 1e-15);
    assert!(points("persson --m2 0.02 --modulus 1GPa --pressure 1MPa")[0]["mean_gap"].is_null());
    let full = &points("stacked --max-amplitude-ratio 0.01 --modulus 1GPa --pressure 1TPa")[0];
    assert_eq!(full["caveat"]["kind"], "saturated");
    close(number(&full["area_fraction"]), 1.0, 1e-15);
    // A stack on a record four times as long; both models see the same amplitudes.
    let area = |line: &str| {
        let points = points(&format!("{line} {SPECTRUM} --modulus 100GPa --pressure 1MPa"));
        number(&points[0]["area_fraction"])
    };
    assert!(area("multiscale") > 0.0);
    close(area("stacked --record-length 400um"), 2.0 * area("stacked"), 1e-3);
    // A separation inside the surface has no answer.
    let said = at.run(&format!("model {GW} --separation=-300um --json"));
    assert_eq!(said.json()["points"][0]["error"]["quantity"], "area fraction");
    // A refusal of each load, with the domain.
    let said = at.run(
        "model majumdar-bhushan --dimension 1.62 --roughness 1nm --area 1mm^2 --modulus 1GPa \
         --pressure 1MPa,2MPa --json",
    );
    assert_eq!(said.status, 2);
    for point in list(&said.json()["points"]) {
        let error = &point["error"];
        assert_eq!(error["quantity"], "D");
        close(number(&error["value"]), 1.62, 1e-15);
        close(number(&error["domain"][1]), 1.5, 1e-15);
        assert!(point["area_fraction"].is_null());
    }
}

/// Without a map it is said what the model did on Gaussian surfaces like it: p = 0.028 E* h'rms, bandwidth 5.
#[test]
fn typed_numbers_tell_the_error_on_other_surfaces() {
    let line = format!("gw {BGT} --pressure 0.04Pa,1e-9Pa");
    let ps = points(&line);
    let [low, high] = ends(&ps[0]["survey"]["area_error"]);
    assert!(-0.45 < low && low < high && high < -0.05, "{low} {high}");
    assert!(ps[0]["survey"]["surfaces"].as_u64().unwrap() >= 20);
    assert!(ps[1]["survey"].is_null()); // no such load was solved
    let said = folder().run(&format!("model {line}")).out;
    has(&said, &["error: of the area, on isotropic Gaussian surfaces"]);
}

#[test]
fn a_surface_file_gives_what_a_model_needs() {
    let at = &folder();
    at.synth("a.x3p", &format!("{ROUGH} --rms-height 0.3um --seed 5"));
    let stats = at.answer("stats a.x3p");
    let [m0, m2, m4] = ["m0", "m2", "m4"].map(|key| number(&stats[key]));
    let load = "--modulus 110GPa --pressure 50MPa";
    for name in ["gw", "bgt", "greenwood-elliptical"] {
        let typed = format!("--m0 {m0}m^2 --m2 {m2} --m4 {m4}m^-2");
        let [of_file, typed] = ["a.x3p", &typed].map(|from| {
            let answer = at.answer(&format!("model {name} {from} {load}"));
            number(&answer["points"][0]["area_fraction"])
        });
        close(of_file, typed, 1e-12);
    }
    for name in ["persson", "stacked", "multiscale", "majumdar-bhushan"] {
        let said = at.run(&format!("model {name} a.x3p {load} --json"));
        assert!(said.status == 0 || name == "majumdar-bhushan", "{name}: {}", said.err);
    }
    let persson = at.answer(&format!("model persson a.x3p --boundary periodic {load}"));
    assert!(number(&persson["points"][0]["mean_gap"]) > 0.0);
}

#[test]
fn the_list_is_complete_and_refusals_name_the_way_out() {
    let at = &folder();
    let object = at.answer("model --list");
    let listed: Vec<&str> =
        list(&object["models"]).iter().filter_map(|m| m["name"].as_str()).collect();
    let names = "gw bgt greenwood-elliptical persson stacked multiscale archard majumdar-bhushan";
    for name in names.split_whitespace() {
        assert!(listed.contains(&name), "{name}");
        at.refuses(&format!("model {name} --modulus 1GPa --pressure 1MPa"), &["needs", "--"]);
    }
    for model in list(&object["models"]) {
        for key in ["title", "inputs", "domain"] {
            assert!(!model[key].as_str().unwrap().is_empty());
        }
    }
    has(&at.run("model --list").out, &["10.1098/rspa.1966.0242"]);
    at.refuses_each(
        "model --modulus 1GPa",
        &[
            ("nonsense --pressure 1MPa", &["nonsense", "persson"]),
            ("gw --m0 1um^2 --pressure 1MPa", &["--m2", "--m4"]),
            ("gw --m0 1 --pressure 1MPa", &["1um^2"]),
            ("persson --m2 0.1m --pressure 1MPa", &["pure number"]),
            ("persson --m2 0.1", &["--pressure"]),
            ("persson --m2 0.1 --separation 1um", &["gw"]),
            ("gw --hurst 1 --dimension 1.4 --pressure 1Pa", &["--dimension"]),
        ],
    );
}
