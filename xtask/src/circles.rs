//! Circles of files: inside a crate, files import each other downwards only.
//!
//! Each name that a file imports is followed through re-exports to the file that defines it; a
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

    fn circles(&self) -> Vec<String> {
        let arrows = self.arrows();
        let shown = |place: &String| self.0[place].0.display().to_string();
        let describe = |circle: &BTreeSet<String>| {
            let mut text = String::new();
            for from in circle {
                for (to, names) in arrows[from].iter().filter(|(to, _)| circle.contains(*to)) {
                    let names: Vec<&str> = names.iter().map(String::as_str).collect();
                    let (from, to) = (shown(from), shown(to));
                    let _ = write!(text, "\n    {from} takes {} from {to}", names.join(", "));
                }
            }
            format!("a circle of {} files{text}", circle.len())
        };
        strongly_connected(&arrows).iter().map(describe).collect()
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
            let is_arrow = |(name, (is_public, _)): &(&String, &(bool, String))| {
                !is_public || names.used.contains(*name)
            };
            let imports = names.imported.iter().filter(is_arrow).map(|(_, (_, path))| path);
            let paths = names.used.iter().filter(|name| name.contains("::"));
            for path in imports.chain(paths) {
                if let Some((to, name)) = self.resolve(place, path, 0)
                    && to != *place
                {
                    arrows.entry(to).or_default().insert(name);
                }
            }
        }
        all
    }

    /// The file that defines what `path` names as seen from `from`, and the name. `None` for a file itself, and for what
    /// lies outside the crate.
    fn resolve(&self, from: &str, path: &str, depth: usize) -> Option<(String, String)> {
        let (first, behind) = path.split_once("::").unwrap_or((path, ""));
        let own = &self.0[from].1;
        let (mut here, mut rest) = match first {
            _ if depth > 12 => return None,
            "crate" => (String::new(), behind),
            "self" => (from.to_owned(), behind),
            "super" => (above(from), behind),
            _ if self.0.contains_key(&inside(from, first)) || own.imported.contains_key(first) => {
                (from.to_owned(), path)
            }
            _ => return None,
        };
        while let Some(behind) = rest.strip_prefix("super::") {
            here = above(&here);
            rest = behind;
        }
        while !rest.is_empty() {
            let (name, behind) = rest.split_once("::").unwrap_or((rest, ""));
            let below = inside(&here, name);
            match self.0[&here].1.imported.get(name) {
                _ if self.0.contains_key(&below) => here = below,
                Some((_, target)) if target != path => {
                    return self.resolve(&here, &inside(target, behind), depth + 1);
                }
                _ => return Some((here, name.to_owned())),
            }
            rest = behind;
        }
        None
    }
}

fn above(place: &str) -> String {
    place.rsplit_once("::").map_or(String::new(), |(above, _)| above.to_owned())
}

/// Two paths as one; either may be empty.
fn inside(place: &str, child: &str) -> String {
    let between = if place.is_empty() || child.is_empty() { "" } else { "::" };
    format!("{place}{between}{child}")
}

/// The sets of two and more nodes in which each reaches each: few nodes, so by reachability.
fn strongly_connected(arrows: &Arrows) -> Vec<BTreeSet<String>> {
    let reached: BTreeMap<&String, BTreeSet<&String>> = arrows
        .keys()
        .map(|start| {
            let (mut seen, mut open) = (BTreeSet::new(), vec![start]);
            while let Some(next) = open.pop() {
                open.extend(arrows[next].keys().filter(|to| seen.insert(*to)));
            }
            (start, seen)
        })
        .collect();
    let mut found: Vec<BTreeSet<String>> = Vec::new();
    for (start, seen) in &reached {
        if seen.contains(start) && !found.iter().any(|circle| circle.contains(*start)) {
            let back = seen.iter().filter(|other| reached[*other].contains(start));
            found.push(back.map(|place| (*place).clone()).collect());
        }
    }
    found
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
                found.import(tree.trim_end_matches(';'), is_public);
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

    /// Takes a `use` tree apart: `a::{b, c as d}` is `a::b` and `a::c`.
    fn import(&mut self, tree: &str, is_public: bool) {
        let Some((stem, branches)) = tree.split_once('{') else {
            let (path, alias) = tree.split_once(" as ").unwrap_or((tree, ""));
            let path = path.strip_suffix("::self").unwrap_or(path);
            let own = path.rsplit("::").next().unwrap_or(path);
            let name = if alias.is_empty() { own } else { alias };
            self.imported.insert(name.to_owned(), (is_public, path.to_owned()));
            return;
        };
        let (mut depth, mut begin) = (0, 0);
        for (at, c) in branches.char_indices() {
            match c {
                ',' | '}' if depth == 0 => {
                    let branch = branches[begin..at].trim();
                    if !branch.is_empty() {
                        self.import(&format!("{stem}{branch}"), is_public);
                    }
                    begin = at + 1;
                }
                '{' => depth += 1,
                '}' => depth -= 1,
                _ => {}
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

    #[test]
    fn a_circle_through_a_face_is_found_and_a_tree_is_none() {
        let circle = found(
            "circle",
            &[
                ("lib.rs", "mod a;\nmod b;\npub use a::A;\npub use b::B;"),
                ("a.rs", "use crate::B;\npub struct A(B);"),
                ("b/mod.rs", "mod c;\npub use c::B;"),
                ("b/c.rs", "pub struct B;\nfn f() {\n    let _ = crate::a::A;\n}"),
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
                (
                    "b.rs",
                    "pub struct B;\npub fn g() {}\n#[cfg(test)]\nmod tests {\n    use crate::A;\n}",
                ),
            ],
        );
        assert!(tree.len() == 1 && tree[0].ends_with("has fn defined"), "{tree:?}");
    }

    #[test]
    fn a_use_tree_is_taken_apart_and_tests_and_comments_are_no_names() {
        let names = FileNames::of(
            "pub(crate) use a::{\n    self,\n    b::{C, D as E},\n    f,\n};\n#[cfg(test)]\nuse t::u;\nmod g; // x::y\n\
             fn h() {\n    g::i::<u8>();\n}\n#[cfg(test)]\nmod tests {\n    fn s() {\n    }\n    v::w();\n}\n",
        );
        let shown = |(name, (is_public, path)): (&String, &(bool, String))| {
            format!("{name}={path}:{is_public}")
        };
        let imported: Vec<String> = names.imported.iter().map(shown).collect();
        assert_eq!(imported, ["C=a::b::C:true", "E=a::b::D:true", "a=a:true", "f=a::f:true"]);
        assert_eq!((names.children, names.item.as_deref()), (vec!["g".to_owned()], Some("fn h")));
        assert!(names.used.contains("g::i"));
        assert!(!names.used.iter().any(|path| ["x::y", "t::u", "v::w"].contains(&path.as_str())));
    }
}
