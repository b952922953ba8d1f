//! Checks of the architecture that no compiler makes. `docs/src/architecture.md` says why.

use crate::TaskResult;
use crate::dependencies::{LAYERS, brought_along};
use crate::shell::{cargo, files, output, root};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// A file longer than this is reported: think again whether it is about one thing.
const LONG_FILE: usize = 500;

pub(crate) fn run(args: &[String]) -> TaskResult {
    if !args.is_empty() {
        return Err(format!("unknown arguments {args:?}; tidy takes none"));
    }
    let mut faults = Vec::new();
    let packages = packages()?;
    layers(&packages, &mut faults);
    dependency_counts(&packages, &mut faults)?;
    sources(&mut faults);
    models(&mut faults);
    book(&mut faults);
    if faults.is_empty() {
        println!("tidy: no faults");
        return Ok(());
    }
    for fault in &faults {
        println!("tidy: {fault}");
    }
    Err(format!("{} faults", faults.len()))
}

/// The packages of this workspace, by name.
fn packages() -> Result<BTreeMap<String, Value>, String> {
    let text =
        output(cargo().args(["metadata", "--no-deps", "--locked", "--format-version", "1"]))?;
    let metadata: Value =
        serde_json::from_str(&text).map_err(|e| format!("cargo metadata is not JSON: {e}"))?;
    let packages = metadata["packages"].as_array().ok_or("cargo metadata names no packages")?;
    Ok(packages.iter().filter_map(|p| Some((p["name"].as_str()?.to_owned(), p.clone()))).collect())
}

/// Every edge between our crates is in the picture. Tests may look sideways and down, not up.
fn layers(packages: &BTreeMap<String, Value>, faults: &mut Vec<String>) {
    let layer = |name: &str| LAYERS.iter().find(|row| row.0 == name);
    for (name, package) in packages {
        let Some(&(_, level, allowed, _)) = layer(name) else {
            faults.push(format!("crate {name} is not in the layer picture"));
            continue;
        };
        for dependency in package["dependencies"].as_array().into_iter().flatten() {
            let to = dependency["name"].as_str().unwrap_or_default();
            if !packages.contains_key(to) {
                continue;
            }
            if dependency["kind"] == "dev" {
                if layer(to).is_some_and(|row| row.1 > level) {
                    faults.push(format!("the tests of {name} use {to}, a layer above it"));
                }
            } else if !allowed.contains(&to) {
                faults.push(format!("{name} depends on {to}: not in the layer picture"));
            }
        }
    }
}

/// How many registry crates each of ours brings along, against its limit.
fn dependency_counts(packages: &BTreeMap<String, Value>, faults: &mut Vec<String>) -> TaskResult {
    println!("registry crates that each crate brings along (limit)");
    for &(name, _, _, limit) in LAYERS.iter().filter(|row| packages.contains_key(row.0)) {
        let count = brought_along(name)?.from_registry.len();
        println!("  {name:<18} {count:>3} ({limit})");
        if count > limit {
            faults.push(format!("{name} brings {count} registry crates, limit {limit}"));
        }
    }
    Ok(())
}

/// Long files, printing and file access in libraries, unfinished work.
fn sources(faults: &mut Vec<String>) {
    let mut long = Vec::new();
    for path in
        files(&root().join("crates"), "rs").iter().chain(&files(&root().join("xtask"), "rs"))
    {
        let Ok(text) = std::fs::read_to_string(path) else { continue };
        let shown = relative(path);
        let lines = text.lines().count();
        if lines > LONG_FILE {
            long.push((lines, shown.clone()));
        }
        for (number, line) in text.lines().enumerate() {
            let at = format!("{shown}:{}", number + 1);
            if line.contains(concat!("TO", "DO")) || line.contains(concat!("FIX", "ME")) {
                faults.push(format!("{at}: unfinished work belongs in an issue"));
            }
        }
        if is_library(&shown) && !is_test_module(path) {
            library_source(&shown, &text, faults);
        }
    }
    long.sort_by(|a, b| b.cmp(a));
    println!("files over {LONG_FILE} lines: {}", long.len());
    for (lines, path) in long {
        println!("  {lines:>5}  {path}");
    }
}

/// Only the command prints; only `surface-io` and the command touch files.
fn library_source(shown: &str, text: &str, faults: &mut Vec<String>) {
    let library = text.split("#[cfg(test)]").next().unwrap_or_default();
    for (number, line) in library.lines().enumerate() {
        let code = line.trim_start();
        if code.starts_with("//") {
            continue;
        }
        let at = format!("{shown}:{}", number + 1);
        if ["println!", "print!", "eprintln!", "eprint!", "dbg!"].iter().any(|p| code.contains(p)) {
            faults.push(format!("{at}: a library does not print"));
        }
        let touches = ["std::fs", "File::open", "File::create"].iter().any(|p| code.contains(p));
        if touches && !shown.starts_with("crates/surface-io/") {
            faults.push(format!("{at}: only surface-io and the command touch files"));
        }
    }
}

/// True for a file that its folder declares under `#[cfg(test)]`.
fn is_test_module(path: &Path) -> bool {
    let (Some(folder), Some(name)) = (path.parent(), path.file_stem()) else { return false };
    let declaration = format!("#[cfg(test)]\nmod {};", name.to_string_lossy());
    ["mod.rs", "lib.rs"].iter().any(|parent| {
        std::fs::read_to_string(folder.join(parent)).is_ok_and(|text| text.contains(&declaration))
    })
}

fn is_library(shown: &str) -> bool {
    shown.starts_with("crates/")
        && shown.contains("/src/")
        && !shown.starts_with("crates/rough-contact/")
}

/// Every type that implements `ContactModel` has a DOI in its file and a page in the book that
/// names it.
fn models(faults: &mut Vec<String>) {
    let pages: String = files(&root().join("docs/src/models"), "md")
        .iter()
        .filter_map(|page| std::fs::read_to_string(page).ok())
        .collect();
    let mut found = 0;
    for krate in ["gw-closed-form", "asperity-models", "multiscale-models"] {
        for path in files(&root().join("crates").join(krate).join("src"), "rs") {
            let text = std::fs::read_to_string(&path).unwrap_or_default();
            let shown = relative(&path);
            for line in text.lines() {
                let Some(rest) = line.trim().strip_prefix("impl ContactModel for ") else {
                    continue;
                };
                let name = rest.trim_end_matches('{').trim();
                found += 1;
                if !text.contains("10.") || !text.to_lowercase().contains("doi") {
                    faults.push(format!("{shown}: {name} gives no DOI"));
                }
                if !pages.contains(name) {
                    faults.push(format!("{name} has no page in docs/src/models"));
                }
            }
        }
    }
    println!("contact models: {found}");
}

/// Every page is in the table of contents, and every entry of it exists.
fn book(faults: &mut Vec<String>) {
    let source = root().join("docs/src");
    let contents = std::fs::read_to_string(source.join("SUMMARY.md")).unwrap_or_default();
    let listed: BTreeSet<&str> = contents
        .split("](")
        .skip(1)
        .filter_map(|tail| tail.split(')').next())
        .filter(|target| !target.is_empty())
        .collect();
    for target in &listed {
        if !source.join(target).is_file() {
            faults.push(format!("docs/src/SUMMARY.md lists {target}, which is missing"));
        }
    }
    let text = |path: &str| std::fs::read_to_string(root().join(path)).unwrap_or_default();
    if text("docs/theme/head.hbs") != text("docs/katex-header.html") {
        faults.push("docs/theme/head.hbs is not docs/katex-header.html".to_owned());
    }
    for page in files(&source, "md") {
        let shown = relative(&page);
        let name = shown.trim_start_matches("docs/src/");
        if name != "SUMMARY.md" && !listed.contains(name) {
            faults.push(format!("{shown} is not listed in docs/src/SUMMARY.md"));
        }
    }
}

fn relative(path: &Path) -> String {
    let path = path.strip_prefix(root()).unwrap_or(path);
    path.to_string_lossy().replace('\\', "/")
}
