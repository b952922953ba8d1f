//! The same questions to the command, to the engine of the page and to `rough-contact app`: every number is compared. Python is
//! asked the same in `crates/python/tests/test_questions.py`, the page in a browser in `crates/web/tests/questions.test.mjs`.

use crate::cli::app::RunningApp;
use crate::cli::{RunOutput, folder, list, number, timeless};
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
    for body in list(&question["bodies"]) {
        for key in ["material", "young", "poisson"] {
            line += &word(body, key).map_or_else(String::new, |value| format!(" --{key} {value}"));
        }
    }
    let keys = "hardness pressure load area pixel lateral_unit height_unit level edges outliers fill crop \
                layout resistivity against";
    for key in keys.split_whitespace() {
        let usual = (key == "fill").then(|| "harmonic".to_owned());
        let value = word(question, key).or(usual);
        let option = key.replace('_', "-");
        line += &value.map_or_else(String::new, |value| format!(" --{option} {value}"));
    }
    line + " --threads 1 --quiet"
}

/// As the page asks.
fn request(question: &Value) -> Value {
    let text = |key: &str| word(question, key).unwrap_or_default();
    let bodies = list(&question["bodies"]).iter().map(|body| {
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

fn kind(said: &RunOutput) -> Value {
    assert_eq!(said.status, 2, "{}", said.err);
    said.json()["error"]["kind"].clone()
}

/// The last message: by the engine in this process, and by the program over its socket.
fn asked(app: &RunningApp, request: &Value, file: &[u8]) -> [Value; 2] {
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
    let at = &folder();
    for entry in std::fs::read_dir(data()).expect("files").flatten() {
        std::fs::copy(entry.path(), at.path().join(entry.file_name())).expect("a copy");
    }
    let app = RunningApp::start(at.path());
    let all = questions();
    assert!(all.len() >= 20);
    for (i, question) in all.iter().enumerate() {
        let name = &question["name"];
        let command = at.run(&format!("compare {} --json --out {i}", options(question)));
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
        assert_eq!(command.status, 0, "{name}: {}", command.err);
        let command = command.json();
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
                let [found, command] = [&found, &command]
                    .map(|results| timeless(&results[key], &["speed", "explanation"]));
                assert_eq!(found, command, "{name}: {key}");
            }
        }
        let hardness = &command["settings"]["hardness"];
        match question["hardness_is"].as_f64() {
            None => assert!(hardness.is_null(), "{name}: {hardness}"),
            Some(is) => assert!((number(hardness) / is - 1.0).abs() < 2e-3, "{name}: {hardness}"),
        }
        let solved = at.answer(&format!("solve {}", options(question)));
        let points = list(&solved["points"]);
        let studied = &command["surfaces"][0]["deterministic"]["points"];
        assert_eq!(list(studied).len(), points.len(), "{name}");
        for (i, point) in points.iter().enumerate() {
            for key in ["mean_pressure", "area_fraction", "mean_gap"] {
                let (a, b) = (number(&point[key]), number(&studied[i][key]));
                assert!((a / b - 1.0).abs() < 1e-9, "{name}, {key}: solve {a}, compare {b}");
            }
        }
    }
}
