//! Maps and contacts go out in files that other programs open, and come back as they were.

use crate::cli;

use cli::{folder, number, refused, rough_contact};
use serde_json::Value;
use std::path::Path;
use surface_io::ReadOptions;

fn map(at: &Path) {
    let synth = "synth --shape 40,56 --pixel 1um,1.25um --hurst 0.8 --rolloff 24um --cutoff 6um \
                 --rms-height 0.3um --seed 7 --out map.sdf";
    assert_eq!(rough_contact(at, synth).status, 0);
}

/// The numbers of a file of ours.
fn numbers(path: &Path) -> Vec<f64> {
    let bytes = std::fs::read(path).unwrap();
    let data = bytes.iter().position(|b| *b == b'\n').unwrap() + 1;
    bytes[data..].chunks_exact(8).map(|b| f64::from_le_bytes(b.try_into().unwrap())).collect()
}

#[test]
fn heights_come_back_from_every_format() {
    let dir = folder();
    let at = dir.path();
    map(at);
    let stats =
        |file: &str| rough_contact(at, &format!("stats {file} --level none --json")).answered();
    let before = stats("map.sdf");
    for (name, more) in [
        ("a.x3p", ""),
        ("a.sdf", ""),
        ("a.txt", ""),
        ("a.h5", ""),
        ("a.npy", "--pixel 1um,1.25um --height-unit m"),
    ] {
        let said = rough_contact(at, &format!("convert map.sdf --out {name} --json")).answered();
        assert_eq!(said["shape"], before["shape"]);
        let after = stats(&format!("{name} {more}"));
        for key in ["rms_height", "skewness", "m2_x", "m2_y", "m4"] {
            let (a, b) = (number(&after[key]), number(&before[key]));
            assert!((a / b - 1.0).abs() < 1e-12, "{name}: {key} {a} {b}");
        }
    }
    // Levelled and cleaned as `stats` does it.
    let said =
        rough_contact(at, "convert map.sdf --form quadratic --level plane --out b.x3p --json");
    assert_eq!(said.answered()["cleaning"].as_array().unwrap().len(), 1);
    let levelled = rough_contact(at, "stats map.sdf --form quadratic --json").answered();
    let again = stats("b.x3p");
    assert!((number(&again["rms_height"]) / number(&levelled["rms_height"]) - 1.0).abs() < 1e-12);
    refused(at, "convert map.sdf --out b.x3p", 2, &["b.x3p", "--force"]);
    refused(at, "convert map.sdf --out b.png", 2, &["png", ".x3p", ".vti"]);
}

#[test]
fn a_contact_is_written_whole() {
    let dir = folder();
    let at = dir.path();
    map(at);
    let solve = "solve map.sdf --modulus 110GPa --pressure 300MPa --maps out --json \
                 --fields pressure,gap,displacement,heights,spots --distributions";
    let said = rough_contact(at, solve).answered();
    let point = &said["points"][0];
    let field = |name: &str| numbers(&at.join(format!("out/{name}-000.npy")));
    let [pressure, gap, displacement, heights] =
        ["pressure", "gap", "displacement", "heights"].map(field);
    let count = pressure.len() as f64;
    assert_eq!(pressure.len(), 40 * 56);

    // The body goes down on average by nothing, and where it touches it lies on the flat.
    let size = displacement.iter().fold(0.0, |m: f64, u| m.max(u.abs()));
    assert!((displacement.iter().sum::<f64>() / count).abs() < 1e-4 * size);
    let flat: Vec<f64> =
        heights.iter().zip(&displacement).zip(&gap).map(|((z, u), g)| z - u + g).collect();
    let (low, high) = flat.iter().fold((f64::MAX, f64::MIN), |(l, h), v| (l.min(*v), h.max(*v)));
    assert!(high - low < 1e-12 * size.max(1e-6));
    // The displacement is that of the pressure: the wave of one period along x by 2/(E* q).
    let wave = |field: &[f64]| {
        let part = |i: usize| (i % 56) as f64 / 56.0 * std::f64::consts::TAU;
        field.iter().enumerate().map(|(i, v)| v * part(i).cos()).sum::<f64>()
    };
    let q = std::f64::consts::TAU / 56e-6;
    let expected = 2.0 / (110e9 * q) * wave(&pressure);
    assert!(
        (wave(&displacement) / expected - 1.0).abs() < 2e-3,
        "{} {expected}",
        wave(&displacement)
    );

    // Spots carry the load and have the area.
    let table = std::fs::read_to_string(at.join("out/spots-000.csv")).unwrap();
    let rows: Vec<Vec<f64>> = table
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect())
        .collect();
    let sum = |k: usize| rows.iter().map(|row| row[k]).sum::<f64>();
    let area = 40.0 * 56.0 * 1.25e-12;
    assert!((sum(0) / area - number(&point["touching_fraction"])).abs() < 1e-9);
    assert!((sum(1) / area / number(&point["mean_pressure"]) - 1.0).abs() < 1e-9);
    assert!(
        rows.iter()
            .all(|r| r[2] < 56e-6 && r[3] < 50e-6 && (r[1] / r[0] / r[4] - 1.0).abs() < 1e-9)
    );

    // Distributions: the weight at zero is what does not touch.
    let found = &point["distributions"];
    let p = &found["pressure"];
    let list =
        |value: &Value| -> Vec<f64> { value.as_array().unwrap().iter().map(number).collect() };
    let (edges, density) = (list(&p["edges"]), list(&p["density"]));
    let integral: f64 = density.iter().map(|d| d * edges[1]).sum();
    assert!((integral - number(&point["touching_fraction"])).abs() < 1e-12);
    assert!((number(&p["apart"]) + integral - 1.0).abs() < 1e-12);
    assert_eq!(found["spots"]["count"], rows.len());
    let mean = pressure.iter().zip(&gap).filter(|(p, _)| **p <= 0.0).map(|(_, g)| g).sum::<f64>();
    let apart = number(&p["apart"]) * count;
    assert!((number(&found["gap"]["mean"]) / (mean / apart) - 1.0).abs() < 1e-9);

    // One file for all fields; only what was asked.
    let vti = "solve map.sdf --modulus 110GPa --pressure 300MPa --maps vtk --map-format vti";
    assert_eq!(rough_contact(at, vti).status, 0);
    let names: Vec<_> =
        std::fs::read_dir(at.join("vtk")).unwrap().map(|e| e.unwrap().file_name()).collect();
    assert_eq!(names, ["contact-000.vti"]);
    let h5 = "solve map.sdf --modulus 110GPa --pressure 300MPa --maps h5 --map-format hdf5 --fields pressure,gap,heights";
    assert_eq!(rough_contact(at, h5).status, 0);
    let kept = surface_io::read(at.join("h5/contact-000.h5"), &ReadOptions::default()).unwrap();
    assert_eq!(kept.channel(), "heights", "the pressure is no height");
    assert_eq!(kept.grid().pixel().map(f64::to_bits), [1.25e-6f64, 1e-6].map(f64::to_bits));
    assert_eq!(kept.channels().len(), 3);
    let only = "solve map.sdf --modulus 110GPa --pressure 300MPa --maps only --fields spots";
    assert_eq!(rough_contact(at, only).status, 0);
    let names: Vec<_> =
        std::fs::read_dir(at.join("only")).unwrap().map(|e| e.unwrap().file_name()).collect();
    assert_eq!(names, ["spots-000.csv"]);
    assert_eq!(std::fs::read_to_string(at.join("only/spots-000.csv")).unwrap(), table);
    let broken = "solve none.sdf --modulus 110GPa --pressure 300MPa --maps left";
    refused(at, broken, 2, &["none.sdf"]);
    assert!(!at.join("left").exists(), "nothing was written, so there is no folder");
    let chosen =
        "solve map.sdf --modulus 110GPa --pressure 300MPa --accuracy 5% --maps x --fields heights";
    refused(at, chosen, 2, &["--accuracy", "--tolerance"]);
}

/// A slope over one point is the one the moments are made of.
#[test]
fn statistics_by_distance_begin_with_the_moments() {
    let dir = folder();
    let at = dir.path();
    map(at);
    let stats = rough_contact(at, "stats map.sdf --scales --json").answered();
    for (axis, pixel) in [("x", 1e-6), ("y", 1.25e-6)] {
        let first = &stats["scales"][axis][0];
        assert!((number(&first["distance"]) / pixel - 1.0).abs() < 1e-9);
        let m2 = number(&stats[format!("m2_{axis}")]);
        assert!((number(&first["slope"]).powi(2) / m2 - 1.0).abs() < 1e-9, "{axis}");
    }
    assert!(rough_contact(at, "stats map.sdf --json").answered().get("scales").is_none());
}
