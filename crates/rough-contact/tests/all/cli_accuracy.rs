//! `--accuracy`: a request that is met, and requests that the data cannot support.

use crate::cli;

use cli::{folder, refused, rough_contact};
use contact_types::{ContactModulus, Grid, HeightMap};
use fft_bem_solver::{Load, Solver};
use serde_json::Value;
use std::path::Path;
use surface_io::ReadOptions;
use surface_stats::Edges;
use surface_stats::clean::resample;

/// A load on four times as many points along each side.
struct Truth {
    pressure: f64,
    area: f64,
    gap: f64,
}

/// `map.npy` in `folder` on four times as many points a side, pressed by these loads.
fn truths(folder: &Path, pressures: &[f64]) -> Vec<Truth> {
    let options = ReadOptions::default().with_pixel([1e-6; 2]).with_height_unit(1.0);
    let read = surface_io::read(folder.join("map.npy"), &options).unwrap();
    let map =
        HeightMap::new(Grid::new([192; 2], [1e-6; 2]).unwrap(), read.heights().to_vec()).unwrap();
    let fine = resample(&map, [768; 2], Edges::Periodic).unwrap();
    let modulus = ContactModulus::from_pascals(1e9).unwrap();
    let mut solver = Solver::builder().tolerance(1e-6).build(fine.grid(), modulus).unwrap();
    let solve = |&pressure: &f64| {
        let solution = solver.solve(&fine, Load::MeanPressure(pressure)).unwrap();
        let area = solution.state.area_fraction;
        Truth { pressure, area, gap: solution.state.mean_gap.unwrap() }
    };
    pressures.iter().map(solve).collect()
}

/// A surface of 192² points of 1 um with these shortest waves (um), and how to read it.
fn surface(folder: &Path, cutoff: f64, more: &str) -> &'static str {
    let made = rough_contact(
        folder,
        &format!(
            "synth --shape 192,192 --pixel 1um --hurst 0.8 --rolloff 48um --cutoff {cutoff}um \
             --rms-gradient 0.1 --seed 11 --out map.npy --force --quiet {more}"
        ),
    );
    assert_eq!(made.status, 0, "{}", made.err);
    "solve map.npy --level none --pixel 1um --height-unit m --modulus 1GPa --quiet --json --threads 1"
}

fn areas(answer: &Value) -> Vec<f64> {
    let points = answer["points"].as_array().unwrap();
    points.iter().map(|p| p["area_fraction"].as_f64().unwrap()).collect()
}

/// Every second point for a loose request, twice the points for a tight one. The areas lie within the request of
/// those of the tightest, and every point comes with its interval.
#[test]
fn the_rung_follows_the_request() {
    let folder = folder();
    let solve = surface(folder.path(), 12.0, "");
    let loads = "--pressure 8MPa,2MPa,30MPa";
    let truth: Vec<f64> =
        truths(folder.path(), &[8e6, 2e6, 30e6]).iter().map(|truth| truth.area).collect();
    let mut sides = Vec::new();
    for percent in [20.0, 5.0, 2.0] {
        let line = format!("{solve} {loads} --accuracy {percent}%");
        let answer = rough_contact(folder.path(), &line).answered();
        let plan = &answer["accuracy"];
        assert_eq!(plan["met"], true, "{plan}");
        assert!(plan["half_width"].as_f64().unwrap() <= percent / 100.0);
        assert_eq!(plan["grid"], answer["shape"]);
        assert_eq!(plan["precision"], answer["precision"]);
        assert_eq!(plan["tolerance"], answer["tolerance"]);
        for (found, truth) in areas(&answer).iter().zip(&truth) {
            assert!((found / truth - 1.0).abs() < percent / 100.0, "{percent} %: {found} {truth}");
        }
        for point in answer["points"].as_array().unwrap() {
            let [low, high] = [0, 1].map(|i| point["area_interval"][i].as_f64().unwrap());
            let area = point["area_fraction"].as_f64().unwrap();
            assert!((0.5 * (high - low) / area) <= percent / 100.0 && low < area && area < high);
        }
        sides.push(plan["grid"][0].as_u64().unwrap());
    }
    assert!(sides[0] < sides[2] && sides.is_sorted(), "{sides:?}");
    // The same choice again, on other threads, and without JSON one line of it.
    let line = format!("{solve} {loads} --accuracy 5%");
    let again = rough_contact(folder.path(), &line.replace("--threads 1", "--threads 3"));
    assert_eq!(again.answered()["accuracy"]["grid"][0].as_u64(), Some(sides[1]));
    let text = rough_contact(folder.path(), &line.replace("--json", "")).out;
    let last = text.trim_end().lines().last().unwrap().to_owned();
    assert!(last.contains("f32, tolerance 1e−3: ±") && last.contains("next: "), "{last}");
}

/// `--fast` answers on every second point and says what the map itself would give.
#[test]
fn a_fast_answer_says_what_the_next_rung_gives() {
    let folder = folder();
    let solve = surface(folder.path(), 12.0, "").replace("--json ", "");
    let said = rough_contact(folder.path(), &format!("{solve} --pressure 8MPa --fast"));
    assert_eq!(said.status, 0, "{}", said.err);
    assert!(
        said.out.contains("96² of 192² points") && said.out.contains("next: 192², about ±"),
        "{}",
        said.out
    );
}

/// Waves of two points, contacts of a few points: what was computed is printed, marked, with exit status 1 and the
/// reason.
#[test]
fn what_the_data_cannot_support_is_said() {
    for (cutoff, load, why) in [
        (2.0, "5MPa", "the result depends on interpolation between points"),
        (4.0, "0.1MPa", "at 100\u{202F}kPa, and no finer grid"),
    ] {
        let folder = folder();
        let solve = surface(folder.path(), cutoff, "");
        let said =
            rough_contact(folder.path(), &format!("{solve} --pressure {load} --accuracy 1%"));
        let answer = said.json();
        assert_eq!(said.status, 1, "{why}: {answer}");
        let plan = &answer["accuracy"];
        assert_eq!(plan["met"], false);
        let reason = plan["reason"].as_str().unwrap();
        assert!(reason.contains(why), "{reason}");
        assert!(said.err.contains(reason), "{}", said.err);
        assert_eq!(answer["error"]["kind"], "accuracy_not_met");
        assert!(answer["points"][0]["area_fraction"].as_f64().unwrap() > 0.0);
    }
}

/// A single point in contact is solved exactly and says nothing about the area of the surface;
/// contact everywhere has no line and no error of the grid.
#[test]
fn one_point_of_contact_is_no_accuracy_and_full_contact_is() {
    let folder = folder();
    let solve = surface(folder.path(), 12.0, "");
    let said = rough_contact(folder.path(), &format!("{solve} --pressure 1mPa --accuracy 5%"));
    let answer = said.json();
    assert_eq!((said.status, &answer["accuracy"]["met"]), (1, &Value::Bool(false)), "{answer}");
    assert!(answer["accuracy"]["half_width"].as_f64().is_none_or(|width| width > 0.05));
    let full = format!("{solve} --pressure 10GPa --accuracy 0.1%");
    let answer = rough_contact(folder.path(), &full).answered();
    assert_eq!(answer["points"][0]["area_fraction"], 1.0);
    assert_eq!(answer["accuracy"]["met"], true);
}

#[test]
fn what_cannot_be_planned_is_refused() {
    let folder = folder();
    let solve = surface(folder.path(), 8.0, "").replace("--json ", "");
    let line = |more: &str| format!("{solve} --pressure 1MPa {more}");
    refused(folder.path(), &line("--accuracy 2"), 2, &["'2'", "write a percentage", "2%"]);
    refused(folder.path(), &line("--accuracy 0%"), 2, &["0 %", "greater than 0"]);
    refused(folder.path(), &line("--accuracy 2% --tolerance 1e-3"), 2, &["--tolerance"]);
    refused(folder.path(), &line("--accuracy 2% --precision f32"), 2, &["--precision"]);
    refused(folder.path(), &line("--accuracy 2% --fast"), 2, &["--fast", "--accuracy"]);
    refused(folder.path(), &line("--refine"), 2, &["--refine", "unasked", "--accuracy"]);
    refused(folder.path(), &line("--accuracy 200%"), 2, &["200 %", "at most 50 %"]);
    let free = format!("{solve} --gap 10nm --accuracy 2% --boundary free");
    refused(folder.path(), &free, 2, &["--gap", "--boundary free", "--pressure"]);
}

/// Areas at gaps and the loads that belong to them: the map on four times as many points a side is
/// pressed to its gaps by loads, and the same gaps are asked for on the map as given. The wide gap
/// beyond the first contact is no accuracy, and the message says where contact begins.
#[test]
fn a_given_gap_has_an_area_and_a_load_with_their_intervals() {
    let folder = folder();
    let solve = surface(folder.path(), 12.0, "");
    let fine = truths(folder.path(), &[2e6, 8e6, 30e6]);
    let gaps: Vec<String> = fine.iter().map(|t| format!("{}m", t.gap)).collect();
    for (request, bound) in [("--accuracy 10%", 0.1), ("--accuracy 3%", 0.03), ("", 0.1)] {
        let line = format!("{solve} --gap {} {request}", gaps.join(","));
        let answer = rough_contact(folder.path(), &line).answered();
        for (point, truth) in answer["points"].as_array().unwrap().iter().zip(&fine) {
            for (name, exact) in [("area", truth.area), ("mean_pressure", truth.pressure)] {
                let interval = &point[format!("{name}_interval")];
                let [low, high] = [0, 1].map(|i| interval[i].as_f64().unwrap());
                assert!(low < exact && exact < high, "{request} {name}: {low} {exact} {high}");
                assert!((high - low) / exact < 2.1 * bound, "{request} {name}: {low} {high}");
            }
            let gap = &point["mean_gap"];
            assert_eq!(point["mean_gap_interval"], serde_json::json!([gap, gap]));
        }
    }
    let said = rough_contact(folder.path(), &format!("{solve} --gap 1mm --accuracy 5%"));
    assert_eq!((said.status, said.json()["points"][0]["area_fraction"].as_f64()), (1, Some(0.0)));
    assert!(said.err.contains("at a mean gap of 1\u{202F}mm nothing touches"), "{}", said.err);
}

/// Waves of two points, by pressure and by gap: twice the points are solved unasked, the interval holds the area on
/// four times the points, and the text says what they read. A load that does not depend on them is not solved twice.
#[test]
fn twice_the_points_are_solved_where_the_answer_depends_on_them() {
    let folder = folder();
    let solve = surface(folder.path(), 2.0, "");
    let text =
        rough_contact(folder.path(), &format!("{solve} --pressure 3MPa").replace("--json", ""));
    assert!(text.out.contains("twice the points read"), "{}", text.out);
    let fine = truths(folder.path(), &[3e6, 15e6]);
    let gaps: Vec<String> = fine.iter().map(|t| format!("{}m", t.gap)).collect();
    for loads in ["--pressure 3MPa,15MPa".to_owned(), format!("--gap {}", gaps.join(","))] {
        let answer = rough_contact(folder.path(), &format!("{solve} {loads}")).answered();
        for (point, truth) in answer["points"].as_array().unwrap().iter().zip(&fine) {
            for (name, exact) in [("area", truth.area), ("mean_pressure", truth.pressure)] {
                let interval = &point[format!("{name}_interval")];
                let [low, high] = [0, 1].map(|i| interval[i].as_f64().unwrap());
                let rounding = 1e-9 * exact;
                assert!(low <= exact + rounding && exact <= high + rounding, "{loads} {name}");
            }
            assert!(point["finer"]["area_fraction"].as_f64().unwrap() > 0.0);
            assert!(point["interpolation_indicator"].as_f64().unwrap() > 0.05);
        }
    }
    let resolved = surface(folder.path(), 12.0, "");
    let answer = rough_contact(folder.path(), &format!("{resolved} --pressure 10MPa"));
    assert_eq!(answer.answered()["points"][0]["finer"], Value::Null);
}

/// A study: its deterministic side on the grid that was chosen, models on the map as it is, the
/// line in the text, in the report and in the results; `run.toml` repeats the request.
#[test]
fn a_study_takes_a_request_and_repeats_it() {
    let folder = folder();
    surface(folder.path(), 12.0, "");
    let line = "compare map.npy --pixel 1um --height-unit m --modulus 1GPa --pressure 3MPa,10MPa \
                --accuracy 15% --json --quiet --threads 2";
    let first = rough_contact(folder.path(), &format!("{line} --out one")).answered();
    let study = &first["surfaces"][0]["deterministic"];
    let plan = &study["accuracy"];
    assert_eq!(plan["met"], true, "{plan}");
    assert_eq!(plan["given"], serde_json::json!([192, 192]));
    assert_eq!(plan["grid"], study["shape"]);
    assert!(plan["factor"].as_f64().unwrap() < 1.0, "{plan}");
    for point in study["points"].as_array().unwrap() {
        let [low, high] = [0, 1].map(|i| point["area_interval"][i].as_f64().unwrap());
        let area = point["area_fraction"].as_f64().unwrap();
        assert!((high - low) / area <= 0.3 && low < area && area < high);
    }
    // The models were given the map itself: the same inputs as in a study without a request.
    let plain = line.replace("--accuracy 15% ", "");
    let plain = rough_contact(folder.path(), &format!("{plain} --out plain")).answered();
    assert_eq!(first["surfaces"][0]["inputs"], plain["surfaces"][0]["inputs"]);
    assert_eq!(plain["surfaces"][0]["deterministic"]["accuracy"], Value::Null);

    let read = |name: &str| std::fs::read_to_string(folder.path().join(name)).unwrap();
    assert!(read("one/run.toml").contains("accuracy = 0.15"));
    let explanation = plan["explanation"].as_str().unwrap();
    assert!(read("one/report.html").contains(explanation), "{explanation}");

    let repeat = "compare --from one/run.toml --out two --json --quiet --threads 1";
    let second = rough_contact(folder.path(), repeat).answered();
    let again = &second["surfaces"][0]["deterministic"];
    assert_eq!(again["accuracy"]["grid"], plan["grid"]);
    for (a, b) in areas(study).iter().zip(areas(again)) {
        assert!((a / b - 1.0).abs() < 1e-9, "{a} {b}");
    }
    // The lightest load of a tight request is beyond the data: exit status 1, all of it written.
    let tight = line.replace("15%", "0.1%");
    let said = rough_contact(folder.path(), &format!("{tight} --out tight"));
    assert_eq!(said.status, 1, "{}", said.err);
    assert_eq!(said.json()["error"]["kind"], "accuracy_not_met");
    assert!(read("tight/report.html").contains("not met"));
}
