//! Profiles as a user meets them: a trace to numbers, to a model, to a report, to ridges.

use crate::cli;

use cli::{file, folder, number, refused, rough_contact};
use std::f64::consts::{FRAC_2_PI, PI, TAU};
use std::fmt::Write as _;
use std::path::Path;

/// Text of positions in mm and heights in µm, one column for each of `heights`.
fn traces(at: &Path, name: &str, n: usize, spacing: f64, heights: &[&dyn Fn(f64) -> f64]) {
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
    file(at, name, &text);
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
    let dir = folder();
    let at = dir.path();
    let z = |x: f64| 1e-6 * (TAU * x / 50e-6).sin() + 0.01 * x;
    traces(at, "sine.txt", 12_001, 0.5e-6, &[&z]);
    let said = rough_contact(at, "stats sine.txt --json").answered();
    assert_eq!(said["profile"], true);
    let r = &said["roughness"];
    assert_eq!(r["setting"]["source"], "Sc3");
    assert_eq!(r["sections"], 5);
    let of = |name: &str| number(&r["parameters"][name]["mean"]);
    for (name, expected) in [
        ("Ra", 2e-6 / PI),
        ("Rq", 1e-6 / 2f64.sqrt()),
        ("Rz", 2e-6),
        ("Rt", 2e-6),
        ("RSm", 50e-6),
        ("Rku", 1.5),
        ("Rdq", 2f64.sqrt() * PI * 1e-6 / 50e-6),
    ] {
        assert!((of(name) / expected - 1.0).abs() < 5e-3, "{name}: {} {expected}", of(name));
    }
    // A wave of 100 points: differences see sinc²(π/100) of m2.
    let q = TAU / 50e-6;
    assert!((number(&said["m2"]) / (0.5e-12 * q * q) - 1.0).abs() < 2e-3);
    assert!(
        (number(&said["seen"][0]) / ((PI / 100.0).sin() / (PI / 100.0)).powi(2) - 1.0).abs() < 1e-3
    );
    let text = rough_contact(at, "stats sine.txt");
    assert_eq!(text.status, 0, "{}", text.err);
    for part in ["λc = 800 µm", "5 section lengths", "Sc3", "if isotropic"] {
        assert!(text.out.contains(part), "{part}: {}", text.out);
    }
}

/// Three traces beside each other are one surface; a column of it can be asked for alone. Two columns
/// without titles are asked about and read as one trace.
#[test]
fn several_traces_are_taken_together() {
    let dir = folder();
    let at = dir.path();
    let other = |x: f64| 1.2 * rough(x + 7e-4);
    let third = |x: f64| 0.9 * rough(x + 3e-4);
    traces(at, "three.csv", 4001, 1e-6, &[&rough, &other, &third]);
    let all = rough_contact(at, "stats three.csv --json").answered();
    assert_eq!(all["traces"], 3);
    assert!(number(&all["between_traces"][1]) > 0.05);
    let mean = (0..3).map(|k| number(&all["each"][k]["m2"])).sum::<f64>() / 3.0;
    assert!((number(&all["m2"]) / mean - 1.0).abs() < 1e-12);
    let one = rough_contact(at, "stats three.csv --channel Z2 --json").answered();
    assert_eq!(one["traces"], 1);
    assert!((number(&one["m2"]) / number(&all["each"][1]["m2"]) - 1.0).abs() < 1e-12);
    let info = rough_contact(at, "info three.csv --json").answered();
    assert_eq!(info["channels"].as_array().unwrap().len(), 3);
}

/// The models answer with an interval and with what they assume.
#[test]
fn models_answer_for_an_isotropic_surface() {
    let dir = folder();
    let at = dir.path();
    traces(at, "trace.txt", 6001, 1e-6, &[&rough]);
    for name in ["gw", "persson", "stacked"] {
        let line = format!("model {name} trace.txt --modulus 110GPa --pressure 1MPa,10MPa --json");
        let said = rough_contact(at, &line);
        let json = said.json();
        assert!(json["findings"].to_string().contains("isotropic"), "{name}: {json}");
        let interval = &json["points"][0]["area_interval"];
        assert_eq!(interval.is_array(), matches!(name, "gw" | "persson"), "{name}: {interval}");
        if let Some([low, high]) = interval.as_array().map(Vec::as_slice) {
            let area = number(&json["points"][0]["area_fraction"]);
            assert!(number(low) < area && area < number(high));
        }
    }
    let said = rough_contact(at, "model gw trace.txt --modulus 110GPa --pressure 1MPa");
    assert!(said.out.contains("95 % interval of the area"), "{}", said.out);
}

/// One command to a report; its run file repeats it to the digit.
#[test]
fn a_trace_to_a_report_and_again() {
    let dir = folder();
    let at = dir.path();
    traces(at, "trace.txt", 6001, 1e-6, &[&rough]);
    let said =
        rough_contact(at, "compare trace.txt --modulus 110GPa --out out --quiet --json").answered();
    let profile = &said["profiles"][0];
    assert!(profile["models"].as_array().unwrap().len() >= 7);
    let page = std::fs::read_to_string(at.join("out/report.html")).unwrap();
    for part in ["isotropic", "λc", "RSm", "Greenwood", "<svg", "run.toml"] {
        assert!(page.contains(part), "{part}");
    }
    assert!(!page.contains("NaN") && !page.contains("inf "), "{page}");
    for name in ["results.json", "curves.csv", "area.svg", "trace.svg", "run.toml"] {
        assert!(at.join("out").join(name).exists(), "{name}");
    }
    let again =
        rough_contact(at, "compare --from out/run.toml --out again --quiet --json").answered();
    assert_eq!(again["profiles"][0]["statistics"], profile["statistics"]);
    // A map and a profile are two reports.
    cli::matrix(at, "map.txt", 16, 16, |iy, ix| ((3 * iy + ix) % 5) as f64);
    refused(
        at,
        "compare trace.txt map.txt --pixel 1um --height-unit um --modulus 1GPa --out mixed",
        2,
        &["is a map", "two runs"],
    );
}

/// A cosine in plane strain is Westergaard's: A = 2/π asin √(p/p*), p* = π E* Δ/λ; without being asked
/// it is refused with the way out.
#[test]
fn a_sinusoid_in_plane_strain_is_westergaards() {
    let dir = folder();
    let at = dir.path();
    let (a, n, spacing) = (0.1e-6, 2048, 0.05e-6);
    let wavelength = n as f64 * spacing;
    traces(at, "wave.txt", n, spacing, &[&|x: f64| a * (TAU * x / wavelength).cos()]);
    let closing = PI * 1e9 * a / wavelength;
    for share in [0.1, 0.3, 0.7] {
        let line = format!(
            "solve wave.txt --plane-strain --level mean --modulus 1GPa --pressure {}Pa --tolerance 1e-8 \
             --json --quiet",
            share * closing
        );
        let said = rough_contact(at, &line).answered();
        let expected = FRAC_2_PI * share.sqrt().asin();
        let found = number(&said["points"][0]["area_fraction"]);
        assert!((found - expected).abs() < 3.0 / n as f64, "{share}: {found} {expected}");
        // Mean gap Δ (1 - m + m ln m).
        let gap = a * (1.0 - share + share * share.ln());
        assert!((number(&said["points"][0]["mean_gap"]) / gap - 1.0).abs() < 1e-3, "{share}");
        assert_eq!(said["plane_strain"], true);
    }
    let said =
        rough_contact(at, "solve wave.txt --plane-strain --modulus 1GPa --pressure 1kPa --quiet");
    assert!(said.out.contains("infinitely long"), "{}", said.out);
    let one_line = &["one line of it", "--plane-strain", "compare"];
    refused(at, "solve wave.txt --modulus 1GPa --pressure 1kPa --quiet", 2, one_line);
    let free =
        "solve wave.txt --plane-strain --boundary free --modulus 1GPa --pressure 1kPa --quiet";
    refused(at, free, 2, &["--boundary free"]);
}

/// Uneven points are put at equal distances and it is said; gaps and short traces are refused with
/// value, limit and way out.
#[test]
fn what_cannot_be_taken_as_it_is_is_said() {
    let dir = folder();
    let at = dir.path();
    let mut text = String::from("X [um];Z [nm]\n");
    for i in 0..2000 {
        let x = f64::from(i) + 0.3 * (f64::from(i) * 0.7).sin();
        writeln!(text, "{x:.4};{:.4}", 100.0 * (x / 8.0).sin()).unwrap();
    }
    file(at, "uneven.txt", &text);
    let said = rough_contact(at, "stats uneven.txt --json").answered();
    assert!(number(&said["uneven"]["longest_step"]) > 1.05e-6);
    let q = 1.0 / 8e-6;
    assert!((number(&said["m2"]) / (0.5e-14 * q * q) - 1.0).abs() < 0.03, "{}", said["m2"]);
    let words = rough_contact(at, "stats uneven.txt");
    assert!(words.out.contains("straight lines between neighbours"), "{}", words.out);

    file(
        at,
        "gap.txt",
        "X [um];Z [nm]\n0.0;1\n1.0;2\n2.0;1\n3.0;2\n90.5;1\n91.0;2\n92.0;1\n93.0;2\n94.0;0\n95.0;1\n96.0;2\n97.0;3\n98.0;1\n",
    );
    refused(at, "stats gap.txt", 2, &["0.087", "10", "cut the gap out"]);
    file(at, "short.txt", "X [um];Z [nm]\n0;1\n1;2\n2;1\n3;2\n");
    refused(at, "stats short.txt", 2, &["32", "4", "longer trace"]);
    traces(at, "trace.txt", 1001, 1e-6, &[&rough]);
    refused(
        at,
        "stats trace.txt --l-filter 0.8mm",
        2,
        &["1 mm", "0.8 mm", "1.6 mm", "shorter cut-off"],
    );
    refused(at, "stats trace.txt --align-rows", 2, &["--align-rows", "profile"]);
    refused(at, "stats trace.txt --form sphere", 2, &["polynomial:2"]);
    // No class fits 0.1 mm: the moments are there, the roughness is not, and why.
    traces(at, "tiny.txt", 201, 0.5e-6, &[&rough]);
    let tiny = rough_contact(at, "stats tiny.txt --json").answered();
    assert!(tiny["roughness"].is_null() && tiny["m2"].is_number());
    assert!(tiny["no_roughness_because"].as_str().unwrap().contains("0.16 mm"), "{tiny}");
}
