//! What repeats what the code knows: tables of models and formats in the book, the numbers of Python's statistics.

use crate::generated::{check_flag, keep_section};
use crate::shell::{TaskResult, output, read, root, rough_contact};
use serde_json::Value;
use std::fmt::Write;

/// Writes the tables, or checks that they are current.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let check = check_flag(args)?;
    let models = list("model")?;
    keep_section("docs/src/models.md", "models", &model_table(&models), check)?;
    let formats = list("info")?;
    keep_section("docs/src/formats.md", "formats", &format_table(&formats), check)?;
    let statistics = read(&root().join("crates/surface-stats/src/statistics.rs"))?;
    let python = "crates/python/python/rough_contact/_statistics.py";
    keep_section(python, "numbers", &python_numbers(&statistics), check)
}

/// The fields of Python's `Statistics`: one for each number of the table `STATISTICS` in a source text.
fn python_numbers(source: &str) -> String {
    let mut lines = String::new();
    let rest = source.split("pub const STATISTICS").nth(1).unwrap_or_default();
    let table = rest.split("\n];").next().unwrap_or_default();
    for call in table.split(" number(").skip(1) {
        let mut texts = call.split('"').skip(1).step_by(2);
        let (key, unit) = (texts.next().unwrap_or_default(), texts.nth(2).unwrap_or_default());
        let unit = if unit.is_empty() { "1" } else { &unit.replace('²', "2").replace('⁻', "-") };
        let absent = if call.contains("Some(") { "" } else { " | None" };
        let _ =
            writeln!(lines, "    {key}: float{absent} = field(metadata={{\"unit\": \"{unit}\"}})");
    }
    lines
}

/// What `rough-contact COMMAND --list --json` prints.
fn list(command: &str) -> Result<Value, String> {
    let text = output(rough_contact(false).args([command, "--list", "--json"]))?;
    serde_json::from_str(&text).map_err(|e| format!("{command} --list is not JSON: {e}"))
}

fn model_table(list: &Value) -> String {
    let mut table = String::from("| name | theory | inputs | domain |\n|---|---|---|---|\n");
    for model in list["models"].as_array().into_iter().flatten() {
        let text = |key: &str| model[key].as_str().unwrap_or_default().to_owned();
        let name = text("name");
        let citation = &model["citation"];
        let authors = citation["authors"].as_str().unwrap_or_default();
        let _ = writeln!(
            table,
            "| [`{name}`](models/{}.md) | {authors} ({}) | {} | {} |",
            page(&name),
            citation["year"],
            text("inputs"),
            text("domain")
        );
    }
    table
}

/// The page of a model: its name, or that name in full.
fn page(name: &str) -> &str {
    match name {
        "gw" | "ceb" => "greenwood-williamson",
        "persson-yield" => "persson",
        "cmy" | "mikic" => "joint",
        "yan-komvopoulos" => "majumdar-bhushan",
        "bgt" => "bush-gibson-thomas",
        other => other,
    }
}

fn format_table(list: &Value) -> String {
    let mut table = String::from("| format | usual endings | about |\n|---|---|---|\n");
    for format in list["formats"].as_array().into_iter().flatten() {
        let text = |key: &str| format[key].as_str().unwrap_or_default().to_owned();
        let endings: Vec<String> = format["extensions"]
            .as_array()
            .into_iter()
            .flatten()
            .filter_map(Value::as_str)
            .map(|ending| format!("`.{ending}`"))
            .collect();
        let _ = writeln!(table, "| {} | {} | {} |", text("name"), endings.join(" "), text("about"));
    }
    table
}
