//! The engine built for this machine, asked as the page asks it.

use contact_compare::{Comparison, Settings, built_in, built_in_recipes};
use contact_web::{Host, Messages, answer};
use serde_json::{Value, json};
use std::io::Cursor;
use std::ops::ControlFlow;
use surface_io::write;

/// All messages to one question.
fn asked(question: &str, request: &Value, file: &[u8]) -> Vec<Value> {
    let mut out = Vec::new();
    let mut messages = Messages::new(&mut out);
    answer(question, &request.to_string(), file, Host::BROWSER, &mut messages);
    messages.end().expect("memory takes it");
    let text = String::from_utf8(out).expect("JSON is text");
    text.lines().map(|line| serde_json::from_str(line).expect("one object a line")).collect()
}

fn last(question: &str, request: &Value, file: &[u8]) -> Value {
    asked(question, request, file).pop().expect("an answer")
}

/// A map of 48 × 64 points, as the files of two formats.
fn files() -> [Vec<u8>; 2] {
    let mut recipe = built_in_recipes().remove(1);
    (recipe.shape, recipe.rolloff) = ([48, 64], 3e-5);
    let map = recipe.make().expect("a map").heights;
    let (mut x3p, mut npy) = (Cursor::new(Vec::new()), Vec::new());
    write::x3p(&mut x3p, &map, "").expect("memory takes it");
    write::npy(&mut npy, map.grid().shape(), map.heights()).expect("memory takes it");
    [x3p.into_inner(), npy]
}

#[test]
fn a_file_is_inspected_planned_and_run_as_planned() {
    let [x3p, _] = files();
    let request = json!({ "name": "a.x3p" });
    let found = last("inspect", &request, &x3p);
    assert_eq!((&found["kind"], &found["state"]), (&json!("done"), &json!("read")));
    let plan = last("plan", &json!({ "name": "a.x3p", "facts": found["plan"] }), &[]);
    let messages = asked("run", &request, &x3p);
    let loads = messages.iter().filter(|m| m["stage"] == "load").count();
    assert_eq!(plan["count"], loads, "as many loads as were promised");
    let results = messages.last().and_then(|m| m["files"]["results.json"].as_str()).expect("done");
    let results: Value = serde_json::from_str(results).expect("JSON");
    let points = results["surfaces"][0]["deterministic"]["points"].as_array().expect("points");
    assert_eq!(points.len(), loads);
}

#[test]
fn a_built_in_surface_gives_the_numbers_of_the_study() {
    let load = json!({ "by": "pressure", "list": "100MPa" });
    let done = last("run", &json!({ "example": "ground", "load": load }), &[]);
    let found: Value =
        serde_json::from_str(done["files"]["results.json"].as_str().expect("done")).expect("JSON");
    let recipe = built_in_recipes().remove(1);
    let settings = Settings { pressures: Some(vec![1e8]), ..Settings::default() };
    let mut quiet = |_: contact_compare::Progress<'_>| ControlFlow::Continue(());
    let surface = recipe.make().expect("a map");
    let direct = Comparison::run(vec![surface], settings, built_in(), &mut quiet).expect("a study");
    let answer = direct.surfaces[0].headline_answer().expect("an answer");
    let area = &found["surfaces"][0]["deterministic"]["points"][0]["area_fraction"];
    assert!((area.as_f64().expect("a number") - answer.area_fraction).abs() < 1e-15);
}

#[test]
fn what_a_file_does_not_say_is_asked_for_and_its_meaning_told() {
    let [_, npy] = files();
    let asked = last("inspect", &json!({ "name": "a.npy" }), &npy);
    assert_eq!(asked["state"], "ask");
    assert_eq!(asked["needs"], json!(["pixel", "height_unit"]));
    let meaning = |pixel: &str, unit: &str| {
        let reading = json!({ "pixel": pixel, "height_unit": unit });
        last("meaning", &json!({ "reading": reading, "raw": asked["raw"] }), &[])
    };
    assert_eq!(meaning("1um", "m")["tag"], "passed");
    assert_eq!(meaning("1um", "nm")["tag"], "check", "metres are no nanometres");
    assert_eq!(meaning("0um", "m")["kind"], "error");
}

#[test]
fn what_cannot_be_answered_is_said_with_a_way_out() {
    let refused = last("inspect", &json!({ "name": "a.txt" }), b"no height map");
    assert_eq!(refused["kind"], "error");
    assert!(refused["ways"].as_array().is_some_and(|ways| !ways.is_empty()));
    let rigid = json!([{ "young": "∞", "poisson": "0" }, { "young": "∞", "poisson": "0" }]);
    let rigid = last("plan", &json!({ "bodies": rigid }), &[]);
    assert!(rigid["text"].as_str().is_some_and(|t| t.contains("Two rigid bodies")));
    assert_eq!(last("what", &json!({}), &[])["failure"]["kind"], "internal");
}
