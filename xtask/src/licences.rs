//! The licences of what a program of ours is linked with: most ask that their text goes with it.

use crate::dependencies::tree;
use crate::shell::{TaskResult, packages, read};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Prints them for a package, for a target that its program is built for.
pub(crate) fn run(package: &str, target: &str) -> TaskResult {
    print!("{}", text(package, target)?);
    Ok(())
}

/// Each licence once, below the crates that come under it.
fn text(package: &str, target: &str) -> Result<String, String> {
    let known = known()?;
    let mut listed = String::new();
    let mut under: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for key in linked(package, target)? {
        let found = known.get(&key).ok_or_else(|| format!("cargo metadata has no {key}"))?;
        let (folder, licence) = found;
        let _ = writeln!(listed, "{key}: {licence}");
        let texts = texts(folder)?;
        if texts.is_empty() {
            let _ = writeln!(listed, "    (its package has no text; the licences named are below)");
        }
        for text in texts {
            under.entry(text).or_default().push(key.clone());
        }
    }
    let mut all = format!(
        "What {package} for {target} is linked with, besides its own crates and the standard library of\n\
         Rust (MIT or Apache-2.0, https://www.rust-lang.org/policies/licenses) and, on Linux, musl (MIT,\n\
         https://musl.libc.org).\n\n{listed}"
    );
    for (licence, crates) in under {
        let _ = write!(all, "\n{}\n{}\n\n{}\n", "-".repeat(80), crates.join(", "), licence.trim());
    }
    Ok(all)
}

/// Name and version of each crate from the registry that is linked.
fn linked(package: &str, target: &str) -> Result<BTreeSet<String>, String> {
    let lines = tree(package, "normal,no-proc-macro", target)?;
    let crates = lines.lines().filter_map(|line| {
        let (name, rest) = line.split_once(" v")?;
        // A crate that was listed before is marked; ours have their folder behind the version.
        let version = rest.strip_suffix(" (*)").unwrap_or(rest);
        (!version.contains(' ')).then(|| format!("{name} {version}"))
    });
    Ok(crates.collect())
}

/// Where the source of each crate lies, and its licence.
fn known() -> Result<BTreeMap<String, (PathBuf, String)>, String> {
    let of = |p: &Value| {
        let key = format!("{} {}", p["name"].as_str()?, p["version"].as_str()?);
        let folder = Path::new(p["manifest_path"].as_str()?).parent()?.to_owned();
        Some((key, (folder, p["license"].as_str().unwrap_or_default().to_owned())))
    };
    Ok(packages(&[])?.iter().filter_map(of).collect())
}

/// The texts of licences and notices in a folder.
fn texts(folder: &Path) -> Result<Vec<String>, String> {
    let entries = std::fs::read_dir(folder).map_err(|e| format!("no {}: {e}", folder.display()))?;
    let is_one = |name: &str| {
        let name = name.to_uppercase();
        ["LICENSE", "LICENCE", "COPYING", "COPYRIGHT", "NOTICE", "UNLICENSE"]
            .iter()
            .any(|start| name.starts_with(start))
    };
    let mut files: Vec<PathBuf> = entries
        .flatten()
        .filter(|e| e.path().is_file() && is_one(&e.file_name().to_string_lossy()))
        .map(|e| e.path())
        .collect();
    files.sort();
    files.iter().map(|file| Ok(read(file)?.replace("\r\n", "\n"))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_linked_is_listed_once_and_what_a_compiler_runs_is_not() {
        let text = text("rough-contact", "x86_64-unknown-linux-gnu").expect("cargo answers");
        let is_of = |line: &str, name: &str| line.starts_with(name) && line.contains(": ");
        let lines = |name: &str| text.lines().filter(|line| is_of(line, name)).count();
        for name in ["clap ", "faer ", "httparse ", "rayon ", "rustfft ", "zip "] {
            assert_eq!(lines(name), 1, "{name}");
        }
        for name in ["syn ", "thiserror-impl ", "tempfile ", "contact-types "] {
            assert_eq!(lines(name), 0, "{name}");
        }
        assert!(text.contains("Permission is hereby granted"), "the text of the MIT licence");
    }
}
