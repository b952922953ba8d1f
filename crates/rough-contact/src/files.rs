//! Several files and folders where one file could stand, and what is kept of a run over them.

use crate::outcome::{Failure, tell, unfit};
use clap::Args;
use rough_contact::compare;
use rough_contact::surface_io::FORMATS;
use std::collections::BTreeSet;
use std::fmt;
use std::path::{Path, PathBuf};

#[derive(Args, Clone, Default)]
pub(crate) struct Files {
    /// Surface files, and folders whose files are taken; recognised by their content
    #[arg(value_name = "FILE")]
    pub(crate) paths: Vec<PathBuf>,
    /// Of several files: folder for table.csv and results.json, with every answer as it comes
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// Go on with --out: answers to the same content and the same options are kept
    #[arg(long, requires = "out")]
    pub(crate) resume: bool,
}

impl fmt::Debug for Files {
    /// Nothing: which files there are and where answers are kept is no setting of an answer.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Files")
    }
}

impl Files {
    /// The one file, where one was named and its answer is not to be kept.
    pub(crate) fn only(&self) -> Option<&Path> {
        match self.paths.as_slice() {
            [one] if !one.is_dir() && self.out.is_none() => Some(one),
            _ => None,
        }
    }
}

/// The files that were named, and of the folders among them, with the folders in them, those whose
/// name ends like a format or not at all, in the order of their names, each once. What is left out is said.
pub(crate) fn expand(paths: &[PathBuf]) -> Result<Vec<PathBuf>, Failure> {
    let (mut found, mut left_out) = (Vec::new(), Vec::new());
    for path in paths {
        if path.is_dir() {
            walk(path, &mut found, &mut left_out)?;
        } else {
            found.push(path.clone());
        }
    }
    let mut seen = BTreeSet::new();
    found.retain(|path| seen.insert(path.canonicalize().unwrap_or_else(|_| path.clone())));
    let names = |paths: &[PathBuf]| {
        paths.iter().map(|path| path.display().to_string()).collect::<Vec<_>>().join(", ")
    };
    if !left_out.is_empty() {
        let (count, some) = (left_out.len(), names(&left_out[..left_out.len().min(5)]));
        let more = if count > 5 { ", …" } else { "" };
        tell(&format!(
            "rough-contact: left out, for their names end like no format: {some}{more} ({count} in all); name \
             a file to have it read"
        ));
    }
    if found.is_empty() {
        let why = "no surface file is there; `rough-contact info --list` lists the formats";
        return Err(Failure::refused("empty", format!("{}: {why}", names(paths))));
    }
    Ok(found)
}

/// A folder name for what belongs to a file: the way to it, without what a folder name cannot hold.
pub(crate) fn folder_name(file: &Path) -> String {
    let plain = |c: char| if c.is_alphanumeric() || "._-".contains(c) { c } else { '_' };
    let shown = file.display().to_string();
    let name: String = shown.chars().map(plain).collect();
    let start = name.chars().count().saturating_sub(80);
    let hash: String = compare::sha256_hex(shown.as_bytes()).chars().take(8).collect();
    format!("{}-{hash}", name.chars().skip(start).collect::<String>())
}

fn walk(
    folder: &Path,
    found: &mut Vec<PathBuf>,
    left_out: &mut Vec<PathBuf>,
) -> Result<(), Failure> {
    let entries = std::fs::read_dir(folder).and_then(Iterator::collect::<Result<Vec<_>, _>>);
    let mut entries = entries.map_err(|e| unfit(folder, "io", e))?;
    entries.sort_by_cached_key(|entry| natural(&entry.file_name().to_string_lossy()));
    for entry in entries {
        let path = entry.path();
        if entry.file_name().to_string_lossy().starts_with('.') {
            continue;
        }
        // A link to a folder may lead back here; one to a file may not.
        let is_folder = entry.file_type().is_ok_and(|kind| kind.is_dir());
        if is_folder {
            walk(&path, found, left_out)?;
        } else if path.is_file() {
            if ends_like_a_format(&path) { found.push(path) } else { left_out.push(path) }
        }
    }
    Ok(())
}

/// A key by which `part2` comes before `part10`: text and the numbers in it by turns, each number by how many
/// digits it has, then by them; names that differ by zeros alone by themselves.
fn natural(name: &str) -> (Vec<(String, usize, String)>, String) {
    let mut parts = Vec::new();
    let mut rest = name;
    while !rest.is_empty() {
        let (text, after) =
            rest.split_at(rest.find(|c: char| c.is_ascii_digit()).unwrap_or(rest.len()));
        let digits = after.len() - after.trim_start_matches(|c: char| c.is_ascii_digit()).len();
        let number = after[..digits].trim_start_matches('0');
        parts.push((text.to_owned(), number.len(), number.to_owned()));
        rest = &after[digits..];
    }
    (parts, name.to_owned())
}

/// True of endings that a format has, of the running numbers of microscopes, and of no ending.
fn ends_like_a_format(path: &Path) -> bool {
    let Some(ending) = path.extension() else { return true };
    let ending = ending.to_string_lossy().to_lowercase();
    let numbered = ending.len() == 3 && ending.bytes().all(|b| b.is_ascii_digit());
    let packed = matches!(ending.as_str(), "zip" | "gz");
    numbered || packed || FORMATS.iter().any(|f| f.extensions.contains(&ending.as_str()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_is_walked_in_the_order_of_names() {
        let dir = tempfile::tempdir().expect("a folder");
        std::fs::create_dir(dir.path().join("b")).expect("a folder in it");
        let names = "part10.x3p part1.x3p part2.x3p c.x3p b/a.sdf a.x3p b/.hidden.x3p \
                     b/picture.png b/readme.md b/notes.0123 scan.003 bare d.zip E.SUR";
        for name in names.split(' ') {
            std::fs::write(dir.path().join(name), "").expect("a file");
        }
        let found = expand(&[dir.path().to_owned(), dir.path().join(".")]).expect("files");
        let names: Vec<_> = found.iter().map(|p| p.strip_prefix(dir.path()).unwrap()).collect();
        let order = "E.SUR a.x3p b/a.sdf bare c.x3p d.zip part1.x3p part2.x3p part10.x3p scan.003";
        assert_eq!(names, order.split(' ').map(Path::new).collect::<Vec<_>>());
    }
}
