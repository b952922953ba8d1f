//! The same questions to the command, to the engine of the page and to `rough-contact app`: every number is compared. Python is
//! asked the same in `crates/python/tests/test_questions.py`, the page in a browser in `crates/web/tests/questions.test.mjs`.

use crate::cli;

use cli::app::App;
use cli::{Said, folder, number, rough_contact};
use contact_web::{Host, Messages, answer};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// Where files and questions are.
fn data() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/questions")
}

fn questions() -> Vec<Value> {
    let text = std::fs::read_to_string(data().join("questions.json")).expect("the questions");
    serde_json::from_str(&text).expect("JSON")
}

fn word(question: &Value, key: &str) -> Option<String> {
    match &question[key] {
        Value::Null => None,
        Value::String(text) => Some(text.replace(' ', "")),
        Value::Array(all) => {
            Some(all.iter().filter_map(Value::as_str).collect::<Vec<_>>().join(","))
        }
        other => Some(other.to_string()),
    }
}

/// As options of `compare` and `solve`.
fn options(question: &Value) -> String {
    let mut line = word(question, "file").expect("a file");
    for body in question["bodies"].as_array().expect("bodies") {
        for key in ["material", "young", "poisson"] {
            line += &word(body, key).map_or_else(String::new, |value| format!(" --{key} {value}"));
        }
    }
    for (key, usual) in [
        ("hardness", None),
        ("pressure", None),
        ("load", None),
        ("area", None),
        ("pixel", None),
        ("lateral_unit", None),
        ("height_unit", None),
        ("level", None),
        ("edges", None),
        ("outliers", None),
        ("fill", Some("harmonic")),
        ("crop", None),
        ("layout", None),
        ("resistivity", None),
        ("against", None),
    ] {
        let value = word(question, key).or(usual.map(str::to_owned));
        let option = key.replace('_', "-");
        line += &value.map_or_else(String::new, |value| format!(" --{option} {value}"));
    }
    line + " --threads 1 --json --quiet"
}

/// As the page asks.
fn request(question: &Value) -> Value {
    let text = |key: &str| word(question, key).unwrap_or_default();
    let bodies = question["bodies"].as_array().expect("bodies").iter().map(|body| {
        let text = |key: &str| word(body, key).unwrap_or_default();
        json!({ "material": text("material"), "young": text("young"), "poisson": text("poisson") })
    });
    let of = &question["resistivity"];
    let by = if question["load"].is_null() { "pressure" } else { "force" };
    let list = if by == "force" { text("load") } else { text("pressure") };
    json!({
        "name": text("file"),
        "bodies": bodies.collect::<Vec<_>>(),
        "hardness": text("hardness"),
        "resistivities": [of[0].as_str().unwrap_or(""), of[1].as_str().unwrap_or("")],
        "load": { "by": by, "list": list, "area": text("area") },
        "reading": {
            "pixel": question["pixel"], "lateral_unit": question["lateral_unit"],
            "height_unit": question["height_unit"], "part": question["crop"],
            "layout": question["layout"],
        },
        "remedies": {
            "spikes": !question["outliers"].is_null(),
            "plane": question["level"].is_null(),
            "mirror": question["edges"] == "mirrored",
            "fill": if text("fill").is_empty() { "harmonic".to_owned() } else { text("fill") },
        },
    })
}

/// Without what a clock makes different.
fn timeless(value: &Value) -> Value {
    match value {
        Value::Object(map) => {
            let kept = map.iter().filter(|(key, _)| {
                !key.contains("seconds") && !["speed", "explanation"].contains(&key.as_str())
            });
            Value::Object(kept.map(|(key, value)| (key.clone(), timeless(value))).collect())
        }
        Value::Array(list) => list.iter().map(timeless).collect(),
        other => other.clone(),
    }
}

fn kind(said: &Said) -> Value {
    assert_eq!(said.status, 2, "{}", said.err);
    said.json()["error"]["kind"].clone()
}

/// The last message: by the engine in this process, and by the program over its socket.
fn asked(app: &App, request: &Value, file: &[u8]) -> [Value; 2] {
    let mut out = Vec::new();
    let mut messages = Messages::new(&mut out);
    answer("run", &request.to_string(), file, Host::machine(1), &mut messages);
    messages.end().expect("memory takes it");
    let text = String::from_utf8(out).expect("text");
    let engine = serde_json::from_str(text.lines().last().expect("a message")).expect("JSON");
    [engine, app.asked("run", &request.to_string(), file)]
}

#[test]
fn all_front_ends_give_the_same_numbers() {
    let dir = folder();
    for entry in std::fs::read_dir(data()).expect("files").flatten() {
        std::fs::copy(entry.path(), dir.path().join(entry.file_name())).expect("a copy");
    }
    let app = App::start(dir.path());
    let all = questions();
    assert!(all.len() >= 20);
    for (i, question) in all.iter().enumerate() {
        let name = &question["name"];
        let command =
            rough_contact(dir.path(), &format!("compare {} --out {i}", options(question)));
        let of_page = question["against"].is_null();
        let file = std::fs::read(data().join(word(question, "file").expect("a file")));
        let answers = of_page.then(|| asked(&app, &request(question), &file.expect("it is there")));
        if let Some(refused) = question.get("refused") {
            assert_eq!(&kind(&command), refused, "{name}");
            for answer in answers.into_iter().flatten() {
                assert_eq!(&answer["failure"]["kind"], refused, "{name}: {answer}");
            }
            continue;
        }
        let command = command.answered();
        if command["surfaces"].is_null() {
            // Of a line the page tells nothing; the command does.
            for answer in answers.into_iter().flatten() {
                assert_eq!(answer["failure"]["kind"], "profile", "{name}: {answer}");
            }
            continue;
        }
        for answer in answers.into_iter().flatten() {
            let results = answer["files"]["results.json"].as_str();
            let results = results.unwrap_or_else(|| panic!("{name}: {answer}"));
            let found: Value = serde_json::from_str(results).expect("JSON");
            for key in ["settings", "surfaces", "materials"] {
                assert_eq!(timeless(&found[key]), timeless(&command[key]), "{name}: {key}");
            }
        }
        let hardness = &command["settings"]["hardness"];
        match question["hardness_is"].as_f64() {
            None => assert!(hardness.is_null(), "{name}: {hardness}"),
            Some(is) => assert!((number(hardness) / is - 1.0).abs() < 2e-3, "{name}: {hardness}"),
        }
        let solved = rough_contact(dir.path(), &format!("solve {}", options(question))).answered();
        let points = solved["points"].as_array().expect("points");
        let studied = &command["surfaces"][0]["deterministic"]["points"];
        assert_eq!(studied.as_array().map(Vec::len), Some(points.len()), "{name}");
        for (i, point) in points.iter().enumerate() {
            for key in ["mean_pressure", "area_fraction", "mean_gap"] {
                let (a, b) = (number(&point[key]), number(&studied[i][key]));
                assert!((a / b - 1.0).abs() < 1e-9, "{name}, {key}: solve {a}, compare {b}");
            }
        }
    }
}
