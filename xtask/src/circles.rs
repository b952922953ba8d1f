//! Circles of files: inside a crate, files import each other downwards only.
//!
//! Each path that a file imports or names is followed through imports and re-exports to the file that defines it; a
//! re-export alone is a face and no arrow. Sources are read line by line, as `cargo fmt` leaves them. What is not seen: a
//! method of an `impl` that stands in another file than its type, and names that a macro makes.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// For each file the files it takes something from, and what. A file is named by its module, as `a::b`, the root by
/// nothing.
type Arrows = BTreeMap<String, BTreeMap<String, BTreeSet<String>>>;

/// The files of one crate.
#[derive(Default)]
struct CrateFiles(BTreeMap<String, (PathBuf, FileNames)>);

/// What one file declares, imports and names, tests aside.
#[derive(Default)]
struct FileNames {
    /// Child modules that are files of their own.
    children: Vec<String>,
    /// The path of each imported name, and whether it is `pub`.
    imported: BTreeMap<String, (bool, String)>,
    /// Names and paths in the code itself, outside `use`.
    used: BTreeSet<String>,
    /// The first item that is defined here, as `fn f`; none in a face.
    item: Option<String>,
}

const DEFINES: [&str; 9] =
    ["fn", "struct", "enum", "trait", "type", "const", "static", "union", "impl"];

/// One sentence for each circle of files below the crate root `main` (`src/lib.rs`), and where it is that of a library for
/// each `lib.rs` or `mod.rs` that defines something.
pub(crate) fn circles_and_faces(main: &Path) -> Vec<String> {
    let mut krate = CrateFiles::default();
    krate.walk(main, "", main.parent().unwrap_or(Path::new(".")));
    let mut found = krate.circles();
    if main.ends_with("lib.rs") {
        found.extend(krate.faces());
    }
    found
}

impl CrateFiles {
    fn walk(&mut self, file: &Path, place: &str, folder: &Path) {
        let names = FileNames::of(&std::fs::read_to_string(file).unwrap_or_default());
        for child in &names.children {
            let below = folder.join(child);
            let candidates = [below.with_extension("rs"), below.join("mod.rs")];
            if let Some(path) = candidates.iter().find(|path| path.is_file()) {
                self.walk(path, &inside(place, child), &below);
            }
        }
        self.0.insert(place.to_owned(), (file.to_path_buf(), names));
    }

    /// The sets of two and more files in which each reaches each: few files, so by reachability.
    fn circles(&self) -> Vec<String> {
        let arrows = self.arrows();
        let reached = |start: &String| {
            let (mut seen, mut open) = (BTreeSet::new(), vec![start.clone()]);
            while let Some(next) = open.pop() {
                open.extend(arrows[&next].keys().filter(|to| seen.insert((*to).clone())).cloned());
            }
            seen
        };
        let reached: BTreeMap<&String, BTreeSet<String>> =
            arrows.keys().map(|start| (start, reached(start))).collect();
        let circle = |(start, seen): (&&String, &BTreeSet<String>)| {
            let back = seen.iter().filter(|other| reached[*other].contains(*start));
            back.cloned().collect::<BTreeSet<String>>()
        };
        let circles: BTreeSet<_> = reached.iter().map(circle).filter(|c| !c.is_empty()).collect();
        let shown = |place: &String| self.0[place].0.display().to_string();
        let describe = |circle: &BTreeSet<String>| {
            let mut text = format!("a circle of {} files", circle.len());
            for from in circle {
                for (to, names) in arrows[from].iter().filter(|(to, _)| circle.contains(*to)) {
                    let names: Vec<&str> = names.iter().map(String::as_str).collect();
                    let (from, to) = (shown(from), shown(to));
                    let _ = write!(text, "\n    {from} takes {} from {to}", names.join(", "));
                }
            }
            text
        };
        circles.iter().map(describe).collect()
    }

    fn faces(&self) -> impl Iterator<Item = String> {
        self.0.values().filter_map(|(path, names)| {
            let is_face = path.ends_with("lib.rs") || path.ends_with("mod.rs");
            let item = names.item.as_ref().filter(|_| is_face)?;
            Some(format!("{} only declares and re-exports, but has {item}", path.display()))
        })
    }

    fn arrows(&self) -> Arrows {
        let mut all = Arrows::new();
        for (place, (_, names)) in &self.0 {
            let arrows = all.entry(place.clone()).or_default();
            let imports = names.imported.iter();
            let imports = imports.filter(|(name, (face, _))| !face || names.used.contains(*name));
            let paths = names.used.iter().filter(|name| name.contains("::"));
            for path in imports.map(|(_, (_, path))| path).chain(paths) {
                if let Some((to, name)) = self.resolve(place, path).filter(|(to, _)| to != place) {
                    arrows.entry(to).or_default().insert(name);
                }
            }
        }
        all
    }

    /// The file that defines what `path` names as seen from `from`, and the name. `None` for a file itself, and for what
    /// lies outside the crate.
    fn resolve(&self, from: &str, path: &str) -> Option<(String, String)> {
        let mut here = from.to_owned();
        let mut rest: Vec<&str> = path.rsplit("::").collect();
        let mut is_inside = false; // whether the names before led to a file of the crate
        // Imports that lead back to themselves end somewhere.
        for _ in 0..40 {
            let name = rest.pop()?;
            let below = inside(&here, name);
            match name {
                "crate" => here.clear(),
                "self" => {}
                "super" => here.truncate(here.rfind("::").unwrap_or(0)),
                _ if self.0.contains_key(&below) => here = below,
                _ => match self.0[&here].1.imported.get(name) {
                    Some((_, target)) if target != name => {
                        rest.extend(target.rsplit("::"));
                        is_inside = false;
                        continue;
                    }
                    _ => return is_inside.then(|| (here, name.to_owned())),
                },
            }
            is_inside = true;
        }
        None
    }
}

/// The path of a module in another; that of the root is empty.
fn inside(place: &str, child: &str) -> String {
    if place.is_empty() { child.to_owned() } else { format!("{place}::{child}") }
}

impl FileNames {
    fn of(text: &str) -> Self {
        let mut found = Self::default();
        let code = without_tests(text);
        let mut lines = code.lines();
        while let Some(line) = lines.next() {
            let bare = line.trim_start();
            let is_public = bare.starts_with("pub");
            let item =
                if is_public { bare.split_once(' ').map_or("", |(_, item)| item) } else { bare };
            if let Some(begin) = item.strip_prefix("use ") {
                let mut tree = begin.to_owned();
                while !tree.ends_with(';') {
                    tree += lines.next().unwrap_or(";").trim();
                }
                found.import(&tree, is_public);
                continue;
            }
            if let Some(child) = item.strip_prefix("mod ").and_then(|rest| rest.strip_suffix(';')) {
                found.children.push(child.to_owned());
                continue;
            }
            let mut words = item.split([' ', '<', '(', ':']);
            let kind = words.next().filter(|kind| line == bare && DEFINES.contains(kind));
            if let (Some(kind), None) = (kind, &found.item) {
                found.item = Some(format!("{kind} {}", words.next().unwrap_or_default()));
            }
            let is_between = |c: char| !(c.is_alphanumeric() || c == '_' || c == ':');
            for path in line.split(is_between).map(|path| path.trim_matches(':')) {
                let first = path.split("::").next().unwrap_or_default();
                found.used.extend([path, first].map(str::to_owned));
            }
        }
        found
    }

    /// Takes a `use` tree apart: `a::{b, c as d};` is `a::b` and `a::c`.
    fn import(&mut self, tree: &str, is_public: bool) {
        let (mut stems, mut branch) = (vec![String::new()], String::new());
        for c in tree.chars() {
            match c {
                '{' => stems.push(stems[stems.len() - 1].clone() + &std::mem::take(&mut branch)),
                ',' | '}' | ';' => {
                    if !branch.is_empty() {
                        let path = stems[stems.len() - 1].clone() + &std::mem::take(&mut branch);
                        let (path, alias) = path.split_once(" as ").unwrap_or((&path, ""));
                        let path = path.strip_suffix("::self").unwrap_or(path);
                        let own = path.rsplit("::").next().unwrap_or(path);
                        let name = if alias.is_empty() { own } else { alias };
                        self.imported.insert(name.to_owned(), (is_public, path.to_owned()));
                    }
                    if c == '}' {
                        stems.pop();
                    }
                }
                ' ' if branch.is_empty() => {}
                _ => branch.push(c),
            }
        }
    }
}

/// Source without comments and without items under `#[cfg(test)]`, which end where a line as far in as their first ends so.
fn without_tests(text: &str) -> String {
    let indent = |line: &str| line.len() - line.trim_start().len();
    let (mut code, mut lines) = (String::new(), text.lines());
    while let Some(line) = lines.next() {
        let bare = line.trim_start();
        if bare.starts_with("#[cfg(test)]") || bare.starts_with("#[cfg(all(test,") {
            lines.find(|end| indent(end) == indent(line) && end.ends_with([';', '}']));
        } else {
            code += line.split("//").next().unwrap_or_default().trim_end();
            code += "\n";
        }
    }
    code
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(name: &str, files: &[(&str, &str)]) -> Vec<String> {
        let folder = std::env::temp_dir().join(format!("xtask-{name}-{}", std::process::id()));
        for (file, text) in files {
            let path = folder.join(file);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, text).unwrap();
        }
        let found = circles_and_faces(&folder.join("lib.rs"));
        std::fs::remove_dir_all(folder).unwrap();
        found
    }

    /// Names in trees and under others are seen, those in comments and tests are not.
    #[test]
    fn a_circle_through_a_face_is_found_and_a_tree_is_none() {
        let circle = found(
            "circle",
            &[
                ("lib.rs", "mod a;\nmod b;\nmod d;\npub use a::A;\npub use b::B;"),
                ("a.rs", "use crate::{\n    d::{self, D},\n    B as E,\n};\npub struct A(E, D);"),
                ("b/mod.rs", "mod c;\npub use c::B;"),
                ("b/c.rs", "pub struct B;\nfn f() {\n    crate::a::A::<u8>::g();\n}"),
                ("d.rs", "pub struct D; // crate::A\n#[cfg(test)]\nuse crate::A;"),
            ],
        );
        assert_eq!(circle.len(), 1, "{circle:?}");
        assert!(circle[0].starts_with("a circle of 2 files"), "{circle:?}");
        assert!(circle[0].contains("takes B from") && circle[0].contains("takes A from"));

        let tree = found(
            "tree",
            &[
                ("lib.rs", "mod a;\nmod b;\npub use a::A;\nfn defined() {}"),
                ("a.rs", "use crate::b::{self, B};\npub struct A(B);\nfn f() {\n    b::g();\n}"),
                ("b.rs", "pub struct B;\n#[cfg(test)]\nmod tests {\n    use crate::A;\n}"),
            ],
        );
        assert!(tree.len() == 1 && tree[0].ends_with("has fn defined"), "{tree:?}");
    }
}
