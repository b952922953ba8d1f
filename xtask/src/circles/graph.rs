//! The arrows between the files of a crate, and the circles among them.

use super::uses::{Parts, Source};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Where a file stands in its crate: the root is empty.
type Place = Vec<String>;

/// The files of one crate.
struct Crate {
    files: BTreeMap<Place, (PathBuf, Source)>,
}

/// One sentence for each circle of files below the crate root `main` (`src/lib.rs`).
pub(crate) fn circles(main: &Path) -> Vec<String> {
    let krate = Crate::read(main);
    let arrows = krate.arrows();
    let shown = |place: &Place| krate.files[place].0.display().to_string();
    let describe = |circle: &BTreeSet<Place>| {
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

/// One sentence for each `lib.rs` or `mod.rs` below `main` that defines something.
pub(crate) fn faces(main: &Path) -> Vec<String> {
    let krate = Crate::read(main);
    let is_face =
        |path: &Path| path.file_name().is_some_and(|name| name == "lib.rs" || name == "mod.rs");
    krate
        .files
        .values()
        .filter(|(path, source)| is_face(path) && !source.items.is_empty())
        .map(|(path, source)| {
            format!("{} only declares and re-exports, but has {}", path.display(), source.items[0])
        })
        .collect()
}

impl Crate {
    fn read(main: &Path) -> Self {
        let mut krate = Self { files: BTreeMap::new() };
        let folder = main.parent().unwrap_or(Path::new("."));
        krate.walk(main, &[], folder);
        krate
    }

    fn walk(&mut self, file: &Path, place: &[String], folder: &Path) {
        let source = Source::of(&std::fs::read_to_string(file).unwrap_or_default());
        let children = source.children.clone();
        self.files.insert(place.to_vec(), (file.to_path_buf(), source));
        for child in children {
            let below = folder.join(&child);
            let candidates = [below.with_extension("rs"), below.join("mod.rs")];
            if let Some(path) = candidates.iter().find(|path| path.is_file()) {
                let inside = self::below(place, &child);
                self.walk(path, &inside, &below);
            }
        }
    }

    fn has(&self, place: &[String], child: &str) -> bool {
        self.files.contains_key(&below(place, child))
    }

    /// The file that defines what `parts` names as seen from `from`, and the name; the name is
    /// absent if it is the file itself. `None` for what lies outside the crate.
    fn resolve(
        &self,
        from: &Place,
        parts: &[String],
        depth: usize,
    ) -> Option<(Place, Option<String>)> {
        let (first, mut rest) = parts.split_first()?;
        let mut here = match first.as_str() {
            _ if depth > 12 => return None,
            "crate" => Place::new(),
            "self" => from.clone(),
            "super" => {
                let ups = parts.iter().take_while(|part| *part == "super").count();
                rest = &parts[ups..];
                from[..from.len().checked_sub(ups)?].to_vec()
            }
            _ => {
                rest = parts;
                let is_known = self.has(from, first)
                    || self.files[from].1.imported.contains_key(first)
                        && (depth > 0 || parts.len() > 1);
                if !is_known {
                    return None;
                }
                from.clone()
            }
        };
        while let Some((name, tail)) = rest.split_first() {
            if self.has(&here, name) {
                here.push(name.clone());
                rest = tail;
                continue;
            }
            let source = &self.files[&here].1;
            if !source.defined.contains(name)
                && let Some((_, target)) = source.imported.get(name)
                && *target != *parts
            {
                match self.resolve(&here, target, depth + 1)? {
                    (place, None) if !tail.is_empty() => {
                        here = place;
                        rest = tail;
                        continue;
                    }
                    found => return Some(found),
                }
            }
            return Some((here, Some(name.clone())));
        }
        Some((here, None))
    }

    /// For each file the files it takes something from, and what.
    fn arrows(&self) -> BTreeMap<Place, BTreeMap<Place, BTreeSet<String>>> {
        let mut all = BTreeMap::new();
        for (place, (_, source)) in &self.files {
            let mut arrows: BTreeMap<Place, BTreeSet<String>> = BTreeMap::new();
            let mut arrow = |parts: &Parts, depth: usize| {
                if let Some((to, Some(name))) = self.resolve(place, parts, depth)
                    && to != *place
                {
                    arrows.entry(to).or_default().insert(name);
                }
            };
            for (name, (is_public, parts)) in &source.imported {
                let is_face = *is_public && !source.used.contains(name);
                if !is_face {
                    arrow(parts, 1);
                }
            }
            for parts in &source.paths {
                arrow(parts, 0);
            }
            all.insert(place.clone(), arrows);
        }
        all
    }
}

fn below(place: &[String], child: &str) -> Place {
    let mut place = place.to_vec();
    place.push(child.to_owned());
    place
}

/// The sets of two and more nodes in which each reaches each: few nodes, so by reachability.
fn strongly_connected(
    arrows: &BTreeMap<Place, BTreeMap<Place, BTreeSet<String>>>,
) -> Vec<BTreeSet<Place>> {
    let reached: BTreeMap<&Place, BTreeSet<&Place>> = arrows
        .keys()
        .map(|start| {
            let (mut seen, mut open) = (BTreeSet::new(), vec![start]);
            while let Some(next) = open.pop() {
                open.extend(arrows[next].keys().filter(|to| seen.insert(*to)));
            }
            (start, seen)
        })
        .collect();
    let mut found: Vec<BTreeSet<Place>> = Vec::new();
    for (start, seen) in &reached {
        if seen.contains(start) && !found.iter().any(|circle| circle.contains(*start)) {
            let back = seen.iter().filter(|other| reached[*other].contains(start));
            found.push(back.map(|place| (*place).clone()).collect());
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn krate(name: &str, files: &[(&str, &str)]) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("xtask-{name}-{}", std::process::id()));
        for (file, text) in files {
            let path = folder.join(file);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, text).unwrap();
        }
        folder.join("lib.rs")
    }

    #[test]
    fn a_circle_through_a_face_is_found_and_a_tree_is_none() {
        let circle = krate(
            "circle",
            &[
                ("lib.rs", "mod a;\nmod b;\npub use a::A;\npub use b::B;"),
                ("a.rs", "use crate::B;\npub struct A(B);"),
                ("b/mod.rs", "mod c;\npub use c::B;"),
                ("b/c.rs", "pub struct B; fn f() { let _ = crate::a::A; }"),
            ],
        );
        let found = circles(&circle);
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(found[0].starts_with("a circle of 2 files"), "{found:?}");
        assert!(found[0].contains("takes B from") && found[0].contains("takes A from"));
        assert!(faces(&circle).is_empty());

        let tree = krate(
            "tree",
            &[
                ("lib.rs", "mod a;\nmod b;\npub use a::A;\nfn defined() {}"),
                ("a.rs", "use crate::b::{self, B};\npub struct A(B);\nfn f() { b::g(); }"),
                ("b.rs", "pub struct B;\npub fn g() {}\n#[cfg(test)]\nmod tests { use crate::A; }"),
            ],
        );
        assert!(circles(&tree).is_empty());
        assert_eq!(faces(&tree).len(), 1);
        for main in [circle, tree] {
            std::fs::remove_dir_all(main.parent().unwrap()).unwrap();
        }
    }
}
