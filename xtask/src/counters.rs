//! What the project weighs, against the limits in `xtask/counters.toml`: lower them as it gets lighter, never raise them.

use crate::shell::{files, read, root};
use std::collections::BTreeMap;
use std::path::Path;

const LIMITS: &str = "xtask/counters.toml";

/// Crates that talk to a person, or are not published: their public names are nobody's interface.
const INSIDE: [&str; 5] =
    ["crates/python/", "crates/rough-contact/", "crates/studies/", "crates/web/", "xtask/"];

/// Enums whose variants are diagnostics: a warning, a finding, or a reason for no answer or no uncertainty.
const DIAGNOSTICS: [&str; 5] = ["Fact", "NoUncertainty", "ProfileFact", "Reason", "Warning"];

/// Prints each number with its limit; a number above its limit, or without one, is a fault.
pub(crate) fn check(sources: &[(String, String)], faults: &mut Vec<String>) {
    let text = match read(&root().join(LIMITS)) {
        Ok(text) => text,
        Err(message) => return faults.push(message),
    };
    let limits = limits(&text);
    println!("what the project weighs (limit)");
    for (name, number) in numbers(sources) {
        let limit = limits.get(name).copied();
        println!("  {name:<18} {number:>9} ({})", limit.unwrap_or(0));
        match limit {
            None => faults.push(format!("{LIMITS} has no '{name}', which is {number}")),
            Some(limit) if number > limit => faults.push(format!(
                "{name}: {number}, limit {limit} ({LIMITS}): take something away for what was added"
            )),
            Some(_) => {}
        }
    }
}

fn numbers(sources: &[(String, String)]) -> [(&'static str, usize); 8] {
    let text = |path: &Path| std::fs::read_to_string(path).unwrap_or_default();
    let words = |text: String| text.split_whitespace().count();
    let book = files(&root().join("docs/src"), "md");
    let codes: usize =
        DIAGNOSTICS.iter().flat_map(|e| sources.iter().map(|s| variants(e, &s.1))).sum();
    let public = sources.iter().filter(|(shown, _)| {
        shown.contains("/src/") && !INSIDE.iter().any(|place| shown.starts_with(place))
    });
    let tuned =
        sources.iter().filter(|(shown, _)| shown.starts_with("crates/contact-accuracy/src/"));
    [
        ("rust-lines", sources.iter().map(|(_, text)| text.lines().count()).sum()),
        ("book-words", book.iter().map(|page| words(text(page))).sum()),
        ("readme-words", words(text(&root().join("README.md")))),
        ("changelog-words", words(text(&root().join("CHANGELOG.md")))),
        ("fixtures-bytes", bytes(&root().join("fixtures"))),
        ("public-names", public.map(|(_, text)| public_names(text)).sum()),
        ("tuned-constants", tuned.map(|(_, text)| tuned_numbers(text)).sum()),
        ("diagnostics", codes),
    ]
}

/// Lines `name = number`, with or without a comment.
fn limits(text: &str) -> BTreeMap<&str, usize> {
    text.lines()
        .filter_map(|line| {
            let (name, rest) = line.split('#').next()?.split_once('=')?;
            Some((name.trim(), rest.trim().replace('_', "").parse().ok()?))
        })
        .collect()
}

/// Size of all files below a folder but what was built there.
fn bytes(folder: &Path) -> usize {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    entries
        .filter(|entry| entry.file_name() != "target" && entry.file_name() != "Cargo.lock")
        .map(|entry| match entry.metadata() {
            Ok(data) if data.is_dir() => bytes(&entry.path()),
            Ok(data) => usize::try_from(data.len()).unwrap_or(usize::MAX),
            Err(_) => 0,
        })
        .sum()
}

/// The part of a file that is no test.
fn code(text: &str) -> impl Iterator<Item = &str> {
    let code = text.split("#[cfg(test)]").next().unwrap_or_default();
    code.lines().map(|line| line.split("//").next().unwrap_or_default())
}

/// Public items and methods of a file; fields and variants are not counted.
pub(crate) fn public_names(text: &str) -> usize {
    let kinds = ["fn ", "struct ", "enum ", "trait ", "const ", "type ", "static "];
    let named = |line: &str| {
        line.trim_start()
            .strip_prefix("pub ")
            .is_some_and(|rest| kinds.iter().any(|kind| rest.starts_with(kind)))
    };
    code(text).filter(|line| named(line)).count()
}

/// Decimal numbers in code that are no round ones: each is a choice that somebody made.
fn tuned_numbers(text: &str) -> usize {
    code(text)
        .flat_map(|line| line.split(|c: char| !(c.is_ascii_alphanumeric() || c == '.' || c == '_')))
        .filter(|word| word.starts_with(|c: char| c.is_ascii_digit()) && word.contains('.'))
        .filter_map(|word| word.trim_end_matches("f64").trim_end_matches('.').parse::<f64>().ok())
        .filter(|number| ![0.0, 0.5, 1.0, 2.0, 3.0, 4.0, 100.0].contains(number))
        .count()
}

/// How many variants the enum of this name has, if it is declared in the text.
fn variants(name: &str, text: &str) -> usize {
    let Some((_, body)) = text.split_once(&format!("\npub enum {name} {{\n")) else { return 0 };
    let body = body.split("\n}").next().unwrap_or_default();
    let begins = |line: &&str| {
        line.strip_prefix("    ")
            .is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_uppercase()))
    };
    body.lines().filter(begins).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_those_that_a_reader_counts() {
        let text = "pub fn a() -> f64 {\n    0.37 * b(1.0, 12.5) // 0.99\n}\npub(crate) fn c() {}\n\
                    pub enum Warning {\n    /// One.\n    One,\n    /// Two.\n    Two {\n        Field: u8,\n    },\n}\n\
                    #[cfg(test)]\npub fn d() { 0.77 }\n";
        assert_eq!(public_names(text), 2);
        assert_eq!(tuned_numbers(text), 2);
        assert_eq!(variants("Warning", text), 2);
        assert_eq!(variants("Warn", text), 0);
        assert_eq!(limits("# x\na = 1_200 # words\nb=3\n")["a"], 1200);
    }
}
