//! Files that a command makes and the repository keeps: write them, or check that they are
//! current. Numbers are compared to 1e-9, not by their digits, because sine and cosine differ
//! in the last place between platforms.

use crate::shell::{TaskResult, read, root};

/// Whether a file is checked, and the relative difference up to which two numbers in it count as the same; it is written
/// otherwise.
pub(crate) type Check = Option<f64>;

/// A check as strict as platforms allow.
pub(crate) const CHECK: Check = Some(1e-9);

/// `--check` among the arguments, and nothing that is not known.
pub(crate) fn check_flag(args: &[String]) -> Result<Check, String> {
    match args {
        [] => Ok(None),
        [flag] if flag == "--check" => Ok(CHECK),
        other => Err(format!("unknown arguments {other:?}; the only one is --check")),
    }
}

/// Writes `text` to `path` (below the repository root), or checks that it is there already.
pub(crate) fn keep(path: &str, text: &str, check: Check) -> TaskResult {
    let full = root().join(path);
    if let Some(tolerance) = check {
        return match first_difference(&read(&full)?, text, tolerance) {
            None => Ok(()),
            Some(what) => {
                Err(format!("{path} is not current ({what}); run the task without --check"))
            }
        };
    }
    if let Some(folder) = full.parent() {
        std::fs::create_dir_all(folder)
            .map_err(|e| format!("cannot make {}: {e}", folder.display()))?;
    }
    std::fs::write(&full, text).map_err(|e| format!("cannot write {path}: {e}"))?;
    println!("wrote {path}");
    Ok(())
}

/// Replaces what stands between `<!-- begin NAME -->` and `<!-- end NAME -->` in the page.
pub(crate) fn keep_section(path: &str, name: &str, text: &str, check: Check) -> TaskResult {
    let full = root().join(path);
    let page = read(&full)?;
    let (begin, end) = (format!("<!-- begin {name} -->"), format!("<!-- end {name} -->"));
    let start = page.find(&begin).ok_or_else(|| format!("{path} has no '{begin}'"))? + begin.len();
    let stop = page.find(&end).ok_or_else(|| format!("{path} has no '{end}'"))?;
    let stop = page[..stop].rfind('\n').map_or(stop, |newline| newline + 1); // with what stands before the mark
    let replaced = format!("{}\n{}\n{}", &page[..start], text.trim_end(), &page[stop..]);
    keep(path, &replaced, check)
}

/// Where two texts differ, numbers compared by value; `None` if nowhere.
fn first_difference(committed: &str, fresh: &str, tolerance: f64) -> Option<String> {
    let mut fresh_tokens = tokens(fresh);
    for old in tokens(committed) {
        let Some(new) = fresh_tokens.next() else { return Some(format!("'{old}' is gone")) };
        if !same(old, new, tolerance) {
            return Some(format!("'{old}' is now '{new}'"));
        }
    }
    fresh_tokens.next().map(|new| format!("'{new}' is new"))
}

fn same(old: &str, new: &str, tolerance: f64) -> bool {
    if old == new {
        return true;
    }
    let (Ok(a), Ok(b)) = (old.parse::<f64>(), new.parse::<f64>()) else { return false };
    (a - b).abs() <= tolerance * a.abs().max(b.abs())
}

/// Splits at white space and around numbers: `M1.5,2` is `M`, `1.5`, `,`, `2`.
fn tokens(text: &str) -> impl Iterator<Item = &str> {
    let numeric = |c: char| c.is_ascii_digit() || c == '.';
    text.split_whitespace().flat_map(move |word| {
        let mut rest = word;
        std::iter::from_fn(move || {
            let first = rest.chars().next()?;
            let is_number = numeric(first);
            let end = rest.find(|c| numeric(c) != is_number).unwrap_or(rest.len());
            let (token, tail) = rest.split_at(end);
            rest = tail;
            Some(token)
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_compared_by_value_and_words_by_letter() {
        let difference = |old, new| first_difference(old, new, 1e-9);
        assert_eq!(difference("<path d=\"M1.5,2\"/>", "<path d=\"M1.50,2.0\"/>"), None);
        assert_eq!(difference("x 0.123456789012", "x 0.123456789013"), None);
        assert!(difference("x 0.1234", "x 0.1235").is_some());
        assert!(difference("steel", "brass").is_some());
        assert!(difference("a b", "a").is_some());
        assert!(difference("a", "a b").is_some());
        assert_eq!(first_difference("3.2 maps", "3.3 maps", 0.05), None);
        assert!(first_difference("3.2 maps", "3.4 maps", 0.05).is_some());
    }
}
