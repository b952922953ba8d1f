//! The leak through the gap, as a user asks for it.

use crate::cli::{ROUGH, book, close, ends, folder, has, number, surface};
use serde_json::{Value, json};

const SEAL: &str =
    "--leak both --viscosity 1mPa.s --pressure-drop 1MPa --seal-length 1mm --seal-width 10mm";
const RUBBER: &str = "a.x3p --modulus 10MPa --pressure 20kPa,100kPa,10MPa";

/// Permeability, rate, closed forms and channel of an open contact, a narrow one and a sealed one.
#[test]
fn a_seal_closes_as_it_is_pressed() {
    let at = &surface(ROUGH);
    let line = format!("solve {RUBBER} {SEAL}");
    let found = at.answer(&line);
    assert_eq!(found["leak"]["gap"], "elastic");
    assert_eq!(found["leak"]["axes"], json!(["x", "y"]));
    let mut last = f64::INFINITY;
    for i in [0, 1] {
        let leak = &found["points"][i]["leak"];
        let here = &leak["x"];
        assert_eq!(here["channel"], "open", "{here}");
        let k = number(&here["permeability"]);
        assert!(k > 0.0 && k < last);
        last = k;
        close(number(&here["rate"]), k * 0.01 * 1e6 / (12.0 * 1e-3 * 1e-3), 1e-12);
        let plates = &leak["closed_forms"][0];
        assert_eq!(plates["name"], "mean_gap_cubed");
        let of_plates = number(&plates["permeability"]);
        close(number(&here["flow_factor"]), k / of_plates, 1e-12);
        close(number(&plates["error"]["x"]), of_plates / k - 1.0, 1e-12);
        // Mean gap of the solver, whose residual in contact is that of its tolerance.
        close(of_plates.cbrt(), number(&found["points"][i]["mean_gap"]), 1e-2);
        let [low, high] = ends(&here["interval"]);
        assert!(low < k && k < high);
        assert!(number(&here["imbalance"]) < 1e-9);
    }
    for axis in ["x", "y"] {
        let sealed = &found["points"][2]["leak"][axis];
        assert_eq!(sealed["channel"], "sealed");
        assert_eq!((number(&sealed["permeability"]), number(&sealed["rate"])), (0.0, 0.0));
        assert_eq!((&sealed["bottleneck"], &sealed["interval"]), (&Value::Null, &Value::Null));
    }
    let said = at.run(&line).out;
    has(&said, &["permeability K", "m³/s", "sealed at this resolution", "Bruggeman"]);
    assert!(!said.contains("meaningless"), "rubber does not yield: {said}");
}

/// A study says of the leak what `solve` says, in JSON, CSV and page; without `--leak` nothing of it, and of a profile none.
#[test]
fn a_study_leaks_as_its_solutions_do() {
    let at = &surface(ROUGH);
    let study = |more: &str| {
        let said = at.done(&format!("compare {RUBBER} {more} --out report --force"));
        let found = at.results("report")["surfaces"][0]["leak"].clone();
        (found, at.read("report/report.html"), at.read("report/curves.csv"), said.out)
    };
    let (found, page, _, out) = study(SEAL);
    let permeabilities =
        |axis: &str| at.column("report/curves.csv", &format!("permeability_{axis} [m^3]"));
    let solved = at.answer(&format!("solve {RUBBER} {SEAL}"));
    for key in ["axes", "gap", "viscosity", "pressure_drop", "seal_length", "seal_width"] {
        assert_eq!(found[key], solved["leak"][key], "{key}");
    }
    for i in 0..3 {
        let (here, there) = (&found["points"][i], &solved["points"][i]["leak"]);
        for axis in ["x", "y"] {
            for key in ["channel", "bottleneck", "permeability", "rate"] {
                assert_eq!(here[axis][key], there[axis][key], "{axis} {key}");
            }
            let written = permeabilities(axis)[i];
            close(number(&here[axis]["permeability"]) + 1.0, written + 1.0, 1e-12);
        }
        for k in [0, 1] {
            let form = |point: &Value| point["closed_forms"][k]["permeability"].clone();
            assert_eq!(form(here), form(there));
        }
    }
    has(&page, &["Permeability of the gap", "Flow along y", "Bruggeman", "Leak rate along x"]);
    has(&out, &["permeability K", "sealed at this resolution"]);
    let (found, page, csv, out) = study("");
    assert!(found.is_null() && ![page, csv, out].iter().any(|text| text.contains("ermeability")));
}

/// Metals: elastic it is said to be meaningless; yielded the gap is another.
#[test]
fn metals_leak_through_the_yielded_gap() {
    let at = &surface(ROUGH);
    let line = "solve a.x3p --modulus 110GPa --pressure 800MPa --leak x";
    let [elastic, flattened] =
        [("", "elastic"), ("--hardness 3GPa", "yielded")].map(|(more, gap)| {
            let line = format!("{line} {more}");
            let found = at.answer(&line);
            assert_eq!(found["leak"]["gap"], gap);
            let said = at.run(&line).out;
            assert_eq!(said.contains("meaningless"), more.is_empty(), "{said}");
            ends(&found["points"][0]["leak"]["x"]["interval"])[1]
        });
    assert!(flattened < elastic, "{flattened} and {elastic}");
}

#[test]
fn what_has_no_leak_is_refused() {
    let at = &surface(ROUGH);
    at.refuses_each(
        "solve a.x3p --modulus 10MPa --pressure 20kPa",
        &[
            ("--leak x --viscosity 1mPa.s", &["pressure drop is"]),
            ("--leak z", &["both"]),
            ("--leak x --viscosity 1", &["Pa.s"]),
            ("--leak x --boundary free", &["around an isolated contact everything is open"]),
        ],
    );
}

/// The numbers of a row, without those that are times.
fn row(line: &str) -> Vec<f64> {
    let words = line.split_whitespace();
    words.filter_map(|word| word.trim_start_matches('±').parse().ok()).collect()
}

/// The worked example of the book prints the rows that the book shows.
#[test]
fn the_page_shows_what_the_command_prints() {
    let page = book("seal.md").replace("\\\n", " ");
    let at = &folder();
    let commands = page.lines().filter_map(|line| line.strip_prefix("$ rough-contact "));
    let printed = commands.fold(String::new(), |_, line| at.done(line).out);
    let is_row = |line: &&str| {
        line.contains("m³")
            && !line.contains("K =")
            && line.contains("kPa")
            && !line.starts_with('$')
    };
    let leaks = |text: &'_ str| -> Vec<Vec<f64>> { text.lines().filter(is_row).map(row).collect() };
    let (shown, found) = (leaks(&page), leaks(&printed));
    assert!(shown.len() == found.len() && shown.len() >= 2, "{shown:?} and {found:?}");
    for (shown, found) in shown.iter().flatten().zip(found.iter().flatten()) {
        assert!((shown - found).abs() <= 0.02 * found.abs(), "{shown}, not {found}: {printed}");
    }
}
