//! What one file defines, imports and names.

use super::lexer::{Token, tokens};
use std::collections::{BTreeMap, BTreeSet};

/// A path as written: `crate::a::B` has three parts.
pub(crate) type Parts = Vec<String>;

/// One source file as the circle finder sees it.
#[derive(Debug, Default)]
pub(crate) struct Source {
    /// Child modules that are files of their own.
    pub(crate) children: Vec<String>,
    /// Names defined here.
    pub(crate) defined: BTreeSet<String>,
    /// Imported names: the path of each, and whether it is `pub`.
    pub(crate) imported: BTreeMap<String, (bool, Parts)>,
    /// Names that the code itself uses, outside `use`.
    pub(crate) used: BTreeSet<String>,
    /// Paths in the code itself, of two parts and more.
    pub(crate) paths: BTreeSet<Parts>,
    /// Items that a face must not have.
    pub(crate) items: Vec<String>,
}

const DEFINES: [&str; 8] = ["fn", "struct", "enum", "trait", "type", "const", "static", "union"];

impl Source {
    pub(crate) fn of(text: &str) -> Self {
        let all = tokens(text);
        let mut found = Self::default();
        let (mut i, mut depth) = (0, 0_i32);
        while i < all.len() {
            match &all[i] {
                Token::Sign('{') => depth += 1,
                Token::Sign('}') => depth -= 1,
                Token::Name(word) if word == "use" => {
                    i = found.import(&all, i);
                    continue;
                }
                Token::Name(word) if word == "mod" => {
                    if let (Some(Token::Name(name)), Some(Token::Sign(';'))) =
                        (all.get(i + 1), all.get(i + 2))
                    {
                        found.children.push(name.clone());
                        i += 3;
                        continue;
                    }
                }
                Token::Name(word) if word == "macro_rules" => {
                    if let Some(name) = all.get(i + 2).and_then(Token::name) {
                        found.defined.insert(name.to_owned());
                    }
                }
                Token::Name(word) => {
                    let next = all.get(i + 1).and_then(Token::name);
                    if let Some(name) = next
                        && DEFINES.contains(&word.as_str())
                    {
                        found.defined.insert(name.to_owned());
                        if depth == 0 && name != "fn" {
                            found.items.push(format!("{word} {name}"));
                        }
                    } else if depth == 0 && word == "impl" {
                        found.items.push("impl".to_owned());
                    }
                    i = found.path(&all, i);
                    continue;
                }
                _ => {}
            }
            i += 1;
        }
        found
    }

    /// The path that begins at `start`; returns what follows it.
    fn path(&mut self, all: &[Token], start: usize) -> usize {
        let mut parts = vec![all[start].name().unwrap_or_default().to_owned()];
        let mut i = start + 1;
        while let (Some(Token::Path), Some(Token::Name(name))) = (all.get(i), all.get(i + 1)) {
            parts.push(name.clone());
            i += 2;
        }
        self.used.insert(parts[0].clone());
        if parts.len() > 1 {
            self.paths.insert(parts);
        }
        i
    }

    /// The `use` at `start`; returns what follows its `;`.
    fn import(&mut self, all: &[Token], start: usize) -> usize {
        let before = all[..start].iter().rev();
        let is_public = match before.clone().next() {
            Some(token) if token.is("pub") => true,
            Some(Token::Sign(')')) => {
                before.skip_while(|t| **t != Token::Sign('(')).nth(1).is_some_and(|t| t.is("pub"))
            }
            _ => false,
        };
        let length = all[start..].iter().take_while(|t| **t != Token::Sign(';')).count();
        let mut tree = &all[start + 1..start + length];
        self.tree(&mut tree, &Vec::new(), is_public);
        start + length + 1
    }

    /// One branch of a `use` tree, up to its comma or closing brace.
    fn tree(&mut self, rest: &mut &[Token], stem: &Parts, is_public: bool) {
        let mut parts = stem.clone();
        loop {
            match rest.first() {
                Some(Token::Name(word)) if word == "as" => {
                    if let Some(name) = rest.get(1).and_then(Token::name) {
                        self.imported.insert(name.to_owned(), (is_public, whole(&parts)));
                    }
                    *rest = &rest[2.min(rest.len())..];
                    return;
                }
                Some(Token::Name(word)) => parts.push(word.clone()),
                Some(Token::Sign('{')) => {
                    *rest = &rest[1..];
                    while !matches!(rest.first(), None | Some(Token::Sign('}'))) {
                        self.tree(rest, &parts, is_public);
                        if rest.first() == Some(&Token::Sign(',')) {
                            *rest = &rest[1..];
                        }
                    }
                    *rest = rest.get(1..).unwrap_or_default();
                    return;
                }
                Some(Token::Path) => {}
                Some(Token::Sign('*')) => parts.push("*".to_owned()),
                _ => break, // a comma, the closing brace, or the end
            }
            *rest = &rest[1..];
        }
        let parts = whole(&parts);
        if let Some(name) = parts.last() {
            self.imported.insert(name.clone(), (is_public, parts.clone()));
        }
    }
}

/// `a::b::self` is `a::b`.
fn whole(parts: &Parts) -> Parts {
    match parts.split_last() {
        Some((last, stem)) if last == "self" && !stem.is_empty() => stem.to_vec(),
        _ => parts.clone(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_use_tree_is_taken_apart() {
        let source = Source::of(
            "pub(crate) use a::{self, b::{C, D as E}, f};\nmod g;\nfn h() { g::i::<u8>(); }",
        );
        let imported: Vec<String> = source
            .imported
            .iter()
            .map(|(name, (is_public, parts))| format!("{name}={}:{is_public}", parts.join("::")))
            .collect();
        assert_eq!(imported, ["C=a::b::C:true", "E=a::b::D:true", "a=a:true", "f=a::f:true"]);
        assert_eq!(source.children, ["g"]);
        assert!(source.defined.contains("h"));
        assert!(source.paths.contains(&vec!["g".to_owned(), "i".to_owned()]));
        assert_eq!(source.items, ["fn h"]);
    }
}
