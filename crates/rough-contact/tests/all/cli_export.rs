//! Maps and contacts go out in files that other programs open, and come back as they were.

use crate::cli::{TestFolder, close, folder, list, number};
use surface_io::ReadOptions;

const SOLVE: &str = "solve map.sdf --modulus 110GPa --pressure 300MPa";

fn map() -> TestFolder {
    let at = folder();
    at.done(
        "synth --shape 40,56 --pixel 1um,1.25um --hurst 0.8 --rolloff 24um --cutoff 6um \
         --rms-height 0.3um --seed 7 --out map.sdf",
    );
    at
}

#[test]
fn heights_come_back_from_every_format() {
    let at = &map();
    let stats = |file: &str| at.answer(&format!("stats {file} --level none"));
    let before = stats("map.sdf");
    for (name, more) in [
        ("a.x3p", ""),
        ("a.sdf", ""),
        ("a.txt", ""),
        ("a.h5", ""),
        ("a.npy", "--pixel 1um,1.25um --height-unit m"),
    ] {
        let said = at.answer(&format!("convert map.sdf --out {name}"));
        assert_eq!(said["shape"], before["shape"]);
        let after = stats(&format!("{name} {more}"));
        for key in ["rms_height", "skewness", "m2_x", "m2_y", "m4"] {
            close(number(&after[key]), number(&before[key]), 1e-12);
        }
    }
    // Levelled and cleaned as `stats` does it.
    let said = at.answer("convert map.sdf --form quadratic --level plane --out b.x3p");
    assert_eq!(list(&said["cleaning"]).len(), 1);
    let levelled = at.answer("stats map.sdf --form quadratic");
    close(number(&stats("b.x3p")["rms_height"]), number(&levelled["rms_height"]), 1e-12);
    at.refuses("convert map.sdf --out b.x3p", &["b.x3p", "--force"]);
    at.refuses("convert map.sdf --out b.png", &["png", ".x3p", ".vti"]);
}

#[test]
fn a_contact_is_written_whole() {
    let at = &map();
    let fields = "--fields pressure,gap,displacement,heights,spots --distributions";
    let said = at.answer(&format!("{SOLVE} --maps out {fields}"));
    let point = &said["points"][0];
    let [pressure, gap, displacement, heights] = ["pressure", "gap", "displacement", "heights"]
        .map(|name| at.npy(&format!("out/{name}-000.npy")).1);
    let count = pressure.len() as f64;
    assert_eq!(pressure.len(), 40 * 56);

    // The body goes down on average by nothing, and where it touches it lies on the flat, to the tolerance.
    let size = displacement.iter().fold(0.0, |m: f64, u| m.max(u.abs()));
    assert!((displacement.iter().sum::<f64>() / count).abs() < 1e-4 * size);
    let flat: Vec<f64> =
        heights.iter().zip(&displacement).zip(&gap).map(|((z, u), g)| z - u + g).collect();
    let (low, high) = flat.iter().fold((f64::MAX, f64::MIN), |(l, h), v| (l.min(*v), h.max(*v)));
    assert!(high - low < 1e-3 * size, "{} of {size}", high - low);
    // The gap is nowhere below 0, also where the contact yields, and its mean is the mean gap.
    let yields = at.answer(&format!("{SOLVE} --hardness 2GPa --maps yields"));
    assert!(number(&yields["points"][0]["saturated_fraction"]) > 0.0);
    for (folder, answer) in [("out", &said), ("yields", &yields)] {
        let gap = at.npy(&format!("{folder}/gap-000.npy")).1;
        assert!(gap.iter().all(|g| *g >= 0.0));
        close(gap.iter().sum::<f64>() / count, number(&answer["points"][0]["mean_gap"]), 1e-5);
    }
    // The displacement is that of the pressure: the wave of one period along x by 2/(E* q).
    let wave = |field: &[f64]| {
        let part = |i: usize| (i % 56) as f64 / 56.0 * std::f64::consts::TAU;
        field.iter().enumerate().map(|(i, v)| v * part(i).cos()).sum::<f64>()
    };
    let q = std::f64::consts::TAU / 56e-6;
    close(wave(&displacement), 2.0 / (110e9 * q) * wave(&pressure), 2e-3);

    // Spots carry the load and have the area.
    let table = at.read("out/spots-000.csv");
    let row = |line: &str| -> Vec<f64> { line.split(',').map(|c| c.parse().unwrap()).collect() };
    let rows: Vec<Vec<f64>> = table.lines().skip(1).map(row).collect();
    let sum = |k: usize| rows.iter().map(|row| row[k]).sum::<f64>();
    let area = 40.0 * 56.0 * 1.25e-12;
    assert!((sum(0) / area - number(&point["touching_fraction"])).abs() < 1e-9);
    close(sum(1) / area, number(&point["mean_pressure"]), 1e-9);
    for row in &rows {
        assert!(row[2] < 56e-6 && row[3] < 50e-6, "{row:?}");
        close(row[1] / row[0], row[4], 1e-9);
    }

    // Distributions: the weight at zero is what does not touch.
    let (p, found) = (&point["distributions"]["pressure"], &point["distributions"]);
    let [edges, density] = ["edges", "density"].map(|key| list(&p[key]));
    let integral: f64 = density.iter().map(|d| number(d) * number(&edges[1])).sum();
    assert!((integral - number(&point["touching_fraction"])).abs() < 1e-12);
    assert!((number(&p["apart"]) + integral - 1.0).abs() < 1e-12);
    assert_eq!(found["spots"]["count"], rows.len());

    // One file for all fields; only what was asked.
    for (folder, options, name) in [
        ("vtk", "--map-format vti", "contact-000.vti"),
        ("h5", "--map-format hdf5 --fields pressure,gap,heights", "contact-000.h5"),
        ("only", "--fields spots", "spots-000.csv"),
    ] {
        // A file of an earlier run with more loads is in the way, or goes.
        std::fs::create_dir(at.join(folder)).unwrap();
        at.file(&format!("{folder}/{}", name.replace("000", "001")), "of another load");
        at.refuses(&format!("{SOLVE} --maps {folder} {options}"), &["-001.", "--force"]);
        at.done(&format!("{SOLVE} --maps {folder} {options} --force"));
        let written = std::fs::read_dir(at.join(folder)).unwrap();
        assert_eq!(written.map(|e| e.unwrap().file_name()).collect::<Vec<_>>(), [name]);
    }
    let kept = surface_io::read(at.join("h5/contact-000.h5"), &ReadOptions::default()).unwrap();
    assert_eq!(kept.channel, "heights", "the pressure is no height");
    assert_eq!(kept.grid().pixel().map(f64::to_bits), [1.25e-6f64, 1e-6].map(f64::to_bits));
    assert_eq!(kept.channels.len(), 3);
    assert_eq!(at.read("only/spots-000.csv"), table);
    at.refuses(&format!("{} --maps left", SOLVE.replace("map.sdf", "none.sdf")), &["none.sdf"]);
    assert!(!at.join("left").exists(), "nothing was written, so there is no folder");
    let chosen = format!("{SOLVE} --accuracy 5% --maps x --fields heights");
    at.refuses(&chosen, &["--accuracy", "--tolerance"]);
}

/// A slope over one point is the one the moments are made of.
#[test]
fn statistics_by_distance_begin_with_the_moments() {
    let at = &map();
    let stats = at.answer("stats map.sdf --scales");
    for (axis, pixel) in [("x", 1e-6), ("y", 1.25e-6)] {
        let first = &stats["scales"][axis][0];
        close(number(&first["distance"]), pixel, 1e-9);
        close(number(&first["slope"]).powi(2), number(&stats[format!("m2_{axis}")]), 1e-9);
    }
    assert!(at.answer("stats map.sdf").get("scales").is_none());
}
