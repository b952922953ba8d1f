//! Runs the command as a user does and reads what it says.
#![allow(clippy::unwrap_used, reason = "a helper that fails is a failed test")]

pub(crate) mod app;

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::Command;
use tempfile::TempDir;

/// What the command said.
pub(crate) struct Said {
    pub(crate) status: i32,
    pub(crate) out: String,
    pub(crate) err: String,
}

impl Said {
    /// Standard output as one JSON object.
    pub(crate) fn json(&self) -> Value {
        serde_json::from_str(&self.out)
            .unwrap_or_else(|e| panic!("{e}: {:?}\n{}", self.out, self.err))
    }

    /// Asserts status 0 and returns the JSON.
    pub(crate) fn answered(&self) -> Value {
        assert_eq!(self.status, 0, "{}", self.err);
        self.json()
    }
}

/// Runs `rough-contact` in `folder` with the words of `line`.
pub(crate) fn rough_contact(folder: &Path, line: &str) -> Said {
    let output = Command::new(env!("CARGO_BIN_EXE_rough-contact"))
        .current_dir(folder)
        .args(line.split_whitespace())
        .output()
        .unwrap();
    Said {
        status: output.status.code().unwrap(),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    }
}

/// An empty folder that is removed at the end of the test.
pub(crate) fn folder() -> TempDir {
    tempfile::tempdir().unwrap()
}

/// Writes `text` to `name` in `folder`.
pub(crate) fn file(folder: &Path, name: &str, text: &str) -> PathBuf {
    let path = folder.join(name);
    std::fs::write(&path, text).unwrap();
    path
}

/// A matrix text file of heights in micrometres, without header.
pub(crate) fn matrix(
    folder: &Path,
    name: &str,
    ny: usize,
    nx: usize,
    height: impl Fn(usize, usize) -> f64,
) {
    let row = |iy| (0..nx).map(|ix| format!("{}", height(iy, ix))).collect::<Vec<_>>().join(" ");
    let text: Vec<String> = (0..ny).map(row).collect();
    file(folder, name, &(text.join("\n") + "\n"));
}

/// Runs `line` with and without --json and asserts that it is refused both times with `status`,
/// that nothing but the error object is on standard output, and that the one message says
/// `parts`.
pub(crate) fn refused(folder: &Path, line: &str, status: i32, parts: &[&str]) {
    let plain = rough_contact(folder, line);
    assert_eq!(plain.status, status, "{line}: {}{}", plain.out, plain.err);
    assert!(plain.out.is_empty(), "{line}: {}", plain.out);

    let json = rough_contact(folder, &format!("{line} --json"));
    assert_eq!(json.status, status, "{line}: {}", json.err);
    let object = json.json();
    let message = object["error"]["message"].as_str().unwrap_or_default();
    assert!(!object["error"]["kind"].as_str().unwrap_or_default().is_empty(), "{object}");
    for part in parts {
        assert!(plain.err.contains(part), "{line}: {part:?} is not in {:?}", plain.err);
        assert!(message.contains(part), "{line}: {part:?} is not in {message:?}");
    }
}

/// The number at `key`.
pub(crate) fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is not a number"))
}
