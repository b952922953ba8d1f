//! Every model by name, with numbers typed in, against high-precision values.

use crate::cli::{close, ends, folder, has, list, number};
use serde_json::Value;
use std::f64::consts::{PI, SQRT_2};

/// The points of `model LINE --json`.
fn points(line: &str) -> Vec<Value> {
    let object = folder().answer(&format!("model {line}"));
    assert!(object["citation"]["year"].as_u64().unwrap_or(0) > 1900);
    list(&object["points"]).to_vec()
}

/// Asserts that the first point of `model LINE` has these numbers, each to its tolerance.
#[track_caller]
fn gives(line: &str, numbers: &[(&str, f64, f64)]) {
    let point = &points(line)[0];
    for (key, expected, tolerance) in numbers {
        close(number(&point[*key]), *expected, *tolerance);
    }
}

const GW: &str = "gw --asperity-density 49867200m^-2 --asperity-radius 0.5mm \
                  --asperity-height-std 0.634125750251345949577869um \
                  --mean-offset 1.84265708194896327817124um --modulus 1Pa";
const BGT: &str = "--m0 1um^2 --m2 0.01 --m4 5e8m^-2 --modulus 10Pa"; // bandwidth 5
const SPECTRUM: &str = "--hurst 0.8 --rolloff 100um --cutoff 2um --m0 0.2um^2";

/// 20-digit values computed with mpmath: density x radius x rms height = 0.0249336,
/// rms height / radius = 2e-3, h = 3 rms heights.
#[test]
fn greenwood_williamson() {
    gives(
        &format!("{GW} --separation 3um"),
        &[
            ("mean_pressure", 8.069_089_607_325_188e-6, 1e-14),
            ("area_fraction", 6.655_147_577_828_109e-4, 1e-14),
            ("separation", 3e-6, 1e-15),
        ],
    );
    let back = &points(&format!("{GW} --pressure 8.06908960732518799e-6Pa"))[0];
    close(number(&back["separation"]), 3e-6, 1e-14);
    assert!(back["error"].is_null() && back["caveat"].is_null());
}

/// 34-digit quadrature in mpmath, at h = 1 rms height; E* sqrt(m2) = 1 Pa.
#[test]
fn bush_gibson_thomas_and_the_elliptical_model() {
    for (name, area, pressure) in [
        ("bgt", 0.056_040_730_770_166_378, 0.043_102_358_985_660_981),
        ("greenwood-elliptical", 0.056_979_231_437_398_718, 0.042_157_147_477_080_721),
    ] {
        let line = format!("{name} {BGT}");
        gives(
            &format!("{line} --separation 1um"),
            &[("area_fraction", area, 1e-12), ("mean_pressure", pressure, 1e-12)],
        );
        gives(&format!("{line} --pressure {pressure}Pa"), &[("separation", 1e-6, 1e-12)]);
    }
}

/// mpmath: H = 0.8, wavenumbers 1 to 100, m0 = 1, at p = 0.01 E* g_rms.
#[test]
fn persson_with_its_mean_gap() {
    let line = "persson --hurst 0.8 --rolloff 6.283185307179586m --cutoff 0.06283185307179586m \
                --m0 1m^2 --modulus 1GPa --pressure 46.09956908378556555884MPa";
    gives(
        &format!("{line} --gamma 1"),
        &[
            ("area_fraction", 0.015_956_627_433_803_93, 1e-13),
            ("mean_gap", 2.111_701_497_55, 1e-10),
        ],
    );
    for gamma in ["", " --gamma 0.45"] {
        gives(&format!("{line}{gamma}"), &[("mean_gap", 1.585_714_286_02, 1e-10)]);
    }
    // γ stands beside the number.
    let at = &folder();
    has(&at.run(&format!("model {line}")).out, &["γ = 0.4500 (Yang & Persson 2008)"]);
    let shown = at.answer(&format!("model {line} --gamma 1"));
    close(number(&shown["inputs"]["gamma"]), 1.0, 1e-15);
    // With a plateau from wavenumber 1 to 4: longest, roll-off, cut-off wavelength.
    let plateau = "persson --hurst 0.8 --longest 6.283185307179586m \
                   --rolloff 1.5707963267948966m --cutoff 0.02454369260617026m --m0 1m^2 \
                   --modulus 1Pa --pressure 0.1265758890927133379836Pa --gamma 1";
    gives(plateau, &[("mean_gap", 2.086_273_388_100_949, 1e-10)]);
    // Moments alone: the area, and no mean gap.
    let moments = &points("persson --m2 0.02 --modulus 1GPa --pressure 1MPa")[0];
    assert!(moments["mean_gap"].is_null());
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
fn stacked_multiscale_and_archard() {
    let ps = points("stacked --max-amplitude-ratio 0.01 --modulus 1GPa --pressure 1MPa,1TPa");
    close(number(&ps[0]["real_pressure"]), SQRT_2 * PI * 1e7, 1e-14);
    assert_eq!(ps[1]["caveat"]["kind"], "saturated");
    close(number(&ps[1]["area_fraction"]), 1.0, 1e-15);

    // One level of spheres is Hertz contact, each carrying p / density.
    let area = 1e6 * PI * (0.75f64 * 1e-3 * (1e6 / 1e6) / 100e9).powf(2.0 / 3.0);
    gives(
        "archard --sphere-radius 1mm --sphere-density 1mm^-2 --modulus 100GPa --pressure 1MPa",
        &[("area_fraction", area, 1e-13)],
    );

    // A stack on a long record; both models see the same amplitudes.
    let area = |line: &str| {
        let points = points(&format!("{line} {SPECTRUM} --modulus 100GPa --pressure 1MPa"));
        number(&points[0]["area_fraction"])
    };
    assert!(area("multiscale") > 0.0 && area("stacked") > 0.0);
    close(area("stacked --record-length 400um"), 2.0 * area("stacked"), 1e-3);
}

/// mpmath: closed forms with and without critical area.
#[test]
fn majumdar_bhushan() {
    gives(
        "majumdar-bhushan --dimension 1.05 --roughness 1e-5m --area 1m^2 --modulus 1Pa \
         --pressure 0.4347850819981157989862Pa",
        &[("area_fraction", 0.3, 1e-13)],
    );
    gives(
        "majumdar-bhushan --dimension 1.2 --roughness 1e-9m --area 1m^2 \
         --critical-area 1e-14m^2 --modulus 1Pa --pressure 0.000001640898872640677148778Pa",
        &[("area_fraction", 1e-5, 1e-13)],
    );
    let said = folder().run(
        "model majumdar-bhushan --dimension 1.62 --roughness 1nm --area 1mm^2 --modulus 1GPa \
         --pressure 1MPa,2MPa --json",
    );
    assert_eq!(said.status, 2);
    let object = said.json();
    for point in list(&object["points"]) {
        let error = &point["error"];
        assert_eq!(error["quantity"], "D");
        close(number(&error["value"]), 1.62, 1e-15);
        close(number(&error["domain"][1]), 1.5, 1e-15);
        assert!(point["area_fraction"].is_null());
    }
    assert!(!object["error"]["message"].as_str().unwrap().is_empty());
}

/// Loads over 600 decades: an answer or a typed error for each, never NaN or infinity (which JSON
/// cannot hold), and area that never falls as load grows.
#[test]
fn extremes_are_answered_or_refused_one_by_one() {
    let at = &folder();
    for line in [
        GW,
        &format!("bgt {BGT}"),
        &format!("greenwood-elliptical {BGT}"),
        "persson --m2 0.02 --modulus 1GPa",
        "persson --hurst 0.5 --rolloff 1mm --cutoff 1um --m0 1um^2 --modulus 1GPa",
        "stacked --max-amplitude-ratio 0.01 --modulus 1GPa",
        &format!("multiscale {SPECTRUM} --modulus 1GPa"),
        "archard --sphere-radius 1mm,1um --sphere-density 1mm^-2,1um^-2 --modulus 1GPa",
        "majumdar-bhushan --dimension 1.3 --roughness 1nm --area 1mm^2 --modulus 1GPa",
    ] {
        let said = at.run(&format!("model {line} --pressure 1e-300Pa..1e300Pa:61 --json"));
        assert!(said.status == 0 || said.status == 2, "{line}: {}", said.err);
        let object = said.json();
        let points = list(&object["points"]);
        assert_eq!(points.len(), 61);
        let mut last = 0.0;
        for point in points {
            assert!(point["error"].is_null() != point["area_fraction"].is_null(), "{point}");
            if point["error"].is_null() {
                let area = number(&point["area_fraction"]);
                assert!(area >= last * (1.0 - 1e-12), "{line}: {point}");
                last = area;
            } else {
                assert!(!point["error"]["message"].as_str().unwrap().is_empty());
            }
        }
    }
}

#[test]
fn a_surface_file_gives_what_a_model_needs() {
    let at = &folder();
    at.synth("a.x3p", "--shape 64,64 --rolloff 32um --cutoff 8um --rms-height 0.3um --seed 5");
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
