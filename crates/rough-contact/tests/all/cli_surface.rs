//! info, stats, synth, solve and validate as a script sees them.

use crate::cli::{TestFolder, UNITS, close, ends, folder, has, list, number};
use serde_json::{Value, json};

const SYNTH: &str = "synth --shape 48,64 --pixel 1um,2um --hurst 0.7 --rolloff 48um --cutoff 8um \
                     --rms-height 0.5um --seed 3 --out";
const SOLVE: &str = "solve a.npy --pixel 1um,2um --height-unit m";

/// A folder with the map `a.npy`.
fn map() -> TestFolder {
    let at = folder();
    at.done(&format!("{SYNTH} a.npy"));
    at
}

/// Every object has exactly the keys the contract promises, or more.
fn has_keys(object: &Value, keys: &str) {
    for key in keys.split_whitespace() {
        assert!(object.get(key).is_some(), "{key} is missing in {object}");
    }
}

#[test]
fn info_says_what_the_file_holds() {
    let at = &folder();
    at.file("hole.txt", "1 2 4 3\n5 nan 7 8\n9 10 11 12.5\n");
    let info = at.answer("info hole.txt --pixel 2um,3um --height-unit nm");
    has_keys(
        &info,
        "format shape pixel missing height_min height_max height_mean channels metadata",
    );
    assert_eq!(info["shape"], json!([3, 4]));
    assert_eq!(info["pixel"], json!([3e-6, 2e-6])); // [dy, dx]
    assert_eq!(info["missing"], 1);
    assert!((number(&info["height_min"]) - 1e-9).abs() < 1e-24);
    assert!((number(&info["height_max"]) - 12.5e-9).abs() < 1e-23);
    let mean = (1.0 + 2.0 + 3.0 + 4.0 + 5.0 + 7.0 + 8.0 + 9.0 + 10.0 + 11.0 + 12.5) / 11.0 * 1e-9;
    close(number(&info["height_mean"]), mean, 1e-12);

    let line = "info hole.txt --pixel 1um --height-unit nm --crop";
    let cropped = at.answer(&format!("{line} 2,1,1,3"));
    assert_eq!((&cropped["shape"], &cropped["missing"]), (&json!([1, 3]), &json!(0)));
    // Without 6, the missing one, the largest part of 3 x 4 points are the two columns right of it.
    let largest = at.done(&format!("{line} complete --json"));
    has(&largest.err, &["--crop complete is --crop 0,2,3,2"]);
    let largest = largest.json();
    assert_eq!((&largest["shape"], &largest["missing"]), (&json!([3, 2]), &json!(0)));
    assert_eq!(largest["metadata"]["crop"], "0,2,3,2");
    assert!(list(&at.answer("info --list")["formats"]).len() >= 3);
}

/// A ramp of 41 heights from 0 to 4 um: under which key and in which unit each stands.
#[test]
fn areal_parameters_have_the_symbols_of_the_standard() {
    let at = &folder();
    at.matrix("ramp.txt", 40, 41, |_, ix| 0.1 * ix as f64);
    let line = format!("stats ramp.txt {UNITS} --level mean");
    assert!(at.answer(&line).get("iso25178").is_none());
    let iso = at.answer(&format!("{line} --iso"))["iso25178"].clone();
    // By hand on the staircase. The curve joins steps by straight lines, which moves volumes by 1 %.
    for (key, expected, tolerance) in [
        ("Sp", 2e-6, 1e-9),
        ("Sv", 2e-6, 1e-9),
        ("Sz", 4e-6, 1e-9),
        ("Sdq", 0.1, 1e-9),
        ("Sdr", 1.01f64.sqrt() - 1.0, 1e-9),
        ("Sk", 4.1e-6, 0.05), // of the straight line from 4.05 to -0.05 um
        ("Sxp", 1.9e-6, 1e-6),
        ("Vmp", (0.4 + 0.3 + 0.2 + 0.1) / 41.0 * 1e-6, 0.01),
    ] {
        close(number(&iso[key]), expected, tolerance);
    }
    let text = at.run(&format!("{line} --iso")).out;
    has(&text, &["\nSpk ", "\nVmp ", "nm (m³ per m²)"]);
}

/// z = cos(2 pi 3 x / L) um over 60 columns, each number of which is that of the formula in `surface-stats`.
#[test]
fn statistics_have_all_their_keys() {
    let at = &folder();
    let q = std::f64::consts::TAU * 3.0 / 60.0; // per column
    at.matrix("wave.txt", 8, 60, |_, ix| (q * ix as f64).cos());
    let line = format!("stats wave.txt --level mean {UNITS} --boundary periodic --iso");
    let stats = at.answer(&line);
    has_keys(
        &stats,
        "shape pixel level boundary missing rms_height mean_abs_height skewness kurtosis \
         rms_gradient m0 m2 m4 m2_x m2_y m4_x m4_y m0_spectral m2_spectral m4_spectral bandwidth \
         asperities summits hurst dimension roughness rolloff cutoff max_amplitude_ratio warnings",
    );
    has_keys(&stats["summits"], "count density height_mean height_std curvature_mean");
    let (m0, slope) = (0.5e-12_f64, 2.0 * (0.5 * q).sin() / 1e-6);
    for (key, expected) in [
        ("m0", m0),
        ("m2_x", m0 * slope.powi(2)),
        ("m4_x", m0 * slope.powi(4)),
        ("m2_spectral", 0.5 * m0 * (q / 1e-6).powi(2)),
        ("max_amplitude_ratio", 1e-6 / 20e-6),
    ] {
        close(number(&stats[key]), expected, 1e-12);
    }
    assert!(number(&stats["m2_y"]).abs() < 1e-28);
    assert_eq!(stats["iso25178"]["Sdq"], stats["rms_gradient"]);
}

#[test]
fn a_flat_surface_is_answered() {
    let at = &folder();
    at.matrix("flat.txt", 6, 7, |_, _| 2.5);
    let stats = at.answer(&format!("stats flat.txt {UNITS}"));
    assert!(number(&stats["rms_height"]).abs() < 1e-30);
    assert!(stats["bandwidth"].is_null() && stats["skewness"].is_null());
    let solve = at.answer(&format!("solve flat.txt {UNITS} --modulus 1GPa --pressure 3MPa"));
    let point = &solve["points"][0];
    assert!((number(&point["area_fraction"]) - 1.0).abs() < 1e-15);
    close(number(&point["real_pressure"]), 3e6, 1e-12);
    assert!(number(&point["mean_gap"]).abs() < 1e-20);
}

#[test]
fn synth_is_the_same_for_the_same_seed_and_obeys_its_recipe() {
    let at = &map();
    for name in ["b.npy", "c.x3p"] {
        at.answer(&format!("{SYNTH} {name}"));
    }
    let (header, a) = at.npy("a.npy");
    has(&header, &["(48, 64)"]);
    assert_eq!(a, at.npy("b.npy").1);
    let rms = (a.iter().map(|h| h * h).sum::<f64>() / a.len() as f64).sqrt();
    close(rms, 0.5e-6, 1e-12);
    // X3P says its pixel and unit, so nothing needs to be given.
    let info = at.answer("info c.x3p");
    assert_eq!(info["shape"], json!([48, 64]));
    close(number(&info["pixel"][0]), 2e-6, 1e-12);
    close(number(&info["pixel"][1]), 1e-6, 1e-12);
}

#[test]
fn solve_answers_in_the_order_asked_and_carries_the_load() {
    let at = &map();
    let loads = "--pressure 200MPa,20MPa,60MPa --tolerance 1e-8 --maps maps";
    let solve = at.answer(&format!("{SOLVE} --modulus 70GPa {loads}"));
    has_keys(&solve, "shape pixel boundary method precision modulus points");
    let mut areas = Vec::new();
    for (i, (point, asked)) in list(&solve["points"]).iter().zip([200e6, 20e6, 60e6]).enumerate() {
        has_keys(
            point,
            "mean_pressure touching_fraction area_fraction mean_gap approach max_pressure \
             real_pressure converged iterations transforms seconds residuals duality_gap",
        );
        has_keys(&point["residuals"], "preconditioned complementarity penetration");
        assert_eq!(point["converged"], true);
        close(number(&point["mean_pressure"]), asked, 1e-12);
        let area = number(&point["area_fraction"]);
        close(number(&point["real_pressure"]) * area, asked, 1e-12);
        areas.push(area);

        let (header, pressure) = at.npy(&format!("maps/pressure-{i:03}.npy"));
        has(&header, &["(48, 64)", "<f8"]);
        let count = pressure.len() as f64;
        close(pressure.iter().sum::<f64>() / count, asked, 1e-12);
        let touching = pressure.iter().filter(|&&p| p > 0.0).count() as f64 / count;
        assert!((touching - number(&point["touching_fraction"])).abs() < 1e-15);
        let highest = pressure.iter().copied().fold(0.0, f64::max);
        close(highest, number(&point["max_pressure"]), 1e-12);

        let (_, gap) = at.npy(&format!("maps/gap-{i:03}.npy"));
        let mean = gap.iter().sum::<f64>() / count;
        close(mean, number(&point["mean_gap"]), 1e-9);
        let weighted: f64 = gap.iter().zip(&pressure).map(|(g, p)| g * p).sum();
        assert!(weighted.abs() < 1e-12 * highest * mean * count);
    }
    assert!(areas[1] < areas[2] && areas[2] < areas[0], "{areas:?}");
    let by = at.answer(&format!("{SOLVE} --modulus 70GPa --pressure 50MPa --method polonsky-keer"));
    assert_eq!(by["method"], "polonsky-keer");
}

/// What is not known is null. That the others hold is tested in the crates of solver and accuracy.
#[test]
fn solve_states_how_wrong_it_may_be() {
    let at = &map();
    let solve = |more: &str| {
        at.answer(&format!("{SOLVE} --modulus 70GPa --pressure 200MPa {more}"))["points"][0].clone()
    };
    let [certified, free] = ["--certify --level none", "--boundary free"].map(solve);
    assert!(number(&certified["energy_bound"]) < 1e-3, "{certified}");
    for point in [&certified, &free] {
        let [low, high] = ends(&point["area_interval"]);
        let area = number(&point["area_fraction"]);
        assert!(low < area && area < high && point["area_interval_reason"].is_null(), "{point}");
    }
    assert!(free["energy_bound"].is_null());
    // An isolated contact is no sample of a surface that goes on.
    assert!(free["area_prediction_interval"].is_null());
}

#[test]
fn one_refused_load_does_not_lose_the_others() {
    let said =
        map().run(&format!("{SOLVE} --modulus 1GPa --pressure 1e-310Pa,1MPa --json --quiet"));
    assert_eq!(said.status, 2);
    let object = said.json();
    let points = list(&object["points"]);
    assert_eq!(points[0]["converged"], false);
    assert!(points[0]["area_fraction"].is_null() && !points[0]["error"]["message"].is_null());
    assert_eq!(points[1]["converged"], true);
    assert!(number(&points[1]["area_fraction"]) > 0.0 && points[1]["error"].is_null());
    assert_eq!(said.err.lines().count(), 1, "{}", said.err);
}

/// At what order the errors fall is tested in `fft-bem-solver`.
#[test]
fn every_case_is_compared() {
    let at = &folder();
    let object = at.answer("validate --quiet --finest 64");
    for case in ["Hertz", "Westergaard", "bi-sinusoid", "full contact"] {
        let named = |row: &&Value| {
            row["case"].to_string().contains(case) || row["source"].to_string().contains(case)
        };
        let finest = list(&object["rows"]).iter().rfind(named);
        let finest = finest.unwrap_or_else(|| panic!("no {case}"));
        assert!(number(&finest["error"]).abs() < 0.01, "{finest}");
    }
    at.refuses("validate --finest 4", &["4", "32"]);
}
