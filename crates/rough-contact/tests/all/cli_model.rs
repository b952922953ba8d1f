//! Every model by name, with numbers typed in, against high-precision values.

use crate::cli;

use cli::{folder, number, refused, rough_contact};
use serde_json::Value;
use std::f64::consts::{PI, SQRT_2};

/// The points of `model LINE --json`.
fn points(line: &str) -> Vec<Value> {
    let dir = folder();
    let object = rough_contact(dir.path(), &format!("model {line} --json")).answered();
    assert!(object["citation"]["year"].as_u64().unwrap_or(0) > 1900);
    object["points"].as_array().cloned().unwrap_or_default()
}

fn close(value: &Value, expected: f64, tolerance: f64) {
    let found = number(value);
    assert!((found / expected - 1.0).abs() < tolerance, "{found} instead of {expected}");
}

const GW: &str = "gw --asperity-density 49867200m^-2 --asperity-radius 0.5mm \
                  --asperity-height-std 0.634125750251345949577869um \
                  --mean-offset 1.84265708194896327817124um --modulus 1Pa";
const BGT: &str = "--m0 1um^2 --m2 0.01 --m4 5e8m^-2 --modulus 10Pa"; // bandwidth 5

/// 20-digit values computed with mpmath: density x radius x rms height = 0.0249336,
/// rms height / radius = 2e-3, h = 3 rms heights.
#[test]
fn greenwood_williamson() {
    let point = &points(&format!("{GW} --separation 3um"))[0];
    close(&point["mean_pressure"], 8.069_089_607_325_188e-6, 1e-14);
    close(&point["area_fraction"], 6.655_147_577_828_109e-4, 1e-14);
    close(&point["separation"], 3e-6, 1e-15);
    let back = &points(&format!("{GW} --pressure 8.06908960732518799e-6Pa"))[0];
    close(&back["separation"], 3e-6, 1e-14);
    assert!(back["error"].is_null() && back["caveat"].is_null());
}

/// 34-digit quadrature in mpmath, at h = 1 rms height.
#[test]
fn bush_gibson_thomas_and_the_elliptical_model() {
    for (name, area, pressure) in [
        ("bgt", 0.056_040_730_770_166_378, 0.043_102_358_985_660_981),
        ("greenwood-elliptical", 0.056_979_231_437_398_718, 0.042_157_147_477_080_721),
    ] {
        let point = &points(&format!("{name} {BGT} --separation 1um"))[0];
        close(&point["area_fraction"], area, 1e-12);
        close(&point["mean_pressure"], pressure, 1e-12); // E* sqrt(m2) = 1 Pa
        let back = &points(&format!("{name} {BGT} --pressure {pressure}Pa"))[0];
        close(&back["separation"], 1e-6, 1e-12);
    }
}

/// mpmath: H = 0.8, wavenumbers 1 to 100, m0 = 1, at p = 0.01 E* g_rms.
#[test]
fn persson_with_its_mean_gap() {
    let line = "persson --hurst 0.8 --rolloff 6.283185307179586m --cutoff 0.06283185307179586m \
                --m0 1m^2 --modulus 1GPa --pressure 46.09956908378556555884MPa";
    let point = &points(&format!("{line} --gamma 1"))[0];
    close(&point["area_fraction"], 0.015_956_627_433_803_93, 1e-13);
    close(&point["mean_gap"], 2.111_701_497_55, 1e-10);
    for gamma in ["", " --gamma 0.45"] {
        let yang = &points(&format!("{line}{gamma}"))[0];
        close(&yang["mean_gap"], 1.585_714_286_02, 1e-10);
    }
    // γ stands beside the number.
    let dir = folder();
    let shown = rough_contact(dir.path(), &format!("model {line}"));
    assert!(shown.out.contains("γ = 0.4500 (Yang & Persson 2008)"), "{}", shown.out);
    let shown = rough_contact(dir.path(), &format!("model {line} --gamma 1 --json")).answered();
    close(&shown["inputs"]["gamma"], 1.0, 1e-15);
    // With a plateau from wavenumber 1 to 4: longest, roll-off, cut-off wavelength.
    let plateau = "persson --hurst 0.8 --longest 6.283185307179586m \
                   --rolloff 1.5707963267948966m --cutoff 0.02454369260617026m --m0 1m^2 \
                   --modulus 1Pa --pressure 0.1265758890927133379836Pa --gamma 1";
    close(&points(plateau)[0]["mean_gap"], 2.086_273_388_100_949, 1e-10);
    // Moments alone: the area, and no mean gap.
    let moments = &points("persson --m2 0.02 --modulus 1GPa --pressure 1MPa")[0];
    assert!(moments["mean_gap"].is_null());
}

/// Without a map it is said what the model did on Gaussian surfaces like it: p = 0.028 E* h'rms, bandwidth 5.
#[test]
fn typed_numbers_tell_the_error_on_other_surfaces() {
    let line = format!("gw {BGT} --pressure 0.04Pa,1e-9Pa");
    let ps = points(&line);
    let [low, high] = [0, 1].map(|k| number(&ps[0]["survey"]["area_error"][k]));
    assert!(-0.45 < low && low < high && high < -0.05, "{low} {high}");
    assert!(ps[0]["survey"]["surfaces"].as_u64().unwrap() >= 20);
    assert!(ps[1]["survey"].is_null()); // no such load was solved
    let dir = folder();
    let said = rough_contact(dir.path(), &format!("model {line}")).out;
    assert!(said.contains("error: of the area, on isotropic Gaussian surfaces"), "{said}");
}

#[test]
fn stacked_multiscale_and_archard() {
    let ps = points("stacked --max-amplitude-ratio 0.01 --modulus 1GPa --pressure 1MPa,1TPa");
    close(&ps[0]["real_pressure"], SQRT_2 * PI * 1e7, 1e-14);
    assert_eq!(ps[1]["caveat"]["kind"], "saturated");
    close(&ps[1]["area_fraction"], 1.0, 1e-15);

    // One level of spheres is Hertz contact, each carrying p / density.
    let archard = "archard --sphere-radius 1mm --sphere-density 1mm^-2 --modulus 100GPa";
    let point = &points(&format!("{archard} --pressure 1MPa"))[0];
    let force = 1e6 / 1e6;
    let area = PI * (0.75f64 * 1e-3 * force / 100e9).powf(2.0 / 3.0);
    close(&point["area_fraction"], 1e6 * area, 1e-13);

    // A stack on a long record; both models see the same amplitudes.
    let spectrum = "--hurst 0.8 --rolloff 100um --cutoff 2um --m0 0.2um^2 --modulus 100GPa";
    let areas = |name: &str| {
        number(&points(&format!("{name} {spectrum} --pressure 1MPa"))[0]["area_fraction"])
    };
    assert!(areas("multiscale") > 0.0 && areas("stacked") > 0.0);
    let longer = points(&format!("stacked {spectrum} --record-length 400um --pressure 1MPa"));
    close(&longer[0]["area_fraction"], 2.0 * areas("stacked"), 1e-3);
}

/// mpmath: closed forms with and without critical area.
#[test]
fn majumdar_bhushan() {
    let point = &points(
        "majumdar-bhushan --dimension 1.05 --roughness 1e-5m --area 1m^2 --modulus 1Pa \
         --pressure 0.4347850819981157989862Pa",
    )[0];
    close(&point["area_fraction"], 0.3, 1e-13);
    let point = &points(
        "majumdar-bhushan --dimension 1.2 --roughness 1e-9m --area 1m^2 \
         --critical-area 1e-14m^2 --modulus 1Pa --pressure 0.000001640898872640677148778Pa",
    )[0];
    close(&point["area_fraction"], 1e-5, 1e-13);

    let dir = folder();
    let line = "model majumdar-bhushan --dimension 1.62 --roughness 1nm --area 1mm^2 \
                --modulus 1GPa --pressure 1MPa,2MPa --json";
    let said = rough_contact(dir.path(), line);
    assert_eq!(said.status, 2);
    let object = said.json();
    for point in object["points"].as_array().unwrap() {
        let error = &point["error"];
        assert_eq!(error["quantity"], "D");
        close(&error["value"], 1.62, 1e-15);
        close(&error["domain"][1], 1.5, 1e-15);
        assert!(point["area_fraction"].is_null());
    }
    assert!(!object["error"]["message"].as_str().unwrap().is_empty());
}

/// Loads over 600 decades: an answer or a typed error for each, never NaN or infinity (which JSON
/// cannot hold), and area that never falls as load grows.
#[test]
fn extremes_are_answered_or_refused_one_by_one() {
    let dir = folder();
    for line in [
        GW.to_owned(),
        format!("bgt {BGT}"),
        format!("greenwood-elliptical {BGT}"),
        "persson --m2 0.02 --modulus 1GPa".to_owned(),
        "persson --hurst 0.5 --rolloff 1mm --cutoff 1um --m0 1um^2 --modulus 1GPa".to_owned(),
        "stacked --max-amplitude-ratio 0.01 --modulus 1GPa".to_owned(),
        "multiscale --hurst 0.8 --rolloff 100um --cutoff 2um --m0 0.2um^2 --modulus 1GPa"
            .to_owned(),
        "archard --sphere-radius 1mm,1um --sphere-density 1mm^-2,1um^-2 --modulus 1GPa".to_owned(),
        "majumdar-bhushan --dimension 1.3 --roughness 1nm --area 1mm^2 --modulus 1GPa".to_owned(),
    ] {
        let said = rough_contact(
            dir.path(),
            &format!("model {line} --pressure 1e-300Pa..1e300Pa:61 --json"),
        );
        assert!(said.status == 0 || said.status == 2, "{line}: {}", said.err);
        let object = said.json();
        let points = object["points"].as_array().unwrap();
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
    let dir = folder();
    let at = dir.path();
    let synth = "synth --shape 64,64 --pixel 1um --hurst 0.8 --rolloff 32um --cutoff 8um \
                 --rms-height 0.3um --seed 5 --out a.x3p";
    assert_eq!(rough_contact(at, synth).status, 0);
    let stats = rough_contact(at, "stats a.x3p --json").answered();
    for name in ["gw", "bgt", "greenwood-elliptical"] {
        let of_file = format!("model {name} a.x3p --modulus 110GPa --pressure 50MPa --json");
        let of_file = rough_contact(at, &of_file).answered();
        let typed = format!(
            "model {name} --m0 {}m^2 --m2 {} --m4 {}m^-2 --modulus 110GPa --pressure 50MPa --json",
            number(&stats["m0"]),
            number(&stats["m2"]),
            number(&stats["m4"])
        );
        let typed = rough_contact(at, &typed).answered();
        let area = number(&typed["points"][0]["area_fraction"]);
        close(&of_file["points"][0]["area_fraction"], area, 1e-12);
    }
    for name in ["persson", "stacked", "multiscale", "majumdar-bhushan"] {
        let line = format!("model {name} a.x3p --modulus 110GPa --pressure 50MPa --json");
        let said = rough_contact(at, &line);
        assert!(said.status == 0 || name == "majumdar-bhushan", "{name}: {}", said.err);
    }
    let line = "model persson a.x3p --boundary periodic --modulus 110GPa --pressure 50MPa --json";
    let persson = rough_contact(at, line).answered();
    assert!(number(&persson["points"][0]["mean_gap"]) > 0.0);
}

#[test]
fn the_list_is_complete_and_refusals_name_the_way_out() {
    let dir = folder();
    let at = dir.path();
    let object = rough_contact(at, "model --list --json").answered();
    let listed: Vec<&str> =
        object["models"].as_array().unwrap().iter().filter_map(|m| m["name"].as_str()).collect();
    for name in [
        "gw",
        "bgt",
        "greenwood-elliptical",
        "persson",
        "stacked",
        "multiscale",
        "archard",
        "majumdar-bhushan",
    ] {
        assert!(listed.contains(&name), "{name}");
        let refusal = format!("model {name} --modulus 1GPa --pressure 1MPa");
        refused(at, &refusal, 2, &["needs", "--"]);
    }
    for model in object["models"].as_array().unwrap() {
        for key in ["title", "inputs", "domain"] {
            assert!(!model[key].as_str().unwrap().is_empty());
        }
    }
    let text = rough_contact(at, "model --list").out;
    assert!(text.contains("10.1098/rspa.1966.0242"));

    refused(at, "model nonsense --modulus 1GPa --pressure 1MPa", 2, &["nonsense", "persson"]);
    refused(at, "model gw --m0 1um^2 --modulus 1GPa --pressure 1MPa", 2, &["--m2", "--m4"]);
    refused(at, "model gw --m0 1 --modulus 1GPa --pressure 1MPa", 2, &["1um^2"]);
    refused(at, "model persson --m2 0.1m --modulus 1GPa --pressure 1MPa", 2, &["pure number"]);
    refused(at, "model persson --m2 0.1 --modulus 1GPa", 2, &["--pressure"]);
    refused(at, "model persson --m2 0.1 --modulus 1GPa --separation 1um", 2, &["gw"]);
    refused(
        at,
        "model gw --hurst 1 --dimension 1.4 --modulus 1GPa --pressure 1Pa",
        2,
        &["--dimension"],
    );
}
