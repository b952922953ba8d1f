//! What says which version this is, and whether it is the same everywhere.

use crate::shell::{TaskResult, read, root};

/// Files that state the version, and what stands before it and behind it.
const STATED: [(&str, &str, &str); 3] = [
    ("crates/python/Cargo.toml", "\nversion = \"", "\""),
    ("CITATION.cff", "\nversion: ", "\n"),
    (".zenodo.json", "\"version\": \"", "\""),
];

/// Checks that the versions agree; with a tag, as v1.2.3, that it is theirs and that the changes of that version are
/// written down.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let mut faults = Vec::new();
    versions(&mut faults);
    let version = version()?;
    if let [tag] = args {
        if *tag != format!("v{version}") {
            faults.push(format!("the tag {tag} is not v{version}, the version in Cargo.toml"));
        }
        if notes(&version)?.trim().is_empty() {
            faults.push(format!("CHANGELOG.md has nothing below \"## {version}\""));
        }
        let heading =
            format!("\n## {version} ({})\n", stated("CITATION.cff", "\ndate-released: ", "\n")?);
        if !read(&root().join("CHANGELOG.md"))?.replace("\r\n", "\n").contains(&heading) {
            faults.push(format!(
                "CHANGELOG.md has not the heading of CITATION.cff, \"{}\"",
                heading.trim()
            ));
        }
    } else if !args.is_empty() {
        return Err(format!("unknown arguments {args:?}; release takes a tag or nothing"));
    }
    match faults.as_slice() {
        [] => {
            println!("release: version {version}");
            Ok(())
        }
        some => Err(some.join("; ")),
    }
}

/// Prints what has changed with this version.
pub(crate) fn print_notes() -> TaskResult {
    print!("{}", notes(&version()?)?);
    Ok(())
}

/// Every file states the version of the workspace.
pub(crate) fn versions(faults: &mut Vec<String>) {
    let version = match version() {
        Ok(version) => version,
        Err(fault) => return faults.push(fault),
    };
    for (path, before, behind) in STATED {
        match stated(path, before, behind) {
            Ok(found) if found == version => {}
            Ok(found) => {
                faults.push(format!("{path} states version {found}, Cargo.toml {version}"));
            }
            Err(fault) => faults.push(fault),
        }
    }
}

fn version() -> Result<String, String> {
    stated("Cargo.toml", "[workspace.package]\nversion = \"", "\"")
}

fn stated(path: &str, before: &str, behind: &str) -> Result<String, String> {
    let text = read(&root().join(path))?.replace("\r\n", "\n");
    let version = text.split_once(before).and_then(|(_, rest)| rest.split_once(behind));
    let (version, _) = version.ok_or_else(|| format!("{path} states no version"))?;
    Ok(version.to_owned())
}

/// The part of the changelog below the heading of a version.
fn notes(version: &str) -> Result<String, String> {
    let text = read(&root().join("CHANGELOG.md"))?.replace("\r\n", "\n");
    Ok(below(&text, version).to_owned())
}

fn below<'a>(text: &'a str, version: &str) -> &'a str {
    let sections = text.split("\n## ").skip(1).filter_map(|section| section.split_once('\n'));
    let is_of = |heading: &str| heading.split(' ').next() == Some(version);
    sections.filter(|(heading, _)| is_of(heading)).map(|(_, rest)| rest).next().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_changes_of_a_version_are_found() {
        let text = "# Changelog\n\n## Unreleased\n\na\n\n## 0.1.10 (2027)\n\nb\n### Sub\nc\n\n## 0.1.1\n\nd\n";
        assert_eq!(below(text, "0.1.1").trim(), "d");
        assert_eq!(below(text, "0.1.10").trim(), "b\n### Sub\nc");
        assert_eq!(below(text, "0.2.0"), "");
    }
}
