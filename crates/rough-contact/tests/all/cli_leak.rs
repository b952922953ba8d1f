//! The leak through the gap, as a user asks for it.

use crate::cli;

use cli::{folder, number, rough_contact};
use serde_json::Value;
use std::path::Path;

fn surface(at: &Path) {
    let synth = "synth --shape 64,64 --pixel 1um --hurst 0.8 --rolloff 32um --cutoff 8um \
                 --rms-gradient 0.1 --seed 4 --out a.x3p";
    assert_eq!(rough_contact(at, synth).status, 0);
}

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{found} instead of {expected}");
}

/// Permeability, rate, closed forms and channel of an open contact, a narrow one and a sealed one.
#[test]
fn a_seal_closes_as_it_is_pressed() {
    let dir = folder();
    let at = dir.path();
    surface(at);
    let seal = "--viscosity 1mPa.s --pressure-drop 1MPa --seal-length 1mm --seal-width 10mm";
    let line =
        format!("solve a.x3p --modulus 10MPa --pressure 20kPa,100kPa,10MPa --leak both {seal}");
    let found = rough_contact(at, &format!("{line} --json")).answered();
    assert_eq!(found["leak"]["gap"], "elastic");
    assert_eq!(found["leak"]["axes"], serde_json::json!(["x", "y"]));
    let leak = |i: usize, axis: &str| found["points"][i]["leak"][axis].clone();
    let mut last = f64::INFINITY;
    for (i, axis) in [(0, "x"), (1, "x")] {
        let here = leak(i, axis);
        assert_eq!(here["channel"], "open", "{here}");
        let k = number(&here["permeability"]);
        assert!(k > 0.0 && k < last);
        last = k;
        close(number(&here["rate"]), k * 0.01 * 1e6 / (12.0 * 1e-3 * 1e-3), 1e-12);
        let plates = &found["points"][i]["leak"]["closed_forms"][0];
        assert_eq!(plates["name"], "mean_gap_cubed");
        close(number(&here["flow_factor"]), k / number(&plates["permeability"]), 1e-12);
        close(number(&plates["error"][axis]), number(&plates["permeability"]) / k - 1.0, 1e-12);
        // Mean gap of the solver, whose residual in contact is that of its tolerance.
        close(
            number(&plates["permeability"]).cbrt(),
            number(&found["points"][i]["mean_gap"]),
            1e-2,
        );
        assert!(number(&here["interval"][0]) < k && k < number(&here["interval"][1]));
        assert!(number(&here["imbalance"]) < 1e-8);
    }
    for axis in ["x", "y"] {
        let sealed = leak(2, axis);
        assert_eq!(sealed["channel"], "sealed");
        assert_eq!((number(&sealed["permeability"]), number(&sealed["rate"])), (0.0, 0.0));
        assert_eq!((&sealed["bottleneck"], &sealed["interval"]), (&Value::Null, &Value::Null));
    }
    let said = rough_contact(at, &line);
    for words in ["permeability K", "m³/s", "sealed at this resolution", "Bruggeman"] {
        assert!(said.out.contains(words), "{words}: {}", said.out);
    }
    assert!(!said.out.contains("meaningless"), "rubber does not yield: {}", said.out);
}

/// A study says of the leak what `solve` says, in JSON, CSV and page; without `--leak` nothing of it, and of a profile none.
#[test]
fn a_study_leaks_as_its_solutions_do() {
    let dir = folder();
    let at = dir.path();
    surface(at);
    let seal =
        "--leak both --viscosity 1mPa.s --pressure-drop 1MPa --seal-length 1mm --seal-width 10mm";
    let line = "a.x3p --modulus 10MPa --pressure 20kPa,100kPa,10MPa";
    let study = |more: &str| {
        let said = rough_contact(at, &format!("compare {line} {more} --out report --force"));
        assert_eq!(said.status, 0, "{}", said.err);
        let read = |name: &str| std::fs::read_to_string(at.join("report").join(name)).expect("it");
        let results: Value = serde_json::from_str(&read("results.json")).expect("JSON");
        let found = results["surfaces"][0]["leak"].clone();
        (found, read("report.html"), read("curves.csv"), said.out)
    };
    let (found, page, csv, out) = study(seal);
    let solved = rough_contact(at, &format!("solve {line} {seal} --json")).answered();
    for key in ["axes", "gap", "viscosity", "pressure_drop", "seal_length", "seal_width"] {
        assert_eq!(found[key], solved["leak"][key], "{key}");
    }
    for i in 0..3 {
        let (here, there) = (&found["points"][i], &solved["points"][i]["leak"]);
        for axis in ["x", "y"] {
            assert_eq!(here[axis]["channel"], there[axis]["channel"]);
            assert_eq!(here[axis]["bottleneck"], there[axis]["bottleneck"]);
            for key in ["permeability", "rate"] {
                assert_eq!(here[axis][key], there[axis][key], "{axis} {key}");
            }
            let row: Vec<&str> = csv.lines().nth(i + 1).expect("a row").split(',').collect();
            let head = csv.lines().next().expect("a header").split(',');
            let name = format!("permeability_{axis} [m^3]");
            let column = head.into_iter().position(|h| h == name).expect("a column");
            close(
                number(&here[axis]["permeability"]) + 1.0,
                row[column].parse::<f64>().expect("K") + 1.0,
                1e-12,
            );
        }
        for k in [0, 1] {
            let form = |point: &Value| point["closed_forms"][k]["permeability"].clone();
            assert_eq!(form(here), form(there));
        }
    }
    for words in ["Permeability of the gap", "Flow along y", "Bruggeman", "Leak rate along x"] {
        assert!(page.contains(words), "{words}");
    }
    assert!(out.contains("permeability K") && out.contains("sealed at this resolution"), "{out}");
    let again = rough_contact(at, "compare --from report/run.toml --out again --json").answered();
    assert_eq!(again["surfaces"][0]["leak"]["seal_width"], found["seal_width"]);

    let (found, page, csv, out) = study("");
    assert!(found.is_null() && ![page, csv, out].iter().any(|text| text.contains("ermeability")));
}

/// Metals: elastic it is said to be meaningless; yielded the gap is another.
#[test]
fn metals_leak_through_the_yielded_gap() {
    let dir = folder();
    let at = dir.path();
    surface(at);
    let line = "solve a.x3p --modulus 110GPa --pressure 800MPa --leak x";
    let elastic = rough_contact(at, line);
    assert!(elastic.out.contains("meaningless"), "{}", elastic.out);
    let k = |line: &str| {
        let found = rough_contact(at, &format!("{line} --json")).answered();
        (found["leak"]["gap"].clone(), number(&found["points"][0]["leak"]["x"]["interval"][1]))
    };
    let (gap, elastic) = k(line);
    assert_eq!(gap, "elastic");
    let yielded = format!("{line} --hardness 3GPa");
    assert!(!rough_contact(at, &yielded).out.contains("meaningless"));
    let (gap, flattened) = k(&yielded);
    assert_eq!(gap, "yielded");
    assert!(flattened < elastic, "{flattened} and {elastic}");
}

#[test]
fn what_has_no_leak_is_refused() {
    let dir = folder();
    let at = dir.path();
    surface(at);
    let refused = |rest: &str, words: &str| {
        let said =
            rough_contact(at, &format!("solve a.x3p --modulus 10MPa --pressure 20kPa {rest}"));
        assert_eq!(said.status, 2, "{rest}: {}", said.err);
        assert!(said.err.contains(words), "{rest}: {}", said.err);
    };
    let seal = |eta: &str, drop: &str| {
        format!(
            "--leak x --viscosity {eta} --pressure-drop {drop} --seal-length 1mm --seal-width 1cm"
        )
    };
    refused(&seal("0mPa.s", "1MPa"), "viscosity 0e0: it must be more than 0");
    refused(&seal("1mPa.s", "-1MPa"), "pressure drop -1e6: it must be 0 or more");
    refused("--leak x --viscosity 1mPa.s", "pressure drop is");
    refused("--viscosity 1mPa.s", "ask for it along");
    refused("--leak z", "both");
    refused("--leak x --viscosity 1", "Pa.s");
    refused("--leak x --boundary free", "around an isolated contact everything is open");
}

/// The numbers of a row, without those that are times.
fn row(line: &str) -> Vec<f64> {
    let words = line.split_whitespace();
    words.filter_map(|word| word.trim_start_matches('±').parse().ok()).collect()
}

/// The worked example of the book prints the rows that the book shows.
#[test]
fn the_page_shows_what_the_command_prints() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/src/seal.md");
    let page = std::fs::read_to_string(page).expect("the page").replace("\\\n", " ");
    let dir = folder();
    let commands: Vec<&str> =
        page.lines().filter_map(|line| line.strip_prefix("$ rough-contact ")).collect();
    let said: Vec<_> = commands.iter().map(|line| rough_contact(dir.path(), line)).collect();
    let printed = said.last().expect("a command");
    assert_eq!(printed.status, 0, "{}", printed.err);
    let is_row = |line: &&str| line.contains("m³") && !line.contains("K =");
    let leaks = |text: &'_ str| -> Vec<Vec<f64>> {
        let rows = text.lines().filter(|l| is_row(l) && l.contains("kPa") && !l.starts_with('$'));
        rows.map(row).collect()
    };
    let (shown, found) = (leaks(&page), leaks(&printed.out));
    assert!(shown.len() == found.len() && shown.len() >= 2, "{shown:?} and {found:?}");
    for (shown, found) in shown.iter().flatten().zip(found.iter().flatten()) {
        assert!(
            (shown - found).abs() <= 0.02 * found.abs(),
            "{shown} instead of {found}: {}",
            printed.out
        );
    }
}
