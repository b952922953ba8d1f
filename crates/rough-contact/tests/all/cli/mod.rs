//! Runs the command as a user does and reads what it says.

pub(crate) mod app;

use serde_json::Value;
use std::f64::consts::TAU;
use std::path::{Path, PathBuf};
use std::process::Command;
use tempfile::TempDir;

/// Where and in what unit the heights of [`TestFolder::matrix`] are.
pub(crate) const UNITS: &str = "--pixel 1um --height-unit um";

/// What the command said.
pub(crate) struct RunOutput {
    pub(crate) status: i32,
    pub(crate) out: String,
    pub(crate) err: String,
}

impl RunOutput {
    /// Standard output as one JSON object.
    pub(crate) fn json(&self) -> Value {
        serde_json::from_str(&self.out)
            .unwrap_or_else(|e| panic!("{e}: {:?}\n{}", self.out, self.err))
    }
}

/// An empty folder in which the command runs, removed at the end of the test.
pub(crate) struct TestFolder(TempDir);

pub(crate) fn folder() -> TestFolder {
    TestFolder(tempfile::tempdir().unwrap())
}

/// Waves of several lengths, one cell of 32 x 32; `mirrored` as seen after a turn about the y axis.
pub(crate) fn bumpy(seed: f64, sign: f64, mirrored: bool) -> impl Fn(usize, usize) -> f64 {
    move |iy, ix| {
        let ix = if mirrored { 31 - ix } else { ix };
        let wave = |a: f64, ky: f64, kx: f64| {
            a * (TAU * (ky * iy as f64 + kx * ix as f64) / 32.0 + seed * (ky + 2.0 * kx)).cos()
        };
        // Rounded, so that text keeps every bit and sums of two are exact.
        let height = wave(0.1, 1.0, 2.0) + wave(0.06, 3.0, -1.0) + wave(0.04, 2.0, 4.0);
        sign * (height * 1024.0).round() / 1024.0
    }
}

/// A folder with `a.x3p`, points 1 µm apart with an rms gradient of 0.1.
#[track_caller]
pub(crate) fn surface(recipe: &str) -> TestFolder {
    let at = folder();
    at.synth("a.x3p", &format!("{recipe} --rms-gradient 0.1 --seed 4"));
    at
}

/// The usual recipe of [`surface`].
pub(crate) const ROUGH: &str = "--shape 64,64 --rolloff 32um --cutoff 8um";

impl TestFolder {
    pub(crate) fn path(&self) -> &Path {
        self.0.path()
    }

    pub(crate) fn join(&self, name: &str) -> PathBuf {
        self.path().join(name)
    }

    /// Runs `rough-contact` with the words of `line`.
    pub(crate) fn run(&self, line: &str) -> RunOutput {
        run(self.path(), &line.split_whitespace().collect::<Vec<_>>())
    }

    /// The same; asserts status 0.
    #[track_caller]
    pub(crate) fn done(&self, line: &str) -> RunOutput {
        let output = self.run(line);
        assert_eq!(output.status, 0, "{line}: {}{}", output.out, output.err);
        output
    }

    /// What `line` prints with `--json`; asserts status 0.
    #[track_caller]
    pub(crate) fn answer(&self, line: &str) -> Value {
        self.done(&format!("{line} --json")).json()
    }

    /// A random surface of 1 µm points and Hurst exponent 0.8.
    #[track_caller]
    pub(crate) fn synth(&self, name: &str, recipe: &str) {
        self.done(&format!("synth --pixel 1um --hurst 0.8 {recipe} --out {name}"));
    }

    pub(crate) fn file(&self, name: &str, text: &str) {
        std::fs::write(self.join(name), text).unwrap();
    }

    /// A matrix text file of heights in micrometres, without header.
    pub(crate) fn matrix(
        &self,
        name: &str,
        ny: usize,
        nx: usize,
        height: impl Fn(usize, usize) -> f64,
    ) {
        let row = |iy| (0..nx).map(|ix| height(iy, ix).to_string()).collect::<Vec<_>>().join(" ");
        let text: Vec<String> = (0..ny).map(row).collect();
        self.file(name, &(text.join("\n") + "\n"));
    }

    #[track_caller]
    pub(crate) fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
    }

    /// The numbers of a CSV file under the first heading that begins so.
    #[track_caller]
    pub(crate) fn column(&self, name: &str, heading: &str) -> Vec<f64> {
        let text = self.read(name);
        let mut rows = text.lines().map(|line| line.split(','));
        let place = rows.next().unwrap().position(|head| head.starts_with(heading));
        let place = place.unwrap_or_else(|| panic!("{name}: no {heading}"));
        rows.map(|mut row| row.nth(place).unwrap().parse().unwrap()).collect()
    }

    /// Header and numbers of a little-endian f64 NPY file of version 1, as `numpy.save` writes it.
    #[track_caller]
    pub(crate) fn npy(&self, name: &str) -> (String, Vec<f64>) {
        let bytes = std::fs::read(self.join(name)).unwrap();
        assert_eq!(&bytes[..8], b"\x93NUMPY\x01\x00");
        let length = usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
        let header = String::from_utf8(bytes[10..10 + length].to_vec()).unwrap();
        let values = bytes[10 + length..].chunks(8);
        (header, values.map(|b| f64::from_le_bytes(b.try_into().unwrap())).collect())
    }

    /// `results.json` of a study.
    #[track_caller]
    pub(crate) fn results(&self, study: &str) -> Value {
        serde_json::from_str(&self.read(&format!("{study}/results.json"))).unwrap()
    }

    /// Asserts that `line` is refused with status 2 and says `parts`.
    #[track_caller]
    pub(crate) fn refuses(&self, line: &str, parts: &[&str]) {
        self.refuses_with(2, line, parts);
    }

    /// Asserts that `line` is refused with each of these options, and that the message has these parts.
    #[track_caller]
    pub(crate) fn refuses_each(&self, line: &str, cases: &[(&str, &[&str])]) {
        for (options, parts) in cases {
            self.refuses(&format!("{line} {options}"), parts);
        }
    }

    /// Runs `line` with and without `--json` and asserts that it is refused both times with `status`, that nothing but
    /// the error object is on standard output, and that the one message says `parts`.
    #[track_caller]
    pub(crate) fn refuses_with(&self, status: i32, line: &str, parts: &[&str]) {
        let plain = self.run(line);
        assert_eq!(plain.status, status, "{line}: {}{}", plain.out, plain.err);
        assert!(plain.out.is_empty(), "{line}: {}", plain.out);

        let json = self.run(&format!("{line} --json"));
        assert_eq!(json.status, status, "{line}: {}", json.err);
        let object = json.json();
        let message = object["error"]["message"].as_str().unwrap_or_default();
        assert!(!object["error"]["kind"].as_str().unwrap_or_default().is_empty(), "{object}");
        for part in parts {
            assert!(plain.err.contains(part), "{line}: {part:?} is not in {:?}", plain.err);
            assert!(message.contains(part), "{line}: {part:?} is not in {message:?}");
        }
    }
}

/// Runs `rough-contact` in `folder` with these words.
pub(crate) fn run(folder: &Path, words: &[&str]) -> RunOutput {
    let output = Command::new(env!("CARGO_BIN_EXE_rough-contact"))
        .current_dir(folder)
        .args(words)
        .output()
        .unwrap();
    RunOutput {
        status: output.status.code().unwrap(),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    }
}

/// Asserts that `text` has every part.
#[track_caller]
pub(crate) fn has(text: &str, parts: &[&str]) {
    for part in parts {
        assert!(text.contains(part), "{part:?} is not in {text}");
    }
}

/// Asserts that two numbers agree to this relative error.
#[track_caller]
pub(crate) fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{found} instead of {expected}");
}

/// A number of JSON.
#[track_caller]
pub(crate) fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is not a number"))
}

/// The two numbers of an interval.
#[track_caller]
pub(crate) fn ends(interval: &Value) -> [f64; 2] {
    [0, 1].map(|i| number(&interval[i]))
}

/// The entries of a list.
#[track_caller]
pub(crate) fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap_or_else(|| panic!("{value} is not a list"))
}

/// A document of the book.
pub(crate) fn book(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/src").join(name);
    std::fs::read_to_string(path).unwrap()
}

/// An answer without times and these keys.
pub(crate) fn timeless(value: &Value, keys: &[&str]) -> Value {
    match value {
        Value::Object(map) => {
            let is_kept = |key: &&String| !key.contains("seconds") && !keys.contains(&key.as_str());
            let kept = map.iter().filter(|(key, _)| is_kept(key));
            kept.map(|(key, value)| (key.clone(), timeless(value, keys))).collect()
        }
        Value::Array(items) => items.iter().map(|item| timeless(item, keys)).collect(),
        other => other.clone(),
    }
}
