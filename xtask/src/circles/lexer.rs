//! Rust source as a row of names and signs, without comments, text and tests.

/// A piece of source.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Token {
    /// A name or keyword.
    Name(String),
    /// `::`.
    Path,
    /// Any other sign.
    Sign(char),
}

impl Token {
    /// The name, if it is one.
    pub(crate) fn name(&self) -> Option<&str> {
        if let Self::Name(name) = self { Some(name) } else { None }
    }

    /// Whether this is the name `name`.
    pub(crate) fn is(&self, name: &str) -> bool {
        self.name() == Some(name)
    }
}

/// The names and signs of `source`; comments, strings, characters, lifetimes and everything under
/// `#[cfg(test)]` are gone.
pub(crate) fn tokens(source: &str) -> Vec<Token> {
    without_tests(&lex(source))
}

fn lex(source: &str) -> Vec<Token> {
    let text: Vec<char> = source.chars().collect();
    let at = |i: usize| text.get(i).copied().unwrap_or('\0');
    let mut found = Vec::new();
    let mut i = 0;
    while i < text.len() {
        let c = text[i];
        if c == '/' && at(i + 1) == '/' {
            while i < text.len() && text[i] != '\n' {
                i += 1;
            }
        } else if c == '/' && at(i + 1) == '*' {
            i = after_comment(&text, i);
        } else if c == '"' {
            i = after_string(&text, i);
        } else if c == '\'' {
            i = after_quote(&text, i);
        } else if is_word(c) {
            let start = i;
            while i < text.len() && is_word(text[i]) {
                i += 1;
            }
            let name: String = text[start..i].iter().collect();
            let is_raw = matches!(name.as_str(), "r" | "br" | "cr");
            if is_raw && let Some(end) = after_raw_string(&text, i) {
                i = end;
            } else if is_raw && at(i) == '#' {
                i += 1; // a raw name: r#type
            } else if !(matches!(name.as_str(), "b" | "c") && matches!(at(i), '"' | '\'')) {
                found.push(Token::Name(name));
            }
        } else if c == ':' && at(i + 1) == ':' {
            found.push(Token::Path);
            i += 2;
        } else {
            if !c.is_whitespace() {
                found.push(Token::Sign(c));
            }
            i += 1;
        }
    }
    found
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

fn after_comment(text: &[char], start: usize) -> usize {
    let (mut depth, mut i) = (0, start);
    while i + 1 < text.len() {
        match (text[i], text[i + 1]) {
            ('/', '*') => (depth, i) = (depth + 1, i + 2),
            ('*', '/') => (depth, i) = (depth - 1, i + 2),
            _ => i += 1,
        }
        if depth == 0 {
            return i;
        }
    }
    text.len()
}

fn after_string(text: &[char], start: usize) -> usize {
    let mut i = start + 1;
    while i < text.len() && text[i] != '"' {
        i += if text[i] == '\\' { 2 } else { 1 };
    }
    i + 1
}

/// After the raw string whose `r` ends at `start`; `None` if there is none.
fn after_raw_string(text: &[char], start: usize) -> Option<usize> {
    let marks = text[start..].iter().take_while(|c| **c == '#').count();
    if text.get(start + marks) != Some(&'"') {
        return None;
    }
    let closes = |i: usize| {
        text[i] == '"' && text[i + 1..].iter().take(marks).filter(|c| **c == '#').count() == marks
    };
    let end = (start + marks + 1..text.len()).find(|i| closes(*i))?;
    Some(end + 1 + marks)
}

/// After a character, or after the quote of a lifetime.
fn after_quote(text: &[char], start: usize) -> usize {
    if text.get(start + 1) == Some(&'\\') {
        let end = (start + 3..text.len()).find(|i| text[*i] == '\'');
        return end.unwrap_or(text.len()) + 1;
    }
    if text.get(start + 2) == Some(&'\'') {
        return start + 3;
    }
    let name = text[start + 1..].iter().take_while(|c| is_word(**c)).count();
    start + 1 + name
}

fn without_tests(all: &[Token]) -> Vec<Token> {
    let mut kept = Vec::new();
    let mut i = 0;
    while i < all.len() {
        if is_test_attribute(&all[i..]) {
            i = after_item(all, i);
        } else {
            kept.push(all[i].clone());
            i += 1;
        }
    }
    kept
}

/// `#[cfg(test)]`, or `#[cfg(all(test, ..))]`.
fn is_test_attribute(here: &[Token]) -> bool {
    let head = [Token::Sign('#'), Token::Sign('['), Token::Name("cfg".into()), Token::Sign('(')];
    here.starts_with(&head)
        && (here.get(4).is_some_and(|t| t.is("test"))
            || here.get(4).is_some_and(|t| t.is("all"))
                && here.get(6).is_some_and(|t| t.is("test")))
}

/// After the item whose first attribute is at `start`: after its closing brace, or its `;`.
fn after_item(all: &[Token], start: usize) -> usize {
    let mut depth = 0_i32;
    for (i, token) in all.iter().enumerate().skip(start) {
        match token {
            Token::Sign('(' | '[' | '{') => depth += 1,
            Token::Sign(')' | ']') => depth -= 1,
            Token::Sign('}') => {
                depth -= 1;
                if depth == 0 {
                    return i + 1;
                }
            }
            Token::Sign(';') if depth == 0 => return i + 1,
            _ => {}
        }
    }
    all.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(source: &str) -> Vec<String> {
        tokens(source).iter().filter_map(|t| t.name().map(str::to_owned)).collect()
    }

    #[test]
    fn text_comments_and_tests_are_no_names() {
        let source = r##"
            use a::b; // use c::d
            /* e /* f */ g */ const X: &str = "https://h \" i"; let r = r#"j " k"#;
            fn l<'m>(n: &'m u8) -> char { b'o'; '\''; 'p' }
            #[cfg(test)] mod tests { use super::q; fn s() { {} } }
            #[cfg(test)] use t::u;
            fn after() {}
        "##;
        let expected = "use a b const X str let r fn l n u8 char fn after";
        assert_eq!(names(source).join(" "), expected);
    }
}
