//! Profiles as a user meets them: a trace to numbers, to a model, to a report, to ridges.

use crate::cli::{TestFolder, close, ends, folder, has, list, number};
use std::f64::consts::{FRAC_2_PI, PI, TAU};
use std::fmt::Write as _;

/// Text of positions in mm and heights in µm, one column for each of `heights`.
fn traces(at: &TestFolder, name: &str, n: usize, spacing: f64, heights: &[&dyn Fn(f64) -> f64]) {
    let mut text = String::from("X [mm]");
    for k in 1..=heights.len() {
        write!(text, ";Z{k} [um]").unwrap();
    }
    for i in 0..n {
        let x = i as f64 * spacing;
        write!(text, "\n{:.6}", 1e3 * x).unwrap();
        for z in heights {
            write!(text, ";{:.9}", 1e6 * z(x)).unwrap();
        }
    }
    at.file(name, &text);
}

/// Waves of random-looking phases between 20 and 400 µm.
fn rough(x: f64) -> f64 {
    (1..60)
        .map(|k| 0.02e-6 * (TAU * x * f64::from(k) / 1.013e-3 + f64::from(k * k) * 1.7).sin())
        .sum()
}

/// A sine of 1 µm and 50 µm on a tilt, 6 mm long: the class of Ra = 0.64 µm is Sc3, λc = 0.8 mm, five
/// sections; Ra = 2A/π, Rq = A/√2, Rz = 2A, RSm = λ, less what λs = 2.5 µm and λc take off (0.3 %).
#[test]
fn a_sine_has_the_parameters_of_the_formulas() {
    let at = &folder();
    let z = |x: f64| 1e-6 * (TAU * x / 50e-6).sin() + 0.01 * x;
    traces(at, "sine.txt", 12_001, 0.5e-6, &[&z]);
    let said = at.answer("stats sine.txt");
    assert_eq!(said["profile"], true);
    let r = &said["roughness"];
    assert_eq!(r["setting"]["source"], "Sc3");
    assert_eq!(r["sections"], 5);
    for (name, expected) in [
        ("Ra", 2e-6 / PI),
        ("Rz", 2e-6),
        ("RSm", 50e-6),
        ("Rku", 1.5),
        ("Rdq", 2f64.sqrt() * PI * 1e-6 / 50e-6),
    ] {
        close(number(&r["parameters"][name]["mean"]), expected, 5e-3);
    }
    // A wave of 100 points: differences see sinc²(π/100) of m2.
    let q = TAU / 50e-6;
    close(number(&said["m2"]), 0.5e-12 * q * q, 2e-3);
    close(number(&said["seen"][0]), ((PI / 100.0).sin() / (PI / 100.0)).powi(2), 1e-3);
    let text = at.done("stats sine.txt").out;
    has(&text, &["λc = 800 µm", "5 section lengths", "Sc3", "if isotropic"]);
}

/// Traces beside each other are one surface; a column of it can be asked for alone.
#[test]
fn several_traces_are_taken_together() {
    let at = &folder();
    let other = |x: f64| 1.2 * rough(x + 7e-4);
    let third = |x: f64| 0.9 * rough(x + 3e-4);
    traces(at, "three.csv", 4001, 1e-6, &[&rough, &other, &third]);
    let all = at.answer("stats three.csv");
    assert_eq!(all["traces"], 3);
    assert!(number(&all["between_traces"][1]) > 0.05);
    let each: Vec<f64> = list(&all["each"]).iter().map(|trace| number(&trace["m2"])).collect();
    close(number(&all["m2"]), each.iter().sum::<f64>() / 3.0, 1e-12);
    let one = at.answer("stats three.csv --channel Z2");
    assert_eq!(one["traces"], 1);
    close(number(&one["m2"]), each[1], 1e-12);
    assert_eq!(list(&at.answer("info three.csv")["channels"]).len(), 3);
}

/// The models answer with an interval and with what they assume.
#[test]
fn models_answer_for_an_isotropic_surface() {
    let at = &folder();
    traces(at, "trace.txt", 6001, 1e-6, &[&rough]);
    let line =
        |name: &str| format!("model {name} trace.txt --modulus 110GPa --pressure 1MPa,10MPa");
    for name in ["gw", "persson", "stacked"] {
        let json = at.run(&format!("{} --json", line(name))).json();
        has(&json["findings"].to_string(), &["isotropic"]);
        let interval = &json["points"][0]["area_interval"];
        assert_eq!(interval.is_array(), matches!(name, "gw" | "persson"), "{name}: {interval}");
        if interval.is_array() {
            let ([low, high], area) = (ends(interval), number(&json["points"][0]["area_fraction"]));
            assert!(low < area && area < high);
        }
    }
    has(&at.run(&line("gw")).out, &["95 % interval of the area"]);
    // A line has no area for a force to press on.
    at.refuses("model gw trace.txt --modulus 110GPa --load 1N", &["--area 2mm2"]);
}

/// One command to a report.
#[test]
fn a_trace_to_a_report() {
    let at = &folder();
    traces(at, "trace.txt", 6001, 1e-6, &[&rough]);
    let said = at.answer("compare trace.txt --modulus 110GPa --out out --quiet");
    let profile = &said["profiles"][0];
    assert!(list(&profile["models"]).len() >= 7);
    let page = at.read("out/report.html");
    has(&page, &["isotropic", "λc", "RSm", "Greenwood", "<svg", "run.toml"]);
    assert!(!page.contains("NaN") && !page.contains("inf "), "{page}");
    for name in ["results.json", "curves.csv", "area.svg", "trace.svg", "run.toml"] {
        assert!(at.join("out").join(name).exists(), "{name}");
    }
    // A map and a profile are two reports.
    at.matrix("map.txt", 16, 16, |iy, ix| ((3 * iy + ix) % 5) as f64);
    at.refuses(
        "compare trace.txt map.txt --pixel 1um --height-unit um --modulus 1GPa --out mixed",
        &["is a map", "two runs"],
    );
}

/// A = 2/π asin √(p/p*), p* = π E* Δ/λ; unasked it is refused with the way out.
#[test]
fn a_sinusoid_in_plane_strain_is_westergaards() {
    let at = &folder();
    let (a, n, spacing) = (0.1e-6, 2048, 0.05e-6);
    let wavelength = n as f64 * spacing;
    traces(at, "wave.txt", n, spacing, &[&|x: f64| a * (TAU * x / wavelength).cos()]);
    let closing = PI * 1e9 * a / wavelength;
    let line = "solve wave.txt --modulus 1GPa --quiet";
    for share in [0.1, 0.3, 0.7] {
        let load = format!("--level mean --pressure {}Pa --tolerance 1e-8", share * closing);
        let said = at.answer(&format!("{line} --plane-strain {load}"));
        let expected = FRAC_2_PI * share.sqrt().asin();
        let found = number(&said["points"][0]["area_fraction"]);
        assert!((found - expected).abs() < 3.0 / n as f64, "{share}: {found} {expected}");
        // Mean gap Δ (1 - m + m ln m).
        let gap = a * (1.0 - share + share * share.ln());
        close(number(&said["points"][0]["mean_gap"]), gap, 1e-3);
        assert_eq!(said["plane_strain"], true);
    }
    let spots = "--maps maps --fields spots --distributions";
    let said = at.answer(&format!("{line} --plane-strain --pressure 1kPa {spots}"));
    // The one spot of ridges: its length, and load per length.
    let [length] = at.column("maps/spots-000.csv", "length (m)")[..] else { panic!("one spot") };
    close(at.column("maps/spots-000.csv", "load (N/m)")[0], 1e3 * wavelength, 1e-9);
    close(length, number(&said["points"][0]["touching_fraction"]) * wavelength, 1e-9);
    close(number(&said["points"][0]["distributions"]["spots"]["areas"][0]), spacing, 1e-9);
    let said = at.run(&format!("{line} --plane-strain --pressure 1kPa")).out;
    has(&said, &["infinitely long"]);
    at.refuses_each(
        &format!("{line} --pressure 1kPa"),
        &[
            ("", &["one line of it", "--plane-strain", "compare"]),
            ("--plane-strain --boundary free", &["--boundary free"]),
        ],
    );
}

/// Uneven points are put at equal distances; gaps and short traces are refused with the limit.
#[test]
fn what_cannot_be_taken_as_it_is_is_said() {
    let at = &folder();
    let mut text = String::from("X [um];Z [nm]\n");
    for i in 0..2000 {
        let x = f64::from(i) + 0.3 * (f64::from(i) * 0.7).sin();
        writeln!(text, "{x:.4};{:.4}", 100.0 * (x / 8.0).sin()).unwrap();
    }
    at.file("uneven.txt", &text);
    let said = at.answer("stats uneven.txt");
    assert!(number(&said["uneven"]["longest_step"]) > 1.05e-6);
    let q = 1.0 / 8e-6;
    close(number(&said["m2"]), 0.5e-14 * q * q, 0.03);
    has(&at.run("stats uneven.txt").out, &["straight lines between neighbours"]);

    at.file(
        "gap.txt",
        "X [um];Z [nm]\n0.0;1\n1.0;2\n2.0;1\n3.0;2\n90.5;1\n91.0;2\n92.0;1\n93.0;2\n94.0;0\n95.0;1\n96.0;2\n97.0;3\n98.0;1\n",
    );
    at.file("short.txt", "X [um];Z [nm]\n0;1\n1;2\n2;1\n3;2\n");
    traces(at, "trace.txt", 1001, 1e-6, &[&rough]);
    at.refuses_each(
        "stats",
        &[
            ("gap.txt", &["0.087", "10", "cut the gap out"]),
            ("short.txt", &["32", "4", "longer trace"]),
            ("trace.txt --l-filter 0.8mm", &["1 mm", "0.8 mm", "1.6 mm", "shorter cut-off"]),
            ("trace.txt --align-rows", &["--align-rows", "profile"]),
            ("trace.txt --form sphere", &["polynomial:2"]),
        ],
    );
    // No class fits 0.1 mm: the moments are there, the roughness is not, and why.
    traces(at, "tiny.txt", 201, 0.5e-6, &[&rough]);
    let tiny = at.answer("stats tiny.txt");
    assert!(tiny["roughness"].is_null() && tiny["m2"].is_number());
    has(tiny["no_roughness_because"].as_str().unwrap(), &["0.16 mm"]);
}
