//! Circles of files: inside a crate, files import each other downwards only.
//!
//! Each name that a file imports is followed through re-exports to the file that defines it; a
//! re-export alone is a face and no arrow. What is not seen: a method of an `impl` that stands in
//! another file than its type, and names that a macro makes.

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// A path of names: where a file stands in its crate, the root being empty, or a path as written, so
/// that `crate::a::B` has three.
type ModulePath = Vec<String>;

/// For each file the files it takes something from, and what.
type Arrows = BTreeMap<ModulePath, BTreeMap<ModulePath, BTreeSet<String>>>;

/// The files of one crate.
#[derive(Default)]
struct CrateFiles(BTreeMap<ModulePath, (PathBuf, FileNames)>);

/// What one file declares, imports and names, tests aside.
#[derive(Default)]
struct FileNames {
    /// Child modules that are files of their own.
    children: Vec<String>,
    /// The path of each imported name, and whether it is `pub`.
    imported: BTreeMap<String, (bool, ModulePath)>,
    /// Names that the code itself uses, outside `use`.
    used: BTreeSet<String>,
    /// Paths in the code itself, of two parts and more.
    paths: BTreeSet<ModulePath>,
    /// The first item that is defined here, as `fn f` or `impl`; none in a face.
    item: Option<String>,
}

const DEFINES: [&str; 8] = ["fn", "struct", "enum", "trait", "type", "const", "static", "union"];

/// One sentence for each circle of files below the crate root `main` (`src/lib.rs`), and where it is that of a library for
/// each `lib.rs` or `mod.rs` that defines something.
pub(crate) fn circles_and_faces(main: &Path) -> Vec<String> {
    let krate = CrateFiles::read(main);
    let mut found = krate.circles();
    if main.ends_with("lib.rs") {
        found.extend(krate.faces());
    }
    found
}

impl CrateFiles {
    fn read(main: &Path) -> Self {
        let mut krate = Self::default();
        krate.walk(main, &[], main.parent().unwrap_or(Path::new(".")));
        krate
    }

    fn circles(&self) -> Vec<String> {
        let arrows = self.arrows();
        let shown = |place: &ModulePath| self.0[place].0.display().to_string();
        let describe = |circle: &BTreeSet<ModulePath>| {
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

    fn walk(&mut self, file: &Path, place: &[String], folder: &Path) {
        let names = FileNames::of(&std::fs::read_to_string(file).unwrap_or_default());
        for child in &names.children {
            let below = folder.join(child);
            let candidates = [below.with_extension("rs"), below.join("mod.rs")];
            if let Some(path) = candidates.iter().find(|path| path.is_file()) {
                self.walk(path, &inside(place, child), &below);
            }
        }
        self.0.insert(place.to_vec(), (file.to_path_buf(), names));
    }

    fn has(&self, place: &[String], child: &str) -> bool {
        self.0.contains_key(&inside(place, child))
    }

    /// The file that defines what `parts` names as seen from `from`, and the name; the name is
    /// absent if it is the file itself. `None` for what lies outside the crate.
    fn resolve(
        &self,
        from: &ModulePath,
        parts: &[String],
        depth: usize,
    ) -> Option<(ModulePath, Option<String>)> {
        let (first, mut rest) = parts.split_first()?;
        let mut here = match first.as_str() {
            _ if depth > 12 => return None,
            "crate" => ModulePath::new(),
            "self" => from.clone(),
            "super" => {
                let ups = parts.iter().take_while(|part| *part == "super").count();
                rest = &parts[ups..];
                from[..from.len().checked_sub(ups)?].to_vec()
            }
            _ => {
                rest = parts;
                let is_imported = self.0[from].1.imported.contains_key(first);
                let is_named = depth > 0 || parts.len() > 1;
                if !(self.has(from, first) || is_imported && is_named) {
                    return None;
                }
                from.clone()
            }
        };
        while let Some((name, tail)) = rest.split_first() {
            let names = &self.0[&here].1;
            if self.has(&here, name) {
                here.push(name.clone());
            } else if let Some((_, target)) = names.imported.get(name)
                && *target != *parts
            {
                match self.resolve(&here, target, depth + 1)? {
                    (place, None) if !tail.is_empty() => here = place,
                    found => return Some(found),
                }
            } else {
                return Some((here, Some(name.clone())));
            }
            rest = tail;
        }
        Some((here, None))
    }

    fn arrows(&self) -> Arrows {
        let mut all = Arrows::new();
        for (place, (_, names)) in &self.0 {
            let arrows = all.entry(place.clone()).or_default();
            let is_arrow = |(name, (is_public, _)): &(&String, &(bool, ModulePath))| {
                !is_public || names.used.contains(*name)
            };
            let imports = names.imported.iter().filter(is_arrow).map(|(_, (_, parts))| (parts, 1));
            for (parts, depth) in imports.chain(names.paths.iter().map(|parts| (parts, 0))) {
                if let Some((to, Some(name))) = self.resolve(place, parts, depth)
                    && to != *place
                {
                    arrows.entry(to).or_default().insert(name);
                }
            }
        }
        all
    }
}

fn inside(place: &[String], child: &str) -> ModulePath {
    let mut path = place.to_vec();
    path.push(child.to_owned());
    path
}

/// The sets of two and more nodes in which each reaches each: few nodes, so by reachability.
fn strongly_connected(arrows: &Arrows) -> Vec<BTreeSet<ModulePath>> {
    let reached: BTreeMap<&ModulePath, BTreeSet<&ModulePath>> = arrows
        .keys()
        .map(|start| {
            let (mut seen, mut open) = (BTreeSet::new(), vec![start]);
            while let Some(next) = open.pop() {
                open.extend(arrows[next].keys().filter(|to| seen.insert(*to)));
            }
            (start, seen)
        })
        .collect();
    let mut found: Vec<BTreeSet<ModulePath>> = Vec::new();
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
        let all = tokens(text.parse().expect("a source that compiles"));
        let at = |i: usize| all.get(i).map_or("", String::as_str);
        let mut found = Self::default();
        let (mut i, mut depth) = (0, 0_i32);
        while i < all.len() {
            let start = i;
            i += 1;
            match at(start) {
                "{" => depth += 1,
                "}" => depth -= 1,
                "impl" if depth == 0 => found.item = found.item.or(Some("impl".to_owned())),
                _ => {}
            }
            if at(start) == "use" {
                i += all[i..].iter().take_while(|token| *token != ";").count();
                let before = if at(start.wrapping_sub(1)) == ")" { 4 } else { 1 }; // pub(crate)
                found.import(&all[start + 1..i], at(start.wrapping_sub(before)) == "pub");
            } else if at(start) == "mod" && at(start + 2) == ";" {
                found.children.push(at(i).to_owned());
                i += 2;
            } else if at(start).starts_with(is_word) {
                let defines = DEFINES.contains(&at(start)) && at(i).starts_with(is_word);
                if defines && depth == 0 {
                    found.item.get_or_insert_with(|| format!("{} {}", at(start), at(i)));
                }
                while at(i) == "::" && at(i + 1).starts_with(is_word) {
                    i += 2;
                }
                found.used.insert(at(start).to_owned());
                if i > start + 1 {
                    let parts = all[start..i].iter().filter(|token| *token != "::");
                    found.paths.insert(parts.cloned().collect());
                }
            }
        }
        found
    }

    /// Takes a `use` tree apart.
    fn import(&mut self, tree: &[String], is_public: bool) {
        let mut path = ModulePath::new();
        // Length of the path before each open brace.
        let mut stems = vec![0];
        let mut alias = None;
        for (i, token) in tree.iter().map(String::as_str).chain([";"]).enumerate() {
            match token {
                "{" => stems.push(path.len()),
                "," | "}" | ";" => {
                    if path.len() > stems[stems.len() - 1] {
                        if path.len() > 1 && path.ends_with(&["self".to_owned()]) {
                            path.pop(); // a::b::self is a::b
                        }
                        let name = alias.take().unwrap_or(path[path.len() - 1].clone());
                        self.imported.insert(name, (is_public, path.clone()));
                    }
                    if token == "}" {
                        stems.pop();
                    }
                    path.truncate(stems[stems.len() - 1]);
                }
                "::" | "as" => {}
                word if i > 0 && tree[i - 1] == "as" => alias = Some(word.to_owned()),
                word => path.push(word.to_owned()),
            }
        }
    }
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// The names and signs of Rust source without items under `#[cfg(test)]` or `#[cfg(all(test, ..))]`; comments, strings,
/// characters and lifetimes are gone. A documentation comment is the attribute `doc`.
fn tokens(source: TokenStream) -> Vec<String> {
    let is =
        |tree: &TokenTree, sign: char| matches!(tree, TokenTree::Punct(p) if p.as_char() == sign);
    let is_body =
        |tree: &TokenTree| matches!(tree, TokenTree::Group(g) if g.delimiter() == Delimiter::Brace);
    let (mut found, mut trees) = (Vec::new(), source.into_iter().peekable());
    while let Some(tree) = trees.next() {
        match tree {
            TokenTree::Group(group) => {
                let [open, close] = match group.delimiter() {
                    Delimiter::Brace => ["{", "}"],
                    Delimiter::Bracket => ["[", "]"],
                    _ => ["(", ")"],
                };
                found.push(open.to_owned());
                found.extend(tokens(group.stream()));
                found.push(close.to_owned());
            }
            TokenTree::Ident(name) => found.push(name.to_string()),
            TokenTree::Punct(sign) => match sign.as_char() {
                // A lifetime.
                '\'' => drop(trees.next()),
                '#' if trees.peek().is_some_and(is_of_tests) => {
                    trees.find(|tree| is_body(tree) || is(tree, ';'));
                }
                ':' if sign.spacing() == Spacing::Joint
                    && trees.next_if(|tree| is(tree, ':')).is_some() =>
                {
                    found.push("::".to_owned());
                }
                sign => found.push(sign.to_string()),
            },
            TokenTree::Literal(_) => {}
        }
    }
    found
}

/// Whether an attribute keeps an item to tests.
fn is_of_tests(attribute: &TokenTree) -> bool {
    let text = attribute.to_string().replace(' ', "");
    text.starts_with("[cfg(test)") || text.starts_with("[cfg(all(test,")
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
        let found = circles_and_faces(&circle);
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(found[0].starts_with("a circle of 2 files"), "{found:?}");
        assert!(found[0].contains("takes B from") && found[0].contains("takes A from"));

        let tree = krate(
            "tree",
            &[
                ("lib.rs", "mod a;\nmod b;\npub use a::A;\nfn defined() {}"),
                ("a.rs", "use crate::b::{self, B};\npub struct A(B);\nfn f() { b::g(); }"),
                ("b.rs", "pub struct B;\npub fn g() {}\n#[cfg(test)]\nmod tests { use crate::A; }"),
            ],
        );
        let found = circles_and_faces(&tree);
        assert!(found.len() == 1 && found[0].ends_with("has fn defined"), "{found:?}");
        for main in [circle, tree] {
            std::fs::remove_dir_all(main.parent().unwrap()).unwrap();
        }
    }

    #[test]
    fn text_comments_and_tests_are_no_names() {
        let source = r##"
            use a::b; // use c::d
            /* e /* f */ g */ const X: &str = "https://h \" i"; let r = r#"j " k"#;
            fn l<'m>(n: &'m u8) -> char { '\''; b'o'; 'p' }
            #[cfg(test)] mod tests { use super::q; fn s() { {} } }
            #[cfg(test)] use t::u;
            fn after() {}
        "##;
        let mut names = tokens(source.parse().unwrap());
        names.retain(|token| token.starts_with(is_word));
        assert_eq!(names.join(" "), "use a b const X str let r fn l n u8 char fn after");
    }

    #[test]
    fn a_use_tree_is_taken_apart() {
        let names = FileNames::of(
            "pub(crate) use a::{self, b::{C, D as E}, f};\nmod g;\nfn h() { g::i::<u8>(); }",
        );
        let shown = |(name, (is_public, parts)): (&String, &(bool, ModulePath))| {
            format!("{name}={}:{is_public}", parts.join("::"))
        };
        let imported: Vec<String> = names.imported.iter().map(shown).collect();
        assert_eq!(imported, ["C=a::b::C:true", "E=a::b::D:true", "a=a:true", "f=a::f:true"]);
        assert_eq!(names.children, ["g"]);
        assert_eq!(names.item.as_deref(), Some("fn h"));
        assert!(names.paths.contains(&vec!["g".to_owned(), "i".to_owned()]));
    }
}
