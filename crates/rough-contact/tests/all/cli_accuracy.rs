//! `--accuracy`: a request that is met, and requests that the data cannot support. That the intervals hold the truth is tested
//! in `contact-accuracy`.

use crate::cli::{TestFolder, ends, folder, has, list, number};
use serde_json::{Value, json};

const SOLVE: &str =
    "solve map.npy --level none --pixel 1um --height-unit m --modulus 1GPa --quiet --threads 1";

/// A surface of 192² points of 1 um with these shortest waves (um).
fn surface(cutoff: f64) -> TestFolder {
    let at = folder();
    let recipe = format!("--shape 192,192 --rolloff 48um --cutoff {cutoff}um --rms-gradient 0.1");
    at.synth("map.npy", &format!("{recipe} --seed 11"));
    at
}

fn areas(answer: &Value) -> Vec<f64> {
    list(&answer["points"]).iter().map(|p| number(&p["area_fraction"])).collect()
}

/// The areas lie within the request of those of the tightest, and all come with their intervals.
#[test]
fn the_rung_follows_the_request() {
    let at = &surface(12.0);
    let line = |percent: f64| format!("{SOLVE} --pressure 8MPa,2MPa,30MPa --accuracy {percent}%");
    let [tight, middle, loose] = [2.0, 5.0, 20.0].map(|percent| {
        let answer = at.answer(&line(percent));
        let plan = &answer["accuracy"];
        assert_eq!(plan["met"], true, "{plan}");
        assert!(number(&plan["half_width"]) <= percent / 100.0);
        for (of_plan, of_answer) in
            [("grid", "shape"), ("precision", "precision"), ("tolerance", "tolerance")]
        {
            assert_eq!(plan[of_plan], answer[of_answer]);
        }
        for point in list(&answer["points"]) {
            let [low, high] = ends(&point["area_interval"]);
            let area = number(&point["area_fraction"]);
            assert!((0.5 * (high - low) / area) <= percent / 100.0 && low < area && area < high);
        }
        answer
    });
    for (answer, percent) in [(&middle, 5.0), (&loose, 20.0)] {
        for (found, truth) in areas(answer).iter().zip(areas(&tight)) {
            assert!((found / truth - 1.0).abs() < percent / 100.0, "{percent} %: {found}");
        }
    }
    let sides = [&loose, &middle, &tight].map(|answer| answer["shape"][0].as_u64().unwrap());
    assert!(sides[0] < sides[2] && sides.is_sorted(), "{sides:?}");
    // The same choice again, on other threads, and without JSON one line of it.
    let again = at.answer(&line(5.0).replace("--threads 1", "--threads 3"));
    assert_eq!(again["shape"], middle["shape"]);
    let text = at.run(&line(5.0)).out;
    has(text.trim_end().lines().last().unwrap(), &["f32, tolerance 1e−3: ±", "next: "]);
}

/// `--fast` answers on every second point and says what the map itself would give.
#[test]
fn a_fast_answer_says_what_the_next_rung_gives() {
    let said = surface(12.0).done(&format!("{SOLVE} --pressure 8MPa --fast"));
    has(&said.out, &["96² of 192² points", "next: 192², about ±"]);
}

/// Waves of two points, contacts of a few: what was computed is printed, with exit status 1.
#[test]
fn what_the_data_cannot_support_is_said() {
    for (cutoff, load, why) in [
        (2.0, "5MPa", "the result depends on interpolation between points"),
        (4.0, "0.1MPa", "at 100\u{202F}kPa, and no finer grid"),
    ] {
        let said = surface(cutoff).run(&format!("{SOLVE} --pressure {load} --accuracy 1% --json"));
        let answer = said.json();
        assert_eq!(said.status, 1, "{why}: {answer}");
        let plan = &answer["accuracy"];
        assert_eq!(plan["met"], false);
        let reason = plan["reason"].as_str().unwrap();
        has(reason, &[why]);
        has(&said.err, &[reason]);
        assert_eq!(answer["error"]["kind"], "accuracy_not_met");
        assert!(areas(&answer)[0] > 0.0);
    }
}

/// One point says nothing about the area; contact everywhere has no line and no error of the grid.
#[test]
fn one_point_of_contact_is_no_accuracy_and_full_contact_is() {
    let at = &surface(12.0);
    let said = at.run(&format!("{SOLVE} --pressure 1mPa --accuracy 5% --json"));
    let answer = said.json();
    assert_eq!((said.status, &answer["accuracy"]["met"]), (1, &Value::Bool(false)), "{answer}");
    assert!(answer["accuracy"]["half_width"].as_f64().is_none_or(|width| width > 0.05));
    let answer = at.answer(&format!("{SOLVE} --pressure 10GPa --accuracy 0.1%"));
    assert_eq!(answer["points"][0]["area_fraction"], 1.0);
    assert_eq!(answer["accuracy"]["met"], true);
}

#[test]
fn what_cannot_be_planned_is_refused() {
    let at = &surface(8.0);
    at.refuses_each(
        &format!("{SOLVE} --pressure 1MPa"),
        &[
            ("--accuracy 2", &["'2'", "write a percentage", "2%"]),
            ("--accuracy 0%", &["0 %", "greater than 0"]),
            ("--accuracy 2% --tolerance 1e-3", &["--tolerance"]),
            ("--accuracy 2% --precision f32", &["--precision"]),
            ("--accuracy 2% --fast", &["--fast", "--accuracy"]),
            ("--refine", &["--refine", "unasked", "--accuracy"]),
            ("--accuracy 200%", &["200 %", "at most 50 %"]),
        ],
    );
    let free = format!("{SOLVE} --gap 10nm --accuracy 2% --boundary free");
    at.refuses(&free, &["--gap", "--boundary free", "--pressure"]);
}

/// A gap beyond the first contact is no accuracy; the message says where contact begins.
#[test]
fn a_given_gap_has_an_area_and_a_load_with_their_intervals() {
    let at = &surface(12.0);
    let pressed = at.answer(&format!("{SOLVE} --pressure 8MPa"))["points"][0].clone();
    for (request, bound) in [("--accuracy 3%", 0.03), ("", 0.1)] {
        let gap = &pressed["mean_gap"];
        let answer = at.answer(&format!("{SOLVE} --gap {gap}m {request}"));
        let point = &answer["points"][0];
        for name in ["area_fraction", "mean_pressure"] {
            let [low, high] = ends(&point[format!("{}_interval", name.replace("_fraction", ""))]);
            let value = number(&pressed[name]);
            assert!(low < value && value < high && (high - low) / value < 2.1 * bound, "{point}");
        }
        assert_eq!(point["mean_gap_interval"], json!([point["mean_gap"], point["mean_gap"]]));
    }
    let said = at.run(&format!("{SOLVE} --gap 1mm --accuracy 5% --json"));
    assert_eq!((said.status, areas(&said.json())), (1, vec![0.0]));
    has(&said.err, &["at a mean gap of 1\u{202F}mm nothing touches"]);
}

/// Waves of two points, unasked. What does not depend on them is not solved twice.
#[test]
fn twice_the_points_are_solved_where_the_answer_depends_on_them() {
    let at = &surface(2.0);
    has(&at.run(&format!("{SOLVE} --pressure 3MPa")).out, &["twice the points read"]);
    for loads in ["--pressure 3MPa,15MPa", "--gap 0.5um"] {
        for point in list(&at.answer(&format!("{SOLVE} {loads}"))["points"]) {
            assert!(number(&point["finer"]["area_fraction"]) > 0.0, "{point}");
            assert!(number(&point["interpolation_indicator"]) > 0.05);
        }
    }
    let resolved = surface(12.0).answer(&format!("{SOLVE} --pressure 10MPa"));
    assert_eq!(resolved["points"][0]["finer"], Value::Null);
}

/// The deterministic side on the grid that was chosen, models on the map as it is.
#[test]
fn a_study_takes_a_request() {
    let at = &surface(12.0);
    let study = |request: &str, out: &str| {
        format!(
            "compare map.npy --pixel 1um --height-unit m --modulus 1GPa --pressure 3MPa,10MPa --quiet \
             --threads 2 {request} --out {out}"
        )
    };
    let first = at.answer(&study("--accuracy 15%", "one"));
    let solved = &first["surfaces"][0]["deterministic"];
    let plan = &solved["accuracy"];
    assert_eq!(plan["met"], true, "{plan}");
    assert_eq!(plan["given"], json!([192, 192]));
    assert_eq!(plan["grid"], solved["shape"]);
    assert!(number(&plan["factor"]) < 1.0, "{plan}");
    for point in list(&solved["points"]) {
        let [low, high] = ends(&point["area_interval"]);
        let area = number(&point["area_fraction"]);
        assert!((high - low) / area <= 0.3 && low < area && area < high);
    }
    // The models were given the map itself: the same inputs as in a study without a request.
    let plain = at.answer(&study("", "plain"));
    assert_eq!(first["surfaces"][0]["inputs"], plain["surfaces"][0]["inputs"]);
    assert_eq!(plain["surfaces"][0]["deterministic"]["accuracy"], Value::Null);

    has(&at.read("one/report.html"), &[plan["explanation"].as_str().unwrap()]);
    // The lightest load of a tight request is beyond the data: exit status 1, all of it written.
    let said = at.run(&study("--accuracy 0.1% --json", "tight"));
    assert_eq!(said.status, 1, "{}", said.err);
    assert_eq!(said.json()["error"]["kind"], "accuracy_not_met");
    // With the map at each load, though one grid was left for another.
    has(&at.read("tight/report.html"), &["not met", "Contact map at"]);
}
