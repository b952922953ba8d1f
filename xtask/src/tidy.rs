//! Checks of the architecture that no compiler makes. `docs/src/architecture.md` says why.

use crate::circles;
use crate::counters;
use crate::dependencies::{LAYERS, brought_along};
use crate::release;
use crate::shell::{self, TaskResult, files, root};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// A file longer than this is about more than one thing.
const LONG_FILE: usize = 500;

/// What Linux says in the form of a file is no file: here a solver asks how much memory there is before it takes any.
const ASKS_LINUX: &str = "crates/fft-bem-solver/src/memory.rs";

/// Half of the files are at most this long.
const MEDIAN_FILE: usize = 250;

/// Folders of crates that talk to a person; all others are libraries.
const TALKING: [&str; 3] = ["rough-contact", "studies", "web"];

pub(crate) fn run() -> TaskResult {
    let mut faults = Vec::new();
    let by_name = |p: Value| Some((p["name"].as_str()?.to_owned(), p));
    let packages = shell::packages(&["--no-deps"])?.into_iter().filter_map(by_name).collect();
    layers(&packages, &mut faults);
    dependency_counts(&packages, &mut faults)?;
    let all = read_sources();
    sources(&all, &mut faults);
    rooms(&all, &mut faults);
    models(&all, &mut faults);
    type_names(&all, &mut faults);
    book(&mut faults);
    release::versions(&mut faults);
    paper(&mut faults);
    terms(&mut faults);
    counters::check(&all, &mut faults);
    if faults.is_empty() {
        println!("tidy: no faults");
        return Ok(());
    }
    for fault in &faults {
        println!("tidy: {fault}");
    }
    Err(format!("{} faults", faults.len()))
}

/// Crates that only a command needs.
const COMMAND_LINE: [&str; 4] = ["clap", "clap_builder", "console", "indicatif"];

/// Every edge between our crates is in the picture. Tests may look sideways and down, not up.
fn layers(packages: &BTreeMap<String, Value>, faults: &mut Vec<String>) {
    let layer = |name: &str| LAYERS.iter().find(|row| row.0 == name);
    for (name, package) in packages {
        let Some(&(_, level, _, allowed)) = layer(name) else {
            faults.push(format!("crate {name} is not in the layer picture"));
            continue;
        };
        for dependency in package["dependencies"].as_array().into_iter().flatten() {
            let to = dependency["name"].as_str().unwrap_or_default();
            let (is_ours, is_test) = (packages.contains_key(to), dependency["kind"] == "dev");
            if is_ours && is_test && layer(to).is_some_and(|row| row.1 > level) {
                faults.push(format!("the tests of {name} use {to}, a layer above it"));
            }
            if is_ours && !is_test && !allowed.split(' ').any(|name| name == to) {
                faults.push(format!("{name} depends on {to}: not in the layer picture"));
            }
        }
    }
}

/// How many registry crates each of ours brings along, against its limit.
fn dependency_counts(packages: &BTreeMap<String, Value>, faults: &mut Vec<String>) -> TaskResult {
    println!("registry crates that each crate brings along (limit)");
    for &(name, _, limit, _) in LAYERS.iter().filter(|row| packages.contains_key(row.0)) {
        let [_, along] = brought_along(name)?;
        let count = along.len();
        println!("  {name:<18} {count:>3} ({limit})");
        if count > limit {
            faults.push(format!("{name} brings {count} registry crates, limit {limit}"));
        }
        let is_library = !TALKING.contains(&name);
        let brought = COMMAND_LINE.iter().filter(|c| is_library && along.contains(**c));
        let why = "command lines are for commands";
        faults.extend(brought.map(|c| format!("the library {name} brings {c}: {why}")));
    }
    Ok(())
}

/// Lengths of files, printing and file access in libraries, unfinished work.
fn sources(all: &[SourceText], faults: &mut Vec<String>) {
    let mut lengths = Vec::new();
    for (shown, text) in all {
        let lines = text.lines().count();
        lengths.push(lines);
        if lines > LONG_FILE {
            faults.push(format!("{shown} has {lines} lines, more than {LONG_FILE}: take it apart"));
        }
        for (number, line) in (1..).zip(text.lines()) {
            if line.contains(concat!("TO", "DO")) || line.contains(concat!("FIX", "ME")) {
                faults.push(format!("{shown}:{number}: unfinished work belongs in an issue"));
            }
        }
        if shown.starts_with("crates/") && shown.contains("/src/") {
            let code = text.split("#[cfg(test)]").next().unwrap_or_default();
            included(shown, code, faults);
            if !TALKING.iter().any(|place| shown.starts_with(&format!("crates/{place}/"))) {
                library_source(shown, code, faults);
            }
        }
    }
    lengths.sort_unstable();
    let median = lengths.get(lengths.len() / 2).copied().unwrap_or_default();
    let longest = lengths.last().copied().unwrap_or_default();
    println!("files: {}, median {median} lines, longest {longest}", lengths.len());
    if median > MEDIAN_FILE {
        faults.push(format!("the median file has {median} lines, more than {MEDIAN_FILE}"));
    }
}

/// A source with its path below the root.
type SourceText = (String, String);

/// The sources of crates and tasks; workspaces of their own below `crates` count, what was built
/// there does not.
fn read_sources() -> Vec<SourceText> {
    let mut found = files(&root().join("crates"), "rs");
    found.extend(files(&root().join("xtask"), "rs"));
    found.retain(|path| !path.components().any(|part| part.as_os_str() == "target"));
    let text = |path: &Path| std::fs::read_to_string(path).unwrap_or_default();
    found.iter().map(|path| (relative(path), text(path))).collect()
}

/// True for a file from which the modules of a crate, an example or a test are reached.
fn is_root(shown: &str) -> bool {
    let place: Vec<&str> = shown.split('/').rev().take(3).collect();
    match place[..] {
        ["lib.rs" | "main.rs", "src", ..] => true,
        ["main.rs", _, kind] => matches!(kind, "bin" | "examples" | "tests"),
        _ => false,
    }
}

/// Files import each other downwards only, and faces define nothing.
fn rooms(all: &[SourceText], faults: &mut Vec<String>) {
    let roots: Vec<&str> = all.iter().map(|(shown, _)| &**shown).filter(|s| is_root(s)).collect();
    let here = format!("{}/", root().display());
    for shown in &roots {
        let found = circles::circles_and_faces(&root().join(shown));
        faults.extend(found.iter().map(|fault| format!("{shown}: {}", fault.replace(&here, ""))));
    }
    println!("crates, examples and tests looked through for circles of files: {}", roots.len());
}

/// No crate reads a file outside its folder when it is compiled.
fn included(shown: &str, code: &str, faults: &mut Vec<String>) {
    // `src/a.rs` reaches its crate's folder with one step up.
    let depth = shown.split("/src/").nth(1).map_or(0, |rest| rest.matches('/').count());
    for call in ["include_str!(\"", "include_bytes!(\"", "include!(\""] {
        for included in code.split(call).skip(1).filter_map(|rest| rest.split('"').next()) {
            if included.matches("../").count() > depth + 1 {
                faults.push(format!("{shown} includes {included}, outside its crate"));
            }
        }
    }
}

/// Only the command prints; only `surface-io` and the command touch files.
fn library_source(shown: &str, code: &str, faults: &mut Vec<String>) {
    let code = (1..).zip(code.lines()).filter(|(_, line)| !line.trim_start().starts_with("//"));
    for (number, line) in code {
        let at = format!("{shown}:{number}");
        if ["println!", "print!", "eprintln!", "eprint!", "dbg!"].iter().any(|p| line.contains(p)) {
            faults.push(format!("{at}: a library does not print"));
        }
        let touches = ["std::fs", "File::open", "File::create"].iter().any(|p| line.contains(p));
        if touches && !shown.starts_with("crates/surface-io/") && shown != ASKS_LINUX {
            faults.push(format!("{at}: only surface-io and the command touch files"));
        }
    }
}

/// Every type that implements `ContactModel` has a DOI in its file and a page in the book that
/// names it.
fn models(all: &[SourceText], faults: &mut Vec<String>) {
    let pages = files(&root().join("docs/src/models"), "md");
    let pages: String = pages.iter().flat_map(std::fs::read_to_string).collect();
    let places = ["gw-closed-form", "asperity-models", "multiscale-models"]
        .map(|krate| format!("crates/{krate}/src/"));
    let mut found = 0;
    let of_models = all.iter().filter(|(shown, _)| places.iter().any(|p| shown.starts_with(p)));
    for (shown, text) in of_models {
        for rest in text.split("\nimpl ContactModel for ").skip(1) {
            let name = rest.split(' ').next().unwrap_or_default();
            found += 1;
            if !text.contains("10.") || !text.to_lowercase().contains("doi") {
                faults.push(format!("{shown}: {name} gives no DOI"));
            }
            if !pages.contains(name) {
                faults.push(format!("{name} has no page in docs/src/models"));
            }
        }
    }
    println!("contact models: {found}");
}

/// A name of a type means one thing in all crates.
fn type_names(all: &[SourceText], faults: &mut Vec<String>) {
    let mut owners = BTreeMap::new();
    for (shown, text) in all.iter().filter(|(shown, _)| shown.contains("/src/")) {
        let owner = shown.split("/src/").next().unwrap_or_default();
        for name in text.lines().filter_map(type_name) {
            let first = *owners.entry(name).or_insert(owner);
            if first != owner {
                faults.push(format!("{shown}: {name} is a type of {first}: one name, one thing"));
            }
        }
    }
}

/// The type that a line declares, if it does so at the top of its file.
fn type_name(line: &str) -> Option<&str> {
    let mut words = line.split(' ');
    let first = words.next()?;
    let kind = if first.starts_with("pub") { words.next()? } else { first };
    let declares = ["struct", "enum", "trait", "type"].contains(&kind);
    let name = words.next().filter(|_| declares)?;
    name.split(|c: char| !c.is_alphanumeric()).next()
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
    let missing = listed.iter().filter(|target| !source.join(target).is_file());
    faults.extend(missing.map(|t| format!("docs/src/SUMMARY.md lists {t}, which is missing")));
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

/// Each number of the paper has behind it, in a comment, a page of the book and the words there.
fn paper(faults: &mut Vec<String>) {
    // Spaces that do not break are spaces.
    let text = |path: &str| {
        let text = std::fs::read_to_string(root().join(path)).unwrap_or_default();
        text.replace(['\u{a0}', '\u{202f}'], " ")
    };
    let paper = text("docs/paper/paper.md");
    let mut quoted = 0;
    for comment in paper.split("<!-- ").skip(1).filter_map(|rest| rest.split(" -->").next()) {
        let Some((page, words)) = comment.split_once(".md: ") else { continue };
        quoted += 1;
        if !text(&format!("docs/src/{page}.md")).contains(words) {
            faults.push(format!("docs/paper/paper.md: docs/src/{page}.md has no {words:?}"));
        }
    }
    println!("quotations of the paper: {quoted}");
}

/// Words of our own, between `|`, where the field has its own.
const OURS: &str = "between the points|took part|kept back|theory card|how hard pressed|what it conducts|\
                    both surfaces as one|times too tall|its input sits|summits no longer act|\
                    finite differences see|that nobody measured|drawn with|that does not ring|\
                    four of five maps|slopes differ|error bar|one map of many|share of the line|\
                    held by floor|carry no ±";

/// None of them is in the book, the README or what the report says.
fn terms(faults: &mut Vec<String>) {
    let mut prose = files(&root().join("docs/src"), "md");
    prose.extend(files(&root().join("crates/report/src"), "rs"));
    prose.push(root().join("README.md"));
    for path in prose {
        let text = std::fs::read_to_string(&path).unwrap_or_default().replace("\\\n", "");
        // A line may end within a term.
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ").to_lowercase();
        for term in OURS.split('|').filter(|term| text.contains(term)) {
            faults.push(format!("{} says {term:?}: the field has its own word", relative(&path)));
        }
    }
}

fn relative(path: &Path) -> String {
    let path = path.strip_prefix(root()).unwrap_or(path);
    path.to_string_lossy().replace('\\', "/")
}
