//! Starting other programs from the repository root.

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// What a task returns; an error is one sentence for a person.
pub(crate) type TaskResult = Result<(), String>;

pub(crate) fn root() -> PathBuf {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    here.parent().expect("xtask lies inside the repository").to_path_buf()
}

/// The cargo that started this task.
pub(crate) fn cargo() -> Command {
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.current_dir(root());
    cargo
}

/// `rough-contact`: built in release with `all` its options, or in the profile `first` with what the tasks of this
/// repository need; its arguments are to follow. Relative paths are the caller's: the command runs where the task was
/// started.
pub(crate) fn rough_contact(all: bool) -> Command {
    let first = ["--profile", "first", "--no-default-features", "--features", "command,parallel"];
    let how = if all { &RELEASE[..] } else { &first };
    released("rough-contact", how, ["--bin", "rough-contact"])
}

/// The example `name` of a crate, built in release; its arguments are to follow. It runs in the
/// repository root.
pub(crate) fn example(package: &str, name: &str) -> Command {
    let mut command = released(package, &RELEASE, ["--example", name]);
    command.current_dir(root());
    command
}

/// Set by `ci` for its checks, which time nothing: the programs that `cargo test --workspace` has
/// built, beside this task, are run as they are.
pub(crate) const BUILT: &str = "XTASK_BUILT";

/// How programs are built whose time counts.
pub(crate) const RELEASE: [&str; 1] = ["--release"];

/// A program of a crate, built in this way unless [`BUILT`] is set, and run where the task was
/// started; its arguments are to follow.
pub(crate) fn released(package: &str, how: &[&str], program: [&str; 2]) -> Command {
    if std::env::var_os(BUILT).is_some() {
        return Command::new(built(program));
    }
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.args(["run", "--locked", "--manifest-path"]);
    cargo.arg(root().join("crates").join(package).join("Cargo.toml"));
    cargo.args(how).args(program).arg("--");
    cargo
}

/// Where the tests have put a program: `--bin` beside this task, `--example` one folder below.
fn built([kind, name]: [&str; 2]) -> PathBuf {
    let here = std::env::current_exe().unwrap_or_default();
    let folder = here.parent().unwrap_or(Path::new("."));
    let folder = if kind == "--example" { folder.join("examples") } else { folder.to_path_buf() };
    folder.join(format!("{name}{}", std::env::consts::EXE_SUFFIX))
}

/// Runs to the end, with our own standard streams.
pub(crate) fn run(command: &mut Command) -> TaskResult {
    let status = command.status().map_err(|e| format!("cannot start {}: {e}", shown(command)))?;
    if status.success() { Ok(()) } else { Err(format!("{} ended with {status}", shown(command))) }
}

/// Runs to the end and returns standard output; standard error goes to ours.
pub(crate) fn output(command: &mut Command) -> Result<String, String> {
    let output = command
        .stderr(Stdio::inherit())
        .output()
        .map_err(|e| format!("cannot start {}: {e}", shown(command)))?;
    if !output.status.success() {
        return Err(format!("{} ended with {}", shown(command), output.status));
    }
    String::from_utf8(output.stdout).map_err(|_| format!("{} did not write UTF-8", shown(command)))
}

/// What `cargo metadata ARGS` says of packages: those of this workspace with `--no-deps`.
pub(crate) fn packages(args: &[&str]) -> Result<Vec<Value>, String> {
    let mut metadata = cargo();
    let text = output(metadata.args(["metadata", "--locked", "--format-version", "1"]).args(args))?;
    let mut found: Value =
        serde_json::from_str(&text).map_err(|e| format!("cargo metadata is not JSON: {e}"))?;
    match found["packages"].take() {
        Value::Array(packages) => Ok(packages),
        _ => Err("cargo metadata names no packages".to_owned()),
    }
}

/// The command as a person would type it.
pub(crate) fn shown(command: &Command) -> String {
    let program = Path::new(command.get_program());
    let mut line = program.file_name().unwrap_or_default().to_string_lossy().into_owned();
    for arg in command.get_args() {
        line.push(' ');
        line.push_str(&arg.to_string_lossy());
    }
    line
}

pub(crate) fn read(path: &Path) -> Result<String, String> {
    std::fs::read_to_string(path).map_err(|e| format!("cannot read {}: {e}", path.display()))
}

/// Every file below `folder` whose name ends with `.extension`, sorted.
pub(crate) fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let Ok(entries) = std::fs::read_dir(folder) else { return found };
    for entry in entries.flatten() {
        let path = entry.path();
        if path.is_dir() {
            found.extend(files(&path, extension));
        } else if path.extension().is_some_and(|e| e == extension) {
            found.push(path);
        }
    }
    found.sort();
    found
}
